// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Our words as the toolkit's.
#pragma once

#include <QString>
#include <QTextDocument>
#include <string_view>

namespace betwixt::studio {

inline QString text_of(std::string_view s) { return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size())); }

// Tooltips take for markup what looks like it. This is what shows the words of a film as they are.
inline QString tip_of(const QString& words) {
  return Qt::mightBeRichText(words) ? Qt::convertFromPlainText(words) : words;
}

}  // namespace betwixt::studio
