// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a formula that is not closed.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_PARTIAL_SUM_H_
#define TRUELUX_RADIOMETRY_FORMULAS_PARTIAL_SUM_H_

namespace truelux {

/// A form factor [1] and what it leaves out.
template <class T>
struct PartialSum {
  T value{};
  /// Bound on what the formula itself leaves out, exact arithmetic or not [1];
  /// 0 for a closed form. A Ball's bound does not hold it.
  double truncation = 0;
  bool applicable = true;  ///< else nothing else here means anything
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_PARTIAL_SUM_H_
