// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt contacts: which objects touch or leave the view in a film, as JSON lines.
#include <fmt/format.h>

#include "app/command.h"
#include "app/subcommand.h"
#include "betwixt/program.h"

namespace betwixt {
namespace {

struct ContactsCall {
  std::string file, frames;
  bool sweep = false;
  ContactOptions options;
};

int contacts(const ContactsCall& call) {
  const auto document = open_script(call.file);
  if (!document) return wrong_input;
  const auto frames = read_frames(call.frames, *document);
  if (!frames) return complain(frames.error(), wrong_call);
  const Rate ticks = document->ticks();
  const auto tick = [&](std::int64_t n) { return ticks.span(static_cast<double>(n)); };
  std::int64_t n = ticks.whole(frames->first);
  if (tick(n) < frames->first) ++n;
  const Time last = frames->time(frames->count - 1);
  const Program program = Program::compile(*document);
  ContactWatch watch(call.options, call.sweep);
  Problems problems;
  for (; tick(n) <= last; ++n) {
    const Frame frame = program.frame(tick(n));
    problems.say(frame.problems);
    for (const ContactEvent& e : watch.step(frame)) fmt::print("{}\n", to_json(e, *document));
    if (!watch.now().complete)
      problems.say({fmt::format("more than {} pairs touch at once; the others are left out", Contacts::most_pairs)});
  }
  return all_done;
}

const Enlisted enlisted_contacts(contacts, [](ContactsCall& call) -> Subcommand {
  return {.rank = 90,
          .name = "contacts",
          .sentence = "prints which things touch and which leave the view, tick by tick",
          .takes = {script_parameter(call.file), frames_parameter(call.frames),
                    flag("--swept", "finds contacts between two ticks, too", call.sweep),
                    flag("--related", "finds contacts between the parts of one body, too", call.options.related)},
          .example = "betwixt contacts examples/bounce.bx --frames 1f..24f",
          .manual =
              "It prints a line of JSON when a contact begins or ends, and when an object enters or leaves the view."};
});

}  // namespace
}  // namespace betwixt
