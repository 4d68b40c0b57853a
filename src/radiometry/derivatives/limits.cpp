// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/limits.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "exact/displacement.h"
#include "exact/exact_conversion.h"
#include "radiometry/evaluate.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// A step aside is so much smaller than the one that it is taken from.
constexpr double kAside = 0x1p-64;

/// Steps in general position: in no plane that a scene has for a reason.
constexpr Vec3<double> kSteps[] = {
    {0.42955857, -0.45405198, 0.76495242},
    {-0.82509993, -0.93499051, 0.02727396},
    {0.95447552, 0.04304652, -0.89805821},
};
constexpr Vec3<double> kAcross = {1.10757409, -0.85257302, 0.76673040};

Vec3<Exact> ExactOf(const Vec3<double>& v) {
  return {Exact(v.x), Exact(v.y), Exact(v.z)};
}

/// v times a power of two, its largest component in [1/2, 1).
Vec3<Exact> AboutOne(const Vec3<Exact>& v) {
  long exponent = 0;
  bool any = false;
  for (const Exact* x : {&v.x, &v.y, &v.z}) {
    if (x->is_zero()) continue;
    const long own = BinaryExponentOf(*x);
    exponent = any ? std::max(exponent, own) : own;
    any = true;
  }
  return {TimesPowerOfTwo(v.x, -exponent), TimesPowerOfTwo(v.y, -exponent),
          TimesPowerOfTwo(v.z, -exponent)};
}

/// Per channel J at a displaced receiver, and a bound on its size.
struct DisplacedJacobian {
  std::array<std::array<Vec3<ArbReal>, 3>, 3> rows;
  ArbRgb size;
};

class LimitFinder {
 public:
  LimitFinder(const ContourEngine& engine, const ContourQuery& query)
      : query_(query),
        builder_(engine),
        range_(CoordinateRangeOf(query)),
        exponent_(range_.StepExponent()),
        precision_(StepPrecision(exponent_)) {}

  /// Of what it finds [bits].
  [[nodiscard]] slong precision() const { return precision_; }

  /// direction: of about the length 1.
  DisplacedJacobian At(const Vec3<Exact>& direction) {
    const Displacement displacement{{TimesPowerOfTwo(direction.x, exponent_),
                                     TimesPowerOfTwo(direction.y, exponent_),
                                     TimesPowerOfTwo(direction.z, exponent_)},
                                    {},
                                    {Exact(0), Exact(0), Exact(0)}};
    ContourQuery query = query_;
    query.displacement = &displacement;
    builder_.Build(query, contour_);
    const MovingContour moving = MovingContourOf(ViewOf(query), contour_);
    const auto fields =
        ArbFieldsOf(moving, contour_.sources.size(), precision_);
    std::vector<Rgb> weights;
    FindWeights(query, contour_, weights);
    const ArbReal zero(precision_, 0L);
    const Vec3<ArbReal> none{zero, zero, zero};
    DisplacedJacobian result{
        {{{none, none, none}, {none, none, none}, {none, none, none}}},
        {zero, zero, zero}};
    for (std::size_t s = 0; s < fields.size(); ++s) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        if (weights[s][channel] == 0) continue;
        const ArbReal weight(precision_, Exact(weights[s][channel]));
        result.size[channel] =
            result.size[channel] + range_.Slope(weights[s][channel]);
        for (std::size_t p = 0; p < 3; ++p) {
          Vec3<ArbReal>& row = result.rows[channel][p];
          const Vec3<ArbReal> own = weight * fields[s].jacobian[p];
          row = row + own;
          result.size[channel] = result.size[channel] + own.x.Absolute() +
                                 own.y.Absolute() + own.z.Absolute();
        }
      }
    }
    return result;
  }

 private:
  const ContourQuery& query_;
  DisplacedContourBuilder builder_;
  Contour contour_;
  CoordinateRange range_;
  long exponent_;
  slong precision_;
};

bool AreEqual(const DisplacedJacobian& a, const DisplacedJacobian& b,
              const JacobianLimits& limits) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t p = 0; p < 3; ++p) {
      const Vec3<ArbReal> d = a.rows[channel][p] - b.rows[channel][p];
      for (const ArbReal* x : {&d.x, &d.y, &d.z}) {
        if (!limits.IsZero(*x, channel)) return false;
      }
    }
  }
  return true;
}

Vec3<ArbReal> UnitOf(slong precision, const Vec3<Exact>& m) {
  const Vec3<ArbReal> v = ArbVector(precision, m);
  const ArbReal inverse =
      ArbReal(precision, 1L) / Sqrt(ArbReal(precision, Dot(m, m)));
  return inverse * v;
}

void TakeSize(const DisplacedJacobian& jacobian, ArbRgb& size) {
  for (std::size_t channel = 0; channel < 3; ++channel)
    size[channel] = size[channel] + jacobian.size[channel];
}

}  // namespace

/// What is not zero stays what it is, and what is 0 in the limit is below 2^-500
/// beside it. A predicate is of degree 16 at most (the order of two cuts on a
/// cut), so what is not zero is at least 2^(16 low), and a step of 2^e changes
/// it by less than 2^(e + 15 high + 40). The limits change by the step times
/// second derivatives, fewer than 2^100 times what the lengths 2^low and 2^high
/// allow.
long CoordinateRange::StepExponent() const {
  return 16L * low - 16L * high - 660;
}

CoordinateRange CoordinateRangeOf(const ContourQuery& query) {
  CoordinateRange range;
  const auto take = [&range](double x) {
    if (x == 0) return;
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    const auto bits =
        static_cast<std::uint64_t>(std::fabs(std::ldexp(mantissa, 53)));
    range.high = std::max(range.high, exponent + 1);
    range.low = std::min(range.low, exponent - 53 + std::countr_zero(bits));
  };
  for (const Point3& p : query.scene.vertices()) {
    take(p.x);
    take(p.y);
    take(p.z);
  }
  const auto& [position, normal, face] = query.receiver;
  for (const double x :
       {position.x, position.y, position.z, normal.x, normal.y, normal.z}) {
    take(x);
  }
  return range;
}

JacobianLimits FindLimits(const ContourEngine& engine,
                          const ContourQuery& query,
                          std::span<const KinkPlane> planes) {
  LimitFinder finder(engine, query);
  const ArbReal zero(finder.precision(), 0L);
  JacobianLimits limits;
  limits.size = {zero, zero, zero};
  std::vector<DisplacedJacobian> around;
  for (const Vec3<double>& step : kSteps) {
    for (const bool back : {false, true}) {
      const Vec3<Exact> direction = ExactOf(step);
      around.push_back(finder.At(back ? -direction : direction));
      TakeSize(around.back(), limits.size);
    }
  }
  limits.mean = around.front().rows;
  if (std::ranges::all_of(around, [&](const DisplacedJacobian& other) {
        return AreEqual(other, around.front(), limits);
      })) {
    return limits;
  }
  for (const KinkPlane& plane : planes) {
    const Vec3<Exact> m = AboutOne(plane.normal);
    const Vec3<Exact> along = Cross(m, ExactOf(kAcross));
    const Vec3<Exact> aside = Exact(kAside) * m;
    const DisplacedJacobian above = finder.At(along + aside);
    const DisplacedJacobian below = finder.At(along - aside);
    TakeSize(above, limits.size);
    TakeSize(below, limits.size);
    JacobianJump jump{&plane, UnitOf(finder.precision(), m), {}};
    bool any = false;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      std::array<ArbReal, 3> height;
      for (std::size_t p = 0; p < 3; ++p) {
        height[p] =
            Dot(above.rows[channel][p] - below.rows[channel][p], jump.normal)
                .TimesTwoTo(-1);
        any = any || !limits.IsZero(height[p], channel);
      }
      jump.height[channel] = {height[0], height[1], height[2]};
    }
    if (any) limits.jumps.push_back(std::move(jump));
  }
  // From the limit on one side to the mean.
  const Vec3<Exact> step = ExactOf(kSteps[0]);
  for (const JacobianJump& jump : limits.jumps) {
    const bool above = SignOf(Dot(step, jump.plane->normal)) == Sign::kPositive;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const Vec3<ArbReal>& c = jump.height[channel];
      const std::array<const ArbReal*, 3> heights = {&c.x, &c.y, &c.z};
      for (std::size_t p = 0; p < 3; ++p) {
        const Vec3<ArbReal> change = *heights[p] * jump.normal;
        Vec3<ArbReal>& row = limits.mean[channel][p];
        row = above ? row - change : row + change;
      }
    }
  }
  return limits;
}

}  // namespace truelux
