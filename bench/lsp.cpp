// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures how long an editor waits from a key to the diagnostics of the text, and for the requests after it, without
// the pipe. After each key the text must have no errors, or only the error that the key makes.
//   bench_lsp [KEYS]
#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "export/json.h"
#include "lsp/language_server.h"
#include "timing.h"

using namespace betwixt;

namespace {

// About 17 lines for each object, as films have them: its creation, sheets, lines about it alone and about many
// objects.
std::string film(std::size_t lines) {
  std::string text = "rate 24\nrange 1f 2000f\nfilm flat\nlet beat = 12f\n";
  std::size_t count = 4;
  for (int n = 1; count < lines; ++n) {
    std::string one = fmt::format("\n# thing {0}\ncreate thing{0} circle radius={1} color=gold position=({2} {3} 0)\n",
                                  n, 1 + n % 7, n % 40, n % 30);
    one += fmt::format("thing{}.position\n", n);
    for (int k = 0; k < 7; ++k)
      one += fmt::format("  {}f   ({} {} 0)  {}\n", 1 + 20 * k, (n * 7 + k) % 40, (n + k * k) % 30,
                         k % 3 == 0 ? "linear" : "ease-in=4f");
    one += fmt::format("thing{}.color\n  1f  red\n  beat*3  #aabbcc\n", n);
    one += fmt::format("at 24f hide thing{0}\nset thing{0}.transparency 0.5\n", n);
    if (n % 10 == 0) one += fmt::format("copy thing{}.position 1f..24f to 300f\n", n);
    if (n % 100 == 0) one += "set thing*.scale (2 2 2)\n";
    count += static_cast<std::size_t>(std::ranges::count(one, '\n'));
    text += one;
  }
  return text;
}

std::string events(int objects, int each) {
  std::string text = "rate 24\nfilm flat\n";
  for (int n = 0; n < objects; ++n) {
    text += fmt::format("create thing{0} circle\nthing{0}.position\n", n);
    for (int k = 0; k < each; ++k) text += fmt::format("  {}f  ({} {} 0)  linear\n", 1 + k, (n + k) % 40, k % 30);
  }
  return text;
}

class BenchEditor {
 public:
  explicit BenchEditor(const std::string& text) {
    say("initialize", Json::object(), true);
    say("textDocument/didOpen", {{"textDocument", {{"uri", uri}, {"version", 1}, {"text", text}}}}, false);
  }
  // Returns all messages of the server.
  std::string say(const char* method, Json params, bool asks) {
    Json message{{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
    if (asks) message["id"] = 1;
    const std::string text = message.dump();
    server_.come(fmt::format("Content-Length: {}\r\n\r\n{}", text.size(), text));
    while (server_.work()) {
    }
    return server_.take_out();
  }
  std::string key(std::size_t line, std::size_t from, std::size_t to, const char* text) {
    const Json range{{"start", {{"line", line}, {"character", from}}}, {"end", {{"line", line}, {"character", to}}}};
    return say("textDocument/didChange",
               {{"textDocument", {{"uri", uri}, {"version", 2}}},
                {"contentChanges", Json::array({{{"range", range}, {"text", text}}})}},
               false);
  }
  static constexpr const char* uri = "untitled:bench";

 private:
  LanguageServer server_;
};

void report_times(const std::string& what, std::vector<double> all) {
  std::ranges::sort(all);
  report((what + " p50").c_str(), all[all.size() / 2]);
  report((what + " p99").c_str(), all[all.size() * 99 / 100]);
}

void measure(const std::string& name, const std::string& text, int keys) {
  BenchEditor editor(text);
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
    lines.push_back(text.substr(at, text.find('\n', at) - at));
  report((name + " lines").c_str(), static_cast<double>(lines.size()));
  std::mt19937 random(7);
  std::vector<double> typed, completion, hover, symbols, colors;
  for (int n = 0; n < keys; ++n) {
    std::size_t line = 0;
    while (lines[line].size() < 5 || lines[line][0] == '#') line = random() % lines.size();
    const std::size_t end = lines[line].size();
    std::string said;
    typed.push_back(milliseconds([&] { said = editor.key(line, end, end, " ?"); }));
    insist(said.find("\"severity\":1") != std::string::npos, "an error is not said");
    typed.push_back(milliseconds([&] { said = editor.key(line, end, end + 2, ""); }));
    insist(said.find("\"diagnostics\":[]") != std::string::npos, "an error stays");
    const Json there{{"textDocument", {{"uri", editor.uri}}}, {"position", {{"line", line}, {"character", 4}}}};
    const auto ask = [&](const char* method) {
      return milliseconds([&] { insist(editor.say(method, there, true).find("result") != std::string::npos, method); });
    };
    completion.push_back(ask("textDocument/completion"));
    hover.push_back(ask("textDocument/hover"));
    if (n % 10 != 0) continue;
    symbols.push_back(ask("textDocument/documentSymbol"));
    colors.push_back(ask("textDocument/documentColor"));
  }
  report_times(name + " key-to-diagnostics", typed);
  report_times(name + " completion", completion);
  report_times(name + " hover", hover);
  report_times(name + " symbols", symbols);
  report_times(name + " colours", colors);
}

}  // namespace

int main(int count, char** words) {
  const int keys = count > 1 ? std::atoi(words[1]) : 100;
  measure("10,000-lines", film(10'000), keys);
  measure("100,000-events", events(100, 1000), keys);
}
