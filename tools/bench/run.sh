#!/usr/bin/env bash
# Measures all benchmark scenes and prints one table: tools/bench/run.sh [SIZE…] (512 where none is given).
# What stands after -- goes to vkbake_bench_rays, e.g. -- --repeats 9 --verify 1000000.
# Results are kept in tools/bench/results. Scenes of others are taken from ../shared/data/scenes, where they are there.
set -euo pipefail
cd "$(dirname "$0")/../.."

sizes=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    sizes+=("$1")
    shift
done
if [ $# -gt 0 ]; then
    shift
fi
if [ ${#sizes[@]} -eq 0 ]; then
    sizes=(512)
fi

tools/setup.sh
cmake --preset release -DVKBAKE_TOOLS=ON -DVKBAKE_BENCHMARKS=ON -DCMAKE_UNITY_BUILD=ON >/dev/null
cmake --build --preset release --target make_scenes vkbake_bench_rays vkbake_bench_summary >/dev/null
tools=build/release/tools
made=build/release/bench-scenes
kept=tools/bench/results
results=build/release/bench-results # until all are there: kept ones that change would make the checkout a changed one
mkdir -p "$made" "$kept"
rm -rf "$results"
mkdir "$results"
"$tools/make_scenes/make_scenes" --benchmarks "$made"

scenes=("$made"/thesis-objects.glb "$made"/furnished-apartment.glb)
for size in 5k 20k 80k 320k 1m 2m; do
    scenes+=("$made/forest-$size.glb" "$made/grove-$size.glb")
done
for name in suzanne+ground japanese-bridge-garden city-diorama bunny+ground; do
    scenes+=("../shared/data/scenes/${name%+ground}.glb${name#"${name%+ground}"}")
done

for size in "${sizes[@]}"; do
    files=()
    for scene in "${scenes[@]}"; do
        file=${scene%+ground}
        options=()
        if [ "$file" != "$scene" ]; then
            options=(--ground)
        fi
        if [ ! -e "$file" ]; then
            echo "$file is not there: left out" >&2
            continue
        fi
        name=$(basename "$file" .glb)${options:+-ground}-$size
        echo "== $name" >&2
        "$tools/bench/rays/vkbake_bench_rays" "$file" "${options[@]}" --size "$size" --json "$results/$name.json" "$@" >"$results/$name.txt"
        files+=("$results/$name.json")
    done
    "$tools/bench/summary/vkbake_bench_summary" "${files[@]}" --plot "$results/forest-$size.svg" --family forest- | tee "$results/summary-$size.md"
    "$tools/bench/summary/vkbake_bench_summary" "${files[@]}" --plot "$results/grove-$size.svg" --family grove- >/dev/null
done
cp "$results"/* "$kept"
