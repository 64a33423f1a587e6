#!/usr/bin/env bash
# The long form of tests/extremes: rays at the edges and corners of closed meshes in every instruction set, then the three
# readers of foreign files under libFuzzer and sanitizers. Writes a report page, build/extremes.md, and prints it.
#   tools/extremes.sh [RAYS [SECONDS]]      1000000000 rays; 600 seconds for each reader, 0: none
# What the fuzzers learn stays in build/fuzz/corpus for the next run; inputs at fault lie in build/fuzz/faults.
set -euo pipefail
cd "$(dirname "$0")/.."

rays=${1:-1000000000}
seconds=${2:-600}
status=0

trace_rays() {
    cmake --preset release -DVKBAKE_TOOLS=ON >/dev/null
    cmake --build --preset release --target vkbake_extremes >/dev/null
    build/release/tools/extremes/vkbake_extremes "$rays"
}

# What takes too long for every day, or too much memory.
run_long_tests() {
    cmake --preset release -DVKBAKE_TESTS=ON >/dev/null
    cmake --build --preset release --target test_extremes >/dev/null
    build/release/tests/test_extremes --gtest_also_run_disabled_tests --gtest_filter='*DISABLED*' | grep '^\[  \|^\[ *OK'
}

# One reader: a row of the table. Without entropic weights: for programs of many edges to count features for them takes
# longer than to read a file.
fuzz() {
    local log=build/fuzz/$1.log fault=no
    mkdir -p build/fuzz/corpus/"$1" build/fuzz/faults
    "build/fuzz/tools/fuzz/fuzz_$1" -entropic=0 -max_total_time="$seconds" -timeout=25 -rss_limit_mb=4096 -max_len=20000 \
        -dict=tools/fuzz/words.dict -artifact_prefix="build/fuzz/faults/$1-" -print_final_stats=1 \
        build/fuzz/corpus/"$1" tests/fuzz/corpus/"$1" >"$log" 2>&1 || fault="YES, see $log"
    echo "| $1 | $(awk '/number_of_executed_units/ { print $2 }' "$log") | $(find build/fuzz/corpus/"$1" -type f | wc -l) |" \
        "$(grep -ao 'cov: [0-9]*' "$log" | tail -1 | cut -c6-) | $seconds | $fault |"
    [ "$fault" = no ]
}

fuzz_all() {
    if ! command -v clang++ >/dev/null; then
        echo "Left out: clang is not installed (apt-get install clang)."
        return 1
    fi
    cmake --preset fuzz >/dev/null
    cmake --build --preset fuzz --target fuzz_scene fuzz_manifest fuzz_sky >/dev/null
    # A gigabyte that a file announces is to be refused, not to end the process; quarantined memory would hide the rest.
    export ASAN_OPTIONS=allocator_may_return_null=1:quarantine_size_mb=16
    export LSAN_OPTIONS="suppressions=$PWD/tests/lsan.supp:print_suppressions=0"
    echo "| reader | inputs read | kept | edges covered | seconds | crash, hang or leak |"
    echo "|---|---|---|---|---|---|"
    local failed=0
    for reader in scene manifest sky; do
        fuzz "$reader" || failed=1
    done
    return $failed
}

report() {
    echo "# Extremes, the long form"
    echo
    echo "$(nproc) cores, $(grep -m1 'model name' /proc/cpuinfo | cut -d: -f2 | xargs);" \
        "commit $(git rev-parse --short HEAD 2>/dev/null || echo unknown); $(date -u +%F)"
    echo
    echo "## Rays at shared edges and corners"
    echo
    trace_rays || status=1
    echo
    echo "## Tests that take too long for every day"
    echo
    run_long_tests || status=1
    if [ "$seconds" -gt 0 ]; then
        echo
        echo "## Readers of foreign files, fuzzed (libFuzzer, address and undefined-behaviour sanitizers)"
        echo
        fuzz_all || status=1
    fi
}

tools/setup.sh
mkdir -p build
report > >(tee build/extremes.md)
wait $! # for tee
exit $status
