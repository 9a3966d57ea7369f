# Language level, warnings, sanitizers and ccache, for every target of the project.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

# Exact predicates rely on every product being rounded by itself.
add_compile_options(-ffp-contract=off)

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

if(CIRQUE_SANITIZE)
  add_compile_options(-fsanitize=${CIRQUE_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all
                      # What the processor traps or does by itself makes a quarter of the code.
                      -fno-sanitize=null,alignment,vptr)
  add_link_options(-fsanitize=${CIRQUE_SANITIZE})
endif()

# The warnings of our own targets; libraries' headers are system headers and stay silent.
add_library(cirque_warnings INTERFACE)
target_compile_options(cirque_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-qual
  -Wundef -Wdouble-promotion
  # GCC 12 takes the concatenation of short strings for overlapping copies.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  $<$<BOOL:${CIRQUE_WARNINGS_AS_ERRORS}>:-Werror>)
