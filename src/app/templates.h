// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The films to begin with: `betwixt new`, and File, New in the studio. Their scripts are the files of templates/.
#pragma once

#include <span>
#include <string_view>

namespace betwixt {

struct FilmTemplate {
  std::string_view name, title;  // "chart-race", "Chart race"
  std::string_view sentence;     // describes the film
  std::string_view text;         // the script
  double shown_frame;            // the frame that shows it best
};
std::span<const FilmTemplate> film_templates();

}  // namespace betwixt
