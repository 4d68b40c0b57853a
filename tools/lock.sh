# SPDX-License-Identifier: GPL-3.0-or-later
# Part of common.sh: one build at a time. With flock the kernel lets go of the
# lock when its holder ends, however it ends. Without flock the lock is a
# folder, and a file in it names the processes that hold it: if none of them is
# alive, the lock is stale.
# shellcheck shell=bash
# shellcheck disable=SC2154 # common.sh sets build

lock_folder=""
lock_is_held=""  # "flock" or "folder"

# started PID: when that process started; nothing if there is none. Numbers of
# processes come again, so a number alone names none.
started() {
  { ps -o lstart= -p "$1" 2>/dev/null || true; } | tr -s ' ' | sed 's/ *$//'
}

# is_stale: whether every process that holds the folder has ended.
is_stale() {
  local pid start now
  # Whoever made the folder names itself at once, unless it was killed.
  if [[ ! -s "$lock_folder/holders" ]]; then
    [[ -n "$(find "$lock_folder" -prune -mmin +1 2>/dev/null)" ]]
    return
  fi
  while read -r pid start; do
    now="$(started "$pid")"
    if [[ -n "$now" && "$now" == "$start" ]]; then return 1; fi
  done <"$lock_folder/holders"
}

# name_holder PID
name_holder() {
  printf '%s %s\n' "$1" "$(started "$1")" >>"$lock_folder/holders"
}

# Only one of those who wait takes a stale lock away.
remove_if_stale() {
  is_stale || return 0
  if mkdir "$lock_folder.removal" 2>/dev/null; then
    if is_stale; then rm -rf -- "$lock_folder"; fi
    rmdir "$lock_folder.removal"
  elif [[ -n "$(find "$lock_folder.removal" -prune -mmin +1 2>/dev/null)" ]]
  then
    rmdir "$lock_folder.removal" 2>/dev/null || true
  fi
}

lock_build() {
  local said=""
  mkdir -p -- "$build"
  lock_folder="$build/.lock_folder"
  if command -v flock >/dev/null; then
    exec 9>"$build/.lock"
    flock 9
    lock_is_held=flock
    return
  fi
  until mkdir "$lock_folder" 2>/dev/null; do
    remove_if_stale
    if [[ -z "$said" && -d "$lock_folder" ]]; then
      say "Another build is under way; waiting for it."
      said=yes
    fi
    sleep 0.2
  done
  lock_is_held=folder
  name_holder $$
  trap release_build EXIT
}

release_build() {
  case "$lock_is_held" in
    flock) exec 9>&- ;;
    folder)
      rm -rf -- "$lock_folder"
      trap - EXIT
      ;;
  esac
  lock_is_held=""
}

# holding_lock COMMAND...: runs it so that the lock lasts until the command has
# ended, even if this script is killed before. Flock does so by itself.
holding_lock() {
  if [[ "$lock_is_held" != folder ]]; then
    "$@"
    return
  fi
  (
    trap - EXIT
    # The number of a subshell, which bash 3.2 does not tell.
    name_holder "$(exec sh -c 'echo "$PPID"')"
    exec "$@"
  )
}
