# SPDX-License-Identifier: GPL-3.0-or-later
# Manual pages, made from --help by help2man: truelux(1), truelux-eval(1), ..
find_program(HELP2MAN help2man)
mark_as_advanced(HELP2MAN)

# One line each for the NAME section.
set(_truelux_pages
  "|exact irradiance from polygons that others partly hide"
  "bench|compare methods on a scene, speed against error"
  "compare|hold another program's values against the truth"
  "eval|irradiance at receivers in a scene"
  "gradient|how irradiance changes when receivers and vertices move"
  "inspect|all that one receiver sees, as a picture and as numbers"
  "isolux|contours of irradiance on a flat surface, certified"
  "render|pictures of a scene, one irradiance a pixel"
  "stability|accuracy of every formula on hard families")

set(_truelux_pages_made "")
foreach(_page IN LISTS _truelux_pages)
  string(REGEX MATCH "^([a-z]*)[|](.*)$" _ "${_page}")
  set(_command ${CMAKE_MATCH_1})
  set(_summary ${CMAKE_MATCH_2})
  set(_name truelux)
  set(_see "")
  if(_command)
    set(_name truelux-${_command})
    set(_see " ${_command}")
  endif()
  set(_file ${PROJECT_BINARY_DIR}/man/${_name}.1)
  # help2man names a page after the file that it runs, and takes a path with a
  # blank for a command with an argument.
  set(_script ${PROJECT_BINARY_DIR}/man/${_name})
  file(GENERATE OUTPUT ${_script}
    CONTENT "#!/bin/sh\nexec '$<TARGET_FILE:truelux>'${_see} \"$@\"\n"
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  if(HELP2MAN)
    add_custom_command(OUTPUT ${_file}
      COMMAND ${HELP2MAN} --no-info --section=1 --name=${_summary}
        --version-string=${PROJECT_VERSION} --source=truelux
        --include=${PROJECT_SOURCE_DIR}/cmake/truelux_man.inc
        --output=${_file} ./${_name}
      WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/man
      DEPENDS truelux ${PROJECT_SOURCE_DIR}/cmake/truelux_man.inc
      VERBATIM)
    list(APPEND _truelux_pages_made ${_file})
  endif()
endforeach()
add_custom_target(man ALL DEPENDS ${_truelux_pages_made})
if(HELP2MAN)
  install(FILES ${_truelux_pages_made}
    DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT man)
else()
  message(STATUS "No help2man: there will be no manual pages")
endif()
