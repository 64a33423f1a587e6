#!/usr/bin/env bash
# What a ray of a bake costs in instructions, by callgrind, and in which functions: mode ao beside a sky of one colour,
# which must run the same kernel. A count needs no quiet machine.
#   tools/kernel-cost.sh [SCENE [SIZE [RAYS]]]      scenes/four-cannons.glb 64 256
# Needs valgrind (apt-get install valgrind).
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/release.sh
build_release vkbake_cli
exec python3 - "${1:-scenes/four-cannons.glb}" "${2:-64}" "${3:-256}" <<'PYTHON'
import json, re, subprocess, sys, tempfile

scene, size, rays = sys.argv[1:4]
cases = {"ao": ["--mode", "ao"], "a white sky": ["--sky", "1,1,1"], "the clear sky": []}
kernel = re.compile(r"vkbake::(N_\w+::)?(TileTracer|TileRays|Visibility|BlockTraversal|TriangleAccelerator|add_\w+|trace_block|"
                    r"cosine_directions|set_directions|invert_\w+|set_lanes|BlockCaster)")


def bake(count, flags, folder):
    """Instructions of each function, and the rays."""
    out = f"{folder}/callgrind.out"
    subprocess.run(["valgrind", "-q", "--tool=callgrind", f"--callgrind-out-file={out}", "build/release/src/cli/vkbake", "bake", scene,
                    "--size", size, "--rays", str(count), "--threads", "1", "--quiet", "-o", folder + "/baked", *flags], check=True)
    lines = subprocess.run(["callgrind_annotate", "--threshold=100", "--show-percs=no", out], stdout=subprocess.PIPE, text=True, check=True).stdout
    cost = {}
    for line in lines.splitlines():
        found = re.match(r"\s*([\d,]+)\s+\S*?:(.*?)(\(.*)? \[", line)
        if found and kernel.match(found[2]):
            cost[found[2]] = cost.get(found[2], 0) + int(found[1].replace(",", ""))
    maps = json.load(open(folder + "/baked/manifest.json"))["light_maps"]
    return cost, sum(entry["rays"] for entry in maps)


costs = {}
for name, flags in cases.items():
    with tempfile.TemporaryDirectory() as folder:
        costs[name] = bake(int(rays), flags, folder)
functions = sorted({f for cost, _ in costs.values() for f in cost}, key=lambda f: -costs["ao"][0].get(f, 0))
print("| instructions a ray | " + " | ".join(costs) + " |\n|---|" + "---|" * len(costs))
row = lambda name, values: print(f"| {name} | " + " | ".join(f"{value:.2f}" for value in values) + " |")
for function in functions:
    values = [cost.get(function, 0) / count for cost, count in costs.values()]
    if max(values) >= 0.05:
        row(f"`{function}`", values)
row("all of these", [sum(cost.values()) / count for cost, count in costs.values()])
PYTHON
