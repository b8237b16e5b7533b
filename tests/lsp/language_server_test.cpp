// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the language server without pipes: messages, positions in UTF-16, changes of texts, and invalid messages.
#include "lsp/language_server.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "base/cancellation.h"
#include "lsp/state.h"
#include "support/folder.h"

namespace betwixt {
namespace {

TEST(LspFrames, AMessageIsWholeHoweverItComes) {
  const std::string two = LspFrames::framed("{}") + "content-LENGTH:  3\nContent-Type: x\n\n[1]";
  for (std::size_t step = 1; step < two.size(); ++step) {
    LspFrames frames;
    std::string all;
    for (std::size_t at = 0; at < two.size(); at += step) {
      frames.take(std::string_view(two).substr(at, step));
      while (const auto m = frames.next()) all += *m + ";";
    }
    ASSERT_EQ(all, "{};[1];") << step;
  }
}

TEST(LspFrames, WhatIsNoMessageIsPassedOver) {
  LspFrames frames;
  std::string why;
  frames.take("Content-Length: x\r\n\r\n" + LspFrames::framed("1"));
  EXPECT_EQ(frames.next(&why), "1");
  EXPECT_EQ(why, "this is not a message: its length is missing");
  frames.take("Content-Length: 18446744073709551615\r\n\r\n");
  EXPECT_EQ(frames.next(&why), std::nullopt);
  EXPECT_NE(why.find("can have at most"), std::string::npos);
  LspFrames long_one;
  long_one.take(fmt::format("Content-Length: {}\r\n\r\n", LspFrames::longest + 1));
  EXPECT_EQ(long_one.next(&why), std::nullopt);
  long_one.take(std::string(LspFrames::longest / 2, ' '));
  EXPECT_EQ(long_one.next(), std::nullopt);
  long_one.take(std::string(LspFrames::longest / 2 + 1, ' ') + LspFrames::framed("2"));
  EXPECT_EQ(long_one.next(), "2");
  LspFrames noise;
  noise.take(std::string(20'000, 'x'));
  EXPECT_EQ(noise.next(&why), std::nullopt);
  noise.take(LspFrames::framed("3"));
  EXPECT_EQ(noise.next(), "3");
}

// A length that is wrong, to either side, costs that message, and one more where it ends in its head, however the bytes
// come.
TEST(LspFrames, AWrongLengthCostsOneMessage) {
  for (const std::size_t wrong : {std::size_t{0}, std::size_t{1}, std::size_t{9}, std::size_t{11}, std::size_t{40},
                                  std::size_t{90}, std::size_t{100'000'000}, LspFrames::longest + 1})
    for (const std::size_t step : {std::size_t{1}, std::size_t{7}, std::size_t{1000}}) {
      const std::string all = fmt::format("Content-Length: {}\r\n\r\n{{\"id\": 12}}", wrong) +
                              LspFrames::framed("[2]") + LspFrames::framed("[3]") + LspFrames::framed("[4]");
      LspFrames frames;
      std::vector<std::string> got;
      for (std::size_t at = 0; at < all.size(); at += step) {
        frames.take(std::string_view(all).substr(at, step));
        while (auto m = frames.next()) got.push_back(*m);
      }
      if (wrong == 11) got.insert(got.end() - 2, "[2]");
      ASSERT_GE(got.size(), 3u) << wrong << " " << step;
      EXPECT_EQ(std::vector(got.end() - 3, got.end()), (std::vector<std::string>{"[2]", "[3]", "[4]"})) << wrong;
    }
}

// a, an emoji of two units, e with a mark of its own, a return before the end.
const std::string wide = "a\U0001F600b\r\ne\u0301x\n\u00fc";

TEST(LspPlaces, CountUnitsOfUtf16) {
  const ScriptText lines(wide);
  const auto at = [&](std::size_t place) {
    const Json p = position_at(lines, place);
    return fmt::format("{}:{}", p["line"].get<int>(), p["character"].get<int>());
  };
  EXPECT_EQ(at(wide.find('b')), "0:3");
  EXPECT_EQ(at(wide.find('\r')), "0:4");
  EXPECT_EQ(at(wide.find('\n')), "0:4") << "behind the return is the end of the line";
  EXPECT_EQ(at(wide.find('x')), "1:2");
  EXPECT_EQ(at(wide.size()), "2:1");
  const auto back = [&](int line, int unit) { return *place_of(lines, {{"line", line}, {"character", unit}}); };
  EXPECT_EQ(back(0, 3), wide.find('b'));
  EXPECT_EQ(back(0, 2), 1u) << "in the middle of an emoji: where that begins";
  EXPECT_EQ(back(0, 99), wide.find('\r'));
  EXPECT_EQ(back(1, 1), wide.find('e') + 1);
  EXPECT_EQ(back(7, 0), wide.size());
  EXPECT_FALSE(place_of(lines, {{"line", -1}, {"character", 0}}));
  EXPECT_FALSE(place_of(lines, {{"line", "1"}, {"character", 0}}));
  // Betwixt's own columns are characters.
  EXPECT_EQ(span_of(lines, Place{"", 1, 3, 1}).at, wide.find('b'));
  EXPECT_EQ(utf16_units("\U0001F600\u00fc"), 3u);
}

TEST(LspPlaces, FilesAreUris) {
  EXPECT_EQ(path_of_uri("file:///a%20b/c.bx"), "/a b/c.bx");
  EXPECT_EQ(path_of_uri("file://machine/c.bx"), "/c.bx");
  EXPECT_EQ(path_of_uri("untitled:Untitled-1"), std::nullopt);
  EXPECT_EQ(path_of_uri("file:///a%00b"), std::nullopt);
  EXPECT_EQ(path_of_uri("file:///50%"), "/50%");
  EXPECT_EQ(uri_of_path("/a b/\u00fc.bx"), "file:///a%20b/%C3%BC.bx");
}

// An editor that says things and reads what comes.
class Says {
 public:
  explicit Says(const LoadOptions& options = {}) : server_(options) {
    ask("initialize", Json::object());
    tell("initialized", Json::object());
  }
  void bytes(std::string_view b) { server_.come(b), run(); }
  Json ask(std::string_view method, Json params) {
    send({{"jsonrpc", "2.0"}, {"id", ++last_}, {"method", method}, {"params", std::move(params)}});
    for (const Json& m : got)
      if (m.contains("id") && m["id"] == last_) return m;
    return nullptr;
  }
  void tell(std::string_view method, Json params) {
    send({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
  }
  void open(const std::string& uri, const std::string& text) {
    tell("textDocument/didOpen", {{"textDocument", {{"uri", uri}, {"version", 1}, {"text", text}}}});
  }
  void change(const std::string& uri, Json changes) {
    tell("textDocument/didChange", {{"textDocument", {{"uri", uri}, {"version", 2}}}, {"contentChanges", changes}});
  }
  // What was said of a text last.
  Json said_of(const std::string& uri) const {
    for (auto m = got.rbegin(); m != got.rend(); ++m)
      if (m->contains("params") && (*m)["params"]["uri"] == uri) return (*m)["params"]["diagnostics"];
    return nullptr;
  }
  std::string messages(const std::string& uri) const {
    std::string all;
    for (const Json& d : said_of(uri)) all += d["message"].get<std::string>() + ";";
    return all;
  }
  void send(const Json& m) { bytes(LspFrames::framed(m.dump())); }
  LanguageServer& server() { return server_; }
  std::vector<Json> got;

 private:
  void run() {
    while (server_.work()) {
    }
    frames_.take(server_.take_out());
    while (const auto m = frames_.next()) got.push_back(Json::parse(*m));
  }
  LanguageServer server_;
  LspFrames frames_;
  int last_ = 0;
};

// Some warnings are about no line, but about an object.
TEST(Lsp, AWarningWithoutALineIsWhereItsObjectIsMade) {
  Says s;
  s.open("untitled:1", "create arm box\ncreate palm sphere\ncouple palm to arm\nset palm.reach arm\n");
  const Json said = s.said_of("untitled:1");
  ASSERT_EQ(said.size(), 1U) << said;
  EXPECT_EQ(said[0]["range"],
            (Json{{"start", {{"line", 1}, {"character", 7}}}, {"end", {{"line", 1}, {"character", 11}}}}));
}

TEST(Lsp, BeginsAndEndsAsTheProtocolSays) {
  LanguageServer early;
  early.come(LspFrames::framed(R"({"id":1,"method":"textDocument/hover","params":{}})"));
  while (early.work()) {
  }
  EXPECT_NE(early.take_out().find("-32002"), std::string::npos);
  early.come(LspFrames::framed(R"({"method":"exit"})"));
  EXPECT_TRUE(early.work());
  EXPECT_TRUE(early.over());
  EXPECT_EQ(early.exit_code(), 1);
  Says s;
  EXPECT_EQ(s.ask("initialize", Json::object())["error"]["code"], -32600) << "only once";
  EXPECT_EQ(s.ask("shutdown", nullptr)["result"], nullptr);
  EXPECT_EQ(s.ask("textDocument/hover", Json::object())["error"]["code"], -32600);
  s.tell("exit", nullptr);
  EXPECT_EQ(s.server().exit_code(), 0);
}

TEST(Lsp, NonsenseIsAnsweredInWords) {
  Says s;
  EXPECT_EQ(s.ask("textDocument/dance", Json::object())["error"]["code"], -32601);
  EXPECT_EQ(s.ask("textDocument/hover", Json::array())["error"]["code"], -32602);
  EXPECT_EQ(s.ask("textDocument/rename", {{"textDocument", 3}})["error"]["code"], -32602);
  s.bytes(LspFrames::framed("{"));
  EXPECT_EQ(s.got.back()["error"]["code"], -32700);
  s.bytes(LspFrames::framed("\"\xff\""));
  EXPECT_EQ(s.got.back()["error"]["code"], -32700);
  s.bytes(LspFrames::framed("[]"));
  EXPECT_EQ(s.got.back()["error"]["code"], -32600);
  s.bytes(LspFrames::framed(R"({"id":{},"method":"shutdown"})"));
  EXPECT_EQ(s.got.back()["error"]["code"], -32600);
  const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');
  for (const std::string& message :
       {"{\"id\":" + deep + ",\"method\":\"shutdown\"}", "{\"id\":1,\"params\":" + deep + "}", deep}) {
    s.bytes(LspFrames::framed(message));
    EXPECT_EQ(s.got.back()["error"]["code"], -32700);
  }
  for (const Json& params : {Json(), Json(3), Json::object(), Json{{"textDocument", nullptr}}})
    for (const char* method : {"textDocument/didOpen", "textDocument/didChange", "textDocument/didClose", "$/what"})
      s.tell(method, params);
  s.change("file:///nobody.bx", Json::array());
  EXPECT_EQ(s.ask("shutdown", nullptr)["result"], nullptr);
}

TEST(Lsp, ARequestThatIsCancelledIsNotWorkedOut) {
  LanguageServer server;
  server.come(LspFrames::framed(R"({"id":1,"method":"initialize","params":{}})") +
              LspFrames::framed(R"({"id":"a","method":"textDocument/hover","params":{}})") +
              LspFrames::framed(R"({"method":"$/cancelRequest","params":{"id":"a"}})") +
              LspFrames::framed(R"({"method":"$/cancelRequest","params":{"id":"b"}})"));
  while (server.work()) {
  }
  const std::string out = server.take_out();
  EXPECT_NE(out.find("-32800"), std::string::npos);
  EXPECT_EQ(out.find("-32602"), std::string::npos);
}

TEST(Lsp, DiagnosticsStandWhereTheyAreInUtf16) {
  Says s;
  s.open("untitled:1", "create ball sphere\r\nat 1f note \"\U0001F600\u0301\" oops\r\n");
  const Json all = s.said_of("untitled:1");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0]["range"].dump(), R"({"start":{"line":1,"character":17},"end":{"line":1,"character":21}})");
  EXPECT_EQ(all[0]["severity"], 1);
  s.change("untitled:1", Json::array({{{"range", all[0]["range"]}, {"text", ""}}}));
  EXPECT_EQ(s.said_of("untitled:1"), Json::array());
}

TEST(Lsp, EndsOfLinesStayWhatTheyAre) {
  Says s;
  const auto tidied = [&](const char* text) {
    s.open("untitled:1", text);
    const Json edits = s.ask("textDocument/formatting", {{"textDocument", {{"uri", "untitled:1"}}}})["result"];
    return edits.empty() ? "" : edits[0]["newText"].get<std::string>();
  };
  EXPECT_EQ(tidied("create  a  box\r\nset a.color   red\r\n"), "create a box\r\nset a.color red\r\n");
  EXPECT_EQ(tidied("create  a  box\nset a.color   red\n"), "create a box\nset a.color red\n");
  EXPECT_EQ(tidied("create  a  (\r\n"), "") << "what cannot be told apart is left alone";
  EXPECT_EQ(tidied("at 1f  note \"\"\"a\r\nb\"\"\"\r\n"), "at 1f note \"\"\"a\r\n") << "the rest is as it was";
}

TEST(Lsp, WhatIsSaidOfTheWholeFilmStandsWhereItIsSaid) {
  Says s;
  s.open("untitled:1", "create eye camera\nset eye.height 3\nset eye.f-stop 2\n");
  const Json all = s.said_of("untitled:1");
  ASSERT_EQ(all.size(), 1u) << all.dump();
  EXPECT_EQ(all[0]["message"].get<std::string>().substr(0, 15), "eye has a heigh");
  EXPECT_EQ(all[0]["range"].dump(), R"({"start":{"line":2,"character":0},"end":{"line":2,"character":16}})");
}

// A correction is a field of the diagnostic. Texts that only look like one offer none, and editors may drop the field.
TEST(Lsp, CorrectionsAreOffered) {
  Says s;
  s.open("untitled:1", "create ball spher\ncreate b text text=\"did you mean 'x'?\" zzz=1\n");
  Json all = s.said_of("untitled:1");
  ASSERT_EQ(all.size(), 2u) << all.dump();
  std::vector<std::string> fixes;
  for (Json d : all) {
    d.erase("data");
    const Json params{{"textDocument", {{"uri", "untitled:1"}}},
                      {"range", d["range"]},
                      {"context", {{"diagnostics", Json::array({d})}}}};
    const Json answer = s.ask("textDocument/codeAction", params);
    for (const Json& a : answer["result"])
      fixes.push_back(a["edit"]["changes"]["untitled:1"][0]["newText"].get<std::string>());
  }
  EXPECT_EQ(fixes, (std::vector<std::string>{"sphere"}));
}

TEST(Lsp, OtherFilesHaveWhatIsSaidOfThem) {
  const Folder folder;
  folder.put("part.bx", "create ball sphere\nset ball.radius\n");
  folder.put("main.bx", "");
  Says s;
  const std::string main = "file://" + (folder / "main.bx"), part = "file://" + (folder / "part.bx");
  s.open(main, "use part.bx\nset ball.radios 2\n");
  EXPECT_NE(s.messages(main).find("has no function 'radios'"), std::string::npos);
  EXPECT_EQ(s.said_of(part).size(), 1u);
  // What is written counts, and not what is on the disk. Alone it would lack a name.
  s.open(part, "set lamp.range 3\ncreate ball sphere\n");
  EXPECT_NE(s.messages(part).find("'lamp'"), std::string::npos) << s.messages(part);
  s.change(main, Json::array({{{"text", "create lamp light\nuse part.bx\nset ball.radius 2\n"}}}));
  EXPECT_EQ(s.messages(main), "");
  EXPECT_EQ(s.messages(part), "");
  // Names go from one to the other.
  const auto at = [](const std::string& uri, int line, int unit) {
    return Json{{"textDocument", {{"uri", uri}}}, {"position", {{"line", line}, {"character", unit}}}};
  };
  EXPECT_EQ(s.ask("textDocument/definition", at(part, 0, 5))["result"][0]["uri"], main);
  EXPECT_EQ(s.ask("textDocument/definition", at(main, 2, 5))["result"][0]["uri"], part);
  EXPECT_EQ(s.ask("textDocument/definition", at(main, 1, 6))["result"][0]["uri"], part);
  Json rename = at(main, 2, 5);
  rename["newName"] = "orb";
  const Json changes = s.ask("textDocument/rename", rename)["result"]["changes"];
  EXPECT_EQ(changes[main].size(), 1u);
  EXPECT_EQ(changes[part].size(), 1u);
  // Alone again it lacks its name again.
  s.tell("textDocument/didClose", {{"textDocument", {{"uri", main}}}});
  EXPECT_EQ(s.messages(main), "");
  EXPECT_NE(s.messages(part).find("'lamp'"), std::string::npos) << s.messages(part);
}

TEST(Lsp, NothingIsReadBeyondTheFolderAndForTextsWithoutAFile) {
  const Folder folder;
  folder.put("secret.bx", "create ball sphere\n");
  folder.put("in/film.bx", "");
  Says s;
  const std::string uri = "file://" + (folder / "in/film.bx");
  s.open(uri, "use ../secret.bx\n");
  EXPECT_NE(s.messages(uri).find("outside the script's folder"), std::string::npos);
  s.open("untitled:1", "use " + (folder / "secret.bx") + "\n");
  EXPECT_NE(s.messages("untitled:1").find("outside the script's folder"), std::string::npos);
  const std::string tex = "create f text tex=\"x\"\n";
  s.change(uri, Json::array({{{"text", tex}}}));
  EXPECT_EQ(s.messages(uri).find("a script may not run"), std::string::npos);  // formulas need no program
}

TEST(Lsp, WhatIsSaidIsLeftOffWhenMoreComes) {
  std::atomic<bool> more = true;
  LanguageServer server({}, &more);
  server.come(
      LspFrames::framed(R"({"id":1,"method":"initialize","params":{}})") +
      LspFrames::framed(R"({"method":"textDocument/didOpen","params":{"textDocument":{"uri":"u:1","text":"x"}}})"));
  while (server.work()) {
  }
  EXPECT_EQ(server.take_out().find("publishDiagnostics"), std::string::npos);
  more = false;
  EXPECT_TRUE(server.work());
  EXPECT_NE(server.take_out().find("there is no command 'x'"), std::string::npos);
}

// After edits by chance everything is said as of a text that was opened as it is by then.
TEST(Lsp, AnEditedTextIsTheTextItHasBecome) {
  const std::vector<std::string> bits = {"create a sphere\n",
                                         "set a.radius 2\n",
                                         "a.position\n",
                                         "  1f (1 2 3)\n",
                                         "\n",
                                         "\r\n",
                                         "\"\"\"",
                                         "(",
                                         ")",
                                         "\U0001F600",
                                         "a",
                                         " ",
                                         "let k = 3\n",
                                         "set a.radius k\n",
                                         "e\u0301"};
  std::mt19937 random(3);
  const auto up_to = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (int round = 0; round < 12; ++round) {
    std::string text = "create a sphere\n\U0001F600 a\r\n";
    Says edited;
    edited.open("u:1", text);
    for (int edit = 0; edit < 25; ++edit) {
      const ScriptText lines(text);
      std::size_t from = up_to(text.size() + 1), to = std::min(text.size(), from + up_to(6));
      const Json range = range_of(lines, {from, to - from});
      const Span meant = *span_of(lines, range);  // of whole characters
      const std::string& bit = bits[up_to(bits.size())];
      text.replace(meant.at, meant.size, bit);
      edited.change("u:1", Json::array({{{"range", range}, {"text", bit}}}));
    }
    Says fresh;
    fresh.open("u:1", text);
    ASSERT_EQ(edited.said_of("u:1"), fresh.said_of("u:1")) << text;
    for (const char* what : {"documentSymbol", "foldingRange", "documentColor", "formatting"}) {
      const Json params{{"textDocument", {{"uri", "u:1"}}}};
      const std::string method = std::string("textDocument/") + what;
      ASSERT_EQ(edited.ask(method, params)["result"], fresh.ask(method, params)["result"]) << text;
    }
  }
}

}  // namespace
}  // namespace betwixt
