# Sourced by scripts that run in stages: each stage is silent when it succeeds, and its minutes are printed.
# A stage that fails shows its output and ends the script.

stage_names=()
stage_seconds=()

# stage NAME COMMAND...: the output goes to build/log/NAME.log.
stage() {
  local name=$1 log start=$SECONDS
  shift
  mkdir -p build/log
  log="build/log/${name// /_}.log"
  printf '%-28s' "$name"
  if ! "$@" >"$log" 2>&1 </dev/null; then
    printf 'failed\n\n'
    cat "$log"
    return 1
  fi
  stage_names+=("$name")
  stage_seconds+=($((SECONDS - start)))
  minutes $((SECONDS - start))
}

# minutes SECONDS: "  1.5 min".
minutes() { printf '%3d.%d min\n' $(($1 / 60)) $(($1 % 60 / 6)); }
