// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/memory_budget.h"

namespace betwixt {

Error too_many_bytes(std::size_t most) {
  return fail(
      ErrorCode::range,
      fmt::format("texts, points, lists of names, code and the contents of files would have more than {} bytes", most),
      "to allow more: betwixt serve --values N");
}

}  // namespace betwixt
