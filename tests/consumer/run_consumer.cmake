# Installs truelux, then configures, builds and runs the consumer project.
#
#   cmake -DBUILD=... -DSOURCE=... -DWORK=... -DCOMPILER=... -DSANITIZE=...
#         -P run_consumer.cmake
#
# CGAL is made unfindable for it: the library's users need GMP and MPFR only.
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
