// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the preferences: they take effect at once, the file holds the differences only, and safe colours differ for
// colour-blind eyes.
#include "studio/shell/preferences.h"

#include <QTest>
#include <QtWidgets>
#include <cmath>

#include "studio/film.h"
#include "studio/shell/keys.h"
#include "studio/shell/preferences_window.h"
#include "studio/shell/sound.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

QSettings settings() { return QSettings("betwixt", "studio"); }
Preferences& user() { return Preferences::of_user(); }

// The matrices of Machado, Oliveira and Fernandes for eyes without one kind of cone, on linear colours.
using Eyes = std::array<std::array<double, 3>, 3>;
const Eyes all_eyes[] = {
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}};

std::array<double, 3> lab(const QColor& c, const Eyes& eyes) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  const double in[] = {linear(c.redF()), linear(c.greenF()), linear(c.blueF())};
  double out[3];
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = std::clamp(eyes[i][0] * in[0] + eyes[i][1] * in[1] + eyes[i][2] * in[2], 0.0, 1.0);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f((0.4124 * out[0] + 0.3576 * out[1] + 0.1805 * out[2]) / 0.95047),
               y = f(0.2126 * out[0] + 0.7152 * out[1] + 0.0722 * out[2]),
               z = f((0.0193 * out[0] + 0.1192 * out[1] + 0.9505 * out[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// How far the nearest two of the colours are apart, for the eyes that see them nearest.
double least_apart(const Colors& c) {
  const QColor all[] = {c.x, c.y, c.z, c.event, c.cut};
  double least = 1e9;
  for (const Eyes& eyes : all_eyes)
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const auto a = lab(all[i], eyes), b = lab(all[k], eyes);
        least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
      }
  return least;
}

}  // namespace

class PreferencesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { set_theme(*qApp, Theme::dark); }
  void init() {
    settings().clear();
    user().recall();
    Keys::of_user().recall();
  }
  void cleanup() { user().reset_all(); }

  void safeColoursDifferForAllEyes() {
    for (const Theme theme : {Theme::dark, Theme::light}) {
      set_theme(*qApp, theme, true);
      QVERIFY2(least_apart(colors()) > 30, qPrintable(QString::number(least_apart(colors()))));
      QVERIFY(least_apart(picture_colors()) > 30);
      set_theme(*qApp, theme, false);
      QVERIFY2(least_apart(colors()) < 10, "the usual colours would do, so there is no need of others");
    }
    set_theme(*qApp, Theme::dark);
  }

  // The bounds of WCAG 2.1, level AA: 4.5 for text, 3 for lines and signs.
  void textsAndSignsCanBeSeen() {
    QVERIFY(std::abs(contrast(Qt::black, Qt::white) - 21) < 1e-9);
    QVERIFY(std::abs(contrast(QColor(0x77, 0x77, 0x77), Qt::white) - 4.48) < 0.005);  // an example of the standard
    double least_text = 21, least_sign = 21;
    for (const Theme theme : {Theme::dark, Theme::light})
      for (const bool safe : {false, true}) {
        set_theme(*qApp, theme, safe);
        const Colors& c = colors();
        const auto is_least = [&](double& least, const char* name, const QColor& a, const QColor& b, double bound) {
          least = std::min(least, contrast(a, b));
          QVERIFY2(contrast(a, b) >= bound, qPrintable(QString("%1, light %2, safe %3: %4")
                                                           .arg(name)
                                                           .arg(theme == Theme::light)
                                                           .arg(safe)
                                                           .arg(contrast(a, b))));
        };
        // The line with the cursor is on `raised`, and so are panels.
        for (const QColor& ground : {c.back, c.raised}) {
          for (const auto& [name, color] : {std::pair("text", c.text),
                                            {"dim", c.dim},
                                            {"error", c.error},
                                            {"warning", c.warning},
                                            {"accent", c.accent},
                                            {"note", c.note},
                                            {"z", c.z},
                                            {"cut", c.cut},
                                            {"playhead", c.playhead},
                                            {"event", c.event}})
            is_least(least_text, name, color, ground, 4.5);
          for (const auto& [name, color] : {std::pair("x", c.x), {"y", c.y}, {"selected", c.selected}})
            is_least(least_sign, name, color, ground, 3);
        }
        QColor lit = c.accent;  // behind the names of the selection in the script
        lit = QColor::fromRgbF((lit.redF() * 60 + c.back.redF() * 195) / 255,
                               (lit.greenF() * 60 + c.back.greenF() * 195) / 255,
                               (lit.blueF() * 60 + c.back.blueF() * 195) / 255);
        is_least(least_text, "a selected name", c.text, lit, 4.5);
        is_least(least_text, "auto-key", text_on(c.error), c.error, 4.5);
        const QPalette p = qApp->palette();
        for (const auto& [text, ground] : {std::pair(QPalette::HighlightedText, QPalette::Highlight),
                                           {QPalette::WindowText, QPalette::Window},
                                           {QPalette::Text, QPalette::Base},
                                           {QPalette::Text, QPalette::AlternateBase},
                                           {QPalette::ButtonText, QPalette::Button},
                                           {QPalette::ToolTipText, QPalette::ToolTipBase},
                                           {QPalette::Link, QPalette::Window},
                                           {QPalette::PlaceholderText, QPalette::Base},
                                           {QPalette::PlaceholderText, QPalette::Window}})
          is_least(least_text, "palette", p.color(text), p.color(ground), 4.5);
      }
    set_theme(*qApp, Theme::dark);
    qInfo("least contrast: text %.2f, lines and signs %.2f", least_text, least_sign);
  }

  void changesTakeEffectAtOnce() {
    Film film("create ball sphere\n");
    Window window(film.workspace);
    window.show();
    const QColor dark = colors().back, red = colors().x;
    user().set("light", true);
    QVERIFY(colors().back != dark);
    user().set("safe-colors", true);
    QVERIFY(colors().x != red && picture_colors().x != red);
    const double font = QApplication::font().pointSizeF();
    auto* script = window.findChild<QPlainTextEdit*>("script");
    const double of_script = script->font().pointSizeF();
    user().set("interface-size", 200);
    QVERIFY(std::abs(QApplication::font().pointSizeF() - 2 * font) < 0.01);
    QVERIFY(std::abs(script->font().pointSizeF() - 2 * of_script) < 0.01);
    user().set("script-size", 150);
    QVERIFY(std::abs(script->font().pointSizeF() - 3 * of_script) < 0.01);
    QVERIFY(std::abs(QApplication::font().pointSizeF() - 2 * font) < 0.01);
    QVERIFY(window.isAnimated());
    user().set("less-motion", true);
    QVERIFY(!window.isAnimated());
    QCOMPARE(QApplication::cursorFlashTime(), 0);
    user().set("loop", false);
    QVERIFY(!film.workspace.playhead().loops());
    user().set("mute", true);
    QVERIFY(window.sound().muted());
    user().reset_all();
    QCOMPARE(colors().back, dark);
    QVERIFY(std::abs(QApplication::font().pointSizeF() - font) < 0.01);
    QVERIFY(film.workspace.playhead().loops() && !window.sound().muted() && window.isAnimated());
  }

  void aLaterWindowHasTheSameSizes() {
    Film film("create ball sphere\n"), other("create ball sphere\n");
    Window first(film.workspace);
    first.show();
    user().set("interface-size", 200);
    {
      Window later(other.workspace);
      later.show();
      QCoreApplication::processEvents();
      for (const char* name : {"script", "log", "play", "at", "outliner_tree", "name"}) {
        const auto *a = first.findChild<QWidget*>(name), *b = later.findChild<QWidget*>(name);
        if (!a && !b) continue;
        QVERIFY2(std::abs(a->font().pointSizeF() - b->font().pointSizeF()) < 0.01, name);
        const auto *x = qobject_cast<const QToolButton*>(a), *y = qobject_cast<const QToolButton*>(b);
        if (x && y) QCOMPARE(x->iconSize(), y->iconSize());
      }
      const auto *a = first.findChild<QDockWidget*>("history_dock"), *b = later.findChild<QDockWidget*>("history_dock");
      QVERIFY(std::abs(a->font().pointSizeF() - b->font().pointSizeF()) < 0.01);
      QVERIFY(std::abs(a->font().pointSizeF() - QApplication::font().pointSizeF()) < 0.01);
    }
    user().reset_all();
  }

  void theFileKeepsTheDifferencesOnly() {
    user().set("light", true);
    user().set("interface-size", 120);
    user().set("loop", true);  // as at the start
    QStringList kept = settings().allKeys();
    kept.sort();
    QCOMPARE(kept, (QStringList{"interface-size", "light"}));
    settings().setValue("interface-size", "huge");
    settings().setValue("script-size", 100'000);
    settings().setValue("language", "what nobody speaks");
    settings().setValue("light", "perhaps");
    user().recall();
    QCOMPARE(user().value("interface-size").toInt(), 100);
    QCOMPARE(user().value("script-size").toInt(), 250);
    QCOMPARE(user().word("language"), "system");
    QVERIFY(!user().is_on("light"));
  }

  void everySettingHasAFieldThatChangesIt() {
    PreferencesWindow window;
    window.show();
    for (const Preference& row : preference_rows()) {
      auto* field = window.findChild<QWidget*>("set_" + text_of(row.name));
      QVERIFY2(field, qPrintable(text_of(row.name)));
      QVERIFY(!field->accessibleName().isEmpty() && !field->toolTip().isEmpty());
      const QVariant before = user().value(row.name);
      if (auto* box = qobject_cast<QCheckBox*>(field)) box->click();
      if (auto* box = qobject_cast<QComboBox*>(field)) box->setCurrentIndex((box->currentIndex() + 1) % box->count());
      if (auto* box = qobject_cast<QSpinBox*>(field)) box->stepUp();
      if (row.kind != Preference::Kind::fact) QVERIFY2(user().value(row.name) != before, qPrintable(text_of(row.name)));
      user().set(row.name, before);
      if (auto* box = qobject_cast<QCheckBox*>(field)) QCOMPARE(box->isChecked(), before.toBool());
      if (auto* box = qobject_cast<QSpinBox*>(field)) QCOMPARE(box->value(), before.toInt());
    }
  }
};

QTEST_MAIN(PreferencesTest)
#include "preferences_test.moc"
