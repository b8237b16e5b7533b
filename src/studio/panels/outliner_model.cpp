// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/outliner_model.h"

#include <algorithm>

#include "base/names.h"
#include "scene/own_kinds.h"
#include "studio/shell/theme.h"
#include "studio/viewport/kind_icons.h"

namespace betwixt::studio {
namespace {

std::vector<ObjectId> named(const Document& d, const std::string& pattern) {
  std::vector<ObjectId> all = objects(d, pattern);
  if (all.empty() && !is_pattern(pattern))  // part of a name
    for (const ObjectId id : objects(d))
      if (d.name(id).find(pattern) != std::string::npos) all.push_back(id);
  return all;
}

}  // namespace

OutlinerModel::OutlinerModel(Workspace& workspace, QObject* parent)
    : QAbstractItemModel(parent), workspace_(workspace) {
  make();
}

// Computes the parent of each object now, and the time in which the tree is valid.
void OutlinerModel::make() {
  const Document& d = workspace_.document();
  const Time now = workspace_.time();
  const std::size_t count = d.scene().objects.size();
  std::vector<Node> nodes(count + 1);
  from_ = earliest_time, until_ = latest_time;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Object& o = d.scene().objects[i];
    if (o.removed) continue;
    nodes[i].there = true;
    const Slot* slot = o.find(fn::attachment);
    if (!slot) continue;
    for (const AttachmentSpan& s : attachments(d, {i})) {
      if (s.from > now) {
        until_ = std::min(until_, s.from);
        break;
      }
      from_ = std::max(from_, s.from);
      nodes[i].parent = s.to.kind >= AttachmentKind::hang ? s.to.parent : ObjectId{};
    }
  }
  const std::string pattern = pattern_.trimmed().toStdString();
  if (!pattern.empty()) {
    for (Node& n : nodes) n.wanted = false;
    for (ObjectId id : named(d, pattern))
      for (int deep = 0; id && deep < 10'000 && !nodes[id.index].wanted; ++deep, id = nodes[id.index].parent)
        nodes[id.index].wanted = true;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    Node& n = nodes[i];
    if (!n.there || !n.wanted) continue;
    if (n.parent && (n.parent.index >= count || !nodes[n.parent.index].there)) n.parent = {};
    Node& holder = nodes[n.parent ? n.parent.index : count];
    n.row = static_cast<int>(holder.children.size());
    holder.children.push_back({i});
  }
  if (nodes == nodes_) return;
  beginResetModel();
  nodes_ = std::move(nodes);
  endResetModel();
}

void OutlinerModel::follow_document() { make(); }
void OutlinerModel::follow_time() {
  if (workspace_.time() < from_ || workspace_.time() >= until_) make();
}

void OutlinerModel::filter(const QString& pattern) {
  pattern_ = pattern;
  make();
}

const OutlinerModel::Node* OutlinerModel::node(ObjectId id) const {
  const bool known = !nodes_.empty() && id.index < nodes_.size() - 1;
  return known && nodes_[id.index].there && nodes_[id.index].wanted ? &nodes_[id.index] : nullptr;
}

ObjectId OutlinerModel::object(const QModelIndex& i) const {
  return i.isValid() ? ObjectId{static_cast<std::uint32_t>(i.internalId())} : ObjectId{};
}

QModelIndex OutlinerModel::index_of(ObjectId id, int column) const {
  const Node* n = node(id);
  return n ? createIndex(n->row, column, static_cast<quintptr>(id.index)) : QModelIndex();
}

QModelIndex OutlinerModel::index(int row, int column, const QModelIndex& parent) const {
  const Node& n = parent.isValid() ? nodes_[object(parent).index] : nodes_.back();
  if (row < 0 || row >= static_cast<int>(n.children.size()) || column < 0 || column > eye) return {};
  return createIndex(row, column, static_cast<quintptr>(n.children[static_cast<std::size_t>(row)].index));
}

QModelIndex OutlinerModel::parent(const QModelIndex& i) const {
  const Node* n = node(object(i));
  return n && n->parent ? index_of(n->parent) : QModelIndex();
}

int OutlinerModel::rowCount(const QModelIndex& parent) const {
  if (parent.column() > 0) return 0;
  const Node* n = parent.isValid() ? node(object(parent)) : &nodes_.back();
  return n ? static_cast<int>(n->children.size()) : 0;
}

bool OutlinerModel::shown(ObjectId id) const {
  const Value v = workspace_.program().read(Target(id, fn::display), workspace_.time());
  const auto* on = std::get_if<bool>(&v);
  return !on || *on;
}

QVariant OutlinerModel::data(const QModelIndex& i, int role) const {
  const ObjectId id = object(i);
  const Document& d = workspace_.document();
  if (d.name(id).empty()) return {};
  const Kind k = kind(d, id);
  if (i.column() == eye) {
    if (role == Qt::DecorationRole && placed(k)) return eye_icon(shown(id));
    if (role == Qt::ToolTipRole && placed(k))
      return QString::fromStdString((shown(id) ? "hide " : "show ") + d.name(id));
    if (role == Qt::AccessibleTextRole && placed(k)) return shown(id) ? tr("shown") : tr("hidden");
    return {};
  }
  const QString full = QString::fromStdString(d.name(id));
  if (role == Qt::EditRole) return full;
  if (role == Qt::DisplayRole) {  // below the parent, leave out its part of the name
    const QString above = QString::fromStdString(d.name(node(id) ? node(id)->parent : ObjectId{})) + "/";
    return above.size() > 1 && full.startsWith(above) ? full.mid(above.size()) : full;
  }
  if (role == Qt::DecorationRole) return kind_icon(k);
  if (role == Qt::ToolTipRole || role == Qt::AccessibleDescriptionRole) {
    const OwnKind* own = d.scene().kinds->of(id);
    return full + ", " + QString::fromStdString(a_kind(k)) +
           (own ? tr(", of the kind %1").arg(QString::fromStdString(own->name)) : QString());
  }
  if (role == Qt::ForegroundRole && (derived(d, id) || (placed(k) && !shown(id)))) return colors().dim;
  return {};
}

bool OutlinerModel::setData(const QModelIndex& i, const QVariant& value, int role) {
  const std::string now = value.toString().trimmed().toStdString(), was = workspace_.name(object(i));
  if (role != Qt::EditRole || now.empty() || now == was) return false;
  return workspace_.say("rename " + was + " " + now);
}

Qt::ItemFlags OutlinerModel::flags(const QModelIndex& i) const {
  if (!i.isValid()) return {};
  const Qt::ItemFlags all = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  return i.column() == name && !derived(workspace_.document(), object(i)) ? all | Qt::ItemIsEditable : all;
}

}  // namespace betwixt::studio
