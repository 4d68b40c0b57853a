// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/kink_crossing.h"

#include <algorithm>
#include <cmath>

#include "base/vector_math.h"

namespace truelux {
namespace {

Receiver Middle(const Way& way) {
  Receiver middle = way.from;
  middle.position = {(way.from.position.x + way.to.position.x) / 2,
                     (way.from.position.y + way.to.position.y) / 2,
                     (way.from.position.z + way.to.position.z) / 2};
  return middle;
}

/// The compared channels at one place.
struct Place {
  Rgb irradiance{};
  GradientRow gradient{};
};

class Halving {
 public:
  Halving(const GradientTrial& trial, std::span<const Way> ways)
      : trial_(trial), ways_(ways.begin(), ways.end()) {
    std::vector<Receiver> ends;
    for (const Way& way : ways_) {
      ends.push_back(way.from);
      ends.push_back(way.to);
    }
    const std::vector<Place> places = PlacesAt(ends);
    for (std::size_t w = 0; w < ways_.size(); ++w) {
      from_.push_back(places[2 * w]);
      to_.push_back(places[2 * w + 1]);
    }
  }

  void Step() {
    std::vector<Receiver> middles;
    for (const Way& way : ways_)
      middles.push_back(Middle(way));
    const std::vector<Place> places = PlacesAt(middles);
    for (std::size_t w = 0; w < ways_.size(); ++w) {
      if (Change(from_[w], places[w]) >= Change(places[w], to_[w])) {
        ways_[w].to = middles[w];
        to_[w] = places[w];
      } else {
        ways_[w].from = middles[w];
        from_[w] = places[w];
      }
    }
  }

  [[nodiscard]] WayCrossing At(std::size_t w) const {
    constexpr double kJump = 1e-3;
    WayCrossing crossing = WayCrossing::kNothing;
    for (std::size_t c = 0; c < trial_.data().channels.size(); ++c) {
      const double e = std::abs(from_[w].irradiance[c] - to_[w].irradiance[c]);
      if (e > kJump * std::max(from_[w].irradiance[c], to_[w].irradiance[c]))
        return WayCrossing::kFace;
      const Vector3& a = from_[w].gradient[c];
      const Vector3& b = to_[w].gradient[c];
      const double length = std::max(LengthOf(a), LengthOf(b));
      if (LengthOf(Difference(a, b)) > kJump * length)
        crossing = WayCrossing::kKink;
    }
    return crossing;
  }

 private:
  [[nodiscard]] std::vector<Place> PlacesAt(
      std::span<const Receiver> receivers) const {
    std::vector<Place> places;
    for (const Derivatives& d :
         trial_.evaluate().derivatives(trial_.scene(), receivers)) {
      Place place;
      place.gradient = trial_.GradientsOf(std::span(&d, 1)).front();
      for (std::size_t c = 0; c < trial_.data().channels.size(); ++c)
        place.irradiance[c] = d.irradiance.value[trial_.data().channels[c]];
      places.push_back(place);
    }
    return places;
  }

  /// Infinite where a gradient is missing: that is where a face is.
  [[nodiscard]] double Change(const Place& a, const Place& b) const {
    double change = 0;
    for (std::size_t c = 0; c < trial_.data().channels.size(); ++c) {
      const double length = LengthOf(Difference(a.gradient[c], b.gradient[c]));
      change = std::max(change, std::isnan(length) ? HUGE_VAL : length);
    }
    return change;
  }

  const GradientTrial& trial_;
  std::vector<Way> ways_;
  std::vector<Place> from_;
  std::vector<Place> to_;
};

}  // namespace

std::vector<WayCrossing> CrossingsOn(const GradientTrial& trial,
                                     std::span<const Way> ways) {
  constexpr int kRounds = 30;
  Halving halving(trial, ways);
  for (int round = 0; round < kRounds; ++round)
    halving.Step();
  std::vector<WayCrossing> crossings;
  for (std::size_t w = 0; w < ways.size(); ++w)
    crossings.push_back(halving.At(w));
  return crossings;
}

}  // namespace truelux
