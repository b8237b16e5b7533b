// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/sections.h"

#include "scene/document.h"

namespace betwixt {

const std::vector<Section>& Document::sections() const { return *scene_->sections; }

std::vector<Pause> Document::pauses() const {
  std::vector<Pause> out;
  for (const auto& [time, pause] : *scene_->pauses) out.push_back(pause);
  return out;
}

std::vector<Description> Document::descriptions() const {
  std::vector<Description> out;
  for (const auto& [time, said] : *scene_->descriptions) out.push_back(said);
  return out;
}

}  // namespace betwixt
