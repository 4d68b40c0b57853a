// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/messages.h"

#include <cstdio>

#include "base/visible_text.h"
#include "run/output_file.h"

namespace truelux {

void PrintLine(std::string_view line) {
  // In one piece, so that lines of several programs do not mix; on one line,
  // whatever names a user has given.
  const std::string text = Visible(line) + "\n";
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
