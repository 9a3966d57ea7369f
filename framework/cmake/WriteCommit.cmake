# Writes OUTPUT, a header with the git commit of SOURCE_DIR, with "-dirty" behind it where framework/
# or experiments/ differ from it (a page made anew changes no program); an unchanged header keeps its
# time, so that nothing is built again. Without git or outside a checkout the commit is "unknown".
# usage: cmake -D SOURCE_DIR=... -D OUTPUT=... -P WriteCommit.cmake
cmake_minimum_required(VERSION 3.25)
set(COMMIT "")
find_program(GIT git)

# A checkout mounted into a container belongs to somebody else, which git refuses unless told.
function(ask_git ANSWER)
  execute_process(
    COMMAND ${GIT} -c safe.directory=* -C ${SOURCE_DIR} ${ARGN}
    OUTPUT_VARIABLE OUTPUT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  set(${ANSWER} "${OUTPUT}" PARENT_SCOPE)
endfunction()

if(GIT AND EXISTS ${SOURCE_DIR}/.git)
  ask_git(COMMIT rev-parse --short=12 HEAD)
  ask_git(CHANGES status --porcelain --untracked-files=no -- framework experiments)
  if(COMMIT AND CHANGES)
    string(APPEND COMMIT -dirty)
  endif()
endif()
if(NOT COMMIT)
  set(COMMIT unknown)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define CIRQUE_GIT_COMMIT \"@COMMIT@\"\n" @ONLY)
