// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Kinds that own children: `create` makes their pieces too, by lines of the language.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/command.h"
#include "exchange/said_text.h"
#include "scene/quantity.h"

namespace betwixt {

// What `create` reads besides display functions, for the kinds that take it: of=(3 1 4) keys=("Ann" "Bob").
struct Furniture {
  std::vector<LetList> rows;  // of `of`: one row, or several for tables
  bool nested = false;        // whether the rows stand in brackets of their own
  LetList keys;
  std::optional<SayText> say;                                     // of a sound
  std::string_view of_at, formula_at, say_at, voice_at, text_at;  // their places in the line
};
// Reads `of` or `keys` after its =, if the kind takes it. Returns false with an error, or without one if it does not.
bool furniture(Command&, Kind, std::string_view key, Furniture&);

// Reads say, voice or pace of a sound after the =. Returns as furniture() does.
bool said_parameter(Command&, std::string_view key, Furniture&);
// Makes the voice of such a name (exchange/said_text.h), with its words.
bool load_said_text(Command&, const std::string& name, std::string_view voice_at, std::string_view about);
// Gives a sound the text that it says.
bool give_said_text(Command&, Object&, const Furniture&, std::string_view about);

// Returns the function that a word of `create` means: the points of a scatter are its `of`.
std::string_view meant_at_create(Kind, std::string_view key);

// Makes the pieces of an object that exists. Changes the scene even if it fails.
bool furnish(Command&, ObjectId, const Furniture&, std::string_view about);
// Carries out lines of the language, as a command of the author's own does. Changes the scene even if it fails.
bool carry_out_lines(Command&, const std::string& lines, std::string_view about);
// The same, but if a line fails, none of them counts.
bool all_or_none(Command&, const std::string& lines, std::string_view about);
// Reads [for L] and the end of the line. `length` has the default.
bool lasting(Command&, Time& length, std::string_view about);
// Writes a length in metres to a tenth of a millimetre.
std::string write_metres(double);
// Couples an object to its axes, if it has no parent and is on some.
bool put_on_axes(Command&, Object&, ObjectId& parent, std::string_view about);

}  // namespace betwixt
