// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts our strings to Qt's.
#pragma once

#include <QString>
#include <string_view>

namespace betwixt::studio {

inline QString text_of(std::string_view s) { return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size())); }

}  // namespace betwixt::studio
