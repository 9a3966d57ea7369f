# Writes OUTPUT, a header with a line {"path", "hash"}, for every file that LIST names, one a line,
# relative to SOURCE_DIR; an unchanged header keeps its time, so that nothing is built again.
# usage: cmake -D SOURCE_DIR=... -D LIST=... -D OUTPUT=... -P HashSources.cmake
cmake_minimum_required(VERSION 3.25)
file(STRINGS ${LIST} PATHS)
set(LINES "")
foreach(SOURCE ${PATHS})
  file(SHA256 ${SOURCE_DIR}/${SOURCE} HASH)
  string(SUBSTRING ${HASH} 0 16 HASH)
  string(APPEND LINES "{\"${SOURCE}\", \"${HASH}\"},\n")
endforeach()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "${LINES}" @ONLY)
