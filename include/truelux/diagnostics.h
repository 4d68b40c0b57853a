// What is wrong with an input, and a result that may carry it.

#ifndef TRUELUX_DIAGNOSTICS_H_
#define TRUELUX_DIAGNOSTICS_H_

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace truelux {

/// An error makes the input unusable; a note tells what was ignored.
enum class Severity { kError, kNote };

/// One defect or remark about an input.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string file;     ///< as the user named it; empty: no file
  int line = 0;         ///< 1-based; 0: the file as a whole
  std::string message;  ///< what, and what was expected

  /// "file:line: error: message", without the parts that are missing.
  [[nodiscard]] std::string Text() const;
};

/// A value, or the reasons why there is none. Notes may stand beside a value.
template <class T>
struct Result {
  std::optional<T> value;
  std::vector<Diagnostic> diagnostics;

  [[nodiscard]] bool ok() const { return value.has_value(); }
};

}  // namespace truelux

#endif  // TRUELUX_DIAGNOSTICS_H_
