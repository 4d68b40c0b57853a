# SPDX-License-Identifier: GPL-3.0-or-later
# The Python that the package is built for: ${Python3_EXECUTABLE}, if given, else
# the first of PATH, or of the system, that has NumPy. Debian's packages belong
# to the system's, and another Python may come first on PATH. Sets
# truelux_has_python.

set(truelux_has_python FALSE)
if(NOT Python3_EXECUTABLE)
  find_program(_path_python python3)
  foreach(_candidate IN ITEMS ${_path_python} /usr/bin/python3)
    execute_process(COMMAND ${_candidate} -c "import numpy"
      RESULT_VARIABLE _failed OUTPUT_QUIET ERROR_QUIET)
    if(_failed EQUAL 0)
      set(Python3_EXECUTABLE ${_candidate} CACHE FILEPATH
        "The Python that the package is built for")
      break()
    endif()
  endforeach()
  unset(_path_python CACHE)
endif()
if(Python3_EXECUTABLE)
  find_package(Python3 COMPONENTS Interpreter Development.Module NumPy QUIET)
  set(PYTHON_EXECUTABLE ${Python3_EXECUTABLE})
  if(Python3_FOUND)
    find_package(pybind11 2.10 CONFIG QUIET)
  endif()
endif()
if(pybind11_FOUND)
  set(truelux_has_python TRUE)
  set(TRUELUX_PYTHON_DIR
    ${CMAKE_INSTALL_LIBDIR}/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/site-packages
    CACHE STRING "Where the Python package is installed")
else()
  message(WARNING "The Python package is left out: it needs a Python with "
    "NumPy and its headers, and pybind11 2.10 or later.")
endif()
