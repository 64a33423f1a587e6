# `cmake --install` gives headers, the shared library, the program and a package: find_package(vkbake), vkbake::vkbake.
include(CMakePackageConfigHelpers)

install(TARGETS vkbake EXPORT vkbakeTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS vkbake_codec LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_SKIP) # loaded by libvkbake, beside it
if(TARGET vkbake_cli)
    set_target_properties(vkbake_cli PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
    install(TARGETS vkbake_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY include/vkbake DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# What renderers include to evaluate directional maps and light probes.
install(FILES shaders/glsl/shared/vkbake_light.h DESTINATION ${CMAKE_INSTALL_DATADIR}/vkbake/glsl)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/vkbake)
install(EXPORT vkbakeTargets NAMESPACE vkbake:: DESTINATION ${package_folder})
configure_package_config_file(cmake/vkbakeConfig.cmake.in ${PROJECT_BINARY_DIR}/vkbakeConfig.cmake
    INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/vkbakeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/vkbakeConfig.cmake ${PROJECT_BINARY_DIR}/vkbakeConfigVersion.cmake
    DESTINATION ${package_folder})
