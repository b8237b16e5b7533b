# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# What libbetwixt is made with. Whoever links the static library needs the same: the CMake package includes this file.
if(NOT TARGET betwixt_math)  # where it is installed: beside the library
  get_filename_component(betwixt_math ${CMAKE_CURRENT_LIST_DIR}/../../libbetwixt_math.a ABSOLUTE)
  if(EXISTS ${betwixt_math})
    add_library(betwixt_math STATIC IMPORTED)
    set_target_properties(betwixt_math PROPERTIES IMPORTED_LOCATION ${betwixt_math})
  else()
    add_library(betwixt_math INTERFACE IMPORTED)
  endif()
endif()
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(fmt REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(embree 3 REQUIRED)
pkg_check_modules(HWY REQUIRED QUIET IMPORTED_TARGET libhwy)
pkg_check_modules(BULLET REQUIRED QUIET IMPORTED_TARGET bullet)
pkg_check_modules(EGL REQUIRED QUIET IMPORTED_TARGET egl glesv2)
pkg_check_modules(TYPE REQUIRED QUIET IMPORTED_TARGET freetype2 harfbuzz fontconfig glu)
pkg_check_modules(ASSIMP REQUIRED QUIET IMPORTED_TARGET assimp)
pkg_check_modules(GLTF REQUIRED QUIET IMPORTED_TARGET tinygltf stb)
pkg_check_modules(PUGIXML REQUIRED QUIET IMPORTED_TARGET pugixml)
pkg_check_modules(SQLITE REQUIRED QUIET IMPORTED_TARGET sqlite3)
pkg_check_modules(SPNG REQUIRED QUIET IMPORTED_TARGET spng)
pkg_check_modules(EXR REQUIRED QUIET IMPORTED_TARGET OpenEXR)
pkg_check_modules(LUA REQUIRED QUIET IMPORTED_TARGET lua5.4)
