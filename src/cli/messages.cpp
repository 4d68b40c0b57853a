#include "cli/messages.h"

#include <cstdio>
#include <fmt/format.h>
#include <system_error>
#include <utility>

#include "cli/output_file.h"

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

void PrintLine(std::string_view line) {
  // In one piece, so that lines of several programs do not mix.
  const std::string text = fmt::format("{}\n", line);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void Print(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics)
    PrintLine(diagnostic.Text());
}

void PrintNote(const std::string& message) {
  PrintLine(Diagnostic{Severity::kNote, "", 0, message}.Text());
}

void WriteStandardOutput(std::string_view text) {
  OutputFile output("");
  output.Write(text);
  output.Finish();
}

}  // namespace truelux
