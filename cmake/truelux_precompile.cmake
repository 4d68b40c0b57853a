# SPDX-License-Identifier: GPL-3.0-or-later
# exact/number.h brings CGAL's number types, which take most of the time of a
# file that includes them: 6 s, and 2.5 s where the header is precompiled. Files
# without it would lose 1 s each by loading it (docs/performance.md, section
# "Building"), so a file gets it only if its #include lines lead there.
#
# Off, every file must include what it uses, so the preset dev has it off.
option(TRUELUX_PRECOMPILE "Precompile the header of CGAL's number types" ON)

# truelux_leads_to_number(VARIABLE FILE): whether the #include "..." lines of a
# file of src/ or tests/, or of what they name, reach exact/number.h.
function(truelux_leads_to_number variable file)
  get_property(known GLOBAL PROPERTY "truelux_leads_${file}")
  if("${known}" STREQUAL "")
    set(known FALSE)
    # Headers do not include each other in a circle (tests/layering_test.cpp).
    file(STRINGS ${file} lines REGEX "^#include \"")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" name "${line}")
      if(name STREQUAL "exact/number.h")
        set(known TRUE)
        break()
      endif()
      foreach(root src tests)
        if(EXISTS ${PROJECT_SOURCE_DIR}/${root}/${name})
          truelux_leads_to_number(known ${PROJECT_SOURCE_DIR}/${root}/${name})
          break()
        endif()
      endforeach()
      if(known)
        break()
      endif()
    endforeach()
    set_property(GLOBAL PROPERTY "truelux_leads_${file}" ${known})
  endif()
  set(${variable} ${known} PARENT_SCOPE)
endfunction()

# truelux_precompile(TARGET OWNER SOURCE...): gives those of the target's sources
# that need it the header that the target OWNER precompiles. Both targets must
# have the same flags and definitions.
function(truelux_precompile target owner)
  if(NOT TRUELUX_PRECOMPILE)
    return()
  endif()
  set(any FALSE)
  list(FILTER ARGN INCLUDE REGEX "\\.cpp$")  # object files have no source here
  foreach(source IN LISTS ARGN)
    get_filename_component(path ${source} ABSOLUTE)
    truelux_leads_to_number(leads ${path})
    if(leads)
      set(any TRUE)
    else()
      set_source_files_properties(${source} PROPERTIES
        SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
  if(target STREQUAL owner)
    target_precompile_headers(${target} PRIVATE
      ${PROJECT_SOURCE_DIR}/src/exact/number.h)
  elseif(any)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()
