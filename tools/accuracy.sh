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
. tools/release.sh
build_release vkbake_accuracy -DVKBAKE_TOOLS=ON -DVKBAKE_BENCHMARKS=ON
machine_and_commit
echo
build/release/tools/accuracy/vkbake_accuracy "$size" "$skies" "${scenes[@]}"
