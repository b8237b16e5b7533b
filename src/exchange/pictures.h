// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures, in this process, whatever they do to it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "betwixt/mesh.h"
#include "betwixt/result.h"
#include "exchange/shelf.h"

namespace betwixt {

// `name` for messages and, where the bytes do not say it, for its ending.
Result<std::shared_ptr<const Picture>> decode_picture(std::span<const std::uint8_t> bytes, const std::string& name);
// As read_picture().
Result<std::shared_ptr<const Picture>> parse_picture(const std::string& path, Shelf&);

}  // namespace betwixt
