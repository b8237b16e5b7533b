// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/keys_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

#include "studio/shell/keys.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {

// Tab and Escape keep their meaning in windows, so that the keyboard can leave the field.
class KeyField : public QLineEdit {
 public:
  explicit KeyField(QWidget* parent) : QLineEdit(parent) { setReadOnly(true); }
  std::function<void(const QKeySequence&)> pressed;

 protected:
  bool event(QEvent* e) override {
    if (e->type() == QEvent::ShortcutOverride) return e->accept(), true;
    return QLineEdit::event(e);
  }
  void keyPressEvent(QKeyEvent* e) override {
    const QKeyCombination key = key_of(*e);
    const bool leaves = key.key() == Qt::Key_Tab || key.key() == Qt::Key_Escape;
    const bool half = key.key() == Qt::Key_Shift || key.key() == Qt::Key_Control || key.key() == Qt::Key_Alt ||
                      key.key() == Qt::Key_Meta || key.key() == Qt::Key_AltGr || key.key() == Qt::Key_unknown;
    if (leaves) return QLineEdit::keyPressEvent(e);
    if (!half) pressed(QKeySequence(key));
  }
};

QComboBox* make_preset_box(QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setObjectName("preset");
  box->setAccessibleName(QObject::tr("Preset"));
  box->setToolTip(QObject::tr("The keys of another program, for the actions that are here too"));
  for (const KeyPreset& p : key_presets()) box->addItem(text_of(p.title), text_of(p.name));
  Keys& keys = Keys::of_user();
  const auto follow = [box, &keys] { box->setCurrentIndex(box->findData(keys.preset())); };
  QObject::connect(box, &QComboBox::activated, box,
                   [box, &keys](int i) { keys.set_preset(box->itemData(i).toString()); });
  QObject::connect(&keys, &Keys::changed, box, follow);
  follow();
  return box;
}

KeysPage::KeysPage(QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit(this)),
      rows_(new QTreeWidget(this)),
      field_(new KeyField(this)),
      says_(new QLabel(this)) {
  search_->setObjectName("key_search"), rows_->setObjectName("key_rows");
  field_->setObjectName("key_field"), says_->setObjectName("key_says");
  search_->setPlaceholderText(tr("part of an action, or a key")), search_->setAccessibleName(tr("Search"));
  search_->setClearButtonEnabled(true);
  rows_->setHeaderLabels({tr("Action"), tr("Key"), tr("Where")});
  rows_->setAccessibleName(tr("Actions and their keys"));
  rows_->setRootIsDecorated(false), rows_->setUniformRowHeights(true);
  rows_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  rows_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  rows_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  field_->setPlaceholderText(tr("press a key here")), field_->setAccessibleName(tr("New key"));
  says_->setWordWrap(true), says_->setTextFormat(Qt::PlainText);
  take_ = new QPushButton(tr("Take it"), this), take_->setObjectName("take_key");
  take_->setToolTip(tr("Gives the key to this action, and takes it from the other one"));
  none_ = new QPushButton(tr("No key"), this), none_->setObjectName("no_key");
  none_->setToolTip(tr("Removes the key of this action"));
  reset_ = new QPushButton(tr("Reset"), this), reset_->setObjectName("reset_key");
  reset_->setToolTip(tr("Gives this action the key of the preset"));
  auto* reset_all = new QPushButton(tr("Reset all keys"), this);
  reset_all->setObjectName("reset_keys");
  reset_all->setToolTip(tr("Gives all actions the keys of the preset"));
  auto* head = new QHBoxLayout;
  head->addWidget(new QLabel(tr("Preset"))), head->addWidget(make_preset_box(this)), head->addWidget(search_, 1);
  auto* below = new QHBoxLayout;
  below->addWidget(field_, 1), below->addWidget(take_), below->addWidget(none_), below->addWidget(reset_);
  below->addWidget(reset_all);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  says_->setMinimumHeight(2 * says_->fontMetrics().lineSpacing());
  all->addLayout(head), all->addWidget(rows_, 1), all->addLayout(below), all->addWidget(says_);

  Keys& keys = Keys::of_user();
  connect(search_, &QLineEdit::textChanged, this, &KeysPage::search);
  connect(rows_, &QTreeWidget::currentItemChanged, this, &KeysPage::show_row);
  field_->pressed = [this](const QKeySequence& key) { press(key); };
  connect(take_, &QPushButton::clicked, this, [this, &keys] {
    const KeyRow* row = chosen();
    const QList<QKeySequence> key = keys_from(field_->text());
    if (!row || key.isEmpty()) return;
    for (const KeyRow* other : keys.conflicts(*row, key[0])) {
      QList<QKeySequence> left = keys.keys(*other);
      left.removeAll(key[0]);
      keys.set(*other, left);
    }
    keys.set(*row, key);
  });
  connect(none_, &QPushButton::clicked, this, [this, &keys] {
    if (const KeyRow* row = chosen()) keys.set(*row, {});
  });
  connect(reset_, &QPushButton::clicked, this, [this, &keys] {
    if (const KeyRow* row = chosen()) keys.reset(*row);
  });
  connect(reset_all, &QPushButton::clicked, &keys, &Keys::reset_all);
  connect(&keys, &Keys::changed, this, &KeysPage::list);
  list();
}

const KeyRow* KeysPage::chosen() const {
  const QTreeWidgetItem* item = rows_->currentItem();
  if (!item || item->isHidden()) return nullptr;
  return &Keys::of_user().rows()[static_cast<std::size_t>(item->data(0, Qt::UserRole).toInt())];
}

void KeysPage::list() {
  const Keys& keys = Keys::of_user();
  const int current = rows_->indexOfTopLevelItem(rows_->currentItem());
  const QSignalBlocker quiet(rows_);  // without a row for a moment, the key field would lose the focus
  rows_->clear();
  for (std::size_t i = 0; i < keys.rows().size(); ++i) {
    const KeyRow& row = keys.rows()[i];
    if (row.fixed) continue;
    const auto place = std::ranges::find(key_places(), row.place, &KeyPlace::name);
    const QString where = row.menu.empty() ? word_of(place->title) : word_of(row.menu);
    auto* item =
        new QTreeWidgetItem(rows_, {word_of(row.name), words_of_keys(keys.keys(row), QKeySequence::NativeText), where});
    item->setData(0, Qt::UserRole, static_cast<int>(i));
    item->setToolTip(0, word_of(row.sentence));
    if (!keys.is_changed(row)) continue;
    QFont bold = font();
    bold.setBold(true);
    item->setFont(1, bold);
    item->setToolTip(1, tr("changed by you"));
  }
  search(search_->text());
  rows_->setCurrentItem(rows_->topLevelItem(std::max(0, current)));
  show_row();
}

void KeysPage::search(const QString& words) {
  for (int i = 0; i < rows_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = rows_->topLevelItem(i);
    bool fits = words.trimmed().isEmpty();
    for (int column = 0; column < 3; ++column)
      fits = fits || item->text(column).contains(words.trimmed(), Qt::CaseInsensitive);
    item->setHidden(!fits);
  }
}

void KeysPage::show_row() {
  const KeyRow* row = chosen();
  field_->clear(), take_->setEnabled(false);
  for (QWidget* w : std::initializer_list<QWidget*>{field_, none_, reset_}) w->setEnabled(row);
  reset_->setEnabled(row && Keys::of_user().is_changed(*row));
  says_->setText(row ? word_of(row->sentence) : QString());
}

// A free key is taken at once. If another action has it, a message says which one, and the user decides.
void KeysPage::press(const QKeySequence& key) {
  Keys& keys = Keys::of_user();
  const KeyRow* row = chosen();
  if (!row) return;
  const auto others = keys.conflicts(*row, key);
  const QString shown = key.toString(QKeySequence::NativeText);
  if (others.empty()) {
    const KeyRow* hides = keys.hidden_by(*row, key);
    keys.set(*row, {key});
    if (hides) says_->setText(tr("In some panels %1 means: %2.").arg(shown, word_of(hides->name)));
    return;
  }
  field_->setText(key.toString(QKeySequence::PortableText));
  const bool fixed = std::ranges::any_of(others, &KeyRow::fixed);
  says_->setText(
      fixed ? tr("%1 belongs to '%2' and cannot be changed.").arg(shown, word_of(others[0]->name))
            : tr("%1 is the key of '%2'. 'Take it' takes it from there.").arg(shown, word_of(others[0]->name)));
  take_->setEnabled(!fixed);
}

}  // namespace betwixt::studio
