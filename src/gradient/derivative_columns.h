// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives as columns of a table.

#ifndef TRUELUX_GRADIENT_DERIVATIVE_COLUMNS_H_
#define TRUELUX_GRADIENT_DERIVATIVE_COLUMNS_H_

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/derivatives.h"

namespace truelux {

/// Groups of columns that can be asked for, in the order of the table.
enum class ColumnGroup {
  kGradient,    ///< "gradient": grad_r_x ..
  kTangential,  ///< "tangential": tgrad_r_x ..
  kNormal,      ///< "normal": dn_r_x ..
  kVector,      ///< "vector": V_r_x ..
  kJacobian,    ///< "jacobian": J_r_xx .. and Jsphere_r_xx ..
  kSphere,      ///< "sphere": L_r_x ..
  kFlux,        ///< "flux": flux_r
};

inline constexpr std::array kColumnGroups = {
    ColumnGroup::kGradient, ColumnGroup::kTangential, ColumnGroup::kNormal,
    ColumnGroup::kVector,   ColumnGroup::kJacobian,   ColumnGroup::kSphere,
    ColumnGroup::kFlux};

/// The word in quotes above.
[[nodiscard]] std::string_view Name(ColumnGroup group);

/// Which groups a table has.
class ColumnChoice {
 public:
  void Add(ColumnGroup group) { has_[Index(group)] = true; }

  [[nodiscard]] bool Has(ColumnGroup group) const { return has_[Index(group)]; }

  /// Whether some group is about the whole sphere.
  [[nodiscard]] bool HasSphere() const {
    return Has(ColumnGroup::kJacobian) || Has(ColumnGroup::kSphere) ||
           Has(ColumnGroup::kFlux);
  }

 private:
  static std::size_t Index(ColumnGroup group) {
    return static_cast<std::size_t>(group);
  }

  std::array<bool, kColumnGroups.size()> has_{};
};

/// The names of the columns after those of the receivers.
[[nodiscard]] std::vector<std::string> DerivativeNames(
    const ColumnChoice& columns, Method method);

/// The same, each with the separator before it: E, status, and the groups, channel by channel; with
/// Method::kDouble then a bound for each number, bound_E_r .. bound_grad_r_x ..
[[nodiscard]] std::string DerivativeHeader(const ColumnChoice& columns,
                                           Method method, char separator);

/// Appends one row's cells. Those of derivatives are empty where E is
/// discontinuous.
void AppendDerivatives(std::string& text, const Derivatives& derivatives,
                       const ColumnChoice& columns, Method method,
                       char separator);

}  // namespace truelux

#endif  // TRUELUX_GRADIENT_DERIVATIVE_COLUMNS_H_
