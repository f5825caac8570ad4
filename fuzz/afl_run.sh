#!/bin/sh
# SPDX-License-Identifier: MIT
# AFL++ as a second opinion: builds the targets with its compiler and its driver for libFuzzer's entry, and runs one of them.
#
#   fuzz/afl_run.sh <target> <seconds>          apt: afl++
#
#   fuzz/afl_run.sh numbers 60
set -eu
target=$1
seconds=$2
here=$(cd "$(dirname "$0")" && pwd)
build=$here/../build/fuzz-afl
driver=$(find /usr/lib/afl /usr/local/lib/afl /usr/lib -name libAFLDriver.a 2>/dev/null | head -1)
AFL_QUIET=1 cmake -S "$here/.." -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER=afl-clang-fast++ -DINGOT_BUILD_FUZZ=ON \
    -DINGOT_BUILD_TESTS=OFF -DINGOT_BUILD_REPORT=OFF -DINGOT_FUZZ_SANITIZE=OFF -DINGOT_FUZZ_DRIVER="$driver" > /dev/null
AFL_QUIET=1 cmake --build "$build" --target "fuzz_$target"
corpus=$here/corpus_$target
[ -d "$corpus" ] || corpus=$here/corpus
rm -rf "$build/out_$target"
AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_UI=1 AFL_NO_AFFINITY=1 afl-fuzz -V "$seconds" -i "$corpus" -o "$build/out_$target" -- "$build/fuzz/fuzz_$target" > "$build/$target.log" 2>&1
grep -E 'execs_done|execs_per_sec|saved_crashes|saved_hangs|edges_found' "$build/out_$target/default/fuzzer_stats"
! grep -q 'saved_crashes *: *[1-9]' "$build/out_$target/default/fuzzer_stats"
