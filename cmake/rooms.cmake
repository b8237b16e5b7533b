# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# How the rooms are compiled. tests/CMakeLists.txt makes a second set of them, under sanitizers.

# What nearly every file includes is read once, for all targets that are compiled alike, and the files of a room are
# compiled some at a time: that is four times as fast, as most of the time goes into headers and templates. Names in
# anonymous namespaces differ within a room.
function(precompile target first header)
  if(NOT BETWIXT_JUMBO)
    return()
  elseif(target STREQUAL first)
    target_precompile_headers(${target} PRIVATE ${header})
  else()
    target_precompile_headers(${target} REUSE_FROM ${first})
  endif()
endfunction()
function(quicker target first)
  precompile(${target} ${first} ${PROJECT_SOURCE_DIR}/cmake/often.h)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${BETWIXT_JUMBO} UNITY_BUILD_BATCH_SIZE 8)
endfunction()

# These stand alone: they are compiled once for each kind of machine, or include much that is not ours.
set(kernels algebra/kernels.cpp program/environment_kernels.cpp program/playing_kernels.cpp)
set(loners ${kernels} exchange/gltf_model.cpp exchange/meshes_gltf.cpp exchange/scene_gltf.cpp exchange/assimp_model.cpp
    exchange/meshes_assimp.cpp exchange/scene_assimp.cpp server/aim.cpp)
list(TRANSFORM kernels PREPEND ${PROJECT_SOURCE_DIR}/src/)
list(TRANSFORM loners PREPEND ${PROJECT_SOURCE_DIR}/src/)

# add_rooms(PREFIX): a static library PREFIX_ROOM for each room.
function(add_rooms prefix)
  set_source_files_properties(${loners} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set(above "")
  foreach(room IN LISTS BETWIXT_ROOMS)
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${room}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "_program.cpp$")
    add_library(${prefix}_${room} STATIC ${sources})
    target_include_directories(${prefix}_${room} PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
    set_target_properties(${prefix}_${room} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    if(above)
      target_link_libraries(${prefix}_${room} PUBLIC ${prefix}_${above})
    endif()
    set(above ${room})
    quicker(${prefix}_${room} ${prefix}_base)
  endforeach()
  target_link_libraries(${prefix}_base PUBLIC betwixt_math fmt::fmt Threads::Threads)
  target_link_libraries(${prefix}_algebra PRIVATE PkgConfig::HWY)
  target_link_libraries(${prefix}_program PRIVATE PkgConfig::HWY PkgConfig::BULLET)
  target_link_libraries(${prefix}_procedure PRIVATE PkgConfig::LUA ${CMAKE_DL_LIBS})
  target_link_libraries(${prefix}_exchange PRIVATE PkgConfig::TYPE PkgConfig::ASSIMP PkgConfig::GLTF PkgConfig::PUGIXML
                        PkgConfig::SPNG PkgConfig::EXR PkgConfig::SQLITE meshoptimizer::meshoptimizer)
  target_link_libraries(${prefix}_render PRIVATE PkgConfig::EGL embree)
  target_link_libraries(${prefix}_film PRIVATE PkgConfig::SPNG)
endfunction()

# Under all sanitizers the kernels alone would take a minute to build. Without speed they can be tested all the same.
function(watch_kernels)
  set_source_files_properties(${kernels} PROPERTIES COMPILE_OPTIONS -fno-sanitize=undefined SKIP_PRECOMPILE_HEADERS ON)
endfunction()
