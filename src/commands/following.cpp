// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/following.h"

#include <algorithm>

#include "procedure/lua.h"
#include "track/along.h"

namespace betwixt {
namespace {

template <class F>
bool any_strand(const Slot& slot, const F& f) {
  const auto in = [&](const Strand& s) {
    return f(s.track) || std::any_of(s.components.begin(), s.components.end(), f);
  };
  return in(slot) || in(slot.velocity);
}

template <class F>
void each_strand(Slot& slot, const F& f) {
  for (Strand* s : {static_cast<Strand*>(&slot), &slot.velocity}) {
    f(s->track);
    for (auto& component : s->components) f(component);
  }
}

}  // namespace

std::string Following::name(const std::string& old) const {
  if (!old.starts_with(from_) || (old.size() > from_.size() && old[from_.size()] != '/')) return old;
  std::string now = to_ + old.substr(from_.size());
  return known_ && !known_->names.find(now) ? old : now;
}

ObjectId Following::id(ObjectId of) const {
  const auto at = ids_.find(of.index);
  return at == ids_.end() ? of : at->second;
}

// Renames quoted texts that are the name, or begin with it and a dot or a slash.
std::string Following::source(const std::string& source) const {
  std::string out;
  for (std::size_t i = 0; i < source.size();) {
    const char quote = source[i];
    out += quote;
    ++i;
    if (quote != '"' && quote != '\'') continue;
    const std::size_t end = i + from_.size();
    if (source.compare(i, from_.size(), from_) == 0 && end < source.size() &&
        (source[end] == '.' || source[end] == '/' || source[end] == quote)) {
      out += to_;
      i = end;
    }
    for (; i < source.size() && source[i] != quote; ++i) {
      out += source[i];
      if (source[i] == '\\' && i + 1 < source.size()) out += source[++i];
    }
    if (i < source.size()) out += source[i++];
  }
  return out;
}

std::shared_ptr<const Routine> Following::code(Role role, const std::shared_ptr<const Routine>& was) const {
  if (!was || was->language != "lua" || was->source.find(from_) == std::string::npos) return nullptr;
  std::string now = source(was->source);
  if (now == was->source) return nullptr;
  auto made = make_lua(role, std::move(now));
  return made ? *std::move(made) : nullptr;
}

std::optional<Value> Following::value(const Value& v) const {
  if (const auto* at = std::get_if<ObjectId>(&v)) return id(*at) == *at ? std::nullopt : std::optional<Value>(id(*at));
  if (const auto* at = std::get_if<Attachment>(&v)) {
    Attachment now = *at;
    now.parent = id(now.parent);
    return now == *at ? std::nullopt : std::optional<Value>(now);
  }
  if (const Along* at = along(v))
    return id(at->road) == at->road ? std::nullopt : std::optional<Value>(along(id(at->road), at->share));
  if (const auto* at = std::get_if<Procedure>(&v)) {
    auto now = code(Role::value, at->code);
    return now ? std::optional<Value>(Procedure{std::move(now)}) : std::nullopt;
  }
  if (const auto* at = std::get_if<Names>(&v)) {
    std::vector<std::string> now;
    for (const std::string& one : **at) now.push_back(name(one));
    return now == **at ? std::nullopt : std::optional<Value>(Names(std::move(now)));
  }
  if (const auto* at = std::get_if<Moves>(&v)) {
    Motion now = **at;
    bool any = false;
    for (Factor& f : now.factors) {
      std::string about = name(f.about);
      any = any || about != f.about;
      f.about = std::move(about);
    }
    return any ? std::optional<Value>(Moves(std::move(now))) : std::nullopt;
  }
  return std::nullopt;
}

bool Following::concerns(const Track& t) const {
  bool any = false;
  t.events.each([&](const Event& e) {
    any = any || value(e.value) || (e.detail && e.detail->before && value(*e.detail->before));
  });
  return any;
}

void Following::apply(Cow<Track>& t) const {
  if (!t || !concerns(*t)) return;
  t.edit().events.edit_between({INT64_MIN}, {INT64_MAX}, [&](Event& e) {
    if (auto now = value(e.value)) e.value = *std::move(now);
    if (!e.detail || !e.detail->before) return;
    if (auto now = value(*e.detail->before)) e.detail.edit().before = *std::move(now);
  });
}

bool Following::concerns(const Object& o) const {
  return std::any_of(o.slots.begin(), o.slots.end(), [&](const Slot& slot) {
    return !(id(slot.layer) == slot.layer) || (slot.set && value(*slot.set)) ||
           any_strand(slot, [&](const Cow<Track>& t) { return concerns(*t); });
  });
}

void Following::apply(Object& o) const {
  for (Slot& slot : o.slots) {
    slot.layer = id(slot.layer);
    if (slot.set)
      if (auto now = value(*slot.set)) slot.set = *std::move(now);
    each_strand(slot, [&](Cow<Track>& t) { apply(t); });
  }
  std::sort(o.slots.begin(), o.slots.end(), [](const Slot& a, const Slot& b) {
    return std::pair(a.function, a.layer.index + 1) < std::pair(b.function, b.layer.index + 1);
  });
}

}  // namespace betwixt
