// Errors and notes for the user, on standard error, one line each.

#ifndef TRUELUX_CLI_MESSAGES_H_
#define TRUELUX_CLI_MESSAGES_H_

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/diagnostics.h"

namespace truelux {

/// Ends the command with exit status 2: something that the user can mend.
class UserError : public std::runtime_error {
 public:
  /// diagnostics: at least one.
  explicit UserError(std::vector<Diagnostic> diagnostics);
  explicit UserError(const std::string& message);

  /// "file: error: what: the system's reason for error_number".
  UserError(const std::string& file, const std::string& what, int error_number);

  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const {
    return diagnostics_;
  }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// A command line that says nothing that could be done.
class UsageError : public UserError {
 public:
  using UserError::UserError;
};

/// Prints a line on standard error. Failures are ignored: there is no place
/// left to report them.
void PrintLine(std::string_view line);

/// Prints each diagnostic on a line of its own.
void Print(const std::vector<Diagnostic>& diagnostics);

/// Prints "note: message".
void PrintNote(const std::string& message);

/// Writes a text to standard output. Throws UserError if that fails.
void WriteStandardOutput(std::string_view text);

}  // namespace truelux

#endif  // TRUELUX_CLI_MESSAGES_H_
