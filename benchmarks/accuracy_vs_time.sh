#!/usr/bin/env bash
# What accuracy costs: runs all methods on ten scenes and writes the tables and plots of docs/accuracy.md anew. What
# stands between the lines `<!-- generated: NAME -->` and `<!-- end -->` is replaced, the rest of the page stays.
#
#   benchmarks/accuracy_vs_time.sh [BUILD]     BUILD holds hottel (and benchmarks/benchmark_discretisation, else its
#                                              table stays as it is); without it build/release
#   REPEAT=3 THREADS=1 AT_MOST=0.5             timed runs of each method; threads; seconds after which a family's sweep
#                                              goes no further
# Takes about five minutes on a quiet machine; what it computed is left in build/accuracy.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=${1:-build/release}
repeat=${REPEAT:-3} threads=${THREADS:-1} at_most=${AT_MOST:-0.5}
page=docs/accuracy.md
work=build/accuracy
mkdir -p "$work/tables"
hottel() { "$build/hottel" "$@"; }

# --- the scenes: name, words, file, options -------------------------------------------------------------------------

for view in short long; do
  for n in 200 500 2000; do
    hottel generate clutter --view $view --n $n --seed 1 --quiet -o "$work/clutter_${view}_$n.json"
  done
done
scenes=(
  "square_16|square room, 16 elements a side|scenes/analytic/square_radiosity.json|--elements 16"
  "square_64|square room, 64 elements a side|scenes/analytic/square_radiosity.json|--elements 64"
  "apartment|apartment|scenes/showcase/apartment.json|"
  "apartment_4|apartment, 4 elements an edge|scenes/showcase/apartment.json|--elements 4"
  "museum|museum|scenes/showcase/museum.json|"
  "maze|maze|scenes/showcase/maze.json|"
  "clutter_200|clutter of 200 edges|$work/clutter_short_200.json|"
  "clutter_2000|clutter of 2,000 edges|$work/clutter_short_2000.json|"
  "dense_200|dense clutter of 200 edges|$work/clutter_long_200.json|"
  "dense_500|dense clutter of 500 edges|$work/clutter_long_500.json|"
)
run() {  # name, file, options
  echo "$1" >&2
  # shellcheck disable=SC2086  # options are words
  hottel compare "$2" $3 --sweep --threads "$threads" --repeat "$repeat" --at-most "$at_most" -o "$work/$1" \
    2>"$work/$1.log" || { cat "$work/$1.log" >&2; exit 1; }
}
names=()
for scene in "${scenes[@]}"; do
  IFS='|' read -r name words file options <<<"$scene"
  names+=("$name")
  run "$name" "$file" "$options"
  echo "$words" >"$work/$name/words"
  grep -m1 'view factors;' "$work/$name.log" | sed 's/;.*//' >"$work/$name/size"
done

# --- tables -----------------------------------------------------------------------------------------------------------

# Functions that the tables share.
words_for_awk='
  function time(s) {
    return s >= 1 ? sprintf("%.3g s", s) : s >= 1e-3 ? sprintf("%.3g ms", 1e3 * s) : sprintf("%.3g µs", 1e6 * s)
  }
  function times(ratio) { return sprintf(ratio < 100 ? "%.2g" : "%.0f", ratio) }
  function is_exact_again(family) { return family ~ /^(exact|arithmetic)(:|$)/ }'

machine() {
  echo
  echo "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1), $threads thread(s), medians of $repeat runs," \
    "$(date -u +%Y-%m-%d), commit $(git rev-parse --short HEAD), load of the machine at the end $(cut -d' ' -f1 /proc/loadavg)."
}

# One row a scene: what exact takes, and what the cheapest approximation takes to each error, in multiples of that.
crossings() {
  echo
  echo "| scene | size | exact | error 1e-1 | error 1e-2 | error 1e-3 | error 1e-6 |"
  echo "|---|---|--:|--:|--:|--:|--:|"
  for name in "${names[@]}"; do
    awk -F, -v words="$(cat "$work/$name/words")" -v size="$(cat "$work/$name/size")" "$words_for_awk"'
      NR > 1 {
        exact = $4
        if (is_exact_again($2) || $3 == "") next
        if (!($1 in best) || $3 < best[$1]) { best[$1] = $3; whose[$1] = $2 }
      }
      function cell(e) { return e in best ? times(best[e] / exact) " × (" whose[e] ")" : "never" }
      END { print "| " words " | " size " | " time(exact) " | " cell("0.1") " | " cell("0.01") " | " cell("0.001") \
                  " | " cell("1e-06") " |" }' "$work/$name/readings.csv"
  done
}

# One row a method of a scene.
table() {  # name
  echo
  echo "| method | time | largest error | rms error | worst row | radiosity error |"
  echo "|---|--:|--:|--:|--:|--:|"
  awk -F, "$words_for_awk"'
    function number(x) { return x == "" ? "none" : x == "inf" ? "no solution" : x == 0 ? "0" : sprintf("%.2g", x) }
    NR > 1 { print "| `" $1 "` | " time($3) " | " number($4) " | " number($5) " | " number($6) " | " number($7) " |" }' \
    "$work/$1/compare.csv"
}

# What each family takes to an error, in multiples of what exact takes: one row a family, one column a scene.
reach() {  # error
  echo
  local files=()
  for name in "${names[@]}"; do files+=("$work/$name/readings.csv"); done
  awk -F, -v error="$1" "$words_for_awk"'
    FNR == 1 { column = FILENAME; sub(/\/readings.csv$/, "", column); sub(/.*\//, "", column); columns[++count] = column }
    FNR > 1 && $1 == error && !is_exact_again($2) {
      if (!($2 in known)) { known[$2] = 1; families[++rows] = $2 }
      if ($3 != "") cell[$2, column] = times($3 / $4)
    }
    END {
      line = "| family |"; rule = "|---|"
      for (c = 1; c <= count; ++c) { name = columns[c]; gsub(/_/, " ", name); line = line " " name " |"; rule = rule "--:|" }
      print line; print rule
      for (r = 1; r <= rows; ++r) {
        line = "| `" families[r] "` |"; reaches = 0
        for (c = 1; c <= count; ++c)
          if ((families[r], columns[c]) in cell) { line = line " " cell[families[r], columns[c]] " |"; reaches = 1 }
          else line = line "  |"
        if (reaches) print line; else nowhere = nowhere (nowhere == "" ? "" : ", ") "`" families[r] "`"
      }
      if (nowhere != "") print "\nNowhere: " nowhere "."
    }' "${files[@]}"
}

# What exactness costs: the same sweep in other arithmetic, times in multiples of plain doubles.
arithmetic() {
  echo
  echo "| scene | plain doubles | naive | bounds | rounded | exact | CGAL | error of plain doubles |"
  echo "|---|--:|--:|--:|--:|--:|--:|--:|"
  for name in "${names[@]}"; do
    awk -F, -v words="$(cat "$work/$name/words")" "$words_for_awk"'
      { seconds[$1] = $3; error[$1] = $4 }
      function cell(m) { return m in seconds ? times(seconds[m] / seconds["arithmetic:doubles"]) " ×" : "" }
      END {
        if (!("arithmetic:doubles" in seconds)) exit
        print "| " words " | " time(seconds["arithmetic:doubles"]) " | " cell("arithmetic:naive") " | " \
              cell("arithmetic:bounds") " | " cell("arithmetic:rounded") " | " cell("exact") " | " \
              cell("arithmetic:cgal") " | " sprintf("%.1g", error["arithmetic:doubles"]) " |"
      }' "$work/$name/compare.csv"
  done
}

# The claim of diagonal dominance: row sums of F = K/r² cos cos Vis on the unit square, in proportion to K; and beside
# it the kernel of the plane, which knows the length of what it looks at.
dominance() {
  echo
  echo "| elements a side | largest row sum, K = 1 | K up to which rows sum to at most 1 | largest row defect of \`center\` |"
  echo "|--:|--:|--:|--:|"
  for elements in 1 4 16 64; do
    hottel compare scenes/analytic/square_radiosity.json --elements $elements --repeat 1 --quiet -o "$work/dominance" \
      --methods center-vis:inverse-square=1,center
    awk -F, -v elements=$elements '
      NR == 2 { sum = $6 + 1 }
      NR == 3 { printf "| %d | %.3g | %.2g | %.2g |\n", elements, sum, 1 / sum, $6 }' "$work/dominance/compare.csv"
  done
}

# Degenerate scenes that naive predicates get wrong by more than rounding can explain.
naive() {
  echo
  echo "| scene | largest error, naive | largest error, plain doubles |"
  echo "|---|--:|--:|"
  hottel generate lattice --n 200 --seed 3 --quiet -o "$work/lattice_200.json"
  local scene count=0 wrong=0
  for scene in scenes/degenerate/*.json "$work/lattice_200.json"; do
    hottel compare "$scene" --repeat 1 --quiet -o "$work/naive" --methods arithmetic:naive,arithmetic:doubles
    ((++count))
    awk -F, -v scene="$(basename "$scene" .json)" '
      { error[$1] = $4 }
      END {
        if (error["arithmetic:naive"] <= 1e-9) exit 1
        printf "| %s | %.2g | %.1g |\n", scene, error["arithmetic:naive"], error["arithmetic:doubles"]
      }' "$work/naive/compare.csv" && ((++wrong))
  done
  echo
  echo "That is $wrong of $count scenes: those of \`scenes/degenerate\` and a lattice of 200 edges."
}

discretisation() {
  local csv=$work/discretisation.csv
  "$build/benchmarks/benchmark_discretisation" --benchmark_min_time=0.05 --benchmark_out="$csv" \
    --benchmark_out_format=csv >"$work/discretisation.log" 2>&1
  echo
  echo "| scene | elements an edge | pairs | time | error of means | order | rms error | order | largest error | order |"
  echo "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
  awk -F, '
    function plain(text) { gsub(/"/, "", text); return text }
    /^name,/ { for (k = 1; k <= NF; ++k) at[plain($k)] = k; next }
    /^"discretisation\// {
      split(plain($1), part, "/"); sub(/elements:/, "", part[3])
      order_of = part[3] > 1
      printf "| %s | %d | %d | %.3g ms | %.2g | %s | %.2g | %s | %.2g | %s |\n", part[2], part[3], $at["pairs"],
             $at["real_time"], $at["error_of_means"], order_of ? sprintf("%.2f", $at["order_of_means"]) : "",
             $at["rms_error"], order_of ? sprintf("%.2f", $at["order_rms"]) : "", $at["largest_error"],
             order_of ? sprintf("%.2f", $at["order_largest"]) : ""
    }' "$csv"
}

# --- the page ---------------------------------------------------------------------------------------------------------

tables=$work/tables
machine >"$tables/machine"
crossings >"$tables/crossings"
for name in apartment clutter_2000; do
  table $name >"$tables/$name"
  cp "$work/$name/compare.svg" "docs/images/accuracy_$name.svg"
done
reach 0.01 >"$tables/reach_1e-2"
reach 0.001 >"$tables/reach_1e-3"
arithmetic >"$tables/arithmetic"
dominance >"$tables/dominance"
naive >"$tables/naive"
if [[ -x $build/benchmarks/benchmark_discretisation ]]; then discretisation >"$tables/discretisation"; fi

awk -v tables="$tables" '
  /^<!-- end -->$/ { if (skipping) print ""; skipping = 0 }
  !skipping { print }
  /^<!-- generated: .* -->$/ {
    file = tables "/" $3
    if ((getline line < file) < 0) next
    skipping = 1
    do print line; while ((getline line < file) > 0)
    close(file)
  }' "$page" >"$work/page.md"
cp "$work/page.md" "$page"
echo "$page" >&2
