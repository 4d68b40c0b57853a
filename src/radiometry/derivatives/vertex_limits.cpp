// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/vertex_limits.h"

#include <utility>

#include "exact/displacement.h"
#include "exact/exact_conversion.h"
#include "radiometry/derivatives/arb_field.h"
#include "radiometry/evaluate.h"

namespace truelux {
namespace {

ArbReal Zero() {
  return ArbReal(64, 0L);
}

/// E per channel: n.V / |n|.
std::array<ArbReal, 3> IrradianceOf(const MovingContour& contour,
                                    const std::vector<Rgb>& weights,
                                    Emission emission, slong precision) {
  const auto fields = ArbFieldsOf(contour, weights.size(), precision);
  const Vec3<ArbReal> n = ArbVector(precision, contour.receiver_normal);
  const ArbReal length = Sqrt(Dot(n, n));
  std::array<ArbReal, 3> sums = {Zero(), Zero(), Zero()};
  for (std::size_t s = 0; s < fields.size(); ++s) {
    const ArbReal factor = Dot(n, fields[s].vector) / length;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      sums[channel] = sums[channel] +
                      factor * ArbReal(precision, Exact(weights[s][channel]));
    }
  }
  if (emission == Emission::kRadiance) {
    for (ArbReal& sum : sums)
      sum = sum * ArbReal::Pi(precision);
  }
  return sums;
}

/// Whether x is 0 but for what a step leaves, beside something of a size.
bool IsNothing(const ArbReal& x, const ArbReal& size) {
  return x.IsAtMost(size.TimesTwoTo(-490));
}

}  // namespace

std::array<Vec3<ArbReal>, 3> VertexSums(const MovingContour& contour,
                                        const std::vector<VertexTerm>& terms,
                                        const std::vector<Rgb>& weights,
                                        Emission emission, slong precision) {
  const Vec3<ArbReal> n = ArbVector(precision, contour.receiver_normal);
  ArbReal scale = ArbReal(precision, 1L) / Sqrt(Dot(n, n));
  if (emission == Emission::kExitance) scale = scale / ArbReal::Pi(precision);
  const ArbReal zero(precision, 0L);
  const Vec3<ArbReal> none{zero, zero, zero};
  std::array<Vec3<ArbReal>, 3> sums = {none, none, none};
  for (const VertexTerm& term : terms) {
    const MovingArc& moving = contour.arcs[term.arc];
    const ArbArc arc(moving, precision);
    const ArbReal moment =
        Dot(n, arc.Moment(ArbVector(precision, term.y))) / Sqrt(arc.square());
    const ArbReal factor = scale * moment * ArbReal(precision, term.above) /
                           ArbReal(precision, term.below);
    const Vec3<ArbReal> moved = factor * ArbVector(precision, term.direction);
    const Rgb& weight = weights[moving.source.index()];
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (weight[channel] == 0) continue;
      sums[channel] =
          sums[channel] + ArbReal(precision, Exact(weight[channel])) * moved;
    }
  }
  return sums;
}

VertexLimits::VertexLimits(const LooseEngine& loose, const ContourQuery& query,
                           Emission emission)
    : loose_(loose),
      query_(query),
      emission_(emission),
      builder_(loose.engine),
      range_(CoordinateRangeOf(query)),
      exponent_(range_.StepExponent()),
      precision_(StepPrecision(exponent_)) {
  query_.scene = loose.scene.scene;
  const Displacement nowhere;
  query_.displacement = &nowhere;
  builder_.Build(query_, contour_);
  std::vector<Rgb> weights;
  FindWeights(query_, contour_, weights);
  irradiance_ = IrradianceOf(MovingContourOf(ViewOf(query_), contour_), weights,
                             emission, precision_);
  query_.displacement = nullptr;
}

auto VertexLimits::SideOf(int number, std::size_t axis, bool right) -> OneSide {
  const Exact step = TimesPowerOfTwo(Exact(right ? 1 : -1), exponent_);
  const Exact zero(0);
  const Displacement displacement{
      {zero, zero, zero},
      loose_.scene.VertexOf(number),
      {axis == 0 ? step : zero, axis == 1 ? step : zero,
       axis == 2 ? step : zero}};
  ContourQuery query = query_;
  query.displacement = &displacement;
  if (const auto other = WithDisplacedTriangles(
          loose_.scene, displacement.vertex, displacement.of_vertex)) {
    query.scene = *other;
    const ContourEngine engine(query.scene);
    DisplacedContourBuilder(engine).Build(query, contour_);
  } else {
    builder_.Build(query, contour_);
  }
  const ReceiverView view = ViewOf(query);
  const MovingContour contour = MovingContourOf(view, contour_);
  std::vector<Rgb> weights;
  FindWeights(query, contour_, weights);
  OneSide side{IrradianceOf(contour, weights, emission_, precision_),
               {Zero(), Zero(), Zero()},
               {Zero(), Zero(), Zero()},
               {Zero(), Zero(), Zero()}};
  for (const Rgb& weight : weights) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      side.exitance[channel] =
          side.exitance[channel] + ArbReal(precision_, Exact(weight[channel]));
      side.size[channel] = side.size[channel] + range_.Slope(weight[channel]);
    }
  }
  const VertexTerms terms = VertexTermsOf(view, query.scene, contour);
  for (const auto& [other, own] : terms) {
    const auto sums = VertexSums(contour, own, weights, emission_, precision_);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const Vec3<ArbReal>& v = sums[channel];
      side.size[channel] =
          side.size[channel] + v.x.Absolute() + v.y.Absolute() + v.z.Absolute();
      if (other == number) {
        side.slope[channel] = axis == 0 ? v.x : axis == 1 ? v.y : v.z;
      }
    }
  }
  return side;
}

VertexDerivative VertexLimits::At(int number) {
  VertexDerivative result;
  result.number = number;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const OneSide left = SideOf(number, axis, false);
    const OneSide right = SideOf(number, axis, true);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      VertexSlope& slope = result.slopes[channel][axis];
      const ArbReal size = left.size[channel] + right.size[channel];
      const ArbReal whole = irradiance_[channel].Absolute() +
                            left.exitance[channel] + right.exitance[channel];
      slope.left_jumps =
          !IsNothing(left.irradiance[channel] - irradiance_[channel], whole);
      slope.right_jumps =
          !IsNothing(right.irradiance[channel] - irradiance_[channel], whole);
      const bool is_same =
          IsNothing(left.slope[channel] - right.slope[channel], size);
      const auto rounded = [&size](const ArbReal& x) {
        return IsNothing(x, size) ? 0 : x.Nearest();
      };
      if (!slope.left_jumps) slope.left = rounded(left.slope[channel]);
      if (!slope.right_jumps) {
        slope.right = is_same && !slope.left_jumps
                          ? slope.left
                          : rounded(right.slope[channel]);
      }
    }
  }
  return result;
}

}  // namespace truelux
