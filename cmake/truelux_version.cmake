# SPDX-License-Identifier: GPL-3.0-or-later
# truelux_version: what include/truelux/version.h says, the one place where the
# version stands.
set(_header ${CMAKE_CURRENT_LIST_DIR}/../include/truelux/version.h)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${_header})
file(STRINGS ${_header} _lines REGEX "^#define TRUELUX_VERSION_[A-Z]+ ")
foreach(_name MAJOR MINOR PATCH STRING)
  string(REGEX MATCH "TRUELUX_VERSION_${_name} \"?([0-9.]+)" _ "${_lines}")
  set(_${_name} "${CMAKE_MATCH_1}")
endforeach()
set(truelux_version ${_MAJOR}.${_MINOR}.${_PATCH})
if(NOT _STRING STREQUAL truelux_version)
  message(FATAL_ERROR "version.h: TRUELUX_VERSION_STRING is \"${_STRING}\", "
    "the numbers say \"${truelux_version}\"")
endif()
