// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Contacts as a function of time, also for the film's procedures. Evaluates only values that affect positions and
// shapes. So a colour may depend on contacts, but a value that moves things may not: that cycle is cut.
#include <algorithm>

#include "program/evaluator.h"

namespace betwixt {
Frame Program::Compiled::solids(Time t, Asking& asking) const {
  Frame f;
  f.time = t;
  for (const Node& n : nodes)  // for calls during compiling, before all attachments are settled
    if (const CompiledSpan* h = span(n, t); h && h->frozen >= 0) thaw(h->frozen, asking);
  Evaluator all(*this);
  all.to(t, asking, true);
  all.add_items(f);
  if (!sees_all(t)) f.camera = all.camera();
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
  if (sees_all(t))  // the default camera sees everything
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
  if (code_->sees_all(t)) f.camera = code_->own_camera();
  return betwixt::contacts(f, options);
}

}  // namespace betwixt
