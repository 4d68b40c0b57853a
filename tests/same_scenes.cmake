# SPDX-License-Identifier: GPL-3.0-or-later
# Runs tools/make_figure7.py and compares what it writes with what is kept.
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
execute_process(COMMAND ${PYTHON} ${SOURCE}/tools/make_figure7.py ${WORK}
  COMMAND_ERROR_IS_FATAL ANY)
foreach(_letter a b c d)
  foreach(_ending obj mtl)
    set(_name figure7_${_letter}.${_ending})
    execute_process(
      COMMAND ${CMAKE_COMMAND} -E compare_files
        ${WORK}/${_name} ${SOURCE}/examples/scenes/${_name}
      COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endforeach()
