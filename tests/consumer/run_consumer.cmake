# Installs truelux, then configures, builds and runs the consumer project.
#
#   cmake -DBUILD=... -DSOURCE=... -DWORK=... -DCOMPILER=... -DSANITIZE=...
#         -P run_consumer.cmake
#
# CGAL is made unfindable for it: the library's users need FLINT, GMP and MPFR
# only.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(flags "")
if(SANITIZE)  # a library with sanitizers needs their runtime
  set(flags "-fsanitize=${SANITIZE}")
endif()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)
run(${CMAKE_COMMAND} --no-warn-unused-cli -G Ninja -S ${SOURCE} -B ${WORK}/build
  -DCMAKE_PREFIX_PATH=${WORK}/installed
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${flags}
  -DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
run(${WORK}/installed/bin/truelux --version)

# The manual pages say what --help says.
find_program(HELP2MAN help2man)
if(HELP2MAN)
  file(READ ${WORK}/installed/share/man/man1/truelux-eval.1 page)
  foreach(words "truelux-eval \\- irradiance" ".SH OPTIONS"
      "\\-\\-on\\-face" ".SH \"SEE ALSO\"" "a comparison failed")
    string(FIND "${page}" "${words}" found)
    if(found EQUAL -1)
      message(FATAL_ERROR "truelux-eval.1 lacks ${words}")
    endif()
  endforeach()
endif()
