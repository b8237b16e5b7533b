// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Chapters, in the form in which ffmpeg reads them.
#pragma once

#include <string>
#include <vector>

#include "betwixt/film.h"

namespace betwixt {

std::string chapters_metadata(const std::vector<Chapter>&);

}  // namespace betwixt
