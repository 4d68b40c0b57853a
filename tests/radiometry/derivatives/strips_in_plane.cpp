// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/strips_in_plane.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "support/real.h"

namespace truelux::testing {
namespace {

ShortReal RealOf(const mpq_class& q) {
  ShortReal x;
  mpfr_set_q(x.get(), q.get_mpq_t(), MPFR_RNDN);
  return x;
}

bool IsNothing(const RationalVector& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

/// A sheet that the plane P crosses, or that has an edge in P.
struct Trace {
  const Sheet* sheet = nullptr;
  int side = 0;  ///< where it lies beside P: 1 along m, -1, 0 on both sides
  RationalVector from;
  RationalVector to;  ///< directions in P, in the sense of m
};

/// A sheet as it is seen along some direction w in P.
struct Cover {
  const Sheet* sheet = nullptr;
  bool is_flat = false;    ///< lies in P
  int side = 0;            ///< as Trace::side
  RationalVector line;     ///< its 1/rho, of a flat one at the near edge
  RationalVector far;      ///< of a flat one: 1/rho at the far edge
  mpq_class near_inverse;  ///< line.w
  mpq_class far_inverse;   ///< far.w
  mpq_class tilt;          ///< line.m
};

/// A strip: z of the head of strips_twin.h, and the sense of the motion.
struct Strip {
  mpq_class z;
  int sense = 1;
};

class PlaneStrips {
 public:
  PlaneStrips(std::span<const Sheet> sheets, const RationalVector& m,
              const RationalVector& n)
      : m_(m), n_(n) {
    for (const Sheet& sheet : sheets) {
      if (sheet.height != 0) {
        AddTrace(sheet);
      } else if (IsNothing(Cross(sheet.normal, m))) {
        flats_.push_back(&sheet);
      }
    }
  }

  Rgb Find() {
    const RationalVector right = Cross(m_, n_);
    if (IsNothing(right)) return {};  // in the receiver plane n.w = 0
    std::vector<RationalVector> ends = {Cross(right, m_)};
    for (const Trace& trace : traces_) {
      ends.push_back(trace.from);
      ends.push_back(trace.to);
    }
    for (const Sheet* sheet : flats_) {
      for (const RationalVector& corner : sheet->corners)
        ends.push_back(corner);
    }
    std::erase_if(ends,
                  [this](const RationalVector& d) { return Dot(d, n_) <= 0; });
    Sort(ends);
    ends.insert(ends.begin(), -right);
    ends.push_back(right);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      AddPiece(ends[i], ends[i + 1]);
    return Total();
  }

 private:
  /// The sine of the angle from a to b, times something positive.
  [[nodiscard]] mpq_class Turn(const RationalVector& a,
                               const RationalVector& b) const {
    return Dot(m_, Cross(a, b));
  }

  /// Directions of less than half a turn by angle, each of them once.
  void Sort(std::vector<RationalVector>& directions) const {
    std::ranges::sort(directions,
                      [this](const RationalVector& a, const RationalVector& b) {
                        return Turn(a, b) > 0;
                      });
    const auto rest = std::ranges::unique(
        directions, [this](const RationalVector& a, const RationalVector& b) {
          return Turn(a, b) == 0;
        });
    directions.erase(rest.begin(), rest.end());
  }

  void AddTrace(const Sheet& sheet) {
    std::vector<RationalVector> points;
    bool is_above = false;
    bool is_below = false;
    const std::size_t count = sheet.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      const RationalVector& a = sheet.corners[i];
      const RationalVector& b = sheet.corners[(i + 1) % count];
      const mpq_class at_a = Dot(m_, a);
      const mpq_class at_b = Dot(m_, b);
      is_above = is_above || at_a > 0;
      is_below = is_below || at_a < 0;
      if (at_a == 0) points.push_back(a);
      if (sgn(at_a) * sgn(at_b) < 0) {
        const mpq_class share = at_a / (at_a - at_b);
        points.push_back(a + share * (b - a));
      }
    }
    // They are on one line, which does not go through r.
    Sort(points);
    if (points.size() < 2) return;
    const int side = is_above && is_below ? 0 : is_above ? 1 : -1;
    traces_.push_back({&sheet, side, points.front(), points.back()});
  }

  /// A sheet in P, if w meets its inside. No corner lies along w.
  [[nodiscard]] std::optional<Cover> FlatCover(const Sheet& sheet,
                                               const RationalVector& w) const {
    std::vector<std::pair<mpq_class, RationalVector>> hits;
    const std::size_t count = sheet.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      const RationalVector& a = sheet.corners[i];
      const RationalVector& b = sheet.corners[(i + 1) % count];
      if (sgn(Turn(a, w)) * sgn(Turn(w, b)) <= 0) continue;
      const RationalVector moment = Cross(a, b);
      const mpq_class scale = 1 / Dot(moment, moment);
      const RationalVector line = scale * Cross(b - a, moment);
      const mpq_class inverse = Dot(line, w);
      if (inverse > 0) hits.emplace_back(inverse, line);
    }
    if (hits.size() != 2) return std::nullopt;
    if (hits[0].first < hits[1].first) std::swap(hits[0], hits[1]);
    Cover cover;
    cover.sheet = &sheet;
    cover.is_flat = true;
    cover.line = hits[0].second;
    cover.far = hits[1].second;
    return cover;
  }

  /// What is seen along w, from r or from beside r.
  [[nodiscard]] std::vector<Cover> CoversAlong(const RationalVector& w) const {
    std::vector<Cover> covers;
    for (const Trace& trace : traces_) {
      if (Turn(trace.from, w) <= 0 || Turn(w, trace.to) <= 0) continue;
      Cover cover;
      cover.sheet = trace.sheet;
      cover.side = trace.side;
      cover.line = trace.sheet->InverseDistance();
      cover.tilt = Dot(cover.line, m_);
      covers.push_back(std::move(cover));
    }
    for (const Sheet* sheet : flats_) {
      if (std::optional<Cover> cover = FlatCover(*sheet, w))
        covers.push_back(*std::move(cover));
    }
    return covers;
  }

  /// A piece on which no cover begins or ends: cut where lines cross.
  void AddPiece(const RationalVector& from, const RationalVector& to) {
    std::vector<Cover> covers = CoversAlong(from + to);
    std::vector<RationalVector> lines;
    for (const Cover& cover : covers) {
      lines.push_back(cover.line);
      if (cover.is_flat) lines.push_back(cover.far);
    }
    std::vector<RationalVector> ends = {from, to};
    for (const RationalVector& a : lines) {
      // Both senses of each crossing, since each pair comes twice.
      for (const RationalVector& b : lines) {
        const RationalVector d = Cross(m_, a - b);
        if (Turn(from, d) > 0 && Turn(d, to) > 0) ends.push_back(d);
      }
    }
    Sort(ends);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const RationalVector w = ends[i] + ends[i + 1];
      for (Cover& cover : covers) {
        cover.near_inverse = Dot(cover.line, w);
        if (cover.is_flat) cover.far_inverse = Dot(cover.far, w);
      }
      std::array<RationalVector, 3> sums;
      AddSteps(covers, lines, w, 1, sums);
      AddSteps(covers, lines, w, -1, sums);
      for (std::size_t channel = 0; channel < 3; ++channel)
        Integrate(ends[i], ends[i + 1], sums[channel], channel);
    }
  }

  /// Adds the sum of -J g of one sense per channel.
  void AddSteps(std::span<const Cover> covers,
                std::span<const RationalVector> lines, const RationalVector& w,
                int sense, std::array<RationalVector, 3>& sums) const {
    std::vector<std::pair<mpq_class, const RationalVector*>> places;
    for (const RationalVector& line : lines)
      places.emplace_back(Dot(line, w), &line);
    std::ranges::sort(places, {}, [](const auto& p) { return p.first; });
    const auto rest =
        std::ranges::unique(places, {}, [](const auto& p) { return p.first; });
    places.erase(rest.begin(), rest.end());
    if (places.empty()) return;
    const std::array<mpq_class, 3> none;
    const auto seen = [&](const mpq_class& z) -> const auto& {
      const Cover* nearest = NearestIn(covers, {z, sense});
      return nearest != nullptr && ShowsFront(*nearest, sense)
                 ? nearest->sheet->emission
                 : none;
    };
    const auto* before = &seen(places.front().first - 1);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const mpq_class next =
          k + 1 < places.size()
              ? mpq_class((places[k].first + places[k + 1].first) / 2)
              : mpq_class(places[k].first + 1);
      const auto* after = &seen(next);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const mpq_class step = (*before)[channel] - (*after)[channel];
        sums[channel] = sums[channel] + step * *places[k].second;
      }
      before = after;
    }
  }

  [[nodiscard]] static bool Covers(const Cover& cover, const Strip& strip) {
    if (cover.is_flat)
      return cover.far_inverse < strip.z && strip.z < cover.near_inverse;
    return cover.side == 0 ||
           cover.side * strip.sense * sgn(cover.near_inverse - strip.z) > 0;
  }

  [[nodiscard]] bool ShowsFront(const Cover& cover, int sense) const {
    if (cover.is_flat) return sense * sgn(Dot(cover.sheet->normal, m_)) > 0;
    return cover.sheet->height < 0;
  }

  /// Which of two faces in one plane goes first: less is first.
  [[nodiscard]] std::pair<int, int> Rank(const Cover& cover, int sense) const {
    const int rank = !ShowsFront(cover, sense) ? 2
                     : cover.sheet->Emits()    ? 0
                                               : 1;
    return {rank, cover.sheet->number};
  }

  /// Whether a is seen before b in a strip that both cover.
  [[nodiscard]] bool IsNearer(const Cover& a, const Cover& b,
                              const Strip& strip) const {
    const auto inverse = [&strip](const Cover& c) -> const mpq_class& {
      return c.is_flat ? strip.z : c.near_inverse;
    };
    if (inverse(a) != inverse(b)) return inverse(a) > inverse(b);
    if (!a.is_flat && a.tilt != b.tilt) {
      return strip.sense * sgn(a.near_inverse - strip.z) *
                 sgn(a.tilt - b.tilt) >
             0;
    }
    return Rank(a, strip.sense) < Rank(b, strip.sense);
  }

  [[nodiscard]] const Cover* NearestIn(std::span<const Cover> covers,
                                       const Strip& strip) const {
    const Cover* nearest = nullptr;
    for (const Cover& cover : covers) {
      if (!Covers(cover, strip)) continue;
      if (nearest == nullptr || IsNearer(cover, *nearest, strip))
        nearest = &cover;
    }
    return nearest;
  }

  /// Adds the integral of (n.w)(g.w) from a to b, in closed form: a multiple of
  /// the angle, and the change of a rational number / |m|.
  void Integrate(const RationalVector& a, const RationalVector& b,
                 const RationalVector& g, std::size_t channel) {
    if (IsNothing(Cross(m_, g))) return;
    const mpq_class square = Dot(m_, m_);
    const mpq_class factor = (Dot(n_, g) - Dot(n_, m_) * Dot(g, m_) / square);
    const ShortReal angle =
        Atan2(RealOf(Turn(a, b)) / Sqrt(RealOf(square)), RealOf(Dot(a, b)));
    const auto at = [&](const RationalVector& d) {
      const RationalVector across = Cross(m_, d);
      return mpq_class(
          (Dot(n_, d) * Dot(across, g) + Dot(n_, across) * Dot(d, g)) /
          Dot(d, d));
    };
    const mpq_class change = at(a) - at(b);
    angles_[channel] = angles_[channel] + RealOf(factor) * angle;
    changes_[channel] += change;
    scale_ = scale_ + Abs(RealOf(factor) * angle) + Abs(RealOf(change));
  }

  /// b per channel; what 300 bits cannot tell from 0 is 0.
  [[nodiscard]] Rgb Total() const {
    Rgb size{};
    const ShortReal length = Sqrt(RealOf(Dot(m_, m_)));
    const ShortReal all = ShortReal::Pi() * Sqrt(RealOf(Dot(n_, n_)));
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const ShortReal sum = angles_[channel] * ShortReal(0.5) +
                            RealOf(changes_[channel]) / (length * ShortReal(4));
      if (Abs(sum) <= scale_ * ShortReal(0x1p-300)) continue;
      size[channel] = (sum / (all * ShortReal(2))).ToDouble();
    }
    return size;
  }

  RationalVector m_;
  RationalVector n_;
  std::vector<Trace> traces_;
  std::vector<const Sheet*> flats_;
  std::array<ShortReal, 3> angles_;   ///< twice the terms with angles
  std::array<mpq_class, 3> changes_;  ///< 4 |m| times the others
  ShortReal scale_;                   ///< a size to tell zeros by
};

}  // namespace

Rgb KinkSize(std::span<const Sheet> sheets, const RationalVector& m,
             const RationalVector& n) {
  return PlaneStrips(sheets, m, n).Find();
}

}  // namespace truelux::testing
