// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions that engine.js calls: they open films, draw pictures and read values. A text that they return is valid
// until the next call.
#include <emscripten.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/utf8.h"
#include "betwixt/film.h"
#include "betwixt/language.h"
#include "betwixt/session.h"
#include "betwixt/sound.h"
#include "betwixt/track.h"
#include "editor/plain_values.h"
#include "graphics.h"
#include "language/json.h"
#include "playback/film_player.h"
#include "typefaces.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

// The renderers of films that were closed: an editor opens another film with each key, and to make a renderer takes
// longer than to draw a picture.
RendererCache spare_renderers(2);

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
  std::set<std::string> missing_files;
  std::optional<Program> program;  // compiled when it is needed
  FilmPlayer player{1, &spare_renderers};
  std::string text;                // as it was opened
  LoadOptions load;                // its lets and its language
  std::set<std::string> problems;  // JSON: errors of procedures while pictures were drawn
  std::optional<Session> session;  // from the first edit on

  const Document& document() const { return loaded.document; }
  // Collects the errors of procedures, with their places in the text: they appear only when frames are made.
  void collect_problems(const Evaluation& evaluation) {
    for (Problem p : evaluation.reports()) {
      Diagnostic d;
      d.severity = p.source ? Severity::error : Severity::warning;
      d.what.code = ErrorCode::type;
      if (p.source) point_at(d, p, text, *p.source);
      d.what.message = to_string(p);
      if (problems.size() < 100) problems.insert(json(d));
    }
  }
  void compile() {
    if (!program) program = Program::compile(document());
  }
  // Takes the film of the session, after an edit.
  void take_edit() {
    loaded.document = session->document();
    loaded.diagnostics = session->diagnostics();
    if (program) program = Program::compile(document(), *program);
    problems.clear();
  }
};
std::set<Film*> open_films;
LoadOptions of_next_film;  // until it is opened
bool has_linear = true;    // whether the graphics can draw linear light

// Returns a text that is valid until the next call.
const char* returned(std::string text) {
  static std::string last;
  last = std::move(text);
  return last.c_str();
}

const char* returned(const Error& e) {
  return returned(e.hint.empty() ? e.message : fmt::format("{} ({})", e.message, e.hint));
}

const char* error_json(const Error& e) {
  return returned(fmt::format(R"({{"error":{}}})", json_text(std::string(returned(e)))));
}

// Returns the answer of a session as {"said": …} or {"error": …}, and shows the film as it is now.
const char* answered(Film& film, const Session::Answer& answer) {
  if (answer.refused) return error_json(answer.why.empty() ? fail(ErrorCode::name, answer.said) : answer.why[0].what);
  film.take_edit();
  return returned(fmt::format(R"({{"said":{}}})", json_text(answer.said)));
}

// Returns the film's options. A style that pages do not have is replaced by a similar one.
RenderOptions options(const Film& film, int width, int height) {
  RenderOptions otherwise;
  RenderOptions out = options_for(film.document(), otherwise, std::pair{width, height});
  if (out.style == "traced") out.style = "shaded";
  if (out.samples > 16 || !check_options(out)) out.samples = otherwise.samples;
  out.linear = has_linear && film.document().transparent();
  return out;
}

}  // namespace
}  // namespace betwixt

using namespace betwixt;  // NOLINT: nothing else follows

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* betwixt_version() { return BETWIXT_VERSION; }

// Gives a value for a `let` of the next film, and the catalogue of its texts.
EMSCRIPTEN_KEEPALIVE void betwixt_let(const char* name, const char* value) {
  of_next_film.lets.push_back({name, value});
}
EMSCRIPTEN_KEEPALIVE void betwixt_language(const char* path) { of_next_film.language = path; }

// Opens the film of a script. Its files are in the current folder and below.
EMSCRIPTEN_KEEPALIVE Film* betwixt_open(const char* path) {
  auto film = std::make_unique<Film>();
  film->load = std::exchange(of_next_film, {});
  LoadOptions load = film->load;
  load.asked_for = [&](const std::string& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored))
      film->missing_files.insert(fs::path(file).lexically_relative(fs::current_path()).string());
  };
  film->loaded = load_file(path, load);
  if (auto text = read_whole(path)) film->text = *std::move(text);
  open_films.insert(film.get());
  return film.release();
}

EMSCRIPTEN_KEEPALIVE void betwixt_close(Film* film) {
  open_films.erase(film);
  delete film;
}

// Returns what the page shows of a film before it draws, as JSON: its errors, times, size and notes.
EMSCRIPTEN_KEEPALIVE const char* betwixt_about(Film* film) {
  const Document& d = film->document();
  std::string diagnostics, message, missing;
  for (const Diagnostic& one : film->loaded.diagnostics) {
    diagnostics += (diagnostics.empty() ? "" : ",") + json(one);
    if (one.severity != Severity::notice) message += to_string(one);
  }
  for (const std::string& file : film->missing_files) missing += (missing.empty() ? "" : ",") + json_text(file);
  const auto [first, last] = d.range();
  std::string notes;
  for (const Note& n : d.notes(first, last))
    notes += fmt::format(R"({}{{"seconds":{},"text":{}}})", notes.empty() ? "" : ",", json_number(n.time.seconds()),
                         json_text(n.text));
  std::string descriptions;
  for (const Description& one : d.descriptions())
    descriptions += fmt::format(R"({}{{"seconds":{},"text":{}}})", descriptions.empty() ? "" : ",",
                                json_number(one.time.seconds()), json_text(one.text));
  const auto [width, height] = d.size().value_or(std::pair{1280, 720});
  return returned(fmt::format(
      R"({{"ok":{},"diagnostics":[{}],"message":{},"wants":[{}],"fps":{},"start":{},"end":{},)"
      R"("firstFrame":{},"lastFrame":{},"width":{},"height":{},"clear":{},"sounds":{},"notes":[{}],)"
      R"("descriptions":[{}]}})",
      !has_errors(film->loaded.diagnostics), diagnostics, json_text(message), missing,
      json_number(d.rate().per_second()), json_number(first.seconds()),
      json_number((last + d.rate().span(1)).seconds()), json_number(d.rate().frame_number(first)),
      json_number(d.rate().frame_number(last)), width, height, d.transparent(), has_sounds(d), notes, descriptions));
}

// Draws to the hidden canvas, which has this size. Returns an error, or null.
EMSCRIPTEN_KEEPALIVE const char* betwixt_draw(Film* film, double seconds, int width, int height) {
  if (!(std::abs(seconds) <= longest_seconds)) return returned("this is no time of a film");
  film->compile();
  film->collect_problems(film->player.evaluate(*film->program, from_seconds(seconds)));
  RenderOptions wanted = options(*film, width, height);
  Status shown = film->player.show(wanted);
  if (!shown && wanted.linear) {  // some graphics cannot draw linear light; then transparent parts are black
    wanted.linear = false;
    shown = film->player.show(wanted);
    if (shown) has_linear = false;
  }
  return shown ? nullptr : returned(shown.error());
}

// Frees the film's renderer. The next picture makes another one.
EMSCRIPTEN_KEEPALIVE void betwixt_rest(Film* film) { film->player.rest(); }
// Frees all that was made with the graphics context, which the browser has taken away.
EMSCRIPTEN_KEEPALIVE void betwixt_forget_graphics() {
  for (Film* film : open_films) film->player.rest();
  spare_renderers.clear();
  has_linear = true;
  forget_graphics();
}

// Mixes `pairs` samples of the film's sound from this sample of the film on: those of the sound track that `betwixt
// render` writes. Returns left and right alternately, until the next call.
EMSCRIPTEN_KEEPALIVE const float* betwixt_mix(Film* film, double first, int pairs) {
  static std::vector<float> stereo;
  stereo.assign(2 * static_cast<std::size_t>(std::max(pairs, 0)), 0.0f);
  if (!(std::abs(first) <= longest_seconds * sound_rate)) return stereo.data();
  film->compile();
  const Time from =
      film->document().range().first + Time{static_cast<std::int64_t>(first) * (flicks_per_second / sound_rate)};
  (void)mix_sounds(*film->program, from, stereo);  // a sound that is not decoded is silent
  return stereo.data();
}

// Returns the errors of procedures while pictures were drawn, as JSON in the form of betwixt_about's diagnostics.
EMSCRIPTEN_KEEPALIVE const char* betwixt_problems(Film* film) {
  std::string out;
  for (const std::string& p : film->problems) out += (out.empty() ? "" : ",") + p;
  return returned("[" + out + "]");
}

// Returns values as the JSON of `betwixt eval --json`, or {"error": …}; with `one`, only the value and its text. The
// patterns are separated by line ends, and so are the times.
EMSCRIPTEN_KEEPALIVE const char* betwixt_eval(Film* film, const char* patterns, const char* times, int one) {
  const Document& d = film->document();
  const auto lines = [](std::string_view text) {
    std::vector<std::string> out;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      out.emplace_back(text.substr(at, end - at));
      at = end + 1;
    }
    return out;
  };
  std::vector<std::pair<std::string, Time>> moments;
  for (const std::string& text : lines(times)) {
    const auto t = parse_time(text, d);
    if (!t) return error_json(t.error());
    moments.emplace_back(text, *t);
  }
  const auto targets = targets_of(d, lines(patterns));
  if (!targets) return error_json(targets.error());
  film->compile();
  if (!one) return returned(values_json(d, *film->program, *targets, moments));
  if (targets->size() != 1 || moments.size() != 1)
    return error_json(fail(ErrorCode::name,
                           fmt::format("'{}' names {} values, and one is asked for", patterns, targets->size()),
                           "such as ball.position; evalAll() gives several"));
  const auto values = film->program->read(*targets, moments[0].second);
  return returned(fmt::format(R"({{"value":{},"text":{}}})", json(values[0], targets->front(), d),
                              json_text(plain_value(values[0], targets->front(), d))));
}

// Prepares a film for edits. Its files are in the current folder again, and `path` is the name of its script.
EMSCRIPTEN_KEEPALIVE const char* betwixt_begin_edits(Film* film, const char* path) {
  film->session.emplace(Session::Callbacks{}, film->load);
  film->session->begin(film->text, path);
  return nullptr;
}

// Replaces the events of a track: `count` times in seconds, and `size` numbers. After betwixt_begin_edits.
EMSCRIPTEN_KEEPALIVE const char* betwixt_set_track(Film* film, const char* target, const char* twerper,
                                                   const double* seconds, std::size_t count, const double* numbers,
                                                   std::size_t size) {
  std::vector<Time> times;
  times.reserve(count);
  for (const double s : std::span(seconds, count)) {
    if (!(std::abs(s) <= longest_seconds))
      return error_json(fail(ErrorCode::range,
                             std::isfinite(s) ? "this time is too far from the beginning" : "that is no time",
                             "times are seconds"));
    times.push_back(from_seconds(s));
  }
  return answered(*film, film->session->set_track(target, times, std::span(numbers, size), twerper));
}

// `word` is undo or redo. After betwixt_begin_edits.
EMSCRIPTEN_KEEPALIVE const char* betwixt_step(Film* film, const char* word) {
  return answered(*film, film->session->enter(word));
}

// Returns {"at": …, "count": …, "width": …}: the address of `count` times in seconds and then of `count` times `width`
// numbers, which the caller frees; or {"error": …}.
EMSCRIPTEN_KEEPALIVE const char* betwixt_track_numbers(Film* film, const char* target) {
  const Result<TrackNumbers> found = track_numbers(film->document(), target);
  if (!found) return error_json(found.error());
  auto* const at =
      static_cast<double*>(std::malloc((found->times.size() + found->numbers.size() + 1) * sizeof(double)));
  if (!at) return error_json(fail(ErrorCode::machine, "there is no memory left"));
  double* to = at;
  for (const Time t : found->times) *to++ = t.seconds();
  std::copy(found->numbers.begin(), found->numbers.end(), to);
  return returned(fmt::format(R"({{"at":{},"count":{},"width":{}}})", reinterpret_cast<std::uintptr_t>(at),
                              found->times.size(), found->width));
}

EMSCRIPTEN_KEEPALIVE const char* betwixt_text(Film* film) {
  return film->session ? returned(film->session->text()) : film->text.c_str();
}

EMSCRIPTEN_KEEPALIVE int betwixt_add_font(const char* path) { return add_font(path); }

}  // extern "C"
