// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/moving_contour.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "exact/recipe_evaluator.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// The line that a plane of the contour is the plane of.
void SetLine(const RecipeEvaluator<Exact>& exact, const PlaneRecipe& plane,
             MovingArc& arc) {
  const Vec3<Exact> none{Exact(0), Exact(0), Exact(0)};
  switch (plane.kind()) {
    case PlaneRecipe::Kind::kEdge:
      arc.kind = ArcLine::kEdge;
      arc.from = plane.negated() ? plane.to() : plane.from();
      arc.to = plane.negated() ? plane.from() : plane.to();
      arc.line = exact.FromVertex(arc.from, arc.to);
      return;
    case PlaneRecipe::Kind::kCut:
      arc.kind = ArcLine::kCut;
      arc.source_triangle = plane.first_triangle();
      arc.other_triangle = plane.second_triangle();
      arc.turned = plane.negated();
      arc.line = Cross(exact.TriangleNormal(arc.source_triangle),
                       exact.TriangleNormal(arc.other_triangle));
      if (arc.turned) arc.line = -arc.line;
      return;
    case PlaneRecipe::Kind::kHorizon:
      arc.kind = ArcLine::kHorizon;
      arc.line = none;
      return;
    case PlaneRecipe::Kind::kExplicit:
      break;
  }
  assert(false && "a contour without lines");
}

/// Splits one arc on a cut.
class CutSplitter {
 public:
  CutSplitter(const ReceiverView& view, const Scene& scene)
      : view_(view), scene_(scene), exact_(view) {}

  void Split(const MovingArc& arc, std::vector<MovingArc>& parts) const {
    std::vector<Vec3<Exact>> ends = {arc.first, arc.last};
    for (const TriangleId t : {arc.source_triangle, arc.other_triangle}) {
      for (const TriangleId own : TrianglesOfFacet(t))
        AddEnds(arc, own, ends);
    }
    std::sort(ends.begin(), ends.end(),
              [&arc](const Vec3<Exact>& a, const Vec3<Exact>& b) {
                return SignOf(Determinant(a, b, arc.normal)) == Sign::kPositive;
              });
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const Exact t = Determinant(ends[i], ends[i + 1], arc.normal);
      if (SignOf(t) != Sign::kPositive) continue;  // one direction twice
      const Vec3<Exact> middle = ends[i] + ends[i + 1];
      MovingArc& part = parts.emplace_back(arc);
      part.first = ends[i];
      part.last = ends[i + 1];
      part.source_triangle = Around(arc.source_triangle, middle);
      part.other_triangle = Around(arc.other_triangle, middle);
      part.normal = exact_.Plane(
          PlaneRecipe::OfCut(part.source_triangle, part.other_triangle)
              .NegatedIf(arc.turned),
          {});
      part.line = Cross(exact_.TriangleNormal(part.source_triangle),
                        exact_.TriangleNormal(part.other_triangle));
      if (arc.turned) part.line = -part.line;
    }
  }

 private:
  [[nodiscard]] IdRange<TriangleId> TrianglesOfFacet(TriangleId t) const {
    const Facet& facet = FacetsOf(scene_)[FacetOf(view_.triangles[t])];
    return {FirstTriangleOf(facet), facet.triangle_count};
  }

  /// Where the arc crosses the sides of a triangle.
  void AddEnds(const MovingArc& arc, TriangleId t,
               std::vector<Vec3<Exact>>& ends) const {
    const auto corners = CornersOf(view_.triangles[t]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3<Exact> side = Cross(exact_.FromReceiver(corners[k]),
                                     exact_.FromReceiver(corners[(k + 1) % 3]));
      Vec3<Exact> d = Cross(arc.normal, side);
      if (IsZero(d)) continue;
      if (SignOf(Dot(d, arc.first + arc.last)) == Sign::kNegative) d = -d;
      const bool is_inside =
          SignOf(Determinant(arc.first, d, arc.normal)) == Sign::kPositive &&
          SignOf(Determinant(d, arc.last, arc.normal)) == Sign::kPositive;
      if (is_inside) ends.push_back(std::move(d));
    }
  }

  /// The triangle of t's facet in whose cone a direction is; t if it is in none.
  [[nodiscard]] TriangleId Around(TriangleId t, const Vec3<Exact>& d) const {
    for (const TriangleId own : TrianglesOfFacet(t)) {
      const auto corners = CornersOf(view_.triangles[own]);
      bool any_positive = false;
      bool any_negative = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const Sign side =
            SignOf(Determinant(exact_.FromReceiver(corners[k]),
                               exact_.FromReceiver(corners[(k + 1) % 3]), d));
        any_positive = any_positive || side == Sign::kPositive;
        any_negative = any_negative || side == Sign::kNegative;
      }
      if (!any_positive || !any_negative) return own;
    }
    return t;
  }

  const ReceiverView& view_;
  const Scene& scene_;
  RecipeEvaluator<Exact> exact_;
};

}  // namespace

MovingContour MovingContourOf(const ReceiverView& view,
                              const Contour& contour) {
  const RecipeEvaluator<Exact> exact(view);
  const auto vectors = contour.explicit_vectors.All();
  MovingContour result;
  result.receiver_normal = exact.ReceiverNormal();
  result.arcs.reserve(contour.arcs.size());
  for (const SourceId source : contour.sources.ids()) {
    for (const Arc& arc : contour.ArcsOf(contour.sources[source])) {
      MovingArc& moving = result.arcs.emplace_back();
      moving.source = source;
      moving.face = arc.edge_face;
      moving.outward = !arc.positive;
      const PlaneRecipe& plane = contour.planes[arc.plane];
      moving.normal = exact.Plane(plane, vectors);
      SetLine(exact, plane, moving);
      moving.first = exact.Direction(contour.directions[arc.from],
                                     contour.planes, vectors);
      moving.last =
          exact.Direction(contour.directions[arc.to], contour.planes, vectors);
      if (!arc.positive) std::swap(moving.first, moving.last);
    }
  }
  return result;
}

void SplitCuts(const ReceiverView& view, const Scene& scene,
               MovingContour& contour) {
  const CutSplitter splitter(view, scene);
  std::vector<MovingArc> arcs;
  for (MovingArc& arc : contour.arcs) {
    if (arc.kind == ArcLine::kCut) {
      splitter.Split(arc, arcs);
    } else {
      arcs.push_back(std::move(arc));
    }
  }
  contour.arcs = std::move(arcs);
}

}  // namespace truelux
