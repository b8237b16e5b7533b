// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Files of text that others read as JSON, in the order in which it is said.
#pragma once

#include <nlohmann/json.hpp>

namespace betwixt {

using Json = nlohmann::ordered_json;

}  // namespace betwixt
