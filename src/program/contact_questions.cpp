// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Contacts as a function of time, for whoever asks; procedures of the film among them. Only what says where things are
// is worked out, so a colour may ask what touches: only what moves things cannot, and is cut like any circle.
#include <algorithm>

#include "program/compiled.h"

namespace betwixt {
namespace {

// Whether the whole that is named is the holder's: car/wheel on car.
bool part_of(const std::string& name, const std::string& whole) {
  return name.size() > whole.size() && name[whole.size()] == '/' && name.starts_with(whole);
}

}  // namespace

std::vector<std::uint32_t> Program::Compiled::bodies(Time t) const {
  constexpr std::uint32_t unknown = 0xffffffff;
  std::vector<std::uint32_t> body(nodes.size(), unknown), chain;
  const auto holder = [&](std::uint32_t i) -> std::uint32_t {  // itself: nothing that it is one with holds it
    const CompiledSpan* h = span(nodes[i], t);
    if (!h || h->kind < AttachmentKind::hang) return i;
    const auto parent = static_cast<std::uint32_t>(h->parent);
    const auto name = [&](std::uint32_t node) -> const std::string& {
      return document.scene().objects[nodes[node].object].name;
    };
    return drawable(nodes[parent].kind) || part_of(name(i), name(parent)) ? parent : i;
  };
  for (std::uint32_t start = 0; start < nodes.size(); ++start) {
    std::uint32_t i = start;
    while (body[i] == unknown) {
      const std::uint32_t above = holder(i);
      if (above == i) {
        body[i] = i;
      } else {
        chain.push_back(i);
        i = above;
      }
    }
    for (; !chain.empty(); chain.pop_back()) body[chain.back()] = body[i];
  }
  return body;
}

Frame Program::Compiled::solids(Time t, Asking& asking) const {
  Frame f;
  f.time = t;
  for (const Node& n : nodes)  // while attachments are still being worked out
    if (const CompiledSpan* h = span(n, t); h && h->frozen >= 0) thaw(h->frozen, asking);
  const auto numbers = at(t, asking, true);
  const auto w = worlds(t, numbers.data(), asking);
  add_solids(f, numbers.data(), w, asking);
  if (camera_at(t)) f.camera = camera(t, numbers.data(), w);
  return f;
}

std::shared_ptr<const Contacts> Program::Compiled::contacts(Time t, Asking& asking) const {
  const auto known = asking.found_contacts.find(t.flicks);
  if (known != asking.found_contacts.end() && !asking.is_open(known->second.taken)) {
    asking.take(known->second.taken);
    return known->second.value;
  }
  Working working(asking);
  const Frame f = solids(t, asking);
  auto made = std::make_shared<Contacts>(betwixt::contacts(f));
  if (!camera_at(t))  // the camera of a film that has none sees all there is
    for (ContactBox& b : made->boxes) b.sight = Sight::in;
  asking.cost += 10 * f.items.size();
  if (auto taken = working.done(); taken && asking.found_contacts.size() < 1000)
    asking.found_contacts.insert_or_assign(t.flicks,
                                           Asking::Found<std::shared_ptr<const Contacts>>{made, *std::move(taken)});
  return made;
}

Contacts Program::contacts(Time t, const ContactOptions& options) const {
  Asking asking;
  Frame f = code_->solids(t, asking);
  if (!code_->camera_at(t)) f.camera = code_->own_camera();
  return betwixt::contacts(f, options);
}

}  // namespace betwixt
