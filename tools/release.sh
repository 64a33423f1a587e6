# What tools that measure the release build begin with; sourced by them, from the repository's folder.

# build_release TARGET [CMAKE_FLAG...]
build_release() {
    tools/setup.sh
    cmake --preset release "${@:2}" >/dev/null
    cmake --build --preset release --target "$1" >/dev/null
}

commit_name() { git rev-parse --short HEAD 2>/dev/null || echo unknown; }

machine_and_commit() {
    echo "$(nproc) cores, $(grep -m1 'model name' /proc/cpuinfo | cut -d: -f2 | xargs); commit $(commit_name)"
}
