// SPDX-License-Identifier: GPL-3.0-or-later
// Long calls without the interpreter's lock, over threads, that Ctrl-C ends.

#ifndef TRUELUX_BINDINGS_PYTHON_INTERRUPTIBLE_H_
#define TRUELUX_BINDINGS_PYTHON_INTERRUPTIBLE_H_

#include <cstddef>
#include <functional>
#include <pybind11/pybind11.h>

#include "truelux/stop.h"

namespace truelux::python {

/// Receivers are handed to the library in blocks: near ones share work there,
/// and a block is what a thread takes at a time. At most so many, and fewer if
/// there are not enough for some blocks a thread.
inline constexpr std::size_t kLargestBlock = 64;
inline constexpr std::size_t kSmallestBlock = 4;

/// While it lives, the interpreter's lock is free, and SIGINT sets flag() and
/// goes on to the handler that was there. Only in the main thread, where Python
/// looks at signals; elsewhere the flag stays false. One within another, as a
/// bar makes them that calls truelux, has the flag of the outer one. Throws
/// nothing. A thread whose interpreter has ended stays in the destructor.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /// For OracleOptions::stop and ReadOptions::stop.
  [[nodiscard]] const StopFlag* flag() const { return flag_; }

 private:
  void Catch();

  StopFlag own_ = false;
  const StopFlag* flag_ = &own_;
  bool handles_ = false;
  PyThreadState* thread_;  ///< whose lock is free
};

/// Where the interpreter has ended, asking for its lock unwinds the thread's
/// stack, which must not go past destructors that throw nothing, nor run those
/// of Python's objects. Instead the thread stays here until the process ends.
[[noreturn]] void StayForEver();

/// work(first, count) for blocks of at most kLargestBlock that make up [0, count), on
/// any threads, at most `threads`; 0: as many as there are cores. In the
/// calling thread if there is one block. Ends with what work throws.
void ForBlocks(std::size_t count, int threads,
               const std::function<void(std::size_t, std::size_t)>& work);

}  // namespace truelux::python

#endif  // TRUELUX_BINDINGS_PYTHON_INTERRUPTIBLE_H_
