// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/imaging.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <new>
#include <tuple>

#include "base/names.h"
#include "base/still_wanted.h"
#include "commands/verbs.h"
#include "language/json.h"
#include "server/answers.h"

namespace betwixt {
namespace {

constexpr int most_open_lines = 10'000;    // of one command
constexpr int most_attempts = 3;           // while others change the document, before they wait …
constexpr Nanos most_waited = 50'000'000;  // … for what takes no more of a processor than this
constexpr int most_in_vain = 12;           // attempts at what takes longer

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

Imaging::Imaging(Options options)
    : options_(std::move(options)), editor_(options_.load, options_.undo), history_(options_.ceilings.history) {
  editor_.keep([this](Did what, const Step& step) { return history_.note(what, step); });
}

Imaging::Host Imaging::arrive() {
  ++last_host_;
  hosts_[last_host_].host = last_host_;
  return last_host_;
}
void Imaging::leave(Host host) { hosts_.erase(host), later_.erase(host); }

std::int64_t Imaging::tick(Nanos now) const { return document().scene().ticks.whole(transport_.time(now)); }

// While it lives nobody else changes the document, unless somebody else is being waited for already.
class Imaging::Alone {
 public:
  explicit Alone(Imaging& all) : all_(all) {}
  ~Alone() {
    if (mine_) all_.alone_.reset();
  }
  Alone(const Alone&) = delete;
  Alone& operator=(const Alone&) = delete;
  // … and nobody has waited for the one before, and not been heard yet.
  void ask(Host host) {
    if (!all_.alone_ && all_.later_.empty()) all_.alone_ = host, mine_ = true;
  }
  // Somebody else is alone, and must not be disturbed.
  bool others() const { return all_.alone_ && !mine_; }

 private:
  Imaging& all_;
  bool mine_ = false;
};

const Program& Imaging::program() {
  constexpr auto soon = std::chrono::milliseconds(5);
  Alone alone(*this);
  for (int n = 0; compiled_ != version_; ++n) {
    if (n >= most_attempts) alone.ask(0);
    const std::uint64_t version = version_;
    const Document from = document();
    const Program before = program_;
    Program made;
    const auto compile = [&] { made = Program::compile(from, before); };
    const auto begun = std::chrono::steady_clock::now();
    const std::size_t objects = compiled_ > 0 ? before.document().scene().objects.size() : 0;
    const bool much = long_to_compile_ || from.scene().objects.size() > objects + 10'000;
    if (much && options_.beside)
      options_.beside(compile, Claim::first);
    else
      compile();
    long_to_compile_ = std::chrono::steady_clock::now() - begun > soon;
    if (version > compiled_) program_ = std::move(made), compiled_ = version;  // else somebody was faster
  }
  return program_;
}

// Whether a line may do more than change a few things: it speaks of many, reads files, runs code or draws lists.
bool Imaging::takes_long(const SaidLine& line) {
  static constexpr std::string_view quick[] = {"set",  "at",     "create", "note",    "attach",
                                               "hang", "couple", "detach", "letgo",   "show",
                                               "hide", "halt",   "kill",   "animate", "look"};
  if (line.text.size() > 2000 || line.text.find_first_of("*?{[\"") != std::string_view::npos) return true;
  const bool row = line.indented || line.verb.find('.') != std::string_view::npos;
  return !row && std::find(std::begin(quick), std::end(quick), line.verb) == std::end(quick);
}

Imaging::Worked Imaging::work_out(Visitor& h, bool takes_long,
                                  const std::function<bool(const Point&, std::size_t)>& work) {
  Alone alone(*this);
  bool changes = true;
  const auto timed = [&](const Point& from, std::size_t events) {
    const auto before = StillWanted::used();
    changes = work(from, events);
    h.took = (StillWanted::used() - before).count();
  };
  for (;; ++h.attempts) {
    if (h.attempts >= most_in_vain && h.took > most_waited) return h.attempts = 0, Worked::in_vain;
    const bool first = h.attempts >= most_attempts && h.took <= most_waited;
    if (first) alone.ask(h.host);
    const Point from = editor_.now();
    const std::size_t events = event_count_;
    if (!takes_long || !options_.beside) {
      work(from, events);
      break;
    }
    const Claim claim = first && !alone.others() ? Claim::first : Claim::fair;
    if (!options_.beside([&] { timed(from, events); }, claim)) return h.attempts = 0, Worked::gone;
    if (changes && alone.others()) return Worked::later;
    if (!changes || &from.document.scene() == &document().scene()) break;
  }
  h.attempts = 0;
  return Worked::done;
}

Imaging::Reply Imaging::not_worked(const Visitor& h, Worked how, Nanos now) {
  if (how != Worked::in_vain) return {{}, false, how == Worked::later};
  return no(h, now,
            fail(ErrorCode::range,
                 fmt::format("others changed the document each of {} times that this was worked out", most_in_vain),
                 "say it in smaller parts, or when they rest"));
}

// ---- answers

Imaging::Reply Imaging::yes(const Visitor& h, Nanos now, const std::string& members, std::optional<std::int64_t> at) {
  return {fmt::format("{{\"line\":{},\"ok\":true,\"tick\":{}{}}}\n", h.line, at.value_or(tick(now)), members), false};
}

Imaging::Reply Imaging::no(const Visitor& h, Nanos now, const Error& e, const std::string& members) {
  ++refused_;
  std::string more = members;
  if (!e.hint.empty()) more = ",\"hint\":" + json_words(e.hint) + more;
  if (e.place.column > 0) more += fmt::format(",\"column\":{}", e.place.column);
  return {fmt::format("{{\"line\":{},\"ok\":false,\"tick\":{},\"error\":{}{}}}\n", h.line, tick(now),
                      json_words(e.message), more),
          false};
}

// ---- lines

Imaging::Reply Imaging::enter_too_long(Host host, Nanos now) {
  Visitor& h = hosts_.at(host);
  ++h.line, ++lines_;
  h.open.clear(), h.open_lines = 0;
  const Error e = fail(ErrorCode::range, fmt::format("a line is at most {} bytes long", longest_line));
  if (!h.bundling) return no(h, now, e);
  if (!h.bundle_broken) h.bundle_broken = fail(e.code, fmt::format("line {}: {}", h.line, e.message));
  return {};
}

Imaging::Reply Imaging::enter(Host host, std::string_view line, Nanos now) {
  Visitor& h = hosts_.at(host);
  latest_ = std::max(latest_, now);
  const std::size_t bytes = line.size();
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
  if (alone_ && changes_document(h, line)) {
    later_.insert(host);
    return {{}, false, true};
  }
  later_.erase(host);
  const auto before = std::tuple(h.line, h.open, h.open_lines);
  bytes_ += bytes;
  Reply reply = enter_next(h, line, now);
  if (reply.later) later_.insert(host);
  if (reply.later) std::tie(h.line, h.open, h.open_lines) = before, --lines_, bytes_ -= bytes;
  return reply;
}

Imaging::Reply Imaging::enter_next(Visitor& h, std::string_view line, Nanos now) {
  if (line.size() > longest_line) return enter_too_long(h.host, now);
  ++h.line, ++lines_;
  if (h.bundling) return collect(h, line, now);
  std::string whole = std::exchange(h.open, {});
  if (h.open_lines > 0) line = whole += "\n" + std::string(line);
  const SaidLine said = look_at(line);
  const int lines = std::exchange(h.open_lines, 0);
  if (line.size() > longest_line || (said.open && lines >= most_open_lines))
    return no(h, now,
              fail(ErrorCode::range, "this command goes on for too long", "a bracket or a \"\"\" is never closed"));
  if (!said.open) try {
      return enter_whole(h, said, now);
    } catch (const std::bad_alloc&) {  // it was worked out on a copy
      return no(h, now, fail(ErrorCode::machine, "there is not enough memory for this"));
    }
  h.open = line, h.open_lines = lines + 1;
  return yes(h, now, ",\"more\":true");
}

// A word of the server; none: it is a command. One that is both (`notes`, `start`) is a command where more words
// follow.
const Imaging::Word* Imaging::word_of(const Visitor& h, const SaidLine& line) {
  const bool row = line.indented && h.sheet;
  return row || (!line.alone() && is_verb(line.verb)) ? nullptr : find_word(line.verb);
}

// Whether carrying it out may; lines that others follow are only kept.
bool Imaging::changes_document(const Visitor& h, std::string_view line) {
  if (line.size() > longest_line) return false;
  if (h.open_lines > 0 && !h.bundling) return true;
  const SaidLine said = look_at(line);
  if (h.bundling) return ends_bundle(h, said);
  if (said.open || said.words.empty()) return false;
  const Word* const word = word_of(h, said);
  return !word || word->run == &Imaging::undo || word->run == &Imaging::redo;
}

Imaging::Reply Imaging::enter_whole(Visitor& h, const SaidLine& line, Nanos now) {
  const Word* word = word_of(h, line);
  if (!word) return command(h, line, now);
  if (line.words.size() > word->most + 1) return no(h, now, one_word_too_many(line.words[word->most + 1], word->usage));
  const auto done = (this->*word->run)(h, line.words, now);
  if (!done) return no(h, now, done.error());
  if (h.bundling) return {};  // its end has the answer
  return {yes(h, now, *done).line, h.leaving};
}

Result<Imaging::Carried> Imaging::carry_out(const Point& from, std::size_t events, std::string_view line,
                                            std::int64_t stamp) const {
  const Scene& was = from.document.scene();
  Carried c;
  c.deed = editor_.carry_out(from, line, was.ticks.span(static_cast<double>(stamp)));
  for (const Diagnostic& d : c.deed.said) {
    Error e = d.what;
    if (!e.place.file.empty() && e.place.line > 0)
      e.message = fmt::format("{}:{}:{}: {}", e.place.file, e.place.line, e.place.column, e.message);
    if (!e.place.file.empty() || e.place.line < 1) e.place = {};
    if (d.severity == Severity::error) {
      if (e.hint.find("--read-anywhere") != std::string::npos)
        e.hint = options_.load.read_nothing ? "this server began without a script: it reads no files"
                                            : "hosts reach files below the script's folder only";
      if (e.hint.find("--tex") != std::string::npos) e.hint = "hosts show the formulas of the server's script only";
      return e;
    }
    c.said += fmt::format("{}: {}\n", d.severity == Severity::warning ? "warning" : "notice", e.message);
  }
  const Scene& is = c.deed.after.document.scene();
  c.events = count_events(was, events, is);
  c.kept = !c.deed.opens || !is.lists.same(was.lists) || !is.later_lists.same(was.later_lists);
  if (const Status fits = within(options_.ceilings, was, events, is, c.events); !fits) return fits.error();
  return c;
}

bool Imaging::starts_show(std::string_view verb) {
  const Verb* known = find_verb(verb);
  return known && known->flags & Verb::starts_show;
}

Imaging::Reply Imaging::command(Visitor& h, const SaidLine& line, Nanos now) {
  if (line.words.empty()) return yes(h, now, "");
  const std::int64_t at = stamp(now);
  Result<Carried> c = Error{};
  std::optional<Program> made;  // by then: nobody else waits for that either
  const bool takes_time = takes_long(line);
  const auto carry = [&, before = program_](Point from, std::size_t events) {
    from.script.left = h.sheet;
    c = carry_out(from, events, line.text, at);
    made.reset();
    if (takes_time && c && c->kept) made = Program::compile(c->deed.after.document, before);
    return bool(c);
  };
  if (const Worked worked = work_out(h, takes_time, carry); worked != Worked::done) return not_worked(h, worked, now);
  if (!c) {
    Error e = c.error();
    if (!line.indented) h.sheet.reset();
    if (e.message.starts_with("there is no command") && e.hint.empty()) {
      std::vector<std::string_view> known;
      for (const Word& w : words()) known.push_back(w.word);
      e.hint = did_you_mean(line.verb, known);
    }
    return no(h, now, e);
  }
  Deed& deed = c->deed;
  h.sheet = deed.after.script.left;
  if (!c->kept) return yes(h, now, said(c->said));
  if (Status s = editor_.take(std::move(deed.after), {{deed.line}, deed.sheet}); !s) return no(h, now, s.error());
  ++commands_;
  event_count_ = c->events;
  if (starts_show(line.verb)) start_clock(now);
  changed(h.host, deed.line, now);
  if (made) program_ = *std::move(made), compiled_ = version_;
  return yes(h, now, said(c->said), deed.stamped ? std::optional(at) : std::nullopt);
}

}  // namespace betwixt
