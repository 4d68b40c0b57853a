// SPDX-License-Identifier: GPL-3.0-or-later
// The occluded regimes: a triangular source behind black triangles whose
// edges, as seen from the receiver, nearly meet, or that are thin, or that
// leave a tiny hole.

#ifndef TRUELUX_BASELINES_REGIME_SHADOWS_H_
#define TRUELUX_BASELINES_REGIME_SHADOWS_H_

#include "baselines/case_random.h"
#include "baselines/regime.h"

namespace truelux {

// In all of them the receiver is at the origin with the normal (0, 0, 1), face
// 1 is the source, a triangle of about 0.8 rad at 0.5 to 5, and the other faces
// are black and nearer. Angles are measured on a plane across the line of sight
// to the source's middle; on the sphere they are up to a third smaller.

/// Three blockers. The first edges (from corner 1 to corner 2) of faces 2 and 3
/// cross, as seen from the receiver, in a point inside the source; that of face
/// 4 passes it at `miss` [rad].
RegimeCase NearConjunction(CaseRandom& random, double miss);

/// Two blockers. Corner 1 of face 2 is `miss` [rad] away from the first edge of
/// the source (an even draw) or of face 3, on either side of it.
RegimeCase VertexNearEdge(CaseRandom& random, double miss);

/// One blocker, whose first edge is parallel to the source's first edge,
/// `miss` [rad] inside or outside; it hides a part of the source behind that
/// edge.
RegimeCase NearlyEqualEdges(CaseRandom& random, double miss);

/// One blocker, which hides all but a strip of that width [rad] along the
/// source's first edge.
RegimeCase Slit(CaseRandom& random, double width);

/// Three crossing blockers about 1.5 rad long, of that width [rad] at one end
/// and pointed at the other.
RegimeCase ThinBlockers(CaseRandom& random, double width);

/// Three blockers, which hide all but a triangle whose sides are 0.3 to 0.6
/// times `size` [rad] from a point inside the source.
RegimeCase Pinhole(CaseRandom& random, double size);

}  // namespace truelux

#endif  // TRUELUX_BASELINES_REGIME_SHADOWS_H_
