// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The marked parts of formulas, and the parts of code that have a class (code_languages.h). A part is known by what it
// contains; the second part with the same content has "#2" behind it. The object of a part is coupled to that of the
// formula. `f/a` names the parts of f that contain a.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/document.h"

namespace betwixt {

inline bool has_letters(Kind kind) { return kind == Kind::text || kind == Kind::code; }

FunctionId part_function();
// Returns the part that an object shows; nullptr if it is no part.
const std::string* shown_part(const Object&);
// Returns the formula of a part; none if it has none.
ObjectId formula_of_part(const Scene&, const Object&);
// Returns the parts that a name means by their content, in order.
std::vector<ObjectId> parts_by_content(const Scene&, std::string_view name);
// Returns the name of the formula of which an object of this name is a part, by its number; nullptr if of none.
const std::string* formula_above(const Scene&, const std::string& name);
// Returns the object of this name; if there is none, the first part that it means.
ObjectId find_named(const Scene&, std::string_view name);
// Returns the marked parts of a formula, in order.
std::vector<std::string> parts_of_formula(const Outline&);

}  // namespace betwixt
