# cmake --install, and what find_package(poinsot) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS poinsot_engine poinsot_problem poinsot EXPORT poinsot_targets)
install(DIRECTORY include/poinsot TYPE INCLUDE)
install(EXPORT poinsot_targets NAMESPACE poinsot:: DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/poinsot")
configure_package_config_file(cmake/poinsot-config.cmake.in "${PROJECT_BINARY_DIR}/poinsot-config.cmake"
                              INSTALL_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/poinsot")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/poinsot-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/poinsot-config.cmake" "${PROJECT_BINARY_DIR}/poinsot-config-version.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindFLINT.cmake"
        DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/poinsot")
