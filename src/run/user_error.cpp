// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/user_error.h"

#include <system_error>
#include <utility>

namespace truelux {

UserError::UserError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(diagnostics.front().Text()),
      diagnostics_(std::move(diagnostics)) {}

UserError::UserError(const std::string& message)
    : UserError({Diagnostic{Severity::kError, "", 0, message}}) {}

UserError::UserError(const std::string& file, const std::string& what,
                     int error_number)
    : UserError({Diagnostic{
          Severity::kError, file, 0,
          what + ": " + std::generic_category().message(error_number)}}) {}

}  // namespace truelux
