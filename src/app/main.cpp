// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <exception>

#include "app/command.h"
#include "app/command_line.h"

namespace {

// Nothing that is opened later gets the place of a standard stream that is closed: what is meant for it would be
// written there.
void fill_streams() {
  for (int file = 0; file <= STDERR_FILENO; ++file)
    if (::fcntl(file, F_GETFD) < 0) (void)::open("/dev/null", O_RDWR);  // takes the lowest that is free: this one
}

}  // namespace

int main(int argc, char** argv) {
  fill_streams();
  try {
    return betwixt::command_line(argc, argv);
  } catch (const std::exception& e) {  // memory that is not to be had, above all
    std::fprintf(stderr, "betwixt: error: the machine failed: %s\n", e.what());
    return betwixt::machine_failed;
  }
}
