// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts our strings to Qt's.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QTextDocument>
#include <string>
#include <string_view>

namespace betwixt::studio {

inline QString text_of(std::string_view s) { return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size())); }

// Returns a text of a table in the language of the user.
inline QString word_of(std::string_view s) { return QCoreApplication::translate("studio", std::string(s).c_str()); }

// Returns the beginning of a text that may be megabytes long, such as a line that rewrites a script. Widgets need
// seconds for such a text.
inline QString beginning_of(const QString& text, qsizetype most = 2000) {
  return text.size() <= most ? text : text.left(most) + " …";
}

// Returns a tooltip that shows a text unchanged. Qt would read a text that looks like markup as markup.
inline QString tip_of(const QString& words) {
  return Qt::mightBeRichText(words) ? Qt::convertFromPlainText(words) : words;
}

}  // namespace betwixt::studio
