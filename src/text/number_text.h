// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people read them; results.h has those that read back exactly.

#ifndef TRUELUX_TEXT_NUMBER_TEXT_H_
#define TRUELUX_TEXT_NUMBER_TEXT_H_

#include <string>

namespace truelux {

/// With `digits` digits behind the first one and a bare exponent: "3e-5",
/// "1.2e-16", "3.5" (not "3.5e0"); "0" and "inf" for these.
std::string ScientificText(double value, int digits);

/// A time in a handy unit with about three digits: "740 ns", "14.8 µs".
std::string TimeText(double microseconds);

}  // namespace truelux

#endif  // TRUELUX_TEXT_NUMBER_TEXT_H_
