// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a parser's process has read lies flat in memory that two processes have. Who takes it over believes none of it.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "betwixt/mesh.h"
#include "betwixt/result.h"
#include "exchange/drawing.h"
#include "exchange/scene_file.h"

namespace betwixt {

using Parsed = std::variant<std::shared_ptr<const Mesh>, std::shared_ptr<const Picture>, Error,
                            std::shared_ptr<const SceneFile>, std::shared_ptr<const DrawingFile>>;

// Both return the system's reason (0: none). EBADMSG: what lies there is nothing of these.
int hand_over(const Parsed&, int memory);
int take_over(int memory, Parsed&);

}  // namespace betwixt
