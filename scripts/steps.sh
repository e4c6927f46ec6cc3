# Steps that are never silent and never chatter: sourced by `run` and by the scripts that it calls,
# from the root. What a step prints goes to out/logs/; the reader sees how far it is, and of a step
# that fails the end of its log.

readonly LOGS=out/logs
readonly TICK=1           # seconds between two looks at a log
readonly STALL=8          # seconds between two lines where there is no terminal
readonly TAIL=40          # lines of the log of a step that failed
readonly JOB_KIB=1572864  # memory for one compiler: the heaviest files take about 1.5 GiB

say() { printf '== %s\n' "$*"; }

die() {
  local status=$1
  shift
  printf 'run: %s\n' "$*" >&2
  exit "$status"
}

# has_live_line: whether one line can be written over again and again.
has_live_line() { [[ -t 1 && ${TERM:-dumb} != dumb && -z ${CI:-} ]]; }

# log_of NAME: the file that the step's output goes to.
log_of() { printf '%s/%s.log\n' "$LOGS" "${1//[^[:alnum:]._-]/-}"; }

# last_line LOG WIDTH: what the step said last, without what would move the cursor.
last_line() {
  tail -c 4096 "$1" | tr '\r' '\n' | sed '/^[[:space:]]*$/d' | tail -n 1 |
    sed 's/\x1b\[[0-9;]*[A-Za-z]//g' | tr -d '\000-\037' | cut -c "1-$2"
}

# watch_log NAME LOG: says how far the step is, until it is killed or the script that called is gone.
watch_log() {
  local name=$1 log=$2 begun=$SECONDS said=$SECONDS width=100 never
  exec {never}<> <(:) # reading from it waits, and starts no process that could be left behind
  has_live_line && width=$((${COLUMNS:-$(tput cols 2>/dev/null || echo 80)} - 1))
  while kill -0 $$ 2>/dev/null; do
    read -r -t "$TICK" -u "$never" || true
    local line="   $name: $((SECONDS - begun)) s"
    if has_live_line; then
      line+="  $(last_line "$log" "$width")"
      printf '\r\033[K%s' "${line:0:width}"
    elif ((SECONDS - said >= STALL)); then
      said=$SECONDS
      printf '%s  %s\n' "$line" "$(last_line "$log" "$width")"
    fi
  done
}

# show_tail LOG: what is seen of a step that failed.
show_tail() { tail -n "$TAIL" "$1" | sed 's/^/   | /'; }

# step NAME COMMAND...: runs the command without input, its output in the log; keeps its status. If
# it fails, the function that SHOW_FAILURE names shows of the log what matters.
step() {
  local name=$1 log status=0 begun=$SECONDS watcher show=${SHOW_FAILURE:-show_tail}
  unset SHOW_FAILURE # the caller's word for this step, not for what the step runs
  log=$(log_of "$1")
  shift
  { mkdir -p "$LOGS" && : >"$log"; } 2>/dev/null ||
    die 2 "cannot write $log: make $PWD/out a folder that you may write to, on a disk with room"
  watch_log "$name" "$log" &
  watcher=$!
  # In the foreground, so that Ctrl-C reaches it.
  "$@" >"$log" 2>&1 </dev/null || status=$?
  kill "$watcher" 2>/dev/null || true
  wait "$watcher" 2>/dev/null || true
  if has_live_line; then printf '\r\033[K'; fi
  if ((status == 0)); then
    printf '   %s: %d s\n' "$name" $((SECONDS - begun))
  else
    printf '   %s: FAILED with status %d after %d s; all that it said: %s\n' "$name" "$status" \
      $((SECONDS - begun)) "$log"
    "$show" "$log"
  fi
  return "$status"
}

# One job a core, as long as there is JOB_KIB of memory for each.
count_jobs() {
  local cores free_kib by_memory
  cores=$(nproc)
  free_kib=$(awk '/^MemAvailable/ {print $2}' /proc/meminfo 2>/dev/null || true)
  by_memory=$((${free_kib:-$((cores * JOB_KIB))} / JOB_KIB))
  ((by_memory >= 1)) || by_memory=1
  echo $((by_memory < cores ? by_memory : cores))
}

# configure PRESET
configure() {
  step configure cmake --preset "$1" || die 3 "cmake --preset $1 failed"
}

# build PRESET TARGET... Memory in large pages: clang takes a tenth less time.
build() {
  local preset=$1
  shift
  step "build $preset" env NINJA_STATUS='[%f/%t, %es] ' GLIBC_TUNABLES=glibc.malloc.hugetlb=1 \
    cmake --build --preset "$preset" --parallel "$(count_jobs)" --target "$@" ||
    die 3 "the build of preset $preset failed"
  # What an earlier tree built at another place is gone, so that no document can go on naming it.
  cmake --build --preset "$preset" -- -t cleandead >/dev/null
}
