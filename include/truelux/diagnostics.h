// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with an input, and a result that may carry it.

#ifndef TRUELUX_DIAGNOSTICS_H_
#define TRUELUX_DIAGNOSTICS_H_

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "truelux/export.h"

namespace truelux {

/// How bad a defect is.
enum class Severity {
  kError,  ///< "error": the input cannot be used
  kNote,   ///< "note": the input can be used; the message says how it was read
};

/// The word in quotes above.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(Severity severity);

/// One defect or remark about an input.
struct TRUELUX_EXPORT Diagnostic {
  Severity severity = Severity::kError;
  std::string file;     ///< as the user named it; empty: the input is no file
  int line = 0;         ///< counted from 1; 0: the file as a whole
  std::string message;  ///< what is wrong, and what was expected instead

  /// "file:line: error: message", without the parts that are missing.
  [[nodiscard]] std::string Text() const;
};

/// A value, or the reasons why there is no value. Notes may stand beside a
/// value; errors never do.
template <class T>
struct [[nodiscard]] Result {
  std::optional<T> value;  ///< nothing if the diagnostics hold an error
  /// All defects that were found, in the order of the input, not only the
  /// first one.
  std::vector<Diagnostic> diagnostics;

  /// Whether there is a value.
  [[nodiscard]] bool ok() const { return value.has_value(); }
};

}  // namespace truelux

#endif  // TRUELUX_DIAGNOSTICS_H_
