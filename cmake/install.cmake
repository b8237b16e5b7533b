# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# One library from all rooms, and what a stranger needs to use it and the program.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

add_library(betwixt_library)
set_target_properties(betwixt_library PROPERTIES OUTPUT_NAME betwixt EXPORT_NAME betwixt LINKER_LANGUAGE CXX
                      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
target_compile_features(betwixt_library PUBLIC cxx_std_20)
target_include_directories(betwixt_library PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                                  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
foreach(room IN LISTS BETWIXT_ROOMS)
  target_sources(betwixt_library PRIVATE $<TARGET_OBJECTS:betwixt_${room}>)
  get_target_property(libraries betwixt_${room} LINK_LIBRARIES)
  list(FILTER libraries EXCLUDE REGEX "^betwixt_")
  target_link_libraries(betwixt_library PRIVATE ${libraries})
endforeach()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/betwixt)
write_basic_package_version_file(betwixtConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(TARGETS betwixt_library EXPORT betwixt)
install(EXPORT betwixt NAMESPACE betwixt:: FILE betwixtTargets.cmake DESTINATION ${package})
install(FILES cmake/betwixtConfig.cmake cmake/dependencies.cmake ${CMAKE_BINARY_DIR}/betwixtConfigVersion.cmake
        DESTINATION ${package})
if(EXISTS ${steady_library})
  install(FILES ${steady_library} DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
# For pkg-config. A static library needs what it was made with; a shared one has it.
string(REGEX REPLACE "[^/]+" ".." pc_up ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(NOT BUILD_SHARED_LIBS)
  set(pc_libraries " -lstdc++ -lmeshoptimizer -lembree3 -lpthread -ldl -lm")
  if(EXISTS ${steady_library})
    string(PREPEND pc_libraries " -lbetwixt_math")
  endif()
  set(pc_requires "Requires: fmt libhwy bullet lua5.4 egl glesv2 freetype2 harfbuzz fontconfig glu assimp tinygltf stb pugixml spng sqlite3 OpenEXR")
endif()
configure_file(packaging/betwixt.pc.in packaging/betwixt.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/packaging/betwixt.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(TARGETS betwixt_parser RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/betwixt)
install(FILES packaging/example/still.cpp packaging/example/CMakeLists.txt DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libbetwixt-dev/examples)
install(DIRECTORY include/betwixt DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if(TARGET betwixt_command)
  install(TARGETS betwixt_command)
  # What shells complete and what the manual says, as the program itself says it.
  foreach(row IN ITEMS "manual betwixt.1 ${CMAKE_INSTALL_MANDIR}/man1"
                       "bash betwixt ${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
                       "zsh _betwixt ${CMAKE_INSTALL_DATADIR}/zsh/site-functions"
                       "fish betwixt.fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
    separate_arguments(row UNIX_COMMAND "${row}")
    list(POP_FRONT row what file folder)
    set(printed ${CMAKE_BINARY_DIR}/packaging/${file})
    add_custom_command(OUTPUT ${printed} COMMAND betwixt_command help --print ${what} > ${printed} DEPENDS betwixt_command
                       VERBATIM)
    list(APPEND all_printed ${printed})
    install(FILES ${printed} DESTINATION ${folder})
  endforeach()
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/packaging)
  add_custom_target(packaging ALL DEPENDS ${all_printed})
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT docs)
install(CODE "set(SOURCE \"${PROJECT_SOURCE_DIR}\")
set(FOLDER \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DOCDIR}\")
set(EXAMPLES ../../betwixt/examples)" COMPONENT docs)
install(SCRIPT cmake/docs.cmake COMPONENT docs)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/betwixt COMPONENT docs)
install(DIRECTORY clients/vim clients/vscode DESTINATION ${CMAKE_INSTALL_DATADIR}/betwixt)
# What plays in pages, where it has been built (tools/web.sh).
install(FILES ${CMAKE_BINARY_DIR}/../web/betwixt-player.js DESTINATION ${CMAKE_INSTALL_DATADIR}/betwixt/web OPTIONAL)
# What desktops show: an icon for films and for the studio, and its entry in menus.
file(STRINGS CHANGELOG.md released REGEX "^## ${PROJECT_VERSION} " ENCODING UTF-8)
string(REGEX MATCH "[0-9]+-[0-9]+-[0-9]+" BETWIXT_RELEASE_DATE "${released}")
set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable)
install(FILES packaging/desktop/betwixt.svg DESTINATION ${icons}/mimetypes RENAME text-x-betwixt.svg)
install(FILES packaging/desktop/betwixt.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES packaging/betwixt-farm.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
if(TARGET betwixt_studio)
  configure_file(packaging/desktop/org.betwixt.Studio.metainfo.xml.in packaging/org.betwixt.Studio.metainfo.xml @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/packaging/org.betwixt.Studio.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
  install(FILES packaging/desktop/betwixt.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES packaging/desktop/betwixt.svg DESTINATION ${icons}/apps)
endif()
install(PROGRAMS clients/slurm/betwixt-farm DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES clients/python/betwixt_client.py DESTINATION ${CMAKE_INSTALL_DATADIR}/betwixt/python)
