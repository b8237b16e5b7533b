// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "lsp/language_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/cancellation.h"
#include "base/files.h"
#include "base/json.h"
#include "base/utf8.h"
#include "commands/reader.h"
#include "lsp/state.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_used = std::size_t{64} << 20;  // bytes of a file that is searched for names

// Returns the span of a diagnostic. A diagnostic without a place gets the place where the script makes its subject.
Span place_of(const Diagnostic& d, const ScriptText& lines) {
  if (d.what.place.line > 0) return span_of(lines, d.what.place);
  const std::string& name = d.what.subject;
  for (std::size_t i = 0; i < lines.count(); ++i)
    if (const auto made = making(lines.line(i)); made && made->word == name)
      return {lines.start(i) + static_cast<std::size_t>(made->word.data() - lines.line(i).data()), name.size()};
  return {};
}

int severity_of(Severity s) { return s == Severity::error ? 1 : s == Severity::warning ? 2 : 3; }

Json diagnostic(const Diagnostic& d, const ScriptText& lines) {
  Json out{{"range", range_of(lines, place_of(d, lines))},
           {"severity", severity_of(d.severity)},
           {"source", "betwixt"},
           {"message", visible_lines(d.what.hint.empty() ? d.what.message : d.what.message + "\n" + d.what.hint)}};
  if (!d.what.instead.empty()) out["data"] = {{"instead", d.what.instead}};
  return out;
}

}  // namespace

const Json& member(const Json& object, const char* key) {
  static const Json nothing;
  const auto found = object.is_object() ? object.find(key) : object.end();
  return !object.is_object() || found == object.end() ? nothing : *found;
}

std::string text_member(const Json& object, const char* key) {
  const Json& there = member(object, key);
  return there.is_string() ? there.get<std::string>() : std::string();
}

std::string real_path(const std::string& path) {
  std::error_code why;
  const fs::path real = fs::weakly_canonical(path, why);
  return why ? path : real.string();
}

void LanguageServer::State::answer(const Json& id, const LspAnswer& answer) {
  Json message{{"jsonrpc", "2.0"}, {"id", id}};
  if (const auto* refusal = std::get_if<LspRefusal>(&answer))
    message["error"] = {{"code", refusal->code}, {"message", refusal->message}};
  else
    message["result"] = std::get<Json>(answer);
  send(message);
}

// Takes a waiting cancellation of this request. Returns false if there is none.
bool LanguageServer::State::cancelled(const Json& id) {
  const auto asks = [&](const Json& m) {
    return text_member(m, "method") == "$/cancelRequest" && member(member(m, "params"), "id") == id;
  };
  const auto found = std::ranges::find_if(waiting, asks);
  if (found == waiting.end()) return false;
  waiting.erase(found);
  return true;
}

void LanguageServer::State::handle(const Json& message) {
  if (!message.is_object()) return answer(nullptr, LspRefusal{LspRefusal::bad_request, "this is not a request"});
  const std::string method = text_member(message, "method");
  const auto id = message.find("id");
  const Json& params = member(message, "params");
  if (id == message.end()) return notified(method, params);
  // An answer that the server never asked for.
  if (method.empty() && (message.contains("result") || message.contains("error"))) return;
  if (!id->is_string() && !id->is_number_integer())
    return answer(nullptr, LspRefusal{LspRefusal::bad_request, "the id of a request must be a number or a string"});
  if (cancelled(*id)) return answer(*id, LspRefusal{LspRefusal::cancelled, "the request was cancelled"});
  if (shut) return answer(*id, LspRefusal{LspRefusal::bad_request, "the server is shut down"});
  if (!begun && method != "initialize")
    return answer(*id, LspRefusal{LspRefusal::not_begun, "the first request must be 'initialize'"});
  if (begun && method == "initialize")
    return answer(*id, LspRefusal{LspRefusal::bad_request, "'initialize' was already received"});
  const auto row = std::ranges::find(lsp_requests(), method, &LspRequest::method);
  if (row == lsp_requests().end())
    return answer(*id, LspRefusal{LspRefusal::unknown, fmt::format("there is no request '{}'", method)});
  answer(*id, row->answer(*this, params));
}

void LanguageServer::State::notified(const std::string& method, const Json& params) {
  if (method == "exit") over = true;
  if (!begun || shut || !params.is_object()) return;
  if (method == "textDocument/didOpen") did_open(params);
  if (method == "textDocument/didChange") did_change(params);
  if (method == "textDocument/didClose") did_close(params);
  if (method == "textDocument/didSave" || method == "workspace/didChangeWatchedFiles") files_changed();
}

OpenScript* LanguageServer::State::find(const Json& params) {
  const auto found = open.find(text_member(member(params, "textDocument"), "uri"));
  return found == open.end() ? nullptr : &found->second;
}

OpenScript* LanguageServer::State::find_real(const std::string& real) {
  const auto found = std::ranges::find_if(open, [&](const auto& o) { return o.second.real == real; });
  return real.empty() || found == open.end() ? nullptr : &found->second;
}

void LanguageServer::State::did_open(const Json& params) {
  const Json& document = member(params, "textDocument");
  const std::string uri = text_member(document, "uri");
  if (uri.empty()) return;
  open.erase(uri);
  OpenScript& script = open[uri];
  script.uri = uri, script.path = path_of_uri(uri).value_or(""), script.version = member(document, "version");
  if (!script.path.empty()) script.real = real_path(script.path);
  script.lines.assign(text_member(document, "text"));
  changed(script.real);
}

void LanguageServer::State::did_change(const Json& params) {
  OpenScript* const script = find(params);
  if (!script) return;
  for (const Json& change : member(params, "contentChanges")) {
    const std::string text = text_member(change, "text");
    if (member(change, "range").is_null())
      script->lines.assign(text);
    else if (const auto span = span_of(script->lines, member(change, "range")))
      script->lines.replace(*span, text);
  }
  script->version = member(member(params, "textDocument"), "version");
  script->stale = script->unsaid = true;
  changed(script->real);
}

void LanguageServer::State::did_close(const Json& params) {
  OpenScript* const script = find(params);
  if (!script) return;
  const std::string uri = script->uri, real = script->real;
  for (auto& [_, other] : open)
    if (script->uses.contains(other.real)) other.unsaid = true;  // it may be the root of a film again
  open.erase(uri);
  const auto said = published.extract(uri);
  if (!said.empty())
    for (const auto& [file, _] : said.mapped()) publish(file);
  changed(real);  // the file on disk counts again
}

// Reloads every film, because files that it reads may have changed.
void LanguageServer::State::files_changed() {
  for (auto& [_, script] : open) script.film = {}, script.stale = script.unsaid = true;
}

// Marks as stale the films that use a text.
void LanguageServer::State::changed(const std::string& real) {
  if (real.empty()) return;
  for (auto& [_, script] : open)
    if (script.uses.contains(real)) script.stale = script.unsaid = true;
}

// Loads a script's film. `said` replaces texts, by their real paths; other texts come from the editor or the disk.
Loaded LanguageServer::State::load(const OpenScript& script,
                                   const std::vector<std::pair<std::string, std::string>>& said,
                                   std::set<std::string>* uses) {
  LoadOptions how = options;
  if (script.path.empty()) how.read_nothing = true;
  const auto other = [&](const std::string& real) {
    const auto found = std::ranges::find(said, real, &std::pair<std::string, std::string>::first);
    return found == said.end() ? nullptr : &found->second;
  };
  how.written = [&](const std::string& real) -> std::optional<std::string> {
    if (uses) uses->insert(real);
    if (const std::string* text = other(real)) return *text;
    const OpenScript* const there = find_real(real);
    return there ? std::optional(there->lines.text()) : std::nullopt;
  };
  const std::string* text = other(script.real);
  return load_text_again(text ? *text : script.lines.text(), script.path.empty() ? script.uri : script.path, how,
                         script.film.document);
}

void LanguageServer::State::refresh(OpenScript& script) {
  if (!script.stale) return;
  std::set<std::string> uses;
  Loaded film = load(script, {}, &uses);
  for (auto& [_, other] : open)  // marks texts that have joined this film or left it
    if (uses.contains(other.real) != script.uses.contains(other.real)) other.unsaid = true;
  script.names.reset(), script.texts.clear();
  script.film = std::move(film), script.uses = std::move(uses), script.stale = false;
}

// Returns true if another open script uses this one. If two use each other, the first by URI is the root.
bool LanguageServer::State::is_part(const OpenScript& script) const {
  return std::ranges::any_of(open, [&](const auto& o) {
    const OpenScript& other = o.second;
    return &other != &script && other.uses.contains(script.real) &&
           !(script.uses.contains(other.real) && script.uri < other.uri);
  });
}

OpenScript& LanguageServer::State::root_of(OpenScript& script) {
  for (auto& [_, other] : open) refresh(other);
  OpenScript* root = &script;
  for (auto& [_, other] : open)
    if (!script.real.empty() && other.uses.contains(script.real) && !is_part(other)) root = &other;
  return *root;
}

const TextNames& LanguageServer::State::names_of(OpenScript& root) {
  if (root.names) return *root.names;
  root.texts.push_back({root.path, root.lines});
  for (const std::string& real : root.uses) {
    const OpenScript* const there = find_real(real);
    if (there == &root) continue;
    root.texts.push_back({there ? there->path : real, there ? there->lines : ScriptText()});
    if (!there) root.texts.back().lines.assign(read_contents(real, {.largest = longest_used}).text);
  }
  root.names = std::make_unique<TextNames>(root.texts, root.film.document);
  return *root.names;
}

std::size_t LanguageServer::State::text_in(const OpenScript& root, const OpenScript& script) const {
  for (std::size_t i = 1; i < root.texts.size(); ++i)
    if (root.texts[i].path == script.path) return i;
  return 0;
}

std::string LanguageServer::State::uri_of(const std::string& path) const {
  const std::string real = real_path(path);
  for (const auto& [uri, script] : open)
    if (script.real == real || (script.path.empty() && uri == path)) return uri;
  return uri_of_path(fs::path(path).lexically_normal().string());
}

// Publishes the diagnostics of one text. Returns false if all have been published.
bool LanguageServer::State::say_one() {
  for (auto& [_, script] : open) {
    if (!script.unsaid) continue;
    refresh(script);
    script.unsaid = false;
    say(script);
    return true;
  }
  return false;
}

void LanguageServer::State::say(OpenScript& script) {
  std::map<std::string, std::vector<Json>> now{{script.uri, {}}};
  std::map<std::string, ScriptText> read;  // files that are not open
  const std::string own = script.path.empty() ? script.uri : script.path;
  for (const Diagnostic& d : is_part(script) ? Diagnostics() : script.film.diagnostics) {
    const std::string& file = d.what.place.file;
    const bool here = file.empty() || file == own;
    OpenScript* const there = here ? &script : find_real(real_path(file));
    if (!there && !read.contains(file)) read[file].assign(read_contents(file, {.largest = longest_used}).text);
    now[there ? there->uri : uri_of(file)].push_back(diagnostic(d, there ? there->lines : read[file]));
  }
  std::set<std::string> files;
  for (const auto& [file, _] : published[script.uri]) files.insert(file);
  for (const auto& [file, _] : now) files.insert(file);
  published[script.uri] = std::move(now);
  for (const std::string& file : files) publish(file);
}

// Publishes what all films say about a file.
void LanguageServer::State::publish(const std::string& uri) {
  Json all = Json::array();
  for (const auto& [_, files] : published) {
    const auto found = files.find(uri);
    if (found == files.end()) continue;
    // Two films that use one file give the same diagnostic only once.
    const auto others = static_cast<std::ptrdiff_t>(all.size());
    for (const Json& d : found->second)
      if (std::find(all.begin(), all.begin() + others, d) == all.begin() + others) all.push_back(d);
  }
  Json params{{"uri", uri}};
  if (const auto script = open.find(uri); script != open.end() && script->second.version.is_number_integer())
    params["version"] = script->second.version;
  params["diagnostics"] = std::move(all);
  send({{"jsonrpc", "2.0"}, {"method", "textDocument/publishDiagnostics"}, {"params", std::move(params)}});
}

// The deepest nesting of a message. Deeper JSON would overflow the stack when it is copied, answered or freed.
constexpr std::size_t deepest = 200;

LanguageServer::LanguageServer(const LoadOptions& options, const std::atomic<bool>* called_off)
    : state_(std::make_unique<State>()) {
  state_->options = options, state_->called_off = called_off;
  state_->options.tex = false;  // an unfinished script must not run programs
}
LanguageServer::~LanguageServer() = default;

void LanguageServer::come(std::string_view bytes) {
  State& s = *state_;
  s.frames.take(bytes);
  std::string refused;
  while (const auto message = s.frames.next(&refused)) {
    Json read =
        json_depth(*message) <= deepest ? Json::parse(*message, nullptr, false) : Json(Json::value_t::discarded);
    if (read.is_discarded())
      s.answer(nullptr, LspRefusal{LspRefusal::bad_message, "this is not JSON, or it is nested too deeply"});
    else
      s.waiting.push_back(std::move(read));
  }
  if (!refused.empty()) s.answer(nullptr, LspRefusal{LspRefusal::bad_message, refused});
}

bool LanguageServer::work() {
  State& s = *state_;
  if (s.over) return false;
  if (!s.waiting.empty()) {
    const Json message = std::move(s.waiting.front());
    s.waiting.pop_front();
    s.handle(message);
    return true;
  }
  static const std::atomic<bool> never = false;
  static const std::atomic<int> none = 0;
  try {
    const Cancellation wanted(s.called_off ? *s.called_off : never, never, none, {});
    return s.say_one();
  } catch (const Cancelled&) {
    return false;
  }
}

bool LanguageServer::idle() const { return state_->waiting.empty(); }
std::string LanguageServer::take_out() { return std::exchange(state_->out, {}); }
bool LanguageServer::over() const { return state_->over; }
int LanguageServer::exit_code() const { return state_->shut ? 0 : 1; }

}  // namespace betwixt
