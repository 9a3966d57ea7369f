# The strategy newton_amg: a module that is loaded when it is asked for, because PETSc brings a
# hundred libraries along, whose loading every start of every program would pay. The module lies at
# one place relative to the programs in the build tree as installed.
set(CIRQUE_PETSC OFF)
if(CIRQUE_WITH_PETSC)
  list(APPEND CMAKE_PREFIX_PATH /usr/lib/petsc)  # where Debian has its PETSc.pc
  set(PETSC_REQUIRED)
  if(NOT CIRQUE_WITH_PETSC STREQUAL AUTO)
    set(PETSC_REQUIRED REQUIRED)
  endif()
  find_package(PkgConfig QUIET ${PETSC_REQUIRED})
  if(PkgConfig_FOUND)
    pkg_check_modules(CIRQUE_PETSC_LIBRARIES ${PETSC_REQUIRED} PETSc>=3.18 ompi-c)
    set(CIRQUE_PETSC ${CIRQUE_PETSC_LIBRARIES_FOUND})
  endif()
endif()
if(NOT CIRQUE_PETSC)
  message(STATUS "newton_amg: not built (CIRQUE_WITH_PETSC=${CIRQUE_WITH_PETSC}; it takes "
          "petsc-dev, libhypre-dev, libopenmpi-dev and pkg-config)")
  return()
endif()

set(MODULE_DIR ${CMAKE_INSTALL_LIBDIR}/cirque)
file(GLOB PETSC_SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/cirque/linear/petsc/*.cc)
add_library(cirque_petsc MODULE ${PETSC_SOURCES})
set_target_properties(cirque_petsc PROPERTIES
  PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${MODULE_DIR})
target_include_directories(cirque_petsc PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_include_directories(cirque_petsc SYSTEM PRIVATE ${CIRQUE_PETSC_LIBRARIES_INCLUDE_DIRS})
target_link_libraries(cirque_petsc PRIVATE cirque_warnings glog::glog
                      ${CIRQUE_PETSC_LIBRARIES_LINK_LIBRARIES})
foreach(COMPONENT programs development)
  install(TARGETS cirque_petsc DESTINATION ${MODULE_DIR} COMPONENT ${COMPONENT})
endforeach()

target_compile_definitions(cirque PRIVATE CIRQUE_PETSC)
set_source_files_properties(cirque/linear/multigrid.cc PROPERTIES COMPILE_DEFINITIONS
  "CIRQUE_PETSC_MODULE=\"${MODULE_DIR}/cirque_petsc.so\";\
CIRQUE_PETSC_INSTALLED_MODULE=\"${CMAKE_INSTALL_FULL_LIBDIR}/cirque/cirque_petsc.so\"")
# Whatever runs a program may ask for the module.
add_dependencies(cirque cirque_petsc)
