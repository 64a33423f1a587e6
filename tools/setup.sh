#!/usr/bin/env bash
# Installs what building, running and testing need, from Debian's packages. Nothing else installs anything.
set -euo pipefail

packages=(
    # build
    g++ cmake ninja-build pkg-config
    # libraries
    libvulkan-dev libglm-dev libeigen3-dev libtbb-dev libhwy-dev libtinygltf-dev nlohmann-json3-dev libdraco-dev libmeshoptimizer-dev
    libopenimageio-dev libopenexr-dev libpng-dev librsvg2-dev libxxhash-dev libcli11-dev libfmt-dev
    # running: a software Vulkan driver
    mesa-vulkan-drivers
    # tests
    libgtest-dev libembree-dev vulkan-validationlayers glslang-tools spirv-tools
)

missing=()
for package in "${packages[@]}"; do
    if ! dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed'; then
        missing+=("$package")
    fi
done
if [ ${#missing[@]} -eq 0 ]; then
    exit 0
fi

echo "installing ${#missing[@]} packages: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo)
fi
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
