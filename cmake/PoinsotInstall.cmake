# cmake --install, and what find_package(poinsot) reads. Components: engine; problem, which needs the engine; program.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(poinsot_package "${CMAKE_INSTALL_LIBDIR}/cmake/poinsot")

# An export set for each library, so that who uses the engine need not have what problems need.
foreach(library engine problem)
  install(TARGETS poinsot_${library} EXPORT poinsot_${library}_targets ARCHIVE COMPONENT ${library})
  install(EXPORT poinsot_${library}_targets NAMESPACE poinsot:: DESTINATION "${poinsot_package}" COMPONENT ${library})
endforeach()
install(DIRECTORY include/poinsot/engine DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/poinsot" COMPONENT engine)
install(FILES include/poinsot/problem.h include/poinsot/cases.h include/poinsot/document.h include/poinsot/pictures.h
              include/poinsot/rendering.h include/poinsot/scene.h
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/poinsot" COMPONENT problem)
install(TARGETS poinsot RUNTIME COMPONENT program)
set(texts "${PROJECT_BINARY_DIR}/texts")
install(FILES "${texts}/poinsot.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program)
install(FILES "${texts}/poinsot" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT program)
install(FILES "${texts}/_poinsot" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" COMPONENT program)
install(FILES "${texts}/poinsot.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d" COMPONENT program)

configure_package_config_file(cmake/poinsot-config.cmake.in "${PROJECT_BINARY_DIR}/poinsot-config.cmake"
                              INSTALL_DESTINATION "${poinsot_package}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/poinsot-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/poinsot-config.cmake" "${PROJECT_BINARY_DIR}/poinsot-config-version.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindFLINT.cmake"
        DESTINATION "${poinsot_package}" COMPONENT engine)
