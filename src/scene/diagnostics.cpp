// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/diagnostics.h"

#include <string>

#include "base/visible_text.h"

namespace truelux {

std::string Diagnostic::Text() const {
  std::string text = Visible(file);
  if (line > 0) {
    text += file.empty() ? "line " : ":";
    text += std::to_string(line);
  }
  if (!text.empty()) text += ": ";
  text += Name(severity);
  return text + ": " + message;
}

}  // namespace truelux
