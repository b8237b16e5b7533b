// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Prints the position of a ball at frame 13, half way up, and its tracks.
#include <cstdio>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "betwixt/track.h"

int main() {
  const betwixt::Loaded loaded = betwixt::load_text(
      "rate 24\n"
      "create ball sphere\n"
      "ball.position\n"
      "  1f (0 0 0)\n"
      "  25f (4 8 -2) linear\n",
      "ball.bx");
  for (const betwixt::Diagnostic& d : loaded.diagnostics) std::fputs(to_string(d).c_str(), stderr);
  const auto program = betwixt::Program::compile(loaded.document);
  const betwixt::Frame frame = program.frame(loaded.document.rate().frame(13));
  if (frame.items.size() != 1) return 1;
  const betwixt::Vec3 at = translation_of(frame.items.front().world);
  std::printf("%g %g %g\n", at.x, at.y, at.z);
  for (const betwixt::TrackView& track : tracks(loaded.document, loaded.document.find("ball"))) {
    std::printf("%s\n", loaded.document.name(track.target).c_str());
    for (const betwixt::EventView& e : events(loaded.document, track.target))
      std::printf("%s%s%s\n", format_time(e.time, loaded.document).c_str(), e.twerper.empty() ? "" : " ",
                  std::string(e.twerper).c_str());
  }
}
