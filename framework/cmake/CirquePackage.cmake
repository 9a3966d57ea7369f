# `cpack --config build/package/CPackConfig.cmake`: Debian packages, of the preset `package`. cirque holds the programs, their
# man pages and the Python module where it is built; cirque-dev the library with its headers.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Cirque authors <cirque@localhost.invalid>")
set(CPACK_PACKAGE_VENDOR "The Cirque authors")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL programs development)
if(TARGET cirque_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENT_PROGRAMS_GROUP programs)
set(CPACK_COMPONENT_PYTHON_GROUP programs)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME cirque)
if(TARGET cirque_python)
  set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS python3-numpy)
endif()
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME cirque-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# The library is static: who links it needs what it stands on.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libceres-dev, libeigen3-dev, libfmt-dev, libgoogle-glog-dev, libsuitesparse-dev, \
libopenblas-dev, libtbb-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "libopenmesh-dev")
include(CPack)
