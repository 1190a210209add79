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

# What stands in the street, by crossed strings. A balcony of depth d half-way up the west wall, with its tip at T: of the
# road (|road left, east eave| + |road right, west eave| - |road left, T| - |T, west eave| - h) / 2; in the middle of the
# road the lower one of eave and tip bounds the sky on the left. A crown of sparse screens at the height of the eaves, from
# a to b each: of the road less (|left, b| + |right, a| - |left, a| - |right, b|) / 2, in the middle of the road less half of
# what it takes of the sines. Its gaps, and the leaves, are a tenth of the street wide, or a hundredth.
for h in 0.25 0.5 1 2 4; do
  for leaf in 0.1 0.01; do
    awk -v h=$h -v leaf=$leaf 'BEGIN {
      print "{ \"hottel\": 1, \"dimension\": 2, \"materials\": {\"m\": {}}, \"edges\": ["
      printf "{\"name\": \"road\", \"points\": [[1, 0], [0, 0]], \"material\": \"m\"},\n"
      printf "{\"name\": \"west\", \"points\": [[0, 0], [0, %s]], \"material\": \"m\"},\n", h
      for (k = 0; 0.3 + (2 * k + 1) * leaf < 0.7; ++k)
        printf "{\"name\": \"leaf %d\", \"points\": [[%.2f, %s], [%.2f, %s]], \"material\": \"m\", \"back\": \"m\"},\n",
          k, 0.3 + 2 * k * leaf, h, 0.3 + (2 * k + 1) * leaf, h
      printf "{\"name\": \"east\", \"points\": [[1, %s], [1, 0]], \"material\": \"m\"}] }\n", h }' > crown.json
    sed "s|{\"name\": \"leaf 0\".*|{\"name\": \"balcony\", \"points\": [[0, \"$h/2\"], [0.1, \"$h/2\"]], \"material\": \"m\", \"back\": \"m\"},|;
         /leaf [1-9]/d" crown.json | sed "s|\"0.25/2\"|0.125|g; s|\"0.5/2\"|0.25|g" > balcony.json
    for scene in crown balcony; do
      { "$program" factors $scene.json --quiet | sed -n 's/^road,sky,\([^,]*\),.*/road \1/p'
        "$program" visibility $scene.json --on road --at 1/2 --quiet | awk '$1 == "sky" { print "middle", $2 }'; } |
        awk -v h=$h -v leaf=$leaf -v scene=$scene '
          function far(x0, y0, x1, y1) { return sqrt((x1 - x0)^2 + (y1 - y0)^2) }
          function sine(x, y) { return (x - 0.5) / far(0.5, 0, x, y) }  # of the angle from upright, seen from the middle
          function check(value, expected) {
            if ((value - expected)^2 > 1e-28) { print scene, h, leaf ": " value " instead of " expected; exit 1 }
          }
          BEGIN {
            road = sqrt(1 + h*h) - h; middle = sine(1, h)
            if (scene == "crown")
              for (k = 0; 0.3 + (2 * k + 1) * leaf < 0.7; ++k) {
                a = 0.3 + 2 * k * leaf; b = a + leaf
                road -= (far(0, 0, b, h) + far(1, 0, a, h) - far(0, 0, a, h) - far(1, 0, b, h)) / 2
                middle -= (sine(b, h) - sine(a, h)) / 2
              }
            else {
              road = (2 * far(0, 0, 1, h) - far(0, 0, 0.1, h/2) - far(0.1, h/2, 0, h) - h) / 2
              left = sine(0, h) > sine(0.1, h/2) ? sine(0, h) : sine(0.1, h/2)
              middle = (sine(1, h) - left) / 2
            }
          }
          $1 == "road" { check($2, road); ++n }
          $1 == "middle" { check($2, middle); ++n }
          END { exit n != 2 }' || fail "a $scene in a street of height $h, leaves of $leaf"
    done
  done
done

# In the street of the night, balconies and tree and all: from a place on the road the sky is what no edge covers of the
# sines of the angles from upright, by sorting all of them.
for place in 1/24 1/4 1/2 17/24 23/24; do
  seen=$("$program" visibility "$sources/scenes/heat/street_canyon.json" --on road --at $place --quiet | awk '$1 == "sky" { print $2 }')
  tr -d '"' < "$sources/scenes/heat/street_canyon.json" | awk -v place=$place -v seen="$seen" '
    function number(text,   part) { return split(text, part, "/") == 2 ? part[1] / part[2] : text + 0 }
    function sine(px, py) { return (px - x) / sqrt((px - x)^2 + py^2) }
    BEGIN { x = 12 * (1 - number(place)); n = 0 }
    /points:/ && !/name: road/ {
      sub(/.*points: *\[\[/, ""); sub(/\]\].*/, ""); gsub(/\], *\[/, ","); split($0, c, ",")
      a = sine(number(c[1]), number(c[2])); b = sine(number(c[3]), number(c[4]))
      low[n] = a < b ? a : b; high[n++] = a < b ? b : a
    }
    END {
      for (i = 1; i < n; ++i)
        for (j = i; j > 0 && low[j] < low[j - 1]; --j) {
          t = low[j]; low[j] = low[j - 1]; low[j - 1] = t; t = high[j]; high[j] = high[j - 1]; high[j - 1] = t
        }
      free = 0; end = -1
      for (i = 0; i < n; ++i) {
        if (low[i] > end) free += low[i] - end
        if (high[i] > end) end = high[i]
      }
      free = (free + 1 - end) / 2
      if (n != 21 || (seen - free)^2 > 1e-28) { print place ": " seen " instead of " free; exit 1 }
    }' || fail "the sky over the road at $place"
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
