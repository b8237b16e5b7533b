// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Every panel and dialog in several window sizes, text sizes, colours and languages: no text is cut off, and no control
// is outside of its panel. tools/studio-looks.sh also saves a picture of each.
#include <QTest>
#include <QtWidgets>

#include "studio/course/film_chooser.h"
#include "studio/film.h"
#include "studio/shell/export_dialog.h"
#include "studio/shell/key_sheet.h"
#include "studio/shell/palette.h"
#include "studio/shell/preferences.h"
#include "studio/shell/preferences_window.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/shell/words.h"
#include "studio/viewport/viewport.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

// Returns the width that the text of a widget needs, and the width that it has; nothing if it has no text, or one that
// ends with an ellipsis by design.
std::optional<std::pair<int, int>> widths(const QWidget& w) {
  const auto text_width = [&](const QString& text) { return w.fontMetrics().size(Qt::TextShowMnemonic, text).width(); };
  if (const auto* label = qobject_cast<const QLabel*>(&w)) {
    const bool may_shorten = label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored;
    if (label->wordWrap() || label->text().isEmpty() || label->textFormat() == Qt::RichText || may_shorten) return {};
    return std::pair(text_width(label->text()), label->contentsRect().width());
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(&w)) {
    if (button->text().isEmpty()) return {};
    const auto* tool = qobject_cast<const QToolButton*>(&w);
    if (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()) return {};
    return std::pair(tool ? text_width(button->text()) : button->minimumSizeHint().width(), button->width());
  }
  if (const auto* box = qobject_cast<const QComboBox*>(&w)) {
    QStyleOptionComboBox option;
    option.initFrom(box), option.editable = box->isEditable();
    const QRect inside = box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
    return std::pair(text_width(box->currentText()), inside.width());
  }
  if (const auto* line = qobject_cast<const QLineEdit*>(&w); line && line->alignment() & Qt::AlignRight)  // numbers
    return std::pair(text_width(line->text()), line->contentsRect().width() - 2);
  return {};
}

// Returns the height that the text of a widget needs, and the height that it has.
std::optional<std::pair<int, int>> heights(const QWidget& w) {
  const int line = w.fontMetrics().height();
  if (const auto* label = qobject_cast<const QLabel*>(&w)) {
    if (label->text().isEmpty()) return {};
    const bool wraps = label->wordWrap() || label->textFormat() == Qt::RichText;
    return std::pair(wraps ? label->heightForWidth(label->width()) : line, label->height());
  }
  if (qobject_cast<const QAbstractButton*>(&w) || qobject_cast<const QComboBox*>(&w) ||
      qobject_cast<const QLineEdit*>(&w))
    return std::pair(line, w.height());
  return {};
}

bool scrolls(const QWidget& w, Qt::Orientation way) {
  const auto* area = qobject_cast<const QAbstractScrollArea*>(w.parentWidget() ? w.parentWidget()->parentWidget() : &w);
  return area && (way == Qt::Horizontal ? area->horizontalScrollBarPolicy() : area->verticalScrollBarPolicy()) !=
                     Qt::ScrollBarAlwaysOff;
}

// Panels behind another tab count as visible, and lie outside of the window.
bool is_behind(const QWidget& w) {
  for (const QWidget* up = &w; up; up = up->parentWidget())
    if (qobject_cast<const QDockWidget*>(up) && up->visibleRegion().isEmpty()) return true;
  return false;
}

// Returns what cannot be read in a window: texts that are cut off in width or height, controls that stick out.
QStringList unreadable(const QWidget& window) {
  QStringList all;
  for (const QWidget* w : window.findChildren<QWidget*>()) {
    if (!w->isVisible() || w->window() != &window || w->width() == 0 || is_behind(*w)) continue;
    const QString name = w->objectName() + " (" + w->metaObject()->className() + ")";
    const auto* label = qobject_cast<const QLabel*>(w);
    const auto* button = qobject_cast<const QAbstractButton*>(w);
    const auto* line = qobject_cast<const QLineEdit*>(w);
    const QString text = label ? label->text() : button ? button->text() : line ? line->text() : QString();
    if (const auto is = widths(*w); is && is->first > is->second)
      all << QString("%1 \"%2\" needs %3, has %4").arg(name, text).arg(is->first).arg(is->second);
    const bool only_icon = name.startsWith("qt_");
    if (const auto is = heights(*w); is && !only_icon && is->first > is->second)
      all << QString("%1 \"%2\" needs a height of %3, has %4").arg(name, text).arg(is->first).arg(is->second);
    if (!label && !button && !line && !qobject_cast<const QComboBox*>(w)) continue;
    for (const auto way : {Qt::Horizontal, Qt::Vertical})
      for (const QWidget* up = w; up && !scrolls(*up, way); up = up->parentWidget()) {
        const QRect box(w->mapTo(up, QPoint()), w->size());
        if (way == Qt::Horizontal ? box.left() < 0 || box.right() >= up->width()
                                  : box.top() < 0 || box.bottom() >= up->height()) {
          all << QString("%1 \"%2\" sticks out of %3 %4")
                     .arg(name, text, up->objectName(), up->metaObject()->className());
          break;
        }
        if (up->isWindow()) break;
      }
  }
  all.removeDuplicates();
  return all;
}

QByteArray file_text(const QString& name) {
  QFile file(SOURCE_DIR "/examples/" + name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class LooksTest : public QObject {
  Q_OBJECT

  static bool saves() { return qEnvironmentVariableIsSet("BETWIXT_LOOKS"); }

  // Notes what cannot be read, and saves the picture.
  void look_at(QWidget& w, const QString& name) {
    for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
    for (const QString& what : unreadable(w)) wrong_ << name + ": " + what;
    if (saves()) w.grab().save(qEnvironmentVariable("BETWIXT_LOOKS") + "/" + name + ".png");
  }

  void look_at_panels(Film& film, Window& window, const QString& name) {
    window.set_layout("all");
    QCoreApplication::processEvents();
    for (const auto& [face, panels] :
         std::initializer_list<std::pair<QString, QStringList>>{{"1", {"outliner", "sheet", "properties", "console"}},
                                                                {"2", {"poses", "curves", "script_panel", "history"}},
                                                                {"3", {"assets", "sheet", "properties", "course"}}}) {
      for (const QString& panel : panels) window.show_panel(panel);
      if (face == "3") {
        window.panel("sheet")->findChild<QToolButton*>("columns")->setChecked(true);
        film.workspace.select({});
      }
      if (saves()) window.viewport().await_picture();
      look_at(window, name + "-" + face);
    }
    window.panel("sheet")->findChild<QToolButton*>("columns")->setChecked(false);
    film.workspace.select({film.id("ball"), film.id("hand")});
    window.set_layout("live");
    if (saves()) window.viewport().await_picture();
    look_at(window, name + "-4");
    window.show_panel("server");
    look_at(window, name + "-5");
  }

  void look_at_dialogs(Window& window, const QString& name) {
    for (const char* page : {"General", "Appearance", "Keyboard", "Playback"}) {
      PreferencesWindow preferences;
      preferences.turn_to(page), preferences.show();
      look_at(preferences, name + "-preferences-" + page);
    }
    KeySheet keys(window);
    keys.setAttribute(Qt::WA_DeleteOnClose, false), keys.show();
    look_at(keys, name + "-keys");
    ExportDialog render(window.workspace());
    render.show();
    look_at(render, name + "-export");
    FilmChooser chooser({"/films/one.bx", "/films/two.bx", "/films/three.bx"}, &window);
    chooser.show();
    if (saves()) chooser.await_pictures();
    look_at(chooser, name + "-new");
    Palette palette(window);
    palette.show();
    look_at(palette, name + "-palette");
  }

  QStringList wrong_;

 private Q_SLOTS:
  void cleanup() { use_language("en"), Preferences::of_user().reset_all(); }

  void every_text_can_be_read_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<bool>("light");
    QTest::addColumn<int>("percent");
    for (const QString& language : {QString("en"), QString("de")})
      for (const bool light : {false, true})
        for (const int percent : {100, 250})
          if (saves() || light == (language == "de"))
            QTest::newRow(qPrintable(QString("%1-%2-%3").arg(language, light ? "light" : "dark").arg(percent)))
                << language << light << percent;
  }
  void every_text_can_be_read() {
    QFETCH(QString, language);
    QFETCH(bool, light);
    QFETCH(int, percent);
    Preferences& user = Preferences::of_user();
    use_language(language);
    user.set("light", light), user.set("interface-size", percent);
    Film film(file_text("grab.bx"));
    const QString first = film.text();
    wrong_.clear();
    {
      Window window(film.workspace);
      window.show();
      film.workspace.go_to(film.workspace.document().rate().frame(40));
      film.workspace.select({film.id("ball"), film.id("hand")});
      for (const QSize size : {QSize(1000, 640), QSize(1440, 900), QSize(2560, 1440)}) {
        window.resize(size);
        QCoreApplication::processEvents();
        // Text of 250 % needs a height of its own.
        const int height = std::max(size.height(), percent > 100 ? 850 : 0);
        if (window.width() > size.width() || window.height() > height)
          wrong_ << QString("the window is %1x%2").arg(window.width()).arg(window.height());
        const QString name = QString("%1-%2").arg(QTest::currentDataTag()).arg(size.width());
        look_at_panels(film, window, name);
      }
      look_at_dialogs(window, QTest::currentDataTag());
    }
    for (const QString& what : wrong_) fprintf(stderr, "%s\n", qPrintable(what));
    QVERIFY(wrong_.isEmpty());
    QCOMPARE(film.text(), first);
  }
};

QTEST_MAIN(LooksTest)
#include "looks_test.moc"
