#!/usr/bin/env bash
# Beside Blender's Cycles, light by light: the same scene, UVs and light, means and texels, and the noise of both.
#   tools/cycles-light.sh [SAMPLES [RAYS]]      of Cycles a texel: 1024; of ours: 256. Some minutes.
# Needs Blender (apt-get install blender python3-numpy).
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/release.sh
build_release vkbake_cli
echo "$(blender --version | head -1); commit $(commit_name)"
blender -b -noaudio -P tools/accuracy/cycles_light.py -- build/release/src/cli/vkbake "${1:-1024}" "${2:-256}" | grep '^|'
