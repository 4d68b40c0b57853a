#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds truelux if need be and runs it.
#
#   tools/run.sh              the irradiance on the floor of the Cornell box
#   tools/run.sh ARGUMENTS    truelux ARGUMENTS
#
# Standard output and the exit status are those of truelux. What is missing is
# installed first on Debian and Ubuntu, and named elsewhere.

# shellcheck source=tools/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

lock_build
need_packages run
is_configured || configure -DTRUELUX_BUILD_TESTS=OFF
build_targets truelux man
release_build

if [[ $# == 0 ]]; then
  scenes="$root/examples/scenes"
  set -- eval "$scenes/cornell_box.obj" "$scenes/cornell_box_floor.csv"
  say "The irradiance at 144 points on the floor of the Cornell box: truelux $*"
fi
exec "$build/truelux" "$@"
