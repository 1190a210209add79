#!/bin/sh -e
# Cells that are a patch on a panel, and a window and a door that are patches on the walls of a drawing, checked by hand:
# docs/heat.md tells how.
#
#   tests/users/panel_with_cells.sh PROGRAM SOURCES        works in the current folder
program=$(realpath "$1")
sources=$(realpath "$2")
fail() { echo "panel_with_cells: $*" >&2; exit 1; }

"$program" solve "$sources/scenes/heat/panel_with_cells.json" -o panel --no-picture 2> said.txt
# Areas of what is left, and the net flux of the back, which sees the sky alone: 2 m2 at 300 K, of emissivity 0.9.
awk -F, '
  $1 == "panel" { n += ($4 == 1.04) } $1 == "panel:back" { n += ($4 == 2) } $1 == "cells" { n += ($4 == 0.96) }
  END { exit n != 3 }' panel/radiosity.csv || fail "areas: $(cut -d, -f1,4 panel/radiosity.csv)"
awk -F, '
  BEGIN { sigma = 5.670374419e-8 }
  $1 == "face" && $2 == "panel:back" { d = $5 - 2 * 0.9 * sigma * (300^4 - 3^4); n = d * d < 1e-18 }
  END { exit !n }' panel/flux.csv || fail "the net flux of the back: $(grep back panel/flux.csv)"

# Without the panel the cells radiate as much as on it: what they see is the same.
sed -e '/"name": "panel"/d' -e 's/, "on": "panel"//' "$sources/scenes/heat/panel_with_cells.json" > alone.json
"$program" factors "$sources/scenes/heat/panel_with_cells.json" --quiet | grep '^cells,shield,' > on.txt
"$program" factors alone.json --quiet | grep '^cells,shield,' > alone.txt
[ "$(cut -d, -f3 on.txt | cut -c1-14)" = "$(cut -d, -f3 alone.txt | cut -c1-14)" ] || fail "$(cat on.txt alone.txt)"

# The room of the drawing is 800 by 600; the window is 250 long and the door 200.
"$program" factors "$sources/scenes/drawings/room_with_window.svg" -o room.mtx --quiet
awk -F, '
  $2 == "window" { n += ($4 == 250) } $2 == "door" { n += ($4 == 200) }
  $2 == "room[3]" { n += ($4 == 350) } $2 == "room[2]" { n += ($4 == 600) } $2 == "room[0]" { n += ($4 == 800) }
  END { exit n != 5 }' room.mtx.faces.csv || fail "lengths: $(cut -d, -f2,4 room.mtx.faces.csv)"
