// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of compiling: tracks and constants (compile.cpp), what is worked out by question and answer
// (compile_lives.cpp), what is where (compile_nodes.cpp), what is drawn and when it changes (compile_schedule.cpp).
#pragma once

#include "program/compiled.h"

namespace betwixt {

// Room for a constant of a type in the array of numbers; colours become light.
Binding bind_constant(Program::Compiled&, FunctionId, const Value&, Type);
Binding bind_track(Program::Compiled&, const Slot&);
// The slot with what was set as what its tracks come to at their first events, so that it holds until then.
Slot with_beginning(const Scene&, const Slot&);
Binding bind_live(Program::Compiled&, std::uint32_t object, FunctionId);
// Nodes, the environments and the parents that they have; all bindings are made.
void compile_nodes(Program::Compiled&, const Program::Compiled* before);
// What is drawn and when what changes; nodes, attachments and motions are known, but not yet what they keep.
void compile_schedule(Program::Compiled&, const Program::Compiled* before);

inline bool scripted(const Value& v) { return std::holds_alternative<Procedure>(v); }
bool scripted(const Track&);
bool has_values(const Track&);
template <class F>
void each_track(const Strand& s, F&& f) {
  if (s.components.empty()) f(*s.track);
  for (const auto& c : s.components) f(*c);
}
bool has_events(const Strand&);

}  // namespace betwixt
