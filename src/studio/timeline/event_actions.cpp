// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/event_actions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <QApplication>
#include <QMenu>
#include <algorithm>

#include "betwixt/object.h"
#include "editor/made_by.h"
#include "scene/document.h"
#include "studio/curves/curve_actions.h"
#include "studio/objects/object_lines.h"
#include "studio/shell/text_of.h"
#include "studio/timeline/key_lines.h"
#include "studio/timeline/twerper_grid.h"
#include "track/twerpers.h"

namespace betwixt::studio {
namespace {

// Says that code makes a value, so that an event has no effect there.
void tell_of_code(Workspace& workspace, const QString& words) { emit workspace.said({}, words + "\n", true); }

}  // namespace

EventActions::EventActions(Workspace& workspace) : QObject(&workspace), workspace_(workspace) {}

EventActions& EventActions::of(Workspace& workspace) {
  if (auto* hands = workspace.findChild<EventActions*>(QString(), Qt::FindDirectChildrenOnly)) return *hands;
  return *new EventActions(workspace);
}

bool EventActions::retime(const Lines& lines, const std::function<Time(Time)>& when) {
  if (lines.empty()) return false;
  std::vector<EventAt> events = workspace_.events_selected();
  if (!workspace_.say(lines)) return false;
  for (EventAt& e : events) e.time = when(e.time);
  workspace_.select_events(std::move(events));
  return true;
}

void EventActions::move(Time by) {
  retime(move_lines(workspace_.document(), workspace_.events_selected(), by), [by](Time t) { return t + by; });
}

void EventActions::clear() {
  if (const Lines lines = clear_lines(workspace_.document(), workspace_.events_selected()); !lines.empty())
    workspace_.say(lines);
}

void EventActions::reverse() {
  const auto [first, last] = span(workspace_.events_selected());
  retime(reverse_lines(workspace_.document(), workspace_.events_selected()),
         [from = first, to = last](Time t) { return from + (to - t); });
}

void EventActions::copy() { kept_ = workspace_.document(), copied_ = workspace_.events_selected(); }

void EventActions::select_copies(const std::vector<EventAt>& events, Time to, ObjectId onto) {
  std::vector<EventAt> copies = events;
  const Time first = span(events).first;
  for (EventAt& e : copies) {
    e.time = to + (e.time - first);
    if (onto) e.target.object = onto;
  }
  workspace_.select_events(std::move(copies));
}

void EventActions::paste() {
  if (copied_.empty()) return;
  // If the copied events belong to one object, and another one is selected, paste onto that.
  const ObjectId of = copied_.front().target.object;
  const bool one = std::ranges::all_of(copied_, [&](const EventAt& e) { return e.target.object == of; });
  ObjectId onto;
  if (one && workspace_.selected().size() == 1 && workspace_.selected().back() != of)
    onto = workspace_.selected().back();
  const Time to = workspace_.time();
  if (workspace_.say(copy_lines(workspace_.document(), kept_, copied_, to, onto))) select_copies(copied_, to, onto);
}

void EventActions::duplicate() {
  const std::vector<EventAt> events = workspace_.events_selected();
  if (events.empty()) return;
  const auto [first, last] = span(events);
  const Time to = first == last ? last + workspace_.document().rate().span(1) : last;
  if (workspace_.say(copy_lines(workspace_.document(), workspace_.document(), events, to)))
    select_copies(events, to, {});
}

// An event would replace the code for the whole film.
std::vector<Target> EventActions::without_code(std::vector<Target> where) {
  const Document& d = workspace_.document();
  std::erase_if(where, [&](const Target& t) {
    const Target whole(t.object, t.function);
    if (t.layer || made_by(d, whole, workspace_.time()).code.empty()) return false;
    tell_of_code(workspace_,
                 tr("code computes %1; an event would end that").arg(QString::fromStdString(d.name(whole))));
    return true;
  });
  return where;
}

// A group is its parts, as in the sheet.
std::vector<ObjectId> EventActions::with_parts() const {
  return all_below_at(workspace_.document(), workspace_.selected(), workspace_.time());
}

void EventActions::insert_on(const std::vector<Target>& where) {
  if (where.empty() ||
      !workspace_.say(insert_lines(workspace_.document(), workspace_.program(), where, workspace_.time())))
    return;
  std::vector<EventAt> come;
  for (const Target& t : where) come.push_back({t, workspace_.time()});
  workspace_.select_events(std::move(come));
}

void EventActions::insert() {
  insert_on(without_code(animated_tracks(workspace_.document(), workspace_.selected(), true)));
}

void EventActions::insert_transforms() {
  insert_on(without_code(tracks_with_transforms(workspace_.document(), workspace_.selected())));
}

void EventActions::insert_changed() {
  insert_on(changed_tracks(workspace_.program(),
                           without_code(animated_tracks(workspace_.document(), with_parts(), false)),
                           workspace_.time()));
}

void EventActions::insert_character() {
  insert_on(without_code(
      animated_tracks(workspace_.document(),
                      whole_characters(workspace_.document(), workspace_.selected(), workspace_.time()), false)));
}

void EventActions::hold() {
  workspace_.say(hold_lines(workspace_.program(),
                            without_code(animated_tracks(workspace_.document(), with_parts(), false)),
                            workspace_.time()));
}

Lines EventActions::breakdown(double share) {
  return breakdown_lines(workspace_.program(),
                         without_code(animated_tracks(workspace_.document(), with_parts(), false)), workspace_.time(),
                         share);
}

void EventActions::warp(const std::function<double(double)>& share) {
  const Document d = workspace_.document();
  const std::vector<EventAt> events = workspace_.events_selected();
  const auto [first, last] = span(events);
  if (!(last > first)) return;
  const auto when = retiming(d, events, share);
  if (!retime(retime_lines(d, events, when), when)) return;
  if (const auto names = left_behind(d, events, workspace_.time()); !names.empty())
    tell_of_code(workspace_, tr("%1 %2 code or filters with times of their own, which stay as they are")
                                 .arg(QString::fromStdString(fmt::format("{}", fmt::join(names, ", "))),
                                      names.size() == 1 ? tr("has") : tr("have")));
}

void EventActions::go_to_event(int direction) {
  const Document& d = workspace_.document();
  const Time now = workspace_.time();
  std::optional<Time> to;
  for (const ObjectId id : workspace_.selected().empty() ? objects(d) : workspace_.selected())
    for (const TrackView& t : tracks(d, id)) {
      const auto at = direction > 0 ? next_event(d, t.target, now + Time{1}) : event_before(d, t.target, now);
      if (at) to = !to ? *at : direction > 0 ? std::min(*to, *at) : std::max(*to, *at);
    }
  if (to) workspace_.go_to(*to);
}

void EventActions::go_to_note(int direction) {
  const Document& d = workspace_.document();
  const Time now = workspace_.time();
  const auto notes = direction > 0 ? d.notes(now + Time{1}, latest_time) : d.notes(earliest_time, now - Time{1});
  if (!notes.empty()) workspace_.go_to(direction > 0 ? notes.front().time : notes.back().time);
}

void EventActions::twerper(const std::string& name) {
  if (const Lines lines = twerper_lines(workspace_.document(), workspace_.events_selected(), name); !lines.empty())
    workspace_.say(lines);
}

void EventActions::extend(const std::string& how, const std::string& side) {
  Lines lines;
  for (const Picked& p : by_track(workspace_.events_selected()))
    lines.push_back(fmt::format("{}extend {} {}{}", layer_words(workspace_.document(), p.target),
                                workspace_.document().name(p.target), how, side.empty() ? "" : " " + side));
  if (!lines.empty()) workspace_.say(lines);
}

bool EventActions::key(int key, Qt::KeyboardModifiers with, bool act) {
  const bool any = !workspace_.events_selected().empty(), ctrl = with == Qt::ControlModifier,
             plain = with == Qt::NoModifier;
  const Time frame = workspace_.document().rate().span(1);
  const auto mine = [&](bool is, auto&& does) { return is && (act ? does() : void(), true); };
  switch (key) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
    case Qt::Key_X:
      return mine(plain && any, [&] { clear(); });
    case Qt::Key_R:
      return mine(plain && any, [&] { reverse(); });
    case Qt::Key_C:
      return mine(ctrl && any, [&] { copy(); });
    case Qt::Key_V:
      if (plain) return mine(any, [&] { ask_key_type(workspace_, QApplication::activeWindow()); });
      return mine(ctrl && !copied_.empty(), [&] { paste(); });
    case Qt::Key_T:
      return mine(plain && any, [&] { ask_twerper(workspace_, QApplication::activeWindow()); });
    case Qt::Key_D:
      return mine(ctrl && any, [&] { duplicate(); });
    case Qt::Key_K:
      return mine(plain && !workspace_.selected().empty(), [&] { insert(); });
    case Qt::Key_Left:
      return mine(ctrl && any, [&] { move(-frame); });
    case Qt::Key_Right:
      return mine(ctrl && any, [&] { move(frame); });
    default:
      return false;
  }
}

// Adds a menu row with its script line as the tooltip.
template <class F>
static QAction* row(EventActions* hands, QMenu& in, const QString& what, const QString& keys, const QString& says,
                    F does) {
  in.setToolTipsVisible(true);
  QAction* a = in.addAction(what + (keys.isEmpty() ? "" : "\t" + keys));
  a->setToolTip(says);
  QObject::connect(a, &QAction::triggered, hands, does);
  return a;
}

void EventActions::fill_twerpers(QMenu& menu) {
  row(this, menu, tr("default"), {}, tr("writes no twerper"), [this] { twerper(""); });
  menu.addSeparator();
  const auto choose = [&](QMenu& in, std::string_view name, std::string_view sentence) {
    row(this, in, text_of(name), {}, text_of(sentence), [this, said = std::string(name)] {
      twerper(said);
    })->setIcon(twerper_picture(workspace_.document(), std::string(name)));
  };
  QMenu* easings = new QMenu(tr("easings"), &menu);
  for (const TwerperRow& t : twerpers().subspan(1)) {
    const bool easing = t.name.find('-') != std::string_view::npos && t.name.substr(0, 4) != "ease";
    choose(easing ? *easings : menu, t.name, t.sentence);
  }
  menu.addMenu(easings);
  bool first = true;
  for (const ProcedureView& p : procedures(workspace_.document())) {
    if (p.role != "twerper" && p.role != "tween") continue;
    if (std::exchange(first, false)) menu.addSeparator();
    choose(menu, p.name, p.source);
  }
}

void EventActions::fill(QMenu& menu) {
  const bool any = !workspace_.events_selected().empty();
  QMenu* goes_on = menu.addMenu(tr("Twerper to the next event"));
  fill_twerpers(*goes_on);
  QMenu* outside = menu.addMenu(tr("Extrapolation"));
  for (const std::string how : {"hold", "linear", "cycle", "bounce"})
    for (const std::string side : {"", "before", "after"})
      row(this, *outside, QString::fromStdString(side.empty() ? how : how + " " + side), {},
          QString::fromStdString("extend TARGET " + how + (side.empty() ? "" : " " + side)),
          [this, how, side] { extend(how, side); });
  goes_on->setEnabled(any), outside->setEnabled(any);
  menu.addSeparator();
  row(this, menu, tr("Reverse"), "R", "reverse TARGET A..B", [this] { reverse(); })->setEnabled(any);
  row(this, menu, tr("Copy"), "Ctrl+C", tr("copies the events for 'Paste at playhead'"), [this] {
    copy();
  })->setEnabled(any);
  row(this, menu, tr("Paste at playhead"), "Ctrl+V", "copy TARGET A..B to T", [this] {
    paste();
  })->setEnabled(!copied_.empty());
  row(this, menu, tr("Duplicate after it"), "Ctrl+D", "copy TARGET A..B to B", [this] {
    duplicate();
  })->setEnabled(any);
  row(this, menu, tr("Delete"), "Delete", "clear TARGET A..B", [this] { clear(); })->setEnabled(any);
  menu.addSeparator();
  row(this, menu, tr("Insert event at playhead"), "K", "at T TARGET VALUE", [this] {
    insert();
  })->setEnabled(!workspace_.selected().empty());
}

}  // namespace betwixt::studio
