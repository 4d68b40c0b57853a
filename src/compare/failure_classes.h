// SPDX-License-Identifier: GPL-3.0-or-later
// At which kinds of receivers a candidate fails.

#ifndef TRUELUX_COMPARE_FAILURE_CLASSES_H_
#define TRUELUX_COMPARE_FAILURE_CLASSES_H_

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "explain/receiver_reason.h"

namespace truelux {

/// A receiver that was looked at.
struct ClassifiedReceiver {
  ReceiverTraits traits;
  bool passes = false;
};

/// How many receivers of a kind there are among those looked at.
struct FailureClass {
  std::string_view name;
  std::size_t receivers = 0;
  std::size_t failing = 0;
};

/// Unlit, umbra, fully lit, penumbra: every receiver is one of these; then
/// those with a conjunction and those near the horizon (grazing, see
/// receiver_reason.h), which are among them. Empty ones are left out.
[[nodiscard]] std::vector<FailureClass> FailureClasses(
    std::span<const ClassifiedReceiver> receivers);

/// Where it fails, in one sentence: everywhere, only in one class, or as it
/// comes. At least one receiver fails.
[[nodiscard]] std::string WhereItFails(
    std::span<const ClassifiedReceiver> receivers);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_FAILURE_CLASSES_H_
