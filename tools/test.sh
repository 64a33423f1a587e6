#!/usr/bin/env bash
# Sets everything up and runs all tests: optimised, then under the address and undefined-behaviour sanitizers.
# The Vulkan validation layers (synchronization validation too) are on throughout: any message fails its test.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh
export VKBAKE_VALIDATION=1
jobs=$(nproc)
tools=ON # scene makers: no part of what is installed, so they are not built again for the sanitizers
for preset in release asan-ubsan; do
    echo "== $preset"
    cmake --preset "$preset" -DCMAKE_UNITY_BUILD=ON -DVKBAKE_TESTS=ON -DVKBAKE_TOOLS="$tools" \
        -DVKBAKE_BENCHMARKS=OFF >/dev/null # no test needs them; tools/lint.sh reads them
    cmake --build --preset "$preset" -j "$jobs"
    ctest --preset "$preset" -j "$jobs"
    tools=OFF
done
