// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The texts of the studio in other languages. Its English texts are the keys of catalogues in the .po format, which are
// part of the program. Everything that goes through tr() or word_of() is translated; what a catalogue lacks stays
// English.
#pragma once

#include <QHash>
#include <QTranslator>

namespace betwixt::studio {

class Words : public QTranslator {
 public:
  explicit Words(const QByteArray& catalogue, QObject* parent = nullptr);
  QString translate(const char* context, const char* text, const char* = nullptr, int = -1) const override;
  bool isEmpty() const override { return texts_.isEmpty(); }
  bool has(const QString& text) const { return texts_.contains(text); }

 private:
  QHash<QString, QString> texts_;
};

QByteArray catalogue_of(const QString& language);  // "de"; empty if there is none
// The language of the preferences, or of the system if they say so.
QString wanted_language();
// Lets all new texts be in this language.
void use_language(const QString&);

}  // namespace betwixt::studio
