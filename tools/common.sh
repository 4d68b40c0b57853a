# SPDX-License-Identifier: GPL-3.0-or-later
# Shared by the scripts beside it: finds the repository, knows the packages,
# configures and builds. All chatter goes to stderr. Bash 3.2 is enough, and
# neither flock nor nproc is needed.
# shellcheck shell=bash

set -euo pipefail

root="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)"

# use_preset NAME: what follows is about build/NAME.
use_preset() {
  preset="$1"
  build="$root/build/$preset"
}
use_preset release

say() { printf '%s\n' "$*" >&2; }

# shellcheck source=tools/packages.sh
. "$root/tools/packages.sh"
# shellcheck source=tools/lock.sh
. "$root/tools/lock.sh"

# cores: how many jobs to run at once.
cores() {
  nproc 2>/dev/null || getconf _NPROCESSORS_ONLN 2>/dev/null ||
    sysctl -n hw.ncpu 2>/dev/null || echo 2
}

cache_value() {
  sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt" 2>/dev/null || true
}

# configure OPTION...: cmake, with the preset.
configure() {
  local home
  home="$(cache_value CMAKE_HOME_DIRECTORY)"
  # A cache that was moved, with its tree or without, is of no use.
  [[ -z "$home" || "$home" == "$root" ]] ||
    rm -rf -- "$build/CMakeCache.txt" "$build/CMakeFiles"
  (cd -- "$root" && holding_lock cmake --preset "$preset" "$@") >&2 || {
    say "If something was not found: what is needed, by the name of its" \
      "package, is in tools/packages.txt."
    exit 1
  }
}

is_configured() {
  [[ -f "$build/build.ninja" &&
    "$(cache_value CMAKE_HOME_DIRECTORY)" == "$root" ]]
}

# A file takes about three seconds of one core (docs/performance.md).
say_how_long() {
  local minutes=$((($1 * 3 / $(cores) + 59) / 60))
  say "Building $1 files on $(cores) cores: about $minutes min."
}

# Ninja's lines, with a file instead of the path of its object.
short_lines() {
  local line
  while IFS= read -r line; do
    case "$line" in
      '['*'] Building '*' object '* | '['*'] Linking '*)
        say "${line%%]*}] ${line##*[/ ]}" ;;
      'ninja: Entering'*) ;;
      *) say "$line" ;;
    esac
  done
}

# build_targets TARGET...: silent if there is nothing to do.
build_targets() {
  local plan jobs
  plan="$(ninja -C "$build" -n "$@" 2>&1 | tail -n 1)"
  case "$plan" in *"no work to do."*) return ;; esac
  jobs="${plan#*/}"
  jobs="${jobs%%]*}"
  case "$jobs" in '' | *[!0-9]*) ;; *) say_how_long "$jobs" ;; esac
  export NINJA_STATUS='[%f/%t %es] '
  if [[ -t 2 ]]; then
    holding_lock ninja -C "$build" -j "$(cores)" "$@" >&2
  else
    holding_lock ninja -C "$build" -j "$(cores)" "$@" 2>&1 | short_lines
  fi
}
