// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The properties of the selected object: its functions, their values now, and what computes them.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QToolButton>
#include <QWidget>

#include "studio/panels/film_settings.h"
#include "studio/panels/parts_view.h"
#include "studio/panels/value_editors.h"

namespace betwixt {
struct ValueSource;
}

namespace betwixt::studio {

class Properties : public QWidget {
  Q_OBJECT
 public:
  explicit Properties(Workspace&, QWidget* parent = nullptr);
  QSize sizeHint() const override;

 protected:
  void showEvent(QShowEvent*) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  struct Row {
    FunctionView of;
    std::string name;  // copied, because the view refers to a document
    EditorKind kind;
    QToolButton* diamond;
    QLabel *called, *made;
    ValueEditor* editor;
    QToolButton *unfold = nullptr, *add = nullptr;
    PartsView* parts = nullptr;  // while it is unfolded
    int at = 0;                  // its row in the grid
    bool said = true, shown_event = false, shown_events = false;
  };
  ObjectId leading() const;
  void refresh();
  void rebuild();
  void show_row(Row&, const Value&);
  void show_sources();
  std::vector<std::string> lines_for(const Row&, int component, const QString& text) const;
  void toggle_event(const Row&);
  static QString words_of(const std::vector<ValueSource>&);
  void add_part_buttons(Row&, QWidget* section);
  void unfold(Row&, bool open);
  void fill_new_parts_of(QMenu&, const Row&);
  void show_new_part(const QString& function, const std::vector<ValuePart>& before);
  void rename();
  QWidget* make_section(const QString& title);
  void add_row(QWidget* section, const FunctionView&, EditorKind);

  Workspace& workspace_;
  QLabel *icon_, *kind_;
  FilmSettings* film_;  // shown if no object is selected
  QScrollArea* film_area_;
  QLineEdit* name_;
  QScrollArea* area_;
  std::vector<std::unique_ptr<Row>> rows_;
  std::vector<std::pair<std::string, EditorKind>> built_;  // the rows as built
  std::optional<Kind> built_of_;
  QStringList folded_;
  QStringList unfolded_;  // functions whose parts are shown
  bool refreshing_ = false;
};

}  // namespace betwixt::studio
