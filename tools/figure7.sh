#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Renders the four pictures of docs/gallery.md, 512 x 512 on one thread, with
# both methods, and prints a table of times:
#
#   tools/figure7.sh [TRUELUX [FOLDER [RUNS]]]
#
# TRUELUX is the program (build/release/truelux), FOLDER gets the certified
# pictures (a temporary folder). A time is that of the whole command, reading,
# finding the first face along each ray and writing the PNG included: processor
# time, the least of RUNS (3).

set -euo pipefail
export LC_ALL=C

root="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)"
truelux="${1:-$root/build/release/truelux}"
runs="${3:-3}"
work="$(mktemp -d)"
trap 'rm -rf -- "$work"' EXIT
out="${2:-$work}"
mkdir -p -- "$out"

# What each picture shows, as in docs/gallery.md.
view() {
  case "$1" in
    a) echo "--eye 3,-14,7.5 --target 0.2,-0.3,0.7 --up 0,0,1 --fov 36 --white 0.065" ;;
    b) echo "--surface floor --white 0.6" ;;
    c) echo "--eye 4,-15,7.5 --target 0,-0.2,0.9 --up 0,0,1 --fov 38 --white 0.6" ;;
    d) echo "--eye 3,-12,7 --target 0.3,-0.2,2 --up 0,0,1 --fov 40 --white 0.35" ;;
  esac
}

# seconds LETTER METHOD PICTURE: the least processor time of some runs.
seconds() {
  local best="" time TIMEFORMAT='%U %S'
  local -a options
  read -ra options <<<"$(view "$1")"
  for ((i = 0; i < runs; ++i)); do
    time="$({ time "$truelux" render "$root/examples/scenes/figure7_$1.obj" \
      "${options[@]}" --size 512x512 --threads 1 --method "$2" -o "$3" \
      2>"$work/notes"; } 2>&1)" || { cat "$work/notes" >&2; return 1; }
    best="$(awk -v best="$best" '{ t = $1 + $2
      if (best == "" || t < best) best = t; print best }' <<<"$time")"
  done
  echo "$best"
}

echo "| | paper [s] | certified [s] | paper / certified (bar 10) | double [s] | paper / double (bar 25) |"
echo "|---|---|---|---|---|---|"
for row in a:32 b:280 c:98 d:21; do
  letter="${row%:*}" paper="${row#*:}"
  certified="$(seconds "$letter" certified "$out/figure7_$letter.png")"
  double="$(seconds "$letter" double "$work/double.png")"
  awk -v l="$letter" -v p="$paper" -v c="$certified" -v d="$double" 'BEGIN {
    printf "| %s | %g | %.2f | %.0f | %.2f | %.0f |\n", l, p, c, p / c, d, p / d }'
done
