// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt mcp: a server of the Model Context Protocol on standard input and output, so that an assistant can make a
// film and see it. A tool is a row of a table: its name, what it takes, and its function.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "app/command.h"
#include "app/subcommand.h"
#include "app/version.h"
#include "base/base64.h"
#include "base/counted.h"
#include "base/files.h"
#include "base/json.h"
#include "base/names.h"
#include "betwixt/object.h"
#include "betwixt/picture.h"
#include "betwixt/session.h"
#include "editor/help.h"
#include "editor/plain_values.h"
#include "export/json.h"
#include "language/values.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_line = 32U << 20U;
constexpr int most_pixels = 1920;  // a side of a picture

// A wrong request of the protocol, with its code in JSON-RPC. A tool that fails has a result with `isError` instead.
struct Refused {
  int code;
  std::string why;
};

// Content of a tool's result.
struct Outcome {
  std::string text, png = {};
  bool wrong = false;
};

Outcome wrong(const Error& e) { return {.text = to_string(Diagnostic{Severity::error, e, {}, 0}), .wrong = true}; }

struct Film {
  Session session{{}, load_options()};
  Film() { session.begin("", ""); }
};

// Returns the path, if it is in the folder in which the server was started. The assistant gets no other files.
Result<std::string> inside(const std::string& path) {
  std::error_code failed;
  const fs::path here = fs::weakly_canonical(fs::current_path(), failed);
  const fs::path there = failed ? fs::path{} : fs::weakly_canonical(here / path, failed);
  const auto [end, ignored] = std::ranges::mismatch(here, there);
  if (!failed && end == here.end() && there.extension() == ".bx") return there.string();
  return fail(ErrorCode::file, "\"" + path + "\" is not a film in the server's folder or below",
              "name a file such as film.bx");
}

std::string told(const Diagnostics& all) {
  std::string out;
  for (const Diagnostic& d : all) out += to_string(d);
  return out;
}

Outcome outcome_of(const Session::Answer& a) {
  const std::string said = a.said.empty() ? told(a.why) : a.said;
  return {.text = said + (a.done ? "Done.\n" : "Nothing was changed.\n"), .wrong = !a.done};
}

std::vector<std::string> strings(const Json& from, const char* name) {
  std::vector<std::string> all;
  if (const auto at = from.find(name); at != from.end()) {
    if (at->is_string()) return {at->get<std::string>()};
    for (const Json& one : *at) all.push_back(one.get<std::string>());
  }
  return all;
}

// The lines of a text; a row below its sheet stays a row.
std::vector<std::string> lines_of(const std::vector<std::string>& texts) {
  std::vector<std::string> lines;
  for (const std::string& text : texts) {
    std::string line;
    for (std::istringstream in(text); std::getline(in, line);)
      if (!lines.empty() && Session::needs_more(lines.back()))
        lines.back() += "\n" + line;
      else if (line.find_first_not_of(" \t\r") != std::string::npos)
        lines.push_back(line);
  }
  return lines;
}

// Words of the shell write files, or wait for a person: only undo and redo are allowed.
std::optional<std::string> word_of_the_shell(const std::string& line) {
  const std::size_t from = line.find_first_not_of(" \t");
  const std::string word = from == std::string::npos ? "" : line.substr(from, line.find_first_of(" \t", from) - from);
  for (const HelpEntry& e : shell_entries())
    if (e.word == word && word != "undo" && word != "redo") return word;
  return std::nullopt;
}

Outcome show_words(Film& film, const Json& args) {
  const std::string word = args.value("word", "");
  const Scene& scene = film.session.document().scene();
  if (word.empty()) return {.text = help_overview(scene, false)};
  const std::string text = help_text(word, scene);
  return text.empty() ? Outcome{.text = "There is no help for '" + word + "'.\n", .wrong = true}
                      : Outcome{.text = text};
}

Outcome open_film(Film& film, const Json& args) {
  const Result<std::string> path = inside(args.at("file").get<std::string>());
  if (!path) return wrong(path.error());
  if (*path == film.session.file()) return {.text = film.session.text()};
  Session next({}, load_options());
  next.edit_in_place();
  const Session::Answer a = next.open(*path, Session::Earlier::recover);
  if (!a.done && !a.why.empty()) return outcome_of(a);
  film.session = std::move(next);
  return {.text = a.said + told(film.session.diagnostics()) + film.session.text()};
}

Outcome show_film(Film& film, const Json&) {
  const Document& d = film.session.document();
  std::string text = fmt::format("{}, {} a second\n", counted(d.frame_count(), "frame"), d.rate().per_second());
  for (const ObjectId id : objects(d)) text += fmt::format("{}: {}\n", d.name(id), name_of(kind(d, id)));
  return {.text = text + "\n" + film.session.text()};
}

Outcome eval_film(Film& film, const Json& args) {
  const Document& d = film.session.document();
  std::vector<std::pair<std::string, Time>> times;
  for (const std::string& text : strings(args, "times")) {
    const Result<Time> t = read_time(text, d, "times");
    if (!t) return wrong(t.error());
    times.emplace_back(text, *t);
  }
  std::string missing;
  const Result<std::vector<Target>> targets =
      targets_of(d, strings(args, "targets"), [&](const std::string& pattern) { missing = pattern; });
  if (!targets) return wrong(targets.error());
  if (!missing.empty()) return wrong(nothing_named(missing));
  if (times.empty()) times.emplace_back("first", d.range().first);
  return {.text = values_json(d, Program::compile(d), *targets, times)};
}

Outcome draw_film(Film& film, const Json& args) {
  const Document& d = film.session.document();
  const std::string at = args.value("at", "");
  const Result<Time> time = at.empty() ? d.range().first : read_time(at, d, "at");
  if (!time) return wrong(time.error());
  const int width = std::clamp(args.value("width", 640), 16, most_pixels);
  const int height = std::clamp(args.value("height", width * 9 / 16), 16, most_pixels);
  PictureCall call;
  call.size = {width, height};
  const RenderOptions options = call.of(d);
  Result<std::unique_ptr<Renderer>> renderer = make_renderer(options);
  if (!renderer) return wrong(renderer.error());
  const Program program = Program::compile(d);
  Picture picture;
  const Frame frame = program.frame(*time);
  if (const Status drawn = (*renderer)->render(frame, picture); !drawn) return wrong(drawn.error());
  Result<std::string> png = to_png(picture);
  if (!png) return wrong(png.error());
  std::string problems;
  for (const std::string& problem : frame.problems) problems += problem + "\n";
  return {.text = problems, .png = std::move(*png)};
}

Outcome edit_film(Film& film, const Json& args) {
  const std::vector<std::string> lines = lines_of(strings(args, "lines"));
  for (const std::string& line : lines)
    if (const auto word = word_of_the_shell(line))
      return {.text = "'" + *word + "' is a word of the shell. Use the tools of this server.\n", .wrong = true};
  if (lines.size() == 1 && (lines[0] == "undo" || lines[0] == "redo")) return outcome_of(film.session.enter(lines[0]));
  film.session.edit_in_place();
  return outcome_of(film.session.enter_together(lines));
}

Outcome write_film(Film& film, const Json& args) {
  const std::string text = args.at("text").get<std::string>(), now = film.session.text();
  if (const Loaded loaded = load_text(text, film.session.file(), load_options()); has_errors(loaded.diagnostics))
    return {.text = told(loaded.diagnostics) + "Nothing was changed.\n", .wrong = true};
  const auto lines = std::ranges::count(now, '\n') + (now.empty() || now.ends_with('\n') ? 0 : 1);
  return outcome_of(film.session.enter(Session::rewrite_line(1, static_cast<int>(lines), text)));
}

Outcome save_film(Film& film, const Json& args) {
  const std::string name = args.value("file", "");
  if (name.empty() && film.session.file().empty())
    return {.text = "The film has no file yet. Name one, such as film.bx.\n", .wrong = true};
  const Result<std::string> path = inside(name.empty() ? film.session.file() : name);
  if (!path) return wrong(path.error());
  return outcome_of(film.session.enter(name.empty() ? "save" : "save \"" + *path + "\""));
}

struct Tool {
  const char *name, *sentence;
  Outcome (*run)(Film&, const Json&);
  Json takes;  // properties of a JSON schema
  std::vector<std::string> required = {};
};

Json text_of_a(const char* sentence) { return {{"type", "string"}, {"description", sentence}}; }
Json list_of(const char* sentence) {
  return {{"type", "array"}, {"items", {{"type", "string"}}}, {"description", sentence}};
}
Json number_of(const char* sentence) { return {{"type", "integer"}, {"description", sentence}}; }

const std::vector<Tool>& tools() {
  static const std::vector<Tool> all = {
      {"help",
       "Explains a word of the language, or lists all words. Begin here.",
       show_words,
       {{"word", text_of_a("the word, such as create, sphere or ease; without it: a list of all words")}}},
      {"open",
       "Opens a film in the server's folder. If the file does not exist, begins a new film.",
       open_film,
       {{"file", text_of_a("the file, such as film.bx")}},
       {"file"}},
      {"list", "Shows the objects of the film and its whole text.", show_film, Json::object()},
      {"eval",
       "Gives values of properties at times, as JSON.",
       eval_film,
       {{"targets", list_of("targets or patterns, such as ball.position or wheel*; without them: all objects")},
        {"times", list_of("times, such as 24f or 2.5s; without them: the first frame")}}},
      {"frame",
       "Draws the film at a time, as a picture.",
       draw_film,
       {{"at", text_of_a("the time, such as 24f or 2.5s; without it: the first frame")},
        {"width", number_of("the width in pixels, at most 1920; usually 640")},
        {"height", number_of("the height in pixels; usually 9/16 of the width")}}},
      {"edit",
       "Adds lines to the film, or changes its events: all lines or none. The line undo takes the last edit back.",
       edit_film,
       {{"lines", list_of("lines of the language, such as: create ball sphere color=gold")}},
       {"lines"}},
      {"write",
       "Replaces the whole text of the film. If the new text has an error, nothing changes.",
       write_film,
       {{"text", text_of_a("the new text")}},
       {"text"}},
      {"save",
       "Saves the film in the server's folder.",
       save_film,
       {{"file", text_of_a("the file, such as film.bx; without it: the file that was opened")}}},
  };
  return all;
}

Json listed(const Tool& t) {
  return {{"name", t.name},
          {"description", t.sentence},
          {"inputSchema",
           {{"type", "object"}, {"properties", t.takes}, {"required", t.required}, {"additionalProperties", false}}}};
}

// Returns what is wrong with the arguments of a tool, or "".
std::string wrong_arguments(const Tool& t, const Json& given) {
  if (!given.is_object()) return fmt::format("The arguments of '{}' must be an object.\n", t.name);
  std::vector<std::string> known;
  for (const auto& [name, schema] : t.takes.items()) known.push_back(name);
  const std::string all = known.empty() ? "it has none" : fmt::format("it has {}", fmt::join(known, ", "));
  for (const auto& [name, value] : given.items()) {
    const auto schema = t.takes.find(name);
    if (schema == t.takes.end()) return fmt::format("'{}' has no argument '{}'; {}.\n", t.name, name, all);
    const std::string type = (*schema)["type"];
    const bool fits = type == "string" ? value.is_string()
                      : type == "integer"
                          ? value.is_number_integer()
                          : value.is_array() && std::ranges::all_of(value, [](const Json& v) { return v.is_string(); });
    const char* const wanted = type == "string" ? "a text" : type == "integer" ? "a whole number" : "a list of texts";
    if (!fits) return fmt::format("'{}' of '{}' must be {}.\n", name, t.name, wanted);
  }
  for (const std::string& name : t.required)
    if (!given.contains(name)) return fmt::format("'{}' needs the argument '{}'.\n", t.name, name);
  return "";
}

Json call_tool(Film& film, const Json& params) {
  const std::string name = params.value("name", "");
  const auto tool = std::ranges::find(tools(), name, &Tool::name);
  if (tool == tools().end()) throw Refused{-32602, "there is no tool '" + name + "'"};
  const auto said = params.find("arguments");
  const Json arguments = said == params.end() || said->is_null() ? Json::object() : *said;
  const std::string why = wrong_arguments(*tool, arguments);
  const Outcome made = why.empty() ? tool->run(film, arguments) : Outcome{.text = why, .wrong = true};
  Json content = Json::array();
  if (!made.png.empty()) content.push_back({{"type", "image"}, {"data", base64(made.png)}, {"mimeType", "image/png"}});
  if (!made.text.empty() || made.png.empty()) content.push_back({{"type", "text"}, {"text", made.text}});
  return {{"content", content}, {"isError", made.wrong}};
}

Json answer_to(Film& film, const std::string& method, const Json& params) {
  if (method == "initialize") {
    // The protocol's versions differ in nothing that this server uses.
    const std::string version = params.value("protocolVersion", "2024-11-05");
    return {{"protocolVersion", version},
            {"capabilities", {{"tools", Json::object()}}},
            {"serverInfo", {{"name", "betwixt"}, {"version", version_line()}}},
            {"instructions",
             "You make animated films as text. Call help first. After each edit, look at the film with frame."}};
  }
  if (method == "ping") return Json::object();
  if (method == "tools/list") {
    Json all = Json::array();
    for (const Tool& t : tools()) all.push_back(listed(t));
    return {{"tools", all}};
  }
  if (method == "tools/call") return call_tool(film, params);
  throw Refused{-32601, "there is no method '" + method + "'"};
}

// Returns the answer to a line, or nullopt if it wants none.
std::optional<Json> answer_line(Film& film, const std::string& line) {
  Json id = nullptr;
  const auto refuse = [&](int code, const std::string& why) {
    return Json{{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", why}}}};
  };
  const Json asked = Json::parse(line, nullptr, false);
  if (asked.is_discarded()) return refuse(-32700, "the line is not JSON");
  if (!asked.is_object() || !asked.contains("method") || !asked["method"].is_string())
    return refuse(-32600, "the line is not a request");
  if (!asked.contains("id")) return std::nullopt;  // a notification
  id = asked["id"];
  const Json params = asked.value("params", Json::object());
  if (!params.is_object()) return refuse(-32602, "the parameters are not an object");
  try {
    return Json{{"jsonrpc", "2.0"}, {"id", id}, {"result", answer_to(film, asked["method"], params)}};
  } catch (const Refused& r) {
    return refuse(r.code, r.why);
  } catch (const Json::exception&) {
    return refuse(-32602, "the parameters are of the wrong type");
  }
}

struct McpCall {
  std::string file;
};

int mcp(const McpCall& call) {
  Film film;
  if (!call.file.empty())
    if (const Outcome opened = open_film(film, {{"file", call.file}}); opened.wrong) {
      fmt::print(stderr, "{}", opened.text);
      return wrong_input;
    }
  std::string line;
  while (std::getline(std::cin, line)) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::optional<Json> answer;
    if (line.size() > longest_line || json_depth(line) > 100)
      answer =
          Json{{"jsonrpc", "2.0"}, {"id", nullptr}, {"error", {{"code", -32600}, {"message", "the line is too long"}}}};
    else
      answer = answer_line(film, line);
    if (!answer) continue;
    const std::string out = answer->dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    if (write_all(STDOUT_FILENO, out) != 0) return machine_failed;
  }
  return all_done;
}

const Enlisted enlisted_mcp(mcp, [](McpCall& call) -> Subcommand {
  return {
      .rank = 107,
      .name = "mcp",
      .sentence = "lets an assistant make a film and see it, over the Model Context Protocol",
      .takes = {{.name = "FILE", .sentence = "the film to begin with", .into = &call.file, .offer = Offer::scripts}},
      .example = "betwixt mcp film.bx",
      .manual =
          "The server reads requests from standard input, a line each. It opens and saves only films in the "
          "folder in which it was started, and runs no other program."};
});

}  // namespace
}  // namespace betwixt
