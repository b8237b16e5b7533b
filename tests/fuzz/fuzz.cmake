# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# A target takes the rooms that it feeds and no more: what is linked is looked through after every execution.
function(fuzz_target name room)
  add_executable(fuzz_${name} tests/fuzz/${name}.cpp)
  target_link_libraries(fuzz_${name} PRIVATE betwixt_${room})
  target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
endfunction()
fuzz_target(motion algebra)
fuzz_target(drawing exchange)
fuzz_target(language commands)
fuzz_target(protocol server)
fuzz_target(scene exchange)
fuzz_target(lsp lsp)
fuzz_target(words exchange)
fuzz_target(tables exchange)
