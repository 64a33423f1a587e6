#!/usr/bin/env bash
# Measures what --target-error promises on the project's scenes, and on what else is named: a table for docs/accuracy.md.
# Takes some minutes a scene and sky.
#   tools/accuracy.sh [SIZE ['SKY[;SKY…]' [SCENE…]]]
set -euo pipefail
cd "$(dirname "$0")/.."

size=${1:-128}
skies=${2:-clear;1,1,1}
scenes=("${@:3}")
if [ ${#scenes[@]} -eq 0 ]; then
    scenes=(scenes/*.glb scenes/objects/*.glb)
fi
tools/setup.sh
cmake --preset release -DVKBAKE_TOOLS=ON -DVKBAKE_BENCHMARKS=ON >/dev/null
cmake --build --preset release --target vkbake_accuracy >/dev/null
echo "$(nproc) cores, $(grep -m1 'model name' /proc/cpuinfo | cut -d: -f2 | xargs); commit $(git rev-parse --short HEAD 2>/dev/null || echo unknown)"
echo
build/release/tools/accuracy/vkbake_accuracy "$size" "$skies" "${scenes[@]}"
