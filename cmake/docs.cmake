# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs the pages of docs, with their pictures, into one folder: README.md, tutorial.md, guide/… and a link `examples`.
# Run by install(SCRIPT) with SOURCE, FOLDER (of the pages) and EXAMPLES (from there). Links to files that
# are not installed become plain text.
set(outside "\\.github|CHANGELOG\\.md|LICENSE|bench|clients|include|web|tests|tools|src|python|templates|tour")
file(GLOB pages RELATIVE ${SOURCE} ${SOURCE}/docs/*.md ${SOURCE}/docs/guide/*.md)
set(to $ENV{DESTDIR}${FOLDER})
foreach(page IN LISTS pages ITEMS README.md CONTRIBUTING.md)
  file(READ ${SOURCE}/${page} text)
  string(REGEX REPLACE "^docs/" "" name "${page}")
  # One folder less on the way up and down.
  string(REPLACE "](docs/" "](" text "${text}")
  if(page MATCHES "^docs/guide/")
    string(REPLACE "](../../" "](../" text "${text}")
  elseif(page MATCHES "^docs/")
    string(REPLACE "](../" "](" text "${text}")
  endif()
  string(REGEX REPLACE "\\[([^]]*)\\]\\((\\.\\./)*(${outside})(/[^)]*)?\\)" "\\1" text "${text}")
  file(WRITE ${to}/${name} "${text}")
  message(STATUS "Installing: ${to}/${name}")
endforeach()
file(COPY ${SOURCE}/llms.txt ${SOURCE}/docs/pictures DESTINATION ${to}
     FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ
     DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
file(REMOVE ${to}/examples)
file(CREATE_LINK ${EXAMPLES} ${to}/examples SYMBOLIC)
