// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle mesh of a flat surface whose edges follow the light: outline, lines
// at which irradiance or its gradient jumps, and contours. In the library
// truelux_tools.
//
// Source: Arvo, The Irradiance Jacobian for Partially Occluded Polyhedral
// Sources, 1994, section 5 (isolux contours and meshes); docs/isolux.md tells
// what is proven and what is measured.

#ifndef TRUELUX_ISOMESH_H_
#define TRUELUX_ISOMESH_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/export.h"
#include "truelux/geometry.h"
#include "truelux/irradiance.h"
#include "truelux/isolux.h"

namespace truelux {

/// What a side of a triangle lies on. A contour's chord may end within a kink.
enum class MeshSide : unsigned char {
  kInside,   ///< "inside": nothing
  kContour,  ///< "contour": the chord of a contour
  kKink,     ///< "kink": the gradient jumps there
  kJump,     ///< "jump": a face stands there; each side has its own vertices
  kOutline,  ///< "outline"
};

/// The word in quotes above.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(MeshSide side);

/// A vertex. Where E jumps there are several in one place.
struct IsoMeshVertex {
  Point3 at;
  /// E [W/m^2], certified as Oracle::Evaluate has it. At an outline or a jump
  /// the receiver is 2^-36 of the surface's size beside it (at least 2^-48 of
  /// the coordinates), in the triangles that have the vertex. At the end of a
  /// jump E depends on the direction: if it differs by more than the error that
  /// was asked for, each triangle has its own vertex, with E at 16 times that
  /// distance into the triangle.
  Rgb irradiance{};
  double value = 0;  ///< what contours are of [W/m^2]
};

/// A triangle, counter-clockwise as seen from the lit side.
struct IsoMeshTriangle {
  std::array<int, 3> vertices{};
  /// Of the side from vertex k + 1 to vertex k + 2, which is opposite to vertex
  /// k.
  std::array<MeshSide, 3> sides{};
  int face = 0;  ///< as IsoluxContour::face
};

/// How far values that are interpolated between vertices are from the truth
/// [W/m^2], measured and not proven.
struct InterpolationError {
  /// In 10,000 points of the area and the middles of all triangles. The larger of
  /// the two sides, if faces look to both, as the others.
  double most = 0;
  double at_99 = 0;  ///< 99 % of the points have less
  double mean = 0;   ///< over the points
};

/// What is asked for.
struct IsoMeshOptions {
  /// Of contours, with levels, channel, threads and the hook.
  IsoluxOptions contours{};
  /// Triangles are divided until the error is not above this at three points in
  /// each [W/m^2]; 0: 1/100 of the difference of the largest and the least value
  /// that were met.
  double error = 0;
  /// Triangles whose longest side is not longer are not divided [length]; 0:
  /// 2^-12 of the size.
  double smallest = 0;
  /// Nor is any if there are so many vertices, before they are doubled at jumps;
  /// 0: 300,000.
  std::size_t most_vertices = 0;
};

/// A mesh, and the contours that are in it.
struct IsoMesh {
  Isolux isolux;
  std::vector<IsoMeshVertex> vertices;
  std::vector<IsoMeshTriangle> triangles;
  double error = 0;  ///< that was asked for [W/m^2]
  /// Triangles that are above it: too small to be divided, or there were too
  /// many.
  std::size_t unfinished = 0;
  InterpolationError interpolation;
  /// Of a Delaunay mesh of the outline alone with triangles of one size and as
  /// many vertices, for comparison.
  InterpolationError uniform;
  std::size_t uniform_vertices = 0;
  double least_angle = 0;  ///< in any triangle [degrees]
  /// Contour vertices nearer than 2^-16 of the size to a corner of lines are
  /// drawn to it: all contours run into the feet of vertical edges.
  int drawn = 0;
  double most_drawn = 0;          ///< the longest way of one [length]
  std::uint64_t evaluations = 0;  ///< for the mesh, without its contours
};

/// The mesh of a flat surface. By `oracle`, as IsoluxOf. The result does not
/// depend on threads. Throws as IsoluxOf does.
[[nodiscard]] TRUELUX_EXPORT IsoMesh IsoMeshOf(const Oracle& oracle,
                                               const std::string& surface,
                                               const IsoMeshOptions& options);

}  // namespace truelux

#endif  // TRUELUX_ISOMESH_H_
