// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Events for subscribed hosts: changes of the document, and events that frames bring.
#include <fmt/format.h>

#include <algorithm>

#include "language/json.h"
#include "server/imaging.h"

namespace betwixt {

void Imaging::changed(Host by, const std::string& commands, Nanos now) {
  ++version_;
  const auto told = [&] {
    return fmt::format("{{\"event\":\"change\",\"tick\":{},\"host\":{},\"commands\":{}}}\n", tick(now), by, commands);
  };
  tell_all(changes, told);
}

void Imaging::tell_all(Topic topic, const std::function<std::string()>& what) {
  std::shared_ptr<const std::string> text;
  for (const auto& [host, visitor] : hosts_) {
    if (!(visitor.topics & topic)) continue;
    if (!text) text = std::make_shared<const std::string>(what());
    if (!text->empty()) events_.push_back({host, text});
  }
}

bool Imaging::frames_wanted() const {
  return std::any_of(hosts_.begin(), hosts_.end(),
                     [](const auto& h) { return (h.second.topics & ~unsigned{changes}) != 0; });
}

// Sends the events of one frame after the other. Other threads can run while contacts are computed, and may add a
// frame.
void Imaging::shown(const std::vector<Shown>& frames) {
  shown_.insert(shown_.end(), frames.begin(), frames.end());
  if (telling_) return;
  struct Telling {
    bool& on;
    explicit Telling(bool& flag) : on(flag) { on = true; }
    Telling(const Telling&) = delete;
    Telling& operator=(const Telling&) = delete;
    ~Telling() { on = false; }
  } const telling(telling_);
  while (!shown_.empty()) {
    const Shown next = std::move(shown_.front());
    shown_.pop_front();
    tell(next);
  }
}

void Imaging::tell(const Shown& f) {
  const Time after = f.time < told_ ? f.time - Time{1} : told_;
  told_ = f.time;
  tell_contacts(f);
  tell_all(notes, [&] {
    std::string remarks;
    if (document().scene().notes_shown)
      for (const Note& n : document().notes(after + Time{1}, f.time))
        remarks += fmt::format("{{\"event\":\"note\",\"seconds\":{},\"note\":{}}}\n", json_number(n.time.seconds()),
                               json_text(n.text));
    return remarks;
  });
  tell_all(slow, [&] {
    std::string turns;
    for (const SlowTurn& s : f.turns)
      turns += fmt::format("{{\"event\":\"slow\",\"target\":{},\"slow\":{},\"late\":{:.1f}}}\n", json_text(s.target),
                           s.slow, s.late);
    return turns;
  });
  tell_all(frames, [&] {
    return fmt::format("{{\"event\":\"frame\",\"frame\":{},\"seconds\":{},\"late\":{:.1f}}}\n", f.number,
                       json_number(f.time.seconds()), static_cast<double>(f.late) / 1000);
  });
}

// Runs here, not on the clock's thread, so it never delays the next frame. It may take long, so it runs beside; the
// subscribers may have left when it ends.
void Imaging::tell_contacts(const Shown& f) {
  const auto watches = [](const auto& h) { return (h.second.topics & contacts) != 0; };
  if (std::none_of(hosts_.begin(), hosts_.end(), watches)) return watch_.reset();
  if (!watch_) watch_ = std::make_shared<ContactWatch>(options_.contacts, options_.sweep);
  const auto watch = watch_;
  const Program film = options_.beside ? program_ : program();  // the published and shown program
  std::vector<ContactEvent> events;
  const auto look = [&] { events = watch->step(film.frame(f.time)); };
  if (options_.beside)
    options_.beside(look, Claim::first);
  else
    look();
  if (watch != watch_) return;  // another watch has been started since
  tell_all(contacts, [&] {
    std::string all;
    for (const ContactEvent& e : events) all += to_json(e, film.document()) + "\n";
    return all;
  });
}

}  // namespace betwixt
