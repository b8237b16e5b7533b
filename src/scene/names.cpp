// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/names.h"

namespace betwixt {

namespace {

struct QueryName {
  Query query;
  std::string_view name;
  bool (*of)(Kind);
};
bool heard(Kind k) { return k == Kind::sound; }
bool moves_others(Kind k) { return k == Kind::environment; }
constexpr QueryName query_names[] = {{Query::world, "world", [](Kind) { return true; }},
                                     {Query::by, "by", moves_others},
                                     {Query::every, "every", moves_others},
                                     {Query::count, "count", moves_others},
                                     {Query::touching, "touching", drawable},
                                     {Query::in_view, "in-view", drawable},
                                     {Query::loudness, "loudness", heard},
                                     {Query::onsets, "onsets", heard}};

}  // namespace

std::optional<Query> find_query(Kind kind, std::string_view name) {
  for (const QueryName& q : query_names)
    if (q.name == name && q.of(kind)) return q.query;
  return std::nullopt;
}

std::string_view name_of(Query query) {
  return std::find_if(std::begin(query_names), std::end(query_names),
                      [&](const QueryName& q) { return q.query == query; })
      ->name;
}

std::string object_name(const Scene& s, ObjectId id) {
  const Object* o = find_object(s, id);
  return o ? o->name : "none";
}

std::string target_name(const Scene& s, const Target& t) {
  std::string name = object_name(s, t.object) + ".";
  if (const auto query = t.query()) {
    name += name_of(*query);
    return t.component < 0 ? name : name.append(".").append(component_name(Type::vector, t.component));
  }
  const FunctionSpec& spec = spec_of(s, t.function);
  name += spec.name;
  if (t.component >= 0) name.append(".").append(component_name(spec.type, t.component));
  return t.velocity ? name + ".velocity" : name;
}

Hint near_object(const Scene& s, std::string_view word) {
  constexpr std::size_t most = 10'000;
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < s.objects.size() && i < most; ++i)
    if (!s.objects[i].removed) names.push_back(s.objects[i].name);
  for (const auto& a : *s.aliases) names.push_back(a.first);
  return did_you_mean(word, names);
}

std::string format_time(Time t, Rate rate) {
  const double n = rate.frame_number(t);
  if (n == std::round(n) && rate.frame(n) == t) return fmt::format("{}f", n == 0 ? 0.0 : n);
  return fmt::format("{}s", t.flicks == 0 ? 0.0 : t.seconds());
}

std::string Document::name(ObjectId id) const { return object_name(*scene_, id); }
std::string Document::name(const Target& t) const { return target_name(*scene_, t); }

}  // namespace betwixt
