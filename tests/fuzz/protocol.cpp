// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fuzzes an imaging server that keeps its history, with lines of several hosts. The server is killed and restarted, and
// its journal is cut and damaged. After a restart its document must have the effect of all answered commands. A line of
// the input is
//
//   :LETTERS  in the first line: k: checkpoints come early, u: few commands can be undone, c: the limits are low,
//             w: the clock is stopped at first, b: lines of other hosts continue while a line takes long
//   1… 2… 3…  a line of host 1, 2 or 3; a line without a number is of the same host as before
//   +N        N ms pass
//   -N        host N disconnects, and another one connects in its place
//   =         shows a frame
//   ^         sends a line that is too long
//   !  $      kills the server, or ends it, and restarts it
//   ?N  ~N    cuts a copy of the journal at byte N, or flips a bit of that byte, and starts a server with the copy
//   <         the host that sends the next long request has disconnected before its answer
#include <stdlib.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "fuzz.h"
#include "server/imaging.h"

using namespace betwixt;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_lines = 150;
constexpr std::size_t hosts_at_once = 3, names_asked = 6;
constexpr Nanos millisecond = 1'000'000;
constexpr Time time_ahead{2 * flicks_per_second};  // the time of a killed server may be this far ahead at most

// A temporary folder, in memory if possible. It is removed at the end.
class Place {
 public:
  Place() {
    std::error_code none;
    std::string name =
        (fs::is_directory("/dev/shm", none) ? fs::path("/dev/shm") : fs::temp_directory_path()) / "betwixt-fuzz-XXXXXX";
    insist(::mkdtemp(name.data()) != nullptr, "there is a folder");
    at_ = name;
  }
  ~Place() {
    std::error_code ignored;
    fs::remove_all(at_, ignored);
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  std::string file() const { return at_ / "live.bx"; }
  std::string journal() const { return at_ / ".live.bx.journal"; }
  void clear() const {
    for (const auto& entry : fs::directory_iterator(at_)) fs::remove(entry.path());
  }

 private:
  fs::path at_;
};

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
void put(const std::string& path, std::string_view text) { std::ofstream(path, std::ios::binary) << text; }
std::size_t size_of(const std::string& path) {
  struct stat s {};
  return ::stat(path.c_str(), &s) == 0 ? static_cast<std::size_t>(s.st_size) : 0;
}

std::string_view first_of(std::string_view line) {
  const std::size_t from = line.find_first_not_of(" \t\r,");
  if (from == std::string_view::npos) return {};
  line.remove_prefix(from);
  return line.substr(0, line.find_first_of(" \t\r,#"));
}

std::size_t number_of(std::string_view digits) {
  std::size_t n = 0;
  for (const char c : digits.substr(0, 9)) n = c >= '0' && c <= '9' ? 10 * n + static_cast<std::size_t>(c - '0') : n;
  return n;
}

// What there was after something had been answered.
struct State {
  std::string history;
  Document document;
  int written = 0;          // how often the history had been written anew
  std::size_t journal = 0;  // bytes of it then
};

struct Seat {
  Imaging::Host host = 0;
  std::int64_t lines = 0;
  bool bundling = false, in_hand = false, gone = false;
};

class Play {
 public:
  explicit Play(std::string_view text) : left_(text) {
    place().clear();
    again().clear();
    if (left_.starts_with(':')) flags_ = next();
    begin();
    first();
  }

  void run() {
    for (std::size_t n = 0; n < most_lines && !left_.empty(); ++n) step();
    cut(left_.size() + 7919 * all_.size(), false);
    restart(false);
    undo_all();
  }

 private:
  static const Place& place() {
    static const Place one;
    return one;
  }
  static const Place& again() {
    static const Place one;
    return one;
  }
  bool flag(char c) const { return flags_.find(c) != std::string_view::npos; }

  std::string_view next() {
    const std::size_t end = std::min(left_.find('\n'), left_.size());
    const std::string_view line = left_.substr(0, end);
    left_.remove_prefix(std::min(end + 1, left_.size()));
    return line;
  }

  Imaging::Options options(bool beside) {
    Imaging::Options o;
    o.undo.steps = flag('u') ? 3 : 1000;
    o.ceilings.objects = flag('c') ? 8 : 5000;
    if (flag('c')) o.ceilings.environments = 3, o.ceilings.events = 12, o.ceilings.history = 700;
    if (flag('k')) o.checkpoint = 200;
    o.wait = flag('w');
    if (beside && flag('b')) o.beside = [this](const auto& work, auto) { return work_beside(work); };
    return o;
  }

  void begin() {
    imaging_.emplace(options(true));
    const auto begun = imaging_->begin("", place().file(), false, now_);
    insist(static_cast<bool>(begun), "a server begins", begun ? "" : begun.error().message);
    for (Seat& seat : seats_) seat = {.host = imaging_->arrive()};
  }

  // ---- what there is

  State present() const {
    return {imaging_->history(), imaging_->document(), written_, all_.empty() ? 0 : size_of(place().journal())};
  }
  const State& now() const { return states_[at_ - 1]; }
  // From here on there is nothing to go back to.
  void first() {
    all_.clear();
    all_.push_back(present());
    states_ = all_, at_ = 1;
  }
  bool is(const State& s) const {
    return s.written == written_ ? imaging_->history() == s.history : imaging_->document() == s.document;
  }

  // Something was answered: the state is the one before, or one that follows from it.
  void settle(std::string_view verb, bool refused) {
    if (&imaging_->document().scene() != &now().document.scene()) {
      insist(!refused, "what is refused changes nothing", verb);
      if (verb == "undo" && at_ > 1 && is(states_[at_ - 2])) {
        --at_;
      } else if (verb == "redo" && at_ < states_.size() && is(states_[at_])) {
        ++at_;
      } else {
        states_.resize(at_++);
        states_.emplace_back();
      }
    }
    const std::string history = imaging_->history();
    insist(static_cast<bool>(imaging_->sync(now_)), "what was answered is on the disk");
    if (imaging_->history() != history) {
      ++written_;
      insist(load_text(imaging_->history(), "").document == imaging_->document(), "a checkpoint keeps the document",
             imaging_->history());
    }
    all_.push_back(states_[at_ - 1] = present());
  }

  // What objects are worth, as hosts are told.
  static std::string values(Imaging& server, Imaging::Host host) {
    std::string out;
    std::size_t n = 0;
    for (const std::string& name : server.document().names()) {
      if (++n > names_asked) break;
      for (const char* what : {"", ".world"})
        for (const char* time : {"0f", "7t"}) {
          const auto reply = server.enter(host, "eval " + name + what + " at " + time, 0);
          const std::size_t tick = reply.line.find("\"tick\":");
          insist(tick != std::string::npos, "an eval is answered", reply.line);
          out += reply.line.substr(std::min(reply.line.find(',', tick), reply.line.size()));
        }
    }
    return out;
  }

  // ---- what is done

  void restart(bool properly) {
    const State before{imaging_->history(), imaging_->document(), 0, 0};
    const std::string worth = values(*imaging_, imaging_->arrive());
    const Time then = imaging_->transport().time(now_);
    const bool ran = imaging_->transport().running;
    if (properly) {
      const Status whole = imaging_->finish(now_);
      insist(static_cast<bool>(whole), "a server ends", whole ? "" : whole.error().message);
      insist(text_of(place().file()) == before.history, "the file is the whole history");
      insist(!fs::exists(place().journal()), "no journal is left");
    }
    imaging_.reset();
    begin();
    insist(imaging_->history() == before.history, "the history is what was answered", imaging_->history());
    insist(imaging_->document() == before.document, "the document is what was answered", before.history);
    insist(values(*imaging_, imaging_->arrive()) == worth, "the values are what was answered", before.history);
    const Time time = imaging_->transport().time(now_);
    insist(imaging_->transport().running == ran && time >= then, "the time goes on");
    insist(time == then || (ran && !properly && time <= then + time_ahead), "and not far ahead");
    states_[at_ - 1].document = imaging_->document();
    if (properly) written_ = 0, saved_ = false, first();  // all of it is the author's text now
  }

  void undo_all() {
    Seat& seat = seats_[0];
    for (std::size_t n = 0; n < 2 * most_lines && at_ > 1; ++n) {
      const std::size_t at = at_;
      say(seat, "undo");
      if (at_ == at) break;  // no more is kept
      insist(at_ < at, "undo goes back", imaging_->history());
    }
  }

  void cut(std::size_t where, bool changed) {
    again().clear();
    std::string journal = text_of(place().journal());
    if (journal.empty()) return;
    where %= journal.size();
    if (changed)
      journal[where] = static_cast<char>(journal[where] ^ 4);
    else
      journal.resize(where);
    put(again().file(), text_of(place().file()));
    put(again().journal(), journal);
    Imaging server(options(false));
    const auto begun = server.begin("", again().file(), false, 0);
    insist(static_cast<bool>(begun), "what is cut can be begun with", begun ? "" : begun.error().message);
    const std::string history = server.history();
    const State* last = nullptr;
    for (const State& s : all_)
      if (s.journal <= where) last = &s;
    if (!changed && !saved_ && written_ == 0)
      return insist(last && history == last->history, "what is cut is a prefix of what was answered", history);
    for (const State& s : all_)
      if (history == s.history || server.document() == s.document) return;
    insist(false, "what is damaged is a prefix of what was answered", history);
  }

  void show() {
    const Time t = imaging_->transport().time(now_);
    const Frame frame = imaging_->program().frame(t);
    imaging_->shown({{++frames_, t, 0, {}}});
  }

  bool work_beside(const std::function<void()>& work) {
    if (!served_) return work(), true;
    served_->gone = std::exchange(gone_, false);
    const bool gone = served_->gone;
    work();
    // Who is not in hand says something meanwhile.
    const std::size_t who = left_.empty() ? 9 : static_cast<std::size_t>(static_cast<unsigned char>(left_[0]) - '1');
    if (who < hosts_at_once && !seats_[who].in_hand) step();
    return !gone;
  }

  // ---- lines

  void step() {
    std::string_view line = next();
    if (line.empty()) return say(seats_[last_], line);
    const std::string_view rest = line.substr(1);
    const std::size_t n = number_of(rest);
    switch (line[0]) {
      case '1':
      case '2':
      case '3':
        last_ = static_cast<std::size_t>(line[0] - '1');
        return say(seats_[last_], rest);
      case '+':
        now_ += static_cast<Nanos>(n % 100'000) * millisecond;
        return;
      case '-':
        return change_places(seats_[n % hosts_at_once]);
      case '=':
        return show();
      case '^':
        return hear(seats_[last_], imaging_->enter_too_long(seats_[last_].host, now_), "");
      case '!':
        return restart(false);
      case '$':
        return restart(true);
      case '?':
        return cut(n, false);
      case '~':
        return cut(n, true);
      case '<':
        gone_ = true;
        return;
      default:
        return say(seats_[last_], line);
    }
  }

  void change_places(Seat& seat) {
    imaging_->leave(seat.host);
    seat = {.host = imaging_->arrive()};
  }

  void say(Seat& seat, std::string_view line) {
    if (line.find("live") != std::string_view::npos) return;  // the files of its folder are other ones later
    Seat* const before = std::exchange(served_, &seat);
    seat.in_hand = true;
    const Imaging::Reply reply = imaging_->enter(seat.host, line, now_);
    seat.in_hand = false;
    served_ = before;
    hear(seat, reply, line);
  }

  void hear(Seat& seat, const Imaging::Reply& reply, std::string_view line) {
    ++seat.lines;
    const std::string_view verb = first_of(line);
    bool refused = seat.gone;  // it takes back what it asked
    if (seat.gone) {
      change_places(seat);
    } else if (reply.line.empty()) {
      insist(seat.bundling || verb == "bundle", "what is not in a bundle is answered", line);
      seat.bundling = true;
    } else {
      const auto answer = answered(reply.line);
      insist(answer["line"] == seat.lines && answer["ok"].is_boolean() && answer["tick"].is_number_integer(),
             "an answer says what it answers", reply.line);
      insist(answer["ok"] == !answer.contains("error"), "what is refused says why", reply.line);
      refused = !answer["ok"].get<bool>();
      if (seat.bundling && !answer.contains("first")) seat.bundling = false;
    }
    settle(verb, refused);
    if (verb == "save" && !refused) saved_ = true;
    for (const Imaging::Event& e : imaging_->events()) {
      const std::string& lines = *e.line;
      for (std::size_t at = 0; at < lines.size();) {
        const std::size_t end = lines.find('\n', at);
        insist(answered(lines.substr(at, end + 1 - at)).contains("event"), "an event says what it is", lines);
        at = end + 1;
      }
    }
    if (reply.quit) change_places(seat);
  }

  static nlohmann::json answered(const std::string& line) {
    insist(!line.empty() && line.find('\n') == line.size() - 1, "an answer is one line", line);
    auto answer = nlohmann::json::parse(line, nullptr, false);
    insist(answer.is_object(), "an answer is an object of JSON", line);
    return answer;
  }

  std::string_view left_, flags_;
  std::optional<Imaging> imaging_;
  std::array<Seat, hosts_at_once> seats_;
  std::size_t last_ = 0;
  Nanos now_ = 0;
  std::int64_t frames_ = 0;
  std::vector<State> states_;  // that stand, then those that were undone
  std::size_t at_ = 0;         // of them
  std::vector<State> all_;     // that ever were
  int written_ = 0;
  bool saved_ = false, gone_ = false;
  Seat* served_ = nullptr;  // whose line is carried out
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Slow slow;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (makes_many(text)) return -1;
  Play(text).run();
  return slow.verdict();
}
