// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/templates.h"

#include "app/templates_text.h"

namespace betwixt {

std::span<const FilmTemplate> film_templates() {
  static constexpr FilmTemplate all[] = {
      {"empty", "Empty film", "objects in light, with a ground, a sky, a sun and a camera", empty_bx, 1},
      {"empty-2d", "Empty drawing", "a flat drawing without light", empty_2d_bx, 1},
      {"title", "Title", "letters fly in, and a subtitle is typed", title_bx, 110},
      {"explainer", "Explainer", "three steps with arrows, one after another", explainer_bx, 150},
      {"lesson", "Lesson", "a graph with its tangent, an area that grows, and a formula", lesson_bx, 170},
      {"chart-race", "Chart race", "bars that grow, overtake each other and count", chart_race_bx, 140},
      {"slides", "Slides", "three pages, and a camera that goes from one to the next", slides_bx, 48},
      {"turntable", "Turntable", "a product turns once in soft light", turntable_bx, 105},
      {"character", "Character", "a figure with arms and legs walks, stops and waves", character_bx, 110},
      {"music-video", "Music video", "shapes that move with a beat", music_video_bx, 110},
  };
  return all;
}

}  // namespace betwixt
