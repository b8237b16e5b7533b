// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Live input: what a control says becomes the value of what its dials turn. (G57)
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "betwixt/document.h"
#include "betwixt/result.h"

namespace betwixt {

// The document after a control has said `numbers` or, where there is one, `text`. When the document is recording, that
// is an event at `now` on the track of every dial of this address; otherwise the value holds for all times, and what
// the target had of tracks and filters gives way. All dials turn or none.
// Errors: name (no dial has this address), type (not as many numbers as the target takes), range (not finite).
Result<Document> turn(const Document&, std::string_view address, std::span<const double> numbers,
                      const std::string* text, Time now);

}  // namespace betwixt
