// libFuzzer's entry: VKBAKE_FUZZ_READER is one of the readers of tests/fuzz.
#include <cstddef>
#include <cstdint>

#include "fuzz/readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    vkbake::fuzz::VKBAKE_FUZZ_READER({data, size});
    return 0;
}
