// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/arc_gradients.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "base/vector_math.h"
#include "explain/arc_integral.h"
#include "inspect/view_measure.h"
#include "scene/facet_normal.h"

namespace truelux {
namespace {

constexpr double kPi = std::numbers::pi;

class ArcSummer {
 public:
  ArcSummer(const Scene& scene, const Receiver& receiver, Emission emission,
            const WholeView& view)
      : scene_(scene),
        receiver_(receiver),
        emission_(emission),
        view_(view),
        normal_(UnitOf(receiver.normal)) {}

  [[nodiscard]] ArcGradient Of(const WholeViewArc& arc) const {
    ArcGradient gradient;
    if (arc.kind == ViewArcKind::kHorizon) return gradient;
    const Rgb left = ExitanceOf(arc.left);
    const Rgb right = ExitanceOf(arc.right);
    if (left == right) return gradient;
    const Vector3 to_left = UnitOf(arc.plane_normal);
    const Vector3 first = DirectionOf(arc.from);
    const Vector3 last = DirectionOf(arc.to);
    const Vector3 inverse = InverseDistanceOf(arc, to_left);
    const Vector3 k =
        InverseDistances(first, last, Dot(inverse, first), Dot(inverse, last),
                         AngleOfArc(view_, arc));
    const Vector3 unit = Times(Dot(normal_, k) / kPi, to_left);
    for (std::size_t channel = 0; channel < 3; ++channel)
      gradient.vector[channel] = Times(left[channel] - right[channel], unit);
    return gradient;
  }

 private:
  /// What a region sends to the receiver [W/m^2].
  [[nodiscard]] Rgb ExitanceOf(int region) const {
    if (region < 0) return {};
    const ViewRegion& r = view_.regions[static_cast<std::size_t>(region)];
    if (r.face == 0 || !r.front) return {};
    Rgb exitance =
        scene_.faces()[static_cast<std::size_t>(r.face - 1)].emission;
    if (emission_ == Emission::kRadiance) {
      for (double& m : exitance)
        m *= kPi;
    }
    return exitance;
  }

  [[nodiscard]] Vector3 DirectionOf(int vertex) const {
    return UnitOf(
        view_.vertices[static_cast<std::size_t>(vertex)].vertex.direction);
  }

  /// G with 1 / rho = G . w for the directions w of an arc. normal: of its
  /// plane, of length 1.
  [[nodiscard]] Vector3 InverseDistanceOf(const WholeViewArc& arc,
                                          const Vector3& normal) const {
    if (arc.edge.a < 0) return InverseDistanceOfMeeting(arc.edge, normal);
    const Point3& a = scene_.vertices()[static_cast<std::size_t>(arc.edge.a)];
    const Point3& b = scene_.vertices()[static_cast<std::size_t>(arc.edge.b)];
    const Vector3 line = UnitOf(FromTo(a, b));
    const Vector3 to_a = FromTo(receiver_.position, a);
    const Vector3 to_b = FromTo(receiver_.position, b);
    const Vector3& near = LengthOf(to_a) < LengthOf(to_b) ? to_a : to_b;
    // N = near x line is this times the normal, and G = (line x N) / N^2.
    const double moment = Dot(Cross(near, line), normal);
    return Times(1 / moment, Cross(line, normal));
  }

  [[nodiscard]] std::span<const Facet> FacetsOf(int face) const {
    const Face& f = scene_.faces()[static_cast<std::size_t>(face - 1)];
    return scene_.facets().subspan(static_cast<std::size_t>(f.first_facet),
                                   static_cast<std::size_t>(f.facet_count));
  }

  /// A facet's plane as seen from the receiver: 1 / rho = inverse . w.
  [[nodiscard]] Vector3 InverseDistanceOf(const Facet& facet) const {
    const auto triangle = static_cast<std::size_t>(facet.first_triangle);
    const Vector3 n =
        UnitOf(FacetNormal(scene_, scene_.triangles()[triangle].facet));
    const auto corner =
        static_cast<std::size_t>(scene_.triangles()[triangle].vertices[0]);
    const double height =
        Dot(n, FromTo(receiver_.position, scene_.vertices()[corner]));
    return Times(1 / height, n);
  }

  /// Of the facets of both faces, those whose line lies in the arc's plane: a
  /// face that is not planar has several.
  [[nodiscard]] Vector3 InverseDistanceOfMeeting(const SeenEdge& edge,
                                                 const Vector3& normal) const {
    Vector3 best;
    double least = 2;
    for (const Facet& facet : FacetsOf(edge.face)) {
      const Vector3 inverse = InverseDistanceOf(facet);
      for (const Facet& other : FacetsOf(edge.other_face)) {
        // Where both planes are equally far.
        const Vector3 plane = Difference(inverse, InverseDistanceOf(other));
        const double off = LengthOf(Cross(UnitOf(plane), normal));
        if (off < least) {
          least = off;
          best = inverse;
        }
      }
    }
    return best;
  }

  const Scene& scene_;
  const Receiver& receiver_;
  Emission emission_;
  const WholeView& view_;
  Vector3 normal_;
};

/// The arcs' vectors are there: sets their shares, if these add up.
void FindShares(const Derivatives& derivatives, std::size_t channel,
                ArcGradients& gradients) {
  const Vector3& g = derivatives.channels[channel].gradient;
  const double length = LengthOf(g);
  if (length == 0) {
    gradients.shares[channel] = GradientShares::kNoGradient;
    return;
  }
  const Vector3 ahead = UnitOf(g);
  Vector3 missing = g;
  for (ArcGradient& arc : gradients.arcs) {
    arc.share[channel] = Dot(arc.vector[channel], ahead) / length;
    missing = Difference(missing, arc.vector[channel]);
  }
  const bool adds_up = LengthOf(missing) <= kShareError * length;
  gradients.shares[channel] =
      adds_up ? GradientShares::kGiven : GradientShares::kDoNotAddUp;
}

}  // namespace

double ArcGradients::LengthOf(std::size_t arc, std::size_t channel) const {
  return truelux::LengthOf(arcs[arc].vector[channel]);
}

ArcGradients ArcGradientsOf(const Scene& scene, const Receiver& receiver,
                            Emission emission, const WholeView& view,
                            const Derivatives& derivatives) {
  ArcGradients gradients;
  if (derivatives.smoothness != Smoothness::kC1) {
    gradients.shares.fill(derivatives.smoothness == Smoothness::kKink
                              ? GradientShares::kKink
                              : GradientShares::kDiscontinuous);
    return gradients;
  }
  const ArcSummer summer(scene, receiver, emission, view);
  for (const WholeViewArc& arc : view.arcs)
    gradients.arcs.push_back(summer.Of(arc));
  for (std::size_t channel = 0; channel < 3; ++channel)
    FindShares(derivatives, channel, gradients);
  return gradients;
}

}  // namespace truelux
