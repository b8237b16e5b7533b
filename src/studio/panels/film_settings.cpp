// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/film_settings.h"

#include <fmt/format.h>

#include <QColorDialog>
#include <QFileDialog>
#include <QGridLayout>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>

#include "commands/verbs.h"
#include "language/values.h"
#include "scene/document.h"
#include "studio/assets/asset_files.h"
#include "studio/shell/control_names.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"
#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

struct Setting {
  const char *verb, *name, *otherwise;  // `otherwise`: the setting of a script that says nothing
  const char* choices;                  // separated by ';'
  bool color = false;                   // a colour can be chosen
  const char* files = nullptr;          // or a file with one of these endings
};
constexpr Setting settings[] = {
    {"rate", QT_TRANSLATE_NOOP("FilmSettings", "Frames a second"), "24", "12;24;25;30;50;60"},
    {"range", QT_TRANSLATE_NOOP("FilmSettings", "First and last frame"), "", "1f 48f;1f 120f;1f 240f;1f 480f"},
    {"size", QT_TRANSLATE_NOOP("FilmSettings", "Size"), "1280x720", "1280x720;1920x1080;3840x2160;1080x1920;1080x1080"},
    {"samples", QT_TRANSLATE_NOOP("FilmSettings", "Samples a pixel"), "4", "1;4;9;16;auto"},
    {"film", QT_TRANSLATE_NOOP("FilmSettings", "Drawn as"), "solid", "solid;flat"},
    {"theme", QT_TRANSLATE_NOOP("FilmSettings", "Theme"), "none", "none;dark;light;paper"},
    {"background", QT_TRANSLATE_NOOP("FilmSettings", "Background"), "none",
     "none;transparent;white;black;navy to black", true},
    {"sky", QT_TRANSLATE_NOOP("FilmSettings", "Sky"), "off", "off;studio;day hour=10;sunset;overcast;on", false,
     "*.hdr *.exr"},
    {"ground", QT_TRANSLATE_NOOP("FilmSettings", "Ground"), "off", "off;on", true},
    {"contact", QT_TRANSLATE_NOOP("FilmSettings", "Contact shadows"), "off", "off;on"},
    {"ambient", QT_TRANSLATE_NOOP("FilmSettings", "Ambient light"), "off", "off;#202428", true},
    {"exposure", QT_TRANSLATE_NOOP("FilmSettings", "Exposure"), "0", "-1;0;0.5;1"},
    {"view", QT_TRANSLATE_NOOP("FilmSettings", "View transform"), "neutral", "neutral;filmic;agx;plain", false,
     "*.cube *.ocio *.3dl *.csp *.clf *.ctf *.spi1d *.spi3d *.vf *.cc *.ccc *.cdl"},
    {"white-balance", QT_TRANSLATE_NOOP("FilmSettings", "White balance"), "6500", "3200;5000;6500;8000"},
    {"bloom", QT_TRANSLATE_NOOP("FilmSettings", "Bloom"), "0", "0;0.1;0.3"},
    {"vignette", QT_TRANSLATE_NOOP("FilmSettings", "Vignette"), "0", "0;0.2;0.4"},
    {"grain", QT_TRANSLATE_NOOP("FilmSettings", "Film grain"), "0", "0;0.1;0.3"},
    {"fog", QT_TRANSLATE_NOOP("FilmSettings", "Fog"), "off", "off;lightsteelblue from 10 to 60"},
    {"pixel-filter", QT_TRANSLATE_NOOP("FilmSettings", "Pixel filter"), "box", "box;tent;gaussian;mitchell;lanczos"},
    {"subframes", QT_TRANSLATE_NOOP("FilmSettings", "Subframes of blur"), "16", "8;16;32"},
};

// Returns what the film says after this verb, or "".
std::string said(const Document& d, const std::string& verb) {
  if (verb == "rate") {
    const Rate r = d.rate();
    return r.den == 1 ? std::to_string(r.num) : fmt::format("{}/{}", r.num, r.den);
  }
  if (verb == "range") return format_time(d.range().first, d) + " " + format_time(d.range().second, d);
  if (verb == "size" && d.size()) return fmt::format("{}x{}", d.size()->first, d.size()->second);
  const std::string all = write_appearance(d.scene()) + write_theme(d.scene());
  for (std::size_t at = 0; at < all.size(); at = all.find('\n', at) + 1)
    if (all.compare(at, verb.size() + 1, verb + " ") == 0)
      return all.substr(at + verb.size() + 1, all.find('\n', at) - at - verb.size() - 1);
  return {};
}

// Returns the command that changes the rate where the script gives it, or writes it above everything else: it says how
// the times of all later lines are meant.
std::string line_of_rate(std::string_view text, const std::string& rate) {
  int number = 0, above = 0;  // lines of comments at the beginning
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    ++number;
    if (first_word(line) == "rate" && !indented(line)) return Session::rewrite_line(number, number, "rate " + rate);
    if (above == number - 1 && first_word(line).starts_with('#')) above = number;
  }
  return Session::rewrite_line(above + 1, above, "rate " + rate);
}

}  // namespace

FilmSettings::FilmSettings(Workspace& workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
  setObjectName("film_settings");
  auto* column = new QVBoxLayout(this);
  auto* title = new QLabel(tr("The film"), this);
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  column->addWidget(title);
  auto* grid = new QGridLayout;
  grid->setColumnStretch(1, 1);
  column->addLayout(grid);
  rows_.reserve(std::size(settings));
  for (const Setting& s : settings) {
    const int at = grid->rowCount();
    Row row{s.verb, new QComboBox(this), new QLabel(tr(s.name), this)};
    const QString name = text_of(s.verb);
    row.box->setObjectName("film_" + name);
    row.box->setEditable(true);
    row.box->setInsertPolicy(QComboBox::NoInsert);
    row.box->addItems(QString(s.choices).split(';'));
    row.box->setAccessibleName(tr(s.name));
    row.box->lineEdit()->setPlaceholderText(s.otherwise);
    if (const Verb* verb = find_verb(s.verb)) {
      const QString help = text_of(verb->sentence) + "\n" + text_of(verb->usage);
      row.called->setToolTip(tip_of(help)), row.box->setToolTip(tip_of(help));
    }
    row.called->setBuddy(row.box);
    grid->addWidget(row.called, at, 0);
    grid->addWidget(row.box, at, 1);
    rows_.push_back(row);
    const Row& of = rows_.back();
    connect(row.box, &QComboBox::activated, this, [this, &of] { say(of); });
    connect(row.box->lineEdit(), &QLineEdit::editingFinished, this, [this, &of] { say(of); });
    if (!s.color && s.files == nullptr) continue;
    auto* chooser = new QToolButton(this);
    chooser->setObjectName((s.color ? "color_" : "file_") + name);
    chooser->setText("…");
    chooser->setToolTip(s.color ? tr("Chooses a colour") : tr("Chooses a file"));
    chooser->setAccessibleName((s.color ? tr("Colour of %1") : tr("File of %1")).arg(tr(s.name)));
    grid->addWidget(chooser, at, 2);
    if (s.color)
      connect(chooser, &QToolButton::clicked, this, [this, &of] { choose_color(of); });
    else
      connect(chooser, &QToolButton::clicked, this, [this, &of, &s] { choose_file(of, s.files); });
  }
  auto* hint = new QLabel(tr("Nothing is selected. Select an object to see its properties."), this);
  hint->setWordWrap(true);
  hint->setEnabled(false);
  column->addWidget(hint);
  column->addStretch(1);
}

void FilmSettings::refresh() {
  const Document& d = workspace_.document();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    QLineEdit* const edit = rows_[i].box->lineEdit();
    if (edit->hasFocus() && edit->isModified()) continue;
    const std::string now = said(d, rows_[i].verb);
    const QString text = text_of(now);
    if (edit->text() != text) show_text(*edit, text);
  }
}

// Carries out the command, unless the film has that setting.
void FilmSettings::say(const Row& row) {
  QLineEdit* const edit = row.box->lineEdit();
  QString words = edit->text().simplified();
  if (row.verb == "range") {  // numbers alone are frames, one alone is the last
    QStringList parts = words.split(' ', Qt::SkipEmptyParts);
    for (QString& part : parts) {
      bool number = false;
      (void)part.toInt(&number);
      if (number) part += "f";
    }
    if (parts.size() == 1)
      parts.prepend(text_of(format_time(workspace_.document().range().first, workspace_.document())));
    words = parts.join(' ');
  }
  const std::string now = words.toStdString();
  edit->setModified(false);
  if (!now.empty() && now != said(workspace_.document(), row.verb))
    workspace_.say(row.verb == "rate" ? line_of_rate(workspace_.text(), now) : row.verb + " " + now);
  refresh();
}

void FilmSettings::choose_color(const Row& row) {
  const QColor color = QColorDialog::getColor(QColor(row.box->currentText()), this);
  if (!color.isValid()) return;
  row.box->setEditText(color.name());
  say(row);
}

void FilmSettings::choose_file(const Row& row, const char* endings) {
  const QString name = row.called->text();
  const QString file = QFileDialog::getOpenFileName(this, name, {}, QString("%1 (%2)").arg(name, endings));
  if (file.isEmpty()) return;
  row.box->setEditText(text_of(write_text(path_from_script(file, workspace_.session().file()))));
  say(row);
}

}  // namespace betwixt::studio
