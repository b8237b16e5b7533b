// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/imaging.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <new>
#include <tuple>

#include "base/cancellation.h"
#include "base/memory_budget.h"
#include "base/names.h"
#include "commands/reader.h"
#include "commands/verbs.h"
#include "language/json.h"
#include "scene/memory.h"
#include "server/answers.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

constexpr int most_open_lines = 10'000;  // in one command
constexpr int most_attempts = 3;         // tries while others change the document, before they must wait …
constexpr int most_in_vain = 12;         // … and for work for which they do not wait
constexpr auto most_at_once = std::chrono::milliseconds(5);

// Measures the thread's processor time; if the thread waits for another process or a file, measures elapsed time.
// Waiting for a processor does not count.
class Effort {
 public:
  Nanos taken() const {
    constexpr long few = 3;  // such as for a lock
    const auto busy = Cancellation::used() - used_;
    const auto all = std::chrono::steady_clock::now() - begun_;
    return std::chrono::nanoseconds(waits() - waits_ > few ? all : busy).count();
  }

 private:
  static long waits() {
    rusage u{};
    ::getrusage(RUSAGE_THREAD, &u);
    return u.ru_nvcsw;
  }
  const std::chrono::nanoseconds used_ = Cancellation::used();
  const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  const long waits_ = waits();
};

// Does work that is usually short. Returns false if it takes longer this time; then the work is abandoned.
bool at_once(const std::function<void()>& work) {
  static const std::atomic<bool> stays{false};
  static const std::atomic<int> everybody{1};
  try {
    const Cancellation wanted(stays, stays, everybody, most_at_once);
    work();
    return true;
  } catch (const Cancelled&) {
    return false;
  }
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

Imaging::Imaging(Options options)
    : options_(std::move(options)),
      editor_(options_.load, options_.undo),
      history_(options_.ceilings.history, options_.checkpoint_step) {
  editor_.keep([this](Did what, const Step& step) { return history_.note(what, step); });
  editor_.free_with([this](Point gone) {
    if (large()) discard(std::move(gone));
  });
}

Imaging::Host Imaging::arrive() {
  ++last_host_;
  hosts_[last_host_].host = last_host_;
  return last_host_;
}
void Imaging::leave(Host host) {
  if (const auto h = hosts_.find(host); h != hosts_.end()) promised_ -= h->second.promised;
  hosts_.erase(host), later_.erase(host);
}

std::int64_t Imaging::tick(Nanos now) const { return document().scene().ticks.whole(transport_.time(now)); }

// While this object lives, other hosts cannot change the document, unless another host already has that right.
class Imaging::Alone {
 public:
  explicit Alone(Imaging& all) : all_(all) {}
  ~Alone() {
    if (mine_) all_.alone_.reset();
  }
  Alone(const Alone&) = delete;
  Alone& operator=(const Alone&) = delete;
  // Takes the right, unless another host has it or a host from the last time still waits for its turn.
  void ask(Host host) {
    if (!all_.alone_ && all_.later_.empty()) all_.alone_ = host, mine_ = true;
  }
  // Returns true if another host has the right.
  bool others() const { return all_.alone_ && !mine_; }

 private:
  Imaging& all_;
  bool mine_ = false;
};

bool Imaging::large() const {
  constexpr std::size_t many = 10'000;
  return long_to_compile_ || document().scene().objects.size() > many || event_count_ > 10 * many;
}

Program Imaging::program() {
  constexpr auto soon = std::chrono::milliseconds(5);
  const std::uint64_t version = version_;
  const Document from = document();
  const Program before = program_;
  if (compiled_ == version || (compiled_ > 0 && &from.scene() == &before.document().scene()))
    return compiled_ = version, before;
  Program made;
  std::chrono::nanoseconds took{};
  const auto compile = [&] {
    const auto begun = Cancellation::used();
    made = Program::compile(from, before);
    took = Cancellation::used() - begun;
  };
  if (options_.beside && large())
    options_.beside(compile, Claim::first);
  else
    compile();
  long_to_compile_ = took > soon;
  keep_program(made, version);
  return made;
}

// Does nothing if a newer program has been stored.
void Imaging::keep_program(Program made, std::uint64_t version) {
  if (version <= compiled_) return;
  Program before = std::exchange(program_, std::move(made));
  if (large()) discard(std::move(before));
  compiled_ = version;
}

// Returns true if a line contains a pattern, or an alias for several objects.
bool Imaging::speaks_of_many(std::string_view text) const {
  if (text.find_first_of("*?{[") != std::string_view::npos) return true;
  const auto& aliases = *document().scene().aliases;
  if (aliases.empty()) return false;
  const auto words = line_words(text);
  return std::any_of(words.begin(), words.end(), [&](const std::string& w) {
    return aliases.contains(std::string_view(w).substr(0, w.find('.')));
  });
}

// Returns true if a line may do more than change a few things: it names many objects, reads files, runs code or draws
// lists.
bool Imaging::takes_long(const HostState& h, const SaidLine& line) const {
  if (line.text.size() > 2000 || may_hold_text(line.text) || speaks_of_many(line.text)) return true;
  if (line.indented && h.sheet) return speaks_of_many(h.sheet->pattern);
  const Verb* const verb = find_verb(line.verb);
  return first_dot(line.verb) == std::string_view::npos && !(verb && verb->flags & Verb::quick);
}

Imaging::Worked Imaging::work_out(HostState& h, bool takes_long,
                                  const std::function<bool(const Point&, std::size_t)>& work) {
  Alone alone(*this);
  bool changes = true;
  const auto over = [&](Worked how) {
    h.attempts = 0, h.results.clear();
    return how;
  };
  const auto timed = [&](const Point& from, std::size_t events) {
    const KeptResults kept(h.results);
    const Effort effort;
    changes = work(from, events);
    h.took = effort.taken();
  };
  for (;; ++h.attempts) {
    if (h.attempts >= most_in_vain && h.took > options_.most_waited) return over(Worked::in_vain);
    const bool first = h.attempts >= most_attempts && h.took <= options_.most_waited;
    if (first) alone.ask(h.host);
    const Point from = editor_.now();
    const std::size_t events = event_count_;
    const auto quick = [&] {
      const KeptResults kept(h.results);
      work(from, events);
    };
    if (!options_.beside || (!takes_long && at_once(quick))) {
      if (!options_.beside) work(from, events);
      break;
    }
    takes_long = true;
    const Claim claim = first && !alone.others() ? Claim::first : Claim::fair;
    if (!options_.beside([&] { timed(from, events); }, claim)) return over(Worked::gone);
    if (changes && alone.others()) return Worked::later;
    if (!changes || &from.document.scene() == &document().scene()) break;
  }
  return over(Worked::done);
}

Imaging::Reply Imaging::not_worked(const HostState& h, Worked how, Nanos now) {
  if (how != Worked::in_vain) return {{}, false, how == Worked::later};
  return no(
      h, now,
      fail(ErrorCode::range, fmt::format("other hosts changed the document during each of {} attempts", most_in_vain),
           "split the command, or repeat it when they are idle"));
}

// ---- answers

// Takes the members without copying them, because they may be long.
Imaging::Reply Imaging::yes(const HostState& h, Nanos now, std::string members, std::optional<std::int64_t> at) {
  members.insert(0, fmt::format("{{\"line\":{},\"ok\":true,\"tick\":{}", h.line, at.value_or(tick(now))));
  members += "}\n";
  return {std::move(members), false};
}

Result<std::string> Imaging::asked(const std::function<Result<std::string>(Film&)>& answer) {
  constexpr std::size_t more = 200;  // bytes for the start and end of an answer
  Film film(document(), program_, compiled_ == version_);
  const std::uint64_t version = version_;
  Result<std::string> out = std::string();
  const auto work = [&] {
    out = answer(film);
    if (out) out->reserve(out->size() + more);
  };
  if (!options_.beside)
    work();
  else if (!options_.beside(work, Claim::fair))
    out = std::string();  // the host has left
  if (film.compiled()) keep_program(film.program(), version);
  return out;
}

Imaging::Reply Imaging::no(const HostState& h, Nanos now, const Error& e, const std::string& members) {
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
  HostState& h = hosts_.at(host);
  ++h.line, ++lines_;
  h.open.clear(), h.open_lines = 0;
  const Error e = fail(ErrorCode::range, fmt::format("a line can have at most {} bytes", longest_line));
  if (!h.bundling) return no(h, now, e);
  if (!h.bundle_broken) h.bundle_broken = fail(e.code, fmt::format("line {}: {}", h.line, e.message));
  return {};
}

Imaging::Reply Imaging::enter(Host host, std::string_view line, Nanos now) {
  HostState& h = hosts_.at(host);
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

Imaging::Reply Imaging::enter_next(HostState& h, std::string_view line, Nanos now) {
  if (line.size() > longest_line) return enter_too_long(h.host, now);
  ++h.line, ++lines_;
  if (h.bundling) return collect(h, line, now);
  std::string whole = std::exchange(h.open, {});
  if (h.open_lines > 0) line = whole += "\n" + std::string(line);
  const SaidLine said = look_at(line, longest_question);
  const int lines = std::exchange(h.open_lines, 0);
  if (line.size() > longest_line || (said.open && lines >= most_open_lines))
    return no(h, now, fail(ErrorCode::range, "this command has too many lines", "a bracket or a \"\"\" is not closed"));
  if (!said.open) try {
      return enter_whole(h, said, now);
    } catch (const std::bad_alloc&) {  // no harm: the work was done on a copy
      return no(h, now, fail(ErrorCode::machine, "there is not enough memory for this"));
    }
  h.open = line, h.open_lines = lines + 1;
  return yes(h, now, ",\"more\":true");
}

// Returns the server's own word, or nullptr for a command of the language. A name that is both (`notes`, `start`) is a
// command if more words follow.
const Imaging::Word* Imaging::word_of(const HostState& h, const SaidLine& line) {
  const bool row = line.indented && h.sheet;
  return row || (!line.alone() && is_verb(line.verb)) ? nullptr : find_word(line.verb);
}

// Returns true if running the line may change the document. A line that is only collected does not.
bool Imaging::changes_document(const HostState& h, std::string_view line) {
  if (line.size() > longest_line) return false;
  if (h.open_lines > 0 && !h.bundling) return true;
  const SaidLine said = look_at(line, longest_question);
  if (h.bundling) return ends_bundle(h, said);
  if (said.open || said.words.empty()) return false;
  const Word* const word = word_of(h, said);
  return !word || !word->run;
}

Imaging::Reply Imaging::enter_whole(HostState& h, const SaidLine& line, Nanos now) {
  const Word* word = word_of(h, line);
  if (!word) return command(h, line, now);
  if (line.text.size() > longest_question)
    return no(h, now,
              fail(ErrorCode::range, fmt::format("'{}' can have at most {} bytes", word->word, longest_question)));
  if (line.words.size() > word->most + 1) return no(h, now, one_word_too_many(line.words[word->most + 1], word->usage));
  if (!word->run) return step(h, word->step, now);
  auto done = (this->*word->run)(h, line.words, now);
  if (!done) return no(h, now, done.error());
  if (h.bundling) return {};  // the bundle's end has the answer
  return {yes(h, now, *std::move(done)).line, h.leaving};
}

}  // namespace betwixt
