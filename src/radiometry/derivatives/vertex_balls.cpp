// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/vertex_balls.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "exact/angle_sum.h"
#include "exact/ball_recipe.h"
#include "exact/recipe_evaluator.h"
#include "radiometry/derivatives/ball_arcs.h"
#include "radiometry/derivatives/vertex_numbers.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// What one arc adds to dE/dv of one vertex, for M = 1 / scale.
template <class T>
struct Term {
  int number = 0;
  SourceId source;
  bool is_of_cut = false;  ///< then only the number counts
  BallVector<T> moved;
  std::array<bool, 3> is_zero{};  ///< per axis, exactly
};

std::array<double, 3> CoordinatesOf(const Point3& p) {
  return {p.x, p.y, p.z};
}

template <class T>
class TermCollector {
 public:
  TermCollector(const WeightedContour& contour, const Scene& scene,
                BallGeometry<T>& geometry)
      : arcs_(contour, geometry),
        scene_(scene),
        numbers_(scene),
        normal_(geometry.receiver_normal()) {}

  std::vector<Term<T>> Collect() {
    const WeightedContour& contour = arcs_.contour();
    for (const SourceId source : contour.contour.sources.ids()) {
      if (!contour.IsLit(source)) continue;
      for (const Arc& arc : contour.ArcsOf(source))
        Add(source, arc);
    }
    return std::move(terms_);
  }

 private:
  void Add(SourceId source, const Arc& arc) {
    const PlaneRecipe& plane = arcs_.contour().contour.planes[arc.plane];
    if (plane.kind() == PlaneRecipe::Kind::kEdge) {
      AddEdge(source, arc, plane);
    } else if (plane.kind() == PlaneRecipe::Kind::kCut) {
      AddFace(plane.first_triangle());
      AddFace(plane.second_triangle());
    }
  }

  void AddFace(TriangleId t) {
    const Triangle& triangle = arcs_.contour().view.triangles[t];
    const Face& face = FacesOf(scene_)[FaceOf(scene_, FacetOf(triangle))];
    for (const int number : scene_.corner_numbers().subspan(
             static_cast<std::size_t>(face.first_corner),
             static_cast<std::size_t>(face.corner_count))) {
      terms_.push_back({number, {}, true, {}, {}});
    }
  }

  void AddEdge(SourceId source, const Arc& arc, const PlaneRecipe& plane) {
    const auto [from, to] = plane.negated()
                                ? std::pair{plane.to(), plane.from()}
                                : std::pair{plane.from(), plane.to()};
    const BallArc<T> own = arcs_.At(arc);
    const ScaledVector<T>& n = arcs_.Normal(arc.plane);
    const Ball<T> inverse = Ball<T>(1.0) / Dot(n.vector, n.vector);
    const BallVector<T>& u1 = arcs_.Unit(arc.from);
    const BallVector<T>& u2 = arcs_.Unit(arc.to);
    const Ball<T> sum = own.a * Dot(normal_, Sum(u1, u2));
    const Ball<T> difference = own.b * Dot(normal_, Sum(u2, -u1));
    const Face& face = FacesOf(scene_)[IndexOf(arc.edge_face)];
    const std::array<bool, 3> is_zero = ZerosOfNormal(from, to);
    // y: N x a of the end that moves, or b x N, over N^2.
    const auto add = [&](VertexId vertex, VertexId other,
                         const BallVector<T>& y, int exponent) {
      const BallVector<T> share =
          Shifted(Times(inverse, y), exponent - n.exponent);
      const Ball<T> q1 = Dot(share, u1);
      const Ball<T> q2 = Dot(share, u2);
      const Ball<T> moment = sum * (q1 + q2) + difference * (q2 - q1);
      terms_.push_back({numbers_.Of(face, vertex, other), source, false,
                        Times(-moment, own.inward), is_zero});
    };
    const ScaledVector<T> a = FromReceiver(from);
    const ScaledVector<T> b = FromReceiver(to);
    add(to, from, Cross(n.vector, a.vector), a.exponent);
    add(from, to, Cross(b.vector, n.vector), b.exponent);
  }

  [[nodiscard]] ScaledVector<T> FromReceiver(VertexId vertex) const {
    const ReceiverView& view = arcs_.contour().view;
    const auto d = Difference<T>(view.position, view.vertices[vertex]);
    ScaledVector<T> scaled;
    if (ScaleToUnit(d.value, d.error, scaled)) return scaled;
    return ScaleToUnit<T>(RecipeEvaluator<Exact>(view).FromReceiver(vertex));
  }

  /// Per axis whether both products of that component of (a - r) x (b - a) are
  /// 0: so it is for edges along the axis.
  [[nodiscard]] std::array<bool, 3> ZerosOfNormal(VertexId from,
                                                  VertexId to) const {
    const ReceiverView& view = arcs_.contour().view;
    const auto r = CoordinatesOf(view.position);
    const auto a = CoordinatesOf(view.vertices[from]);
    const auto b = CoordinatesOf(view.vertices[to]);
    std::array<bool, 3> is_zero{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3;
      const std::size_t j = (k + 2) % 3;
      is_zero[k] =
          (a[i] == r[i] || a[j] == b[j]) && (a[j] == r[j] || a[i] == b[i]);
    }
    return is_zero;
  }

  BallArcs<T> arcs_;
  const Scene& scene_;
  VertexNumbers numbers_;
  const BallVector<T>& normal_;
  std::vector<Term<T>> terms_;
};

/// Adds a term to its vertex. factor: 1 / (pi |n|), or 1 / |n|.
template <class T>
void AddTerm(const Term<T>& term, const Ball<T>& factor, const Rgb& weight,
             VertexBall<T>& vertex) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (weight[channel] == 0) continue;
    BallVector<T>& slope = vertex.slopes[channel];
    slope = Sum(slope, Times(factor * Ball<T>(weight[channel]), term.moved));
    for (std::size_t k = 0; k < 3; ++k) {
      vertex.is_zero[channel][k] =
          vertex.is_zero[channel][k] && term.is_zero[k];
    }
  }
}

}  // namespace

template <class T>
std::vector<VertexBall<T>> VertexBallsOf(const WeightedContour& contour,
                                         const Scene& scene, Emission emission,
                                         BallGeometry<T>& geometry) {
  std::vector<Term<T>> terms =
      TermCollector<T>(contour, scene, geometry).Collect();
  std::ranges::stable_sort(terms, {}, &Term<T>::number);
  const Ball<T> one(1.0);
  Ball<T> factor = one / Length(geometry.receiver_normal());
  if (emission == Emission::kExitance)
    factor = factor * Ball<T>(0.5) / HalfPi<T>();
  std::vector<VertexBall<T>> vertices;
  for (const Term<T>& term : terms) {
    if (vertices.empty() || vertices.back().number != term.number) {
      VertexBall<T>& vertex = vertices.emplace_back();
      vertex.number = term.number;
      vertex.is_zero.fill({true, true, true});
    }
    VertexBall<T>& vertex = vertices.back();
    if (term.is_of_cut)
      vertex.has_cuts = true;
    else
      AddTerm(term, factor, contour.WeightOf(term.source), vertex);
  }
  return vertices;
}

template std::vector<VertexBall<double>> VertexBallsOf(const WeightedContour&,
                                                       const Scene&, Emission,
                                                       BallGeometry<double>&);
template std::vector<VertexBall<DoubleDouble>> VertexBallsOf(
    const WeightedContour&, const Scene&, Emission,
    BallGeometry<DoubleDouble>&);

}  // namespace truelux
