// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which key does what. Every key is a row of one table: menus, the list of keys and the preferences are made from it.
// The user can choose a preset and change any key; the settings file keeps only the differences.
//
// Panels know only the first keys of their rows. If a key has been changed, KeyFocus translates what the user presses.
#pragma once

#include <QKeySequence>
#include <QObject>
#include <QStringList>
#include <optional>
#include <string_view>
#include <vector>

class QKeyEvent;

namespace betwixt::studio {

struct KeyRow {
  std::string_view place;  // one of key_places()
  std::string_view name, keys, sentence;
  bool fixed = false;  // part of a way of working, such as typing; cannot be changed
  std::string_view menu = {};
  // The row in the settings file: "picture.frame-selection".
  QString id() const;
};

// Where a key counts. Several places can belong to one panel.
struct KeyPlace {
  std::string_view name, title;
  std::vector<std::string_view> widgets;  // their object names; none: the whole window
};
const std::vector<KeyPlace>& key_places();
const std::vector<KeyRow>& panel_keys();  // the keys that panels handle themselves

struct KeyPreset {
  struct Key {
    std::string_view place, name, keys;
  };
  std::string_view name, title;
  std::vector<Key> changed;
};
const std::vector<KeyPreset>& key_presets();

class Keys : public QObject {
  Q_OBJECT
 public:
  static Keys& of_user();

  const std::vector<KeyRow>& rows() const { return rows_; }
  const KeyRow* row(std::string_view place, std::string_view name) const;
  // The present keys of a row: "Ctrl+Z", "Ctrl+U".
  QList<QKeySequence> keys(const KeyRow&) const;
  // The first key of an action as menus show it; "" if it has none. Looks in all places.
  QString shown(std::string_view name) const;
  bool is_changed(const KeyRow&) const;  // by the user, not by the preset
  // Returns the rows that have the key in a place where this row counts too.
  std::vector<const KeyRow*> conflicts(const KeyRow&, const QKeySequence&) const;
  // Returns the row in another place that hides the key of a row for the whole window, if there is one.
  const KeyRow* hidden_by(const KeyRow&, const QKeySequence&) const;

  void set(const KeyRow&, const QList<QKeySequence>&);
  void reset(const KeyRow&);
  void reset_all();
  QString preset() const { return preset_; }
  void set_preset(const QString&);

  // Reads the settings file, and from then on keeps all changes there.
  void recall();

  // Returns the key that a widget knows for a key that the user has pressed in it: the same one if nothing is changed.
  // nullopt: the key does nothing there any more.
  std::optional<QKeyCombination> translated(const QString& widget, QKeyCombination) const;

 Q_SIGNALS:
  void changed();

 private:
  Keys();
  void keep(const QString& name, const QVariant&) const;
  QList<QKeySequence> preset_keys(const KeyRow&) const;

  std::vector<KeyRow> rows_;
  QString preset_ = "betwixt";
  std::vector<std::pair<QString, QString>> own_;  // the user's keys, by id
  bool remembers_ = false;
};

// Returns a text in which each "{Handles to move}" is the present key of that action; its name if it has no key.
QString with_keys(const QString& text);

// Returns the key of an event without what does not matter, such as whether it is on the keypad.
QKeyCombination key_of(const QKeyEvent&);
// "Ctrl+Z; Ctrl+Y" as keys, and back.
QList<QKeySequence> keys_from(const QString&);
QString words_of_keys(const QList<QKeySequence>&, QKeySequence::SequenceFormat = QKeySequence::PortableText);

}  // namespace betwixt::studio
