// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/preferences_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QStackedWidget>

#include "studio/shell/keys_page.h"
#include "studio/shell/preferences.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"

namespace betwixt::studio {
namespace {

constexpr std::string_view pages[] = {QT_TR_NOOP("General"), QT_TR_NOOP("Appearance"), QT_TR_NOOP("Keyboard"),
                                      QT_TR_NOOP("Playback")};

}  // namespace

PreferencesWindow::PreferencesWindow(QWidget* parent)
    : QDialog(parent), names_(new QListWidget(this)), pages_(new QStackedWidget(this)) {
  setObjectName("preferences");
  setWindowTitle(tr("Preferences"));
  names_->setObjectName("pages");
  names_->setAccessibleName(tr("Pages"));
  for (const std::string_view page : pages) {
    auto* item = new QListWidgetItem(word_of(page), names_);
    item->setData(Qt::UserRole, text_of(page));
    pages_->addWidget(page == "Keyboard" ? new KeysPage(this) : page_of(page));
  }
  const int em = fontMetrics().height();
  names_->setFixedWidth(std::max(8 * em, names_->sizeHintForColumn(0) + 2 * em));
  connect(names_, &QListWidget::currentRowChanged, pages_, &QStackedWidget::setCurrentIndex);
  names_->setCurrentRow(0);
  auto* reset = new QPushButton(tr("Reset all but the keyboard"), this);
  reset->setObjectName("reset_all");
  reset->setToolTip(tr("Gives all settings their first values. The keyboard has its own button."));
  connect(reset, &QPushButton::clicked, this, [] { Preferences::of_user().reset_all(); });
  auto* done = new QPushButton(tr("Close"), this);
  done->setDefault(true);
  connect(done, &QPushButton::clicked, this, &QDialog::close);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(reset), buttons->addStretch(1), buttons->addWidget(done);
  auto* middle = new QHBoxLayout;
  middle->addWidget(names_), middle->addWidget(pages_, 1);
  auto* all = new QVBoxLayout(this);
  all->addLayout(middle, 1), all->addLayout(buttons);
  resize_on_screen(*this, QSize(46, 30) * em);
}

void PreferencesWindow::turn_to(const QString& page) {
  for (int i = 0; i < names_->count(); ++i)
    if (names_->item(i)->data(Qt::UserRole) == page) names_->setCurrentRow(i);
}

QWidget* PreferencesWindow::page_of(std::string_view name) {
  auto* area = new QScrollArea;  // for small screens
  area->setFrameShape(QFrame::NoFrame), area->setWidgetResizable(true);
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  for (const Preference& row : preference_rows()) {
    if (row.page != name) continue;
    QWidget* field = field_of(row);
    field->setObjectName("set_" + text_of(row.name));
    field->setAccessibleName(word_of(row.label));
    field->setToolTip(word_of(row.sentence));
    row.kind == Preference::Kind::on_off ? form->addRow(field) : form->addRow(word_of(row.label), field);
    if (row.kind == Preference::Kind::fact) continue;
    auto* says = new QLabel(word_of(row.sentence));
    says->setWordWrap(true);
    says->setForegroundRole(QPalette::PlaceholderText);
    form->addRow(says);
  }
  area->setWidget(page);
  return area;
}

// The field shows the value also when something else changes it.
QWidget* PreferencesWindow::field_of(const Preference& row) {
  Preferences& user = Preferences::of_user();
  const auto follow = [&](QWidget* field, auto show) {
    show();
    connect(&user, &Preferences::changed, field, [name = text_of(row.name), show](const QString& changed) {
      if (changed == name) show();
    });
    return field;
  };
  switch (row.kind) {
    case Preference::Kind::on_off: {
      auto* box = new QCheckBox(word_of(row.label));
      connect(box, &QCheckBox::toggled, this, [&user, &row](bool on) { user.set(row.name, on); });
      return follow(box, [box, &user, &row] { box->setChecked(user.is_on(row.name)); });
    }
    case Preference::Kind::choice: {
      auto* box = new QComboBox;
      for (const auto& [value, words] : row.choices) box->addItem(word_of(words), text_of(value));
      connect(box, &QComboBox::currentIndexChanged, this,
              [box, &user, &row](int i) { user.set(row.name, box->itemData(i)); });
      return follow(box, [box, &user, &row] { box->setCurrentIndex(box->findData(user.value(row.name))); });
    }
    case Preference::Kind::percent: {
      auto* box = new QSpinBox;
      box->setRange(row.low, row.high), box->setSingleStep(10), box->setSuffix(" %");
      box->setKeyboardTracking(false);  // 1 on the way to 120 is not meant
      connect(box, &QSpinBox::valueChanged, this, [&user, &row](int v) { user.set(row.name, v); });
      return follow(box, [box, &user, &row] { box->setValue(user.value(row.name).toInt()); });
    }
    case Preference::Kind::fact:
      break;
  }
  auto* says = new QLabel(word_of(row.sentence));
  says->setWordWrap(true);
  return says;
}

}  // namespace betwixt::studio
