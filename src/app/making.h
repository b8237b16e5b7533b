// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How subcommands make films.
#pragma once

#include "betwixt/film.h"

namespace betwixt {

// Makes the film, and shows how far it is: on a terminal, or `in_lines`, wherever they go.
Result<FilmStats> make_showing(const FilmOptions&, const std::function<Result<Painter>()>& new_painter,
                               bool in_lines = false);
Result<FilmStats> make_deep_showing(const FilmOptions&, const std::function<Result<DeepPainter>()>& new_painter,
                                    bool in_lines = false);
// That the film cannot have what is clear.
void say_not_clear(const std::string& path);
// Says what was made, or why not. The exit code.
int say_made(const Result<FilmStats>&, const FilmOptions&);

}  // namespace betwixt
