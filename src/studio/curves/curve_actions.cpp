// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/curves/curve_actions.h"

#include <QCursor>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "betwixt/track.h"
#include "studio/poses/trial_dialog.h"
#include "studio/shell/text_of.h"
#include "studio/timeline/axes.h"
#include "studio/timeline/key_types.h"
#include "studio/timeline/simplified.h"
#include "studio/timeline/twerper_grid.h"

namespace betwixt::studio {
namespace {

void tell_why(Workspace& workspace, const QString& words) { emit workspace.said({}, words + "\n", true); }

// The selected events, or all those of the selected objects.
std::vector<EventAt> meant_events(const Workspace& workspace) {
  if (!workspace.events_selected().empty()) return workspace.events_selected();
  const Document& d = workspace.document();
  std::vector<EventAt> all;
  for (const ObjectId id : workspace.selected())
    for (const TrackView& t : tracks(d, id))
      if (t.event_count > 0)
        each_event(d, t.target, t.first, t.last, [&](const EventView& e) { all.push_back({t.target, e.time}); });
  return all;
}

// Compares the values of a target in two films at many times.
bool same_values(const Document& a, const Document& b, const Target& t, const Program& like) {
  const Program one = Program::compile(a, like), two = Program::compile(b, like);
  const auto track = betwixt::track(a, t);
  if (!track) return false;
  const std::int64_t length = std::max<std::int64_t>(1, (track->last - track->first).flicks);
  for (int i = -20; i <= 220; ++i) {
    const Time at = track->first + Time{length / 200 * i};
    const std::vector<double> x = numbers(one.read(t, at)), y = numbers(two.read(t, at));
    for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k)
      if (std::abs(x[k] - y[k]) > 1e-9 * std::max(1.0, std::abs(x[k]))) return false;
    if (x.size() != y.size()) return false;
  }
  return true;
}

}  // namespace

void ask_key_type(Workspace& workspace, QWidget* parent) {
  if (workspace.events_selected().empty()) return tell_why(workspace, QObject::tr("select events first"));
  auto* menu = new QMenu(parent);
  menu->setObjectName("key_types");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  fill_key_types(*menu, workspace);
  menu->popup(QCursor::pos());
}

void ask_twerper(Workspace& workspace, QWidget* parent) {
  if (workspace.events_selected().empty()) return tell_why(workspace, QObject::tr("select events first"));
  TwerperGrid::pop_up(workspace, parent, QCursor::pos());
}

void ask_simplify(Workspace& workspace, QWidget* parent) {
  const std::vector<EventAt> events = meant_events(workspace);
  const Document film = workspace.document();
  if (simplified(film, events, 1e9).gone.empty())
    return tell_why(workspace, QObject::tr("there are no events between others to remove: select some"));
  std::optional<double> known;
  Simplified made;
  const auto at = [&](double tolerance) -> const Simplified& {
    if (known != tolerance) workspace.jobs().carry_out([&] { made = simplified(film, events, tolerance); });
    known = tolerance;
    return made;
  };
  const auto words = [&](double tolerance) {
    const Simplified& now = at(tolerance);
    const QString sentence = now.gone.size() == 1
                                 ? QObject::tr("%1 of %2 events goes. The largest difference is %3 % of the range.")
                                 : QObject::tr("%1 of %2 events go. The largest difference is %3 % of the range.");
    return sentence.arg(now.gone.size()).arg(events.size()).arg(100 * now.error, 0, 'g', 3);
  };
  const auto lines = [&](double tolerance) { return clear_lines(film, at(tolerance).gone); };
  if (const auto tolerance = ask_tolerance(workspace, parent, QObject::tr("Simplify"), 0.01, words, lines))
    workspace.say(lines(*tolerance));
}

void separate_axes(Workspace& workspace) {
  std::vector<Target> targets, separated;
  for (const EventAt& e : meant_events(workspace))
    if (std::ranges::find(targets, e.target) == targets.end()) targets.push_back(e.target);
  std::erase_if(targets, [&](const Target& t) { return !can_separate(workspace.document(), t); });
  if (targets.empty()) return tell_why(workspace, QObject::tr("no selected track has vectors or angles to separate"));
  const std::vector<EventAt> before = workspace.events_selected();
  for (const Target& t : targets) {
    const Document d = workspace.session().document();
    bool done = false;
    for (const Lines& lines : {separate_in_sheets(d, workspace.text(), t), separate_by_event(d, t)}) {
      if (done || lines.empty()) continue;
      const auto then = workspace.session().look_ahead(lines);
      if (then && same_values(d, *then, t, workspace.program())) done = workspace.say(lines);
    }
    if (done)
      separated.push_back(t);
    else
      tell_why(workspace, QObject::tr("%1 would move in another way if its axes were separate")
                              .arg(text_of(workspace.document().name(t))));
  }
  std::vector<EventAt> selected;
  for (const EventAt& e : before) {
    const bool apart = std::ranges::find(separated, e.target) != separated.end();
    if (!apart) selected.push_back(e);
    for (EventAt part = e; apart && part.target.component < 2; selected.push_back(part)) ++part.target.component;
  }
  std::erase_if(selected, [&](const EventAt& e) { return !find_event(workspace.document(), e); });
  workspace.select_events(std::move(selected));
}

void fill_curve_actions(QMenu& menu, Workspace& workspace, QWidget* parent) {
  const bool any = !workspace.events_selected().empty();
  QMenu* types = menu.addMenu(QObject::tr("Handle type") + "\tV");
  fill_key_types(*types, workspace);
  types->setEnabled(any);
  menu.setToolTipsVisible(true);
  const auto add = [&](const QString& name, const QString& tip, std::function<void()> run) {
    QAction* a = menu.addAction(name);
    a->setToolTip(tip);
    QObject::connect(a, &QAction::triggered, parent, std::move(run));
    return a;
  };
  add(QObject::tr("Choose a twerper by its picture…") + "\tT",
      QObject::tr("Twerpers (easings) from each selected event to the next one"),
      [&workspace, parent] { ask_twerper(workspace, parent); })
      ->setEnabled(any);
  add(QObject::tr("Simplify…"), QObject::tr("Removes events that a tolerance makes unnecessary: clear TARGET A..B"),
      [&workspace, parent] { ask_simplify(workspace, parent); });
  add(QObject::tr("Separate axes"),
      QObject::tr("Gives x, y and z tracks of their own, so that one of them can have events at other times"),
      [&workspace] { separate_axes(workspace); });
}

}  // namespace betwixt::studio
