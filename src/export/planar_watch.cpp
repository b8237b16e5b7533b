// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/planar_watch.h"

#include <fmt/format.h>

#include <algorithm>

#include "betwixt/pose.h"
#include "exchange/gradient_place.h"
#include "export/planar.h"
#include "export/seen.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

constexpr std::size_t most_numbers = 20'000'000;  // of outlines that change: a file of some 200 MB

}  // namespace

void PlanarWatch::add(ObjectId id, bool turns_out) {
  Watched& w = all_[id.index];
  w.turns_out = turns_out, w.paper = drawn_within(program_, id, options_.from);
}

Status PlanarWatch::run() {
  Evaluation e(program_);
  const std::vector<Time> times = looks_of(program_, options_.from, options_.until);
  const std::vector<Time> breaks = program_.discontinuities(options_.from, options_.until);
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (options_.keys.go_on && i % 16 == 0 &&
        !options_.keys.go_on(static_cast<double>(i) / static_cast<double>(times.size())))
      return fail(ErrorCode::machine, "stopped");
    const bool jumps = i > 0 && std::binary_search(breaks.begin(), breaks.end(), times[i]);
    if (jumps && times[i].flicks - 1 > times[i - 1].flicks) look(e, {times[i].flicks - 1}, false);
    look(e, times[i], jumps);
    if (numbers_ > most_numbers)
      return fail(ErrorCode::range,
                  fmt::format("the animated outlines need more than {} million numbers", most_numbers / 1'000'000),
                  "choose fewer frames: --frames 1f..24f; or name the objects to write");
  }
  return Nothing{};
}

void PlanarWatch::look(Evaluation& e, Time t, bool jumps) {
  e.to(t);
  for (const std::uint32_t i : e.changed()) {
    const auto found = all_.find(e.drawables()[i].index);
    if (found != all_.end()) look(e, i, found->second, jumps);
  }
  before_ = t;
}
void PlanarWatch::look(Evaluation& e, std::uint32_t i, Watched& w, bool jumps) {
  const Evaluation::Look& l = e.looks()[i];
  if (!l.visible) {
    if (!w.looks.empty() && w.looks.back().drawn) put(w, {e.time(), nullptr, true});
    return betwixt::put(w.depths, e.time(), {});
  }
  const Mat4& world = e.worlds()[i];
  const std::shared_ptr<const Shape>& shape = e.shape(l.shape);
  const auto toward = l.toward == Evaluation::Look::none ? nullptr : e.shape(l.toward);
  w.textured = w.textured || l.texture != Evaluation::Look::none;
  betwixt::put(w.depths, e.time(), translation_of(world).z + front_of(*shape) * length(column(world, 2)));
  const bool known = !w.looks.empty() && w.looks.back().drawn && shape == w.shape && toward == w.toward;
  const auto gradients = l.gradients == Evaluation::Look::none ? nullptr : e.gradients(l.gradients);
  if (known && l.blend == w.blend && gradients == w.gradients && !w.turns_out && !w.paper) return;
  w.shape = shape, w.toward = toward, w.gradients = gradients, w.blend = l.blend;
  auto drawn = drawn_of(shape, toward, l.blend, w.turns_out ? &world : nullptr);
  if (!drawn) w.no_drawing = a_kind(shape->kind);
  if (drawn && gradients)
    drawn->gradients = gradients, drawn->gradient_box = gradient_box(*shape, toward.get(), l.blend);
  if (drawn && w.paper)
    if (const auto back = inverse(pose(program_, w.paper, e.time()).world)) carry(*drawn, *back * world);
  if (drawn && known && w.looks.back().drawn->looks_like(*drawn)) return;
  put(w, {e.time(), drawn ? std::make_shared<const PlanarDrawn>(*std::move(drawn)) : nullptr, jumps});
}
// An unchanged look continues the one before.
void PlanarWatch::put(Watched& w, SeenThen l) {
  if (w.looks.empty() && l.time > options_.from) w.looks.push_back({options_.from, nullptr, true});
  if (!w.looks.empty() && w.looks.back().time < before_) w.looks.push_back({before_, w.looks.back().drawn, false});
  if (l.drawn) numbers_ += l.drawn->numbers();
  w.looks.push_back(std::move(l));
}

}  // namespace betwixt
