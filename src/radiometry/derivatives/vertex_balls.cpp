// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/vertex_balls.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "exact/angle_sum.h"
#include "exact/ball_recipe.h"
#include "exact/recipe_evaluator.h"
#include "radiometry/derivatives/ball_arcs.h"
#include "radiometry/derivatives/vertex_numbers.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// What one arc adds to dE/dv of one vertex, for M = 1 / scale: the moment times
/// the direction.
template <class T>
struct Term {
  int number = 0;
  SourceId source;
  bool is_of_cut = false;  ///< then only the number counts
  Ball<T> moment;
  BallVector<T> direction;
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
      terms_.push_back({number, {}, true, {}, {}, {}});
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
    const Ball<T> rise1 = Dot(normal_, u1);
    const Ball<T> rise2 = Dot(normal_, u2);
    const Ball<T> sum = own.a * (rise1 + rise2);
    const Ball<T> difference = own.b * (rise2 - rise1);
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
                        -moment, own.inward, is_zero});
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

/// One vertex while its terms are added.
template <class T>
class VertexSum {
 public:
  /// common: what all sources emit, if that is the same.
  explicit VertexSum(const std::optional<Rgb>& common) : common_(common) {
    for (std::array<bool, 3>& flags : is_zero_)
      flags.fill(true);
  }

  void Add(const Term<T>& term, const Rgb& weights) {
    if (term.is_of_cut) {
      has_cuts_ = true;
      return;
    }
    if (common_) sums_[0].Add(term.moment, term.direction);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (weights[channel] == 0) continue;
      if (!common_) {
        sums_[channel].Add(Ball<T>(weights[channel]) * term.moment,
                           term.direction);
      }
      for (std::size_t k = 0; k < 3; ++k)
        is_zero_[channel][k] = is_zero_[channel][k] && term.is_zero[k];
    }
  }

  /// factor: 1 / (pi |n|), or 1 / |n|.
  [[nodiscard]] VertexBall<T> Get(int number, const Ball<T>& factor) const {
    VertexBall<T> vertex;
    vertex.number = number;
    vertex.has_cuts = has_cuts_;
    vertex.is_zero = is_zero_;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const Ball<T> scale =
          common_ ? factor * Ball<T>((*common_)[channel]) : factor;
      vertex.slopes[channel] = Times(scale, sums_[common_ ? 0 : channel].Get());
    }
    return vertex;
  }

 private:
  std::optional<Rgb> common_;
  std::array<VectorSum<T>, 3> sums_;  ///< only the first if common_
  std::array<std::array<bool, 3>, 3> is_zero_{};
  bool has_cuts_ = false;
};

}  // namespace

template <class T>
std::vector<VertexBall<T>> VertexBallsOf(const WeightedContour& contour,
                                         const Scene& scene, Emission emission,
                                         BallGeometry<T>& geometry) {
  std::vector<Term<T>> terms =
      TermCollector<T>(contour, scene, geometry).Collect();
  std::vector<std::size_t> order(terms.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&terms](std::size_t i) { return terms[i].number; });
  const Ball<T> one(1.0);
  Ball<T> factor = one / Length(geometry.receiver_normal());
  if (emission == Emission::kExitance)
    factor = factor * Ball<T>(0.5) / HalfPi<T>();
  const std::optional<Rgb> common = CommonWeights(contour);
  std::vector<VertexBall<T>> vertices;
  for (std::size_t i = 0; i < order.size();) {
    const int number = terms[order[i]].number;
    VertexSum<T> sum(common);
    for (; i < order.size() && terms[order[i]].number == number; ++i) {
      const Term<T>& term = terms[order[i]];
      sum.Add(term, term.is_of_cut ? Rgb{} : contour.WeightOf(term.source));
    }
    vertices.push_back(sum.Get(number, factor));
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
