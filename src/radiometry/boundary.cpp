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
  Builder(const FrameGeometry<W>& geometry, int source)
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
    const auto end = [&](int i) -> const DirectionRecipe& {
      return contour.directions[static_cast<std::size_t>(i)];
    };
    const PlaneRecipe& plane =
        contour.planes[static_cast<std::size_t>(arc.plane)];
    bool whole = false;
    if (plane.kind == PlaneRecipe::Kind::kEdge) {
      // a x b is the plane's normal, and (from x to) . N > 0 if positive.
      const bool backwards = arc.positive != plane.negated;
      const int first = backwards ? plane.b : plane.a;
      const int last = backwards ? plane.a : plane.b;
      whole = IsVertex(end(arc.to), first) && IsVertex(end(arc.from), last);
      if (!whole)
        added.edge = Converted<T>(geometry_.Edge(source_, first, last));
    }
    if (whole && !added.on_horizon) {
      added.normal = Cross(Vertex(added.from).point, added.chord);
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
  static bool IsVertex(const DirectionRecipe& d, int v) {
    return d.kind == DirectionRecipe::Kind::kVertex && !d.negated && d.a == v;
  }

  const BoundaryVertex<T>& Vertex(int i) const {
    return boundary_.vertices[static_cast<std::size_t>(i)];
  }

  int VertexOf(int direction) {
    const int next = static_cast<int>(boundary_.vertices.size());
    const auto [place, is_new] = index_.emplace(direction, next);
    if (is_new) {
      if (next == 0) first_ = direction;
      boundary_.vertices.push_back(
          {Converted<T>(geometry_.Point(source_, direction)),
           Converted<T>(geometry_.Between(source_, first_, direction)),
           geometry_.OnHorizon(direction)});
    }
    return place->second;
  }

  const FrameGeometry<W>& geometry_;
  int source_;
  int first_ = -1;  ///< the direction that is vertex 0
  Boundary<T> boundary_;
  std::unordered_map<int, int> index_;     ///< direction -> vertex
  std::vector<std::pair<int, int>> ends_;  ///< directions of each arc
};

}  // namespace

template <class T>
Boundary<T> BoundaryOf(
    const FrameGeometry<typename WorkingType<T>::Type>& geometry, int source,
    bool with_fan) {
  Builder<T> builder(geometry, source);
  const WeightedContour& contour = geometry.contour();
  for (const Arc& arc : contour.ArcsOf(
           contour.contour.sources[static_cast<std::size_t>(source)])) {
    builder.Add(arc);
  }
  if (with_fan) builder.AddFan();
  return builder.Finish();
}

template Boundary<float> BoundaryOf(const FrameGeometry<Ball<DoubleDouble>>&,
                                    int, bool);
template Boundary<double> BoundaryOf(const FrameGeometry<Ball<DoubleDouble>>&,
                                     int, bool);
template Boundary<DoubleDouble> BoundaryOf(
    const FrameGeometry<Ball<DoubleDouble>>&, int, bool);
template Boundary<Ball<double>> BoundaryOf(
    const FrameGeometry<Ball<DoubleDouble>>&, int, bool);
template Boundary<Multiprecision> BoundaryOf(
    const FrameGeometry<Multiprecision>&, int, bool);

}  // namespace truelux
