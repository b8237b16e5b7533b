// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which pictures are asked for, shown and kept.
#include <algorithm>

#include "studio/viewport/viewport.h"

namespace betwixt::studio {

PictureWanted Viewport::wanted() {
  const QSize size = picture_box().size() * devicePixelRatioF();
  RenderOptions o;
  o.width = std::clamp(size.width(), 1, 8192), o.height = std::clamp(size.height(), 1, 8192);
  o.style = style_;
  o.device = Device::automatic;
  o.linear = workspace_.document().transparent();  // otherwise the picture is opaque
  ++asked_;
  if (!side_ && kept_.use({workspace_.program(), o, through_ ? std::nullopt : free_, through_, workspace_.left_out()}))
    show_kept();
  // What is shown changes with these: earlier pictures are not kept.
  if (kept_.empty()) kept_since_ = asked_;
  // While a button is down anywhere, or while the film plays, other pictures are about to follow.
  const bool moves = QGuiApplication::mouseButtons() != Qt::NoButton || pull_ || workspace_.playhead().playing();
  return {workspace_.program(), workspace_.time(), o, own_eye(workspace_.time()), workspace_.left_out(), asked_, moves};
}

void Viewport::ask() {
  if (!isVisible()) return;
  PictureWanted next = wanted();
  const PictureMade* kept = kept_.at(next.time);
  if (!kept || (kept->draft && !workspace_.playhead().playing())) return maker_.want(std::move(next));
  maker_.want_nothing();
  PictureMade made = *kept;
  made.number = next.number;
  take_picture(made);
}

void Viewport::take_picture(const PictureMade& made) {
  if (made.number < shown_.number) return;  // made late, after a kept one was shown
  keep(made);
  shown_ = made;
  if (workspace_.playhead().playing()) forget();
  if (!side_) workspace_.picture_shown();
  update();
  emit picture_came(made);
  if (fills_ && !made.draft) fill_next();
}

void Viewport::await_picture() { take_picture(PictureMaker::make(wanted())); }

// Keeps pictures of whole frames. Drafts are kept while the film plays, because another round may have no time either.
void Viewport::keep(const PictureMade& made) {
  const Rate rate = workspace_.document().rate();
  const bool on_frame = rate.frame(std::round(rate.frame_number(made.time))) == made.time;
  if (side_ || made.image.isNull() || made.number < kept_since_ || !on_frame || workspace_.looks_ahead()) return;
  if (made.draft && !workspace_.playhead().playing()) return;
  const PictureMade* known = kept_.at(made.time);
  if (known && known->draft == made.draft) return;
  if (!kept_.keep(made) && fills_) {
    fills_ = false;
    refusal_ = tr("the memory for pictures is full: a smaller picture or a shorter part leaves room");
  }
  show_kept();
}

// Tells the ruler.
void Viewport::show_kept() { workspace_.set_kept(kept_.list()); }

void Viewport::fill_memory() {
  workspace_.pause();
  refusal_.clear();
  fills_ = !fills_;
  if (fills_) fill_next();
  update();
}

void Viewport::fill_next() {
  const Playhead& part = workspace_.playhead();
  const Rate rate = part.rate();
  std::optional<Time> missing;
  const int last = static_cast<int>(std::floor(rate.frame_number(part.last())));
  for (int f = static_cast<int>(std::ceil(rate.frame_number(part.first()))); f <= last && !missing; ++f)
    if (const PictureMade* kept = kept_.at(rate.frame(f)); !kept || kept->draft) missing = rate.frame(f);
  if (!missing) fills_ = false;
  fills_by_itself_ = true;
  workspace_.go_to(missing.value_or(part.first()));
  fills_by_itself_ = false;
  missing ? ask() : workspace_.play(1);
}

}  // namespace betwixt::studio
