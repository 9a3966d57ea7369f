# A program with its libraries inside. A dynamic loader looks up the 14,000 names in OpenBLAS' tables of
# kernels at every start, which is a quarter of the time that a mesh of 1,000 triangles takes.
option(CIRQUE_LINK_ARCHIVES "Link circle_patterns with the archives of OpenBLAS, CHOLMOD and glog, where they are" ON)

# The archives and what they call in shared libraries; NOTFOUND where one is missing.
function(find_archives RESULT)
  set(FOUND)
  foreach(FILE cholmod.a amd.a camd.a ccolamd.a colamd.a suitesparseconfig.a cxsparse.a openblas.a
               glog.a gflags.a metis.so.5 gfortran.so.5 gomp.so.1 unwind.so.8)
    find_library(CIRQUE_LIB_${FILE} lib${FILE} PATH_SUFFIXES openblas-pthread)
    mark_as_advanced(CIRQUE_LIB_${FILE})
    if(NOT CIRQUE_LIB_${FILE})
      message(STATUS "circle_patterns: linked with shared libraries (no lib${FILE})")
      set(${RESULT} NOTFOUND PARENT_SCOPE)
      return()
    endif()
    list(APPEND FOUND ${CIRQUE_LIB_${FILE}})
  endforeach()
  set(${RESULT} ${FOUND} PARENT_SCOPE)
endfunction()

function(link_archives PROGRAM)
  if(NOT CIRQUE_LINK_ARCHIVES OR NOT CIRQUE_CHOLMOD OR CIRQUE_SANITIZE)
    return()
  endif()
  find_archives(ARCHIVES)
  if(ARCHIVES)
    set_property(TARGET ${PROGRAM} PROPERTY CIRQUE_HOLDS_OPENBLAS ON)  # asked by cirque::cholmod
    # What experiments/common/openblas.cc defines comes first and takes the place of OpenBLAS' own, and
    # of that of the shared OpenBLAS that PETSc brings.
    target_link_libraries(${PROGRAM} PRIVATE
      experiments_common "$<LINK_GROUP:RESCAN,cirque,Ceres::ceres,${ARCHIVES}>")
    # Its name is asked for weakly, which takes no member of an archive.
    target_link_options(${PROGRAM} PRIVATE -Wl,-z,muldefs -Wl,--undefined=openblas_get_config)
    foreach(NAME openblas_read_env openblas_verbose openblas_num_threads_env)
      target_link_options(${PROGRAM} PRIVATE -Wl,--export-dynamic-symbol=${NAME})
    endforeach()
  endif()
endfunction()
