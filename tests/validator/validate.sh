#!/usr/bin/env bash
# Runs the official glTF validator (npm package gltf-validator) over GLB files:
#     validate.sh FOLDER FILE...
# The package is installed into FOLDER on first use. Exit status: 0 no file has an error, 1 one has, 77 there is no
# node or the package cannot be installed (for ctest's SKIP_RETURN_CODE).
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
folder="$1"
shift
if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
    echo "skipped: node and npm are not installed"
    exit 77
fi
mkdir -p "$folder"
exec 9>"$folder/lock"
flock 9
if [ ! -d "$folder/node_modules/gltf-validator" ]; then
    if ! timeout 120 npm install --prefix "$folder" --no-audit --no-fund gltf-validator@2.0.0-dev.3.10 >"$folder/npm.log" 2>&1; then
        rm -rf "$folder/node_modules"
        echo "skipped: npm cannot install gltf-validator"
        exit 77
    fi
fi
flock -u 9
exec node "$here/validate.mjs" "$folder" "$@"
