#!/bin/sh -e
# A street in the sun, and the same by night, in two bands, checked by hand: docs/heat.md tells how.
#
#   tests/users/street_by_day.sh PROGRAM SOURCES        works in the current folder
program=$(realpath "$1")
sources=$(realpath "$2")
fail() { echo "street_by_day: $*" >&2; exit 1; }

"$program" solve "$sources/scenes/heat/street_by_day.json" -o day --no-illumination 2> said.txt
# 13500 W/m of the sun meet faces: 3780 the road, 4860 the east wall, and 4860 the back of the west wall, which is black.
grep -q '"passed": null' day/report.json || fail "what of the sun passes by has a number"
awk -F, '$1 == "light" && $2 == "sun" && $3 == "solar" { d = $5 - (3780 + 4860 + 4860); ok = d * d < 1e-18 } END { exit !ok }' \
  day/flux.csv || fail "what of the sun meets faces"

sed -e 's/"solar": {"emission": 100}/"solar": {"emission": 0}/' -e '/"lights"/d' -e 's/"emission": 0}},$/"emission": 0}} }/' \
  "$sources/scenes/heat/street_by_day.json" > night.json
"$program" solve night.json -o night --no-illumination 2> said.txt

# The road sees the sky by sqrt(1 + (3/4)^2) - 3/4 = 1/2 and each wall by 1/4; a wall the road, the other wall and the sky
# by 1/3 each. SUN and SKY in W/m2: what the sun gives the road and the east wall, and what the bright sky sends.
by_hand() {
  awk -v of_road="$1" -v of_east="$2" -v bright="$3" 'BEGIN {
    sigma = 5.670374419e-8; cold = sigma * 280^4
    for (k = 0; k < 200; ++k) {  # solar: B = rho H
      hr = bright / 2 + (w + e) / 4 + of_road; hw = (bright + r + e) / 3; he = (bright + r + w) / 3 + of_east
      r = 0.1 * hr; w = 0.6 * hw; e = 0.6 * he
    }
    ar = 0.9 * hr; aw = 0.4 * hw; ae = 0.4 * he; r = w = e = cold
    for (k = 0; k < 200; ++k) {  # thermal: B = H + a
      r = cold / 2 + (w + e) / 4 + ar; w = (cold + r + e) / 3 + aw; e = (cold + r + w) / 3 + ae
    }
    printf "road %.12g\nwest %.12g\neast %.12g\n", ((r + ar * 0.05 / 0.95) / sigma)^0.25,
      ((w + aw * 0.1 / 0.9) / sigma)^0.25, ((e + ae * 0.1 / 0.9) / sigma)^0.25
  }'
}
compare() {
  awk -F'[, ]' 'NR == FNR { t[$1] = $2; next }
    $1 in t { d = $4 - t[$1]; if (d * d > 1e-16) { print $1 ": " $4 " instead of " t[$1]; exit 1 } ++n }
    END { exit n != 3 }' "$1" "$2" || fail "temperatures of $2 differ from those by hand"
}
by_hand 315 540 100 > by_day.txt   # the shadow of the west houses is 27/4 wide: 900 * 4/5 * (12 - 27/4) / 12; 900 * 3/5
by_hand 0 0 0 > by_night.txt
compare by_day.txt day/temperature.csv
compare by_night.txt night/temperature.csv
awk '{ d = $2 - 280; if (d * d > 1e-16) exit 1 }' by_night.txt || fail "without sun all is as cold as the sky"

# A day: the sun turns by 15 degrees an hour, and is back after 24 of them.
"$program" animate "$sources/scenes/heat/street_by_day.json" --frames 25 --fps 1 --size 200 --no-film -o film 2> said.txt
cmp film/frame_00000.png film/frame_00024.png || fail "after a day the light is another"
