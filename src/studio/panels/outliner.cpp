// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/outliner.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QVBoxLayout>

#include "editor/made_by.h"
#include "scene/functions.h"
#include "scene/own_kinds.h"
#include "studio/assets/look_lines.h"
#include "studio/objects/creating.h"
#include "studio/objects/object_actions.h"
#include "studio/shell/key_focus.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {

OutlinerTree::OutlinerTree(Workspace& workspace, OutlinerModel& model, QWidget* parent)
    : QTreeView(parent), workspace_(workspace), model_(model) {
  setObjectName("outliner_tree");
  setModel(&model);
  setHeaderHidden(true);
  setUniformRowHeights(true);
  setFrameShape(QFrame::NoFrame);
  follow_pointer(*this);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setAcceptDrops(true);
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  setExpandsOnDoubleClick(false);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(OutlinerModel::name, QHeaderView::Stretch);
  header()->setSectionResizeMode(OutlinerModel::eye, QHeaderView::Fixed);
  measure_by_text(*this, [this] {
    const int em = fontMetrics().height();
    setIconSize({em, em});
    setIndentation(em);
    header()->setMinimumSectionSize(em);
    header()->resizeSection(OutlinerModel::eye, em + em / 2);
  });
  const auto note = [this](std::set<std::uint32_t>& into, std::set<std::uint32_t>& from) {
    return [this, &into, &from](const QModelIndex& i) {
      if (!folding_) into.insert(model_.object(i).index), from.erase(model_.object(i).index);
    };
  };
  connect(this, &QTreeView::collapsed, this, note(folded_, opened_));
  connect(this, &QTreeView::expanded, this, note(opened_, folded_));
  connect(&model, &QAbstractItemModel::modelReset, this, [this] { fold(), take_selection(); });
  fold();
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (selecting_) return;
    selecting_ = true;
    workspace_.select(marked());
    selecting_ = false;
  });
  connect(&workspace, &Workspace::selection_changed, this, &OutlinerTree::take_selection);
}

// Returns whether all below a row is made by `create`, such as the numbers of axes.
bool OutlinerTree::has_only_pieces(const QModelIndex& of) const {
  const Document& d = workspace_.document();
  const std::string name = d.name(model_.object(of));
  for (int row = 0; row < model_.rowCount(of); ++row)
    if (!is_below(d.name(model_.object(model_.index(row, 0, of))), name)) return false;
  for (std::string up = name;; up.resize(up.rfind('/'))) {
    const ObjectId id = d.find(up);
    if (id && find_built_in(kind(d, id), "bare")) return true;
    if (up.find('/') == up.npos) return false;
  }
}

// Opens and closes the rows of a new tree.
void OutlinerTree::fold() {
  folding_ = true;
  expandAll();
  for (const ObjectId id : objects(workspace_.document()))
    if (const QModelIndex i = model_.index_of(id); i.isValid() && model_.rowCount(i) > 0)
      if (folded_.contains(id.index) || (!opened_.contains(id.index) && has_only_pieces(i))) collapse(i);
  folding_ = false;
}

// Returns the selected objects; the current one comes last, because it leads.
std::vector<ObjectId> OutlinerTree::marked() const {
  std::vector<ObjectId> all;
  for (const QModelIndex& i : selectionModel()->selectedRows()) all.push_back(model_.object(i));
  std::ranges::sort(all, {}, &ObjectId::index);
  const auto leads = std::ranges::find(all, model_.object(currentIndex()));
  if (leads != all.end()) std::rotate(leads, leads + 1, all.end());
  return all;
}

void OutlinerTree::take_selection() {
  if (selecting_) return;
  selecting_ = true;
  // Joins neighbouring rows into ranges, which makes even ten thousand of them fast.
  std::vector<QModelIndex> rows;
  for (const ObjectId id : workspace_.selected())
    if (const QModelIndex i = model_.index_of(id); i.isValid()) rows.push_back(i);
  const auto place = [](const QModelIndex& i) { return std::pair(i.parent().internalId(), i.row()); };
  std::ranges::sort(rows, {}, place);
  QItemSelection all;
  for (std::size_t i = 0; i < rows.size();) {
    const std::size_t first = i;
    for (++i; i < rows.size() && rows[i].parent() == rows[first].parent() && rows[i].row() == rows[i - 1].row() + 1;)
      ++i;
    all.append(QItemSelectionRange(rows[first], rows[i - 1]));
  }
  selectionModel()->select(all, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  if (!workspace_.selected().empty()) {
    const QModelIndex leads = model_.index_of(workspace_.selected().back());
    selectionModel()->setCurrentIndex(leads, QItemSelectionModel::NoUpdate);
    if (leads.isValid()) scrollTo(leads);
  }
  selecting_ = false;
}

// Hides or shows an object, or all selected objects if it is one of them. A display with events changes from the
// current time on.
void OutlinerTree::toggle(ObjectId id) {
  std::vector<ObjectId> all = workspace_.selected();
  if (std::ranges::find(all, id) == all.end()) all = {id};
  workspace_.say(display_lines(workspace_.document(), all, !model_.shown(id), workspace_.time()));
}

// Couples the dragged objects to the row below the pointer; with Alt attaches them, with Shift hangs them on it.
// Dropped on an empty place they lose their parents.
void OutlinerTree::drop(QPoint at, Qt::KeyboardModifiers held) {
  const Document& d = workspace_.document();
  const ObjectId onto = model_.object(indexAt(at));
  const AttachmentKind how = held & Qt::AltModifier     ? AttachmentKind::attach
                             : held & Qt::ShiftModifier ? AttachmentKind::hang
                                                        : AttachmentKind::couple;
  std::vector<std::string> lines;
  for (const ObjectId id : workspace_.selected()) {
    if (id == onto) continue;
    const QModelIndex above = model_.index_of(id).parent();
    if (!onto && !above.isValid()) continue;
    const bool timed = made_by(d, Target(id, fn::attachment), workspace_.time()).events;
    const Attachment to = onto    ? Attachment{how, onto, true}
                          : timed ? Attachment{AttachmentKind::letgo, {}, false}
                                  : Attachment{AttachmentKind::detach, {}, false};
    for (std::string& line : ObjectActions::of(workspace_).parent_lines(id, to)) lines.push_back(std::move(line));
  }
  workspace_.say(lines);
}

void OutlinerTree::mousePressEvent(QMouseEvent* e) {
  const QPoint at = e->position().toPoint();
  const QModelIndex i = indexAt(at);
  if (e->button() == Qt::LeftButton && i.isValid() && i.column() == OutlinerModel::eye) return toggle(model_.object(i));
  dragging_ = false;
  const bool on_name = i.isValid() && visualRect(i).contains(at);
  pressed_ = e->button() == Qt::LeftButton && on_name ? std::optional(at) : std::nullopt;
  // A drag moves all selected rows.
  if (pressed_ && selectionModel()->isSelected(i) && e->modifiers() == Qt::NoModifier) {
    selectionModel()->setCurrentIndex(i, QItemSelectionModel::NoUpdate);
    return;
  }
  QTreeView::mousePressEvent(e);
}

void OutlinerTree::mouseMoveEvent(QMouseEvent* e) {
  if (!pressed_ || !(e->buttons() & Qt::LeftButton)) return QTreeView::mouseMoveEvent(e);
  at_ = e->position().toPoint();
  if (!dragging_ && (at_ - *pressed_).manhattanLength() < QApplication::startDragDistance()) return;
  dragging_ = true;
  setCursor(Qt::ClosedHandCursor);
  viewport()->update();
}

void OutlinerTree::mouseReleaseEvent(QMouseEvent* e) {
  const auto pressed = std::exchange(pressed_, std::nullopt);
  if (std::exchange(dragging_, false)) {
    unsetCursor();
    viewport()->update();
    return drop(e->position().toPoint(), e->modifiers());
  }
  if (pressed && e->modifiers() == Qt::NoModifier) {  // a click without a drag selects this row alone
    const QModelIndex i = indexAt(*pressed);
    selectionModel()->setCurrentIndex(i, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  }
  QTreeView::mouseReleaseEvent(e);
}

void OutlinerTree::keyPressEvent(QKeyEvent* e) {
  if (e->key() == Qt::Key_Escape && dragging_) {
    dragging_ = false, pressed_.reset();
    unsetCursor();
    return viewport()->update();
  }
  if (e->key() == Qt::Key_H && e->modifiers() == Qt::NoModifier && !workspace_.selected().empty())
    return toggle(workspace_.selected().back());
  if (ObjectActions::of(workspace_).key(*e)) return;
  QTreeView::keyPressEvent(e);
}

void OutlinerTree::contextMenuEvent(QContextMenuEvent* e) {
  const QModelIndex under = indexAt(e->pos());
  if (under.isValid() && !selectionModel()->isSelected(under)) workspace_.select({model_.object(under)});
  QMenu menu(this);
  if (under.isValid()) menu.addAction(tr("Rename"), this, [this, under] { edit(under.siblingAtColumn(0)); });
  ObjectActions::of(workspace_).fill(menu);
  menu.exec(e->globalPos());
}

// A look from the assets.
void OutlinerTree::dragEnterEvent(QDragEnterEvent* e) { e->setAccepted(e->mimeData()->hasFormat(look_data)); }
void OutlinerTree::dragMoveEvent(QDragMoveEvent* e) { e->setAccepted(indexAt(e->position().toPoint()).isValid()); }
void OutlinerTree::dropEvent(QDropEvent* e) {
  const ObjectId on = model_.object(indexAt(e->position().toPoint()));
  if (!on) return;
  workspace_.say(look_lines(workspace_.document(), {on}, e->mimeData()->data(look_data).toStdString(),
                            workspace_.time(), workspace_.makes_events()));
  e->acceptProposedAction();
}

// Marks the drop target.
void OutlinerTree::paintEvent(QPaintEvent* e) {
  QTreeView::paintEvent(e);
  if (!dragging_) return;
  QPainter p(viewport());
  p.setPen(QPen(colors().accent, 2));
  const QModelIndex onto = indexAt(at_);
  if (!onto.isValid()) return p.drawRect(viewport()->rect().adjusted(1, 1, -1, -1));
  QRect row = visualRect(onto.siblingAtColumn(0));
  row.setRight(viewport()->width() - 2);
  p.drawRoundedRect(row, 3, 3);
}

Outliner::Outliner(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      model_(new OutlinerModel(workspace, this)),
      tree_(new OutlinerTree(workspace, *model_, this)),
      pattern_(new QLineEdit(this)) {
  setObjectName("outliner");
  setWindowTitle(tr("Outliner"));
  pattern_->setObjectName("pattern");
  pattern_->setPlaceholderText(tr("pattern: wheel*"));
  pattern_->setClearButtonEnabled(true);
  pattern_->setToolTip(tr("Patterns as in the language: wheel* {left,right} arm[1-3]; or a part of a name"));
  auto* plus = new QToolButton(this);
  plus->setObjectName("add");
  plus->setText("+");
  plus->setToolTip(tr("Makes an object: `create NAME KIND`"));
  plus->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(plus);
  fill_kinds(*menu, workspace, this);
  plus->setMenu(menu);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(4, 2, 4, 2);
  head->addWidget(pattern_, 1);
  head->addWidget(plus);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(0);
  all->addLayout(head);
  all->addWidget(tree_, 1);
  setFocusProxy(tree_);
  connect(pattern_, &QLineEdit::textChanged, model_, &OutlinerModel::filter);
  connect(&workspace, &Workspace::document_changed, model_, [this] {
    model_->follow_document();
    tree_->viewport()->update();
  });
  connect(&workspace, &Workspace::time_changed, model_, [this] {
    model_->follow_time();
    tree_->viewport()->update();
  });
}

QSize Outliner::sizeHint() const { return {22 * fontMetrics().horizontalAdvance('m'), 300}; }

}  // namespace betwixt::studio
