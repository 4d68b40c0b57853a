// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/arc_gradients.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "inspect/projection.h"
#include "inspect/view_measure.h"
#include "scene/facet_normal.h"

namespace truelux {
namespace {

constexpr double kPi = std::numbers::pi;

double Dot3(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector3 Cross3(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vector3 Sum(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

Vector3 Times(double s, const Vector3& a) {
  return {s * a.x, s * a.y, s * a.z};
}

double LengthOfVector(const Vector3& a) {
  return std::hypot(a.x, a.y, a.z);
}

Vector3 From(const Point3& a, const Point3& b) {
  return {b.x - a.x, b.y - a.y, b.z - a.z};
}

/// The integral of w / rho over an arc, docs/derivatives.md (6). first, last:
/// its ends; q1, q2: 1 / rho there; angle: in [0, pi).
Vector3 InverseDistances(const Vector3& first, const Vector3& last, double q1,
                         double q2, double angle) {
  const double sine = std::sin(angle);
  const double wide = 1 + std::cos(angle);
  const double a = (angle + sine) / (4 * wide);
  // (angle - sine) has no digits left on short arcs; the next term of the
  // series is angle^2 / 30 times this one.
  constexpr double kShort = 1e-4;
  const double b =
      angle < kShort ? angle / 12 : (angle - sine) * wide / (4 * sine * sine);
  return Sum(Times(a * (q1 + q2), Sum(first, last)),
             Times(b * (q2 - q1), Sum(last, Times(-1, first))));
}

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
        InverseDistances(first, last, Dot3(inverse, first), Dot3(inverse, last),
                         AngleOfArc(view_, arc));
    const Vector3 unit = Times(Dot3(normal_, k) / kPi, to_left);
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
    const Vector3 line = UnitOf(From(a, b));
    const Vector3 to_a = From(receiver_.position, a);
    const Vector3 to_b = From(receiver_.position, b);
    const Vector3& near =
        LengthOfVector(to_a) < LengthOfVector(to_b) ? to_a : to_b;
    // N = near x line is this times the normal, and G = (line x N) / N^2.
    const double moment = Dot3(Cross3(near, line), normal);
    return Times(1 / moment, Cross3(line, normal));
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
        Dot3(n, From(receiver_.position, scene_.vertices()[corner]));
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
        const Vector3 plane = Sum(inverse, Times(-1, InverseDistanceOf(other)));
        const double off = LengthOfVector(Cross3(UnitOf(plane), normal));
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
  const double length = LengthOfVector(g);
  if (length == 0) {
    gradients.shares[channel] = GradientShares::kNoGradient;
    return;
  }
  const Vector3 ahead = UnitOf(g);
  Vector3 missing = g;
  for (ArcGradient& arc : gradients.arcs) {
    arc.share[channel] = Dot3(arc.vector[channel], ahead) / length;
    missing = Sum(missing, Times(-1, arc.vector[channel]));
  }
  const bool adds_up = LengthOfVector(missing) <= kShareError * length;
  gradients.shares[channel] =
      adds_up ? GradientShares::kGiven : GradientShares::kDoNotAddUp;
}

}  // namespace

double ArcGradients::LengthOf(std::size_t arc, std::size_t channel) const {
  return LengthOfVector(arcs[arc].vector[channel]);
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
