// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/fixed_visibility.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "base/vector_math.h"
#include "explain/arc_integral.h"
#include "scene/emitters.h"
#include "scene/facet_normal.h"

namespace truelux {
namespace {

constexpr double kPi = std::numbers::pi;

bool IsPlanar(const Scene& scene, const Face& face) {
  const auto facets =
      scene.facets().subspan(static_cast<std::size_t>(face.first_facet),
                             static_cast<std::size_t>(face.facet_count));
  return std::ranges::count(facets, false, &Facet::is_back) == 1;
}

/// One receiver.
class ArcSum {
 public:
  ArcSum(const Oracle& oracle, const Receiver& receiver)
      : scene_(oracle.scene()),
        emission_(oracle.options().emission),
        receiver_(receiver),
        contour_(oracle.Contour(receiver)),
        normal_(UnitOf(receiver.normal)) {}

  /// As if all arcs lay on their sources.
  [[nodiscard]] GradientRow AtSourceDepth() const {
    GradientRow sum{};
    for (const ContourArc& arc : contour_.arcs)
      Add(arc, sum);
    return sum;
  }

  /// Only arcs that do.
  [[nodiscard]] GradientRow OwnEdgesOnly() const {
    GradientRow sum{};
    for (const ContourArc& arc : contour_.arcs) {
      if (arc.edge_face == arc.source) Add(arc, sum);
    }
    return sum;
  }

 private:
  [[nodiscard]] const Face& FaceOf(int number) const {
    return scene_.faces()[static_cast<std::size_t>(number - 1)];
  }

  [[nodiscard]] Vector3 DirectionOf(int vertex) const {
    return UnitOf(
        contour_.vertices[static_cast<std::size_t>(vertex)].direction);
  }

  /// G with 1 / rho = G . w for directions w to the plane of a face.
  [[nodiscard]] Vector3 InverseDistanceOf(const Face& face) const {
    const Facet& facet =
        scene_.facets()[static_cast<std::size_t>(face.first_facet)];
    const Vector3 n = UnitOf(FacetNormal(scene_, face.first_facet));
    const int corner =
        scene_.triangles()[static_cast<std::size_t>(facet.first_triangle)]
            .vertices[0];
    const double height =
        Dot(n, FromTo(receiver_.position,
                      scene_.vertices()[static_cast<std::size_t>(corner)]));
    return Times(1 / height, n);
  }

  /// docs/derivatives.md (3), with the source's 1 / rho. Arcs of the horizon
  /// add 0: they are at right angles to the normal.
  void Add(const ContourArc& arc, GradientRow& sum) const {
    const Face& source = FaceOf(arc.source);
    const Vector3 first = DirectionOf(arc.from);
    const Vector3 last = DirectionOf(arc.to);
    const Vector3 g = InverseDistanceOf(source);
    const Vector3 inward = UnitOf(arc.plane_normal);
    // first x (last - first) keeps the digits of a short arc.
    const double angle = std::atan2(
        LengthOf(Cross(first, Difference(last, first))), Dot(first, last));
    const Vector3 k =
        InverseDistances(first, last, Dot(g, first), Dot(g, last), angle);
    const double scale =
        Dot(normal_, k) * (emission_ == Emission::kRadiance ? kPi : 1) / kPi;
    for (std::size_t c = 0; c < sum.size(); ++c)
      sum[c] = Sum(sum[c], Times(source.emission[c] * scale, inward));
  }

  const Scene& scene_;
  Emission emission_;
  const Receiver& receiver_;
  VisibleContour contour_;
  Vector3 normal_;
};

}  // namespace

std::optional<FixedVisibility> FixedVisibilityOf(
    const Oracle& oracle, std::span<const Receiver> receivers) {
  const Scene& scene = oracle.scene();
  for (const int emitter : EmittersOf(scene)) {
    if (!IsPlanar(scene, scene.faces()[static_cast<std::size_t>(emitter)]))
      return std::nullopt;
  }
  FixedVisibility fixed;
  for (const Receiver& receiver : receivers) {
    const ArcSum sum(oracle, receiver);
    fixed.at_source_depth.push_back(sum.AtSourceDepth());
    fixed.own_edges_only.push_back(sum.OwnEdgesOnly());
  }
  return fixed;
}

}  // namespace truelux
