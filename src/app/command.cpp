// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"

#include <fmt/format.h>
#include <signal.h>

#include <cmath>
#include <cstdio>

#include "app/streams.h"
#include "base/tell_user.h"

namespace betwixt {
namespace {

volatile sig_atomic_t stop_asked = 0;

}  // namespace

int complain(const Error& e, int otherwise) {
  tell_user(fmt::format("betwixt: error: {}\n", e.message));
  if (!e.hint.empty()) tell_user(fmt::format("  {}\n", e.hint));
  return e.code == ErrorCode::machine ? static_cast<int>(machine_failed) : otherwise;
}

void tell_user(const Diagnostic& d) { tell_user((d.what.place.file.empty() ? "betwixt: " : "") + to_string(d)); }

LoadOptions& load_options() {
  static LoadOptions options;
  return options;
}

Loaded load_script(const std::string& file) {
  if (!is_stream(file)) return load_file(file, load_options());
  const Result<std::string> text = script_text(file);
  if (text) return load_text(*text, "<stdin>", load_options());
  return {Document(), {{Severity::error, text.error(), {}, 0}}};
}

std::optional<Document> open_script(const std::string& file) {
  Loaded loaded = load_script(file);
  for (const Diagnostic& d : loaded.diagnostics)
    if (d.severity != Severity::notice) tell_user(d);
  if (has_errors(loaded.diagnostics)) return std::nullopt;
  return std::move(loaded.document);
}

Result<Time> read_time(const std::string& text, const Document& document, const std::string& option) {
  const bool bare = !text.empty() && text.find_first_not_of("0123456789.-") == std::string::npos;
  Result<Time> time = parse_time(bare ? text + "f" : text, document);
  if (time) return time;
  Error e = time.error();
  e.message = fmt::format("{}: {}", option, e.message);
  return e;
}

std::string section_frames(const std::string& name) { return fmt::format("{0}.start..{0}.end", name); }

// Returns the section whose frames these are; null if they are no section.
static const Section* section_of(const std::string& text, const Document& document) {
  for (const Section& one : document.sections())
    if (text == section_frames(one.name)) return &one;
  return nullptr;
}

Result<FrameList> read_frames(const std::string& text, const Document& document, const std::string& said) {
  // The option that the author has written.
  const std::string option = text == section_frames(text.substr(0, text.find(".start.."))) ? "--section" : said;
  auto [first, last] = document.range();
  if (!text.empty()) {
    const std::size_t dots = text.find("..");
    const auto from = read_time(text.substr(0, dots), document, option);
    if (!from) return from.error();
    first = *from;
    if (dots == std::string::npos) {
      last = first;
    } else if (const std::string end = text.substr(dots + 2); !end.empty()) {
      const auto to = read_time(end, document, option);
      if (!to) return to.error();
      last = *to;
    } else if (last < first) {
      return fail(ErrorCode::range, fmt::format("{}: the film ends before {}", option, text.substr(0, dots)));
    }
    if (last < first) return fail(ErrorCode::range, fmt::format("{}: \"{}\" ends before it begins", option, text));
    // The frame at the end of a section belongs to the section that begins there.
    if (const Section* const section = section_of(text, document))
      for (const Section& next : document.sections())
        if (next.begin == section->end && next.end > next.begin && section->end > section->begin)
          last = section->end - document.rate().span(0.001);
  }
  Result<FrameList> frames = frames_between(first, last, document.rate());
  if (frames) return frames;
  return fail(ErrorCode::range, frames.error().message, fmt::format("choose some: {} A..B", said));
}

void Problems::say(const std::vector<std::string>& problems) {
  const std::lock_guard lock(mutex_);
  for (const std::string& p : problems)
    if (said_.size() < 100 && said_.insert(p).second) tell_user(fmt::format("betwixt: warning: {}\n", p));
}

void catch_stops() {
  struct sigaction action {};
  struct sigaction old {};
  action.sa_handler = [](int) { stop_asked = 1; };
  for (const int s : {SIGINT, SIGTERM, SIGHUP}) {
    const bool unheard = s == SIGHUP && ::sigaction(s, nullptr, &old) == 0 && old.sa_handler == SIG_IGN;  // nohup
    if (!unheard) ::sigaction(s, &action, nullptr);
  }
}

void release_stops() {
  for (const int s : {SIGINT, SIGTERM, SIGHUP}) ::signal(s, SIG_DFL);
  stop_asked = 0;
}

bool stop_requested() { return stop_asked != 0; }

}  // namespace betwixt
