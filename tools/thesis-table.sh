#!/usr/bin/env bash
# The thesis's evaluation, made again: prints a table with its times and ours, and the errors. Takes some minutes.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh
cmake --preset release -DVKBAKE_TOOLS=ON -DVKBAKE_BENCHMARKS=ON >/dev/null
cmake --build --preset release --target vkbake_thesis_table >/dev/null
echo "machine: $(nproc) cores, $(grep -m1 'model name' /proc/cpuinfo | cut -d: -f2 | xargs); commit $(git rev-parse --short HEAD 2>/dev/null || echo unknown)"
build/release/tools/thesis_table/vkbake_thesis_table scenes
