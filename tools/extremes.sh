#!/usr/bin/env bash
# The long form of tests/extremes. Prints a report: rays at the edges and corners of closed meshes in every instruction
# set, then damaged files for the readers of scenes, manifests and skies, the latter under sanitizers where asked.
#   tools/extremes.sh [RAYS [SECONDS [PRESET]]]      1000000000 rays, 600 seconds; PRESET: release or asan-ubsan
set -euo pipefail
cd "$(dirname "$0")/.."

rays=${1:-1000000000}
seconds=${2:-600}
preset=${3:-release}
tools/setup.sh
for each in release "$preset"; do
    cmake --preset "$each" -DVKBAKE_TOOLS=ON >/dev/null
    cmake --build --preset "$each" --target vkbake_extremes >/dev/null
done
echo "# Extremes, the long form"
echo
echo "$(nproc) cores, $(grep -m1 'model name' /proc/cpuinfo | cut -d: -f2 | xargs); commit $(git rev-parse --short HEAD 2>/dev/null || echo unknown)"
echo
echo "## Rays at shared edges and corners"
echo
build/release/tools/extremes/vkbake_extremes rays "$rays"
echo
echo "## Damaged files ($preset)"
echo
"build/$preset/tools/extremes/vkbake_extremes" damage "$seconds" "$(date +%s)000"
