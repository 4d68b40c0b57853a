# Headers that take long to read are read once: exact/number.h brings CGAL's
# number types, seven of the eight to eleven seconds that a unit with them took.
# Off, every file must include what it uses, so the preset dev has it off.
option(TRUELUX_PRECOMPILE "Precompile headers shared by many files" ON)

set(truelux_precompiled_headers
  <algorithm> <array> <cmath> <cstddef> <cstdint> <functional> <map> <memory>
  <optional> <span> <string> <string_view> <utility> <vector>)

# truelux_precompile(TARGET HEADER...): the standard headers above and these.
function(truelux_precompile target)
  if(TRUELUX_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE
      ${truelux_precompiled_headers} ${ARGN})
  endif()
endfunction()

# truelux_precompile_as(TARGET OTHER): those of another target, which has the
# same flags and definitions.
function(truelux_precompile_as target other)
  if(TRUELUX_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()
