# The library, its headers, and what find_package(truelux) needs.
include(CMakePackageConfigHelpers)

set(_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/truelux)
install(TARGETS truelux_library EXPORT truelux-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/truelux
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS truelux RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT truelux-targets NAMESPACE truelux::
  DESTINATION ${_package_dir})

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/truelux-config.cmake.in
  ${PROJECT_BINARY_DIR}/cmake/truelux-config.cmake
  INSTALL_DESTINATION ${_package_dir})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/cmake/truelux-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/cmake/truelux-config.cmake
  ${PROJECT_BINARY_DIR}/cmake/truelux-config-version.cmake
  ${PROJECT_SOURCE_DIR}/cmake/truelux_libraries.cmake
  DESTINATION ${_package_dir})
