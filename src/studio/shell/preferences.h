// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The settings of the user, which no film holds. They are rows of one table, from which the window of preferences is
// made: a new setting needs a row, and one place where it has its effect.
#pragma once

#include <QObject>
#include <QString>
#include <QVariant>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace betwixt::studio {

struct Preference {
  enum class Kind { on_off, choice, percent, fact };
  std::string_view name;  // in the settings file
  std::string_view page, label, sentence;
  Kind kind;
  QVariant initial;
  std::vector<std::pair<std::string_view, std::string_view>> choices = {};  // in the file, in the window
  int low = 0, high = 0;                                                    // of a percentage
};
const std::vector<Preference>& preference_rows();
const Preference* preference(std::string_view name);

class Preferences : public QObject {
  Q_OBJECT
 public:
  static Preferences& of_user();

  // A value that fits the row, whatever the file holds.
  QVariant value(std::string_view name) const;
  bool is_on(std::string_view name) const { return value(name).toBool(); }
  QString word(std::string_view name) const { return value(name).toString(); }
  double share(std::string_view name) const { return value(name).toInt() / 100.0; }  // of a percentage
  void set(std::string_view name, const QVariant&);
  void reset_all();
  // Reads the settings file, and from then on keeps all changes there. Until then everything is as at the first start.
  void recall();

 Q_SIGNALS:
  void changed(const QString& name);

 private:
  std::vector<std::pair<QString, QVariant>> own_;
  bool remembers_ = false;
};

}  // namespace betwixt::studio
