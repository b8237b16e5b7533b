// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/poses/pose_actions.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>

#include "base/files.h"
#include "studio/objects/object_lines.h"
#include "studio/shell/text_of.h"

namespace betwixt::studio {
namespace {

bool is_file_name(const QString& name) {
  return !name.isEmpty() && name.size() <= 100 && !name.startsWith('.') && !name.contains('/') &&
         name.trimmed() == name;
}

}  // namespace

PoseActions::PoseActions(Workspace& workspace) : QObject(&workspace), workspace_(workspace) {
  connect(&workspace, &Workspace::opened, this, &PoseActions::kept_changed);
  connect(&workspace, &Workspace::named, this, &PoseActions::kept_changed);
}

PoseActions& PoseActions::of(Workspace& workspace) {
  if (auto* there = workspace.findChild<PoseActions*>(QString(), Qt::FindDirectChildrenOnly)) return *there;
  return *new PoseActions(workspace);
}

void PoseActions::tell(const QString& why) { emit workspace_.said({}, why + "\n", true); }

ObjectId PoseActions::onto() const {
  const std::vector<ObjectId> roots = topmost(workspace_.document(), workspace_.selected());
  return roots.empty() ? ObjectId{} : roots.front();
}

QString PoseActions::folder() const {
  const QString file = QString::fromStdString(workspace_.session().file());
  return file.isEmpty() ? QString() : QFileInfo(file).absoluteDir().filePath("poses");
}

void PoseActions::copy() {
  const Pose pose = pose_of(workspace_.program(), workspace_.selected(), workspace_.time());
  if (pose.parts.empty()) return tell(tr("select what has a pose: a character, or one of its parts"));
  QApplication::clipboard()->setText(QString::fromStdString(text_of_pose(pose, workspace_.document())));
  emit workspace_.said({}, tr("copied the pose of %1").arg(text_of(pose.root)) + "\n", false);
}

std::optional<Pose> PoseActions::read_text(const std::string& text) {
  const Document& d = workspace_.document();
  const auto trial = [this](const Lines& lines) { return workspace_.session().look_ahead(lines); };
  // The pose of a part of the selected character is for that part. Any other pose is for what is selected.
  Result<Pose> pose = read_pose(text, d, {}, trial);
  const ObjectId to = onto();
  const auto below = with_all_below(d, {to});
  if (to && (!pose || std::ranges::find(below, d.find(pose->root)) == below.end()))
    pose = read_pose(text, d, to, trial);
  if (pose) return *pose;
  const Error& e = pose.error();
  tell(QString::fromStdString(e.message + (e.hint.empty() ? "" : ": " + e.hint)));
  return std::nullopt;
}

Lines PoseActions::lines(const Pose& pose, bool in_mirror, double share) {
  const Program& program = workspace_.program();
  return pose_lines(program, in_mirror ? mirrored(pose, program, workspace_.time()) : pose, {}, workspace_.time(),
                    workspace_.makes_events(), share);
}

void PoseActions::paste(bool in_mirror) {
  const auto pose = read_text(QApplication::clipboard()->text().toStdString());
  if (!pose) return;
  if (!workspace_.say(lines(*pose, in_mirror, 1))) return;
}

bool PoseActions::keep(const QString& name) {
  const auto refuse = [this](const QString& why) { return tell(why), false; };
  if (folder().isEmpty()) return refuse(tr("save the film first: poses are kept in its folder"));
  if (!is_file_name(name)) return refuse(tr("'%1' is no name for a pose").arg(name));
  const Pose pose = pose_of(workspace_.program(), workspace_.selected(), workspace_.time());
  if (pose.parts.empty()) return refuse(tr("select what has a pose: a character, or one of its parts"));
  QDir().mkpath(folder());
  const Status written =
      write_whole(QDir(folder()).filePath(name + ".bx").toStdString(), text_of_pose(pose, workspace_.document()), true);
  if (!written) return refuse(QString::fromStdString(written.error().message));
  emit kept_changed();
  return true;
}

QStringList PoseActions::kept() const {
  QStringList names;
  if (folder().isEmpty()) return names;
  for (const QFileInfo& file : QDir(folder()).entryInfoList({"*.bx"}, QDir::Files, QDir::Name | QDir::LocaleAware))
    names.push_back(file.completeBaseName());
  return names;
}

bool PoseActions::forget(const QString& name) {
  const bool gone = is_file_name(name) && QFile::remove(QDir(folder()).filePath(name + ".bx"));
  emit kept_changed();
  return gone;
}

std::optional<Pose> PoseActions::read(const QString& name) {
  QFile file(QDir(folder()).filePath(name + ".bx"));
  if (!is_file_name(name) || !file.open(QIODevice::ReadOnly))
    return tell(tr("there is no pose '%1'").arg(name)), std::nullopt;
  return read_text(file.read(1 << 20).toStdString());
}

}  // namespace betwixt::studio
