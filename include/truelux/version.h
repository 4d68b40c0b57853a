// SPDX-License-Identifier: GPL-3.0-or-later
// The version of the library: of these headers, and of what is linked.

#ifndef TRUELUX_VERSION_H_
#define TRUELUX_VERSION_H_

#include "truelux/export.h"

/// The version of the headers. The build reads it from these lines and checks
/// that they agree. While MAJOR is 0, a new MINOR may break programs; a new
/// PATCH never does.
#define TRUELUX_VERSION_MAJOR 0
#define TRUELUX_VERSION_MINOR 1
#define TRUELUX_VERSION_PATCH 0
#define TRUELUX_VERSION_STRING "0.1.0"

/// The same as one number that grows from version to version: 1.2.3 is 10203.
#define TRUELUX_VERSION                                          \
  (TRUELUX_VERSION_MAJOR * 10000 + TRUELUX_VERSION_MINOR * 100 + \
   TRUELUX_VERSION_PATCH)

namespace truelux {

/// TRUELUX_VERSION of the library that the program runs with. A program that
/// was compiled with other headers sees a different number.
[[nodiscard]] TRUELUX_EXPORT int VersionNumber();

/// TRUELUX_VERSION_STRING of the library that the program runs with.
[[nodiscard]] TRUELUX_EXPORT const char* VersionText();

}  // namespace truelux

#endif  // TRUELUX_VERSION_H_
