// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The serialized result of a parser process, in memory shared with this process. The receiver validates all of it.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "betwixt/linear_picture.h"
#include "betwixt/mesh.h"
#include "betwixt/result.h"
#include "betwixt/setting.h"
#include "exchange/drawing.h"
#include "exchange/font_face.h"
#include "exchange/scene_file.h"
#include "exchange/table_text.h"

namespace betwixt {

using Parsed = std::variant<std::shared_ptr<const Mesh>, std::shared_ptr<const Picture>, Error,
                            std::shared_ptr<const SceneFile>, std::shared_ptr<const DrawingFile>,
                            std::shared_ptr<const LinearPicture>, std::shared_ptr<const ShapedLine>,
                            std::shared_ptr<const TableText>, std::shared_ptr<const ColorTable>>;

// Both return 0 or the system's error number. EBADMSG: the memory holds no valid result.
int write_parsed(const Parsed&, int memory);
int read_parsed(int memory, Parsed&);

}  // namespace betwixt
