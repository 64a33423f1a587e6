#!/usr/bin/env bash
# Beside Blender's Cycles: do both see the same light, and what does either take for the same error?
#   tools/cycles.sh FOLDER [SKY.hdr]
# FOLDER holds scenes with light-map UVs and maps that Cycles baked of them: SCENE.glb, SCENE.ao.exr (visibility) and,
# with a sky, SCENE.SKY.exr (E/π, direct). The second table needs Blender (apt-get install blender python3-numpy).
set -euo pipefail
folder=$(realpath "$1")
sky=${2:+$(realpath "$2")}
cd "$(dirname "$0")/.."

tools/setup.sh
cmake --preset release -DVKBAKE_TOOLS=ON -DVKBAKE_BENCHMARKS=ON >/dev/null
cmake --build --preset release --target vkbake_against_cycles vkbake >/dev/null
declare -A sky_of=([ao]=ao)
[ -z "$sky" ] || sky_of[$(basename "$sky" .hdr)]=$sky
cases=()
for scene in "$folder"/*.glb; do
    for light in "${!sky_of[@]}"; do
        [ ! -e "${scene%.glb}.$light.exr" ] || cases+=("$(basename "$scene" .glb) $light")
    done
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo "$(nproc) cores, $(grep -m1 'model name' /proc/cpuinfo | cut -d: -f2 | xargs); commit $(git rev-parse --short HEAD 2>/dev/null || echo unknown)"
echo
echo "Our maps, averaged over the half texel that Cycles averages over, against its own:"
echo
echo "| map | texels | mean, ours / theirs − 1 | relative RMSE | without the worst 1 % | median | further off than 5 % | not finite |"
echo "|---|---|---|---|---|---|---|---|"
for case in "${cases[@]}"; do
    read -r name light <<<"$case"
    build/release/tools/accuracy/vkbake_against_cycles "$folder/$name.glb" "$folder/$name.$light.exr" "${sky_of[$light]}" 64
done

command -v blender >/dev/null || exit 0
# A map of 512², and the file it is in.
bake() { # NAME LIGHT RAYS SEED
    local flags=(--mode ao)
    [ "$2" = ao ] || flags=(--sky "$sky")
    build/release/src/cli/vkbake bake "$folder/$1.glb" --uv trust --size 512 --rays "$3" --seed "$4" "${flags[@]}" \
        --quiet -o "$work/$1-$2-$3-$4"
}
map_of() { ls "$work/$1"/lightmaps/*.exr; }
error_of() { # MAP REFERENCE
    build/release/src/cli/vkbake compare "$2" "$1" --json |
        python3 -c 'import json, sys; print(json.load(sys.stdin)["relative_luminance_rmse"])'
}
seconds_of() { # COMMAND…
    local start
    start=$(date +%s.%N)
    "$@" >/dev/null
    python3 -c "print(f'{$(date +%s.%N) - $start:.2f}')"
}
echo
echo "Seconds: of vkbake the whole program, of Cycles its bake call. Errors of vkbake against its own map"
echo "of 8192 rays; what error Cycles leaves with its samples is not measured here."
echo
echo "| map | rays | vkbake, seconds | relative RMSE | Cycles, 256 samples, seconds | Cycles / vkbake |"
echo "|---|---|---|---|---|---|"
for case in "${cases[@]}"; do
    read -r name light <<<"$case"
    bake "$name" "$light" 8192 1
    theirs=$(blender -b -P tools/accuracy/cycles_bake.py -- "$folder/$name.glb" 512 "${sky_of[$light]}" 256 |
        awk '/cycles-seconds/ { print $2 }')
    for rays in 16 32 64 128 256 512; do
        ours=$(seconds_of bake "$name" "$light" "$rays" 0)
        error=$(error_of "$(map_of "$name-$light-$rays-0")" "$(map_of "$name-$light-8192-1")")
        python3 -c "print(f'| $name.$light | $rays | $ours | {100 * $error:.2f} % | $theirs | {$theirs / $ours:.1f} |')"
    done
done
