// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/objects/staging.h"

#include <fmt/format.h>

#include <QApplication>
#include <QInputDialog>
#include <QMenu>

#include "betwixt/language.h"
#include "language/values.h"
#include "scene/functions.h"
#include "studio/shell/text_of.h"

namespace betwixt::studio {
namespace {

constexpr StagingRow all_staging[] = {
    {StagingSort::enter, QT_TR_NOOP("Fade in"), "fade-in",
     QT_TR_NOOP("Fades the selection in from the playhead on: `at 24f fade-in ball`."),
     "appear entrance show transparency opacity dissolve"},
    {StagingSort::enter, QT_TR_NOOP("Write"), "write",
     QT_TR_NOOP("Writes texts, formulas and code letter by letter: `at 24f write title`."),
     "appear entrance type typewriter text formula"},
    {StagingSort::enter, QT_TR_NOOP("Draw"), "draw", QT_TR_NOOP("Draws lines from their beginning: `at 24f draw way`."),
     "appear entrance trim path line stroke"},
    {StagingSort::enter, QT_TR_NOOP("Grow"), "grow",
     QT_TR_NOOP("Lets the selection grow from nothing: `at 24f grow ball`."), "appear entrance scale pop zoom"},
    {StagingSort::enter, QT_TR_NOOP("Flip in"), "flip",
     QT_TR_NOOP("Turns the selection in like a card: `at 24f flip card`."), "appear entrance turn card"},
    {StagingSort::enter, QT_TR_NOOP("Wipe in"), "wipe",
     QT_TR_NOOP("Opens the selection along its x axis: `at 24f wipe card`."), "appear entrance open"},
    {StagingSort::leave, QT_TR_NOOP("Fade out"), "fade-out",
     QT_TR_NOOP("Fades the selection out from the playhead on: `at 24f fade-out ball`."),
     "disappear exit hide transparency opacity dissolve"},
    {StagingSort::leave, QT_TR_NOOP("Erase"), "erase",
     QT_TR_NOOP("Takes letters and lines away as they came: `at 24f erase title`."), "disappear exit remove unwrite"},
    {StagingSort::leave, QT_TR_NOOP("Shrink"), "shrink",
     QT_TR_NOOP("Lets the selection shrink to nothing: `at 24f shrink ball`."), "disappear exit scale"},
    {StagingSort::mark, QT_TR_NOOP("Highlight"), "highlight",
     QT_TR_NOOP("Puts a bright sheet behind the selection: `at 24f highlight title`."), "annotate mark point emphasis"},
    {StagingSort::mark, QT_TR_NOOP("Underline"), "underline",
     QT_TR_NOOP("Draws a line under the selection: `at 24f underline title`."), "annotate mark emphasis"},
    {StagingSort::mark, QT_TR_NOOP("Circle around"), "circle-around",
     QT_TR_NOOP("Draws a line around the selection: `at 24f circle-around ball`."),
     "annotate mark encircle frame emphasis", "circle"},
    {StagingSort::mark, QT_TR_NOOP("Cross out"), "cross-out",
     QT_TR_NOOP("Strikes the selection out: `at 24f cross-out title`."), "annotate mark strike wrong", "cross"},
    {StagingSort::mark, QT_TR_NOOP("Spotlight"), "spotlight",
     QT_TR_NOOP("Darkens everything but the selection: `at 24f spotlight ball`."), "annotate mark dim focus emphasis"},
    {StagingSort::unmark, QT_TR_NOOP("Take marks away"), "",
     QT_TR_NOOP("Takes the marks of the selection away: `at 24f underline title off`."),
     "annotate highlight underline spotlight off remove"},
    {StagingSort::text, QT_TR_NOOP("Label…"), "label",
     QT_TR_NOOP("Puts a text beside the selection: `at 24f label ball \"a disc\"`."), "annotate caption text name"},
    {StagingSort::text, QT_TR_NOOP("Callout…"), "callout",
     QT_TR_NOOP("Puts a text near the selection, with a line to it: `at 24f callout ball \"a disc\"`."),
     "annotate label caption text pointer line"},
    {StagingSort::connect, QT_TR_NOOP("Connect straight"), "connect",
     QT_TR_NOOP("Draws an arrow from the first selected object to the second: `connect a to b`."),
     "arrow line link edge"},
    {StagingSort::connect, QT_TR_NOOP("Connect by a curve"), "connect",
     QT_TR_NOOP("Draws a curved arrow from the first selected object to the second: `connect a to b curved`."),
     "arrow line link edge bend", "curved"},
    {StagingSort::connect, QT_TR_NOOP("Connect at right angles"), "connect",
     QT_TR_NOOP("Draws an angled arrow from the first selected object to the second: `connect a to b angled`."),
     "arrow line link edge elbow", "angled"},
    {StagingSort::connect, QT_TR_NOOP("Dimension"), "dimension",
     QT_TR_NOOP("Draws the distance of the two selected objects beside them: `dimension a to b`."),
     "measure length distance size geometry mark"},
    {StagingSort::morph, QT_TR_NOOP("Morph into the second"), "morph",
     QT_TR_NOOP("Turns the first selected object into the second: `at 24f morph a into b`."),
     "transform shape become replace match"},
    {StagingSort::angle, QT_TR_NOOP("Angle"), "angle",
     QT_TR_NOOP("Marks the angle at the second of three selected objects: `angle a b c`."),
     "arc corner degrees theta right geometry mark"},
};

// Returns the words of the marks that an object shows at a time.
std::vector<std::string_view> marks_of(const Program& program, ObjectId id, Time t) {
  const Document& d = program.document();
  std::vector<std::string_view> found;
  for (const StagingRow& row : all_staging) {
    if (row.sort != StagingSort::mark) continue;
    const ObjectId mark = d.find(fmt::format("{}/{}", d.name(id), row.detail.empty() ? row.verb : row.detail));
    const Value shown = mark ? program.read(Target(mark, fn::display), t) : Value();
    const auto* is = std::get_if<bool>(&shown);
    bool any = is && *is;
    if (kind(d, id) == Kind::code && row.verb == "highlight") {  // it may mark lines
      const Value lines = program.read(Target(id, *find_built_in(Kind::code, "lines")), t);
      const auto* from_to = std::get_if<Vec3>(&lines);
      any = any || (from_to && from_to->x > 0);
    }
    if (any) found.push_back(row.verb);
  }
  return found;
}

QString what_is_missing(const StagingRow& row, std::size_t selected) {
  if (selected == 0) return QObject::tr("select an object first");
  if (row.sort == StagingSort::unmark) return QObject::tr("the selection has no marks");
  if (row.sort == StagingSort::angle)
    return QObject::tr("select three objects with Shift; the angle is at the second one");
  return QObject::tr("select two objects: the first one, then with Shift the second");
}

// Asks for the text of a label. Null if the user calls it off.
QString asked_text(const Workspace& workspace, const StagingRow& row) {
  const std::string name = workspace.name(workspace.selected().front());
  bool good = false;
  const QString said = QInputDialog::getText(QApplication::activeWindow(), word_of(row.name),
                                             QObject::tr("The text beside %1").arg(text_of(name)), QLineEdit::Normal,
                                             text_of(name.substr(name.rfind('/') + 1)), &good);
  return good && !said.trimmed().isEmpty() ? said.trimmed() : QString();
}

}  // namespace

std::span<const StagingRow> staging_rows() { return all_staging; }

std::size_t objects_needed(const StagingRow& row) {
  return row.sort == StagingSort::angle ? 3 : row.sort >= StagingSort::connect ? 2 : 0;
}

Lines staging_lines(const StagingRow& row, const Program& program, const std::vector<ObjectId>& objects, Time t,
                    const std::string& text) {
  const Document& d = program.document();
  const std::string at = fmt::format("at {} ", format_time(t, d));
  // What is there from the beginning of the film needs no time.
  const std::string from = t > d.range().first ? at : "";
  Lines lines;
  if (const std::size_t needed = objects_needed(row)) {
    if (objects.size() != needed) return lines;
    const std::string one = d.name(objects[0]), two = d.name(objects[1]);
    if (row.sort == StagingSort::angle) return {fmt::format("{}angle {} {} {}", from, one, two, d.name(objects[2]))};
    if (row.sort == StagingSort::morph) return {fmt::format("{}morph {} into {}", at, one, two)};
    return {fmt::format("{}{} {} to {}{}{}", from, row.verb, one, two, row.detail.empty() ? "" : " ", row.detail)};
  }
  for (const ObjectId id : objects) {
    const std::string name = d.name(id);
    if (row.sort == StagingSort::unmark)
      for (const std::string_view word : marks_of(program, id, t))
        lines.push_back(fmt::format("{}{} {} off", at, word, name));
    else if (row.sort == StagingSort::text)
      lines.push_back(fmt::format("{}{} {} {}", from, row.verb, name, write_text(text)));
    else
      lines.push_back(fmt::format("{}{} {}", at, row.verb, name));
  }
  return lines;
}

void stage(Workspace& workspace, const StagingRow& row) {
  const std::vector<ObjectId>& selected = workspace.selected();
  QString said;
  if (row.sort == StagingSort::text && !selected.empty() && (said = asked_text(workspace, row)).isEmpty()) return;
  const Lines lines = staging_lines(row, workspace.program(), selected, workspace.time(), said.toStdString());
  if (lines.empty()) return Q_EMIT workspace.said({}, what_is_missing(row, selected.size()), true);
  workspace.say(lines);
}

void fill_staging(QMenu& menu, Workspace& workspace) {
  const std::size_t selected = workspace.selected().size();
  struct Part {
    QString title;
    StagingSort first, last;
  };
  const Part parts[] = {{QObject::tr("Bring on"), StagingSort::enter, StagingSort::enter},
                        {QObject::tr("Take off"), StagingSort::leave, StagingSort::leave},
                        {QObject::tr("Point at it"), StagingSort::mark, StagingSort::text},
                        {QObject::tr("Connect and morph"), StagingSort::connect, StagingSort::angle}};
  for (const Part& part : parts) {
    QMenu* const sub = menu.addMenu(part.title);
    sub->setToolTipsVisible(true);
    sub->setEnabled(part.first >= StagingSort::connect ? selected == 2 || selected == 3 : selected > 0);
    for (const StagingRow& row : all_staging)
      if (row.sort >= part.first && row.sort <= part.last) {
        QAction* const action =
            sub->addAction(word_of(row.name), &workspace, [&workspace, &row] { stage(workspace, row); });
        action->setToolTip(word_of(row.sentence));
        action->setEnabled(objects_needed(row) == 0 || objects_needed(row) == selected);
      }
  }
}

}  // namespace betwixt::studio
