// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a page asks of the engine: films from text, pictures, values. engine.js is the other half. Texts that are given
// back live until the next call; what is JSON says so.
#include <emscripten.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/utf8.h"
#include "betwixt/evaluation.h"
#include "betwixt/language.h"
#include "betwixt/render.h"
#include "editor/plain_values.h"
#include "graphics.h"
#include "language/json.h"
#include "typefaces.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

// A renderer, and what it was made for.
struct Easel {
  std::unique_ptr<Renderer> renderer;
  RenderOptions how;
  unsigned graphics = 0;
  bool fits(const RenderOptions& o) const {
    return renderer && graphics == graphics_generation() && how.width == o.width && how.height == o.height &&
           how.samples == o.samples && how.style == o.style && how.linear == o.linear;
  }
};
// Of films that are over. Who types makes a film with each key, and making a renderer takes longer than its picture.
constexpr std::size_t most_spare = 2;
std::vector<Easel> spare;
void keep_spare(Easel&& easel) {
  if (!easel.renderer) return;
  if (spare.size() == most_spare) spare.erase(spare.begin());
  spare.push_back(std::move(easel));
}

std::string json(const Diagnostic& d) {
  static constexpr const char* severities[] = {"notice", "warning", "error"};
  const Place& place = d.what.place;
  const ShownLine shown = shown_line(d);
  return fmt::format(
      R"({{"severity":"{}","text":{},"hint":{},"file":{},"line":{},"column":{},"length":{},"source":{},"caret":{}}})",
      severities[static_cast<int>(d.severity)], json_words(d.what.message), json_words(d.what.hint),
      json_text(place.file), place.line, place.column, shown.length, json_text(shown.line),
      count_characters(shown.before));
}

struct Film {
  Loaded loaded;
  std::set<std::string> wants;
  std::unique_ptr<Program> program;
  std::unique_ptr<Evaluation> evaluation;
  Easel easel;
  std::string text;                // as it was opened
  std::set<std::string> problems;  // JSON: what procedures did wrong while pictures were drawn

  const Document& document() const { return loaded.document; }
  // Code errs while frames are made. What it does has its place where it stands in the text.
  void hear() {
    for (Problem p : evaluation->reports()) {
      Diagnostic d;
      d.severity = p.source ? Severity::error : Severity::warning;
      d.what.code = ErrorCode::type;
      if (p.source) point_at(d, p, text, *p.source);
      d.what.message = to_string(p);
      if (problems.size() < 100) problems.insert(json(d));
    }
  }
  void compile() {
    if (program) return;
    program = std::make_unique<Program>(Program::compile(document()));
    evaluation = std::make_unique<Evaluation>(*program);
  }
};

const char* keep(std::string text) {
  static std::string kept;
  kept = std::move(text);
  return kept.c_str();
}

const char* say(const Error& e) { return keep(e.hint.empty() ? e.message : fmt::format("{} ({})", e.message, e.hint)); }

// What a film is drawn with that a page does not draw: a style that is near.
RenderOptions options(const Film& film, int width, int height) {
  RenderOptions otherwise;
  RenderOptions out = options_for(film.document(), otherwise, std::pair{width, height});
  if (out.style == "traced") out.style = "shaded";
  if (out.samples > 16 || !check_options(out)) out.samples = otherwise.samples;
  out.linear = film.document().transparent();
  return out;
}

Status need_renderer(Film& film, int width, int height) {
  const RenderOptions wanted = options(film, width, height);
  if (film.easel.fits(wanted)) return Nothing{};
  film.easel = {};
  const auto kept = std::find_if(spare.begin(), spare.end(), [&](const Easel& e) { return e.fits(wanted); });
  if (kept != spare.end()) {
    film.easel = std::move(*kept);
    spare.erase(kept);
    return Nothing{};
  }
  auto made = make_renderer(wanted);
  if (!made && wanted.linear) {  // graphics without pictures of light: what is clear is black there
    RenderOptions over_black = wanted;
    over_black.linear = false;
    made = make_renderer(over_black);
  }
  if (!made) return made.error();
  film.easel = {*std::move(made), wanted, graphics_generation()};
  return Nothing{};
}

}  // namespace
}  // namespace betwixt

using namespace betwixt;  // NOLINT: nothing else follows

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* betwixt_version() { return BETWIXT_VERSION; }

// A film of a script, whose files lie below the folder that is the current one.
EMSCRIPTEN_KEEPALIVE Film* betwixt_open(const char* path) {
  auto film = std::make_unique<Film>();
  LoadOptions how;
  how.asked_for = [&](const std::string& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) film->wants.insert(fs::path(file).lexically_relative(fs::current_path()).string());
  };
  film->loaded = load_file(path, how);
  if (auto text = read_whole(path)) film->text = *std::move(text);
  return film.release();
}

EMSCRIPTEN_KEEPALIVE void betwixt_close(Film* film) {
  keep_spare(std::move(film->easel));
  delete film;
}

// JSON: all that there is to say about it.
EMSCRIPTEN_KEEPALIVE const char* betwixt_about(Film* film) {
  const Document& d = film->document();
  std::string diagnostics, message, wants;
  for (const Diagnostic& one : film->loaded.diagnostics) {
    diagnostics += (diagnostics.empty() ? "" : ",") + json(one);
    if (one.severity != Severity::notice) message += to_string(one);
  }
  for (const std::string& file : film->wants) wants += (wants.empty() ? "" : ",") + json_text(file);
  const auto [first, last] = d.range();
  std::string notes;
  for (const auto& [time, text] : d.notes(first, last))
    notes += fmt::format(R"({}{{"seconds":{},"text":{}}})", notes.empty() ? "" : ",", json_number(time.seconds()),
                         json_text(text));
  const auto [width, height] = d.size().value_or(std::pair{1280, 720});
  return keep(fmt::format(R"({{"ok":{},"diagnostics":[{}],"message":{},"wants":[{}],"fps":{},"start":{},"end":{},)"
                          R"("firstFrame":{},"lastFrame":{},"width":{},"height":{},"clear":{},"notes":[{}]}})",
                          !has_errors(film->loaded.diagnostics), diagnostics, json_text(message), wants,
                          json_number(d.rate().per_second()), json_number(first.seconds()),
                          json_number((last + d.rate().span(1)).seconds()), json_number(d.rate().frame_number(first)),
                          json_number(d.rate().frame_number(last)), width, height, d.transparent(), notes));
}

// Draws onto the hidden canvas, which is as large. Gives what stands against it; null: nothing.
EMSCRIPTEN_KEEPALIVE const char* betwixt_draw(Film* film, double seconds, int width, int height) {
  if (!(std::abs(seconds) <= longest_seconds)) return keep("this is no time of a film");
  film->compile();
  if (const Status s = need_renderer(*film, width, height); !s) return say(s.error());
  film->evaluation->to(from_seconds(seconds));
  film->hear();
  if (const Status s = film->easel.renderer->show(*film->evaluation); !s) return say(s.error());
  return nullptr;
}

// What is kept to draw with is given up; the next picture makes it anew.
EMSCRIPTEN_KEEPALIVE void betwixt_rest(Film* film) { film->easel = {}; }
EMSCRIPTEN_KEEPALIVE void betwixt_forget_graphics() {
  spare.clear();
  forget_graphics();
}

// JSON: what procedures did wrong while pictures were drawn, as betwixt_about says what is wrong with a text.
EMSCRIPTEN_KEEPALIVE const char* betwixt_problems(Film* film) {
  std::string out;
  for (const std::string& p : film->problems) out += (out.empty() ? "" : ",") + p;
  return keep("[" + out + "]");
}

// JSON: as `betwixt eval --json` says it, or {"error": …}; with `one` the one value that is asked for.
// Patterns and times are separated by new lines.
EMSCRIPTEN_KEEPALIVE const char* betwixt_eval(Film* film, const char* patterns, const char* times, int one) {
  const Document& d = film->document();
  const auto error = [](const Error& e) {
    return keep(fmt::format(R"({{"error":{}}})", json_text(std::string(say(e)))));
  };
  const auto lines = [](std::string_view text) {
    std::vector<std::string> out;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      out.emplace_back(text.substr(at, end - at));
      at = end + 1;
    }
    return out;
  };
  std::vector<std::pair<std::string, Time>> when;
  for (const std::string& text : lines(times)) {
    const auto t = parse_time(text, d);
    if (!t) return error(t.error());
    when.emplace_back(text, *t);
  }
  const auto targets = targets_of(d, lines(patterns));
  if (!targets) return error(targets.error());
  film->compile();
  if (!one) return keep(values_json(d, *film->program, *targets, when));
  if (targets->size() != 1 || when.size() != 1)
    return error(fail(ErrorCode::name,
                      fmt::format("'{}' names {} values, and one is asked for", patterns, targets->size()),
                      "such as ball.position; evalAll() gives several"));
  const auto values = film->program->read(*targets, when[0].second);
  return keep(fmt::format(R"({{"value":{},"text":{}}})", json(values[0], targets->front(), d),
                          json_text(plain_value(values[0], targets->front(), d))));
}

EMSCRIPTEN_KEEPALIVE int betwixt_add_font(const char* path) { return add_font(path); }

}  // extern "C"
