// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/memory.h"

#include "base/memory.h"
#include "program/compiled.h"

namespace betwixt {
namespace {

std::size_t bytes_of(const Schedule& s) {
  return bytes_held(s.sources) + bytes_held(s.events) + bytes_held(s.activities) + bytes_held(s.begins) +
         bytes_held(s.ends) + bytes_held(s.lives) + bytes_held(s.coded);
}

std::size_t bytes_of(const Live& live) {
  std::size_t sum = bytes_held(live.strands);
  for (const LiveStrand& strand : live.strands) {
    sum += bytes_held(strand.parts) + bytes_held(strand.filters);
    for (const LivePart& part : strand.parts) sum += bytes_held(part.pieces) + part.track.events.bytes();
  }
  return sum;
}

}  // namespace

std::size_t bytes_of(const Program& program) {
  const Program::Compiled& c = program.compiled();
  std::size_t sum = sizeof c + c.set.bytes() + bytes_of(c.schedule);
  const auto add = [&](const auto&... arrays) { ((sum += bytes_held(arrays)), ...); };
  add(c.rest, c.curves, c.steps, c.bindings, c.pieces, c.defaults, c.plains, c.lives, c.reigns, c.nodes, c.drawables);
  add(c.shapes, c.textures, c.videos, c.video_uses, c.lights, c.eyes, c.layers, c.borrowers, c.spans, c.frozen,
      c.environments, c.sitings, c.movings);
  add(c.offsets, c.node_of, c.slow_shapes, c.slow_blends);
  for (const auto& steps : c.steps) sum += shared_bytes<StepTrack> + steps->bytes();
  for (const Live& live : c.lives) sum += bytes_of(live);
  for (const Siting& siting : c.sitings)
    for (const Siting::Change& change : siting.changes) sum += sizeof change + bytes_held(change.sites);
  for (const Moving& moving : c.movings) sum += bytes_held(moving.pieces);
  sum += c.shapes.size() * shared_bytes<Shape>;
  return sum;
}

}  // namespace betwixt
