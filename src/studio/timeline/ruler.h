// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The ruler: the playhead, the part to play, camera cuts and notes.
#pragma once

#include <functional>
#include <vector>

#include "studio/timeline/sound_bars.h"
#include "studio/timeline/time_pane.h"

class QLineEdit;
class QMenu;

namespace betwixt::studio {

// A section as a block. Sections that overlap are in different rows.
struct SectionBlock {
  Section section;
  int row = 0;
};
std::vector<SectionBlock> section_blocks(const std::vector<Section>&);

class Ruler : public TimePane {
  Q_OBJECT
 public:
  explicit Ruler(Workspace&, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {sizeHint().width() / 5, sizeHint().height()}; }
  // Return the boxes for painting and for the mouse.
  QRectF sound_box(const SoundBar&) const;
  const std::vector<SoundBar>& sounds() const { return sounds_; }
  QRectF word_box(const SoundBar&, std::size_t word) const;
  QRectF section_box(const SectionBlock&) const;
  const std::vector<SectionBlock>& sections() const { return sections_; }
  QRectF step_box(std::size_t) const;
  const std::vector<Pause>& steps() const { return steps_; }
  QRectF note_box(Time) const;
  QRect part_box() const;
  void add_note();  // at the playhead: opens a field for its text

 protected:
  void paint_content(QPainter&) override;
  void paint_over(QPainter&) const override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void press(QMouseEvent*) override;
  void drag(QMouseEvent*) override;
  void release(QMouseEvent*) override;
  void hover(QMouseEvent*) override;
  void call_off() override;
  bool key(int, Qt::KeyboardModifiers, bool act) override;

 private:
  void paint_part(QPainter&) const;
  void paint_cuts(QPainter&) const;
  void paint_notes(QPainter&) const;
  void paint_sounds(QPainter&) const;
  void paint_sections(QPainter&) const;
  void paint_steps(QPainter&) const;
  void paint_words(QPainter&, const SoundBar&) const;
  void follow_film();
  void describe();  // for screen readers
  // The tops of the lanes whose number depends on the film, in lines.
  double steps_top() const;
  double sounds_top() const;
  double sound_pitch() const;  // between the rows of sounds
  double bottom() const;
  std::optional<std::size_t> sound_at(const QPointF&) const;
  struct WordAt {
    std::size_t bar, word;
  };
  std::optional<WordAt> word_at(const QPointF&) const;
  std::optional<std::size_t> block_at(const QPointF&) const;
  bool at_section_end(const SectionBlock&, const QPointF&) const;
  std::string section_moving(const QMouseEvent&) const;
  QString section_tip(const SectionBlock&, const QPointF&) const;
  QString step_tip(const Pause&) const;
  std::optional<std::size_t> step_at(const QPointF&) const;
  std::optional<Time> note_at(const QPointF&) const;
  enum class Edge : std::uint8_t { none, first, last };
  Edge edge_at(const QPointF&) const;  // of the film's range
  std::string note_line(const Note&) const;
  void add_colors(QMenu&, Time);  // for the notes at a time
  // Edits the notes at a time. Without `which` it appends one.
  void write_note(Time, std::optional<std::size_t> which);
  void write_step(Time);  // edits the name of the step at a time, or appends one
  // Opens a field over a place of the ruler. `done` gets what was written in it.
  void write_words(const QRect&, const std::string& before, const QString& hint,
                   const std::function<void(const std::string&)>& done);
  Time edge_time(const QMouseEvent&) const;
  std::string moving(const QMouseEvent&) const;  // the line for what is dragged; "" if it would not move

  std::optional<Time> note_;  // the selected one
  std::vector<SoundBar> sounds_;
  std::optional<ObjectId> sound_;  // the dragged one
  Time sound_from_;                // where it began
  std::vector<SectionBlock> sections_;
  std::optional<Section> section_;  // the dragged one, as it was
  bool stretches_ = false;          // its end is dragged
  int section_rows_ = 0;
  bool words_shown_ = false;  // below a sound
  std::vector<Pause> steps_;
  std::optional<Time> step_;     // the selected one
  std::optional<Time> clicked_;  // where a click goes to
  Edge edge_ = Edge::none;       // the dragged one
  std::optional<Time> edge_to_;  // where it is dragged to
  QPointF from_;
  QLineEdit* words_ = nullptr;
};

}  // namespace betwixt::studio
