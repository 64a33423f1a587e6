#!/usr/bin/env bash
# Sets everything up, bakes the storage room under the built-in sky and draws it.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh
cmake --preset release -DCMAKE_UNITY_BUILD=ON -DVKBAKE_TESTS=OFF -DVKBAKE_TOOLS=OFF >/dev/null
cmake --build --preset release
vkbake=build/release/src/cli/vkbake

# Half the default side leaves time for three times the rays: a smoother picture at less work.
"$vkbake" bake scenes/storage-room.glb -o out/storage-room --size 512 --rays 768
"$vkbake" render out/storage-room -o out/storage-room.png
"$vkbake" render out/storage-room --light-only -o out/storage-room-light.png >/dev/null
echo
echo "the picture:     $PWD/out/storage-room.png"
echo "the light alone: $PWD/out/storage-room-light.png"
echo "the baked scene: $PWD/out/storage-room/storage-room.glb"
echo "its light map:   $PWD/out/storage-room/lightmaps"
