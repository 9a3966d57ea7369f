# `cmake --install`: the library, its headers as cirque/FLOOR/NAME.h, and the package that
# find_package(cirque) reads.
include(CMakePackageConfigHelpers)
set(CIRQUE_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/cirque)

install(TARGETS cirque EXPORT cirqueTargets COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/framework/cirque/ COMPONENT development
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cirque
        FILES_MATCHING PATTERN "*.h" PATTERN petsc EXCLUDE)
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
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT development)
