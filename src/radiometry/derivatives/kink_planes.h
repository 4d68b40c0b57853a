// SPDX-License-Identifier: GPL-3.0-or-later
// The planes across which the derivatives of irradiance may jump at a receiver.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_KINK_PLANES_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_KINK_PLANES_H_

#include <array>
#include <vector>

#include "exact/number.h"
#include "exact/vec3.h"
#include "radiometry/derivatives/coincident_lines.h"
#include "visibility/contour.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {

/// A plane through r that may be one.
struct KinkPlane {
  Vec3<Exact> normal;  ///< its first component that is not 0 is positive
  /// The receiver plane: E has no kink there, since all in it has weight 0, but
  /// V over the hemisphere may have one.
  bool is_level = false;
  /// Only edges in the receiver plane make it one: no kink over the whole
  /// sphere.
  bool is_horizon_only = true;
  std::vector<FaceNumber> faces;  ///< faces that lie in it, ascending
  /// Two edges in it that overlap as seen from r, if that is why.
  std::array<std::array<VertexId, 2>, 2> edges;
};

/// What is special about where a receiver is.
struct KinkCandidates {
  std::vector<KinkPlane> planes;
  /// A face that the receiver lies on, and that its on_face does not leave out.
  FaceNumber touched;
  bool touched_is_level = false;  ///< its plane is the receiver plane
};

/// Every plane through r that holds a face, or edges (or the lines where faces
/// pierce the plane of a source) of two different space lines that overlap as
/// seen from r over a positive angle: derivatives by r can jump across no other
/// plane [docs/derivatives.md, "Kinks"]. Those that hold such edges may be no
/// kinks: whether they are is what limits beside them say. Edges that hide
/// each other count: what is covered now may be seen after any step.
/// seen: of the same query.
KinkCandidates FindKinkPlanes(const ContourEngine& engine,
                              const ContourQuery& query, const SeenLines& seen);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_KINK_PLANES_H_
