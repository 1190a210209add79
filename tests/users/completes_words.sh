#!/usr/bin/env bash
# Someone types half a word and presses the tabulator key: words and options are those of the program.
# Run as: completes_words.sh HOTTEL SOURCE, in a folder of its own.
set -euo pipefail
hottel=$1 source=$2

source "$source/cli/completion/hottel"
# completed WORD...: what bash offers for the last word, one a line.
completed() {
  COMP_WORDS=(hottel "$@") COMP_CWORD=$# COMPREPLY=()
  _hottel "$hottel"
  printf '%s\n' "${COMPREPLY[@]}" | sort
}
expect() {
  [[ $1 == "$2" ]] || { echo "completed: $1"; echo "expected: $2"; exit 1; }
}

expect "$(completed fac)" factors
expect "$(completed 'c')" "$(printf 'check\ncompare\nconvert')"
[[ $(completed '' | wc -l) -eq $(($("$hottel" --help | sed '1,/^Subcommands:/d' | grep -cE '^  [a-z]') + 2)) ]]
expect "$(completed factors --guar)" --guarantee
expect "$(completed factors --guarantee e)" "$(printf 'enclosed\nestimated')"
expect "$(completed solve scene.json --light-l)" --light-levels
touch scene_of_mine.json
expect "$(completed solve scene_of)" scene_of_mine.json
