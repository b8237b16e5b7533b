// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/forms.h"

#include <algorithm>

namespace betwixt {
namespace {

constexpr std::uint64_t looked_through_every = 16;  // pictures

}  // namespace

// A blend of outlines or files is made for each request.
bool has_details(const Shape& shape, const Shape* toward) {
  const KindRow& row = row_of(shape.kind);
  return toward == nullptr ? detailed(shape) || row.fill == Fill::file : detailed(shape) && detailed(*toward);
}

Form::Form(std::shared_ptr<const Shape> shape, std::shared_ptr<const Shape> toward, double blend)
    : shape_(std::move(shape)),
      toward_(std::move(toward)),
      blend_(blend),
      detailed_(has_details(*shape_, toward_.get())) {}

const Form::Realised& Form::at(const Detail& asked, Store& store) {
  const Detail detail = detailed_ ? asked : Detail{};
  for (const auto& r : known_)
    if (r->detail == detail) return *r;
  const Geometry g = toward_ != nullptr ? realise_blend(*shape_, *toward_, blend_, detail) : realise(*shape_, detail);
  known_.push_back(std::make_shared<const Realised>(Realised{detail, store.mesh(g.mesh), g.local}));
  return *known_.back();
}

std::shared_ptr<Form> Forms::find(const std::shared_ptr<const Shape>& shape, const std::shared_ptr<const Shape>& toward,
                                  double blend) {
  if (toward != nullptr && blend != 0) return std::make_shared<Form>(shape, toward, blend);
  if (latest_ == shape.get()) return latest_form_;
  Kept& kept = all_[shape.get()];
  kept.used = picture_;
  if (kept.form == nullptr) kept.form = std::make_shared<Form>(shape, nullptr, 0);
  latest_ = shape.get(), latest_form_ = kept.form;
  return kept.form;
}

void Forms::next_picture() {
  latest_ = nullptr, latest_form_ = nullptr;
  if (++picture_ % looked_through_every != 0) return;
  for (auto i = all_.begin(); i != all_.end();) {
    if (i->second.form.use_count() > 1) i->second.used = picture_;
    i = i->second.used + looked_through_every <= picture_ ? all_.erase(i) : std::next(i);
  }
}

}  // namespace betwixt
