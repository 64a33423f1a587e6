# Writes OUTPUT, a C++ source that holds every module in the folder MODULES.
cmake_minimum_required(VERSION 3.25)
file(GLOB files ${MODULES}/*.spv)
list(SORT files)
set(arrays "")
set(entries "")
set(index 0)
foreach(file IN LISTS files)
    get_filename_component(name ${file} NAME_WLE) # "dilate.comp.spv" is the module "dilate.comp"
    file(READ ${file} hex HEX)
    # SPIR-V is a stream of words, written by the compiler with the least significant byte first.
    string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${hex}")
    string(APPEND arrays "constexpr std::uint32_t words_${index}[] = {${words}};\n")
    string(APPEND entries "    SpirvModule{\"${name}\", words_${index}},\n")
    math(EXPR index "${index} + 1")
endforeach()
file(WRITE ${OUTPUT} "// Written by WriteSpirvSource.cmake.
#include \"gpu/spirv.hpp\"

#include <array>

namespace vkbake::gpu {

namespace {

${arrays}
constexpr std::array<SpirvModule, ${index}> modules{
${entries}};

} // namespace

std::span<const SpirvModule> spirv_modules() { return modules; }

} // namespace vkbake::gpu
")
