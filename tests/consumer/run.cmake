# Installs the package to a temporary prefix, builds the consumer against it and runs it; compiles a shader with what is
# installed for shaders.
# cmake -DBUILD=<build tree> -DSOURCE=<project> -DCONFIG=<type> -DGENERATOR=<generator> -DFLAGS=<flags>
#     -DPROGRAMS=<those to build and run> -P run.cmake
cmake_minimum_required(VERSION 3.25)
set(work ${BUILD}/tests/consumer)
file(REMOVE_RECURSE ${work})

function(run)
    execute_process(COMMAND ${ARGV} RESULT_VARIABLE status)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "failed (${status}): ${ARGV}")
    endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer -B ${work}/build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${work}/prefix
    -DCMAKE_BUILD_TYPE=${CONFIG} "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${work}/build --target ${PROGRAMS})
run(${work}/build/own_device)
find_program(GLSL_COMPILER glslangValidator)
if(GLSL_COMPILER)
    run(${GLSL_COMPILER} -V -I${work}/prefix/share/vkbake/glsl ${SOURCE}/tests/consumer/renderer.frag
        -o ${work}/renderer.spv)
endif()
if(NOT readme IN_LIST PROGRAMS)
    return()
endif()
file(MAKE_DIRECTORY ${work}/run)
run(${CMAKE_COMMAND} -E chdir ${work}/run ${work}/build/readme ${SOURCE}/scenes/test/plane.glb)
foreach(file baked/manifest.json baked/plane.glb)
    if(NOT EXISTS ${work}/run/${file})
        message(FATAL_ERROR "the README's program did not write ${file}")
    endif()
endforeach()
