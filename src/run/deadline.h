// SPDX-License-Identifier: GPL-3.0-or-later
// Asking a call of the library to end when its time is up.

#ifndef TRUELUX_RUN_DEADLINE_H_
#define TRUELUX_RUN_DEADLINE_H_

#include <condition_variable>
#include <mutex>
#include <thread>

#include "truelux/stop.h"

namespace truelux {

/// Sets a flag once some time has passed, unless the deadline is destroyed
/// before. Where the system refuses the thread that waits there is no deadline.
class Deadline {
 public:
  /// seconds: from now, of time that passes. flag: must outlive the deadline.
  Deadline(double seconds, StopFlag& flag);
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

 private:
  void Wait(double seconds, StopFlag& flag);

  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_over_ = false;  ///< guarded by mutex_
  std::thread thread_;
};

}  // namespace truelux

#endif  // TRUELUX_RUN_DEADLINE_H_
