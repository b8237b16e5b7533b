// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// JSON whose objects keep the order of their members.
#pragma once

#include <nlohmann/json.hpp>

namespace betwixt {

using Json = nlohmann::ordered_json;

}  // namespace betwixt
