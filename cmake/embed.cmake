# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# embed_texts(HEADER FILE…): a header in the build folder with each file's text as a constant of the file's name:
# lesson.css becomes lesson_css. Written anew when a file changes.
function(embed_texts header)
  set(text "// Made from the files that it names.\n#pragma once\n\nnamespace betwixt {\n")
  foreach(file IN LISTS ARGN)
    get_filename_component(name ${file} NAME)
    string(MAKE_C_IDENTIFIER ${name} identifier)
    file(READ ${file} content)
    string(APPEND text "// ${file}\ninline constexpr const char* ${identifier} = R\"=text=(${content})=text=\";\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  string(APPEND text "}  // namespace betwixt\n")
  set(made ${CMAKE_BINARY_DIR}/made/${header})
  file(WRITE ${made}.new "${text}")
  file(COPY_FILE ${made}.new ${made} ONLY_IF_DIFFERENT)
endfunction()
