// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a document says of its objects, for programs that show or translate it: a studio, an exporter, a binding.
//
// Nothing here evaluates anything: values at times are a Program's. What views point to belongs to the document, and
// stays as it is for as long as that or any copy of it lives. An object that is not there is nothing: a group without
// functions. Numbers are as the author sees them after units: metres, seconds, radians, colours sRGB.
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
// All that there are, in the order of their creation.
std::vector<ObjectId> objects(const Document&);
// Those that a word of the language names: an alias (in its order), a pattern or braces (in the order of names), a
// name.
std::vector<ObjectId> objects(const Document&, std::string_view word);
Kind kind(const Document&, ObjectId);
// Whether a display list says what it is: it comes and goes with the list, and no script creates it.
bool derived(const Document&, ObjectId);

// How numbers of a function are written: where nothing is behind them they are metres, or millimetres, or plain.
enum class Unit : std::uint8_t { none, metres, millimetres, moment, seconds, opening };

// A display function of an object: what can vary about it.
struct FunctionView {
  std::uint16_t id = 0;      // of this document: Target::function
  std::string_view name;     // "position"
  Type type = Type::scalar;  // of its values
  Unit unit = Unit::none;
  std::vector<std::string_view> components;  // x y z or r g b, where the type has any
  std::string_view words;                    // of texts that are one of a few: "point|sun"; else empty
  double low = -1e300, high = 1e300;         // numbers outside mean nothing
  const Value* rest = nullptr;               // the value where nobody says otherwise; never null
  const Value* set = nullptr;                // what it was set to; null: nothing
  bool animated = false;                     // it has events, a velocity, filters, code or layers
};
// All that the object has, the author's own behind the built-in ones; not those that can only be asked for (Query).
std::vector<FunctionView> functions(const Document&, ObjectId);

// What an object hangs on from `from` to just before `until`. The first span begins with the document, the last one
// never ends; where nothing was ever said there is none, and nothing holds it.
struct AttachmentSpan {
  Time from = from_the_beginning, until = for_good;
  Attachment to;
  bool computed = false;  // by code, from time to time; what `to` says is nothing then
};
std::vector<AttachmentSpan> attachments(const Document&, ObjectId);

// A layer: what it holds is laid over the tracks of others. (its tracks: betwixt/track.h)
struct LayerView {
  ObjectId id;
  std::string_view mode;  // "add": its values are added; "mix": they take the place of what is below
  Target weight;          // how much of it is seen, 0 to 1; may be animated as any function
};
std::vector<LayerView> layers(const Document&);  // in the order in which they are laid, each on those before

}  // namespace betwixt
