// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The steps of compiling: tracks and constants (compile.cpp), live values (compile_live_values.cpp), transforms
// (compile_nodes.cpp), drawables and the schedule of changes (compile_schedule.cpp).
#pragma once

#include "program/compiled.h"

namespace betwixt {

// Stores a constant of a type in the array of numbers; colours become linear light.
Binding bind_constant(CompiledFilm&, FunctionId, const Value&, Type);
Binding bind_track(CompiledFilm&, const Slot&);
// Returns the slot with its set value placed before the first event of each track, so that it holds until that event.
Slot with_beginning(const Scene&, const Slot&);
// `own`: the object's slot, with its constant code replaced; null if it has none.
Binding bind_live(Program::Compiled&, std::uint32_t object, FunctionId, const Slot* own);
// Compiles nodes, their environments and parents. All bindings must exist.
void compile_nodes(Program::Compiled&, const CompiledFilm* before);
// Compiles the drawables and when each value changes. Nodes, attachments and motions exist, but not the transforms that
// they keep.
void compile_schedule(Program::Compiled&, const CompiledFilm* before);
// Numbers the pictures and videos of the scene.
void number_textures(CompiledFilm&);
// Finds out whether a drawable may show a video, and when which picture of it.
bool show_video(CompiledFilm&, std::uint32_t node, Drawable&);
// Returns what of a finish an object has, or nullopt if it never needs one. `made_of` of the drawable is known.
std::optional<FinishUse> finish_use(const CompiledFilm&, std::uint32_t object, const Drawable&);
// The same of gradients.
std::optional<GradientUse> gradient_use(const CompiledFilm&, std::uint32_t object);
// Returns the skin of a drawable whose mesh has an animated rig, or nullopt.
std::optional<Skin> compile_skin(const CompiledFilm&, std::uint32_t drawable);
// Marks all nodes that inverse kinematics may turn at any time.
void find_joints(CompiledFilm&);
// Compiles the motions of all nodes. settle() later fills in their centres and the transforms that attachments keep.
void compile_motions(CompiledFilm&);
// `frozen`: indices of let-go and kept attachments, by time.
void settle(Program::Compiled&, const std::vector<std::int32_t>& frozen);

inline bool scripted(const Value& v) { return std::holds_alternative<Procedure>(v); }
bool scripted(const Track&);
bool has_tweens(const Scene&, const Track&);
bool all_numeric(const Track&);
// Returns whether it is the position of an object with obstacles.
inline bool collides(const Object& o, FunctionId f) { return f == fn::position && !o.removed && o.find(fn::obstacles); }
bool has_values(const Track&);
template <class F>
void each_track(const Strand& s, F&& f) {
  if (s.components.empty()) f(*s.track);
  for (const auto& c : s.components) f(*c);
}
bool has_events(const Strand&);

}  // namespace betwixt
