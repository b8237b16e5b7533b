# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
add_executable(bench_parse bench/parse.cpp)
target_link_libraries(bench_parse PRIVATE betwixt_language)
add_executable(bench_environments bench/environments.cpp bench/copying.cpp)
target_link_libraries(bench_environments PRIVATE betwixt_program PkgConfig::HWY)
target_include_directories(bench_environments PRIVATE bench)
add_executable(bench_contacts bench/contacts.cpp)
target_link_libraries(bench_contacts PRIVATE betwixt_program)
target_include_directories(bench_contacts PRIVATE bench)
add_executable(bench_algebra bench/algebra.cpp bench/kernel_copies.cpp)
target_include_directories(bench_algebra PRIVATE bench)
target_link_libraries(bench_algebra PRIVATE betwixt_algebra PkgConfig::HWY)
