// SPDX-License-Identifier: GPL-3.0-or-later
// The closed forms of the irradiance, by name.

#ifndef TRUELUX_FORMULAS_H_
#define TRUELUX_FORMULAS_H_

#include <optional>
#include <span>
#include <string_view>

#include "truelux/export.h"

namespace truelux {

/// Which closed form is summed over the visible contour. All give the same E
/// in exact arithmetic; they differ in the digits that rounding costs
/// (docs/stability.md). S: Stark, Vertex-Based Formulations of Irradiance from
/// Polygonal Sources (2000), with the corrections listed in docs/method.md
/// section 8. v, v': the ends of an arc as directions from the receiver; N:
/// the normal of the arc's plane. The words in quotes are the names.
enum class Formula {
  /// "auto": lambert-edge with arcs of one plane taken together. Where that
  /// leaves a bound that is large beside the value, each source is summed by
  /// whichever of lambert-edge, difference, series and cubature has the
  /// smallest bound.
  kAuto,
  kLambertAcos,    ///< "lambert-acos": S (3), angles by acos, N = v x v'
  kLambertAtan2,   ///< "lambert-atan2": S (3), angles by atan2, N = v x v'
  kLambertEdge,    ///< "lambert-edge": as before, with N = v x (v' - v)
  kVertexLambert,  ///< "vertex-lambert": S (12), (13), angles with the edges
  kImagePlane,     ///< "image-plane": S (8) to (10), slopes of edges
  kDirections,     ///< "directions": S (44), (45), directions of edges
  kSphere,         ///< "sphere": S (27), (28), vertices on the unit sphere
  kProjective,     ///< "projective": S Figure 10, with points at infinity
  kHomogeneous,    ///< "homogeneous": S Figure 11
  kUnified,        ///< "unified": H(v, N), docs/method.md (11) and (12)
  kDifference,     ///< "difference": docs/method.md section 9
  kSeries,         ///< "series": docs/method.md section 9; applies to sources
                   ///< of small angular size only
  kCubature,       ///< "cubature": positive Gauss cubature, docs/method.md
                   ///< section 9
};

/// All formulas, in the order above, kAuto included.
[[nodiscard]] TRUELUX_EXPORT std::span<const Formula> AllFormulas();

/// The word in quotes above, as --formula takes it.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(Formula formula);

/// The formula of this name; nothing if no formula has it.
[[nodiscard]] TRUELUX_EXPORT std::optional<Formula> FormulaByName(
    std::string_view name);

/// The number types in which formulas can be compared.
enum class Arithmetic {
  kFloat,           ///< "float": binary32
  kDouble,          ///< "double": binary64
  kDoubleDouble,    ///< "double-double": about 106 bits
  kMultiprecision,  ///< "MPFR": any precision
};

/// The word in quotes above.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(Arithmetic arithmetic);

}  // namespace truelux

#endif  // TRUELUX_FORMULAS_H_
