// SPDX-License-Identifier: GPL-3.0-or-later
// A contour followed as it is published: a multistep predictor along the contour
// and Newton's method along the gradient back to it. It proves nothing, and is
// here to be measured.
//
// Source: Arvo, The Irradiance Jacobian for Partially Occluded Polyhedral
// Sources, 1994, section 5, with Milne's predictor.

#ifndef TRUELUX_BENCH_PREDICTOR_TRACER_H_
#define TRUELUX_BENCH_PREDICTOR_TRACER_H_

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "isolux/light_probe.h"
#include "isolux/plan_frame.h"

namespace truelux::bench {

/// How the next point is guessed from the last ones. p: points, t: unit tangents
/// there, h: the step; k is the last point.
enum class Predictor {
  kMilne,    ///< "Milne": p(k-3) + 4h/3 (2 t(k) - t(k-1) + 2 t(k-2)), order 4
  kTwoStep,  ///< "two-step": p(k) + h/2 (3 t(k) - t(k-1)), order 2
};

/// The word in quotes above.
[[nodiscard]] std::string_view Name(Predictor predictor);

/// How many points the next one is guessed from.
[[nodiscard]] int HistoryOf(Predictor predictor);

/// Why a trace ends.
enum class TraceEnd {
  kClosed,      ///< "closed": it is back where it began
  kOutline,     ///< "outline": the next point is off the surface
  kNoGradient,  ///< "no gradient": there is none at a point, or it is 0
  kCorrector,   ///< "corrector": the next point was not found
  kTooLong,     ///< "too long": it has as many points as it may
};

/// The word in quotes above.
[[nodiscard]] std::string_view Name(TraceEnd end);

/// A straight piece of a line on a surface.
using PlanSegment = std::array<PlanPoint, 2>;

/// Whether two segments have a point in common, in double.
[[nodiscard]] bool DoSegmentsCross(const PlanSegment& a, const PlanSegment& b);

/// From this miss on [h] a predictor is taken to have met a kink.
inline constexpr double kLargeMiss = 0.1;

/// What a trace is to be.
struct TraceOptions {
  Predictor predictor = Predictor::kMilne;
  double level = 0;  ///< [W/m^2]
  double step = 0;   ///< h [length]; > 0
  /// Whether a large miss makes the predictor forget all points but the last one.
  bool is_restarting = false;
  double tolerance = 0;  ///< on |E - level| at every point [W/m^2]
  /// The sides of the surface's outline; a trace does not cross them.
  std::vector<PlanSegment> outline;
  std::size_t most_points = 0;
};

/// A point of a trace.
struct TracePoint {
  PlanPoint at;
  /// How far the predictor was from it, or from the contour if the corrector had
  /// nothing to do [length]; nothing for the start and for points found by the
  /// method of Runge and Kutta.
  std::optional<double> miss;
};

/// Points at distances of about h, the start first.
struct Trace {
  std::vector<TracePoint> points;
  TraceEnd end = TraceEnd::kTooLong;
};

/// Follows a contour from a point on it. As long as there are too few points
/// for the predictor, Runge and Kutta's method of order 4 takes its place. A
/// corrector has 6 steps, and fails where it goes farther than 2 h.
/// is_backward: with what is larger on the right, else on the left.
[[nodiscard]] Trace TraceContour(const LightProbe& probe,
                                 const PlanPoint& start, bool is_backward,
                                 const TraceOptions& options);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_PREDICTOR_TRACER_H_
