# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# betwixt_math: sines, powers and the like from musl, which are plain C. The C library's own choose among kinds of
# machines, and differ from those of web pages in the last bit now and then; with these a value is the same everywhere.
# Elsewhere than on Debian, or without musl-dev, they are the C library's.
set(steady_parts __cos __expo2 __math_divzero __math_invalid __math_oflow __math_uflow __math_xflow __rem_pio2
    __rem_pio2_large __sin __tan acos acosh asin asinh atan atan2 atanh cbrt cos cosh exp exp2 exp_data expm1 log log10
    log1p log2 log2_data log_data pow pow_data scalbn sin sincos sinh tan tanh)
set(steady_library ${CMAKE_BINARY_DIR}/libbetwixt_math.a)
file(GLOB steady_source /usr/lib/*-linux-musl/libc.a)
if(steady_source AND NOT EXISTS ${steady_library})
  list(TRANSFORM steady_parts APPEND .lo)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/steady)
  execute_process(COMMAND ${CMAKE_AR} x ${steady_source} ${steady_parts} WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/steady
                  COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_AR} rcs ${steady_library}.new ${steady_parts}
                  WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/steady COMMAND_ERROR_IS_FATAL ANY)
  file(RENAME ${steady_library}.new ${steady_library})
endif()
if(EXISTS ${steady_library})
  add_library(betwixt_math STATIC IMPORTED GLOBAL)
  set_target_properties(betwixt_math PROPERTIES IMPORTED_LOCATION ${steady_library})
else()
  message(STATUS "Values may differ in their last bit from those of other machines: there is no musl-dev")
  add_library(betwixt_math INTERFACE IMPORTED GLOBAL)
endif()
