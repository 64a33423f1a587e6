#!/usr/bin/env bash
# The thesis's evaluation, made again: prints a table with its times and ours, and the errors. Takes some minutes.
set -euo pipefail
cd "$(dirname "$0")/.."

. tools/release.sh
build_release vkbake_thesis_table -DVKBAKE_TOOLS=ON -DVKBAKE_BENCHMARKS=ON
echo "machine: $(machine_and_commit)"
build/release/tools/thesis_table/vkbake_thesis_table scenes
