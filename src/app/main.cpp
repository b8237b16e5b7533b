// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>

#include "app/command.h"
#include "app/command_line.h"

int main(int argc, char** argv) {
  try {
    return betwixt::command_line(argc, argv);
  } catch (const std::exception& e) {  // memory that is not to be had, above all
    std::fprintf(stderr, "betwixt: the machine failed: %s\n", e.what());
    return betwixt::machine_failed;
  }
}
