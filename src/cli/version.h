// The version of the program, as the build names it.

#ifndef TRUELUX_CLI_VERSION_H_
#define TRUELUX_CLI_VERSION_H_

namespace truelux {

inline constexpr const char* kVersion = TRUELUX_VERSION;

}  // namespace truelux

#endif  // TRUELUX_CLI_VERSION_H_
