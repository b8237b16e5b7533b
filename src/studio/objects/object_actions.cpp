// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/objects/object_actions.h"

#include <fmt/format.h>

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QKeyEvent>
#include <QKeySequence>
#include <QMenu>
#include <algorithm>
#include <array>
#include <cmath>

#include "betwixt/math.h"
#include "editor/made_by.h"
#include "scene/document.h"
#include "studio/assets/asset_files.h"
#include "studio/assets/look_lines.h"
#include "studio/objects/staging.h"
#include "studio/shell/keys.h"
#include "studio/viewport/hand.h"

namespace betwixt::studio {

const std::vector<ObjectActions::Row>& ObjectActions::rows() {
  static const std::vector<Row> all = {
      {QT_TR_NOOP("Duplicate"), "Ctrl+D",
       QT_TR_NOOP("Copies the selection with all that hangs on it: `create ball2 like ball`."),
       &ObjectActions::duplicate},
      {QT_TR_NOOP("Duplicate linked"), "Alt+D",
       QT_TR_NOOP("Makes instances, which follow later changes: `define kind ball-kind like ball`."),
       &ObjectActions::instance},
      {QT_TR_NOOP("Cut"), "Ctrl+X", QT_TR_NOOP("Copies the selection and removes it."), &ObjectActions::cut, true},
      {QT_TR_NOOP("Copy"), "Ctrl+C", QT_TR_NOOP("Copies the selection as text of the language."), &ObjectActions::copy},
      {QT_TR_NOOP("Paste"), "Ctrl+V", QT_TR_NOOP("Adds the copied objects, also those of another window."),
       &ObjectActions::paste},
      {QT_TR_NOOP("Group"), "Ctrl+G",
       QT_TR_NOOP("Puts the selection into a group: `couple ball to group1 keep-world`."), &ObjectActions::group, true},
      {QT_TR_NOOP("Ungroup"), "Ctrl+Shift+G", QT_TR_NOOP("Takes the parts out of the group and removes it."),
       &ObjectActions::ungroup},
      {QT_TR_NOOP("Let fall"), "Shift+F",
       QT_TR_NOOP("Lets the selection fall from the playhead on, and bounce: `at 1f fall ball bounce=0.6`."),
       &ObjectActions::fall, true},
      {QT_TR_NOOP("Hide"), "H", QT_TR_NOOP("Hides the selection: `hide ball`."), &ObjectActions::hide, true},
      {QT_TR_NOOP("Show all"), "Alt+H", QT_TR_NOOP("Shows what is hidden for the whole film: `show ball`."),
       &ObjectActions::show_all},
      {QT_TR_NOOP("Remove"), "Del; Backspace", QT_TR_NOOP("Removes the selection: `remove ball`."),
       &ObjectActions::remove, true},
      {QT_TR_NOOP("Remove with all below"), "Shift+Del; Shift+Backspace",
       QT_TR_NOOP("Removes the selection and what hangs on it now."), &ObjectActions::remove_all},
  };
  return all;
}

ObjectActions::ObjectActions(Workspace& workspace) : QObject(&workspace), workspace_(workspace) {}

ObjectActions& ObjectActions::of(Workspace& workspace) {
  if (auto* there = workspace.findChild<ObjectActions*>(QString(), Qt::FindDirectChildrenOnly)) return *there;
  return *new ObjectActions(workspace);
}

bool ObjectActions::key(const QKeyEvent& e) {
  const QKeySequence pressed(key_of(e));
  for (const Row& row : rows())
    if (keys_from(row.key).contains(pressed)) return (this->*row.run)(), true;
  return false;
}

void ObjectActions::fill(QMenu& menu) {
  const bool any = !workspace_.selected().empty();
  menu.setToolTipsVisible(true);
  for (const Row& row : rows()) {
    const bool needs_none = row.run == &ObjectActions::paste || row.run == &ObjectActions::show_all;
    if (row.divides) menu.addSeparator();
    QAction* const action = menu.addAction(tr(row.name), this, [this, run = row.run] { (this->*run)(); });
    action->setEnabled(any || needs_none);
    action->setToolTip(tr(row.sentence));
    action->setShortcut(QKeySequence(Keys::of_user().shown(row.name), QKeySequence::NativeText));
  }
  menu.addSeparator();
  fill_staging(menu, workspace_);
  menu.addSeparator();
  const auto with_axes = [&](const QString& title, std::size_t least, void (ObjectActions::*run)(Axis)) {
    QMenu* const sub = menu.addMenu(title);
    sub->setEnabled(workspace_.selected().size() >= least);
    for (const auto& [axis, name] : {std::pair(Axis::x, "x"), {Axis::y, "y"}, {Axis::z, "z"}})
      sub->addAction(tr("Along %1").arg(name), this, [this, run, axis = axis] { (this->*run)(axis); });
  };
  with_axes(tr("Mirror"), 1, &ObjectActions::mirror);
  with_axes(tr("Align with the last selected"), 2, &ObjectActions::align);
  with_axes(tr("Distribute"), 3, &ObjectActions::distribute);
  QMenu* const shapes = menu.addMenu(tr("Replace shape"));
  shapes->setEnabled(any);
  shapes->addAction(tr("By a file…"), this, [this] { replace_by_file(); });
  shapes->addAction(tr("By its own"), this, [this] { replace(""); });
  shapes->addSeparator();
  for (const char* kind : {"sphere", "box", "cylinder", "cone", "torus", "plane", "star", "gear"})
    shapes->addAction(kind, this, [this, kind] { replace(kind); });
  QMenu* const pivots = menu.addMenu(tr("Pivot"));
  pivots->setEnabled(any);
  pivots->addAction(tr("To the bottom"), this, [this] { pivot(true); });
  pivots->addAction(tr("To the middle"), this, [this] { pivot(false); });
}

void ObjectActions::say(const ObjectEdit& edit) {
  if (edit.lines.empty() || !workspace_.say(edit.lines)) return;
  std::vector<ObjectId> made;
  for (const std::string& name : edit.names)
    if (const ObjectId id = workspace_.document().find(name)) made.push_back(id);
  workspace_.select(std::move(made));
}

void ObjectActions::tell(const QString& why) { emit workspace_.said({}, why, true); }

void ObjectActions::duplicate() { say(duplicate_lines(workspace_.document(), workspace_.selected())); }
void ObjectActions::instance() { say(instance_lines(workspace_.document(), workspace_.selected())); }
void ObjectActions::mirror(Axis axis) { say(mirror_lines(workspace_.document(), workspace_.selected(), axis)); }
void ObjectActions::group() { say(group_lines(workspace_.program(), workspace_.selected(), workspace_.time())); }

void ObjectActions::fall() {
  workspace_.say(fall_lines(workspace_.program(), workspace_.selected(), workspace_.time()));
}

void ObjectActions::align(Axis axis) {
  workspace_.say(
      align_lines(workspace_.program(), workspace_.selected(), axis, workspace_.time(), workspace_.makes_events()));
}
void ObjectActions::distribute(Axis axis) {
  workspace_.say(distribute_lines(workspace_.program(), workspace_.selected(), axis, workspace_.time(),
                                  workspace_.makes_events()));
}

void ObjectActions::pivot(bool at_bottom) {
  const Time t = workspace_.time();
  Lines lines = pivot_lines(workspace_.program(), workspace_.selected(), t, at_bottom);
  if (lines.empty()) return tell(tr("the selection has no shape"));
  const Result<Document> then = workspace_.session().look_ahead(lines);
  if (!then) return tell(QString::fromStdString(then.error().message));
  const Program program = Program::compile(*then);
  for (const ObjectId id : topmost(*then, workspace_.selected()))
    if (const Value was = world(id, t); const auto* place = std::get_if<Matrix>(&was))
      for (std::string& line : lines_to_bring(program, id, **place, t, 1e-6, false)) lines.push_back(std::move(line));
  workspace_.say(lines);
}

void ObjectActions::replace(const std::string& kind) {
  const Lines lines = kind_lines(workspace_.document(), workspace_.selected(), kind);
  lines.empty() ? tell(tr("the selection has no shape to replace")) : void(workspace_.say(lines));
}

void ObjectActions::replace_by_file() {
  if (workspace_.selected().empty()) return tell(tr("select an object first"));
  const QString file = QFileDialog::getOpenFileName(QApplication::activeWindow(), tr("The new shape"), {},
                                                    tr("Meshes (*.obj *.ply *.stl *.3ds *.glb *.gltf *.fbx *.dae)"));
  if (file.isEmpty()) return;
  const Document& d = workspace_.document();
  workspace_.say(
      shape_lines(d, workspace_.selected(), path_from_script(file, workspace_.session().file()), asset_name(file, d)));
}

void ObjectActions::remove() {
  workspace_.say(remove_lines(workspace_.document(), workspace_.selected(), false, workspace_.time()));
}
void ObjectActions::remove_all() {
  workspace_.say(remove_lines(workspace_.document(), workspace_.selected(), true, workspace_.time()));
}

void ObjectActions::copy() {
  const Document& d = workspace_.document();
  if (workspace_.selected().empty()) return;
  const Lines others = lines_to_leave(d, workspace_.selected());
  const Result<Document> rest = others.empty() ? d : workspace_.session().look_ahead(others);
  if (!rest) return tell(QString::fromStdString(rest.error().message));
  QApplication::clipboard()->setText(QString::fromStdString(text_of_objects(*rest)));
}

void ObjectActions::cut() {
  copy();
  remove_all();
}

void ObjectActions::paste() {
  const std::string text = QApplication::clipboard()->text().toStdString();
  const Result<ObjectEdit> edit = paste_lines(workspace_.document(), workspace_.text(), text);
  if (!edit) return tell(tr("the copied text is not of a film: %1").arg(edit.error().message.c_str()));
  if (edit->lines.empty()) return tell(tr("nothing has been copied"));
  say(*edit);
}

void ObjectActions::hide() {
  workspace_.say(display_lines(workspace_.document(), workspace_.selected(), false, workspace_.time()));
}

void ObjectActions::show_all() {
  const Document& d = workspace_.document();
  ObjectEdit edit;
  for (const std::string& name : d.names()) {
    const ObjectId id = d.find(name);
    if (!placed(kind(d, id)) || d.scene().objects[id.index].derived) continue;
    const Target display(id, fn::display);
    if (made_by(d, display, workspace_.time()).events) continue;
    const Value shown = workspace_.program().read(display, workspace_.time());
    if (const bool* is = std::get_if<bool>(&shown); is && !*is)
      edit.lines.push_back("show " + name), edit.names.push_back(name);
  }
  say(edit);
}

Value ObjectActions::world(ObjectId id, Time t) const { return workspace_.program().read(Target(id, Query::world), t); }

Lines ObjectActions::parent_lines(ObjectId id, const Attachment& to) const {
  const Document& d = workspace_.document();
  const Time now = workspace_.time(), first = d.range().first;
  const bool timed = made_by(d, Target(id, fn::attachment), now).events;
  if (timed || to.kind < AttachmentKind::hang || world(to.parent, first) != world(to.parent, now))
    return {line_that_holds(d, id, now, to)};
  // With keep-world the object would stay where it is even if the parent gets another place for the whole film. So it
  // gets its place beside the parent instead, unless events or code place it, or the parent is scaled.
  const Value at = world(id, now), parent = world(to.parent, now);
  const auto *is = std::get_if<Matrix>(&at), *up = std::get_if<Matrix>(&parent);
  const auto free = [&](FunctionId f) {
    const MadeBy made = made_by(d, Target(id, f), now);
    return !made.events && made.code.empty();
  };
  const auto unit = [&](int k) { return std::abs(length(column(**up, k)) - 1) < 1e-9; };
  const Attachment plain{to.kind, to.parent, false};
  if (is && up && free(fn::position) && free(fn::rotation) && free(fn::scale) && unit(0) && unit(1) && unit(2)) {
    Lines lines{line_that_holds(d, id, first, plain)};
    if (const auto then = workspace_.session().look_ahead(lines)) {
      for (std::string& line : lines_to_bring(Program::compile(*then), id, **is, now, 1e-6, false))
        lines.push_back(std::move(line));
      return lines;
    }
  }
  return {line_that_holds(d, id, first, to)};
}

// Detaches the parts of groups. A part that the group has moved since gets its place in the world, if it stands still.
void ObjectActions::ungroup() {
  const Document& d = workspace_.document();
  const Time t = workspace_.time();
  ObjectEdit edit;
  Lines removals;
  std::vector<ObjectId> parts;
  for (const ObjectId id : workspace_.selected()) {
    if (kind(d, id) != Kind::group) continue;
    const std::size_t before = parts.size();
    const auto held = fixed_attachment(d, id);
    for (const std::string& name : d.names())
      for (const ObjectId part = d.find(name); const AttachmentSpan& span : attachments(d, part))
        if (span.to.kind >= AttachmentKind::hang && span.to.parent == id) {
          parts.push_back(part);
          edit.lines.push_back(held ? hold_line(*held, name, d.name(held->parent), held->keep_world)
                                    : "detach " + name);
          edit.names.push_back(name);
          break;
        }
    if (parts.size() > before) removals.push_back("remove " + d.name(id));
  }
  if (parts.empty()) return tell(tr("select a group with parts"));
  const Result<Document> apart = workspace_.session().look_ahead(edit.lines);
  if (!apart) return tell(QString::fromStdString(apart.error().message));
  const Program program = Program::compile(*apart);
  for (const ObjectId part : parts) {
    const Value was = world(part, t), is = program.read(Target(part, Query::world), t);
    const auto *wanted = std::get_if<Matrix>(&was), *found = std::get_if<Matrix>(&is);
    if (!wanted || !found) continue;
    double apart_by = 0;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        apart_by = std::max(apart_by, std::abs((**wanted)(row, column) - (**found)(row, column)));
    if (apart_by < 1e-9) continue;
    const bool moves =
        made_by(*apart, Target(part, fn::position), t).events || made_by(*apart, Target(part, fn::rotation), t).events;
    const ObjectId group = parent_at(d, part, t);
    const bool still = std::ranges::all_of(std::array{fn::position, fn::rotation, fn::scale}, [&](auto f) {
      const MadeBy made = made_by(d, Target(group, f), t);
      return !made.events && made.code.empty();
    });
    const Lines own = moves ? (still ? lines_to_shift(program, part, **found, **wanted, t) : Lines())
                            : lines_to_bring(program, part, **wanted, t, 1e-6, false);
    if (own.empty())
      return tell(tr("%1 has events of its own, and its group has turned or moves: put the group back first")
                      .arg(QString::fromStdString(d.name(part))));
    edit.lines.insert(edit.lines.end(), own.begin(), own.end());
  }
  edit.lines.insert(edit.lines.end(), removals.begin(), removals.end());
  say(edit);
}

}  // namespace betwixt::studio
