#!/usr/bin/env bash
# clang-format over all sources, then clang-tidy over all folders, or over those named (tools/lint.sh src/load tests/cli).
# Changes nothing; says of each folder whether it is clean, and fails at the end if one is not.
# A folder goes through clang-tidy as one source that includes all of its own: headers are most of the work, and so are
# read once. Files whose code is made for several instruction sets (src/bvh, src/trace) go one by one.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh
cmake --preset lint >/dev/null
cmake --build build/lint --target src/gpu/spirv_modules.cpp >/dev/null # the one source that is made
clean=true
if git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run --Werror; then
    echo "clang-format: clean"
else
    clean=false
fi

# A line for each source: its folder and its path.
units() {
    sed -n 's/^ *"file": "\(.*\)",*$/\1/p' build/lint/compile_commands.json | sort -u | grep -v vkbake_test_headers | sed -E "
        s|^($PWD/build/lint/(tools/.*)/CMakeFiles/.*)$|\2 \1|; t
        s|^(.*/vkbake_pipeline\.dir/.*)$|src \1|; t
        s|^(.*/vkbake_([a-z_]+)\.dir/.*)$|src/\2 \1|; t
        s|^(.*/test_unit_([a-z_]+)\.dir/.*)$|tests/unit/\2 \1|; t
        s|^(.*/test_([a-z_]+)\.dir/.*)$|tests/\2 \1|; t
        s|^($PWD/(.*))$|\2 \1|"
    for file in tests/consumer/*.cpp; do
        echo "$file $file"
    done
}

wanted() {
    if [ $# -eq 0 ]; then
        cat
    else
        grep -E "$(printf '^%s[ /]|' "$@" | sed 's/|$//')"
    fi
}

check() {
    local flags=(-p build/lint --extra-arg=-Wno-unknown-warning-option) # some are GCC's alone
    local log
    log=$(mktemp)
    if [[ $1 == tests/consumer/* ]]; then
        flags=(--extra-arg=-std=c++20 --extra-arg=-Iinclude) # no target of ours compiles a stranger's project
    elif [[ $2 == */Unity/* ]]; then
        flags+=(--checks=-bugprone-suspicious-include) # of .cpp: what such a source is for
    fi
    # What is not about a source is said on standard error: counts of what was suppressed.
    if nice clang-tidy "${flags[@]}" --quiet "$2" >"$log" 2>"$log.error" && ! grep -q 'warning:' "$log"; then
        echo "$1: clean"
        rm "$log" "$log.error"
        return 0
    fi
    { cat "$log"; grep -v 'generated\.$\|treated as error\|^Error while processing' "$log.error" || true; } |
        sed "s|^|$1: |"
    rm "$log" "$log.error"
    return 1
}
export -f check

# A folder takes up to 2 GB: no more at a time than there is memory for.
jobs=$(nproc)
room=$(awk '/MemAvailable/ { print int($2 / 2000000) }' /proc/meminfo)
if [ "$room" -lt "$jobs" ]; then
    jobs=$((room > 0 ? room : 1))
fi
units | wanted "$@" | xargs -L 1 -P "$jobs" bash -c 'check "$0" "$1"' || clean=false
if ! $clean; then
    echo "not clean" >&2
    exit 1
fi
echo "clean"
