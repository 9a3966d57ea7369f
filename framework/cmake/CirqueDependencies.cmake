# The libraries that cirque::cirque stands on, all from Debian 12. Read by the build and, installed
# beside cirqueConfig.cmake, by every project that finds the package; both set CIRQUE_CHOLMOD first.

# Found by their own CMake packages.
set(CIRQUE_PACKAGES Eigen3 Ceres fmt glog TBB ZLIB)

if(CIRQUE_CHOLMOD AND NOT TARGET cirque::cholmod)
  find_path(CIRQUE_CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
  find_library(CIRQUE_CHOLMOD_LIBRARY cholmod REQUIRED)
  find_library(CIRQUE_OPENBLAS_LIBRARY openblas REQUIRED)
  add_library(cirque::cholmod INTERFACE IMPORTED)
  target_include_directories(cirque::cholmod SYSTEM INTERFACE ${CIRQUE_CHOLMOD_INCLUDE_DIR})
  target_link_libraries(cirque::cholmod INTERFACE ${CIRQUE_CHOLMOD_LIBRARY})
  # Debian's libceres brings in ATLAS, whose BLAS would otherwise shadow OpenBLAS for CHOLMOD: the
  # first library in link order that defines dgemm_ wins, needed by our own code or not. Programs
  # with the property CIRQUE_HOLDS_OPENBLAS have it inside.
  set(CIRQUE_SHARED_BLAS
    "SHELL:-Wl,--push-state,--no-as-needed ${CIRQUE_OPENBLAS_LIBRARY} -Wl,--pop-state")
  target_link_options(cirque::cholmod INTERFACE
    "$<$<NOT:$<BOOL:$<TARGET_PROPERTY:CIRQUE_HOLDS_OPENBLAS>>>:${CIRQUE_SHARED_BLAS}>")
endif()
