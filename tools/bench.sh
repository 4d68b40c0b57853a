#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the comparison with other ways to the same number if need be and runs
# it; arguments go to side_by_side, e.g.
#
#   tools/bench.sh --quick --svg chart.svg
#
# What is missing is installed first on Debian and Ubuntu, and named elsewhere.

# shellcheck source=tools/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

lock_build
need_packages run bench
if ! is_configured; then
  configure -DTRUELUX_BUILD_TESTS=OFF -DTRUELUX_BUILD_BENCH=ON
elif [[ "$(cache_value TRUELUX_BUILD_BENCH)" != ON ]]; then
  configure -DTRUELUX_BUILD_BENCH=ON
fi
build_targets side_by_side
release_build

exec "$build/bench/side_by_side" "$@"
