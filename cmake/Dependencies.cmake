# Debian 12's packages; tools/setup.sh installs them.
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)
find_package(Vulkan 1.3 REQUIRED)
find_package(glm REQUIRED)
find_package(TBB REQUIRED)
find_package(hwy REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(draco REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(fmt REQUIRED)
find_package(PkgConfig REQUIRED)
# OpenImageIO's own CMake configuration on Debian names a folder of OpenCV headers that need not exist.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
