// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/words.h"

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QPointer>
#include <QRegularExpression>

#include "studio/shell/preferences.h"

// Q_INIT_RESOURCE must be outside of namespaces.
static void init_catalogues() { Q_INIT_RESOURCE(words); }

namespace betwixt::studio {
namespace {

QString unquoted(const QString& line) {
  QString out;
  for (qsizetype i = line.indexOf('"') + 1; i > 0 && i < line.size() && line[i] != '"'; ++i) {
    if (line[i] != '\\' || i + 1 == line.size())
      out += line[i];
    else
      out += line[++i] == 'n' ? QChar('\n') : line[i];
  }
  return out;
}

// The places for values in a text: "%1", "%2".
QStringList places_of(const QString& text) {
  static const QRegularExpression place("%[0-9]");
  QStringList all;
  for (auto i = place.globalMatch(text); i.hasNext();) all << i.next().captured();
  all.sort();
  return all;
}

}  // namespace

// Leaves out what is no catalogue, and texts that lack the places of the English ones.
Words::Words(const QByteArray& catalogue, QObject* parent) : QTranslator(parent) {
  QString text, other;
  const auto keep = [&] {
    if (!text.isEmpty() && !other.isEmpty() && places_of(text) == places_of(other)) texts_.insert(text, other);
  };
  bool to_other = false;
  for (const QString& line : QString::fromUtf8(catalogue).split('\n')) {
    if (line.startsWith("msgid \""))
      keep(), text = unquoted(line), other.clear(), to_other = false;
    else if (line.startsWith("msgstr \""))
      other = unquoted(line), to_other = true;
    else if (line.startsWith('"'))
      (to_other ? other : text) += unquoted(line);
  }
  keep();
}

QString Words::translate(const char*, const char* text, const char*, int) const {
  return texts_.value(QString::fromUtf8(text));
}

QByteArray catalogue_of(const QString& language) {
  init_catalogues();
  QFile file(":/words/" + language + ".po");
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QString wanted_language() {
  const QString language = Preferences::of_user().word("language");
  if (language != "system") return language;
  for (const QString& name : QLocale::system().uiLanguages()) {
    const QString code = name.section('-', 0, 0);
    if (code == "en" || !catalogue_of(code).isEmpty()) return code;
  }
  return "en";
}

void use_language(const QString& language) {
  static QPointer<Words> now;
  if (now) QCoreApplication::removeTranslator(now), delete now;
  now = new Words(catalogue_of(language), qApp);
  if (!now->isEmpty()) QCoreApplication::installTranslator(now);
}

}  // namespace betwixt::studio
