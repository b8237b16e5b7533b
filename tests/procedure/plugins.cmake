# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The plug-ins that the tests load, made as a stranger would: with the public header alone, in C.
enable_language(C)
file(GLOB plugins CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/plugins/*.c)
foreach(source IN LISTS plugins ITEMS ${CMAKE_SOURCE_DIR}/examples/plugin/example.c)
  get_filename_component(name ${source} NAME_WE)
  add_library(plugin_${name} MODULE EXCLUDE_FROM_ALL ${source})
  target_include_directories(plugin_${name} PRIVATE ${PROJECT_SOURCE_DIR}/include)
  set_target_properties(plugin_${name} PROPERTIES PREFIX "" OUTPUT_NAME ${name} C_STANDARD 99 C_STANDARD_REQUIRED ON
                        C_EXTENSIONS OFF LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins)
  foreach(room IN ITEMS procedure commands editor render)
    add_dependencies(test_${room} plugin_${name})
    if(TARGET watched_test_${room})
      add_dependencies(watched_test_${room} plugin_${name})
    endif()
  endforeach()
endforeach()
foreach(room IN ITEMS procedure commands editor render)
  target_compile_definitions(checks_${room} PRIVATE PLUGIN_DIR="${CMAKE_BINARY_DIR}/plugins")
endforeach()
