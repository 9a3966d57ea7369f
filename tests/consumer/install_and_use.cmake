# Installs the library from BUILD_DIR, then configures, builds and runs the project of this folder,
# which knows nothing but find_package(cirque).
set(WORK ${BUILD_DIR}/consumer)
file(REMOVE_RECURSE ${WORK})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The program that the page on OpenMesh shows.
file(READ ${CMAKE_CURRENT_LIST_DIR}/../../framework/docs/openmesh.md PAGE)
string(REGEX REPLACE ".*```cpp\n(.*)\n```.*" "\\1" PROGRAM "${PAGE}")
file(WRITE ${WORK}/openmesh.cc "${PROGRAM}\n")

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --component development --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G ${GENERATOR}
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D WANTED_VERSION=${VERSION} -D OPENMESH_PROGRAM=${WORK}/openmesh.cc)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/package ${VERSION})
run(${WORK}/build/map_arrays)
run(${WORK}/build/own_energy)
run(${WORK}/build/openmesh)

# The same without CMake.
find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  file(GLOB_RECURSE PC ${WORK}/prefix/cirque.pc)
  execute_process(COMMAND ${PKG_CONFIG} --cflags --libs ${PC} OUTPUT_VARIABLE FLAGS
                  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(FLAGS UNIX_COMMAND "${FLAGS}")
  run(${COMPILER} -std=c++20 ${CMAKE_CURRENT_LIST_DIR}/map_arrays.cc ${FLAGS} -o ${WORK}/map_arrays)
  run(${WORK}/map_arrays)
endif()
