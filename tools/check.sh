#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Lanes that look for what a usual build and its tests do not show. Without
# arguments all of them run, else those that are named:
#
#   dev            warnings are errors, assertions on, no precompiled headers
#   asan           the quick tests under AddressSanitizer and UBSan
#   tsan           the tests that start threads, under ThreadSanitizer
#   format         clang-format changes nothing
#   tidy           clang-tidy has no finding
#   fuzz           each fuzzer for a minute from its corpus
#
#   tools/check.sh format tidy
#
# tidy-changed is tidy over the files that differ from the branch origin/main.
# Each lane ends with one line on stdout; the exit status is 1 if one failed.
# What is missing is installed first on Debian and Ubuntu, and named elsewhere.

# shellcheck source=tools/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
cd -- "$root"

# prepare PRESET TARGET...: configures, and builds the targets if there are any.
prepare() {
  use_preset "$1"
  shift
  lock_build
  configure --log-level=WARNING
  if [[ $# != 0 ]]; then build_targets "$@"; fi
  release_build
}

# run_tests OPTION...: with the settings of the test preset.
run_tests() {
  ctest --preset "$preset" -j "$(cores)" "$@" >&2
}

lane_dev() {
  need_packages run test browser
  prepare dev all
  run_tests
}

lane_asan() {
  need_packages run test python
  prepare asan all
  run_tests
}

lane_tsan() {
  need_packages run test clang
  prepare tsan threaded_tests
  run_tests --label-regex threads
}

# sources ENDING...: the files of the project with these endings.
sources() {
  local ending
  for ending in "$@"; do
    find include src tests bench examples fuzz bindings -name "*.$ending"
  done | sort
}

lane_format() {
  need_packages format
  sources h cpp | xargs clang-format --dry-run -Werror >&2
}

# tidy: clang-tidy over the files on stdin, beside each other.
tidy() {
  xargs -n 1 -P "$(cores)" clang-tidy --quiet -p build/dev 2>&1 |
    { grep -v -e 'warnings\{0,1\} generated' -e 'treated as error' || true; } >&2
}

# compiled: those of the files on stdin that the build compiles.
compiled() {
  local file
  while IFS= read -r file; do
    if grep -qF "/$file\"" build/dev/compile_commands.json; then
      printf '%s\n' "$file"
    fi
  done
}

lane_tidy() {
  need_packages run test tidy
  prepare dev
  sources cpp | compiled | tidy
}

# A changed header stands for the file of its name.
lane_tidy_changed() {
  need_packages run test tidy
  prepare dev
  {
    git diff --name-only origin/main
    git ls-files --others --exclude-standard
  } | sed 's/\.h$/.cpp/' | sort -u | compiled | tidy
}

# fuzz NAME: what a run finds is kept in build/fuzz/grown/NAME, so that the
# corpus stays small; an input that fails is left in build/fuzz.
fuzz() {
  local grown="$build/grown/$1" log="$build/$1.log"
  mkdir -p -- "$grown"
  "$build/fuzz/$1_fuzz" -max_total_time="${TRUELUX_FUZZ_SECONDS:-60}" \
    -timeout=10 -close_fd_mask=3 -artifact_prefix="$build/$1-" \
    "$grown" "fuzz/corpus/$1" >"$log" 2>&1 || {
    tail -n 40 "$log" >&2
    return 1
  }
  say "$1: $(grep -a '^Done ' "$log")"
}

lane_fuzz() {
  local corpus name names="" targets=""
  need_packages run test clang
  for corpus in fuzz/corpus/*; do
    names="$names ${corpus##*/}"
    targets="$targets ${corpus##*/}_fuzz"
  done
  # shellcheck disable=SC2086 # names are words
  prepare fuzz $targets
  for name in $names; do
    fuzz "$name"
  done
}

lane() {
  case "$1" in
    dev) lane_dev ;;
    asan) lane_asan ;;
    tsan) lane_tsan ;;
    format) lane_format ;;
    tidy) lane_tidy ;;
    tidy-changed) lane_tidy_changed ;;
    fuzz) lane_fuzz ;;
  esac
}

# run_lane NAME: prints its closing line; sets failed. Not to be called in a
# condition, since set -e does not hold in one.
run_lane() {
  local start=$SECONDS status result=passed
  set +e
  (
    set -e
    lane "$1"
  )
  status=$?
  set -e
  if [[ "$status" != 0 ]]; then
    result=FAILED
    failed=1
  fi
  printf '%s: %s after %d s\n' "$1" "$result" $((SECONDS - start))
}

[[ $# != 0 ]] || set -- format dev tidy asan tsan fuzz
for name in "$@"; do
  case "$name" in
    dev | asan | tsan | format | tidy | tidy-changed | fuzz) ;;
    *)
      say "There is no lane $name; see the first lines of tools/check.sh."
      exit 2
      ;;
  esac
done
failed=0
for name in "$@"; do
  run_lane "$name"
done
exit "$failed"
