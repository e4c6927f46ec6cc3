# Steps that are never silent: sourced by `run` and by the scripts that it calls, from the root.

readonly STALL=7       # seconds of silence after which a step says that it is still at work
readonly JOB_KIB=1572864  # memory for one compiler: the heaviest files take about 1.5 GiB

say() { printf '== %s\n' "$*"; }

die() {
  local status=$1
  shift
  printf 'run: %s\n' "$*" >&2
  exit "$status"
}

# Copies standard input to standard output and adds a line whenever nothing came for STALL seconds.
relay() {
  local name=$1 begun=$SECONDS part='' line status
  while true; do
    status=0
    IFS= read -r -t "$STALL" line || status=$?
    part+=$line
    if ((status == 0)); then
      printf '%s\n' "$part"
      part=''
    elif ((status > 128)); then # timed out: what was read of the line so far is kept
      printf '   %s: still at work, %d s\n' "$name" $((SECONDS - begun))
    else
      [[ -z $part ]] || printf '%s\n' "$part"
      return 0
    fi
  done
}

# step NAME COMMAND...: runs the command without input, never silent for long; keeps its status.
step() {
  local name=$1
  shift
  "$@" 2>&1 </dev/null | relay "$name"
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

# build PRESET TARGET...
build() {
  local preset=$1
  shift
  step "build $preset" env NINJA_STATUS='[%f/%t, %es] ' \
    cmake --build --preset "$preset" --parallel "$(count_jobs)" --target "$@" ||
    die 3 "the build of preset $preset failed"
}
