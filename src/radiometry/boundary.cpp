// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/boundary.h"

#include <cmath>
#include <type_traits>
#include <unordered_map>

namespace truelux {
namespace {

template <class T>
T Converted(const Ball<DoubleDouble>& x) {
  if constexpr (std::is_same_v<T, DoubleDouble>) {
    return x.value;
  } else if constexpr (kIsBall<T>) {
    // A number without error stays one: formulas ask for exact zeros.
    const double rest = std::fabs(x.value.low);
    return {x.value.high, x.error == 0 ? rest : RoundBoundUp(rest + x.error)};
  } else {
    return static_cast<T>(x.value.high);
  }
}

template <class T>
const Multiprecision& Converted(const Multiprecision& x) {
  return x;
}

template <class T, class W>
Vec3<T> Converted(const Vec3<W>& v) {
  return {Converted<T>(v.x), Converted<T>(v.y), Converted<T>(v.z)};
}

/// Gathers the vertices and arcs of one source.
template <class T>
class Builder {
  using W = typename WorkingType<T>::Type;

 public:
  Builder(const FrameGeometry<W>& geometry, SourceId source)
      : geometry_(geometry), source_(source) {}

  void Add(const Arc& arc) {
    // A contour's arcs run clockwise as seen from r.
    BoundaryArc<T> added;
    added.from = VertexOf(arc.to);
    added.to = VertexOf(arc.from);
    added.chord = Converted<T>(geometry_.Between(source_, arc.to, arc.from));
    added.edge = added.chord;
    added.on_horizon = geometry_.IsHorizon(arc.plane);
    const Contour& contour = geometry_.contour().contour;
    const PlaneRecipe& plane = contour.planes[arc.plane];
    bool whole = false;
    if (plane.kind() == PlaneRecipe::Kind::kEdge) {
      // a x b is the plane's normal, and (from x to) . N > 0 if positive.
      const bool backwards = arc.positive != plane.negated();
      const VertexId first = backwards ? plane.to() : plane.from();
      const VertexId last = backwards ? plane.from() : plane.to();
      whole = contour.directions[arc.to] == DirectionRecipe::ToVertex(first) &&
              contour.directions[arc.from] == DirectionRecipe::ToVertex(last);
      if (!whole)
        added.edge = Converted<T>(geometry_.Edge(source_, first, last));
    }
    if (whole && !added.on_horizon) {
      added.normal = Cross(boundary_.From(added).point, added.chord);
    } else {
      added.normal = Converted<T>(geometry_.Plane(arc.plane));
      if (arc.positive) added.normal = -added.normal;
    }
    boundary_.arcs.push_back(std::move(added));
    ends_.emplace_back(arc.to, arc.from);
  }

  void AddFan() {
    for (const auto& [from, to] : ends_) {
      const bool flat = from == first_ || to == first_;
      boundary_.fan.push_back(
          flat ? Make<T>(0)
               : Converted<T>(-geometry_.UnitDeterminant(first_, from, to)));
    }
  }

  Boundary<T> Finish() {
    if (!boundary_.vertices.empty())
      boundary_.pi = Pi(boundary_.vertices.front().point.x);
    return std::move(boundary_);
  }

 private:
  BoundaryVertexId VertexOf(DirectionId direction) {
    const auto [place, is_new] =
        index_.emplace(direction, boundary_.vertices.end_id());
    if (is_new) {
      if (boundary_.vertices.empty()) first_ = direction;
      boundary_.vertices.push_back(
          {Converted<T>(geometry_.Point(source_, direction)),
           Converted<T>(geometry_.Between(source_, first_, direction)),
           geometry_.OnHorizon(direction)});
    }
    return place->second;
  }

  const FrameGeometry<W>& geometry_;
  SourceId source_;
  DirectionId first_;  ///< the direction that is the first vertex
  Boundary<T> boundary_;
  std::unordered_map<DirectionId, BoundaryVertexId> index_;
  std::vector<std::pair<DirectionId, DirectionId>> ends_;  ///< of each arc
};

}  // namespace

template <class T>
Boundary<T> BoundaryOf(
    const FrameGeometry<typename WorkingType<T>::Type>& geometry,
    SourceId source, bool with_fan) {
  Builder<T> builder(geometry, source);
  for (const Arc& arc : geometry.contour().ArcsOf(source))
    builder.Add(arc);
  if (with_fan) builder.AddFan();
  return builder.Finish();
}

template Boundary<float> BoundaryOf(const FrameGeometry<Ball<DoubleDouble>>&,
                                    SourceId, bool);
template Boundary<double> BoundaryOf(const FrameGeometry<Ball<DoubleDouble>>&,
                                     SourceId, bool);
template Boundary<DoubleDouble> BoundaryOf(
    const FrameGeometry<Ball<DoubleDouble>>&, SourceId, bool);
template Boundary<Ball<double>> BoundaryOf(
    const FrameGeometry<Ball<DoubleDouble>>&, SourceId, bool);
template Boundary<Multiprecision> BoundaryOf(
    const FrameGeometry<Multiprecision>&, SourceId, bool);

}  // namespace truelux
