// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fuzzes the reader of SVG files with any text.
#include "exchange/drawing.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

#include "exchange/wire_format.h"
#include "fuzz.h"

using namespace betwixt;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Slow slow;
  const auto drawing = read_svg(std::string(reinterpret_cast<const char*>(data), size), "x.svg");
  if (!drawing) {
    insist(!drawing.error().message.empty(), "an error has words");
    return slow.verdict();
  }
  // What is read is handed over whole: its names are names, its numbers are somewhere.
  const int memory = ::memfd_create("drawing", MFD_CLOEXEC);
  Parsed taken;
  insist(write_parsed(*drawing, memory) == 0 && read_parsed(memory, taken) == 0, "a drawing can be handed over");
  ::close(memory);
  return slow.verdict();
}
