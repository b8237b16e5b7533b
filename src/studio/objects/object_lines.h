// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Edits of whole objects as script lines: copies, instances, groups, alignment, and objects as text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studio/timeline/event_lines.h"

namespace betwixt::studio {

// Lines, and the names of the objects to select afterwards.
struct ObjectEdit {
  Lines lines;
  std::vector<std::string> names;
};

enum class Axis : std::uint8_t { x, y, z };

constexpr double millimetre = 0.001;  // a step of numbers that are written

// Returns the place of an object in the world.
Vec3 place_of(const Program&, ObjectId, Time);
// Returns the attachment that an object has during the whole film, if there is one.
std::optional<Attachment> fixed_attachment(const Document&, ObjectId);
// Returns the line that gives a child such a parent for the whole film.
std::string hold_line(const Attachment&, const std::string& child, const std::string& parent, bool keep_world);
// Returns the name, or a further one if it is taken: ball, ball2, ball3.
std::string free_name(const Document&, const std::string& wanted, const std::vector<std::string>& taken = {});
// Returns a name that nothing has: ball2 or ball3 for "ball" or "ball2", man/arm2 for "man/arm".
std::string unused_name(const Document&, std::string_view like, const std::vector<std::string>& taken = {});
// Returns the objects, and those that hang on them during the whole film; each once, in order of creation.
std::vector<ObjectId> with_all_below(const Document&, const std::vector<ObjectId>&);
// Returns the parent of an object at a time; none if it has none.
ObjectId parent_at(const Document&, ObjectId, Time);
// Returns the objects, and those that hang on them at this time; each once, in order of creation.
std::vector<ObjectId> all_below_at(const Document&, const std::vector<ObjectId>&, Time);
// Returns the chart, the axes, the table or the code of which an object is a piece; the node of a diagram for its text.
// Other objects are wholes themselves.
ObjectId whole_of(const Document&, ObjectId);
// Returns those of the objects that do not hang on another one of them.
std::vector<ObjectId> topmost(const Document&, const std::vector<ObjectId>&);

// Copies objects with all that hangs on them: `create ball2 like ball`. Events stay at their times. A copy keeps its
// parent, unless that is copied too.
ObjectEdit duplicate_lines(const Document&, const std::vector<ObjectId>&);
// Makes instances, which follow later changes of the object: `define kind ball-kind like ball`, `create ball2
// ball-kind`.
ObjectEdit instance_lines(const Document&, const std::vector<ObjectId>&);
// Copies objects into a group that mirrors them, and all their motion, at the middle of the film's world or of their
// parent.
ObjectEdit mirror_lines(const Document&, const std::vector<ObjectId>&, Axis);
// Makes a group that turns about the middle of the objects, and couples them to it for the whole film. They stay where
// they are.
ObjectEdit group_lines(const Program&, const std::vector<ObjectId>&, Time);
// Shows or hides objects; from this time on, if their display has events.
Lines display_lines(const Document&, const std::vector<ObjectId>&, bool shown, Time);
// Returns the lines that remove objects, with what hangs on them at this time if `all`.
Lines remove_lines(const Document&, const std::vector<ObjectId>&, bool all, Time);
// Moves all objects along an axis to the place of the last one; or spreads them evenly between the outermost two.
Lines align_lines(const Program&, const std::vector<ObjectId>&, Axis, Time, bool make_events);
Lines distribute_lines(const Program&, const std::vector<ObjectId>&, Axis, Time, bool make_events);

// Moves an object with all its position events by what leads from one place in the world to another. Returns no lines
// if that takes more than a shift in its parent's space.
Lines lines_to_shift(const Program&, ObjectId, const Mat4& from, const Mat4& to, Time);
// Puts the pivots of objects with a shape to their lowest points, or into their middle: `set ball.pivot (0 -0.5 0)`.
Lines pivot_lines(const Program&, const std::vector<ObjectId>&, Time, bool at_bottom);

// Makes objects fall from where they are and bounce on the floor at y = 0: `at 1f fall ball ground=1 bounce=0.6`.
Lines fall_lines(const Program&, const std::vector<ObjectId>&, Time);

// Returns the script of objects with all that hangs on them, for the clipboard; without the film's settings. `rest` is
// the film without the other objects.
Lines lines_to_leave(const Document&, const std::vector<ObjectId>&);
std::string text_of_objects(const Document& rest);
// Returns the lines that add the objects of such a text to a film, with new names where a name is taken. Errors: those
// of the text.
Result<ObjectEdit> paste_lines(const Document&, const std::string& film_text, const std::string& text);

}  // namespace betwixt::studio
