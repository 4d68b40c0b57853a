# GMP and MPFR as targets: all that a program linked to truelux needs besides.
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
