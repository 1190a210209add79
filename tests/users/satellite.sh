#!/bin/sh -e
# A satellite of two STL files in sun and eclipse, checked by hand: docs/heat.md tells how.
#
#   tests/users/satellite.sh PROGRAM SOURCES        works in the current folder
program=$(realpath "$1")
scenes=$(realpath "$2")/scenes/heat
fail() { echo "satellite: $*" >&2; exit 1; }

"$program" check "$scenes/satellite_in_sun.json" > found.txt
grep -q '^0 errors, 0 warnings, 0 notes' found.txt || fail "$(cat found.txt)"
for when in sun eclipse; do
  "$program" solve "$scenes/satellite_in_$when.json" -o "$when" --no-picture 2> "$when.txt"
done
# temperatures FILE GAINED: the top of the bus gains so much of the sun, its bottom nothing; both see the sky alone.
temperatures() {
  awk -F, -v gained="$2" '
    function is(t) { d = $4 - (81 + t / 0.7 / 5.670374419e-8)^0.25; return d * d < 1e-16 }
    $1 == "bus[0]" || $1 == "bus[1]" { n += is(20 + gained) } $1 == "bus[2]" || $1 == "bus[3]" { n += is(20) }
    END { exit n != 4 }' "$1/temperature.csv" || fail "$(cat "$1/temperature.csv")"
}
temperatures sun 544.4
temperatures eclipse 0
# 1361 W/m2 on 3 m2, and what the bus dissipates.
awk -F, '
  function is(t) { return $6 <= t && t <= $7 }
  $2 == "sun" && $3 == "solar" { n += is(4083) } $2 == "bus" && $3 == "total" { n += is(120) }
  $1 == "group" && $2 == "sky" && $3 == "total" { n += is(-4203) } END { exit n != 3 }' sun/flux.csv || fail "$(cat sun/flux.csv)"
# The wing is warmer than by itself, and in eclipse warmed by the bus alone.
awk -F, '$1 ~ /^wing\[.\]$/ { n += ($4 > 387.69 && $4 < 389) } END { exit n != 2 }' sun/temperature.csv || fail "the wing"
awk -F, '$1 ~ /^wing/ { n += ($4 > 40 && $4 < 70) } END { exit n != 4 }' eclipse/temperature.csv || fail "the wing"
