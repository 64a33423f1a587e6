# embed_spirv(TARGET): turns the checked-in spirv/*.spv into a source file of TARGET that defines gpu::spirv_modules().
# A normal build needs no shader compiler; the target `spirv` rebuilds the modules from shaders/glsl.
# A new shader is a new file there: build `spirv`, commit what it wrote.
function(embed_spirv target)
    file(GLOB modules CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/spirv/*.spv)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/spirv_modules.cpp)
    add_custom_command(
        OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -DMODULES=${PROJECT_SOURCE_DIR}/spirv -DOUTPUT=${output}
                -P ${PROJECT_SOURCE_DIR}/cmake/WriteSpirvSource.cmake
        DEPENDS ${modules} ${PROJECT_SOURCE_DIR}/cmake/WriteSpirvSource.cmake
        COMMENT "Embedding the compiled shaders")
    target_sources(${target} PRIVATE ${output})
endfunction()

if(NOT TARGET spirv)
    add_custom_target(spirv
        COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -P ${PROJECT_SOURCE_DIR}/cmake/CompileShaders.cmake
        COMMENT "Compiling shaders/glsl into spirv" VERBATIM)
endif()
