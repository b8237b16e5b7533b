// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/palette.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/said_line.h"
#include "studio/objects/creating.h"
#include "studio/shell/actions.h"
#include "studio/shell/keys.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

constexpr int what = Qt::UserRole, which = Qt::UserRole + 1;
enum What { action, object, line, kind_to_add };

// Returns whether the text begins with a verb and another word.
bool is_line(const QString& letters) {
  const std::string words = letters.trimmed().toStdString();
  return words.find(' ') != std::string::npos && is_verb(first_word(words));
}

}  // namespace

int fit(const QString& letters, const QString& name) {
  int at = 0, good = 1;
  for (int i = 0; i < letters.size(); ++i) {
    if (letters[i].isSpace()) continue;
    const int there = name.indexOf(letters[i], at, Qt::CaseInsensitive);
    if (there < 0) return 0;
    good += there == at && i > 0 ? 5 : 0;
    good += there == 0 || name[there - 1] == ' ' ? 8 : 0;
    at = there + 1;
  }
  return good * 100 - std::min<int>(static_cast<int>(name.size()), 99);
}

Palette::Palette(Window& window)
    : QDialog(&window), window_(window), line_(new QLineEdit(this)), found_(new QListWidget(this)) {
  setObjectName("palette");
  setWindowTitle(tr("Find a command"));
  auto* lines = new QVBoxLayout(this);
  lines->addWidget(line_);
  lines->addWidget(found_);
  line_->setPlaceholderText(tr("part of a command, an object's name, or a line such as: set ball.color red"));
  line_->installEventFilter(this);
  found_->setFocusPolicy(Qt::NoFocus);
  const int em = fontMetrics().height();
  resize_on_screen(*this, QSize(44, 26) * em);
  connect(line_, &QLineEdit::textChanged, this, &Palette::list);
  connect(line_, &QLineEdit::returnPressed, this, &Palette::run);
  connect(found_, &QListWidget::itemClicked, this, &Palette::run);
  list({});
}

void Palette::list(const QString& letters) {
  found_->clear();
  struct Found {
    int good;
    QListWidgetItem* item;
  };
  std::vector<Found> all;
  const auto add = [&](int good, const QString& words, const QString& tip, int kind, int number) {
    if (good <= 0) return;
    auto* item = new QListWidgetItem(words);
    item->setToolTip(tip), item->setData(what, kind), item->setData(which, number);
    all.push_back({good, item});
  };
  const QString word = letters.trimmed();
  const auto whole_word = [&](const QString& in) {
    return word.size() > 2 && (" " + in + " ").contains(" " + word + " ", Qt::CaseInsensitive);
  };
  const auto by_name = [&](const QString& name) { return fit(letters, name) + (whole_word(name) ? 2000 : 0); };
  // The first of the other words is what the action is mostly called elsewhere.
  const auto by_other_words = [&](std::string_view also) {
    const auto place = (" " + text_of(also)).indexOf(" " + word, 0, Qt::CaseInsensitive);
    const int good = whole_word(text_of(also)) ? 2600 : 1500;
    return word.size() > 2 && place >= 0 ? good - static_cast<int>(place) : 0;
  };
  const auto& rows = action_rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const QString name = word_of(rows[i].name), keys = Keys::of_user().shown(rows[i].name);
    int good = std::max(by_name(name), by_name(text_of(rows[i].name)));  // also by its English name
    good = std::max(good, by_other_words(rows[i].also));
    add(good, word_of(rows[i].menu) + ": " + name + (keys.isEmpty() ? "" : "    " + keys), word_of(rows[i].sentence),
        action, static_cast<int>(i));
  }
  const auto kinds = created_kinds();
  for (std::size_t i = 0; i < kinds.size() && !letters.isEmpty(); ++i) {
    const QString name = text_of(name_of(kinds[i].kind));
    add(std::max(by_name(name), by_other_words(kinds[i].also)), word_of("Add object") + ": " + name, {}, kind_to_add,
        static_cast<int>(i));
  }
  if (!letters.isEmpty()) {
    int listed = 0;
    for (const std::string& name : window_.workspace().document().names()) {
      const QString words = tr("Select %1").arg(QString::fromStdString(name));
      const int good = fit(letters, words);
      if (good <= 0 || ++listed > 200) continue;
      add(good - 50, words, {}, object, static_cast<int>(window_.workspace().document().find(name).index));
    }
    add(is_line(letters) ? 10'000'000 : 1, tr("Run: %1").arg(letters), {}, line, 0);
  }
  std::ranges::stable_sort(all, [](const Found& a, const Found& b) { return a.good > b.good; });
  for (const Found& f : all) found_->addItem(f.item);
  found_->setCurrentRow(0);
}

void Palette::run() {
  const QListWidgetItem* item = found_->currentItem();
  if (!item) return;
  const int kind = item->data(what).toInt(), number = item->data(which).toInt();
  const QString said = line_->text();
  if (kind == line && !window_.workspace().say(said.toStdString())) {  // stay open, so that the user can correct it
    found_->clear();
    for (const QString& why : QString::fromStdString(window_.workspace().last_said()).split('\n', Qt::SkipEmptyParts))
      (new QListWidgetItem(why, found_))->setForeground(colors().error);
    return;
  }
  accept();
  if (kind == action) action_rows()[static_cast<std::size_t>(number)].run(window_);
  if (kind == kind_to_add)
    create_of_kind(window_.workspace(), created_kinds()[static_cast<std::size_t>(number)], &window_);
  if (kind == object) window_.workspace().select({ObjectId{static_cast<std::uint32_t>(number)}});
}

bool Palette::eventFilter(QObject* o, QEvent* e) {
  if (e->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(e)->key(), row = found_->currentRow();
    if (key == Qt::Key_Down) return found_->setCurrentRow(std::min(row + 1, found_->count() - 1)), true;
    if (key == Qt::Key_Up) return found_->setCurrentRow(std::max(row - 1, 0)), true;
  }
  return QDialog::eventFilter(o, e);
}

}  // namespace betwixt::studio
