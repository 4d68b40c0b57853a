// SPDX-License-Identifier: GPL-3.0-or-later
// Collects what is wrong with one file, within bounds.

#ifndef TRUELUX_SCENE_DIAGNOSTIC_LIST_H_
#define TRUELUX_SCENE_DIAGNOSTIC_LIST_H_

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/diagnostics.h"

namespace truelux {

/// The first diagnostics of a file in the order of lines, whatever the order
/// in which they are found; at most kLimit errors and kLimit notes.
class DiagnosticList {
 public:
  static constexpr std::size_t kLimit = 100;

  explicit DiagnosticList(std::string file);

  void Error(int line, std::string message);
  void Note(int line, std::string message);
  void Add(Diagnostic diagnostic);

  /// One error, or one note, for all lines that the same text is told of: it
  /// stands at the first of them and counts the others. For a few texts only.
  void CountError(int line, std::string_view what);
  void CountNote(int line, std::string_view what);

  [[nodiscard]] const std::string& file() const { return file_; }

  [[nodiscard]] bool has_errors() const;

  /// By line; a last line tells how many more there are.
  [[nodiscard]] std::vector<Diagnostic> Sorted() const;

 private:
  struct Kept {
    std::vector<Diagnostic> first;
    std::size_t total = 0;
  };

  /// What many lines have in common.
  struct Counted {
    Diagnostic first;
    std::size_t count = 0;
  };

  static void Keep(Kept& kept, Diagnostic diagnostic);
  void Count(Severity severity, int line, std::string_view what);

  std::string file_;
  Kept errors_;
  Kept notes_;
  std::vector<Counted> counted_;
};

/// The first ten of some names, and how many more there are: "a, b and 3 more".
/// name(i): the i-th of them.
std::string FirstTen(std::size_t count,
                     const std::function<std::string(std::size_t)>& name);

}  // namespace truelux

#endif  // TRUELUX_SCENE_DIAGNOSTIC_LIST_H_
