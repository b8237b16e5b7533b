// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/kept_pictures.h"

namespace betwixt::studio {

bool KeptPictures::use(Of of) {
  if (of_ && *of_ == of) return false;
  const bool some = !pictures_.empty();
  of_ = std::move(of), pictures_.clear(), bytes_ = 0;
  return some;
}

const PictureMade* KeptPictures::at(Time t) const {
  const auto found = pictures_.find(t);
  return found == pictures_.end() ? nullptr : &found->second;
}

bool KeptPictures::keep(const PictureMade& made) {
  const PictureMade* known = at(made.time);
  if (known && (!known->draft || made.draft)) return true;
  const std::size_t more = static_cast<std::size_t>(made.image.sizeInBytes());
  const std::size_t less = known ? static_cast<std::size_t>(known->image.sizeInBytes()) : 0;
  if (bytes_ - less + more > most_bytes) return false;
  bytes_ += more - less;
  pictures_.insert_or_assign(made.time, made);
  return true;
}

std::vector<KeptAt> KeptPictures::list() const {
  std::vector<KeptAt> all;
  for (const auto& [time, picture] : pictures_) all.push_back({time, picture.draft});
  return all;
}

}  // namespace betwixt::studio
