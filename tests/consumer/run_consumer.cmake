# SPDX-License-Identifier: GPL-3.0-or-later
# Installs truelux, once with the library static and once shared, and uses each
# from outside: by find_package and, where there is one, by pkg-config.
#
#   cmake -DBUILD=... -DSOURCE=... -DWORK=... -DCOMPILER=... -DSANITIZE=...
#         -DLIBDIR=lib -DSHARED=... -P run_consumer.cmake
#
# CGAL is made unfindable: the library's users need FLINT, GMP and MPFR only; of
# truelux_tools also fmt, oneTBB, OpenEXR and libpng.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(flags "")
if(SANITIZE)  # a library with sanitizers needs their runtime
  set(flags "-fsanitize=${SANITIZE}")
endif()

# use_by_cmake(KIND): the consumer project over WORK/KIND.
function(use_by_cmake kind)
  set(build ${WORK}/build_${kind})
  run(${CMAKE_COMMAND} --no-warn-unused-cli -G Ninja -S ${SOURCE} -B ${build}
    -DCMAKE_PREFIX_PATH=${WORK}/${kind}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${flags}
    -DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON)
  run(${CMAKE_COMMAND} --build ${build})
  run(${build}/consumer)
  run(${build}/tools_consumer)
endfunction()

# use_by_pkg_config(KIND PROGRAM MODULE): a program of the project compiled by
# hand.
find_program(PKG_CONFIG NAMES pkg-config pkgconf)
function(use_by_pkg_config kind program module)
  if(NOT PKG_CONFIG)
    return()
  endif()
  set(libdir ${WORK}/${kind}/${LIBDIR})
  foreach(what cflags libs)
    execute_process(
      COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${libdir}/pkgconfig
        ${PKG_CONFIG} --${what} ${module}
      OUTPUT_VARIABLE text OUTPUT_STRIP_TRAILING_WHITESPACE
      COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(${what} UNIX_COMMAND "${text}")
  endforeach()
  set(binary ${WORK}/${program}_by_pkg_config_${kind})
  run(${COMPILER} ${flags} -std=c++20 ${cflags} ${SOURCE}/${program}.cpp
    -o ${binary} ${libs} -Wl,-rpath,${libdir})
  run(${binary})
endfunction()

# A shared library shows what the headers declare, and nothing of CGAL.
function(check_symbols library shown)
  find_program(NM nm)
  if(NOT NM)
    return()
  endif()
  execute_process(COMMAND ${NM} -D -C --defined-only ${library}
    OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  if(NOT symbols MATCHES "${shown}")
    message(FATAL_ERROR "${library} hides ${shown}")
  endif()
  foreach(inside "CGAL::" "truelux::ContourEngine" "truelux::SceneVariants"
      "truelux::Diagnose" "truelux::OutputFile")
    if(symbols MATCHES "[^\n]* [TWVBDR] ${inside}[^\n]*")
      message(FATAL_ERROR "${library} shows ${CMAKE_MATCH_0}")
    endif()
  endforeach()
endfunction()

file(REMOVE_RECURSE ${WORK})
set(asked static)
set(other shared)
if(SHARED)
  set(asked shared)
  set(other static)
endif()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/${asked})
foreach(component development other_kind)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/${other}
    --component ${component})
endforeach()
foreach(kind static shared)
  use_by_cmake(${kind})
  use_by_pkg_config(${kind} consumer truelux)
  use_by_pkg_config(${kind} tools_consumer truelux_tools)
endforeach()
check_symbols(${WORK}/shared/${LIBDIR}/libtruelux.so
  "truelux::Oracle::FormFactors")
check_symbols(${WORK}/shared/${LIBDIR}/libtruelux_tools.so
  "truelux::CompareGradients")
run(${WORK}/${asked}/bin/truelux --version)

# The manual pages say what --help says.
find_program(HELP2MAN help2man)
if(HELP2MAN)
  file(READ ${WORK}/${asked}/share/man/man1/truelux-eval.1 page)
  foreach(words "truelux-eval \\- irradiance" ".SH OPTIONS"
      "\\-\\-on\\-face" ".SH \"SEE ALSO\"" "a comparison failed")
    string(FIND "${page}" "${words}" found)
    if(found EQUAL -1)
      message(FATAL_ERROR "truelux-eval.1 lacks ${words}")
    endif()
  endforeach()
endif()
