// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the texts in other languages: all of them go through the translation, all are there in German, and a catalogue
// that is wrong or missing leaves them English.
#include "studio/shell/words.h"

#include <QTest>
#include <QtWidgets>

#include "studio/film.h"
#include "studio/shell/actions.h"
#include "studio/shell/export_dialog.h"
#include "studio/shell/key_sheet.h"
#include "studio/shell/keys.h"
#include "studio/shell/palette.h"
#include "studio/shell/preferences.h"
#include "studio/shell/preferences_window.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

const QByteArray film_text =
    "rate 24\nrange 1f 48f\ncreate eye camera position=(0 0 14)\ncreate ball sphere radius=0.5\n"
    "ball.position\n  1f (0 0 0)\n  12f (2 3 0)\n";

// The texts between quotes after tr( and its like, in all sources of the studio.
QStringList texts_of_sources() {
  static const QRegularExpression said(R"~((?:\btr|QT_TR_NOOP)\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+))~"),
      noted(R"~(QT_TRANSLATE_NOOP\("\w+",\s*((?:"(?:[^"\\]|\\.)*"\s*)+))~"), part(R"~("((?:[^"\\]|\\.)*)")~");
  QStringList all;
  for (QDirIterator files(SOURCE_DIR "/src/studio", {"*.cpp", "*.h"}, QDir::Files, QDirIterator::Subdirectories);
       files.hasNext();) {
    QFile file(files.next());
    if (!file.open(QIODevice::ReadOnly)) continue;
    const QString text = QString::fromUtf8(file.readAll());
    for (const QRegularExpression* r : {&said, &noted})
      for (auto i = r->globalMatch(text); i.hasNext();) {
        QString words;
        for (auto k = part.globalMatch(i.next().captured(1)); k.hasNext();) words += k.next().captured(1);
        all << words.replace("\\n", "\n").replace("\\\"", "\"");
      }
  }
  return all;
}

QStringList texts_of_tables() {
  QStringList all;
  for (const ActionRow& row : action_rows()) all << text_of(row.menu) << text_of(row.name) << text_of(row.sentence);
  for (const KeyRow& row : Keys::of_user().rows()) all << text_of(row.name) << text_of(row.sentence);
  for (const KeyPlace& place : key_places()) all << text_of(place.title);
  for (const Preference& row : preference_rows())
    all << text_of(row.page) << text_of(row.label) << text_of(row.sentence);
  all << Window::layouts();
  return all;
}

bool has_letters(const QString& text) {
  static const QRegularExpression letters("[A-Za-z]{2}");
  return text.contains(letters);
}

// Marks every text that goes through the translation.
class Marking : public QTranslator {
 public:
  QString translate(const char*, const char* text, const char*, int) const override {
    return "«" + QString::fromUtf8(text) + "»";
  }
  bool isEmpty() const override { return false; }
};

// The texts that a widget and its actions show.
QStringList shown_by(const QWidget& w) {
  QStringList all{w.toolTip(), w.isWindow() || qobject_cast<const QDockWidget*>(&w) ? w.windowTitle() : QString(),
                  w.accessibleName()};
  if (const auto* label = qobject_cast<const QLabel*>(&w)) all << label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&w)) all << button->text();
  if (const auto* edit = qobject_cast<const QLineEdit*>(&w)) all << edit->placeholderText();
  if (const auto* menu = qobject_cast<const QMenu*>(&w)) all << menu->title();
  for (const QAction* a : w.actions()) all << a->text().section('\t', 0, 0);
  return all;
}

}  // namespace

class WordsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { set_theme(*qApp, Theme::dark); }
  void cleanup() { use_language("en"); }

  void everyTextIsThereInGerman() {
    const Words german(catalogue_of("de"));
    QStringList missing;
    for (const QString& text : texts_of_sources() + texts_of_tables())
      if (has_letters(text) && !german.has(text) && !missing.contains(text)) missing << text;
    missing.removeAll("Betwixt"), missing.removeAll("After Effects"), missing.removeAll("Blender");
    for (const QString& name : {QString("English"), QString("Deutsch"), QString("Français")}) missing.removeAll(name);
    for (const QString& text : missing) fprintf(stderr, "no German: %s\n", qPrintable(text));
    QVERIFY2(missing.isEmpty(), "src/studio/words/de.po lacks these texts");
  }

  void everyVisibleTextGoesThroughTheTranslation() {
    Film film(film_text);
    const QString first = film.text();
    Marking marking;
    QCoreApplication::installTranslator(&marking);
    QStringList english;
    {
      Window window(film.workspace);
      window.show();
      film.select("ball");
      ExportDialog render(film.workspace);
      PreferencesWindow preferences;
      KeySheet keys(window);
      keys.setAttribute(Qt::WA_DeleteOnClose, false);
      Palette palette(window);
      for (QWidget* w : std::initializer_list<QWidget*>{&render, &preferences, &keys, &palette}) w->show();
      QCoreApplication::processEvents();
      for (const QWidget* w : QApplication::allWidgets()) {
        // Words of the language, names of the film, and files are the same in all languages.
        bool is_data = false;
        for (const QWidget* up = w; up; up = up->parentWidget())
          is_data =
              is_data || QStringList{"section_Place", "section_Look", "section_Film", "properties", "film_settings",
                                     "command",       "style",        "words",        "palette",    "script_panel"}
                             .contains(up->objectName());
        is_data = is_data || (w->objectName() == "kinds" && qobject_cast<const QMenu*>(w));
        if (is_data || w->objectName().startsWith("qt_")) continue;
        for (const QString& text : shown_by(*w))
          if (has_letters(text) && !text.contains("«"))
            english << w->objectName() + " (" + w->metaObject()->className() + "): " + text;
      }
    }
    QCoreApplication::removeTranslator(&marking);
    english.removeDuplicates();
    const QStringList names{"film.bx", "Betwixt", "English", "Deutsch", "Français", "Blender", "After Effects", "MIDI"};
    QStringList wrong;
    for (const QString& text : english)
      if (std::ranges::none_of(names, [&](const QString& n) { return text.contains(n); })) wrong << text;
    for (const QString& text : wrong) fprintf(stderr, "not translated: %s\n", qPrintable(text));
    QVERIFY(wrong.isEmpty());
    QCOMPARE(film.text(), first);
  }

  void theWindowSpeaksGermanAndEnglish() {
    Film film(film_text);
    use_language("de");
    {
      Window window(film.workspace);
      QCOMPARE(window.menuBar()->actions()[0]->text(), "Datei");
      QCOMPARE(window.panel("history")->windowTitle(), "Verlauf");
      QVERIFY(key_sheet_html().contains("Auswahl bewegen"));
    }
    use_language("fr");
    QCOMPARE(Window(film.workspace).menuBar()->actions()[0]->text(), "Fichier");
    use_language("en");
    QCOMPARE(Window(film.workspace).menuBar()->actions()[0]->text(), "File");
  }

  void sourcesOfValuesAreGerman() {
    Film film(film_text + "set ball.color red\nfilter ball.position smooth width=3f\n");
    use_language("de");
    Window window(film.workspace);
    window.show();
    window.show_panel("properties");
    film.select("ball");
    film.workspace.go_to(film.at_time("6f"));
    QCoreApplication::processEvents();
    const auto made = [&](const char* of) { return window.findChild<QLabel*>(QString("made_") + of)->text(); };
    QCOMPARE(made("color"), "gesetzt");
    QCOMPARE(made("position"), "zwischen 1f und 12f, Filter smooth");
  }

  void aWrongOrMissingCatalogueLeavesEnglish() {
    QVERIFY(catalogue_of("tlh").isEmpty());
    use_language("tlh");
    QCOMPARE(word_of("File"), "File");
    const Words words(
        "nonsense\nmsgid \"File\"\nmsgstr \"Datei\nmsgid \"%1 of %2\"\nmsgstr \"%1 von\"\nmsgid \"Open\"\nmsgstr \"\"\n"
        "msgid \"two \"\n\"parts\"\nmsgstr \"zwei \"\n\"Teile\"\n");
    QCOMPARE(words.translate("", "%1 of %2"), QString());  // a place is missing
    QCOMPARE(words.translate("", "Open"), QString());
    QCOMPARE(words.translate("", "two parts"), "zwei Teile");
    QVERIFY(Words("\xff\xfe\x00 what is this").isEmpty());
  }

  void theLanguageIsThatOfThePreferences() {
    Preferences::of_user().set("language", "de");
    QCOMPARE(wanted_language(), "de");
    Preferences::of_user().set("language", "no such language");
    QCOMPARE(wanted_language(), "de");
    Preferences::of_user().set("language", "en");
    QCOMPARE(wanted_language(), "en");
    Preferences::of_user().reset_all();
  }
};

QTEST_MAIN(WordsTest)
#include "words_test.moc"
