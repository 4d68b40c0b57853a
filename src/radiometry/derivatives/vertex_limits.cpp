// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/vertex_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/displacement.h"
#include "exact/exact_conversion.h"
#include "radiometry/derivatives/arb_field.h"
#include "radiometry/evaluate.h"
#include "radiometry/stages/rounding.h"

namespace truelux {
namespace {

ArbReal Zero() {
  return ArbReal(64, 0L);
}

bool AreEqual(const Vec3<Exact>& a, const Vec3<Exact>& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// Whether two arcs add the same to E if their sources emit the same.
bool AreEqual(const MovingArc& a, const MovingArc& b) {
  return a.outward == b.outward && AreEqual(a.first, b.first) &&
         AreEqual(a.last, b.last);
}

/// Adds `sign` times what an arc adds to E per channel, -M beta/2 (n.m) / |n|
/// over pi [docs/derivatives.md (2)].
void AddIrradiance(const MovingArc& moving, const Rgb& weight,
                   const Vec3<ArbReal>& unit_normal, long sign, slong precision,
                   std::array<ArbReal, 3>& sums) {
  const ArbArc arc(moving, precision);
  const ArbReal part = arc.angle() * Dot(unit_normal, arc.outward()) *
                       (ArbReal(precision, -sign) / ArbReal(precision, 2L));
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (weight[channel] == 0) continue;
    sums[channel] =
        sums[channel] + part * ArbReal(precision, Exact(weight[channel]));
  }
}

/// E of b less E of a, per channel. Arcs that both have are left out.
std::array<ArbReal, 3> IrradianceBetween(const LitArcs& a, const LitArcs& b,
                                         Emission emission, slong precision) {
  std::array<ArbReal, 3> sums = {Zero(), Zero(), Zero()};
  const Vec3<ArbReal> n = ArbVector(precision, a.contour.receiver_normal);
  ArbReal scale = ArbReal(precision, 1L) / Sqrt(Dot(n, n));
  if (emission == Emission::kExitance) scale = scale / ArbReal::Pi(precision);
  const Vec3<ArbReal> scaled = scale * n;
  std::vector<bool> is_common(a.contour.arcs.size());
  for (const MovingArc& arc : b.contour.arcs) {
    bool found = false;
    for (std::size_t i = 0; i < is_common.size() && !found; ++i) {
      const MovingArc& other = a.contour.arcs[i];
      found = !is_common[i] && AreEqual(arc, other) &&
              a.WeightOf(other) == b.WeightOf(arc);
      if (found) is_common[i] = true;
    }
    if (!found) AddIrradiance(arc, b.WeightOf(arc), scaled, 1, precision, sums);
  }
  for (std::size_t i = 0; i < is_common.size(); ++i) {
    const MovingArc& arc = a.contour.arcs[i];
    if (!is_common[i])
      AddIrradiance(arc, a.WeightOf(arc), scaled, -1, precision, sums);
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
  at_rest_.contour = MovingContourOf(ViewOf(query_), contour_);
  FindWeights(query_, contour_, at_rest_.weights);
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
  LitArcs lit{MovingContourOf(view, contour_), {}};
  FindWeights(query, contour_, lit.weights);
  OneSide side{IrradianceBetween(at_rest_, lit, emission_, precision_),
               {Zero(), Zero(), Zero()},
               {Zero(), Zero(), Zero()},
               {Zero(), Zero(), Zero()}};
  for (const LitArcs* arcs : {&at_rest_, &lit}) {
    for (const Rgb& weight : arcs->weights) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        side.exitance[channel] = side.exitance[channel] +
                                 ArbReal(precision_, Exact(weight[channel]));
      }
    }
  }
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (const Rgb& weight : lit.weights)
      side.size[channel] = side.size[channel] + range_.Slope(weight[channel]);
  }
  VertexTerms terms = VertexTermsOf(view, query.scene, lit.contour);
  for (const VertexTerm& term : terms[number]) {
    const auto parts =
        VertexSums(lit.contour, {term}, lit.weights, emission_, precision_);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const Vec3<ArbReal>& v = parts[channel];
      const ArbReal& part = axis == 0 ? v.x : axis == 1 ? v.y : v.z;
      side.slope[channel] = side.slope[channel] + part;
      side.size[channel] =
          side.size[channel] + v.x.Absolute() + v.y.Absolute() + v.z.Absolute();
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
      const ArbReal whole = left.exitance[channel] + right.exitance[channel];
      slope.left_jumps = !IsNothing(left.step[channel], whole);
      slope.right_jumps = !IsNothing(right.step[channel], whole);
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
      slope.bound =
          HalfSpacing(std::max(std::fabs(slope.left), std::fabs(slope.right)));
    }
  }
  return result;
}

}  // namespace truelux
