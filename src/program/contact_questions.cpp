// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Contacts as a function of time, also for the film's procedures. Evaluates only values that affect positions and
// shapes. So a colour may depend on contacts, but a value that moves things may not: that cycle is cut.
#include <algorithm>

#include "program/contacts.h"
#include "program/evaluator.h"
#include "program/placing.h"
#include "program/stage.h"

namespace betwixt {
namespace {

// Returns the input of contacts: items without their looks, and the film's camera, if any.
Frame solids(const Program::Compiled& c, Time t, Asking& asking) {
  Frame f;
  f.time = t;
  for (const Node& n : c.nodes)  // for calls during compiling, before all attachments are settled
    if (const CompiledSpan* h = c.span(n, t); h && h->frozen >= 0) thaw(c, h->frozen, asking);
  Evaluator all(c);
  all.to(t, asking, true);
  all.add_items(f, {});
  if (!c.sees_all(t)) f.camera = all.camera();
  return f;
}

}  // namespace

std::shared_ptr<const Contacts> contacts(const Program::Compiled& c, Time t, Asking& asking) {
  const auto known = asking.found_contacts.find(t.flicks);
  if (known != asking.found_contacts.end() && !asking.is_open(known->second.taken)) {
    asking.take(known->second.taken);
    return known->second.value;
  }
  Working working(asking);
  const Frame f = solids(c, t, asking);
  auto made = std::make_shared<Contacts>(contacts(f));
  if (c.sees_all(t))  // the default camera sees everything
    for (ContactBox& b : made->boxes) b.sight = Sight::in;
  asking.cost += 10 * f.items.size();
  if (auto taken = working.done(); taken && asking.found_contacts.size() < 1000)
    asking.found_contacts.insert_or_assign(t.flicks,
                                           Asking::Found<std::shared_ptr<const Contacts>>{made, *std::move(taken)});
  return made;
}

Contacts Program::contacts(Time t, const ContactOptions& options) const {
  Asking asking;
  Frame f = solids(*code_, t, asking);
  if (code_->sees_all(t)) f.camera = own_camera(*code_);
  return betwixt::contacts(f, options);
}

}  // namespace betwixt
