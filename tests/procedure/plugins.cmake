# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The plug-ins that the tests load, made as a stranger would: with the public header alone, in C.
enable_language(C)
file(GLOB plugins CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/plugins/*.c)
foreach(source IN LISTS plugins ITEMS ${CMAKE_SOURCE_DIR}/examples/plugin/example.c)
  get_filename_component(name ${source} NAME_WE)
  add_library(plugin_${name} MODULE ${source})
  target_include_directories(plugin_${name} PRIVATE include)
  set_target_properties(plugin_${name} PROPERTIES PREFIX "" OUTPUT_NAME ${name} C_STANDARD 99 C_STANDARD_REQUIRED ON
                        C_EXTENSIONS OFF LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins)
  add_dependencies(test_procedure plugin_${name})
  add_dependencies(test_commands plugin_${name})
  add_dependencies(test_editor plugin_${name})
endforeach()
foreach(test IN ITEMS test_procedure test_commands test_editor)
  target_compile_definitions(${test} PRIVATE PLUGIN_DIR="${CMAKE_BINARY_DIR}/plugins")
endforeach()
