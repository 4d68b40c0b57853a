// SPDX-License-Identifier: GPL-3.0-or-later
#include "predictor_tracer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace truelux::bench {
namespace {

constexpr int kCorrections = 6;
constexpr double kFarthest = 2;  ///< that a corrector may go, in steps

/// A point of the contour.
struct Station {
  PlanPoint at;
  PlanPoint tangent;  ///< of length 1, along the trace
};

class Tracer {
 public:
  Tracer(const LightProbe& probe, bool is_backward, const TraceOptions& options)
      : probe_(probe),
        options_(options),
        h_(options.step),
        sign_(is_backward ? -1 : 1) {}

  Trace Follow(const PlanPoint& start) {
    Trace trace;
    if (Correct(start)) {
      trace.points.push_back({stations_.front().at, {}});
      while (Advance(trace)) {
      }
    }
    trace.end = end_;
    return trace;
  }

 private:
  /// One point more; false at the end.
  bool Advance(Trace& trace) {
    if (trace.points.size() >= options_.most_points)
      return End(TraceEnd::kTooLong);
    const bool is_guess = history_ >= HistoryOf(options_.predictor);
    const std::optional<PlanPoint> next = is_guess ? Guess() : RungeKutta();
    if (!next) return End(TraceEnd::kNoGradient);
    const PlanPoint last = stations_.back().at;
    if (IsOutlineBetween(last, *next)) return End(TraceEnd::kOutline);
    if (!Correct(*next)) return false;
    const PlanPoint found = stations_.back().at;
    if (IsOutlineBetween(last, found)) return End(TraceEnd::kOutline);
    if (IsStartBetween(last, found)) return End(TraceEnd::kClosed);
    trace.points.push_back({found, {}});
    if (is_guess) trace.points.back().miss = miss_;
    const bool is_lost =
        options_.is_restarting && is_guess && miss_ > kLargeMiss * h_;
    history_ = is_lost ? 1 : history_ + 1;
    return true;
  }

  bool End(TraceEnd reason) {
    end_ = reason;
    return false;
  }

  /// The unit tangent where a gradient is known.
  [[nodiscard]] std::optional<PlanPoint> TangentOf(
      const LightSample& sample) const {
    const double length = LengthOf(sample.gradient);
    if (!sample.is_defined || !(length > 0)) return {};
    return sign_ / length * PlanPoint{sample.gradient.t, -sample.gradient.s};
  }

  /// Newton's method along the gradient, to the next station.
  bool Correct(const PlanPoint& guess) {
    PlanPoint p = guess;
    for (int i = 0;; ++i) {
      const LightSample sample = probe_.SampleAt(p);
      const std::optional<PlanPoint> tangent = TangentOf(sample);
      if (!tangent) return End(TraceEnd::kNoGradient);
      const double lack = options_.level - sample.light.value;
      if (std::fabs(lack) <= options_.tolerance) {
        // A guess that is good enough stays, and misses all the same.
        miss_ = i == 0 ? std::fabs(lack) / LengthOf(sample.gradient)
                       : LengthOf(p - guess);
        stations_.push_back({p, *tangent});
        return true;
      }
      const PlanPoint& g = sample.gradient;
      p = p + lack / Dot(g, g) * g;
      if (i == kCorrections || !(LengthOf(p - guess) <= kFarthest * h_))
        return End(TraceEnd::kCorrector);
    }
  }

  /// k stations back.
  [[nodiscard]] const Station& Back(std::size_t k) const {
    return stations_[stations_.size() - 1 - k];
  }

  [[nodiscard]] PlanPoint Guess() const {
    if (options_.predictor == Predictor::kTwoStep) {
      return Back(0).at + h_ / 2 * (3 * Back(0).tangent - Back(1).tangent);
    }
    return Back(3).at +
           4 * h_ / 3 *
               (2 * Back(0).tangent - Back(1).tangent + 2 * Back(2).tangent);
  }

  [[nodiscard]] std::optional<PlanPoint> RungeKutta() const {
    const Station& from = stations_.back();
    const auto tangent_at = [&](double share, const PlanPoint& along) {
      return TangentOf(probe_.SampleAt(from.at + share * h_ * along));
    };
    const PlanPoint& first = from.tangent;
    const std::optional<PlanPoint> second = tangent_at(0.5, first);
    if (!second) return {};
    const std::optional<PlanPoint> third = tangent_at(0.5, *second);
    if (!third) return {};
    const std::optional<PlanPoint> fourth = tangent_at(1, *third);
    if (!fourth) return {};
    return from.at + h_ / 6 * (first + 2 * *second + 2 * *third + *fourth);
  }

  [[nodiscard]] bool IsOutlineBetween(const PlanPoint& a,
                                      const PlanPoint& b) const {
    return std::ranges::any_of(options_.outline, [&](const PlanSegment& side) {
      return DoSegmentsCross(side, {a, b});
    });
  }

  /// Whether the last step went past the start, in the direction in which the
  /// trace left it.
  [[nodiscard]] bool IsStartBetween(const PlanPoint& a,
                                    const PlanPoint& b) const {
    if (stations_.size() < 4) return false;  // The step is from near the start.
    const PlanPoint way = b - a;
    const PlanPoint to_start = stations_.front().at - a;
    const double length = LengthOf(way);
    const double along = Dot(to_start, way) / length;
    return along >= 0 && along < length &&
           std::fabs(Cross(way, to_start)) < h_ / 2 * length &&
           Dot(way, stations_.front().tangent) > 0;
  }

  const LightProbe& probe_;
  const TraceOptions& options_;
  double h_;
  double sign_;
  std::vector<Station> stations_;
  int history_ = 1;  ///< stations, the last one included, that a guess may use
  double miss_ = 0;  ///< how far the last guess was from its station [length]
  TraceEnd end_ = TraceEnd::kTooLong;
};

}  // namespace

std::string_view Name(Predictor predictor) {
  return predictor == Predictor::kMilne ? "Milne" : "two-step";
}

int HistoryOf(Predictor predictor) {
  return predictor == Predictor::kMilne ? 4 : 2;
}

std::string_view Name(TraceEnd end) {
  switch (end) {
    case TraceEnd::kClosed:
      break;
    case TraceEnd::kOutline:
      return "outline";
    case TraceEnd::kNoGradient:
      return "no gradient";
    case TraceEnd::kCorrector:
      return "corrector";
    case TraceEnd::kTooLong:
      return "too long";
  }
  return "closed";
}

bool DoSegmentsCross(const PlanSegment& a, const PlanSegment& b) {
  const PlanPoint u = a[1] - a[0];
  const PlanPoint v = b[1] - b[0];
  const double of_b = Cross(u, b[0] - a[0]) * Cross(u, b[1] - a[0]);
  const double of_a = Cross(v, a[0] - b[0]) * Cross(v, a[1] - b[0]);
  return of_a <= 0 && of_b <= 0 && Cross(u, v) != 0;
}

Trace TraceContour(const LightProbe& probe, const PlanPoint& start,
                   bool is_backward, const TraceOptions& options) {
  return Tracer(probe, is_backward, options).Follow(start);
}

}  // namespace truelux::bench
