// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a value as rows below its function: each has a switch, its name, its parameters, and buttons to move and
// to remove it.
#pragma once

#include <QToolButton>
#include <QWidget>
#include <memory>
#include <optional>

#include "studio/panels/value_parts.h"

class QCheckBox;
class QLineEdit;
class QVBoxLayout;

namespace betwixt::studio {

class PartsView : public QWidget {
  Q_OBJECT
 public:
  PartsView(Workspace&, const Target& whole, QWidget* parent);
  void refresh(const Target& whole) { whole_ = whole, refresh(); }
  void retire();  // its fields say nothing more, although it still exists
  const std::vector<ValuePart>& parts() const { return parts_; }
  // Returns the first field of a part that was not there before; null if there is none.
  QWidget* first_new_field(const std::vector<ValuePart>& before) const;

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  struct PartRow {
    QWidget* box = nullptr;
    QCheckBox* on = nullptr;
    QToolButton *title = nullptr, *key = nullptr, *up = nullptr, *down = nullptr, *remove = nullptr;
    std::vector<std::vector<QLineEdit*>> fields;  // by field and number
  };
  void refresh();
  void rebuild();
  PartRow make_row(std::size_t part);
  void add_fields(std::size_t part, PartRow&, QVBoxLayout& lines);
  QLineEdit* make_field(std::size_t part, std::size_t field, std::size_t number, QWidget* parent);
  void show_row(std::size_t part);
  Lines changed(std::size_t part, std::size_t field, std::size_t number, const QString& text) const;
  void say(const Lines&);
  void go_to(std::size_t part);
  void remove(std::size_t part);
  void key_weight(std::size_t part);
  bool weight_event_here(const ValuePart&) const;
  std::optional<std::size_t> neighbour(std::size_t part, int by) const;
  // Drags of a row by its grip.
  QWidget* make_grip(QWidget* row);
  std::size_t place_under(int y) const;
  void drag_to(int y);
  void end_drag(bool carry_out);

  Workspace& workspace_;
  Target whole_;
  std::vector<ValuePart> parts_;
  std::vector<PartRow> rows_;
  std::vector<std::string> built_;  // the rows as built
  QVBoxLayout* column_;
  struct RowDrag {
    std::size_t from, to;
  };
  std::optional<RowDrag> drag_;
  QWidget* mark_ = nullptr;  // where the dragged row would be
};

}  // namespace betwixt::studio
