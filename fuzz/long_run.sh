#!/bin/sh
# SPDX-License-Identifier: MIT
# All fuzz targets, one after another, for a number of executions each, and a table of what came of it.
#
#   fuzz/long_run.sh <folder of the targets> <executions of each> [<seconds of each> [<targets>]]
#
#   cmake --preset fuzz-fast && cmake --build --preset fuzz-fast && fuzz/long_run.sh build/fuzz-fast/fuzz 10000000
#
# New inputs go to <folder>/long/<target>; what breaks a promise to <folder>/long/<target>_*. Fails if there is one. A target ends at the first of the two
# bounds, or at a finding. AFL++ takes the same targets: see afl_run.sh.
set -u
folder=$1
runs=$2
seconds=${3:-0}
targets=${4:-numbers hull contacts drift world lanes snapshot friction rooms materials light fast joints drives}
here=$(dirname "$0")
found=0
printf '%-12s %14s %12s %9s\n' target executions per_second findings
for target in $targets; do
    case $target in
        numbers) len=80 ;;
        contacts) len=100 ;;
        drift) len=120 ;;
        hull) len=500 ;;
        snapshot) len=1500 ;;
        joints|drives) len=400 ;;
        *) len=600 ;;
    esac
    corpus=$here/corpus_$target
    [ "$target" != fast ] || corpus=$here/corpus_rooms
    [ "$target" != drives ] || corpus=$here/corpus_joints
    [ -d "$corpus" ] || corpus=$here/corpus
    mkdir -p "$folder/long/$target"
    log=$folder/long/$target.log
    "$folder/fuzz_$target" -runs="$runs" -max_total_time="$seconds" -max_len=$len -timeout=20 -rss_limit_mb=4096 -print_final_stats=1 -reduce_inputs=0 \
        -artifact_prefix="$folder/long/${target}_" "$folder/long/$target" "$corpus" > "$log" 2>&1
    findings=0
    if grep -aq 'Test unit written' "$log"; then findings=1; found=1; fi
    grep -aq number_of_executed_units "$log" || found=1
    printf '%-12s %14s %12s %9s\n' $target "$(awk '/number_of_executed_units/ {print $2}' "$log")" "$(awk '/average_exec_per_sec/ {print $2}' "$log")" $findings
    grep -a -m1 'broken promise\|runtime error\|ERROR' "$log"
done
exit $found
