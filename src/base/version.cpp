// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/version.h"

namespace truelux {

int VersionNumber() {
  return TRUELUX_VERSION;
}

const char* VersionText() {
  return TRUELUX_VERSION_STRING;
}

}  // namespace truelux
