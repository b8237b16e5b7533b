// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The page's text is in web/lesson.html. Its scripts get the figures from the engine, which is embedded too.
#include "app/lesson.h"

#include <fmt/format.h>

#include "algebra/study.h"
#include "app/lesson_page.h"
#include "app/markup.h"
#include "app/page_policy.h"
#include "app/player_file.h"
#include "base/files.h"
#include "base/json.h"

namespace betwixt {
namespace {

std::string list(const std::vector<Vec3>& points) {
  std::string out;
  for (const Vec3& p : points)
    out += fmt::format("{}[{},{},{}]", out.empty() ? "" : ",", json_number(p.x), json_number(p.y), json_number(p.z));
  return "[" + out + "]";
}

// Returns the initial data of the page. A motion's text contains nothing that could end a script.
std::string begins_with(const std::string& text, const LessonOptions& options) {
  return fmt::format("{{\"text\":{},\"steps\":{},\"points\":{}}}", json_text(text), options.steps,
                     list(options.points));
}

}  // namespace

Status write_lesson(const std::string& path, const Motion& motion, const LessonOptions& options) {
  if (const std::string type = ending(path); type != "html" && type != "htm")
    return fail(ErrorCode::range, fmt::format("a lesson must be a .html file, not \"{}\"", path));
  if (auto bad = algebra::can_be_shown(motion, options.points); !bad) return bad;
  if (auto first = frame(motion, 0, options.steps); !first) return first.error();
  if (options.steps > most_lesson_steps)
    return fail(ErrorCode::range, fmt::format("{} steps are too many for a lesson", options.steps),
                fmt::format("the limit is {}", most_lesson_steps));
  const auto player = read_player({});
  if (!player) return player.error();
  const std::string text = to_string(motion);
  std::string script = "\n\"use strict\";\n(() => {\n";
  for (const char* part : {lesson_pictures_js, lesson_words_js, lesson_handles_js, lesson_methods_js, lesson_string_js,
                           lesson_numbers_js, lesson_address_js, lesson_js})
    script += part;
  script += "\n})();\n";
  PagePolicy policy;
  const std::string look = policy.style("\n" + std::string(lesson_css) + "\n"),
                    plays = policy.script("\n" + *player + "\n"), works = policy.script(script);
  const std::string page = filled(lesson_html, {{"policy", policy.said()},
                                                {"title", escaped(text.empty() ? "no factors" : text)},
                                                {"string", escaped(text)},
                                                {"style", look},
                                                {"data", begins_with(text, options)},
                                                {"player", plays},
                                                {"script", works}});
  return write_whole(path, page, true);
}

}  // namespace betwixt
