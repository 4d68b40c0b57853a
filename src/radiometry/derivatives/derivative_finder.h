// SPDX-License-Identifier: GPL-3.0-or-later
// All components of derivatives at one receiver, certified or in double.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_DERIVATIVE_FINDER_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_DERIVATIVE_FINDER_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "truelux/derivatives.h"

#include "radiometry/derivatives/arb_field.h"
#include "radiometry/derivatives/certify.h"
#include "radiometry/derivatives/exact_form.h"
#include "radiometry/derivatives/limits.h"
#include "radiometry/derivatives/moving_contour.h"
#include "radiometry/evaluation_query.h"
#include "radiometry/evaluation_workspace.h"
#include "visibility/contour.h"

namespace truelux {

/// What the fields over one region come from, the hemisphere or the sphere.
struct FieldRegion {
  ReceiverView view;
  Contour contour;
  std::vector<Rgb> weights;              ///< per source
  std::optional<JacobianLimits> limits;  ///< if there may be kinks
  // Made when first needed.
  mutable std::optional<MovingContour> moving;
  mutable std::vector<RationalArc> rational;

  [[nodiscard]] bool IsLit(std::size_t channel) const {
    return std::ranges::any_of(
        weights, [channel](const Rgb& w) { return w[channel] > 0; });
  }

  [[nodiscard]] const MovingContour& Moving() const {
    if (!moving) moving = MovingContourOf(view, contour);
    return *moving;
  }

  [[nodiscard]] const std::vector<RationalArc>& Rational() const {
    if (rational.empty()) {
      for (const MovingArc& arc : Moving().arcs)
        rational.emplace_back(arc);
    }
    return rational;
  }
};

/// Where the components are asked for.
struct FinderQuery {
  const FieldRegion& hemisphere;
  const FieldRegion& sphere;  ///< without sources if it is not asked for
  Vec3<Exact> normal;         ///< n
  Vec3<Exact> surface;        ///< a normal of the face that r lies on
  Method method = Method::kCertified;
  Emission emission = Emission::kExitance;
};

/// The components, channel after channel, kComponentCount each.
struct FoundComponents {
  CertifiedNumbers numbers;
  /// E of the channels where n.V / |n| told the binary64 nearest to it on the
  /// way; with kCertified and without limits only.
  std::array<std::optional<double>, 3> irradiance{};
};

/// With kCertified the nearest binary64, with kDouble sums in double with their
/// bounds where these are finite.
FoundComponents FindComponents(const FinderQuery& query,
                               const DerivativeOptions& options,
                               EvaluationWorkspace& workspace);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_DERIVATIVE_FINDER_H_
