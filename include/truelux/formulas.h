// The closed forms of the irradiance, by name.

#ifndef TRUELUX_FORMULAS_H_
#define TRUELUX_FORMULAS_H_

#include <optional>
#include <span>
#include <string_view>

namespace truelux {

/// What is summed over the visible contour. S: Stark, Vertex-Based Formulations
/// of Irradiance from Polygonal Sources (2000), with the corrections listed in
/// docs/method.md section 8; u = 2^-53. Names on the command line are those in
/// quotes.
enum class Formula {
  /// "auto": lambert-edge with arcs of one plane taken together; per source,
  /// where that leaves a bound that is large beside the value, whichever of
  /// difference, series and cubature has a smaller one.
  kAuto,
  kLambertAcos,    ///< "lambert-acos": S (3), angles by acos, N = v x v'
  kLambertAtan2,   ///< "lambert-atan2": S (3), angles by atan2, N = v x v'
  kLambertEdge,    ///< "lambert-edge": the same with N = v x (v' - v)
  kVertexLambert,  ///< "vertex-lambert": S (12), (13), angles with the edges
  kImagePlane,     ///< "image-plane": S (8) to (10), slopes of edges
  kDirections,     ///< "directions": S (44), (45), directions of edges
  kSphere,         ///< "sphere": S (27), (28), vertices on the unit sphere
  kProjective,     ///< "projective": S Figure 10, with points at infinity
  kHomogeneous,    ///< "homogeneous": S Figure 11
  kUnified,        ///< "unified": H(v, N), docs/method.md (11) and (12)
  kDifference,     ///< "difference": docs/method.md section 9
  kSeries,         ///< "series": for sources of small angular size, the same
  kCubature,       ///< "cubature": positive Gauss cubature, the same
};

/// All of them, in the order above.
[[nodiscard]] std::span<const Formula> AllFormulas();

/// The name on the command line.
[[nodiscard]] std::string_view Name(Formula formula);

/// Nothing if there is no formula of this name.
[[nodiscard]] std::optional<Formula> FormulaByName(std::string_view name);

/// The number types in which formulas can be compared.
enum class Arithmetic {
  kFloat,           ///< "float": binary32
  kDouble,          ///< "double": binary64
  kDoubleDouble,    ///< "double-double": about 106 bits
  kMultiprecision,  ///< "MPFR": any precision
};

/// The name in reports.
[[nodiscard]] std::string_view Name(Arithmetic arithmetic);

}  // namespace truelux

#endif  // TRUELUX_FORMULAS_H_
