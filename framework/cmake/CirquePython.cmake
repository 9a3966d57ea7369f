# The Python package: where Python's headers, numpy and pybind11 are found, and where it is installed.
set(CIRQUE_PYTHON_FOUND OFF)
if(CIRQUE_PYTHON AND NOT CIRQUE_SANITIZE)
  set(PYTHON_REQUIRED QUIET)
  if(NOT CIRQUE_PYTHON STREQUAL AUTO)
    set(PYTHON_REQUIRED REQUIRED)
  endif()
  # Debian's own interpreter, which has Debian's numpy, before others on the path; a build of a wheel
  # names the one that it is for.
  if(NOT DEFINED Python_EXECUTABLE AND NOT DEFINED SKBUILD AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3)
  endif()
  find_package(Python 3.9 ${PYTHON_REQUIRED} COMPONENTS Interpreter Development.Module NumPy)
  if(Python_FOUND)
    set(PYBIND11_FINDPYTHON ON)
    find_package(pybind11 2.9 CONFIG ${PYTHON_REQUIRED})
    set(CIRQUE_PYTHON_FOUND ${pybind11_FOUND})
  endif()
endif()
if(NOT CIRQUE_PYTHON_FOUND)
  message(STATUS "the Python package: not built (CIRQUE_PYTHON=${CIRQUE_PYTHON}; it takes "
          "python3-dev, python3-numpy and pybind11-dev, and no sanitizer)")
  return()
endif()

# Relative to the prefix. Debian's Python looks for packages in lib/python3/dist-packages of /usr, in
# lib/python3.N/dist-packages of /usr/local; of any other prefix PYTHONPATH names the folder.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(PACKAGES lib/python3/dist-packages)
elseif(EXISTS /etc/debian_version)
  set(PACKAGES lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/dist-packages)
else()
  set(PACKAGES lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/site-packages)
endif()
set(CIRQUE_PYTHON_PACKAGES ${PACKAGES} CACHE STRING "Where the Python package is installed")
