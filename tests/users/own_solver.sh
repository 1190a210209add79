#!/bin/sh -e
# A researcher with view factors of a program of his own: how wrong are they, where, and why?
#
#   tests/users/own_solver.sh PROGRAM SOURCES        works in the current folder
program=$(realpath "$1")
scene=$(realpath "$2")/scenes/analytic/strip_obstructed.json
fail() { echo "own_solver: $*" >&2; exit 1; }

# The program of his own is off by one per cent everywhere.
"$program" factors "$scene" --quiet -o exact.csv
awk -F, 'BEGIN { OFS = "," } NR == 1 { print $1, $2, $3 } NR > 1 { print $1, $2, sprintf("%.17g", 1.01 * $3) }' \
  exact.csv > own.csv
"$program" compare "$scene" --methods exact,file:own.csv,rays:1024 --repeat 1 -o compared 2> said

# Its worst error is a hundredth of the largest factor; it has no time; rows sum to 1.01.
awk -F, 'NR == FNR { if (FNR > 1 && $3 > most) most = $3; next }
         $1 == "file:own.csv" { seen = 1; e = $4 - most / 100; c = $6 - 0.01
                                if ($3 != "" || e*e > 1e-30 || c*c > 1e-28) { print $0; exit 1 } }
         $1 == "exact" && ($3 == "" || $4 != 0) { print $0; exit 1 }
         END { exit !seen }' exact.csv compared/compare.csv || fail "compare.csv says something else"
if grep -q 'reaches it, file' said; then fail "a file is called fast"; fi
grep -q '^file:own.csv: ' said || fail "there is no verdict: $(cat said)"
grep -q '^file:own.csv,' compared/worst.csv || fail "the worst pairs are not named"

# By a name of its own, over the pairs it has: no sky, no row of one face.
grep -v ',sky,' own.csv | grep -v '^bottom,' > part.csv
"$program" compare "$scene" --methods exact,mine=file:part.csv --repeat 1 -o compared 2> said
grep -q '^mine,estimated,,' compared/compare.csv || fail "it is not called by its name"
grep -q "there is no row of 'bottom'" said || fail "a row that is missing is not told: $(cat said)"

# Its light on a grid, here the exact one.
scene=$(realpath "$2")/scenes/analytic/square_radiosity.json
"$program" solve "$scene" --quiet --grid 8x6 --no-picture -o solved
"$program" compare "$scene" --grid-file solved/illumination.npy --repeat 1 -o compared 2> said
awk -F, 'NR == 2 && $5 != 0 { print $0; exit 1 }' compared/grid.csv || fail "the exact light is off"

# How fast does it converge? It is told the division by {elements}.
"$program" compare "$scene" --divide 1,2,4 --repeat 1 -o compared \
  --methods "mine=run:$program factors {scene} --per element --elements {elements} --method center --quiet -o {out}" 2> said
[ "$(grep -c ',mine,' compared/divide.csv)" = 3 ] || fail "divide.csv has not three divisions of it"

# His counter of rays is unbiased. Another one loses a fifth of what hits one face: it is named.
scene=$(realpath "$2")/scenes/showcase/museum.json
"$program" factors "$scene" --method rays:4000 --quiet -o counter.csv
awk -F, 'BEGIN { OFS = "," } NR > 1 && $2 == "hall_2[0]" { $3 = sprintf("%.17g", 0.8 * $3) } { print $1, $2, $3 }' \
  counter.csv > leaky.csv
"$program" compare "$scene" --methods file:counter.csv --repeat 1 -o compared 2> said
grep -q 'as about 4[0-9]* random rays a face would give, unbiased' said || fail "rays are not recognised: $(cat said)"
"$program" compare "$scene" --methods file:leaky.csv --repeat 1 -o compared 2> said
grep -q "but biased: .*hits on 'hall_2' are short by 20 %" said || fail "a leak is not found: $(cat said)"
