#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds truelux if need be and runs it.
#
#   tools/run.sh              the irradiance on the floor of the Cornell box
#   tools/run.sh ARGUMENTS    truelux ARGUMENTS
#   tools/run.sh --python     builds the Python package and runs its first
#                             example
#
# Standard output and the exit status are those of truelux. What is missing is
# installed first on Debian and Ubuntu, and named elsewhere.

# shellcheck source=tools/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

# run_python ARGUMENT...: the package's Python, with the package.
run_python() {
  local python
  lock_build
  need_packages run python
  if ! is_configured || [[ "$(cache_value TRUELUX_BUILD_PYTHON)" != ON ]]; then
    configure -DTRUELUX_BUILD_PYTHON=ON
  fi
  python="$(cache_value Python3_EXECUTABLE)"
  [[ -n "$python" ]] || {
    say "There is no Python with NumPy, its headers and pybind11; their packages" \
      "are in tools/packages.txt."
    exit 1
  }
  build_targets truelux_python
  release_build
  say "PYTHONPATH=$build/python $python $*"
  PYTHONPATH="$build/python" exec "$python" "$@"
}

if [[ "${1:-}" == --python ]]; then
  shift
  [[ $# -gt 0 ]] || set -- "$root/examples/python/first.py"
  run_python "$@"
fi

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
