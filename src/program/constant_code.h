// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Code that always returns the same value, because it reads neither the time nor the film: "vec(i, 2 * i)". The
// compiler replaces it by its value, so it is as fast as a number in the script.
#pragma once

#include <optional>

#include "program/compiled_film.h"

namespace betwixt {

// Returns the slot with its constant code replaced by values; nullopt if it has none. Code that fails stays, so that
// its error appears in the frames. Rows of code without a twerper of their own stay too: they hold like no number does.
std::optional<Slot> with_constants(CompiledFilm&, std::uint32_t object, const Slot&);

}  // namespace betwixt
