// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <unistd.h>

#include <exception>
#include <string>

#include "app/command.h"
#include "app/command_line.h"
#include "base/tell_user.h"

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
    betwixt::tell_user(std::string("betwixt: error: the machine failed: ") + e.what() + "\n");
    return betwixt::machine_failed;
  }
}
