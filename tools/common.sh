# Shared by run.sh and test.sh: finds the repository, installs packages on
# Debian 12, configures and builds build/release. All chatter goes to stderr.
# shellcheck shell=bash

set -euo pipefail

root="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)"
build="$root/build/release"

say() { printf '%s\n' "$*" >&2; }

# packages_of SECTION...: the packages that tools/packages.txt lists there.
packages_of() {
  local line section=""
  while read -r line || [[ -n "$line" ]]; do
    case "$line" in
      '' | '#'*) ;;
      '['*']') section="${line:1:-1}" ;;
      *) [[ " $* " == *" $section "* ]] && printf '%s\n' "$line" ;;
    esac
  done <"$root/tools/packages.txt"
  return 0
}

is_debian_12() {
  [[ -r /etc/os-release ]] &&
    (. /etc/os-release && [[ "${ID:-}" == debian && "${VERSION_ID:-}" == 12 ]])
}

# missing_packages NAME...: those that dpkg does not know as installed.
missing_packages() {
  local installed name
  installed="$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" \
    2>/dev/null || true)"
  for name in "$@"; do
    grep -qx -- "$name installed" <<<"$installed" || printf '%s\n' "$name"
  done
}

install_packages() {
  local -a as_root=()
  if [[ "$(id -u)" != 0 ]]; then
    if ! command -v sudo >/dev/null; then
      say "These packages are missing, and neither root nor sudo is at hand to" \
        "install them: $*"
      exit 1
    fi
    as_root=(sudo)
  fi
  say "Installing: $*"
  "${as_root[@]}" apt-get update -q >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "$@" >&2
}

# need_packages SECTION...: makes sure that the packages are there.
need_packages() {
  local -a wanted missing
  mapfile -t wanted < <(packages_of "$@")
  if is_debian_12; then
    mapfile -t missing < <(missing_packages "${wanted[@]}")
    [[ ${#missing[@]} == 0 ]] || install_packages "${missing[@]}"
    return
  fi
  local tool absent=""
  for tool in cmake ninja c++; do
    command -v "$tool" >/dev/null || absent+=" $tool"
  done
  say "This is not Debian 12, so nothing is installed; needed are what Debian" \
    "calls: ${wanted[*]}${absent:+ (not found:$absent)}"
  [[ -z "$absent" ]] || exit 1
}

cache_value() {
  sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt" 2>/dev/null || true
}

# configure OPTION...: cmake, with the preset release.
configure() {
  local -a fresh=()
  local home
  home="$(cache_value CMAKE_HOME_DIRECTORY)"
  # A cache that was moved, with its tree or without, is of no use.
  [[ -z "$home" || "$home" == "$root" ]] || fresh=(--fresh)
  (cd -- "$root" && cmake --preset release "${fresh[@]}" "$@") >&2
}

is_configured() {
  [[ -f "$build/build.ninja" &&
    "$(cache_value CMAKE_HOME_DIRECTORY)" == "$root" ]]
}

# build_target TARGET: silent if there is nothing to do.
build_target() {
  [[ "$(ninja -C "$build" -n "$1" 2>&1 | tail -n 1)" == *"no work to do."* ]] ||
    ninja -C "$build" -j "$(nproc)" "$1" >&2
}

# One build at a time; released by release_build.
lock_build() {
  mkdir -p -- "$build"
  exec 9>"$build/.lock"
  flock 9
}

release_build() { exec 9>&-; }
