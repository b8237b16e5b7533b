// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Contacts and sights that begin or end from tick to tick, and their JSON for hosts.
#include <fmt/format.h>

#include <algorithm>

#include "program/contacts.h"
#include "scene/document.h"

namespace betwixt {
namespace {

using What = ContactEvent::What;

bool before(const Contact& x, const Contact& y) {
  return std::pair(x.a.index, x.b.index) < std::pair(y.a.index, y.b.index);
}
bool earlier(const ContactGroup& x, const ContactGroup& y) {
  return std::lexicographical_compare(x.objects.begin(), x.objects.end(), y.objects.begin(), y.objects.end(),
                                      [](ObjectId a, ObjectId b) { return a.index < b.index; });
}

ContactEvent event(const Contact& p, bool begin, Time t) { return {What::contact, begin, {}, {p.a, p.b}, {}, t}; }
ContactEvent event(const ContactGroup& g, bool begin, Time t) {
  return {What::group, begin, {}, g.objects, g.pairs, t};
}

// Makes events of the elements of `a` that are not in `b`; both must be sorted.
template <class T, class Less>
void differences(const std::vector<T>& a, const std::vector<T>& b, Less less, bool begin, Time t,
                 std::vector<ContactEvent>& out) {
  auto at = b.begin();
  for (const T& x : a) {
    while (at != b.end() && less(*at, x)) ++at;
    if (at == b.end() || less(x, *at)) out.push_back(event(x, begin, t));
  }
}

}  // namespace

std::vector<ContactEvent> ContactWatch::step(const Frame& frame) {
  std::vector<ContactEvent> out;
  if (begun_ && frame.time < now_.time) return seek(frame), out;
  const Contacts was = std::exchange(now_, contacts(frame, options_));
  const Time t = now_.time;
  std::vector<Contact> all = now_.pairs;  // contacts that began, even if they have ended since
  if (sweep_ && begun_) {
    for (const Contact& p : swept(was, now_, options_).pairs)
      if (!now_.touching(p.a, p.b) && !was.touching(p.a, p.b)) all.push_back(p);
    std::sort(all.begin(), all.end(), before);
  }
  begun_ = true;
  differences(was.pairs, now_.pairs, before, false, t, out);
  differences(all, was.pairs, before, true, t, out);
  differences(all, now_.pairs, before, false, t, out);  // a contact between two ticks ends at once
  differences(was.groups, now_.groups, earlier, false, t, out);
  differences(now_.groups, was.groups, earlier, true, t, out);
  const auto view = [&](ObjectId id, Sight sight) { out.push_back({What::view, true, sight, {id}, {}, t}); };
  auto old = was.boxes.begin();
  for (const ContactBox& b : now_.boxes) {
    for (; old != was.boxes.end() && old->id.index < b.id.index; ++old)  // no longer drawn
      if (old->sight != Sight::out) view(old->id, Sight::out);
    const Sight sight = old != was.boxes.end() && old->id == b.id ? (old++)->sight : Sight::out;
    if (sight != b.sight) view(b.id, b.sight);
  }
  for (; old != was.boxes.end(); ++old)
    if (old->sight != Sight::out) view(old->id, Sight::out);
  return out;
}

void ContactWatch::seek(const Frame& frame) {
  now_ = contacts(frame, options_);
  begun_ = true;
}

std::string to_json(const ContactEvent& e, const Document& document) {
  const Scene& scene = document.scene();
  const auto name = [&](ObjectId id) {  // names contain no characters that JSON escapes
    return "\"" + (id.index < scene.objects.size() ? scene.objects[id.index].name : std::string("none")) + "\"";
  };
  const std::int64_t tick = scene.ticks.whole(e.time);
  const char* state = e.begin ? "begin" : "end";
  if (e.what == What::view)
    return fmt::format(R"({{"event":"view","object":{},"state":"{}","tick":{}}})", name(e.objects.at(0)),
                       e.sight == Sight::in    ? "in"
                       : e.sight == Sight::out ? "out"
                                               : "boundary",
                       tick);
  if (e.what == What::contact)
    return fmt::format(R"({{"event":"contact","state":"{}","a":{},"b":{},"tick":{}}})", state, name(e.objects.at(0)),
                       name(e.objects.at(1)), tick);
  std::string objects, pairs;
  for (const ObjectId id : e.objects) objects += (objects.empty() ? "" : ",") + name(id);
  for (const Contact& p : e.pairs) pairs += fmt::format("{}[{},{}]", pairs.empty() ? "" : ",", name(p.a), name(p.b));
  return fmt::format(R"({{"event":"group","state":"{}","objects":[{}],"pairs":[{}],"tick":{}}})", state, objects, pairs,
                     tick);
}

}  // namespace betwixt
