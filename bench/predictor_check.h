// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the published tracer does what it is measured for.

#ifndef TRUELUX_BENCH_PREDICTOR_CHECK_H_
#define TRUELUX_BENCH_PREDICTOR_CHECK_H_

namespace truelux::bench {

/// Follows contours under a square lamp parallel to the floor, where E has a
/// closed form. Throws std::logic_error if one does not close, if E at one of its
/// points, by the closed form, is not the level within 1e-9 of the largest E on
/// the floor and some roundings, or if a predictor has not the order it should
/// have.
void CheckPredictorTracer();

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_PREDICTOR_CHECK_H_
