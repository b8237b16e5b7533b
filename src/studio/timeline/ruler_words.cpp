// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The words of recordings, below the bars of their sounds.
#include <QPainter>
#include <algorithm>

#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"
#include "studio/timeline/ruler.h"

namespace betwixt::studio {

// A word has the room until the next one, or until the sound ends.
QRectF Ruler::word_box(const SoundBar& bar, std::size_t word) const {
  const QRectF sound = sound_box(bar);
  const double x = x_of(bar.time_of_word(word));
  const bool last = word + 1 >= bar.heard_words().second;
  const double end = last ? x_of(bar.to) : x_of(bar.time_of_word(word + 1));
  return {x, sound.bottom(), std::max(0.0, end - x), line_height() * 0.9};
}

std::optional<Ruler::WordAt> Ruler::word_at(const QPointF& at) const {
  for (std::size_t i = sounds_.size(); i-- > 0;) {
    const SoundBar& bar = sounds_[i];
    const QRectF sound = sound_box(bar);
    const auto [first, end] = bar.heard_words();
    if (first == end || !QRectF(sound.left(), sound.bottom(), sound.width(), line_height() * 0.9).contains(at))
      continue;
    const double second = bar.own + (time_at(at.x()) - bar.from).seconds();
    const auto& words = bar.words->words;
    const auto behind = std::ranges::upper_bound(words, second, {}, &SpokenWord::start);
    const auto word = static_cast<std::size_t>(behind - words.begin());
    if (word > first && word <= end) return WordAt{i, word - 1};
  }
  return std::nullopt;
}

// Each word is at its time; what has no room is cut off. Words that are nearer than a pixel or two are marks only.
void Ruler::paint_words(QPainter& p, const SoundBar& bar) const {
  const Colors& c = colors();
  const auto [first, end] = bar.heard_words();
  double free = axis_.gutter();  // where the last mark ends
  for (std::size_t i = first; i < end; ++i) {
    const QRectF box = word_box(bar, i);
    if (box.left() > width()) break;
    if (box.right() < free) continue;
    free = box.left() + 2;
    p.fillRect(QRectF(box.left(), box.top(), 1, box.height()), c.accent);
    if (box.width() < fontMetrics().averageCharWidth()) continue;
    p.save();
    p.setClipRect(box.adjusted(0, 0, -1, 0), Qt::IntersectClip);
    p.setPen(c.text);
    p.drawText(QPointF(box.left() + 3, box.center().y() + fontMetrics().ascent() / 2.0 - 1),
               text_of(bar.words->words[i].text));
    p.restore();
  }
}

}  // namespace betwixt::studio
