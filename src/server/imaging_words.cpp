// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The server's own words: questions, the clock, events, the history.
#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "base/cancellation.h"
#include "base/names.h"
#include "editor/describe.h"
#include "editor/help.h"
#include "language/json.h"
#include "server/answers.h"
#include "server/imaging.h"

namespace betwixt {
namespace {

constexpr int slots = 30;  // size of the source's slot counter
constexpr std::size_t any_number = 1 << 30;
constexpr std::size_t longest_answer = 64 << 20;  // bytes

Result<std::string> said_of(const Result<std::string>& text) {
  if (!text) return text.error();
  return said(*text);
}

Result<unsigned> topics_of(const std::vector<std::string>& w) {
  static constexpr std::string_view names[] = {"changes", "notes", "frames", "contacts", "slow"};
  unsigned topics = 0;
  for (std::size_t i = 1; i < w.size(); ++i) {
    const auto found = std::find(std::begin(names), std::end(names), w[i]);
    if (found == std::end(names))
      return unknown_name("kind of event", w[i], "kinds are changes, contacts, frames, notes and slow");
    topics |= 1u << (found - std::begin(names));
  }
  return topics;
}

// Returns true for an environment that lived before this time and is dead at it.
bool killed_by(const Scene& scene, const Target& target, Time t) {
  const auto& e = scene.objects[target.object.index].environment;
  const std::int64_t tick = scene.ticks.whole(t);
  return e && e->size() > 0 && e->event(0).tick <= tick && !e->generation_at(tick);
}

struct HashTarget {
  std::size_t operator()(const Target& t) const {
    const std::uint64_t part = (std::uint64_t{t.function} << 8 | (t.component + 1) << 1 | (t.velocity ? 1 : 0));
    return std::hash<std::uint64_t>()(part << 32 ^ t.object.index);
  }
};

// The targets and the time of an `eval`. Each target appears once, in the order of the words.
struct Question {
  std::vector<Target> targets;
  Time time;
};
Result<Question> question(const std::vector<std::string>& w, const Document& document, Time now) {
  Question q{{}, now};
  std::size_t end = w.size();
  if (w.size() >= 3 && w[w.size() - 2] == "at") {
    const std::string& text = w.back();
    const bool bare = text.find_first_not_of("0123456789.-") == std::string::npos;
    const auto asked = parse_time(bare ? text + "f" : text, document);
    if (!asked) return asked.error();
    q.time = *asked, end -= 2;
  }
  if (end > 2 && w.back() == "at")
    return fail(ErrorCode::syntax, "a time is missing after 'at'",
                fmt::format("as in eval {} at 24f", w[1].substr(0, 60)));
  if (end < 2) return fail(ErrorCode::syntax, "a target is missing here", "usage: eval TARGET… [at TIME]");
  std::unordered_set<Target, HashTarget> seen;
  for (std::size_t i = 1; i < end; ++i) {
    const auto found = find_targets(w[i], document);
    if (!found) return found.error();
    bool killed = false;
    for (const Target& target : *found) {
      Cancellation::check();
      if (killed_by(document.scene(), target, q.time))
        killed = true;
      else if (seen.insert(target).second)
        q.targets.push_back(target);
    }
    if (killed && !is_pattern(w[i]))
      return fail(ErrorCode::name, fmt::format("the environment '{}' no longer exists: it was killed",
                                               w[i].substr(0, std::min<std::size_t>(w[i].find('.'), 60))));
  }
  return q;
}

// Builds the members of an answer to `eval`. Targets can be added in several parts.
class Values {
 public:
  Values(const Document& document, Time t)
      : document_(document), out_(fmt::format(",\"seconds\":{},\"values\":{{", json_number(t.seconds()))) {}
  void add(std::span<const Target> targets, const std::vector<Value>& values,
           const std::vector<std::string>& problems) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
      Cancellation::check();
      if (too_long()) return;
      out_ += fmt::format("{}{}:{}", first_ ? "" : ",", json_text(document_.name(targets[i])),
                          json(values[i], targets[i], document_));
      first_ = false;
    }
    for (const std::string& p : problems)
      if (std::find(problems_.begin(), problems_.end(), p) == problems_.end()) problems_.push_back(p);
  }
  bool too_long() const { return out_.size() > longest_answer; }
  Result<std::string> members() && {
    if (too_long())
      return fail(ErrorCode::range, fmt::format("the answer would have more than {} bytes", longest_answer),
                  "ask for less at a time");
    return std::move(out_) + "}" + said(fmt::format("{}", fmt::join(problems_, "\n")));
  }

 private:
  const Document& document_;
  std::string out_;
  std::vector<std::string> problems_;
  bool first_ = true;
};

Result<std::string> values_of(const Program& film, const Question& q) {
  constexpr std::size_t at_a_time = 1 << 16;
  Values out(film.document(), q.time);
  for (std::size_t from = 0; from < q.targets.size() && !out.too_long(); from += at_a_time) {
    const auto begin = q.targets.begin() + static_cast<std::ptrdiff_t>(from);
    const std::vector<Target> some(begin,
                                   begin + static_cast<std::ptrdiff_t>(std::min(at_a_time, q.targets.size() - from)));
    std::vector<std::string> problems;
    const std::vector<Value> values = film.read(some, q.time, &problems);
    out.add(some, values, problems);
  }
  return std::move(out).members();
}

}  // namespace

std::span<const Imaging::Word> Imaging::words() {
  static constexpr Word all[] = {
      {"eval", "eval TARGET… [at TIME]", "Prints values, now or at a time.", any_number, &Imaging::eval},
      {"list", "list [PATTERN]", "Lists the objects, their kinds and how many events they have.", 1, &Imaging::look},
      {"describe", "describe NAME|TARGET",
       "Describes an object: its kind, its values, its parent; of a target, its events.", 1, &Imaging::look},
      {"notes", "notes", "Lists the notes and their times.", 0, &Imaging::look},
      {"help", "help [WORD]", "Explains a word; without one, lists all words.", 1, &Imaging::help},
      {"time", "time", "Prints the current tick, seconds and slot.", 0, &Imaging::time},
      {"stats", "stats", "Prints statistics of the server: frames, lateness, hosts.", 0, &Imaging::stats},
      {"history", "history", "Prints the document as a script, with all accepted commands.", 0, &Imaging::history_word},
      {"undo", "undo", "Undoes the last command of all hosts.", 0, nullptr, {}, Did::undo},
      {"redo", "redo", "Repeats the last undone command.", 0, nullptr, {}, Did::redo},
      {"subscribe", "subscribe changes|contacts|frames|notes|slow", "Starts sending events to this host.", any_number,
       &Imaging::subscribe,
       "  changes   each accepted command and its host\n  contacts  objects that begin or stop to touch, or that enter "
       "or leave the view\n  frames    the number and time of each shown frame, and how many µs it was late\n  notes   "
       "  notes whose time has come\n  slow      a value that begins or stops to take longer than a frame\n  example: "
       "subscribe changes contacts\n"},
      {"unsubscribe", "unsubscribe [changes|contacts|frames|notes|slow]", "Stops sending events to this host.",
       any_number, &Imaging::unsubscribe},
      {"start", "start", "Starts the clock if it is paused; with --wait it begins at 0.", 0, &Imaging::start},
      {"pause", "pause", "Pauses the clock.", 0, &Imaging::pause},
      {"go", "go", "Continues the clock.", 0, &Imaging::go},
      {"seek", "seek TIME", "Sets the clock to another time.", any_number, &Imaging::seek},
      {"save", "save",
       "Writes the history as a script and prints its file name. (The server also keeps it without that.)", any_number,
       &Imaging::save},
      {"set-aside", "set-aside", "Lists commands of an earlier server that failed in this one, and why.", 0,
       &Imaging::set_aside_word},
      {"send", "send NAME LENGTH, then LENGTH bytes",
       "Gives the server a picture, mesh, scene, drawing or sound; then @NAME names it like a file.", 2, &Imaging::send,
       "  example: send logo.png 5120\n           (5120 bytes, then the next line)\n           set ball.texture "
       "\"@logo.png\"\n"},
      {"names", "names", "Reserves a thousand unused numbers, for hosts that make names of them.", 0, &Imaging::names},
      {"bundle", "bundle, then commands, then end",
       "Runs the commands up to end together, at one moment: all or none; end has the answer.", 0, &Imaging::bundle,
       "  example: bundle\n           create ball sphere\n           set ball.environments (spin)\n           end\n"},
      {"end", "end", "Ends a bundle and runs its commands: all or none.", any_number, &Imaging::end},
      {"quit", "quit", "Ends the connection; the server continues.", 0, &Imaging::quit},
      {"open", "open", "", any_number, &Imaging::not_for_hosts},
      {"load", "load", "", any_number, &Imaging::not_for_hosts},
      {"plot", "plot", "", any_number, &Imaging::not_for_hosts},
      {"play", "play", "", any_number, &Imaging::not_for_hosts},
      {"stop", "stop", "", any_number, &Imaging::not_for_hosts},
  };
  return all;
}

const Imaging::Word* Imaging::find_word(std::string_view word) {
  for (const Word& w : words())
    if (w.word == word) return &w;
  return nullptr;
}

Result<std::string> Imaging::not_for_hosts(HostState&, const std::vector<std::string>& w, Nanos) {
  if (w[0] == "open") return fail(ErrorCode::name, "hosts cannot use 'open': a server has one document");
  if (w[0] == "load")
    return fail(ErrorCode::name, "hosts cannot use 'load': plug-ins are programs",
                "load plug-ins with betwixt serve --load PLUGIN");
  if (w[0] == "plot")
    return fail(ErrorCode::name, "hosts cannot use 'plot': it would write a file on the server",
                "use eval to read values");
  return fail(ErrorCode::name, fmt::format("hosts cannot use '{}': a server always plays", w[0]),
              "use start, pause, go or seek");
}

// Answers an `eval` of a few named targets if that needs no code and no pass over all objects. Otherwise returns
// nullopt.
std::optional<Result<std::string>> Imaging::known_at_once(const std::vector<std::string>& words, Time now) {
  constexpr std::size_t few = 16, short_word = 200;
  constexpr std::uint64_t steps = 100'000;  // about a millisecond
  if (words.size() > few || (large() && compiled_ != version_)) return std::nullopt;
  for (std::size_t i = 1; i < words.size(); ++i)
    if (words[i].size() > short_word || speaks_of_many(words[i])) return std::nullopt;
  const auto q = question(words, document(), now);
  if (!q) return q.error();
  const Program film = program();
  std::vector<std::string> problems;
  const auto values = film.read_within(steps, q->targets, q->time, &problems);
  if (!values) return std::nullopt;
  Values out(film.document(), q->time);
  out.add(q->targets, *values, problems);
  return std::move(out).members();
}

Result<std::string> Imaging::eval(HostState&, const std::vector<std::string>& w, Nanos now) {
  const Time t = transport_.time(now);
  if (auto answer = known_at_once(w, t)) return *std::move(answer);
  return asked([&w, t](Film& film) -> Result<std::string> {
    const auto q = question(w, film.document(), t);
    if (!q) return q.error();
    return values_of(film.program(), *q);
  });
}

Result<std::string> Imaging::help(HostState& h, const std::vector<std::string>& w, Nanos now) {
  if (w.size() < 2) {
    const Scene& scene = document().scene();
    if (!overview_ || !overview_->defined.same(scene.defined) || !overview_->procedures.same(scene.procedures)) {
      std::string out;
      for (const Word& word : words())
        if (!word.sentence.empty()) out += fmt::format("{:12} {}\n", word.word, word.sentence);
      overview_ = {scene.defined, scene.procedures, said(out + "\n" + help_overview(scene, false))};
    }
    return overview_->text;
  }
  if (const Word* word = find_word(w[1])) {
    if (word->sentence.empty()) return not_for_hosts(h, {w[1]}, now);
    return said(fmt::format("{}\n  usage: {}\n{}", word->sentence, word->usage, word->more));
  }
  return asked([&w](Film& film) { return said_of(look_up(film.document(), w[1])); });
}

Result<std::string> Imaging::look(HostState&, const std::vector<std::string>& w, Nanos) {
  return asked([&w](Film& film) -> Result<std::string> {
    if (w[0] == "notes") return said(list_notes(film.document()));
    const std::string word = w.size() > 1 ? w[1] : "";
    return said_of(w[0] == "list" ? list_objects(film.document(), word) : describe(film.program(), word));
  });
}

Result<std::string> Imaging::time(HostState& h, const std::vector<std::string>&, Nanos now) {
  const Time t = transport_.time(now);
  const std::int64_t slot = ((tick(now) % slots) + slots) % slots;
  return fmt::format(",\"seconds\":{},\"slot\":{},\"running\":{},\"host\":{}", json_number(t.seconds()), slot,
                     transport_.running, h.host);
}

Result<std::string> Imaging::stats(HostState&, const std::vector<std::string>&, Nanos now) {
  return ",\"stats\":" + statistics(now);
}

std::string Imaging::statistics(Nanos now) const {
  std::string more = options_.stats ? options_.stats() : "";
  if (!more.empty()) more = "," + more;
  return fmt::format(
      "{{\"uptime\":{:.3f},\"hosts\":{},\"lines\":{},\"commands\":{},\"refused\":{},\"bytes\":{},"
      "\"steps\":{},\"objects\":{},\"events\":{},\"history\":{}{}}}",
      static_cast<double>(now - begun_) / 1e9, hosts_.size(), lines_, commands_, refused_, bytes_,
      editor_.steps().size(), document().scene().objects.size(), event_count_, history_.bytes(), more);
}

Result<std::string> Imaging::subscribe(HostState& h, const std::vector<std::string>& w, Nanos) {
  const auto topics = topics_of(w);
  if (!topics) return topics.error();
  if (*topics == 0)
    return fail(ErrorCode::syntax, "a kind of event is missing here",
                "usage: subscribe changes|contacts|frames|notes|slow");
  // Starts anew, so that the new subscriber gets the contacts of now.
  if (*topics & contacts && !(h.topics & contacts)) watch_.reset();
  h.topics |= *topics;
  return std::string();
}

Result<std::string> Imaging::unsubscribe(HostState& h, const std::vector<std::string>& w, Nanos) {
  const auto topics = topics_of(w);
  if (!topics) return topics.error();
  h.topics &= *topics == 0 ? 0u : ~*topics;
  return std::string();
}

// The source's StartAniProc. Does nothing if the clock runs: no host may turn a running clock back.
void Imaging::start_clock(Nanos now) {
  if (transport_.running) return;
  transport_ = {true, now, transport_.at};
  told_ = transport_.at - Time{1};
}

Result<std::string> Imaging::start(HostState&, const std::vector<std::string>&, Nanos now) {
  start_clock(now);
  changed(0, json_text("start"), now);
  return std::string();
}

Result<std::string> Imaging::pause(HostState&, const std::vector<std::string>&, Nanos now) {
  transport_ = {false, now, transport_.time(now)};
  changed(0, json_text("pause"), now);
  return std::string();
}

Result<std::string> Imaging::go(HostState&, const std::vector<std::string>&, Nanos now) {
  transport_ = {true, now, transport_.time(now)};
  changed(0, json_text("go"), now);
  return std::string();
}

Result<std::string> Imaging::seek(HostState&, const std::vector<std::string>& w, Nanos now) {
  if (w.size() != 2) return fail(ErrorCode::syntax, "a time is missing here", "usage: seek TIME, as in seek 2.5s");
  const auto to = parse_time(w[1], document());
  if (!to) return to.error();
  transport_.since = now, transport_.at = *to;
  told_ = *to - Time{1};
  changed(0, json_text("seek " + w[1]), now);
  return std::string();
}

Result<std::string> Imaging::bundle(HostState& h, const std::vector<std::string>&, Nanos) {
  h.bundling = true;
  return std::string();
}

Result<std::string> Imaging::quit(HostState& h, const std::vector<std::string>&, Nanos) {
  h.leaving = true;
  return std::string();
}

Result<std::string> Imaging::end(HostState&, const std::vector<std::string>&, Nanos) {
  return fail(ErrorCode::syntax, "no bundle is open", "to end an environment in a display list, indent 'end'");
}

}  // namespace betwixt
