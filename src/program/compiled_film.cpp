// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lookups in the data of a compiled film.
#include "program/compiled_film.h"

#include <span>

namespace betwixt {

const Binding& CompiledFilm::find_shown(std::uint32_t object, FunctionId f) const {
  const Binding& own = find(object, f);
  if (pieces_of_formulas.empty() || &own != &defaults[f]) return own;
  const auto piece = pieces_of_formulas.find(object);
  return piece == pieces_of_formulas.end() ? own : find(piece->second.whole, f);
}

const Binding& CompiledFilm::find(std::uint32_t object, FunctionId f) const {
  const auto first = bindings.begin() + pieces[object].binding, last = bindings.begin() + pieces[object + 1].binding;
  const auto at = std::lower_bound(first, last, f, [](const Binding& b, FunctionId id) { return b.function < id; });
  return at != last && at->function == f ? *at : defaults[f];
}

const MaterialRow& material_of(const Value& v) { return material_row(*std::get<Text>(v)); }

std::uint32_t CompiledFilm::texture(const Value& v) const {
  const auto& pictures = *document.scene().pictures;
  const auto picture = pictures.find(*std::get<Text>(v));
  return picture == pictures.end() ? Evaluation::Look::none
                                   : static_cast<std::uint32_t>(std::distance(pictures.begin(), picture));
}

const Activity* Schedule::active(const Source& s, std::int64_t t) const {
  const Activity *first = activities.data() + s.first_activity, *last = first + s.activities;
  const Activity* next =
      std::upper_bound(first, last, t, [](std::int64_t time, const Activity& a) { return time < a.from; });
  return next != first && t < next[-1].until ? next - 1 : nullptr;
}

void CompiledFilm::evaluate_curve(const CurveUse& use, Time t, double* out) const {
  set.evaluate(use.curve, t, out);
  use.bound(out);
}

void CompiledFilm::evaluate_curves(const Binding& b, Time t, double* out) const {
  std::copy_n(&rest[b.offset], 4, out);
  for (std::uint32_t i = 0; i < b.curves; ++i) {
    const CurveUse& use = curves[b.first_curve + i];
    evaluate_curve(use, t, out + (use.offset - b.offset));
  }
}

bool CompiledFilm::runs_code(const Schedule::LiveSource& coded, Time t) const {
  const Binding& b = *coded.binding;
  if (b.function == fn::motion) {
    const std::int32_t moving = nodes[coded.node].moving;
    const auto at = moving < 0 ? std::nullopt : movings[static_cast<std::size_t>(moving)].place(t);
    return at && !at->piece->open && CurveSet::runs_code(at->piece->progress, at->time);
  }
  if (b.steps >= 0) return steps_of(b).runs_code(t);
  const auto uses = std::span(curves).subspan(b.first_curve, b.curves);
  return std::any_of(uses.begin(), uses.end(), [&](const CurveUse& u) { return CurveSet::runs_code(u.curve, t); });
}

bool CompiledFilm::one_body(std::uint32_t node, std::uint32_t parent) const {
  const auto& objects = document.scene().objects;
  const std::string &name = objects[nodes[node].object].name, &whole = objects[nodes[parent].object].name;
  return drawable(nodes[parent].kind) ||
         (name.size() > whole.size() && name[whole.size()] == '/' && name.starts_with(whole));
}

const CompiledSpan* CompiledFilm::span(const Node& n, Time t) const {
  const CompiledSpan *first = spans.data() + n.first_span, *last = first + n.spans;
  const CompiledSpan* next =
      std::upper_bound(first, last, t, [](Time time, const CompiledSpan& h) { return time < h.from; });
  return next == first ? nullptr : next - 1;
}

std::optional<Moving::Place> Moving::place(Time t) const {
  const Extrapolation how = t < first ? extend_before : t > last ? extend_after : Extrapolation::hold;
  if (how >= Extrapolation::cycle) t = {fold(t.flicks, first.flicks, last.flicks, how == Extrapolation::bounce)};
  const auto later =
      std::upper_bound(pieces.begin(), pieces.end(), t, [](Time time, const Piece& p) { return time < p.from; });
  if (later != pieces.begin()) return Place{&later[-1], t, how};
  // Linear extrapolation continues backwards before the first piece.
  const bool ahead = how == Extrapolation::linear && pieces[0].from == first;
  return ahead ? std::optional(Place{&pieces[0], t, how}) : std::nullopt;
}

std::optional<std::uint32_t> CompiledFilm::camera_at(Time t) const {
  const Scene& scene = document.scene();
  for (const auto* by_time : {&*scene.cuts, &*scene.views}) {
    const auto next = by_time->upper_bound(t);
    if (next != by_time->begin() && std::prev(next)->second) return std::prev(next)->second.index;
  }
  return first_camera;  // cameras of display lists are active only through `views`
}

std::optional<CompiledFilm::Changing> CompiledFilm::changing_at(Time t) const {
  const auto& ways = *document.scene().cut_ways;
  auto way = ways.upper_bound(t);
  if (way == ways.begin()) return std::nullopt;
  const auto& [from, how] = *--way;
  const auto& cuts = *document.scene().cuts;
  const auto next = cuts.upper_bound(from);
  const bool over = t >= from + how.length || (next != cuts.end() && next->first <= t);
  if (over || from.flicks == INT64_MIN) return std::nullopt;
  return Changing{camera_at(from - Time{1}), (t - from).seconds() / how.length.seconds(), how.kind};
}

std::optional<std::uint32_t> CompiledFilm::node_of_object(ObjectId id) const {
  const bool known = id.index < node_of.size() && node_of[id.index] != ObjectId::nothing;
  return known ? std::optional(node_of[id.index]) : std::nullopt;
}

std::vector<std::uint32_t> CompiledFilm::goals(std::uint32_t object, FunctionId f) const {
  const Binding& b = find(object, f);
  std::vector<std::uint32_t> out;
  const auto add = [&](const Value& v) {
    const auto* id = std::get_if<ObjectId>(&v);
    if (const auto node = id ? node_of_object(*id) : std::nullopt) out.push_back(*node);
  };
  if (b.channels > 0 || b.live >= 0) return out;
  if (b.steps < 0) add(b.constant);
  if (b.steps >= 0)
    for (const Value& v : steps_of(b).values()) add(v);
  return out;
}

std::size_t LivePart::piece_at(Time t) const {
  const auto at =
      std::upper_bound(pieces.begin(), pieces.end(), t, [](Time time, const Piece& p) { return time < p.from; });
  return at == pieces.begin() ? 0 : static_cast<std::size_t>(at - pieces.begin()) - 1;
}

bool CompiledFilm::parted(std::int32_t index, int component) const {
  const Live& live = lives[static_cast<std::size_t>(index)];
  if (component < 0 || live.collision >= 0 || live.strands.size() != 1 || !live.strands[0].filters.empty())
    return false;
  const LiveStrand& own = live.strands[0];
  return !own.parts.empty() && own.parts[0].component >= 0 && !std::holds_alternative<Procedure>(own.set);
}

}  // namespace betwixt
