// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A film as a talk: the places where the speaker waits.
#pragma once

#include <string>
#include <vector>

#include "betwixt/film.h"
#include "betwixt/program.h"

namespace betwixt {

// The stops of a talk: the steps between the first and the last frame, and these two.
std::vector<Pause> stops_of(const Document&, const FrameList&);
// Writes the pictures of the film's steps as the pages of a PDF. Errors: range (the film has no steps), file, machine.
Result<int> write_steps_as_pdf(const Program&, const FrameList&, const RenderOptions&, int quality,
                               const std::string& path, bool overwrite);

}  // namespace betwixt
