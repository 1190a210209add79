#!/bin/sh -e
# A duct of triangular section with two heated sides, checked by hand: docs/heat.md tells how.
#
#   tests/users/heated_triangle.sh PROGRAM SOURCES        works in the current folder
program=$(realpath "$1")
sources=$(realpath "$2")
fail() { echo "heated_triangle: $*" >&2; exit 1; }

"$program" solve "$sources/scenes/heat/heated_triangle.json" -o duct --no-illumination 2> said.txt
grep -q "given flux: 's2' 640.683 K, 's3' 598.772 K" said.txt || fail "what is said: $(grep flux said.txt)"
# Sides 4, 3 and 5: F12 = (4 + 3 - 5) / 8. The cold side takes what the others give, 3 * 2000 + 5 * 1000 W/m.
awk -F, '
  BEGIN {
    sigma = 5.670374419e-8
    f12 = (4 + 3 - 5) / (2 * 4); f21 = f12 * 4 / 3; f23 = 1 - f21; f31 = (1 - f12) * 4 / 5; f32 = 1 - f31
    b1 = sigma * 300^4 + (1 - 0.4) / 0.4 * (3 * 2000 + 5 * 1000) / 4
    b2 = (2000 + f21 * b1 + f23 * (1000 + f31 * b1)) / (1 - f23 * f32); b3 = 1000 + f31 * b1 + f32 * b2
    t["s2"] = ((b2 + (1 - 0.6) / 0.6 * 2000) / sigma)^0.25; t["s3"] = ((b3 + (1 - 0.8) / 0.8 * 1000) / sigma)^0.25
  }
  $1 in t { d = $4 - t[$1]; if (d * d > 1e-20 || $5 > $4 || $6 < $4) { print $1 ": " $4 " instead of " t[$1]; exit 1 } ++n }
  END { exit n != 2 }' duct/temperature.csv || fail "temperatures differ from those by hand"
awk -F, '$1 == "face" && $2 == "s1" { d = $5 + 11000; exit d * d > 1e-12 }' duct/flux.csv || fail "what the cold side takes"
# Heat may be taken as well; more than a face can give is refused by name.
sed 's|"flux": 1000|"flux": -100|; s|"flux": 2000|"flux": 60|' "$sources/scenes/heat/heated_triangle.json" > cooled.json
"$program" solve cooled.json -o cooled --no-illumination --quiet
sed 's|"flux": 1000|"flux": -4000|' "$sources/scenes/heat/heated_triangle.json" > frozen.json
if "$program" solve frozen.json -o frozen --no-illumination --quiet 2> refused.txt; then fail "below 0 K"; fi
grep -q "frozen.json:[0-9]*: no temperature: 's3' would have to be colder than 0 K" refused.txt || fail "$(cat refused.txt)"
