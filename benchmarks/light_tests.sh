#!/usr/bin/env bash
# Lights by tests of a few points of each element: writes the tables and pictures of "Lights by centroids and vertices"
# in docs/accuracy.md anew. What stands between the lines `<!-- generated: light_tests_NAME -->` and `<!-- end -->` is
# replaced, the rest of the page stays.
#
#   benchmarks/light_tests.sh [BUILD]     BUILD holds hottel and benchmarks/report_light_tests; without it build/release
# Takes about a minute on a quiet machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=${1:-build/release}
page=docs/accuracy.md
work=build/light_tests
mkdir -p "$work"

table() {  # name, most elements an edge
  {
    echo
    "$build/benchmarks/report_light_tests" "scenes/lights/$1.json" "$2"
    echo
  } >"$work/light_tests_$1"
}
table torch 256
table hall 16

for test in exact centroid; do
  "$build/hottel" solve scenes/lights/hall.json -o "$work/$test" --elements 16 --method points:1 --lights $test \
    --size 400 --quiet
  cp "$work/$test/render.png" "docs/images/lights_$test.png"
done

awk -v tables="$work" '
  /^<!-- end -->$/ { skipping = 0 }
  !skipping { print }
  /^<!-- generated: light_tests_.* -->$/ {
    file = tables "/" $3
    skipping = 1
    while ((getline line < file) > 0) print line
    close(file)
  }' "$page" >"$work/page.md"
cp "$work/page.md" "$page"
