# Writes OUTPUT, a header with the git commit of SOURCE_DIR; an unchanged header keeps its time, so
# that nothing is built again. Without git or outside a checkout the commit is "unknown".
# usage: cmake -D SOURCE_DIR=... -D OUTPUT=... -P WriteCommit.cmake
set(COMMIT "")
cmake_minimum_required(VERSION 3.25)
find_program(GIT git)
if(GIT AND EXISTS ${SOURCE_DIR}/.git)
  # A checkout mounted into a container belongs to somebody else, which git refuses unless told.
  execute_process(
    COMMAND ${GIT} -c safe.directory=* -C ${SOURCE_DIR} describe --always --abbrev=12 --dirty
            --exclude=*
    OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT COMMIT)
  set(COMMIT unknown)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define CIRQUE_GIT_COMMIT \"@COMMIT@\"\n" @ONLY)
