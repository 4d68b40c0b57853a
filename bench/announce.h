// What is being done, for whoever waits at a terminal.

#ifndef TRUELUX_BENCH_ANNOUNCE_H_
#define TRUELUX_BENCH_ANNOUNCE_H_

#include <string>

namespace truelux::bench {

/// Replaces the last line on standard error, if that is a terminal. "": clears
/// the line; to be called before anything is printed.
void Announce(const std::string& what);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_ANNOUNCE_H_
