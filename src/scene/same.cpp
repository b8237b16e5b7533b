// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the content of two documents.
#include <algorithm>

#include "scene/document.h"
#include "scene/own_kinds.h"

namespace betwixt {
namespace {

// Two documents number their objects differently if some were removed, so ids are compared by rank among those that
// exist. Objects of display lists come after all others, in the order of the expansion; they are not content.
struct Ranks {
  std::vector<std::uint32_t> rank;
  std::vector<const Object*> living;
  explicit Ranks(const Scene& s) : rank(s.objects.size(), ObjectId::nothing) {
    for (std::size_t i = 0; i < s.objects.size(); ++i) {
      if (s.objects[i].removed || s.objects[i].derived) continue;
      rank[i] = static_cast<std::uint32_t>(living.size());
      living.push_back(&s.objects[i]);
    }
    for (std::size_t i = 0; i < s.expansion->size(); ++i)
      rank[(*s.expansion)[i].index] = static_cast<std::uint32_t>(living.size() + i);
  }
  ObjectId operator()(ObjectId id) const { return {id.index < rank.size() ? rank[id.index] : ObjectId::nothing}; }
};

struct Compare {
  const Scene &a, &b;
  Ranks ra{a}, rb{b};
  bool same_numbers = ra.rank == rb.rank;  // then an object that both share is equal

  bool values(const Value& x, const Value& y) const {
    const auto *p = std::get_if<ObjectId>(&x), *q = std::get_if<ObjectId>(&y);
    const auto *a1 = std::get_if<Attachment>(&x), *a2 = std::get_if<Attachment>(&y);
    if (a1 && a2) return a1->kind == a2->kind && ra(a1->parent) == rb(a2->parent) && a1->keep_world == a2->keep_world;
    const auto *m1 = std::get_if<Moves>(&x), *m2 = std::get_if<Moves>(&y);
    if (m1 && m2 && !(x == y)) return about_what_is_there(a, **m1) == about_what_is_there(b, **m2);
    return p && q ? ra(*p) == rb(*q) : x == y;
  }
  bool maybe(const std::optional<Value>& x, const std::optional<Value>& y) const {
    return x.has_value() == y.has_value() && (!x || values(*x, *y));
  }
  bool same_twerper(Twerper x, Twerper y) const {
    return is_own(x) && is_own(y) ? twerper_name(a, x) == twerper_name(b, y) : x == y;
  }
  bool events(const Event& x, const Event& y) const {
    return x.time == y.time && same_twerper(x.twerper, y.twerper) && x.keep == y.keep && x.release == y.release &&
           (x.keep || x.release || values(x.value, y.value)) && x.detail->ease_in == y.detail->ease_in &&
           x.detail->ease_out == y.detail->ease_out && x.detail->arguments == y.detail->arguments &&
           maybe(x.detail->before, y.detail->before) && maybe(x.detail->tangent_in, y.detail->tangent_in) &&
           maybe(x.detail->tangent_out, y.detail->tangent_out) && x.detail->handle_in == y.detail->handle_in &&
           x.detail->handle_out == y.detail->handle_out;
  }
  bool tracks(const Track& x, const Track& y) const {
    if (!same_twerper(x.global, y.global) || x.before != y.before || x.after != y.after || x.srgb != y.srgb ||
        x.events.size() != y.events.size())
      return false;
    if (x.global != Twerper::unset && x.arguments != y.arguments) return false;
    const auto p = x.events.between({INT64_MIN}, {INT64_MAX}), q = y.events.between({INT64_MIN}, {INT64_MAX});
    return std::equal(p.begin(), p.end(), q.begin(), q.end(),
                      [&](const Event& e, const Event& f) { return events(e, f); });
  }
  bool strands(const Strand& s, const Strand& t) const {
    if (!tracks(*s.track, *t.track)) return false;
    for (std::size_t i = 0; i < std::max(s.components.size(), t.components.size()); ++i) {  // null equals empty
      static const Track empty;
      const Track &u = s.components.empty() ? empty : *s.components[i],
                  &v = t.components.empty() ? empty : *t.components[i];
      if (!tracks(u, v)) return false;
    }
    return true;
  }
  // Their numbers depend on their history; only the order counts.
  static bool environments(const std::shared_ptr<const Environment>& x, const std::shared_ptr<const Environment>& y) {
    if (!x || !y || x == y) return x == y;
    if (x->size() != y->size()) return false;
    for (std::size_t i = 0; i < x->size(); ++i)
      if (x->event(i).tick != y->event(i).tick || x->event(i).what != y->event(i).what) return false;
    return true;
  }
  bool objects(const Object& x, const Object& y) const {
    if (x.name != y.name || x.kind != y.kind || !environments(x.environment, y.environment)) return false;
    static const Slot nothing;
    const auto rank = [](const Ranks& r, const Slot& s) { return std::pair(s.function, r(s.layer).index + 1); };
    auto p = x.slots.begin(), q = y.slots.begin();
    while (p != x.slots.end() || q != y.slots.end()) {
      const bool left = p != x.slots.end() && (q == y.slots.end() || rank(ra, *p) <= rank(rb, *q));
      const bool right = q != y.slots.end() && (p == x.slots.end() || rank(rb, *q) <= rank(ra, *p));
      const Slot &s = left ? *p++ : nothing, &t = right ? *q++ : nothing;
      if (!maybe(s.set, t.set) || !strands(s, t) || !strands(s.velocity, t.velocity) || s.filters != t.filters)
        return false;
    }
    return true;
  }
  // Compares kinds and the roots of their instances, but not what is an instance's own.
  bool same_kinds() const {
    const auto roots = [](const Scene& s, const Ranks& ranks, const OwnKind& kind) {
      std::vector<std::uint32_t> out{ranks(kind.model()).index};
      for (const Cow<KindInstance>& one : kind.instances)
        if (find_object(s, one->parts.front())) out.push_back(ranks(one->parts.front()).index);
      return out;
    };
    return std::equal(a.kinds->all.begin(), a.kinds->all.end(), b.kinds->all.begin(), b.kinds->all.end(),
                      [&](const OwnKind& x, const OwnKind& y) {
                        return x.name == y.name && x.hidden == y.hidden && roots(a, ra, x) == roots(b, rb, y);
                      });
  }
  bool all() const {
    if (!(a.rate == b.rate && a.ticks == b.ticks && a.smooth_ticks == b.smooth_ticks && a.range == b.range &&
          a.background == b.background && a.appearance == b.appearance && a.notes_shown == b.notes_shown &&
          a.policy == b.policy && a.defined == b.defined && a.aliases == b.aliases && a.lets == b.lets &&
          same_tables(*a.tables, *b.tables) && a.parts == b.parts && a.notes == b.notes && a.sections == b.sections &&
          a.pauses == b.pauses && a.descriptions == b.descriptions && a.procedures == b.procedures &&
          a.recording == b.recording && a.lists == b.lists && a.later_lists == b.later_lists && a.main == b.main))
      return false;
    if (!same_kinds()) return false;
    const auto same_dial = [&](const Dial& x, const Dial& y) {
      return x.address == y.address && ra(x.target.object) == rb(y.target.object) &&
             x.target.function == y.target.function && x.target.component == y.target.component && x.low == y.low &&
             x.high == y.high && x.from == y.from && x.to == y.to && x.mapped == y.mapped;
    };
    if (!std::equal(a.dials->begin(), a.dials->end(), b.dials->begin(), b.dials->end(), same_dial)) return false;
    const auto same_cut = [&](const auto& x, const auto& y) {
      return x.first == y.first && ra(x.second) == rb(y.second);
    };
    if (!std::equal(a.cuts->begin(), a.cuts->end(), b.cuts->begin(), b.cuts->end(), same_cut)) return false;
    if (!(*a.cut_ways == *b.cut_ways)) return false;
    return std::equal(ra.living.begin(), ra.living.end(), rb.living.begin(), rb.living.end(),
                      [&](const Object* x, const Object* y) { return (x == y && same_numbers) || objects(*x, *y); });
  }
};

}  // namespace

Motion about_what_is_there(const Scene& s, Motion m) {
  for (Factor& f : m.factors)
    if (!f.about.empty() && !s.names.find(f.about)) f.about.clear();
  return m;
}

bool same(const Scene& a, const Scene& b) { return Compare{a, b}.all(); }

}  // namespace betwixt
