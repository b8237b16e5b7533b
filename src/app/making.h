// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How subcommands make films.
#pragma once

#include "betwixt/film.h"

namespace betwixt {

// Makes the film and shows the progress: on a terminal, or `in_lines` of JSON to any output.
Result<FilmStats> make_showing(const FilmOptions&, const std::function<Result<Painter>()>& new_painter,
                               bool in_lines = false);
Result<FilmStats> make_linear_showing(const FilmOptions&, const std::function<Result<LinearPainter>()>& new_painter,
                                      bool in_lines = false);
// Warns that the film's format has no transparency.
void say_not_clear(const std::string& path);
// Prints the result or the error. Returns the exit code.
int say_made(const Result<FilmStats>&, const FilmOptions&);

}  // namespace betwixt
