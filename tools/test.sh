#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds everything if need be and runs the tests; arguments go to ctest, e.g.
#
#   tools/test.sh -R report
#   tools/test.sh --all         with those that have the label slow, too
#
# What is missing is installed first on Debian and Ubuntu, and named elsewhere.

# shellcheck source=tools/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

which=(--label-exclude slow)
if [[ "${1:-}" == --all ]]; then
  which=(--no-tests=error)
  shift
fi

lock_build
need_packages run test browser python
if ! is_configured || [[ "$(cache_value TRUELUX_BUILD_TESTS)" != ON ]] ||
  [[ "$(cache_value TRUELUX_BUILD_PYTHON)" != ON ]]; then
  configure -DTRUELUX_BUILD_TESTS=ON -DTRUELUX_BUILD_PYTHON=ON
fi
build_targets all
release_build

exec ctest --test-dir "$build" --output-on-failure -j "$(cores)" \
  "${which[@]}" "$@"
