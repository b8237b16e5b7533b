// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The objects of a document, for programs that show or translate them: a studio, an exporter, a binding.
//
// These functions read the document and evaluate nothing. For values at a time use a Program. A view points into the
// document and is valid as long as the document or a copy of it exists. An object that does not exist is treated as a
// group without functions. Numbers are in metres, seconds and radians, colours are sRGB.
//
// Room: scene
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/shape.h"

namespace betwixt {

std::string_view name_of(Kind);  // "sphere"
// Returns all objects, in order of creation.
std::vector<ObjectId> objects(const Document&);
// Returns the objects that a word of the language names. The word is an alias (a name for several objects), a pattern,
// a name with braces, or a plain name. The objects of an alias come in its own order, those of a pattern or braces in
// order of names.
std::vector<ObjectId> objects(const Document&, std::string_view word);
Kind kind(const Document&, ObjectId);  // Kind::group if there is no such object
// Returns whether the object comes from a display list (stored drawing commands). Then it exists only because of the
// list; no `create` makes it.
bool derived(const Document&, ObjectId);

// How a script writes the numbers of a function. A moment is a time (24f), seconds are a length of time, and an opening
// is the time for which a shutter is open (180deg). A number without a unit is in metres, in millimetres or plain.
enum class Unit : std::uint8_t { none, metres, millimetres, moment, seconds, opening };

// A display function of an object: a property that can be animated.
struct FunctionView {
  std::uint16_t id = 0;      // in this document, for Target::function
  std::string_view name;     // "position"
  Type type = Type::scalar;  // the type of its values
  Unit unit = Unit::none;
  std::vector<std::string_view> components;  // x y z or r g b; empty if the type has none
  std::string_view words;                    // the valid words of a text, as "point|sun"; empty if any text is valid
  double low = -1e300, high = 1e300;         // the range of valid numbers
  const Value* rest = nullptr;               // the default value; never null
  const Value* set = nullptr;                // the value that the script sets; null if it sets none
  bool animated = false;                     // whether it has events, a velocity, filters, code or layers
};
// Returns all display functions of an object, the built-in ones before the author's own. Queries are not included.
std::vector<FunctionView> functions(const Document&, ObjectId);

// The parent of an object from `from` to just before `until`. The first span begins at the earliest time and the last
// one ends at the latest. An object without attachments has no spans.
struct AttachmentSpan {
  Time from = earliest_time, until = latest_time;
  Attachment to;
  bool computed = false;  // code computes the parent at each time, and `to` has no meaning
};
std::vector<AttachmentSpan> attachments(const Document&, ObjectId);

// A layer: its tracks are combined with those of the objects. (For the tracks see betwixt/track.h.)
struct LayerView {
  ObjectId id;
  std::string_view mode;  // "add": adds its values; "mix": blends over to them
  Target weight;          // the share of the layer that is applied, 0 to 1; can be animated
};
std::vector<LayerView> layers(const Document&);  // in the order in which they are applied

}  // namespace betwixt
