// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The texts that an editor has open, the films that they make, and what waits to be answered.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "editor/renaming.h"
#include "editor/text_names.h"
#include "export/json.h"
#include "server/lsp.h"
#include "server/lsp_frames.h"
#include "server/lsp_places.h"

namespace betwixt {

// What is said by a key; null where nothing is.
const Json& member(const Json& object, const char* key);
std::string text_member(const Json& object, const char* key);

// Without links and dots, where that can be told.
std::string real_path(const std::string& path);

// A text that is open in the editor, and what it makes as a script.
struct OpenScript {
  std::string uri, path;  // path: empty where it is no file
  std::string real;       // path without links
  Json version;
  TextLines lines;
  bool stale = true, unsaid = true;  // the film is of an older text; nothing has been said of it yet
  Loaded film;
  std::set<std::string> uses;  // real paths of scripts, as it was loaded last
  // Of the film's texts, this one first; made where somebody asks for names.
  std::vector<FilmText> texts;
  std::unique_ptr<TextNames> names;
};

// Why there is no answer, with a code of the protocol.
struct LspRefusal {
  static constexpr int bad_message = -32700, bad_request = -32600, unknown = -32601, bad_parameters = -32602,
                       not_begun = -32002, cancelled = -32800, failed = -32803;
  int code = failed;
  std::string message;
};
using LspAnswer = std::variant<Json, LspRefusal>;

struct LanguageServer::State {
  LoadOptions options;
  const std::atomic<bool>* called_off = nullptr;
  LspFrames frames;
  std::deque<Json> waiting;
  std::string out;
  bool begun = false, shut = false, over = false;

  std::map<std::string, OpenScript> open;                                     // by URI
  std::map<std::string, std::map<std::string, std::vector<Json>>> published;  // by URI of the script, and the file's

  void send(const Json& message) {
    out += LspFrames::framed(message.dump(-1, ' ', false, Json::error_handler_t::replace));
  }
  void answer(const Json& id, const LspAnswer&);
  void handle(const Json& message);
  bool cancelled(const Json& id);
  void notified(const std::string& method, const Json& params);

  // Texts
  void did_open(const Json& params);
  void did_change(const Json& params);
  void did_close(const Json& params);
  void files_changed();
  void changed(const std::string& real);
  OpenScript* find(const Json& params);  // of params.textDocument
  OpenScript* find_real(const std::string& real);

  // Films
  Loaded load(const OpenScript&, const std::vector<std::pair<std::string, std::string>>& said,
              std::set<std::string>* uses = nullptr);
  void refresh(OpenScript&);  // the film is that of the text
  bool is_part(const OpenScript&) const;
  OpenScript& root_of(OpenScript&);  // the script whose film the text is a part of
  const TextNames& names_of(OpenScript& root);
  std::size_t text_in(const OpenScript& root, const OpenScript&) const;  // its number among the film's texts
  std::string uri_of(const std::string& path) const;

  // What there is to say
  bool say_one();
  void say(OpenScript&);
  void publish(const std::string& uri);
};

// A request, and the answer.
struct LspRequest {
  std::string_view method;
  LspAnswer (*answer)(LanguageServer::State&, const Json& params);
};
std::span<const LspRequest> lsp_requests();
Json lsp_capabilities();

}  // namespace betwixt
