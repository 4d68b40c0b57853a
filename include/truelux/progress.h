// SPDX-License-Identifier: GPL-3.0-or-later
// Being told how far a long call is.

#ifndef TRUELUX_PROGRESS_H_
#define TRUELUX_PROGRESS_H_

#include <cstdint>
#include <functional>
#include <string_view>

namespace truelux {

/// How far one part of a call is. A call may have several parts, one after the
/// other.
struct ProgressState {
  std::uint64_t done = 0;
  std::uint64_t total = 0;
  std::string_view things;  ///< what is counted: "receivers", "pixels", ..
};

/// Called some ten times a second, by any of the threads that do the work but
/// never by two at once, and at the end of a part. It must not throw.
using ProgressHook = std::function<void(const ProgressState&)>;

}  // namespace truelux

#endif  // TRUELUX_PROGRESS_H_
