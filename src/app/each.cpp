// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/each.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>

#include "app/code_errors.h"
#include "app/command.h"
#include "app/each_names.h"
#include "app/made_record.h"
#include "app/making.h"
#include "app/row_table.h"
#include "app/streams.h"
#include "base/counted.h"
#include "base/files.h"
#include "base/in_parallel.h"
#include "base/json.h"
#include "base/tell_user.h"
#include "film/output.h"
#include "scene/document.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

struct RowFilm {
  std::size_t row = 0;  // in the table, from 0
  std::string path;
  std::vector<GivenLet> lets;
  std::string why;    // why it failed
  bool kept = false;  // it was there already
};

struct Work {
  const RenderCall& call;
  const RowTable& table;
  std::vector<RowFilm> films;
  std::atomic<std::size_t> next = 0;
  std::mutex mutex, loading;
  std::size_t done = 0;
  std::set<std::string> warnings;
};

int refuse(const Error& e, int code) {
  if (e.place.file.empty()) return complain(e, code);
  tell_user(to_string(Diagnostic{Severity::error, e, {}, 0}));
  return code;
}

// Returns all that decides how a film looks, besides its files.
std::string parameters_of(const RenderCall& call, const RowFilm& film) {
  const LoadOptions& load = load_options();
  const PictureCall& p = call.picture;
  std::string all = fmt::format("{}\n{}\n{}x{} {} {} {} {} {}\n{} {}\n{} {} {} {}/{} {} {} {} {} {}\n", BETWIXT_VERSION,
                                call.frames, p.size ? p.size->first : 0, p.size ? p.size->second : 0, p.otherwise.style,
                                p.samples.value_or(-1), p.otherwise.denoise, static_cast<int>(p.otherwise.device),
                                p.pixel_filter, call.exposure.shutter.value_or(""), call.exposure.subframes.value_or(0),
                                call.bits, call.quality, call.codec, call.rate ? call.rate->num : 0,
                                call.rate ? call.rate->den : 0, call.keep_going, load.tex, load.read_anywhere,
                                load.language.value_or("-"), color_coding_names[static_cast<std::size_t>(call.colors)]);
  for (const auto* lets : {&load.lets, &film.lets})
    for (const GivenLet& let : *lets) all += fmt::format("{}={}\n", json_text(let.name), json_text(let.value));
  return all;
}

Loaded load_row(const RenderCall& call, const RowFilm& film, std::set<std::string>& files) {
  LoadOptions options = load_options();
  options.lets.insert(options.lets.end(), film.lets.begin(), film.lets.end());
  options.asked_for = [&](const std::string& path) { files.insert(path); };
  if (is_stream(call.file)) {
    const Result<std::string> text = script_text(call.file);
    return load_text(text ? *text : "", "<stdin>", options);
  }
  files.insert(call.file);
  if (options.language && !options.language->empty()) files.insert(*options.language);
  return load_file(call.file, options);
}

std::string errors_in(const Diagnostics& all) {
  std::string out;
  for (const Diagnostic& d : all)
    if (d.severity == Severity::error) out += to_string(d);
  return out;
}

Status make(Work& work, RowFilm& film) {
  const RenderCall& call = work.call;
  const std::string parameters = parameters_of(call, film);
  if (stands_as_made(film.path, parameters)) return film.kept = true, Status(Nothing{});
  std::set<std::string> files;
  std::optional<Document> document;
  {
    const std::lock_guard one_at_a_time(work.loading);
    const Loaded loaded = load_row(call, film, files);
    if (const std::string why = errors_in(loaded.diagnostics); !why.empty()) return fail(ErrorCode::name, why);
    for (const Diagnostic& d : loaded.diagnostics)
      if (d.severity == Severity::warning) work.warnings.insert(to_string(d));
    document = loaded.document;
  }
  Result<FrameList> frames = read_frames(call.frames, *document);
  if (frames && call.rate) frames = frames_between(frames->first, frames->last, *call.rate);
  if (!frames) return frames.error();
  const Result<std::optional<Blur>> exposure = call.exposure.of(*document);
  if (!exposure) return exposure.error();
  const Program program = Program::compile(*document);
  const Findings found =
      look_through(program, call.file, frames->time(0), frames->time(frames->count - 1), frames->count);
  if (!found.errors.empty() && !call.keep_going) return fail(ErrorCode::type, errors_in(found.errors));
  RenderJob job =
      render_job(program, film.path, *frames, call.picture.of(*document), *exposure, call.bits, call.colors);
  job.film.jobs = 1;
  job.film.overwrite = !call.keep_old;
  job.film.quality = call.quality, job.film.codec = call.codec;
  if (Status s = check_encoding(job.film); !s) return s;
  std::error_code ignored;
  if (const fs::path folder = fs::path(film.path).parent_path(); !folder.empty())
    fs::create_directories(folder, ignored);
  const Progress goes_on = [](int, int, double) { return !stop_requested(); };
  const auto made = job.pictures.linear ? make_linear_film(
                                              job.film, [&] { return linear_painter_of(program, job); }, goes_on)
                                        : make_film(
                                              job.film, [&] { return painter_of(program, job); }, goes_on);
  if (!made) return made.error();
  return write_made_record(film.path, parameters, files);
}

void make_all(Work& work) {
  const auto begun = std::chrono::steady_clock::now();
  FilmOptions counted_films;
  counted_films.frames = static_cast<int>(work.films.size());
  const Progress show = shown_progress(counted_films, work.call.progress);
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t jobs = work.call.jobs > 0 ? static_cast<std::size_t>(work.call.jobs) : cores;
  in_parallel(std::min(jobs, work.films.size()), [&](std::size_t) {
    for (std::size_t i; !stop_requested() && (i = work.next++) < work.films.size();) {
      RowFilm& film = work.films[i];
      const Status s = make(work, film);
      if (!s && stop_requested()) return;
      if (!s) film.why = s.error().message + (s.error().hint.empty() ? "" : " (" + s.error().hint + ")");
      const std::lock_guard lock(work.mutex);
      const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begun;
      show(static_cast<int>(++work.done), counted_films.frames, since.count());
    }
  });
}

std::string failure_json(const Work& work, const RowFilm& film) {
  return fmt::format("{{\"row\": {}, \"line\": {}, \"film\": {}, \"message\": {}}}", film.row + 1,
                     work.table.rows[film.row].front().line, json_text(film.path), json_words(film.why));
}

int say_all(const Work& work, double seconds) {
  std::size_t kept = 0, failed = 0;
  for (const RowFilm& film : work.films) kept += film.kept, failed += !film.why.empty();
  const std::size_t made = work.done - kept - failed;
  const int code = stop_requested() ? interrupted : failed > 0 ? wrong_input : all_done;
  if (work.call.json) {
    std::string list;
    for (const RowFilm& film : work.films)
      if (!film.why.empty()) list += (list.empty() ? "\n  " : ",\n  ") + failure_json(work, film);
    fmt::print(
        "{{\"ok\": {}, \"films\": {}, \"made\": {}, \"kept\": {}, \"failed\": {}, \"seconds\": {:.1f}, \"failures\": "
        "[{}{}]}}\n",
        code == all_done, work.films.size(), made, kept, failed, seconds, list, list.empty() ? "" : "\n");
    return code;
  }
  constexpr std::size_t most = 20;
  std::size_t said = 0;
  for (const std::string& warning : work.warnings)
    if (++said <= most) tell_user(warning);
  if (said > most) tell_user(fmt::format("betwixt: {} more warnings\n", said - most));
  for (const RowFilm& film : work.films) {
    if (film.why.empty()) continue;
    std::string why = film.why;
    while (!why.empty() && why.back() == '\n') why.pop_back();
    tell_user(
        fmt::format("{}:{}: {} failed: {}\n", work.table.file, work.table.rows[film.row].front().line, film.path, why));
  }
  if (stop_requested()) tell_user("betwixt: stopped; run the same command again to continue\n");
  std::string sum = fmt::format("{} made", counted(made, "film"));
  if (kept > 0) sum += fmt::format(", {} already there", kept);
  if (failed > 0) sum += fmt::format(", {} failed", failed);
  tell_user(fmt::format("{}, in {:.0f} s\n", sum, seconds));
  return code;
}

// Returns the rows that the options ask for: first and last + 1.
Result<std::pair<std::size_t, std::size_t>> wanted_rows(const RenderCall& call, std::size_t count) {
  if (call.part) {
    const auto [k, n] = *call.part;
    return std::pair{count * (k - 1) / n, count * k / n};
  }
  if (!call.rows) return std::pair{std::size_t{0}, count};
  if (call.rows->first > count)
    return fail(ErrorCode::range, fmt::format("--rows: the table has {}", counted(count, "row")));
  return std::pair{call.rows->first - 1, std::min(call.rows->second, count)};
}

// Reads A..B, A.. or A; or K/N.
Status read_span(const std::string& text, std::string_view between,
                 std::optional<std::pair<std::size_t, std::size_t>>& to, const char* example) {
  const auto number = [](const std::string& word) -> std::optional<std::size_t> {
    if (word.empty() || word.size() > 9 || word.find_first_not_of("0123456789") != word.npos) return std::nullopt;
    return std::stoul(word);
  };
  const std::size_t at = text.find(between);
  const auto first = number(text.substr(0, at));
  std::optional<std::size_t> last = first;
  if (at != text.npos) last = number(text.substr(at + between.size()));
  if (at != text.npos && between == ".." && at + 2 == text.size()) last = 999'999'999;
  const bool good = first && last && *first >= 1 && *first <= *last && (between == ".." || at != text.npos);
  if (!good) return fail(ErrorCode::range, fmt::format("\"{}\" is not {}", text, example));
  return to = {*first, *last}, Nothing{};
}

Status check_call(const RenderCall& call) {
  const auto no = [](const char* what) {
    return fail(ErrorCode::range, fmt::format("{} has no meaning with --each", what));
  };
  if (call.missing) return no("--missing");
  if (call.plan) return no("--plan");
  if (call.stats) return no("--stats");
  if (call.part && call.rows) return fail(ErrorCode::range, "--rows and --part exclude each other");
  if (call.out.empty() || is_stream(call.out) || call.out.starts_with("-."))
    return fail(ErrorCode::range, "--each needs a name for each film", "as in -o \"out/{name}.mp4\"");
  if (ending(call.out) == "pdf")
    return fail(ErrorCode::range, "--each makes films, and no .pdf",
                "a .pdf for each row: --let NAME=VALUE -o FILE.pdf");
  const auto place = read_output(call.out);
  if (!place) return place.error();
  if (!place->format) return fail(ErrorCode::range, "--each makes films, not numbered pictures");
  return Nothing{};
}

}  // namespace

int render_each(RenderCall& call) {
  if (const Status s = check_call(call); !s) return complain(s.error(), wrong_call);
  const Result<RowTable> table = rows_of_table(call.each);
  if (!table) return refuse(table.error(), wrong_input);
  const std::optional<Document> document = open_script(call.file);
  if (!document) return wrong_input;
  std::set<std::string> known;
  for (const auto& [name, value] : *document->scene().lets) known.insert(name);
  for (const GivenLet& let : load_options().lets)
    for (const RowTable::Cell& column : table->columns)
      if (column.text == let.name)
        return complain(
            fail(ErrorCode::name, fmt::format("--let {} and a column of {} give the same value", let.name, call.each)),
            wrong_call);
  const Result<std::vector<std::size_t>> used = columns_for(*table, known, call.file);
  if (!used) return refuse(used.error(), wrong_input);
  const Result<std::vector<std::string>> names = film_names(*table, call.out);
  if (!names) return refuse(names.error(), wrong_input);
  const auto wanted = wanted_rows(call, table->rows.size());
  if (!wanted) return complain(wanted.error(), wrong_call);
  Work work{.call = call, .table = *table, .films = {}, .mutex = {}, .loading = {}, .warnings = {}};
  for (std::size_t row = wanted->first; row < wanted->second; ++row) {
    RowFilm film{.row = row, .path = (*names)[row], .lets = {}, .why = {}};
    for (const std::size_t c : *used) {
      const RowTable::Cell& cell = table->rows[row][c];
      film.lets.push_back({table->columns[c].text, cell.text, true, table->place(cell)});
    }
    work.films.push_back(std::move(film));
  }
  const auto begun = std::chrono::steady_clock::now();
  if (!work.films.empty()) make_all(work);
  return say_all(work, std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
}

std::vector<Parameter> each_parameters(RenderCall& call) {
  Parameter each = file_option(
      "--each", "TABLE",
      "makes one film for each row of this table, .csv, .tsv, .json or SQLite: its columns are values for the "
      "`let`s of their names, and -o \"out/{name}.mp4\" names the films by a column",
      &call.each);
  Parameter rows = option("--rows", "A..B", "with --each: only these rows, counted from 1, both ends included",
                          ReadValue([&call](const std::string& text) {
                            return read_span(text, "..", call.rows, "a span of rows such as 1..250, 251.. or 7");
                          }));
  Parameter part = option(
      "--part", "K/N", "with --each: the K-th of N parts of the table, for a farm",
      ReadValue([&call](const std::string& text) { return read_span(text, "/", call.part, "a part such as 3/8"); }));
  Parameter json = flag("--json", "with --each: prints the summary as one JSON object", call.json);
  rows.needs = part.needs = json.needs = "--each";
  return {each, rows, part, json};
}

}  // namespace betwixt
