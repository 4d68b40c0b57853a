// SPDX-License-Identifier: GPL-3.0-or-later
// The unoccluded regimes: loops above a receiver, each family with one
// difficulty.

#ifndef TRUELUX_BASELINES_REGIME_LOOPS_H_
#define TRUELUX_BASELINES_REGIME_LOOPS_H_

#include <vector>

#include "truelux/geometry.h"

#include "baselines/case_random.h"
#include "baselines/regime.h"

namespace truelux {

/// Counter-clockwise seen from the origin, z > 0.
using Loop = std::vector<Point3>;

/// Angular diameter up to `size` [rad], anywhere from 0.2 rad up, tilted.
Loop LoopOfSize(CaseRandom& random, double size);

/// At that elevation [rad] above the horizon, angular diameter up to 0.6 of it.
Loop LowLoop(CaseRandom& random, double elevation);

/// At that elevation [rad] to its triple, up to 1.2 rad wide.
Loop WideLowLoop(CaseRandom& random, double elevation);

/// The `count` lowest points are 1e-12 to 3e-12 rad above the horizon, the
/// others at 0.15 to 0.95 rad.
Loop LoopDownToTheHorizon(CaseRandom& random, int count);

/// Up to that angular length and width [rad], anywhere from 0.4 rad up.
Loop SliverLoop(CaseRandom& random, double length, double width);

/// In a plane that passes the receiver at that distance, 1.5 to 3 away.
Loop LoopSeenFlat(CaseRandom& random, double distance);

/// In a plane parallel to the receiver's, `height` times the loop's size above
/// it: around the zenith, or 1.5 to 3 sizes beside it.
Loop LoopInFloor(CaseRandom& random, double height, bool around_zenith);

/// A quadrilateral in a plane parallel to the receiver's with two sides along
/// y, each off by at most `slope` over its length.
Loop LoopWithVerticalEdges(CaseRandom& random, double slope);

/// A triangle in a plane parallel to the receiver's, one side of which passes
/// the zenith at that angle [rad].
Loop LoopBesideTheAxis(CaseRandom& random, double distance);

/// A receiver with a generic normal, up to `offset` + 1 from the origin in each
/// coordinate, and a loop of that angular size high above its horizon.
RegimeCase FarCase(CaseRandom& random, double offset, double size);

}  // namespace truelux

#endif  // TRUELUX_BASELINES_REGIME_LOOPS_H_
