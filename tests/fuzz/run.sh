#!/bin/sh
# Runs fuzzers: tests/fuzz/run.sh BUILD SECONDS [TARGET...]. New inputs and findings stay in BUILD/fuzz/TARGET. Prints
# for each target its executions, coverage (edges) and findings. Exit: 0 nothing found, 1 something found.
set -u
build=$(cd "$1" && pwd) || exit 2  # a target may change its folder
seconds=$2
shift 2
source=$(cd "$(dirname "$0")/../.." && pwd)
[ $# -gt 0 ] || set -- transfer checkpoint scene stage parts plan table identify image light report splats density command

# The longest input, in bytes: short ones run often.
longest() {
  case $1 in
    transfer) echo 8192 ;;
    checkpoint | image | plan | splats) echo 4096 ;;
    command) echo 16 ;;
    *) echo 2048 ;;
  esac
}

# How inputs are chosen: command lines add features so often that counting the rare ones costs an eighth of the time.
schedule() {
  case $1 in
    command) echo 0 ;;
    *) echo 1 ;;
  esac
}

# For speed: short traces of allocations, a small quarantine, memory as it comes. Leaks are found where test_fuzz replays the inputs.
export ASAN_OPTIONS=malloc_context_size=1:quarantine_size_mb=8:max_malloc_fill_size=0:detect_leaks=0
found=0
for target in "$@"; do
  work=$build/fuzz/$target
  mkdir -p "$work/inputs" "$work/findings"
  nice -n 19 "$build/bin/fuzz_$target" -seed=1 -max_total_time="$seconds" -max_len="$(longest "$target")" -timeout=60 \
    -entropic="$(schedule "$target")" \
    -rss_limit_mb=4096 -detect_leaks=0 -reload=0 -close_fd_mask=3 -print_final_stats=1 \
    -artifact_prefix="$work/findings/" "$work/inputs" "$source/tests/data/fuzz/$target" > "$work/log" 2>&1 || found=1
  printf '%s: %s executions, %s, %s findings\n' "$target" \
    "$(sed -n 's/stat::number_of_executed_units: *//p' "$work/log")" \
    "$(sed -n 's/.*\(cov: [0-9]*\).*/\1/p' "$work/log" | tail -n 1)" "$(ls "$work/findings" | wc -l)"
done
exit $found
