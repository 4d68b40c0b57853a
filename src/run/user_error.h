// SPDX-License-Identifier: GPL-3.0-or-later
// What ends a command because the user can mend something.

#ifndef TRUELUX_RUN_USER_ERROR_H_
#define TRUELUX_RUN_USER_ERROR_H_

#include <stdexcept>
#include <string>
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

}  // namespace truelux

#endif  // TRUELUX_RUN_USER_ERROR_H_
