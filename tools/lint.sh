#!/usr/bin/env bash
# clang-format and clang-tidy over all sources (or over the files given). Changes nothing; fails at the first complaint.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh
cmake --preset debug >/dev/null
if [ $# -gt 0 ]; then
    sources=("$@")
else
    mapfile -t sources < <(git ls-files '*.cpp')
fi
mapfile -t formatted < <(git ls-files '*.cpp' '*.hpp')
clang-format --dry-run --Werror "${formatted[@]}"
printf '%s\0' "${sources[@]}" | grep -zv '^tests/consumer/' | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/debug --quiet
echo "clean: ${#sources[@]} files"
