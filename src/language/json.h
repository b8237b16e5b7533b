// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values as JSON.
#pragma once

#include <string>
#include <string_view>

#include "betwixt/program.h"
#include "scene/document.h"

namespace betwixt {

// In double quotes. What is not UTF-8 becomes the replacement character, so that the answer can always be read.
std::string json_text(std::string_view);
std::string json_number(double);  // JSON knows no numbers beyond all numbers: those are null
std::string json(const Value&, const Target&, const Document&);

}  // namespace betwixt
