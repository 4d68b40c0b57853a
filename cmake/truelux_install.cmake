# SPDX-License-Identifier: GPL-3.0-or-later
# The libraries, their headers, and what find_package(truelux) and pkg-config need.
# Components: `library` (the kind that was asked for), `development` (headers
# and what does not depend on the kind), `program`, `man`.
include(CMakePackageConfigHelpers)

set(_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/truelux)
set(_pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# truelux_install_library(TARGET COMPONENT [options of install]): one kind of a
# library with the files that describe it.
function(truelux_install_library target component)
  install(TARGETS ${target} EXPORT ${target}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
      COMPONENT ${component} ${ARGN}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
      COMPONENT ${component} NAMELINK_COMPONENT ${component} ${ARGN}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  get_target_property(type ${target} TYPE)
  get_target_property(name ${target} OUTPUT_NAME)
  install(EXPORT ${target}-targets NAMESPACE truelux::
    FILE ${name}-targets-${type}.cmake
    DESTINATION ${_package_dir} COMPONENT ${component} ${ARGN})

  # A static library does not know what it needs: whoever links it links that.
  set(PC_NAME ${name})
  set(PC_LIBS "")
  # Before FLINT 3 Arb was a library of its own (truelux_libraries.cmake).
  set(PC_PRIVATE_LIBS "-lflint -lmpfr -lgmp")
  if(TRUELUX_arb_LIBRARY)
    get_filename_component(_arb ${TRUELUX_arb_LIBRARY} NAME_WE)
    string(REGEX REPLACE "^lib" "-l" _arb ${_arb})
    string(PREPEND PC_PRIVATE_LIBS "${_arb} ")
  endif()
  set(PC_REQUIRES "")
  set(PC_PRIVATE_REQUIRES "")
  if(name STREQUAL truelux_tools)
    set(PC_PRIVATE_REQUIRES "fmt tbb OpenEXR libpng")
  endif()
  if(type STREQUAL STATIC_LIBRARY)
    set(PC_LIBS " ${PC_PRIVATE_LIBS}")
    set(PC_PRIVATE_LIBS "")
    set(PC_REQUIRES ${PC_PRIVATE_REQUIRES})
    set(PC_PRIVATE_REQUIRES "")
  endif()
  # The prefix as seen from the file, so that the folder may be moved.
  file(RELATIVE_PATH PC_PREFIX /prefix/${_pkgconfig_dir} /prefix)
  string(REGEX REPLACE "/$" "" PC_PREFIX "${PC_PREFIX}")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/truelux.pc.in
    ${PROJECT_BINARY_DIR}/cmake/${target}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/cmake/${target}.pc
    DESTINATION ${_pkgconfig_dir} RENAME ${name}.pc
    COMPONENT ${component} ${ARGN})
endfunction()

foreach(_name library tools_library)
  truelux_install_library(truelux_${_name} library)
  if(TARGET truelux_other_${_name})
    truelux_install_library(truelux_other_${_name} other_kind EXCLUDE_FROM_ALL)
  endif()
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/truelux
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
if(TRUELUX_BUILD_PROGRAM)
  install(TARGETS truelux
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()

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
  DESTINATION ${_package_dir} COMPONENT development)
