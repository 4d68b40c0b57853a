// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/vertex_terms.h"

#include <utility>

#include "exact/recipe_evaluator.h"
#include "radiometry/derivatives/vertex_numbers.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

class TermWriter {
 public:
  TermWriter(const ReceiverView& view, const Scene& scene)
      : view_(view), scene_(scene), exact_(view), numbers_(scene) {}

  void AddEdge(const MovingArc& arc, std::size_t index) {
    const Face& face = FacesOf(scene_)[IndexOf(arc.face)];
    const Vec3<Exact> a = exact_.FromReceiver(arc.from);
    const Vec3<Exact> b = exact_.FromReceiver(arc.to);
    const Exact square = Dot(arc.normal, arc.normal);
    const Exact sign(arc.outward ? 1 : -1);
    const auto add = [&](VertexId vertex, VertexId other, Vec3<Exact> y) {
      terms_[numbers_.Of(face, vertex, other)].push_back(
          {index, sign, square, arc.normal, std::move(y)});
    };
    add(arc.to, arc.from, Cross(arc.normal, a));
    add(arc.from, arc.to, Cross(b, arc.normal));
  }

  void AddCut(const MovingArc& arc, std::size_t index) {
    const Exact h_s = exact_.Height(arc.source_triangle);
    const Exact h_t = exact_.Height(arc.other_triangle);
    const Exact sign(arc.outward != arc.turned ? 1 : -1);
    AddTriangle(arc.source_triangle, sign * h_t, h_s, index);
    AddTriangle(arc.other_triangle, -sign * h_s, h_t, index);
  }

  VertexTerms Take() { return std::move(terms_); }

 private:
  void AddTriangle(TriangleId t, const Exact& above, const Exact& below,
                   std::size_t index) {
    const Triangle& triangle = view_.triangles[t];
    const Face& face = FacesOf(scene_)[FaceOf(scene_, FacetOf(triangle))];
    const auto corners = CornersOf(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId next = corners[(k + 1) % 3];
      const VertexId last = corners[(k + 2) % 3];
      terms_[numbers_.Of(face, corners[k], next)].push_back(
          {index, above, below, exact_.TriangleNormal(t),
           Cross(exact_.FromReceiver(next), exact_.FromReceiver(last))});
    }
  }

  const ReceiverView& view_;
  const Scene& scene_;
  RecipeEvaluator<Exact> exact_;
  VertexNumbers numbers_;
  VertexTerms terms_;
};

}  // namespace

VertexTerms VertexTermsOf(const ReceiverView& view, const Scene& scene,
                          const MovingContour& contour) {
  TermWriter writer(view, scene);
  for (std::size_t i = 0; i < contour.arcs.size(); ++i) {
    const MovingArc& arc = contour.arcs[i];
    if (arc.kind == ArcLine::kEdge) writer.AddEdge(arc, i);
    if (arc.kind == ArcLine::kCut) writer.AddCut(arc, i);
  }
  return writer.Take();
}

}  // namespace truelux
