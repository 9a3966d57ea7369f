# `cmake --install`: the library, its public headers as cirque/FOLDER/NAME.h, and the package that
# find_package(cirque) reads.
include(CMakePackageConfigHelpers)
set(CIRQUE_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/cirque)

install(TARGETS cirque EXPORT cirqueTargets COMPONENT development)
# Only what cirque/cirque.h reaches is for users; a test keeps the list to that.
set(CIRQUE_PUBLIC_HEADERS ${PROJECT_SOURCE_DIR}/framework/public_headers.txt)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CIRQUE_PUBLIC_HEADERS})
file(STRINGS ${CIRQUE_PUBLIC_HEADERS} HEADERS REGEX "^cirque/")
foreach(HEADER ${HEADERS})
  cmake_path(GET HEADER PARENT_PATH FOLDER)
  install(FILES ${PROJECT_SOURCE_DIR}/framework/${HEADER} COMPONENT development
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${FOLDER})
endforeach()
install(EXPORT cirqueTargets NAMESPACE cirque:: COMPONENT development
        DESTINATION ${CIRQUE_PACKAGE_DIR})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/cirqueConfig.cmake.in
  ${PROJECT_BINARY_DIR}/package/cirqueConfig.cmake INSTALL_DESTINATION ${CIRQUE_PACKAGE_DIR})
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/cirqueConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/cirqueConfig.cmake
              ${PROJECT_BINARY_DIR}/package/cirqueConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/CirqueDependencies.cmake
        COMPONENT development DESTINATION ${CIRQUE_PACKAGE_DIR})
# The same for who builds without CMake.
if(CIRQUE_CHOLMOD)
  # OpenBLAS before what Ceres brings in (CirqueDependencies.cmake).
  set(CIRQUE_PC_LIBS "-lcholmod -Wl,--push-state,--no-as-needed -lopenblas -Wl,--pop-state")
  set(CIRQUE_PC_CFLAGS "-DCIRQUE_CHOLMOD -I${CIRQUE_CHOLMOD_INCLUDE_DIR}")
endif()
# The prefix is that of where the file lies, wherever it is installed.
file(RELATIVE_PATH CIRQUE_PC_PREFIX /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(${CMAKE_CURRENT_LIST_DIR}/cirque.pc.in ${PROJECT_BINARY_DIR}/package/cirque.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/cirque.pc COMPONENT development
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT development)
