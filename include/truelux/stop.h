// SPDX-License-Identifier: GPL-3.0-or-later
// Ending a call of the library before it is done.

#ifndef TRUELUX_STOP_H_
#define TRUELUX_STOP_H_

#include <atomic>
#include <stdexcept>

#include "truelux/export.h"

namespace truelux {

/// A flag that asks calls to end when it is true. Any thread may set it, and so
/// may a signal handler. It must outlive the calls that look at it.
using StopFlag = std::atomic<bool>;

/// Thrown by a call that was asked to end. Nothing is lost but its result: the
/// objects may be used again once the flag is false.
class TRUELUX_EXPORT Stopped : public std::runtime_error {
 public:
  Stopped();
  ~Stopped() override;
  Stopped(const Stopped&) = default;
  Stopped& operator=(const Stopped&) = default;
};

}  // namespace truelux

#endif  // TRUELUX_STOP_H_
