# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
add_executable(fuzz_language tests/fuzz/language.cpp)
target_link_libraries(fuzz_language PRIVATE betwixt_commands)
target_link_options(fuzz_language PRIVATE -fsanitize=fuzzer)
