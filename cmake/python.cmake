# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The Python module: for Debian's own Python, whichever other one is first on the path. It is built into python/betwixt
# below the build's folder, from where it can be used as it is.
set(PYBIND11_FINDPYTHON ON)
set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that the module is for")
find_package(pybind11 2.10 REQUIRED)

file(GLOB python_sources CONFIGURE_DEPENDS python/*.cpp)
pybind11_add_module(betwixt_python NO_EXTRAS ${python_sources})
set(python_package ${CMAKE_BINARY_DIR}/python/betwixt)
set_target_properties(betwixt_python PROPERTIES UNITY_BUILD ${BETWIXT_JUMBO} UNITY_BUILD_BATCH_SIZE 5 OUTPUT_NAME _core LIBRARY_OUTPUT_DIRECTORY ${python_package})
target_compile_definitions(betwixt_python PRIVATE BETWIXT_VERSION="${PROJECT_VERSION}")
target_link_libraries(betwixt_python PRIVATE betwixt_playback)
target_link_options(betwixt_python PRIVATE -Wl,--exclude-libs,ALL)
add_dependencies(betwixt_python betwixt_parser)

file(GLOB python_texts CONFIGURE_DEPENDS python/betwixt/*.py python/betwixt/*.pyi python/betwixt/py.typed)
add_custom_target(betwixt_python_texts COMMAND ${CMAKE_COMMAND} -E make_directory ${python_package}
                  COMMAND ${CMAKE_COMMAND} -E copy_if_different ${python_texts} ${python_package})
add_dependencies(betwixt_python betwixt_python_texts)
# What it reads files of others with stands beside it.
add_custom_command(TARGET betwixt_python POST_BUILD
                   COMMAND ${CMAKE_COMMAND} -E create_symlink $<TARGET_FILE:betwixt_parser>
                           ${python_package}/betwixt-parser)

# Where Debian's Python looks below /usr/local. (Below ~/.local it is site-packages.)
set(BETWIXT_PYTHON_FOLDER lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/dist-packages
    CACHE STRING "Where the Python module is installed, below the prefix")
install(TARGETS betwixt_python LIBRARY DESTINATION ${BETWIXT_PYTHON_FOLDER}/betwixt)
install(FILES ${python_texts} DESTINATION ${BETWIXT_PYTHON_FOLDER}/betwixt)
