// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/mentions.h"

#include <algorithm>
#include <numeric>

#include "base/cancellation.h"
#include "track/along.h"

namespace betwixt {
namespace {

// Calls f for each quoted text, up to a dot in it if it has one: the names that code reads.
template <class F>
void each_quoted(const std::string& source, const F& f) {
  for (std::size_t i = 0; i < source.size();) {
    const char quote = source[i++];
    if (quote != '"' && quote != '\'') continue;
    const std::size_t end = std::min(source.find(quote, i), source.size());
    const std::string_view text = std::string_view(source).substr(i, end - i);
    f(text.substr(0, text.find('.')));
    for (; i < source.size() && source[i] != quote; ++i)
      if (source[i] == '\\' && i + 1 < source.size()) ++i;
    if (i < source.size()) ++i;
  }
}

}  // namespace

// Adds the number to all names above the name.
void Mentions::add_above(ByName& to, std::string_view name, std::uint32_t number) {
  for (auto slash = name.rfind('/'); slash != std::string_view::npos; slash = name.rfind('/')) {
    name = name.substr(0, slash);
    to[std::string(name)].insert(number);
  }
}

void Mentions::name(std::string_view said, std::uint32_t number) {
  by_name_[std::string(said)].insert(number);
  add_above(by_name_, said, number);
}

void Mentions::look_at(const Value& v, std::uint32_t number) {
  if (const auto* held = std::get_if<Attachment>(&v); held && held->parent)
    by_number_[held->parent.index].insert(number);
  if (const auto* names = std::get_if<Names>(&v))
    for (const std::string& one : **names) name(one, number);
  if (const auto* moves = std::get_if<Moves>(&v))
    for (const Factor& f : (**moves).factors) name(f.about, number);
  const auto* computed = std::get_if<Procedure>(&v);
  if (!computed || !computed->code) return;
  if (const Along* way = along(v)) by_number_[way->road.index].insert(number);
  if (computed->code->language == "lua")
    each_quoted(computed->code->source, [&](std::string_view said) { name(said, number); });
}

void Mentions::look_at(const Object& o, std::uint32_t number) {
  if (o.removed) return;
  add_above(below_, o.name, number);
  const auto look = [&](const Cow<Track>& track) {
    track->events.each([&](const Event& e) {
      look_at(e.value, number);
      if (e.detail && e.detail->before) look_at(*e.detail->before, number);
    });
  };
  for (const Slot& slot : o.slots) {
    if (slot.layer) by_number_[slot.layer.index].insert(number);
    if (slot.set) look_at(*slot.set, number);
    for (const Strand* s : {static_cast<const Strand*>(&slot), &slot.velocity}) {
      look(s->track);
      for (const Cow<Track>& component : s->components) look(component);
    }
  }
}

void Mentions::follow(const Scene& s) {
  s.objects.each_changed(seen_, [&](std::size_t i) {
    Cancellation::check();
    look_at(s.objects[i], static_cast<std::uint32_t>(i));
  });
  seen_ = s.objects;
}

std::vector<std::uint32_t> Mentions::of(const Scene& s, const std::vector<ObjectId>& those) const {
  std::vector<std::uint32_t> out;
  for (const ObjectId id : those) {
    if (const auto at = by_number_.find(id.index); at != by_number_.end())
      out.insert(out.end(), at->second.begin(), at->second.end());
    if (const auto at = by_name_.find(s.objects[id.index].name); at != by_name_.end())
      out.insert(out.end(), at->second.begin(), at->second.end());
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  std::erase_if(out, [&](std::uint32_t i) { return i >= s.objects.size(); });
  return out;
}

std::vector<std::uint32_t> all_of(const Objects& objects) {
  std::vector<std::uint32_t> out(objects.size());
  std::iota(out.begin(), out.end(), 0);
  return out;
}

std::vector<std::uint32_t> Mentions::below(std::string_view name) const {
  const auto at = below_.find(name);
  if (at == below_.end()) return {};
  std::vector<std::uint32_t> out(at->second.begin(), at->second.end());
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace betwixt
