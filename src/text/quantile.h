// SPDX-License-Identifier: GPL-3.0-or-later
// The middle, the upper end and the mean size of a set of numbers.

#ifndef TRUELUX_TEXT_QUANTILE_H_
#define TRUELUX_TEXT_QUANTILE_H_

#include <span>
#include <vector>

namespace truelux {

/// The middle one of an odd number of values, the mean of the middle two of an
/// even number. values: not empty, none not a number.
[[nodiscard]] double Median(std::vector<double> values);

/// The least value that a share of `share` of the values does not exceed.
/// values: not empty, none not a number; 0 < share <= 1.
[[nodiscard]] double Quantile(std::vector<double> values, double share);

/// The root of the mean square, also where the squares leave binary64.
/// values: not empty, none negative or not a number.
[[nodiscard]] double RootMeanSquare(std::span<const double> values);

}  // namespace truelux

#endif  // TRUELUX_TEXT_QUANTILE_H_
