#!/bin/sh -e
# A roof in the sun and under a cold sky, in two bands, checked by hand: docs/heat.md tells how.
#
#   tests/users/warm_plate.sh PROGRAM SOURCES        works in the current folder
program=$(realpath "$1")
sources=$(realpath "$2")
fail() { echo "warm_plate: $*" >&2; exit 1; }

"$program" solve "$sources/scenes/heat/roof_by_day.json" -o day --no-illumination 2> said.txt
grep -q "energy in the solar band: emitted 700" said.txt || fail "the energy of the solar band: $(grep energy said.txt)"
# The roof of 1 m sees the sky alone: 700 W/m2 in the solar band, sigma 260^4 in the thermal one, and it is insulated below.
awk -F, '
  BEGIN { sigma = 5.670374419e-8; a = (1 - 0.3) * 700; t = ((sigma * 260^4 + a / 0.9) / sigma)^0.25 }
  $1 == "roof" { d = $4 - t; if ($3 != "thermal" || d * d > 1e-20) { print $4 " instead of " t; exit 1 } ++n }
  END { exit n != 1 }' day/temperature.csv || fail "the temperature differs from that by hand"
awk -F, '$1 == "face" && $2 == "roof" { net[$3] = $5 } END {
  exit (net["solar"] + 490)^2 > 1e-18 || (net["thermal"] - 490)^2 > 1e-18 || net["total"]^2 > 1e-18 }' day/flux.csv ||
  fail "what the roof gains and gives away"
