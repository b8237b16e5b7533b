// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Contents of files that a program gives as bytes: pictures, meshes, scenes, drawings and sounds.
//
// Room: exchange
#pragma once

#include <string>
#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

// Keeps the bytes until the program ends. From then on every script of this process can write @NAME wherever it can
// name a file: texture="@logo.png". The ending of the name says what the bytes are. Returns the full name, @HASH-NAME,
// which means these bytes for ever; @NAME means the bytes that were sent last when a line is read. So bytes that are
// sent later do not change documents that exist. Any thread may call it.
// Errors: name (the name), range (more than 64 MiB, all together more than 256 MiB, more than 10,000 things), file (the
// bytes are damaged, or not what the ending says), machine.
Result<std::string> send_bytes(const std::string& name, std::string_view bytes);

}  // namespace betwixt
