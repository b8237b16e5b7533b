# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# cmake -DSOURCE=… -DMADE=… -P commit.cmake: a header with the commit that is built, or "" where there is no history.
# Written only when it differs, so that one file is compiled anew and no more.
set(commit "")
if(EXISTS ${SOURCE}/.git)
  execute_process(COMMAND git rev-parse --short=9 HEAD WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit
                  ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
  if(failed)
    set(commit "")
  endif()
endif()
file(WRITE ${MADE}.new "#pragma once\n#define BETWIXT_COMMIT \"${commit}\"\n")
file(COPY_FILE ${MADE}.new ${MADE} ONLY_IF_DIFFERENT)
