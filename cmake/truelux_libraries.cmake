# SPDX-License-Identifier: GPL-3.0-or-later
# GMP, MPFR and Arb as targets: all that a program linked to truelux needs
# besides.
# Used by the build and, installed, by find_package(truelux).
foreach(_truelux_name mpfr gmp)
  if(NOT TARGET truelux::${_truelux_name})
    find_library(TRUELUX_${_truelux_name}_LIBRARY ${_truelux_name})
    mark_as_advanced(TRUELUX_${_truelux_name}_LIBRARY)
    if(NOT TRUELUX_${_truelux_name}_LIBRARY)
      message(FATAL_ERROR "truelux needs the library ${_truelux_name} "
        "(Debian: lib${_truelux_name}-dev)")
    endif()
    add_library(truelux::${_truelux_name} UNKNOWN IMPORTED GLOBAL)
    set_target_properties(truelux::${_truelux_name} PROPERTIES
      IMPORTED_LOCATION "${TRUELUX_${_truelux_name}_LIBRARY}")
  endif()
endforeach()
unset(_truelux_name)

# Arb's balls. FLINT 3 holds them, with flint/arb.h; before that Arb was a
# library of its own, with arb.h (Debian 12 calls it flint-arb).
if(NOT TARGET truelux::arb)
  find_path(TRUELUX_flint_INCLUDE_DIR flint/flint.h)
  find_library(TRUELUX_flint_LIBRARY flint)
  if(NOT TRUELUX_flint_INCLUDE_DIR OR NOT TRUELUX_flint_LIBRARY)
    message(FATAL_ERROR "truelux needs the library FLINT (Debian 12: "
      "libflint-arb-dev, later: libflint-dev)")
  endif()
  add_library(truelux::arb INTERFACE IMPORTED GLOBAL)
  set_target_properties(truelux::arb PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${TRUELUX_flint_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${TRUELUX_flint_LIBRARY}")
  if(NOT EXISTS "${TRUELUX_flint_INCLUDE_DIR}/flint/arb.h")
    find_path(TRUELUX_arb_INCLUDE_DIR arb.h)
    find_library(TRUELUX_arb_LIBRARY NAMES flint-arb arb)
    if(NOT TRUELUX_arb_INCLUDE_DIR OR NOT TRUELUX_arb_LIBRARY)
      message(FATAL_ERROR "truelux needs FLINT 3, or Arb beside FLINT 2 "
        "(Debian 12: libflint-arb-dev)")
    endif()
    set_target_properties(truelux::arb PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES
        "${TRUELUX_flint_INCLUDE_DIR};${TRUELUX_arb_INCLUDE_DIR}"
      INTERFACE_LINK_LIBRARIES
        "${TRUELUX_arb_LIBRARY};${TRUELUX_flint_LIBRARY}")
  endif()
  mark_as_advanced(TRUELUX_flint_INCLUDE_DIR TRUELUX_flint_LIBRARY
    TRUELUX_arb_INCLUDE_DIR TRUELUX_arb_LIBRARY)
endif()
