// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/imaging.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>

#include "base/names.h"
#include "betwixt/session.h"
#include "language/journal.h"
#include "language/json.h"
#include "language/line_words.h"
#include "server/answers.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_bundle = 16 << 20;  // bytes
constexpr int most_open_lines = 10'000;           // of one command

// Commands about environments that give no time happen when they come, and say so in the history.
bool happens_now(std::string_view line) {
  const std::string_view verb = first_word(line);
  return verb == "animate" || verb == "halt" || verb == "kill" || verb == "cancel";
}

// What a host puts into an environment it puts into the one of that name now, not into the first one (R-E9): `set
// TARGET NAMES` is an event then.
std::string joining(std::string_view line, std::int64_t stamp) {
  const auto all = line_words(line);
  if (all.size() < 3 || all[0] != "set" || !(all[1].ends_with(".environments") || all[1].ends_with(".drive")))
    return {};
  const auto target = line.find(all[1], line.find("set") + 3);
  return fmt::format("at {}t {}", stamp, line.substr(target));
}

// Shows a display list; the clock begins with it.
bool starts_show(std::string_view line) { return first_word(line) == "start"; }

// One path for one file, whether it is there or not.
fs::path real(const std::string& file) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(file, ignored), ignored);
}

// Hosts make names from their own numbers: O3000001 is of host 3 (betwixt/aim.h). What a history has of them stays
// theirs: the highest of these hosts.
std::uint64_t last_host_named(std::string_view text) {
  std::uint64_t last = 0;
  const auto part_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t i = text.find_first_of("EOT"); i < text.size(); i = text.find_first_of("EOT", i + 1)) {
    if (i > 0 && part_of_name(text[i - 1])) continue;
    std::uint64_t number = 0;
    std::from_chars(text.data() + i + 1, text.data() + text.size(), number);  // too high for it: nobody's, and 0
    last = std::max(last, number / 1'000'000);
  }
  return last;
}

}  // namespace

// A flick is 625/441 of a nanosecond.
Time Transport::time(Nanos now) const {
  if (!running) return at;
  __extension__ using Wide = __int128;
  return at + Time{static_cast<std::int64_t>(static_cast<Wide>(now - since) * 441 / 625)};
}
Nanos Transport::when(Time t) const {
  __extension__ using Wide = __int128;
  return since + static_cast<Nanos>((static_cast<Wide>((t - at).flicks) * 625 + 440) / 441);
}

Imaging::Imaging(Options options) : options_(std::move(options)), history_(options_.undo, options_.ceilings.history) {}

Result<Diagnostics> Imaging::begin(const std::string& file, const std::string& save, bool overwrite, Nanos now) {
  std::error_code ignored;
  const bool goes_on =
      !save.empty() && (file.empty() ? fs::exists(save, ignored) && !overwrite : real(file) == real(save));
  const std::string from = goes_on ? save : file;
  std::string text;
  if (!from.empty()) {
    const auto there = read_script(from);
    if (!there) return there.error();
    if (!*there && !goes_on) return fail(Code::file, fmt::format("there is no file '{}'", from));
    text = there->value_or("");
  }
  if (!save.empty() && !from.empty() && real(from).parent_path() != real(save).parent_path())
    return fail(Code::file, fmt::format("--save: '{}' is not beside '{}'", save, from),
                "the paths of files in a script count from its folder, so its history must be there too");
  name_ = save.empty() ? from : save, save_ = save;
  last_host_ = last_host_named(text);
  std::string cut;
  Diagnostics all = history_.begin(std::move(text), name_, options_.load, cut);
  if (has_errors(all)) return all;
  if (!cut.empty())
    all.push_back({Severity::warning,
                   fail(Code::file, fmt::format("what stands at the end of '{}' was never finished and is left out: {}",
                                                from, cut.substr(0, 200))),
                   {},
                   0});
  if (!save.empty())
    if (Status s = history_.keep_in(save, overwrite || goes_on); !s) return s.error();
  transport_ = {!options_.wait, now, Time{}};
  begun_ = now;
  options_.load.read_anywhere = false;  // from here on strangers speak
  return all;
}

Imaging::Host Imaging::arrive() {
  ++last_host_;
  hosts_[last_host_].host = last_host_;
  return last_host_;
}
void Imaging::leave(Host host) { hosts_.erase(host); }

std::int64_t Imaging::tick(Nanos now) const { return document().scene().ticks.whole(transport_.time(now)); }

const Program& Imaging::program() {
  if (compiled_ != version_) program_ = Program::compile(document()), compiled_ = version_;
  return program_;
}

// ---- answers

Imaging::Reply Imaging::yes(const Visitor& h, Nanos now, const std::string& members, std::optional<std::int64_t> at) {
  return {fmt::format("{{\"line\":{},\"ok\":true,\"tick\":{}{}}}\n", h.line, at.value_or(tick(now)), members), false};
}

Imaging::Reply Imaging::no(const Visitor& h, Nanos now, const Error& e, const std::string& members) {
  ++refused_;
  std::string more = members;
  if (!e.hint.empty()) more = ",\"hint\":" + json_text(e.hint) + more;
  if (e.place.column > 0) more += fmt::format(",\"column\":{}", e.place.column);
  return {fmt::format("{{\"line\":{},\"ok\":false,\"tick\":{},\"error\":{}{}}}\n", h.line, tick(now),
                      json_text(e.message), more),
          false};
}

// ---- lines

Imaging::Reply Imaging::enter_too_long(Host host, Nanos now) {
  Visitor& h = hosts_.at(host);
  ++h.line, ++lines_;
  h.open.clear(), h.open_lines = 0;
  const Error e = fail(Code::range, fmt::format("a line is at most {} bytes long", longest_line));
  if (!h.bundling) return no(h, now, e);
  if (!h.bundle_broken) h.bundle_broken = fail(e.code, fmt::format("line {}: {}", h.line, e.message));
  return {};
}

Imaging::Reply Imaging::enter(Host host, std::string_view line, Nanos now) {
  Visitor& h = hosts_.at(host);
  bytes_ += line.size();
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
  if (line.size() > longest_line) return enter_too_long(host, now);
  ++h.line, ++lines_;
  if (h.bundling) return collect(host, h, line, now);
  if (h.open.empty() && !Session::needs_more(line)) return enter_whole(host, h, line, now);
  // A bracket or a """ is open: the command goes on in the next line.
  h.open += (h.open_lines++ > 0 ? "\n" : "") + std::string(line);
  if (h.open.size() > longest_line || h.open_lines > most_open_lines) {
    h.open.clear(), h.open_lines = 0;
    return no(h, now, fail(Code::range, "this command goes on for too long", "a bracket or a \"\"\" is never closed"));
  }
  if (Session::needs_more(h.open)) return yes(h, now, ",\"more\":true");
  const std::string whole = std::exchange(h.open, {});
  h.open_lines = 0;
  return enter_whole(host, h, whole, now);
}

Imaging::Reply Imaging::enter_whole(Host host, Visitor& h, std::string_view line, Nanos now) {
  const bool row = indented(line) && !h.sheet.empty();
  const std::string_view verb = row ? std::string_view() : first_word(line);
  if (verb == "bundle" || verb == "quit") {
    const auto all = line_words(line);
    if (all.size() > 1) return no(h, now, one_word_too_many(all[1], verb));
    if (verb == "quit") return {yes(h, now, "").line, true};
    h.bundling = true;
    return {};
  }
  for (const Word& w : words()) {
    if (w.word != verb || !w.run) continue;
    const auto all = line_words(line);
    if ((verb == "notes" || verb == "start") && all.size() > 1) break;  // `notes off`, `start LIST`: of the language
    const auto done = (this->*w.run)(h, all, now);
    return done ? yes(h, now, *done) : no(h, now, done.error());
  }
  return command(host, h, line, now);
}

// A command on a copy. `sheet`: what the host's rows stand below.
Result<Imaging::Deed> Imaging::carry_out(const History::Point& from, const std::string& sheet, std::string_view line,
                                         std::int64_t stamp) const {
  Deed deed;
  const bool row = !sheet.empty() && indented(line);
  const std::size_t size = line.size();
  while (!row && indented(line)) line.remove_prefix(1);
  const auto indent = static_cast<int>(size - line.size());
  const std::string prefix = !row && happens_now(line) ? fmt::format("at {}t ", stamp) : "";
  deed.line = prefix + std::string(line);
  if (std::string joins = row ? std::string() : joining(line, stamp); !joins.empty()) deed.line = std::move(joins);
  const int longer = static_cast<int>(deed.line.size()) - static_cast<int>(line.size());
  deed.remark = line_words(line).empty();
  // A begin belongs to the environment that has the name now.
  if (const auto all = line_words(line); row && all.size() == 2 && all[0] == "begin" && sheet.starts_with("edit "))
    deed.line = fmt::format("  begin {} since {}t", all[1], stamp);
  deed.sheet = row ? sheet : "";
  if (deed.remark) return deed;

  const std::string before = deed.sheet + "\n";  // a line that begins the text could be taken for "#!"
  const int above = static_cast<int>(std::count(before.begin(), before.end(), '\n'));
  Scene scene = from.document.scene();
  Diagnostics all;
  Reader reader(scene, all, options_.load);
  reader.carry(from.carried, name_);
  reader.read_text(before + deed.line + "\n", name_);
  for (const Diagnostic& d : all) {
    Error e = d.what;
    const bool here = e.place.file == name_;
    if (here && e.place.line <= above && d.severity != Severity::error) continue;  // said when the sheet was opened
    if (!here && e.place.line > 0)
      e.message = fmt::format("{}:{}:{}: {}", e.place.file, e.place.line, e.place.column, e.message);
    const int first = above + 1;
    if (!here || e.place.line < first) e.place = {};
    if (e.place.line == first) e.place.column = std::max(1, e.place.column - longer + indent);
    if (d.severity == Severity::error) {
      if (e.hint.find("--read-anywhere") != std::string::npos)
        e.hint = "hosts reach files below the script's folder only";
      return e;
    }
    deed.said += fmt::format("{}: {}\n", d.severity == Severity::warning ? "warning" : "notice", e.message);
  }
  const std::size_t events = count_events(from.document.scene(), from.events, scene);
  deed.after = {Document(std::make_shared<const Scene>(std::move(scene))), reader.carried(), events};
  const bool opens = !row && deed.after.carried.sheet_open;
  const Scene &is = deed.after.document.scene(), &was = from.document.scene();
  deed.kept = !opens || !is.lists.same(was.lists) || !is.later_lists.same(was.later_lists);
  const Status fits =
      within(options_.ceilings, from.document.scene(), from.events, deed.after.document.scene(), events);
  if (!fits) return fits.error();
  return deed;
}

Imaging::Reply Imaging::command(Host host, Visitor& h, std::string_view line, Nanos now) {
  const std::int64_t at = stamp(now);
  Result<Deed> deed = carry_out(history_.now(), h.sheet, line, at);
  if (!deed) {
    Error e = deed.error();
    if (!(indented(line) && !h.sheet.empty())) h.sheet.clear();
    if (e.message.starts_with("there is no command") && e.hint.empty()) {
      std::vector<std::string_view> known;
      for (const Word& w : words()) known.push_back(w.word);
      e.hint = did_you_mean(first_word(line), known);
    }
    return no(h, now, e);
  }
  if (deed->remark) return yes(h, now, "");
  h.sheet = deed->after.carried.sheet;
  if (!deed->kept) return yes(h, now, said(deed->said));
  if (Status s = history_.take(std::move(deed->after), {deed->line}, deed->sheet); !s) return no(h, now, s.error());
  ++commands_;
  if (starts_show(line)) {
    start_clock(now);
    deed->said += yet_to_come();
  }
  changed(host, deed->line, now);
  return yes(h, now, said(deed->said),
             happens_now(line) || !joining(line, at).empty() ? std::optional(at) : std::nullopt);
}

void Imaging::changed(Host by, const std::string& line, Nanos now) {
  ++version_;
  std::string told;
  for (const auto& [host, visitor] : hosts_) {
    if (!(visitor.topics & changes)) continue;
    if (told.empty())
      told = fmt::format("{{\"event\":\"change\",\"tick\":{},\"host\":{},\"commands\":{}}}\n", tick(now), by,
                         json_text(line));
    events_.push_back({host, told});
  }
}

// ---- bundles: all or none

// Display lists have an `end` of their own: an indented one does not end the bundle.
Imaging::Reply Imaging::collect(Host host, Visitor& h, std::string_view line, Nanos now) {
  const std::string_view verb = first_word(line);
  const bool lone = line_words(line).size() == 1 && !indented(line) &&
                    (h.bundle.empty() || !Session::needs_more(h.bundle.back().second));
  if (lone && verb == "end") return end_bundle(host, h, now);
  if (lone && verb == "bundle" && !h.bundle_broken)
    h.bundle_broken = fail(Code::syntax, fmt::format("line {}: a bundle is open already", h.line));
  h.bundle_size += line.size() + 64;
  if (h.bundle_size > largest_bundle && !h.bundle_broken)
    h.bundle_broken = fail(Code::range, fmt::format("a bundle is at most {} bytes long", largest_bundle));
  if (h.bundle_broken) {
    h.bundle.clear();
    return {};
  }
  std::string* const before = h.bundle.empty() ? nullptr : &h.bundle.back().second;
  if (before && before->size() <= longest_line && Session::needs_more(*before))
    *before += "\n" + std::string(line);
  else
    h.bundle.emplace_back(h.line, line);
  return {};
}

Imaging::Reply Imaging::end_bundle(Host host, Visitor& h, Nanos now) {
  const auto lines = std::exchange(h.bundle, {});
  const auto broken = std::exchange(h.bundle_broken, {});
  h.bundling = false, h.bundle_size = 0, h.sheet.clear();
  if (broken) return no(h, now, *broken);
  const std::int64_t at = stamp(now);
  History::Point point = history_.now();
  std::string sheet, warnings, errors, all;
  std::optional<Error> first;
  std::vector<std::string> kept;
  bool stamped = false, starts = false;
  for (const auto& [number, line] : lines) {
    const std::string_view verb = first_word(line);
    const bool row = indented(line) && !sheet.empty();
    const auto word = std::find_if(words().begin(), words().end(), [&](const Word& w) { return w.word == verb; });
    Result<Deed> deed = !row && (verb == "quit" || (word != words().end() && line_words(line).size() == 1))
                            ? fail(Code::syntax, fmt::format("'{}' cannot be part of a bundle", verb),
                                   "a bundle holds commands of the language")
                            : carry_out(point, sheet, line, at);
    if (!deed) {
      Error e = deed.error();
      errors += fmt::format("{}{{\"line\":{},\"error\":{}{}{}}}", errors.empty() ? "" : ",", number,
                            json_text(e.message), e.hint.empty() ? "" : ",\"hint\":" + json_text(e.hint),
                            e.place.column > 0 ? fmt::format(",\"column\":{}", e.place.column) : "");
      e.message = fmt::format("line {}: {}", number, e.message), e.place = {};
      if (!first) first = e;
      if (!row) sheet.clear();
      continue;
    }
    if (deed->remark) continue;
    stamped = stamped || happens_now(line);
    warnings += deed->said;
    starts = starts || starts_show(line);
    sheet = deed->after.carried.sheet;
    point = std::move(deed->after);
    all += deed->line + "\n";
    kept.push_back(std::move(deed->line));
  }
  if (first) return no(h, now, *first, ",\"errors\":[" + errors + "]");
  if (kept.empty()) return yes(h, now, "");
  point.carried.sheet_open = false;
  if (Status s = history_.take(std::move(point), kept, ""); !s) return no(h, now, s.error());
  commands_ += kept.size();
  if (starts) start_clock(now);
  changed(host, all, now);
  return yes(h, now, said(warnings), stamped ? std::optional(at) : std::nullopt);
}

// ---- what frames tell

bool Imaging::frames_wanted() const {
  return std::any_of(hosts_.begin(), hosts_.end(),
                     [](const auto& h) { return (h.second.topics & ~unsigned{changes}) != 0; });
}

void Imaging::shown(const Shown& f) {
  std::string frame, remarks;
  if (f.time < told_) told_ = f.time - Time{1};
  if (document().scene().notes_shown)
    for (const auto& [time, words] : document().notes(told_ + Time{1}, f.time))
      remarks += fmt::format("{{\"event\":\"note\",\"seconds\":{},\"note\":{}}}\n", json_number(time.seconds()),
                             json_text(words));
  told_ = f.time;
  tell_contacts(f);
  for (const auto& [host, visitor] : hosts_) {
    if ((visitor.topics & notes) && !remarks.empty()) events_.push_back({host, remarks});
    if (!(visitor.topics & frames)) continue;
    if (frame.empty())
      frame = fmt::format("{{\"event\":\"frame\",\"frame\":{},\"seconds\":{},\"late\":{:.1f}}}\n", f.number,
                          json_number(f.time.seconds()), static_cast<double>(f.late) / 1000);
    events_.push_back({host, frame});
  }
}

// Here, not on the clock's thread: it is never kept from the next frame.
void Imaging::tell_contacts(const Shown& f) {
  std::vector<Host> to;
  for (const auto& [host, visitor] : hosts_)
    if (visitor.topics & contacts) to.push_back(host);
  if (to.empty()) return watch_.reset();
  if (!watch_) watch_.emplace(options_.contacts, options_.sweep);
  std::string all;
  for (const ContactEvent& e : watch_->step(program().frame(f.time))) all += to_json(e, document()) + "\n";
  for (const Host host : to)
    if (!all.empty()) events_.push_back({host, all});
}

}  // namespace betwixt
