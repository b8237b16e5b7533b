// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The page of a talk. Its text is in web/talk.html.
#include <fmt/format.h>

#include "app/markup.h"
#include "app/page_policy.h"
#include "app/web_page.h"
#include "app/web_page_parts.h"
#include "app/web_page_text.h"
#include "language/json.h"

namespace betwixt {

std::string talk_page(const PageFilm& film, const PageOptions& options) {
  PagePolicy policy;
  std::string stops;
  for (const Pause& stop : film.stops)
    stops += fmt::format("{}{{\"seconds\": {}, \"text\": {}, \"note\": {}}}", stops.empty() ? "" : ",\n",
                         json_number((stop.time - film.begin).seconds()), json_text(stop.text), json_text(stop.note));
  const std::string player = policy.script("\n" + options.player), talk = policy.script("\n" + std::string(talk_js));
  const std::string look = policy.style("\n" + std::string(talk_css));
  return filled(talk_html, {{"policy", policy.said()},
                            {"version", BETWIXT_VERSION},
                            {"title", escaped(options.title)},
                            {"look", look},
                            {"film", player_markup(film, options, "")},
                            {"stops", as_script_text("[" + stops + "]")},
                            {"files", files_markup(film.files)},
                            {"player", player},
                            {"talk", talk}});
}

}  // namespace betwixt
