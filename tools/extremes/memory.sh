#!/usr/bin/env bash
# What bakes take at the most beside what `vkbake inspect` foretells (src/memory_plan.cpp): a table. Fails where one takes
# more.
#   tools/extremes/memory.sh SCENE SIZE… [-- FLAGS…]
set -euo pipefail
scene=$1
shift
sizes=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    sizes+=("$1")
    shift
done
shift || true
vkbake=$(dirname "$0")/../../build/release/src/cli/vkbake
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
echo "| scene | triangles | size | foretold, MiB | peak, MiB |"
echo "|---|---|---|---|---|"
for size in "${sizes[@]}"; do
    "$vkbake" inspect "$scene" --size "$size" "$@" --json >"$folder/said"
    python3 - "$vkbake" "$scene" "$size" "$folder" "$@" <<'PYTHON'
import json, os, sys
program, scene, size, folder, *flags = sys.argv[1:]
said = json.load(open(folder + "/said"))
child = os.fork()
if child == 0:
    os.execv(program, [program, "bake", scene, "--size", size, "--rays", "1", "--quiet", "--memory-limit", "1T",
                       "-o", folder + "/out", *flags])
_, status, usage = os.wait4(child, 0)
peak = usage.ru_maxrss >> 10 if status == 0 else None
foretold = said["memory"] >> 20
print(f"| {os.path.basename(scene)} | {said['triangles']} | {size} | {foretold} | {peak or 'failed'} |", flush=True)
sys.exit(peak is None or peak > foretold)
PYTHON
done
