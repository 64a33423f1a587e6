# What every target of the project is compiled with.
add_library(vkbake_options INTERFACE)
target_compile_features(vkbake_options INTERFACE cxx_std_20)
# No contraction: hit or miss must not depend on which multiply-adds a compiler fuses.
target_compile_options(vkbake_options INTERFACE
    -Wall -Wextra -Wno-missing-field-initializers -Wpedantic -Wshadow -Wconversion -Werror -ffp-contract=off -fno-fast-math)

# GCC 12 takes `std::string + "literal"` for a copy that overlaps or overruns (GCC bug 105651); whether it does so hangs on
# how long a constant such as the checkout's path is.
target_compile_options(vkbake_options INTERFACE
    "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow>")

# -O3 is for the loops that trace (src/bvh, src/trace); elsewhere it only costs the compiler's time.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")

if(VKBAKE_SANITIZE)
    target_compile_options(vkbake_options INTERFACE
        -fsanitize=${VKBAKE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(vkbake_options INTERFACE -fsanitize=${VKBAKE_SANITIZE})
    target_compile_definitions(vkbake_options INTERFACE VKBAKE_SANITIZED)
    # With sanitizers GCC 12 takes the value of an empty std::optional for one that is used (GCC bug 80635).
    target_compile_options(vkbake_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
