// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What hosts that subscribed are told: what changed, and what frames tell.
#include <fmt/format.h>

#include <algorithm>

#include "language/json.h"
#include "server/imaging.h"

namespace betwixt {

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
