#!/usr/bin/env bash
# Builds everything if need be and runs the tests; arguments go to ctest, e.g.
#
#   tools/test.sh -R report
#
# On Debian 12 missing packages are installed first.

. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

lock_build
need_packages run test
if ! is_configured || [[ "$(cache_value TRUELUX_BUILD_TESTS)" != ON ]]; then
  configure -DTRUELUX_BUILD_TESTS=ON
fi
build_target all
release_build

exec ctest --test-dir "$build" --output-on-failure -j "$(nproc)" "$@"
