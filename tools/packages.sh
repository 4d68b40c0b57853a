# SPDX-License-Identifier: GPL-3.0-or-later
# Part of common.sh: which packages are needed here, and which are missing.
# shellcheck shell=bash
# shellcheck disable=SC2154 # common.sh sets root and build

# package_system: the column of tools/packages.txt for this machine: debian,
# fedora, arch or homebrew; nothing if it is none of these.
package_system() {
  local like=""
  if [[ -r /etc/os-release ]]; then
    like="$(. /etc/os-release && printf ' %s %s ' "${ID:-}" "${ID_LIKE:-}")"
  fi
  case "$like" in
    *' debian '* | *' ubuntu '*) echo debian ;;
    *' fedora '* | *' rhel '*) echo fedora ;;
    *' arch '*) echo arch ;;
    *) if command -v brew >/dev/null; then echo homebrew; fi ;;
  esac
}

# packages_of SYSTEM SECTION...: the names in these sections, one a line, as
# they are in the table.
packages_of() {
  local system="$1" section="" debian fedora arch homebrew
  shift
  while read -r debian fedora arch homebrew || [[ -n "$debian" ]]; do
    case "$debian" in
      '' | '#'*) continue ;;
      '['*)
        section="${debian#\[}"
        section="${section%\]}"
        continue
        ;;
    esac
    case " $* " in *" $section "*) ;; *) continue ;; esac
    case "$system" in
      debian) printf '%s\n' "$debian" ;;
      fedora) printf '%s\n' "$fedora" ;;
      arch) printf '%s\n' "$arch" ;;
      homebrew) printf '%s\n' "$homebrew" ;;
    esac
  done <"$root/tools/packages.txt" | { grep -vx -e - || true; } | sort -u
}

# is_installed SYSTEM NAME
is_installed() {
  case "$1" in
    fedora) rpm -q --whatprovides "$2" ;;
    arch) pacman -T "$2" ;;
    homebrew) brew list --versions "$2" ;;
  esac >/dev/null 2>&1
}

# installed_on_debian NAME...: lines that say "NAME installed"; one call for all,
# since every run asks.
installed_on_debian() {
  dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null || true
}

# missing_of SYSTEM NAME...: those that are not installed, but for the optional
# ones of which it is known that there is no such package.
missing_of() {
  local system="$1" name installed=""
  shift
  [[ "$system" != debian ]] || installed="$(installed_on_debian "${@%\?}")"
  for name in "$@"; do
    if [[ "$system" == debian ]]; then
      case $'\n'"$installed"$'\n' in
        *$'\n'"${name%\?} installed"$'\n'*) continue ;;
      esac
      ! grep -qsx -- "${name%\?}" "$root/build/.no_such_package" || continue
    else
      ! is_installed "$system" "${name%\?}" || continue
    fi
    printf '%s\n' "$name"
  done
}

# without_optional NAME...: the names that are needed.
without_optional() {
  printf '%s\n' "$@" | grep -v -e '?$' || true
}

# install_on_debian NAME...: with apt-get, as root or by sudo.
install_on_debian() {
  local name known=""
  local sudo=""
  if [[ "$(id -u)" != 0 ]]; then
    if ! command -v sudo >/dev/null; then
      [[ -n "$(without_optional "$@")" ]] || return 0
      say_command debian "$@"
      exit 1
    fi
    sudo=sudo
  fi
  $sudo apt-get update -q >&2
  for name in "$@"; do
    if [[ "$name" == *\? ]] &&
      ! apt-cache show "${name%\?}" >/dev/null 2>&1; then
      printf '%s\n' "${name%\?}" >>"$root/build/.no_such_package"
    else
      known="$known ${name%\?}"
    fi
  done
  [[ -n "$known" ]] || return 0
  say "Installing:$known"
  # shellcheck disable=SC2086 # names are words
  $sudo env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends $known >&2
}

# say_command SYSTEM NAME...: the line that installs the packages.
say_command() {
  local system="$1"
  shift
  local command="sudo apt-get install"
  case "$system" in
    fedora) command="sudo dnf install" ;;
    arch) command="sudo pacman -S --needed" ;;
    homebrew) command="brew install" ;;
  esac
  say "Something is missing. This installs it:"
  say "    $command ${*%\?}"
}

# need_programs: the least that can be asked of a system that is not known.
need_programs() {
  local tool absent=""
  for tool in cmake ninja c++; do
    command -v "$tool" >/dev/null || absent="$absent $tool"
  done
  [[ -n "$absent" ]] || return 0
  say "Not found:$absent. Debian's names of all that is needed:" \
    "$(packages_of debian "$@" | tr -d '?' | tr '\n' ' ')"
  exit 1
}

# need_packages SECTION...: makes sure that the packages are there. Debian and
# Ubuntu get them; elsewhere a line to copy says what is missing.
need_packages() {
  local system missing stamp
  system="$(package_system)"
  if [[ -z "$system" ]]; then
    need_programs "$@"
    return
  fi
  # Other package managers take a second to answer, so they are asked once.
  stamp="$build/.packages_of_$(printf '%s_' "$@")found"
  if [[ "$system" != debian && "$stamp" -nt "$root/tools/packages.txt" ]]; then
    return
  fi
  # shellcheck disable=SC2046 # names are words
  missing="$(missing_of "$system" $(packages_of "$system" "$@"))"
  # shellcheck disable=SC2086
  if [[ "$system" == debian ]]; then
    [[ -z "$missing" ]] || install_on_debian $missing
  elif [[ -n "$(without_optional $missing)" ]]; then
    say_command "$system" $missing
    exit 1
  else
    : >"$stamp"
  fi
}
