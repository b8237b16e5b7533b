// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The state of the language server: the open texts, their films, and the messages that wait.
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
#include "lsp/framing.h"
#include "lsp/language_server.h"
#include "lsp/positions.h"

namespace betwixt {

// Returns the member of an object, or null if there is none.
const Json& member(const Json& object, const char* key);
std::string text_member(const Json& object, const char* key);

// Resolves links and dots. Returns the path unchanged if that fails.
std::string real_path(const std::string& path);

// A text that is open in the editor, and its film.
struct OpenScript {
  std::string uri, path;  // empty for a text without a file
  std::string real;       // path without links
  Json version;
  ScriptText lines;
  bool stale = true, unsaid = true;  // the film is of an older text; nothing has been said of it yet
  Loaded film;
  std::set<std::string> uses;  // real paths of the scripts that the last load read
  // The film's texts, this one first. Filled at the first request that needs names.
  std::vector<FilmText> texts;
  std::unique_ptr<TextNames> names;
};

// Why a request has no answer, with a code of the protocol.
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

  std::map<std::string, OpenScript> open;  // by URI
  // By URI of the root script, then of the file.
  std::map<std::string, std::map<std::string, std::vector<Json>>> published;

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
  void refresh(OpenScript&);  // loads the film if its text has changed
  bool is_part(const OpenScript&) const;
  OpenScript& root_of(OpenScript&);  // the script whose film contains the text
  const TextNames& names_of(OpenScript& root);
  std::size_t text_in(const OpenScript& root, const OpenScript&) const;  // its index among the film's texts
  std::string uri_of(const std::string& path) const;

  // Diagnostics
  bool say_one();
  void say(OpenScript&);
  void publish(const std::string& uri);
};

// A kind of request, the function that answers it, and what the server tells the editor about it.
struct LspRequest {
  std::string_view method;
  LspAnswer (*answer)(LanguageServer::State&, const Json& params);
  std::string_view capability = {};  // the member of ServerCapabilities, if the request has one
  std::string_view value = "true";   // JSON
};
std::span<const LspRequest> lsp_requests();
Json lsp_capabilities();

}  // namespace betwixt
