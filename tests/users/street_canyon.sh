#!/bin/sh -e
# An engineer's night in a street: sky view factors against closed forms, then heat with a cold sky, insulated faces,
# balconies and a tree. Run by the tests; docs/heat.md tells the story.
#
#   tests/users/street_canyon.sh PROGRAM SOURCES        works in the current folder
program=$(realpath "$1")
sources=$(realpath "$2")
fail() { echo "street_canyon: $*" >&2; exit 1; }

# A street of width 1 and height h. Oke 1981, Johnson and Watson 1984: of the road sqrt(1 + h^2) - h, of a wall
# (1 + h - sqrt(1 + h^2)) / (2 h), in the middle of the road cos(atan(2 h)).
for h in 0.25 0.5 1 2 4; do
  cat > street.json <<SCENE
{ "hottel": 1, "dimension": 2, "materials": {"m": {}},
  "edges": [{"name": "road", "points": [[1, 0], [0, 0]], "material": "m"},
            {"name": "west", "points": [[0, 0], [0, $h]], "material": "m"},
            {"name": "east", "points": [[1, $h], [1, 0]], "material": "m"}] }
SCENE
  "$program" factors street.json --quiet | awk -F, -v h=$h '
    function check(name, value, expected) {
      if ((value - expected)^2 > 1e-30) { print name " at h = " h ": " value " instead of " expected; exit 1 }
    }
    $1 == "road" && $2 == "sky" { check("road", $3, sqrt(1 + h*h) - h); ++n }
    $1 == "west" && $2 == "sky" { check("wall", $3, (1 + h - sqrt(1 + h*h)) / (2*h)); ++n }
    END { exit n != 2 }' || fail "sky view factors differ from the closed forms at h = $h"
  "$program" visibility street.json --on road --at 1/2 --quiet | awk -v h=$h '
    $1 == "sky" { e = $2 - cos(atan2(2*h, 1)); exit e*e > 1e-30 }' || fail "the middle of the road at h = $h"
done

# The night.
"$program" solve "$sources/scenes/heat/street_canyon.json" -o night --show temperature --quiet
for file in radiosity.csv flux.csv temperature.csv illumination.npy illumination.npy.json illumination.png report.json; do
  [ -s night/$file ] || fail "there is no $file"
done
# What is insulated gains and loses nothing; all net fluxes sum to 0; the sky gains.
awk -F, '$1 == "group" { sum += $5; all += $5 < 0 ? -$5 : $5
                         if ($2 ~ /^(east|leaf)/ && ($6 > 0 || $7 < 0)) { print $0; exit 1 }
                         if ($2 == "sky" && $5 >= 0) { print $0; exit 1 } }
         END { if (sum*sum > 1e-20*all*all) { print "the fluxes sum to " sum; exit 1 } }' night/flux.csv ||
  fail "net fluxes are not those of insulated faces"
# Between the sky and the road is what is insulated; the front is colder the higher one looks.
awk -F, '$1 == "east" || $1 ~ /^leaf/ { if (!($5 <= $4 && $4 <= $6 && $5 > 263 && $6 < 293)) { print $0; exit 1 } }
         $1 == "east" { t[$2] = $4; ++n }
         END { if (n != 18 || t[0] >= t[17]) { print "the front: " n " elements, " t[0] " K above, " t[17] " K below"; exit 1 } }' \
  night/temperature.csv || fail "temperatures of insulated faces"

# The same street, read back as it was written.
"$program" convert "$sources/scenes/heat/street_canyon.json" once.json --quiet
"$program" convert once.json twice.json --quiet
cmp once.json twice.json || fail "the scene changes when it is written again"
grep -q '"insulation": {"insulated": true}' once.json || fail "insulated faces are written as something else"
