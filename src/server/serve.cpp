// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/serve.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>
#include <set>
#include <unordered_map>

#include "base/tell_user.h"
#include "server/answers.h"
#include "server/clock_link.h"
#include "server/file_watch.h"
#include "server/guest.h"
#include "server/memory_return.h"
#include "server/multilevel_queue.h"

namespace betwixt {
namespace {

constexpr std::size_t most_events_waiting = 1 << 20;  // bytes; a host that has not read so many gets no more events
constexpr int turn_lines = 64;                        // from one host in a turn …
constexpr Nanos turn_time = 4'000'000;                // … unless they take longer than this, …
constexpr Nanos all_turns = 20'000'000;               // … or all turns of a round take longer than this
constexpr Nanos patience = 10'000'000'000;   // with a stranger's token, and with a host that does not read its answers
constexpr Nanos parting_time = 200'000'000;  // from one probe of a half-closed connection to the next
constexpr std::size_t longest_token_line = 4096;
constexpr int most_guesses = 3;
constexpr std::size_t most_strangers = 64;  // connections that have sent no token yet

class Server {
 public:
  Server(Imaging& imaging, FrameClock& clock, const std::vector<Listener>& listeners, const ServeOptions& options)
      : imaging_(imaging), listeners_(listeners), options_(options), clock_(imaging, clock, leaders_, options.report) {}
  ~Server() {
    for (auto& [file, guest] : guests_) ::close(file);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  Status run() {
    if (!watch_.works())
      return fail(ErrorCode::machine, fmt::format("cannot start the server: {}", std::strerror(errno)));
    for (const Listener& l : listeners_) watch_.add(l.file());
    if (options_.stop >= 0) watch_.add(options_.stop);
    watch_.add(clock_.shown());
    clock_.begin();
    imaging_.work_beside([this](const auto& work, Imaging::Claim claim) { return beside(work, claim); },
                         [this](std::shared_ptr<const void> gone) { memory_.take(std::move(gone)); });
    const bool served = leaders_.run(options_.give_up ? [this] {
      (void)imaging_.sync(monotonic_now());
      options_.give_up();
    } : std::function<void()>());
    imaging_.work_beside({}, {});
    if (!served) return fail(ErrorCode::machine, "cannot start a thread for the hosts");
    return failed_ ? Status(*failed_) : imaging_.sync(monotonic_now());
  }

 private:
  static inline thread_local Guest* served = nullptr;  // the guest whose line this thread runs

  // Implements Imaging::Options::beside.
  bool beside(const std::function<void()>& work, Imaging::Claim claim) {
    Guest* const g = served;
    // No host asked, so this does not queue behind hosts' questions.
    if (!g) return leaders_.beside(work), !leaders_.stopped();
    g->in_hand = true, watch_.change(g->file, g->watched = EPOLLRDHUP);
    bool done = true;
    leaders_.beside([&] {
      if (claim == Imaging::Claim::first)
        work();
      else
        done = lanes_.run(work, g->gone);
    });
    g->in_hand = false, parting_.erase(g->file);
    if (!g->gone) watch_.change(g->file, g->watched = EPOLLIN);
    return done && !leaders_.stopped() && !g->gone;
  }

  void stop() {
    lanes_.end();
    leaders_.stop();
  }

  void round(LeaderFollowerPool::Lock& lock) {
    wait(lock);
    const Nanos most = std::min<Nanos>(turn_time, all_turns / static_cast<Nanos>(busy_.size() + 1));
    for (const int file : std::set(busy_)) {
      if (busy_.erase(file) == 0) continue;  // another thread has led in between
      const auto found = guests_.find(file);
      if (found != guests_.end() && !found->second.in_hand && !leaders_.stopped()) take_turn(found->second, most);
    }
    if (leaders_.stopped()) return;
    for (auto& e : imaging_.events()) tell(e);
    // The answers must not go out before their commands are on the disk.
    if (Status s = imaging_.sync(monotonic_now()); !s) {
      failed_ = s.error();
      return stop(), watch_.wake();
    }
    for (auto it = guests_.begin(); it != guests_.end();) {
      const auto next = std::next(it);
      if (it->second.waiting() > 0 || it->second.last_word || it->second.half_closed) send(it->second);
      it = next;
    }
    if (!imaging_.waits()) let_on();
    if (!busy_.empty() && !leaders_.leads()) watch_.wake();
    clock_.publish();  // after the answers are sent, because a large film takes long to compile
    clock_.report();
  }

  // Returns the milliseconds until the next timed work, or -1 if there is none.
  int patience_now() const {
    if (!busy_.empty()) return 0;
    int most = !parting_.empty() ? 100 : strangers_ > 0 || resting_ || !full_.empty() ? 500 : -1;
    for (const std::optional<Nanos> next : {imaging_.sync_again(), clock_.next_report()}) {
      if (!next) continue;
      const auto left = static_cast<int>(std::max<Nanos>(0, *next - monotonic_now()) / 1'000'000 + 1);
      most = most < 0 ? left : std::min(most, left);
    }
    return most;
  }

  void wait(LeaderFollowerPool::Lock& lock) {
    std::array<epoll_event, 256> room;
    const int timeout = patience_now();
    lock.unlock();
    const std::span<const epoll_event> events = watch_.wait(room, timeout);
    lock.lock();
    if (resting_) rest(false);
    bool shown = false;
    for (const epoll_event& e : events) {
      const int file = e.data.fd;
      if (file == options_.stop) return stop();
      if (file == clock_.shown()) {
        shown = true;
        continue;
      }
      if (const auto guest = guests_.find(file); guest != guests_.end())
        hear(guest->second, e.events);
      else
        for (const Listener& l : listeners_)
          if (l.file() == file) welcome(l);
    }
    if (strangers_ > 0) tire();
    if (!parting_.empty()) ask_the_parting();
    // Last: other threads may lead while it computes contacts, and the events above would be out of date.
    if (shown) clock_.hear();
  }

  // If a thread works for a guest, or the guest waits for another host, only the end of its connection matters. An
  // event for its input may still arrive, if the kernel queued it before the line was taken.
  void hear(Guest& g, std::uint32_t events) {
    if (!g.in_hand && !g.kept)
      busy_.insert(g.file);
    else if (events & (EPOLLHUP | EPOLLERR))
      leave(g);
    else if (g.in_hand && events & EPOLLRDHUP)
      g.parting = monotonic_now(), parting_.insert(g.file), watch_.change(g.file, g.watched = 0);
  }

  // A host that has closed its side may still wait for answers, or be gone. Only a failed send tells, so sends a probe.
  void ask_the_parting() {
    const Nanos now = monotonic_now();
    for (const int file : parting_) {
      Guest& g = guests_.at(file);
      if (now - g.parting < parting_time) continue;
      g.say("{\"event\":\"waiting\"}\n");
      g.parting = now;
    }
  }

  // ---- connections

  void welcome(const Listener& at) {
    for (int n = 0; n < 64; ++n) {
      const int file = at.accept();
      if (file < 0) {
        if (errno == EMFILE || errno == ENFILE || errno == ENOMEM || errno == ENOBUFS) rest(true);
        return;
      }
      if (!at.asks() && files_.size() >= options_.hosts) {
        const std::string no = no_room(options_.hosts);
        ::send(file, no.data(), no.size(), MSG_NOSIGNAL | MSG_DONTWAIT), ::close(file);
        continue;
      }
      if (at.asks() && strangers_ >= most_strangers) leave(oldest_stranger());
      Guest& g = guests_[file];
      g.file = file, g.came = monotonic_now();
      if (at.asks())
        ++strangers_;
      else
        admit(g);
      watch_.add(file), g.watched = EPOLLIN;
    }
  }

  // A connection without a token takes no host's place. Returns the oldest one; there must be one.
  Guest& oldest_stranger() {
    const auto came = [](const auto& g) { return g.second.host ? INT64_MAX : g.second.came; };
    return std::ranges::min_element(guests_, {}, came)->second;
  }

  // Out of file descriptors: stops accepting for a moment instead of spinning.
  void rest(bool on) {
    resting_ = on;
    for (const Listener& l : listeners_) watch_.change(l.file(), on ? 0u : static_cast<std::uint32_t>(EPOLLIN));
  }

  void admit(Guest& g) {
    g.host = imaging_.arrive();
    files_[*g.host] = g.file;
  }
  void leave(Guest& g) {
    if (g.in_hand) {  // cancels its work; the thread that does it cleans up
      g.gone = true, parting_.erase(g.file);
      lanes_.look();
      watch_.remove(g.file);
      return;
    }
    if (g.host)
      imaging_.leave(*g.host), files_.erase(*g.host);
    else
      --strangers_;
    busy_.erase(g.file), kept_.erase(g.file), parting_.erase(g.file), full_.erase(g.file);
    ::close(g.file);
    guests_.erase(g.file);
  }

  // Disconnects those that have not sent the token in time.
  void tire() {
    const Nanos now = monotonic_now();
    std::vector<int> late;
    for (const auto& [file, g] : guests_)
      if (!g.host && now - g.came > patience) late.push_back(file);
    for (const int file : late) leave(guests_.at(file));
  }

  // ---- lines

  // Serves one host for a bounded time, so that no other waits long.
  void take_turn(Guest& g, Nanos most) {
    if (!g.last_word && !g.half_closed && g.seen == g.in.size() && !g.read()) return leave(g);
    const Nanos until = monotonic_now() + most;
    for (int n = 0; n < turn_lines && monotonic_now() < until && !g.last_word && !g.full(); ++n)
      if (!take_line(g) || g.gone) {
        if (g.gone) return leave(g);
        if (g.kept) return;
        if (g.half_closed) g.last_word = true;
        if (g.half_closed && g.waiting() == 0) leave(g);
        return;
      }
    if (!g.last_word && !g.full()) busy_.insert(g.file);
  }

  // Enters the `send` whose bytes have all come, or were skipped.
  bool take_sent(Guest& g) {
    if (g.wanted) imaging_.receive(*g.host, std::exchange(g.sent, {}));
    served = &g;
    answer(g, imaging_.enter(*g.host, std::exchange(g.announced, {}), monotonic_now()));
    return served = nullptr, true;
  }

  // Takes the next whole line. Returns false if none has arrived.
  bool take_line(Guest& g) {
    if (!g.announced.empty()) return g.take_bytes() && take_sent(g);
    const std::size_t end = g.in.find('\n', g.seen);
    const std::size_t longest = g.host ? Imaging::longest_line : longest_token_line;
    if (end == std::string::npos ? g.in.size() > longest : end > longest) {
      g.skipping = end == std::string::npos;
      g.drop(g.skipping ? g.in.size() : end + 1);
      if (!g.host) return answer(g, {refuse_token(g), g.guesses >= most_guesses});
      return answer(g, imaging_.enter_too_long(*g.host, monotonic_now()));
    }
    if (end == std::string::npos) {
      g.seen = g.in.size();
      return false;
    }
    const std::string line = g.in.substr(0, end);
    if (!g.host) return g.drop(end + 1), answer(g, meet(g, line));
    if (const auto length = imaging_.bytes_after(*g.host, line)) {
      g.announced = line, g.awaited = *length, g.wanted = imaging_.wants_bytes(*g.host, line);
      g.drop(end + 1);
      return g.take_bytes() && take_sent(g);
    }
    served = &g;
    const Imaging::Reply reply = imaging_.enter(*g.host, line, monotonic_now());
    served = nullptr;
    if (reply.later) return keep(g), false;
    g.drop(end + 1);
    return answer(g, reply);
  }

  // Holds back the host's next line, and reads no more from it until then.
  void keep(Guest& g) {
    g.kept = true, kept_.insert(g.file);
    watch_.change(g.file, g.watched = 0);
  }
  void let_on() {
    for (const int file : std::exchange(kept_, {})) {
      Guest& g = guests_.at(file);
      g.kept = false, busy_.insert(file);
      watch_.change(file, g.watched = EPOLLIN);
    }
  }

  bool answer(Guest& g, Imaging::Reply reply) {
    if (!reply.line.empty()) g.say(std::move(reply.line));
    if (reply.quit) g.last_word = true, g.in.clear();
    return true;
  }

  Imaging::Reply meet(Guest& g, std::string_view line) {
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    constexpr std::string_view word = "token ";
    if (!line.starts_with(word) || !same_token(line.substr(word.size()), options_.token))
      return {refuse_token(g), g.guesses >= most_guesses};
    if (files_.size() >= options_.hosts) return {no_room(options_.hosts), true};
    admit(g);
    --strangers_;
    return {"{\"line\":0,\"ok\":true}\n", false};
  }
  static std::string refuse_token(Guest& g) { return ++g.guesses, wrong_token(); }

  // ---- answers and events

  void tell(const Imaging::Event& e) {
    const auto file = files_.find(e.to);
    if (file == files_.end()) return;
    Guest& g = guests_.at(file->second);
    if (g.last_word) return;
    if (g.waiting() > most_events_waiting) {
      ++g.lost;
      return;
    }
    if (g.lost > 0) g.say(fmt::format("{{\"event\":\"lost\",\"events\":{}}}\n", std::exchange(g.lost, 0)));
    g.say(e.line);
  }

  void send(Guest& g) {
    const std::size_t before = g.waiting();
    if (!g.send()) return leave(g);
    if (g.waiting() < before) g.moved = monotonic_now();
    if (g.waiting() == 0 && g.last_word) return leave(g);
    if (stops_reading(g)) {
      tell_user("betwixt: warning: a host that does not read its answers was disconnected\n");
      return leave(g);
    }
    if (g.in_hand) return;
    const bool deaf = g.last_word || g.half_closed || g.kept || g.full();
    const std::uint32_t wanted = (deaf ? 0u : static_cast<std::uint32_t>(EPOLLIN)) |
                                 (g.waiting() > 0 ? static_cast<std::uint32_t>(EPOLLOUT) : 0u);
    if (wanted != g.watched) watch_.change(g.file, g.watched = wanted);
  }

  // Back-pressure: reads no more from a host until it has read its waiting answers. A single answer may exceed the
  // limit. Returns true if the host has read nothing for too long.
  bool stops_reading(Guest& g) {
    if (g.full()) {
      if (full_.insert(g.file).second) g.moved = monotonic_now();
      return monotonic_now() - g.moved > patience;
    }
    if (full_.erase(g.file) > 0) busy_.insert(g.file);
    return false;
  }

  Imaging& imaging_;
  const std::vector<Listener>& listeners_;
  const ServeOptions& options_;
  FileWatch watch_;
  std::unordered_map<int, Guest> guests_;  // by file descriptor
  std::unordered_map<Imaging::Host, int> files_;
  std::set<int> busy_;     // may have lines to process
  std::set<int> kept_;     // hold back their next line
  std::set<int> full_;     // must read their answers before they may send more
  std::set<int> parting_;  // closed their side while a thread works for them
  MemoryReturn memory_;
  MultilevelQueue lanes_{memory_};
  LeaderFollowerPool leaders_{[this](LeaderFollowerPool::Lock& lock) { round(lock); }};
  ClockLink clock_;
  std::optional<Error> failed_;
  std::size_t strangers_ = 0;
  bool resting_ = false;
};

}  // namespace

Status serve(Imaging& imaging, FrameClock& clock, const std::vector<Listener>& listeners, const ServeOptions& options) {
  return Server(imaging, clock, listeners, options).run();
}

}  // namespace betwixt
