# One target a folder of src: vkbake_folder(NAME [RUNS_ONCE] [KERNELS source…] [USES library…] [PRECOMPILE header…] [OPTIONS option…]).
# RUNS_ONCE: no loop of it is hot, so under sanitizers it is not optimised, which halves the compiler's time.
# KERNELS: each one source for several instruction sets, which a unity build would mix up.
# Headers that cost seconds each time they are read are read once a folder: precompiled, or, in a unity build, because
# one source includes the whole folder (which is a sixth less work than precompiling as well).
# Which folder may include which is not told here but held by tests/house.
function(vkbake_folder name)
    cmake_parse_arguments(ARG "RUNS_ONCE" "" "KERNELS;USES;PRECOMPILE;OPTIONS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    if(NOT sources)
        return()
    endif()
    add_library(vkbake_${name} OBJECT ${sources})
    set_target_properties(vkbake_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_include_directories(vkbake_${name} PRIVATE
        ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/shaders/glsl/shared)
    target_link_libraries(vkbake_${name} PRIVATE vkbake_options glm::glm ${ARG_USES})
    target_compile_options(vkbake_${name} PRIVATE ${ARG_OPTIONS})
    if(ARG_RUNS_ONCE AND VKBAKE_SANITIZE)
        target_compile_options(vkbake_${name} PRIVATE -O0)
    endif()
    if(ARG_PRECOMPILE AND NOT CMAKE_UNITY_BUILD)
        target_precompile_headers(vkbake_${name} PRIVATE ${ARG_PRECOMPILE})
    endif()
    if(NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
        set_target_properties(vkbake_${name} PROPERTIES UNITY_BUILD_BATCH_SIZE 16)
    endif()
    set_source_files_properties(${ARG_KERNELS} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    if(ARG_KERNELS AND VKBAKE_SANITIZE MATCHES "fuzzer")
        # Readers of files have nothing there to find, and with sanitizers Clang takes minutes for each.
        set_property(SOURCE ${ARG_KERNELS} APPEND PROPERTY COMPILE_OPTIONS -fno-sanitize=all)
    endif()
    set_property(GLOBAL APPEND PROPERTY VKBAKE_FOLDERS vkbake_${name})
    set_property(GLOBAL APPEND PROPERTY VKBAKE_USES ${ARG_USES})
endfunction()
