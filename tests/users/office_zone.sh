#!/bin/sh -e
# A zone of an office with a window in its frame and a heated part of its floor, checked by hand: docs/heat.md tells how.
#
#   tests/users/office_zone.sh PROGRAM SOURCES        works in the current folder
program=$(realpath "$1")
scene=$(realpath "$2")/scenes/heat/office_zone.json
fail() { echo "office_zone: $*" >&2; exit 1; }

"$program" solve "$scene" -o office --no-picture 2> said.txt
awk -F, '
  $1 == "frame" { n += ($4 == 0.86) } $1 == "south" { n += ($4 == 9) } $1 == "floor" { n += ($4 == 8) }
  END { exit n != 3 }' office/radiosity.csv || fail "areas: $(cut -d, -f1,4 office/radiosity.csv)"
# What is supplied, and what all faces lose and gain together.
awk -F, '
  $1 == "face" { all += $5 } $1 == "face" && $2 == "heated" { n = ($6 <= 720 && 720 <= $7) }
  END { exit !(n && all * all < 1e-16) }' office/flux.csv || fail "net fluxes: $(cat office/flux.csv)"

# The matrix to six digits: rows are 1, and the floor as a whole sees the ceiling as one rectangle sees another.
"$program" factors "$scene" --digits 6 --rows fronts -o factors.csv --quiet
awk -F, '
  function atan(x) { return atan2(x, 1) }
  function parallel(x, y,  u, v) {
    u = sqrt(1 + x * x); v = sqrt(1 + y * y)
    return 2 / (4 * atan(1) * x * y) * (log(u * v / sqrt(1 + x * x + y * y)) + x * v * atan(x / v) + y * u * atan(y / u) - \
                                        x * atan(x) - y * atan(y))
  }
  function off(a, b) { return a > b ? a - b : b - a }
  NR > 1 { sum[$1] += $3; if (length($3) > 13) bad = $3 }
  $2 == "ceiling" { f[$1] = $3 }
  END {
    for (row in sum) { ++rows; if (off(sum[row], 1) > 1e-5) bad = row }
    exit bad != "" || rows != 9 || off((8 * f["floor"] + 12 * f["heated"]) / 20, parallel(5 / 2.7, 4 / 2.7)) > 1e-6
  }' factors.csv || fail "factors: $(cat factors.csv)"

# What a seat in the middle of the room receives of all around.
printf 'x,y,z,nx,ny,nz\n2.5,2,1.1,0,-1,0\n' > seat.csv
"$program" visibility "$scene" --points seat.csv --quiet > seen.csv
awk -F, 'NR == 2 { n = ($10 > 295.3 && $10 < 295.4) } END { exit !n }' seen.csv || fail "the seat: $(cat seen.csv)"
