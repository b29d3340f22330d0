#!/usr/bin/env bash
# Runs fuzz targets one after the other and prints one line for each: runs, findings, seconds.
#   tests/fuzz/campaign.sh BUILD MINUTES [TARGET...]          MINUTES are shared between the targets
#   tests/fuzz/campaign.sh BUILD --runs COUNT [TARGET...]     COUNT inputs for each target
# Logs, corpora and inputs that fail are in results/fuzz; the corpora are used again by later runs.
# Ends with 1 where something was found.
set -euo pipefail
cd "$(dirname "$0")/../.."

usage() {
  sed -n 's/^#   /  /p' tests/fuzz/campaign.sh >&2
  exit 2
}
all=(scene markup vtp ply stl obj mask compare solve)
[ $# -ge 2 ] || usage
build=$1
shift
runs=0 minutes=0
if [ "$1" = --runs ]; then
  [ $# -ge 2 ] || usage
  runs=$2
  shift
else
  minutes=$1
fi
shift
[[ $runs =~ ^[0-9]+$ && $minutes =~ ^[0-9]+$ && $((runs + minutes)) -gt 0 ]] || {
  echo "fuzz: expected a whole number of minutes above 0, or --runs and a number" >&2
  exit 2
}
targets=("$@")
[ $# -gt 0 ] || targets=("${all[@]}")
for target in "${targets[@]}"; do
  [ -x "$build/bin/fuzz_$target" ] || {
    echo "fuzz: found no target '$target' in $build, expected one of: ${all[*]}" >&2
    exit 2
  }
done
share=$((minutes * 60 / ${#targets[@]}))
most_findings=20 # of one target; then the rest of its share is not used

# The folders a target's inputs start from.
seeds_of() {
  echo tests/fuzz/found
  case "$1" in
    scene) printf '%s\n' tests/fuzz/seeds/scene benchmarks/cases/{rod,tube} ;;
    compare) printf '%s\n' tests/fuzz/seeds/{compare,vtp} ;;
    *) echo "tests/fuzz/seeds/$1" ;;
  esac
}
dictionary_of() {
  case "$1" in
    solve) echo tests/fuzz/dictionaries/scene.dict ;;
    *) echo "tests/fuzz/dictionaries/$1.dict" ;;
  esac
}

# A solve takes many branches, and half of the time would go into weighing how rare each is.
options_of() {
  case "$1" in
    solve) printf '%s\n' -entropic=0 -detect_leaks=0 ;;
  esac
}
# The solvers, which allocate much, are not checked for addresses.
checks_of() {
  case "$1" in
    solve) echo malloc_context_size=1:quarantine_size_mb=8 ;;
  esac
}

# The inputs that a log counts.
counted() { awk '/^stat::number_of_executed_units:/ { sum += $2 } END { print sum + 0 }' "$1"; }

# Whether the input that just failed is one that took long only because the machine was busy:
# libFuzzer's limit is wall time. Alone and in processor time it takes less than 10 s.
is_hang_of_the_machine() {
  local target=$1 slow
  slow=$(find results/fuzz/found -name "$target-timeout-*" -newer "$2" | head -1)
  [ -n "$slow" ] && (ulimit -t 10 && "$build/bin/fuzz_$target" -timeout=600 "$slow") &>/dev/null &&
    rm "$slow"
}

export OPENBLAS_NUM_THREADS=1 UBSAN_OPTIONS=print_stacktrace=1
total_findings=0
fuzz() {
  local target=$1 log=results/fuzz/$1.log corpus=results/fuzz/corpus/$1 found=results/fuzz/found
  local findings=0 begin=$SECONDS limit seeds options
  local -x ASAN_OPTIONS
  ASAN_OPTIONS=$(checks_of "$target")
  mkdir -p "$corpus" "$found"
  : >"$log"
  mapfile -t seeds < <(seeds_of "$target")
  mapfile -t options < <(options_of "$target")
  while [ "$findings" -lt "$most_findings" ]; do
    if [ "$runs" -gt 0 ]; then
      limit=$((runs - $(counted "$log")))
      [ "$limit" -gt 0 ] || break
      limit=-runs=$limit
    else
      limit=$((share - (SECONDS - begin)))
      [ "$limit" -gt 0 ] || break
      limit=-max_total_time=$limit
    fi
    # -max_len: a few times the largest seed. -reload=0: nobody else writes to the corpus.
    touch "$log.begin"
    if "$build/bin/fuzz_$target" "$limit" -timeout=10 -rss_limit_mb=2048 -max_len=8192 -reload=0 \
      -print_final_stats=1 -artifact_prefix="$found/$target-" -dict="$(dictionary_of "$target")" \
      "${options[@]}" "$corpus" "${seeds[@]}" >>"$log" 2>&1; then
      break
    fi
    is_hang_of_the_machine "$target" "$log.begin" || findings=$((findings + 1))
  done
  rm -f "$log.begin"
  total_findings=$((total_findings + findings))
  printf 'fuzz: %-8s %10d runs %4d findings %6d s\n' \
    "$target" "$(counted "$log")" "$findings" $((SECONDS - begin))
}

for target in "${targets[@]}"; do fuzz "$target"; done
[ "$total_findings" -eq 0 ] || {
  echo "fuzz: the inputs that failed: results/fuzz/found; what they did: results/fuzz/*.log"
  exit 1
}
