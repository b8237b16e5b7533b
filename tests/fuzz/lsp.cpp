// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fuzzes the language server with messages of an editor. The input up to the first line that begins with ':' is an open
// text. The lines after it are the actions of the editor:
//
//   :eN,M TEXT  replaces M characters at N by TEXT, in which ~ is a new line
//   :?N         sends all requests about position N
//   :rN NAME    renames the name at position N to NAME, and back
//   :!BYTES     sends these bytes unchanged; ~~ is the end of a header
//
// Checks that each request gets one answer, that the diagnostics of a changed text equal those of the same text opened
// anew, that a formatted text does not change when it is formatted again, that the range of a symbol contains its name,
// and that renaming there and back gives the old text.
#include <cstdint>
#include <map>

#include "fuzz.h"
#include "language/lines.h"
#include "lsp/language_server.h"
#include "lsp/state.h"

using namespace betwixt;

namespace {

const std::string uri = "untitled:1";
constexpr std::size_t most_steps = 30;

class Editing {
 public:
  explicit Editing(const std::string& text) : lines_(text) {
    ask("initialize", Json::object());
    tell("textDocument/didOpen", {{"textDocument", {{"uri", uri}, {"version", 1}, {"text", text}}}});
  }
  const std::string& text() const { return lines_.text(); }
  std::string said() const { return said_; }

  void bytes(std::string_view b) {
    server_.come(b);
    while (server_.work()) {
    }
    frames_.take(server_.take_out());
    while (const auto m = frames_.next()) {
      const Json message = Json::parse(*m, nullptr, false);
      insist(!message.is_discarded(), "what is sent is JSON", *m);
      if (message.contains("method"))
        said_ = message["params"]["diagnostics"].dump();
      else
        insist(message.contains("result") != message.contains("error"), "an answer is a result or an error", *m),
            answers_[message["id"].dump()].push_back(message);
    }
  }
  void tell(std::string_view method, Json params) { send({{"method", method}, {"params", std::move(params)}}); }
  Json ask(std::string_view method, Json params) {
    send({{"id", ++last_}, {"method", method}, {"params", std::move(params)}});
    const auto& all = answers_[std::to_string(last_)];
    insist(all.size() == 1 || broken_, "a request has one answer", method);
    return all.empty() ? Json() : all[0].value("result", Json());
  }
  Json of(std::string_view what, Json more = Json::object()) {
    more["textDocument"] = {{"uri", uri}};
    return ask("textDocument/" + std::string(what), std::move(more));
  }
  Json at(std::string_view what, std::size_t place, Json more = Json::object()) {
    more["position"] = position_at(lines_, std::min(place, text().size()));
    return of(what, std::move(more));
  }
  void edit(std::size_t at, std::size_t size, const std::string& text) {
    at = std::min(at, lines_.text().size());
    const Json range = range_of(lines_, {at, std::min(size, lines_.text().size() - at)});
    lines_.replace(*span_of(lines_, range), text);
    Json change{{"range", range}, {"text", text}};
    tell("textDocument/didChange", {{"textDocument", {{"uri", uri}}}, {"contentChanges", Json::array({change})}});
  }
  // Edits that an answer holds, from the last to the first.
  void put(const Json& edits) {
    if (edits.is_array())
      for (auto e = edits.rbegin(); e != edits.rend(); ++e) {
        const Span span = *span_of(lines_, (*e)["range"]);
        edit(span.at, span.size, (*e)["newText"].get<std::string>());
      }
  }
  void nonsense(std::string_view b) { broken_ = true, bytes(b); }

 private:
  void send(Json m) {
    m["jsonrpc"] = "2.0";
    bytes(LspFrames::framed(m.dump(-1, ' ', false, Json::error_handler_t::replace)));
  }
  LanguageServer server_;
  LspFrames frames_;
  ScriptText lines_;
  std::map<std::string, std::vector<Json>> answers_;
  std::string said_;
  int last_ = 0;
  bool broken_ = false;  // what came is no message, so nobody knows where the next one begins
};

std::size_t number(std::string_view& rest) {
  std::size_t n = 0;
  while (!rest.empty() && rest[0] >= '0' && rest[0] <= '9') {
    n = std::min<std::size_t>(10 * n + static_cast<std::size_t>(rest[0] - '0'), 100'000);
    rest.remove_prefix(1);
  }
  if (!rest.empty() && (rest[0] == ',' || rest[0] == ' ')) rest.remove_prefix(1);
  return n;
}

void ask_all(Editing& editing, std::size_t place) {
  for (const char* what :
       {"completion", "hover", "signatureHelp", "definition", "references", "documentHighlight", "prepareRename"})
    editing.at(what, place);
  for (const char* what : {"foldingRange", "documentColor", "codeAction"}) editing.of(what);
}

void rename_there_and_back(Editing& editing, std::size_t place, const std::string& name) {
  const Json before = editing.at("prepareRename", place);
  if (!before.is_object()) return;
  const std::string text = editing.text();
  const ScriptText lines(text);
  const Span was = *span_of(lines, before["range"]);
  const Json there = editing.at("rename", was.end(), {{"newName", name}});
  if (!there.is_object() || there["changes"].empty()) return;
  const Json& edits = there["changes"][uri];
  std::size_t moved = was.at;  // how far it is by then
  for (const Json& e : edits) {
    const Span s = *span_of(lines, e["range"]);
    if (s.at < was.at) moved += name.size() - s.size;
  }
  editing.put(edits);
  const Json back = editing.at("rename", moved + name.size(), {{"newName", before["placeholder"]}});
  if (!back.is_object()) return;  // a film with errors: nobody can tell
  editing.put(back["changes"][uri]);
  insist(editing.text() == text, "there and back is the same text", editing.text());
}

void look_over_text(Editing& editing) {
  const std::string text = editing.text();
  Editing fresh(text);
  insist(fresh.said() == editing.said(), "an edited text is the text it has become", text);
  const ScriptText lines(text);
  if (const Json symbols = editing.of("documentSymbol"); symbols.is_array())
    for (const Json& s : symbols) {
      const Span at = *span_of(lines, s["selectionRange"]), whole = *span_of(lines, s["range"]);
      insist(text.substr(at.at, at.size) == s["name"].get<std::string>(), "a symbol's place holds its name", text);
      insist(whole.at <= at.at && at.end() <= whole.end(), "a symbol's place is in its lines", text);
    }
  if (editing.said().find("\"severity\":1") != std::string::npos) return;  // who says what was meant?
  editing.put(editing.of("formatting"));
  insist(editing.of("formatting").empty(), "a tidy text is tidy", editing.text());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Slow slow;
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  if (makes_many(all) || unsound(all)) return -1;
  const std::size_t steps = all.find("\n:");
  const std::size_t end = all.starts_with(':') ? 0 : steps == std::string_view::npos ? all.size() : steps + 1;
  Editing editing(std::string(all.substr(0, end)));
  std::string_view rest = all.substr(end);
  bool nonsense = false;
  for (std::size_t n = 0; !rest.empty() && n < most_steps; ++n) {
    const std::size_t stop = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, stop);
    rest.remove_prefix(std::min(rest.size(), stop + 1));
    if (line.size() < 2 || line[0] != ':') continue;
    const char what = line[1];
    line.remove_prefix(2);
    if (what == '!') {
      std::string bytes(line);
      for (std::size_t at = 0; (at = bytes.find("~~", at)) != std::string::npos;) bytes.replace(at, 2, "\r\n\r\n");
      nonsense = true;
      editing.nonsense(bytes);
      continue;
    }
    const std::size_t at = number(line);
    if (what == 'e') {
      const std::size_t gone = number(line);
      std::string text(line);
      std::ranges::replace(text, '~', '\n');
      editing.edit(at, gone, text);
    }
    if (what == '?') ask_all(editing, at);
    if (what == 'r' && !nonsense) rename_there_and_back(editing, at, std::string(line));
  }
  if (!nonsense) look_over_text(editing);
  return slow.verdict();
}
