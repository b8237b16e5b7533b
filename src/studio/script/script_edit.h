// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The script editor. Each edit shows in the picture at once. Changes from elsewhere replace only the lines that differ.
// It colours only visible lines, so that long scripts stay fast.
#pragma once

#include <QElapsedTimer>
#include <QTextBlock>
#include <map>
#include <optional>

#include "editor/line_pieces.h"
#include "studio/shell/word_edit.h"

namespace betwixt::studio {

class ScriptEdit : public WordEdit {
  Q_OBJECT
 public:
  explicit ScriptEdit(Workspace&, QWidget* parent = nullptr);
  void go_to_line(int line, int column = 1);
  void show_line(int line, int column = 1);  // the same, without the focus
  // A long text comes into the editor part by part.
  bool filling() const { return filled_.has_value(); }
  void fill_all();
  // Returns the worst diagnostic of a line (the first is 1), or nullptr if there is none.
  const Diagnostic* said_of(int line) const;
  // The margin: whether a visible line names a selected object.
  bool speaks(int line) const { return speaking_.contains(line); }
  void paint_margin(QPainter&, QRect);
  int margin_width() const;

 Q_SIGNALS:
  void margin_changed();

 protected:
  std::string said_so_far() const override;
  void keyPressEvent(QKeyEvent*) override;
  void inputMethodEvent(QInputMethodEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void focusOutEvent(QFocusEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void paintEvent(QPaintEvent*) override;
  bool viewportEvent(QEvent*) override;

 private:
  // Between this text and the film's
  void changed_here(int at, int removed, int added);
  void typed();
  void follow_typing(int at, int removed, int added);
  std::string whole_text();
  void pass_on();
  void take_text();
  void fill();
  bool may_type() const;
  void replace(int first_block, const QString& before, const QString& after);
  void flash(int first_block, int blocks);
  void take_diagnostics();
  void cursor_moved();
  // Line states and colours (script_colors.cpp)
  void know_states(int last_block);
  void states_changed(int first_block, int blocks);
  LineState state_above(const QTextBlock&) const;
  std::string opener_above(const QTextBlock&) const;
  void color_what_is_seen();
  void color(QTextBlock, bool row);
  void mark_lines();
  // Numbers that the user drags
  struct Number {
    int block = -1, at = 0, length = 0;  // in UTF-16 units
    QString text;
  };
  std::optional<Number> number_under(const QTextCursor&) const;
  void put_number(Number&, const QString&);

  std::string known_;                  // the film's text, which this editor shows
  std::optional<std::string> typed_;   // a copy of this editor's text, if it is long: see follow_typing()
  std::optional<std::size_t> filled_;  // bytes of `known_` that this editor has, while it is filled
  bool taking_ = false, crlf_ = false;
  int pause_ = 0;  // ms, after the text was passed on
  QElapsedTimer passed_on_;
  QTimer pass_on_soon_, flash_ends_, fills_;
  int stated_ = 0;  // number of blocks with a known state at their end
  bool colored_ = false;
  int colored_from_ = -1, colored_to_ = -1;
  std::multimap<int, const Diagnostic*> of_lines_;
  Diagnostics diagnostics_;
  struct Lines {
    std::vector<int> all;
    bool contains(int line) const { return std::ranges::binary_search(all, line); }
  } speaking_;
  QList<QTextEdit::ExtraSelection> flashing_;
  std::optional<Number> scrubbed_;
  QString scrubbed_from_;
  double scrubbed_x_ = 0;
};

}  // namespace betwixt::studio
