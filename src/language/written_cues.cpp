// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes sections, steps and descriptions.
#include <fmt/format.h>

#include "language/values.h"
#include "scene/sections.h"

namespace betwixt {

std::string write_pause(const Pause& pause, Rate rate) {
  return fmt::format("at {} step{}{}", write_time(pause.time, rate),
                     pause.text.empty() ? "" : " " + write_text(pause.text),
                     pause.note.empty() ? "" : " note=" + write_text(pause.note));
}

std::string write_description(const Description& said, Rate rate) {
  return fmt::format("at {} describe {}", write_time(said.time, rate), write_text(said.text));
}

std::string write_cues(const Scene& s) {
  std::string out;
  for (const Section& one : *s.sections) {
    const Time own = SectionClock{{}, one.speed}.own_time(one.end - one.begin);
    out += fmt::format("section {} at {}{}{}\n", one.name, write_time(one.begin, s.rate),
                       own > Time{} ? " for " + write_seconds(own) : "",
                       one.speed == 1 ? "" : " speed=" + write_number(one.speed));
  }
  for (const auto& [time, pause] : *s.pauses) out += write_pause(pause, s.rate) + "\n";
  for (const auto& [time, said] : *s.descriptions) out += write_description(said, s.rate) + "\n";
  return out;
}

}  // namespace betwixt
