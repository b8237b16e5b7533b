// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How subcommands make films.
#pragma once

#include <functional>

#include "betwixt/film.h"

namespace betwixt {

// Returns a function that shows the progress of a film, on a terminal or `in_lines` of JSON to any output, and stops
// the film at the user's request. Destroy it before you print anything.
Progress shown_progress(const FilmOptions&, bool in_lines = false);
// Carries out the work on a picture. Shows on a terminal how much of it is done and the time left, once it has lasted a
// second.
Status shown_picture(const std::function<Status()>& work);
// Warns that the film's format has no transparency.
void say_not_clear(const std::string& path);
// Prints the result or the error. Returns the exit code.
int say_made(const Result<FilmStats>&, const FilmOptions&);

}  // namespace betwixt
