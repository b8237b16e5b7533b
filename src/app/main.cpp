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

// Opens closed standard streams, because a file opened later would get their number, and receive output meant for them.
void fill_streams() {
  for (int file = 0; file <= STDERR_FILENO; ++file)
    if (::fcntl(file, F_GETFD) < 0) (void)::open("/dev/null", O_RDWR);  // takes the lowest free number: this one
}

}  // namespace

int main(int argc, char** argv) {
  fill_streams();
  try {
    return betwixt::command_line(argc, argv);
  } catch (const std::exception& e) {  // above all, out of memory
    betwixt::tell_user(std::string("betwixt: error: the program failed: ") + e.what() + "\n");
    return betwixt::machine_failed;
  }
}
