// SPDX-License-Identifier: GPL-3.0-or-later
// How a contour is to be evaluated.

#ifndef TRUELUX_RADIOMETRY_EVALUATION_QUERY_H_
#define TRUELUX_RADIOMETRY_EVALUATION_QUERY_H_

#include "truelux/irradiance.h"

namespace truelux {

/// How a contour is evaluated.
struct EvaluationQuery {
  Method method = Method::kCertified;
  Emission emission = Emission::kExitance;
  Formula formula = Formula::kAuto;
  double half_side = 0x1p20;  ///< as OracleOptions::half_side
};

/// Whether a certified sum goes over the vertices of the contour; else it goes
/// over the arcs.
inline bool SumsOverVertices(Formula formula) {
  return formula == Formula::kHomogeneous || formula == Formula::kUnified;
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_EVALUATION_QUERY_H_
