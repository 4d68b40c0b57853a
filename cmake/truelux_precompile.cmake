# SPDX-License-Identifier: GPL-3.0-or-later
# Two headers are precompiled (docs/performance.md, section "Building"):
#
# number  exact/number.h brings CGAL's number types, which take most of the time
#         of a file that includes them: 6 s, and 2.5 s where it is precompiled.
#         A file gets it only if its #include lines lead there.
# plain   the standard headers that most of the other files include, which save
#         them 0.5 to 0.7 s each.
#
# Off, every file must include what it uses, so the preset dev has it off.
option(TRUELUX_PRECOMPILE "Precompile headers that many files include" ON)
if(TRUELUX_PRECOMPILE)  # GCC 12 then invents bounds in std::string
  target_compile_options(truelux_flags INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-stringop-overflow>)
endif()

set(truelux_plain_headers
  <algorithm> <array> <cmath> <cstdint> <functional> <limits> <memory>
  <optional> <span> <sstream> <string> <string_view> <utility> <variant>
  <vector>)

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

# truelux_part_sources(NUMBER PLAIN SOURCE...): sets two variables to those of
# the sources that lead to exact/number.h and to the others.
function(truelux_part_sources number plain)
  set(leading "")
  set(others "")
  list(FILTER ARGN INCLUDE REGEX "\\.cpp$")  # object files have no source here
  foreach(source IN LISTS ARGN)
    get_filename_component(path ${source} ABSOLUTE)
    truelux_leads_to_number(leads ${path})
    if(leads)
      list(APPEND leading ${source})
    else()
      list(APPEND others ${source})
    endif()
  endforeach()
  set(${number} "${leading}" PARENT_SCOPE)
  set(${plain} "${others}" PARENT_SCOPE)
endfunction()

# truelux_precompile(TARGET OWNER [HEADER...]): the target shares what the target
# OWNER precompiles. Both must have the same flags. The owner itself names the
# headers.
function(truelux_precompile target owner)
  if(NOT TRUELUX_PRECOMPILE)
    return()
  endif()
  if(target STREQUAL owner)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()
