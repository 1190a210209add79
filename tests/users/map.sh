#!/bin/sh -e
# A geometer with a map: rings with a hole from well-known text and from GeoJSON, what points see of it, exactly.
#
#   tests/users/map.sh PROGRAM SOURCES        works in the current folder
program=$(realpath "$1")
sources=$(realpath "$2")
fail() { echo "map: $*" >&2; exit 1; }

# A yard like an L. From (3/2, 1/2) the corner (1, 1) hides all beyond the line to (0, 2): 5/2 of 3 are seen.
echo 'POLYGON ((0 0, 2 0, 2 1, 1 1, 1 2, 0 2, 0 0))' > yard.wkt
echo '{"type": "Feature", "id": "yard", "properties": {"height": 3}, "geometry": {"type": "Polygon",
  "coordinates": [[[0, 2], [1, 2], [1, 1], [2, 1], [2, 0], [0, 0], [0, 2]]]}}' > yard.geojson
for map in yard.wkt yard.geojson; do
  "$program" visibility $map --at 3/2,1/2 --quiet | grep -q '^area 2.5$' || fail "the part of $map that is seen"
  "$program" visibility $map --at 1/2,1/2 --quiet | grep -q '^area 3$' || fail "$map is seen wholly"
  # Closed: every row sums to 1 without the sky.
  "$program" factors $map --quiet | awk -F, 'NR > 1 { if ($2 == "sky") exit 1; s[$1] += $3; n[$1] = 1 }
    END { for (f in n) if ((s[f] - 1)^2 > 1e-28) exit 1 }' || fail "$map is not closed"
done

# Many points at once, a line each of the polygon, and polygons for a map program.
printf '3/2,1/2\n1/2,1/2\n' | "$program" visibility yard.wkt --points - --quiet -o seen.geojson
grep -q '"FeatureCollection"' seen.geojson || fail "polygons as GeoJSON"

# A hole is solid: who stands in it sees nothing. A polygon seen from outside is a building.
echo 'POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))' > hall.wkt
"$program" visibility hall.wkt --at 3/2,3/2 --quiet | grep -q "in the solid 'polyline\[1\]'" || fail "the hole is not solid"
"$program" convert hall.wkt block.json --front outside --quiet
"$program" visibility block.json --at 1/2,1/2 --quiet | grep -q "in the solid 'polyline\[0\]'" || fail "the block is not solid"
"$program" visibility block.json --at 3/2,3/2 --quiet | grep -q '^area 1$' || fail "the courtyard is not free"

# A coast is the same on every machine; its islands are solid, its sea is closed. All sides of rings are lines of sight, and
# what the graph says is the same as one critical line for each pair, as every edge is a face of its own.
"$sources/tools/coastline" 5 1 > coast.wkt
[ "$(cksum < coast.wkt)" = "983757022 1477" ] || fail "the coast has changed"
"$program" visibility coast.wkt --graph -o graph.csv 2> said
grep -q '134 vertices; 757 pairs that see each other, 134 of them along edges' said || fail "the graph of the coast: $(cat said)"
awk -F, 'NR > 1 { if ($1 >= $2 || ($7 - sqrt(($5 - $3)^2 + ($6 - $4)^2))^2 > 1e-18 * $7^2) exit 1 }' graph.csv ||
  fail "lines of the graph"
"$program" visibility coast.wkt --events --quiet -o events.csv
[ "$(wc -l < events.csv)" = "$(wc -l < graph.csv)" ] || fail "as many critical lines as pairs"
"$program" factors coast.wkt --quiet | awk -F, '$2 == "sky" { exit 1 }' || fail "the sea is not closed"

# What is no wall is passed over and told with its line; where there is nothing else it is refused.
printf 'LINESTRING (0 0, 1 0)\nPOINT (1 1)\n' > point.wkt
"$program" factors point.wkt > point.csv 2> said || fail "a point beside a wall is refused"
[ "$(grep -c polyline point.csv)" = 1 ] || fail "a point is taken as a wall"
grep -q "1 point passed over at point.wkt:2" said || fail "a point is told as: $(cat said)"
printf '\nPOINT (1 1)\n' > point.wkt
if "$program" factors point.wkt 2> said; then fail "a point is taken as a wall"; fi
grep -q "point.wkt:2: 'POINT' has no walls" said || fail "a point is refused as: $(cat said)"
