// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/kept_frames.h"

namespace betwixt {

std::shared_ptr<const Picture> KeptFrames::find(const void* video, std::size_t number) {
  const auto at = places_.find({video, number});
  if (at == places_.end()) return nullptr;
  all_.splice(all_.begin(), all_, at->second);
  return at->second->picture;
}

void KeptFrames::add(const void* video, std::size_t number, std::shared_ptr<const Picture> picture) {
  const Key key{video, number};
  if (const auto at = places_.find(key); at != places_.end()) drop(at->second);
  bytes_ += picture->rgba.size();
  all_.push_front({key, std::move(picture)});
  places_[key] = all_.begin();
  while (bytes_ > most_ && all_.size() > 2) drop(std::prev(all_.end()));
}

void KeptFrames::forget(const void* video) {
  for (auto at = places_.lower_bound({video, 0}); at != places_.end() && at->first.first == video;)
    drop((at++)->second);
}

void KeptFrames::drop(Place place) {
  bytes_ -= place->picture->rgba.size();
  places_.erase(place->key);
  all_.erase(place);
}

}  // namespace betwixt
