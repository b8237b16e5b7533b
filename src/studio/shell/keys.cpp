// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/keys.h"

#include <QKeyEvent>
#include <QRegularExpression>
#include <QSettings>
#include <algorithm>

#include "studio/objects/object_actions.h"
#include "studio/shell/actions.h"
#include "studio/shell/text_of.h"

namespace betwixt::studio {
namespace {

constexpr std::string_view everywhere = "everywhere";

const KeyPlace& key_place(std::string_view name) { return *std::ranges::find(key_places(), name, &KeyPlace::name); }

bool overlap(std::string_view one, std::string_view other) {
  if (one == other) return true;
  // The panels with objects do not claim these keys before the window.
  if ((one == "objects" && other == everywhere) || (one == everywhere && other == "objects")) return true;
  const auto& others = key_place(other).widgets;
  return std::ranges::any_of(key_place(one).widgets,
                             [&](std::string_view w) { return std::ranges::find(others, w) != others.end(); });
}

// The rows of the window's actions and of the actions on objects, and those of the panels. An action that has a row in
// a panel has no other.
std::vector<KeyRow> all_key_rows() {
  std::vector<KeyRow> all;
  const auto in_panel = [](std::string_view name) {
    return std::ranges::any_of(panel_keys(), [&](const KeyRow& r) { return !r.fixed && r.name == name; }) ||
           std::ranges::any_of(ObjectActions::rows(), [&](const auto& r) { return r.name == name; });
  };
  for (const ActionRow& row : action_rows())
    if (!row.keys.empty() || !in_panel(row.name))
      all.push_back({everywhere, row.name, row.keys, row.sentence, false, row.menu});
  for (const ObjectActions::Row& row : ObjectActions::rows())
    all.push_back({"objects", row.name, row.key, row.sentence});
  all.insert(all.end(), panel_keys().begin(), panel_keys().end());
  return all;
}

}  // namespace

QString KeyRow::id() const {
  QString words = text_of(place) + "." + text_of(name).toLower().remove("…");
  return words.replace(' ', '-');
}

QList<QKeySequence> keys_from(const QString& words) {
  QList<QKeySequence> all;
  for (const QString& k : words.split("; ", Qt::SkipEmptyParts))
    all.push_back(QKeySequence(k, QKeySequence::PortableText));
  return all;
}

QString words_of_keys(const QList<QKeySequence>& keys, QKeySequence::SequenceFormat format) {
  QStringList all;
  for (const QKeySequence& k : keys) all << k.toString(format);
  return all.join("; ");
}

QKeyCombination key_of(const QKeyEvent& e) {
  int key = e.key();
  if (key == Qt::Key_Enter) key = Qt::Key_Return;
  if (key == Qt::Key_Backtab) key = Qt::Key_Tab;
  return QKeyCombination(e.modifiers() & ~(Qt::KeypadModifier | Qt::GroupSwitchModifier), static_cast<Qt::Key>(key));
}

Keys::Keys() : rows_(all_key_rows()) {}

Keys& Keys::of_user() {
  static Keys keys;
  return keys;
}

const KeyRow* Keys::row(std::string_view place, std::string_view name) const {
  const auto found = std::ranges::find_if(rows_, [&](const KeyRow& r) { return r.place == place && r.name == name; });
  return found == rows_.end() ? nullptr : &*found;
}

QList<QKeySequence> Keys::preset_keys(const KeyRow& row) const {
  for (const KeyPreset& p : key_presets())
    if (text_of(p.name) == preset_)
      for (const KeyPreset::Key& k : p.changed)
        if (k.place == row.place && k.name == row.name) return keys_from(text_of(k.keys));
  return keys_from(text_of(row.keys));
}

QList<QKeySequence> Keys::keys(const KeyRow& row) const {
  if (!row.fixed && !own_.empty()) {
    const auto own = std::ranges::find(own_, row.id(), &std::pair<QString, QString>::first);
    if (own != own_.end()) return keys_from(own->second);
  }
  return preset_keys(row);
}

QString Keys::shown(std::string_view name) const {
  for (const KeyRow& r : rows_) {
    if (r.name != name || r.fixed) continue;
    if (const auto all = keys(r); !all.isEmpty()) return all.front().toString(QKeySequence::NativeText);
  }
  return {};
}

QString with_keys(const QString& text) {
  static const QRegularExpression action("\\{([^{}]+)\\}");
  QString out;
  qsizetype from = 0;
  for (auto i = action.globalMatch(text); i.hasNext();) {
    const QRegularExpressionMatch m = i.next();
    const std::string name = m.captured(1).toStdString();
    const QString key = Keys::of_user().shown(name);
    out += text.mid(from, m.capturedStart() - from) + (key.isEmpty() ? "'" + word_of(name) + "'" : key);
    from = m.capturedEnd();
  }
  return out + text.mid(from);
}

bool Keys::is_changed(const KeyRow& row) const {
  return std::ranges::find(own_, row.id(), &std::pair<QString, QString>::first) != own_.end();
}

std::vector<const KeyRow*> Keys::conflicts(const KeyRow& row, const QKeySequence& key) const {
  std::vector<const KeyRow*> all;
  for (const KeyRow& r : rows_)
    if (&r != &row && r.id() != row.id() && overlap(r.place, row.place) && keys(r).contains(key)) all.push_back(&r);
  return all;
}

const KeyRow* Keys::hidden_by(const KeyRow& row, const QKeySequence& key) const {
  if (row.place != everywhere) return nullptr;
  for (const KeyRow& r : rows_)
    if (r.place != everywhere && r.place != "objects" && !r.fixed && keys(r).contains(key)) return &r;
  return nullptr;
}

void Keys::keep(const QString& name, const QVariant& value) const {
  if (!remembers_) return;
  QSettings settings("betwixt", "studio");
  value.isNull() ? settings.remove("keys/" + name) : settings.setValue("keys/" + name, value);
}

void Keys::set(const KeyRow& row, const QList<QKeySequence>& keys) {
  const QString id = row.id(), words = words_of_keys(keys);
  std::erase_if(own_, [&](const auto& own) { return own.first == id; });
  const bool differs = keys != preset_keys(row);
  if (differs) own_.emplace_back(id, words);
  keep(id, differs ? QVariant(words) : QVariant());
  emit changed();
}

void Keys::reset(const KeyRow& row) { set(row, preset_keys(row)); }

void Keys::reset_all() {
  for (const auto& [id, words] : own_) keep(id, {});
  own_.clear();
  emit changed();
}

void Keys::set_preset(const QString& name) {
  const bool known = std::ranges::any_of(key_presets(), [&](const KeyPreset& p) { return text_of(p.name) == name; });
  preset_ = known ? name : "betwixt";
  keep("preset", preset_ == "betwixt" ? QVariant() : QVariant(preset_));
  emit changed();
}

// Whatever the file holds, the studio starts: what is not a key or no row is left out.
void Keys::recall() {
  remembers_ = false;
  own_.clear(), preset_ = "betwixt";
  QSettings settings("betwixt", "studio");
  settings.beginGroup("keys");
  set_preset(settings.value("preset").toString());
  for (const KeyRow& r : rows_) {
    if (r.fixed || !settings.contains(r.id())) continue;
    const QString words = settings.value(r.id()).toString();
    if (words_of_keys(keys_from(words)) == words) own_.emplace_back(r.id(), words);
  }
  remembers_ = true;
  emit changed();
}

std::optional<QKeyCombination> Keys::translated(const QString& widget, QKeyCombination pressed) const {
  if (preset_ == "betwixt" && own_.empty()) return pressed;
  const QKeySequence key(pressed);
  bool gone = false, known = false;
  for (const KeyRow& r : rows_) {
    const auto& widgets = key_place(r.place).widgets;
    const bool here = std::ranges::any_of(widgets, [&](std::string_view w) { return text_of(w) == widget; });
    if (!here && r.place != everywhere) continue;
    known = known || here;
    const QList<QKeySequence> first = keys_from(text_of(r.keys));
    const bool is = keys(r).contains(key);
    if (here && is) return first.contains(key) || first.isEmpty() ? pressed : first.front()[0];
    gone = gone || (!is && first.contains(key));
  }
  return known && gone ? std::nullopt : std::optional(pressed);
}

}  // namespace betwixt::studio
