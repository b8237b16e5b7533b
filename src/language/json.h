// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values as JSON.
#pragma once

#include <string>

#include "base/json.h"
#include "betwixt/program.h"
#include "scene/document.h"

namespace betwixt {

std::string json(const Value&, const Target&, const Document&);

}  // namespace betwixt
