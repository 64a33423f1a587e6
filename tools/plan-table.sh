#!/usr/bin/env bash
# What a bake pays for light that its scene has and for light that it lacks: seconds of tracing as planned, with every
# phenomenon forced on, and with the one that the scene is there to show off, which leaves an error. Then what a sky's
# picture costs beside a sky of one radiance, where every ray meets it.
#   tools/plan-table.sh [SIZE [RUNS]]      256; 3 runs by turns, of which the median counts
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/release.sh
build_release vkbake_cli
machine_and_commit
exec python3 - "${1:-256}" "${2:-3}" <<'PYTHON'
import json, math, os, statistics, subprocess, sys, tempfile

size, runs = sys.argv[1], int(sys.argv[2])
program = "build/release/src/cli/vkbake"
work = tempfile.TemporaryDirectory()


def sky_with_sun(file, sun):
    """A panorama, brighter upwards, with or without a sun of 1.4 by 0.7 degrees, 100,000 times as bright. Radiance RGBE, as it is."""
    width, height = 512, 256
    texels = bytearray()
    for row in range(height):
        for column in range(width):
            up = math.cos(math.pi * (row + 0.5) / height)
            value = 0.6 + 0.4 * up
            if sun and row == 70 and column in (300, 301):
                value = 1e5
            mantissa, exponent = math.frexp(value)
            texels += bytes([int(mantissa * 256)] * 3 + [exponent + 128])
    with open(file, "wb") as out:
        out.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width) + texels)
    return file


sunny = sky_with_sun(work.name + "/sunny.hdr", True)
plain = sky_with_sun(work.name + "/plain.hdr", False)
forced = {"--lamps": "on", "--sun": "on", "--alpha": "traced", "--bounces": "3"}
cases = [  # scene, what it is there to show, flags as planned, what leaves that out
    ("four-cannons", "a white sky", {"--sky": "1,1,1"}, None),
    ("four-cannons", "the clear sky", {}, None),
    ("four-cannons", "a sky's picture", {"--sky": plain}, None),
    ("four-cannons", "its sun", {"--sky": sunny}, {"--sky": plain}),
    ("lamps", "lamps", {}, {"--lamps": "off"}),
    ("pergola", "leaves and glass", {"--lamps": "off"}, {"--alpha": "opaque"}),
    ("storage-room", "bounces", {"--bounces": "3"}, {"--bounces": "0"}),
    ("pergola", "all of it", {"--sky": sunny, "--bounces": "3"},
     {"--bounces": "0", "--sky": plain, "--lamps": "off", "--alpha": "opaque"}),
]


def bake(scene, flags):
    """Its folder and the seconds that it traced."""
    folder = tempfile.mkdtemp(dir=work.name)
    words = [word for pair in flags.items() for word in pair]
    subprocess.run([program, "bake", f"scenes/{scene}.glb", "--size", size, "--quiet", "-o", folder, *words], check=True)
    return folder, sum(entry["seconds"] for entry in json.load(open(folder + "/manifest.json"))["timing"]["light_maps"])


def bake_by_turns(scene, variants):
    """Their folders and median seconds; by turns, so that what else the machine does hits all alike."""
    seconds = [[] for _ in variants]
    folders = [None for _ in variants]
    for _ in range(runs):
        for index, flags in enumerate(variants):
            folders[index], once = bake(scene, flags)
            seconds[index].append(once)
    return folders, [statistics.median(times) for times in seconds]


def error(of, reference):
    """Root-mean-square over all pages ÷ the mean over all pages."""
    texels = squares = total = 0.0
    for page in sorted(os.listdir(reference + "/lightmaps")):
        said = subprocess.run([program, "compare", f"{reference}/lightmaps/{page}", f"{of}/lightmaps/{page}", "--json"],
                              stdout=subprocess.PIPE, text=True, check=True)
        page_error = json.loads(said.stdout)
        texels += page_error["covered_both"]
        squares += page_error["covered_both"] * page_error["root_mean_square"] ** 2
        total += page_error["covered_both"] * page_error["mean_a"]
    return math.sqrt(squares / texels) / (total / texels)


print(f"\n{size}², 256 rays a texel, 64 of each bounce; seconds of tracing\n")
print("| scene | there to show | as planned | all forced on | without it | error without it |\n|---|---|---|---|---|---|")
for scene, shows, planned, left_out in cases:
    variants = [planned, {**planned, **forced}] + ([{**planned, **left_out}] if left_out else [])
    folders, seconds = bake_by_turns(scene, variants)
    row = [scene, shows] + [f"{value:.2f}" for value in seconds]
    row += [f"{100 * error(folders[2], folders[0]):.0f} %"] if left_out else ["", ""]
    print("| " + " | ".join(row) + " |", flush=True)

size = str(4 * int(size))  # rays so simple that loading the codecs beside them would show: four times as far
_, seconds = bake_by_turns("test/plane", [{"--sky": "1,1,1"}, {"--sky": plain}, {"--sky": "clear"}, {"--mode": "ao"}])
print("\nA plane under the open sky, where every ray meets the sky, to a white one: "
      f"a picture {seconds[1] / seconds[0]:.2f}, the clear sky {seconds[2] / seconds[0]:.2f}, mode ao {seconds[3] / seconds[0]:.2f}")
PYTHON
