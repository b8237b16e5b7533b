// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt contacts: what touches and what leaves the view in a film, as JSON lines.
#include <fmt/format.h>

#include "app/command.h"
#include "betwixt/program.h"
#include "scene/document.h"

namespace betwixt {
namespace {

struct Call {
  std::string file, frames;
  bool sweep = false;
  ContactOptions options;
};

int contacts(const Call& call) {
  const auto document = open_script(call.file);
  if (!document) return wrong_input;
  const auto frames = read_frames(call.frames, *document);
  if (!frames) return complain(frames.error(), wrong_call);
  const Rate ticks = document->scene().ticks;
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
      problems.say({fmt::format("more than {} pairs touch at once: the rest is left out", Contacts::most_pairs)});
  }
  return all_done;
}

}  // namespace

void add_contacts(CLI::App& app, int& exit_code) {
  const auto call = std::make_shared<Call>();
  CLI::App* sub = app.add_subcommand("contacts", "prints what touches and what leaves the view, tick by tick");
  sub->add_option("FILE", call->file, "the script")->required()->type_name("");
  sub->add_option("--frames", call->frames, "these only, ends included: 1f..24f")->type_name("A..B");
  sub->add_flag("--swept", call->sweep, "what touches between two ticks too");
  sub->add_flag("--related", call->options.related, "the parts of one body too");
  sub->footer("Example:\n  betwixt contacts examples/bounce.bx --frames 1f..24f");
  sub->callback([call, &exit_code] { exit_code = contacts(*call); });
}

}  // namespace betwixt
