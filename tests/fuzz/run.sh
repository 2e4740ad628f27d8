#!/bin/sh
# Runs fuzzers: tests/fuzz/run.sh BUILD SECONDS [TARGET...]. New inputs and findings stay in BUILD/fuzz/TARGET. Prints
# for each target its executions, coverage (edges) and findings. Exit: 0 nothing found, 1 something found.
set -u
build=$1
seconds=$2
shift 2
source=$(cd "$(dirname "$0")/../.." && pwd)
[ $# -gt 0 ] || set -- transfer checkpoint scene stage parts table image report command
found=0
for target in "$@"; do
  work=$build/fuzz/$target
  mkdir -p "$work/inputs" "$work/findings"
  nice -n 19 "$build/bin/fuzz_$target" -seed=1 -max_total_time="$seconds" -timeout=300 -rss_limit_mb=4096 -max_len=20000 \
    -close_fd_mask=3 -print_final_stats=1 -artifact_prefix="$work/findings/" "$work/inputs" "$source/tests/data/fuzz/$target" \
    > "$work/log" 2>&1 || found=1
  printf '%s: %s executions, %s, %s findings\n' "$target" \
    "$(sed -n 's/stat::number_of_executed_units: *//p' "$work/log")" \
    "$(sed -n 's/.*\(cov: [0-9]*\).*/\1/p' "$work/log" | tail -n 1)" "$(ls "$work/findings" | wc -l)"
done
exit $found
