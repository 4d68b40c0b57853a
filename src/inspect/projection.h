// SPDX-License-Identifier: GPL-3.0-or-later
// Directions of a receiver's hemisphere as points of a round picture.

#ifndef TRUELUX_INSPECT_PROJECTION_H_
#define TRUELUX_INSPECT_PROJECTION_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/geometry.h"

namespace truelux {

enum class ViewProjection {
  /// "nusselt": unit directions, projected orthogonally onto the receiver's
  /// plane. The area of a source by that of the disc is its form factor.
  kNusselt,
  /// "gnomonic": the image plane of a pinhole camera, on which edges are
  /// straight; cut at kGnomonicLimit.
  kGnomonic,
};

/// The angle from the normal at which the gnomonic picture ends [degrees].
inline constexpr double kGnomonicLimit = 80;

/// The name on the command line.
[[nodiscard]] std::string_view Name(ViewProjection projection);

/// A point of a picture [px], y downwards.
struct PicturePoint {
  double x = 0;
  double y = 0;
};

/// An orthonormal frame, as somebody at the receiver who looks along its normal
/// sees it.
struct ViewFrame {
  Vector3 right;
  Vector3 up;     ///< of the scene's y, z, x axes the first that is not within
                  ///< some 25 degrees of the normal, made orthogonal to it
  Vector3 ahead;  ///< the normal
};

[[nodiscard]] ViewFrame FrameOf(const Vector3& normal);

/// An arc of a great circle in the frame: start cos t + side sin t for t from
/// 0 to angle, both of length 1 and orthogonal.
struct CircleArc {
  Vector3 start;
  Vector3 side;
  double angle = 0;  ///< [rad]

  [[nodiscard]] Vector3 At(double t) const;
};

/// Draws on a disc. Vectors here have the components right, up, ahead.
class ProjectedDisc {
 public:
  ProjectedDisc(ViewProjection kind, PicturePoint centre, double radius)
      : kind_(kind), centre_(centre), radius_(radius) {}

  /// Nothing if it lies outside the disc. direction: a unit vector.
  [[nodiscard]] std::optional<PicturePoint> PointOf(
      const Vector3& direction) const;

  /// The radius of the circle `degrees` from the normal [px].
  [[nodiscard]] double RadiusAt(double degrees) const;

  /// SVG path data of an arc, within a hundredth of a pixel; "" if none of it
  /// is in the disc.
  [[nodiscard]] std::string ArcPath(const CircleArc& arc) const;

  /// The same of a closed border, arcs one after the other. Where it leaves
  /// the gnomonic disc, it goes around outside of it: to be clipped.
  [[nodiscard]] std::string LoopPath(const std::vector<CircleArc>& arcs) const;

 private:
  [[nodiscard]] PicturePoint Place(const Vector3& v) const;
  void AppendCurve(const CircleArc& arc, std::string& path) const;

  ViewProjection kind_;
  PicturePoint centre_;
  double radius_;
};

}  // namespace truelux

#endif  // TRUELUX_INSPECT_PROJECTION_H_
