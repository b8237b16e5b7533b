# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The studio: a program of its own, so that nobody waits for it who makes films from the command line.
embed_texts(studio/exercises_text.h src/studio/course/exercises.txt)
find_package(Qt6 REQUIRED COMPONENTS Widgets Network Test)
file(GLOB_RECURSE studio_sources CONFIGURE_DEPENDS src/studio/*.cpp src/studio/*.h)
list(FILTER studio_sources EXCLUDE REGEX "_program.cpp$")
add_library(betwixt_studio_room STATIC ${studio_sources} src/app/command.cpp src/app/streams.cpp src/app/live_input.cpp src/app/hearing.cpp
            src/app/sound_device.cpp src/app/templates.cpp src/studio/words/words.qrc src/studio/shell/icons.qrc)
target_include_directories(betwixt_studio_room PRIVATE ${CMAKE_BINARY_DIR}/made)
set_target_properties(betwixt_studio_room PROPERTIES AUTOMOC ON AUTORCC ON UNITY_BUILD ${BETWIXT_JUMBO} UNITY_BUILD_BATCH_SIZE 5)
target_precompile_headers(betwixt_studio_room PRIVATE <QtWidgets> <fmt/format.h> <algorithm> <map> <optional> <string> <vector>)
target_link_libraries(betwixt_studio_room PUBLIC betwixt_server Qt6::Widgets Qt6::Network PkgConfig::CONTROLS PkgConfig::ALSA)
# Words such as slots are ours.
target_compile_definitions(betwixt_studio_room PUBLIC QT_NO_SIGNALS_SLOTS_KEYWORDS PRIVATE BETWIXT_VERSION="${PROJECT_VERSION}")
# Nothing here is done often enough to be worth the building.
target_compile_options(betwixt_studio_room PRIVATE $<$<CONFIG:Release>:-O1>)
add_executable(betwixt_studio src/studio/shell/studio_program.cpp)
set_target_properties(betwixt_studio PROPERTIES OUTPUT_NAME betwixt-studio)
target_link_libraries(betwixt_studio PRIVATE betwixt_studio_room)
add_dependencies(betwixt_studio betwixt_parser)
install(TARGETS betwixt_studio RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/betwixt)

# Its tests, which tests/studio/run.sh runs: built when they are asked for.
add_custom_target(studio_tests)
file(GLOB studio_tests CONFIGURE_DEPENDS tests/studio/*_test.cpp)
foreach(source IN LISTS studio_tests)
  get_filename_component(name ${source} NAME_WE)
  add_executable(studio_${name} EXCLUDE_FROM_ALL ${source})
  set_target_properties(studio_${name} PROPERTIES AUTOMOC ON)
  target_include_directories(studio_${name} PRIVATE tests)
  target_compile_definitions(studio_${name} PRIVATE SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  target_link_libraries(studio_${name} PRIVATE betwixt_studio_room Qt6::Test)
  # As the other tests: without speed, which takes half of the time to build.
  target_compile_options(studio_${name} PRIVATE -O0 -g0 -UNDEBUG)
  if(first)
    target_precompile_headers(studio_${name} REUSE_FROM ${first})
  else()
    set(first studio_${name})
    target_precompile_headers(studio_${name} PRIVATE <QtTest> <QtWidgets> <fmt/format.h> <algorithm> <map> <optional>
                                                     <string> <vector>)
  endif()
  add_dependencies(studio_tests studio_${name})
endforeach()
add_executable(studio_gestures EXCLUDE_FROM_ALL tests/studio/gestures.cpp)
target_link_libraries(studio_gestures PRIVATE betwixt_studio_room Qt6::Test)
add_executable(bench_studio EXCLUDE_FROM_ALL bench/studio.cpp)
target_include_directories(bench_studio PRIVATE bench)
target_link_libraries(bench_studio PRIVATE betwixt_studio_room Qt6::Test)
