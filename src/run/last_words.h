// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to end the program from anywhere: where memory has run out, where an
// exception must not pass, and in a signal handler.

#ifndef TRUELUX_RUN_LAST_WORDS_H_
#define TRUELUX_RUN_LAST_WORDS_H_

#include <cstddef>

namespace truelux {

/// Files that must not outlive the program. A fixed table, because what reads
/// it at the end can neither allocate nor wait.
class TemporaryName {
 public:
  TemporaryName() = default;

  ~TemporaryName() { Forget(); }

  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

  /// Takes note of a path, before the file exists. False if there is no room
  /// for it: more than kMost files, or a path longer than kLongest.
  [[nodiscard]] bool Keep(const char* path);

  /// The file has another name now, or is gone.
  void Forget();

  static constexpr std::size_t kMost = 16;
  static constexpr std::size_t kLongest = 4096;

 private:
  int slot_ = -1;
};

/// Removes the temporary files, writes a line to standard error, and ends the
/// process. Async-signal-safe. line: ended by a line end.
[[noreturn]] void EndNow(const char* line, int exit_status);

/// From now on memory that cannot be had, for C++, GMP, MPFR and FLINT, and an
/// exception that nobody catches end the program by EndNow with the exit status
/// of an internal error. The number types of CGAL are damaged by a bad_alloc
/// that passes through them, so none is ever thrown. For programs: a library
/// must not set what is the whole process's.
void EndWhereNothingHelps();

}  // namespace truelux

#endif  // TRUELUX_RUN_LAST_WORDS_H_
