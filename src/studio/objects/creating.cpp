// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/objects/creating.h"

#include <fmt/format.h>

#include <QFileDialog>
#include <QMenu>
#include <algorithm>

#include "betwixt/pick.h"
#include "language/values.h"
#include "scene/document.h"
#include "scene/kinds.h"
#include "scene/own_kinds.h"
#include "studio/objects/object_lines.h"
#include "studio/shell/text_of.h"
#include "studio/viewport/kind_icons.h"

namespace betwixt::studio {
namespace {

// If the film has a ground, returns the position in which a new object stands on it.
std::string above_ground(const Workspace& workspace, const std::string& line, const std::string& name) {
  if (!workspace.document().scene().appearance.ground || line.find("position=") != line.npos) return {};
  const auto then = workspace.session().look_ahead({line});
  if (!then) return {};
  const Frame frame = Program::compile(*then).frame(workspace.time());
  double lowest = 0;
  for (const Item& item : frame.items)
    if (item.id == then->find(name))
      for (const Vec3& corner : drawn(item).corners) lowest = std::min(lowest, corner.y);
  return lowest < -1e-9 ? fmt::format(" position=(0 {:.4g} 0)", -lowest) : "";
}

// A first camera sees what stands around the middle; another one looks from where the user looks from.
std::string place_of_camera(const Workspace& workspace) {
  const Frame frame = workspace.program().frame(workspace.time());
  if (!workspace.view() && frame.items.empty()) return " position=(0 2 11) look-at=(0 1.7 0)";
  const Mat4 eye = workspace.view() ? workspace.view()->world : frame.camera.world;
  const Vec3 at = translation_of(eye), to = at - 10 * normalize(Vec3{eye(0, 2), eye(1, 2), eye(2, 2)});
  return fmt::format(" position=({:.4g} {:.4g} {:.4g}) look-at=({:.4g} {:.4g} {:.4g})", at.x, at.y, at.z, to.x, to.y,
                     to.z);
}

// Asks for a file if the kind needs one.
void create_of_kind(Workspace& workspace, const QString& kind, QWidget* over) {
  const std::string name = free_name(workspace.document(), kind.toStdString() + "1");
  std::string line = "create " + name + " " + kind.toStdString();
  if (kind == "text") line += " text=\"text\"";
  if (kind == "camera") line += place_of_camera(workspace);
  if (kind == "light") line += " position=(4 8 6)";  // above, to the right and in front of the middle
  if (kind == "mesh" || kind == "sound") {
    const QString file = QFileDialog::getOpenFileName(over, QObject::tr("The file of %1").arg(text_of(name)));
    if (file.isEmpty()) return;
    line += " file=" + write_text(file.toStdString());
  }
  line += above_ground(workspace, line, name);
  if (workspace.say(line)) workspace.select({workspace.document().find(name)});
}

}  // namespace

void fill_kinds(QMenu& menu, Workspace& workspace, QWidget* over) {
  const auto add = [&workspace, over](QMenu& into, Kind icon, const QString& kind, const QString& tip) {
    into.addAction(kind_icon(icon), kind, over, [&workspace, over, kind] { create_of_kind(workspace, kind, over); })
        ->setToolTip(tip);
  };
  for (const KindRow& row : kinds())
    if (row.placed || row.kind == Kind::sound) add(menu, row.kind, text_of(row.name), text_of(row.sentence));
  menu.setToolTipsVisible(true);
  QObject::connect(&menu, &QMenu::aboutToShow, over, [&menu, &workspace, add, built_in = menu.actions().size()] {
    while (menu.actions().size() > built_in) delete menu.actions().back();
    const Scene& s = workspace.document().scene();
    for (const OwnKind& own : s.kinds->all) {
      const auto& model = s.objects[own.model().index];
      add(menu, model.kind, text_of(own.name), QObject::tr("A kind of this film, like %1").arg(text_of(model.name)));
    }
  });
}

}  // namespace betwixt::studio
