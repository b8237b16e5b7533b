// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The handle of a host in C: its connection, and its state between two calls.
#pragma once

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/aim.h"
#include "syntax/tokens.h"

struct aim {
  using Json = nlohmann::json;
  static constexpr int names_at_once = 1000;

  int fd = -1;
  std::string in;               // bytes received after the last answer
  std::string error, warnings;  // from the last call
  std::string said;
  Json answer;
  std::vector<int> blocks;  // the first number of each thousand that the server has given for names
  int objects = 0, tags = 0, environments = 0;
  int open = 0, open_before_bundle = 0;  // the object's number, 0 if none is open
  // Another command came between the object's rows, so it must be opened again before the next row.
  bool interrupted = false;
  bool replacing = false;
  bool bundling = false;
  long stamp = LONG_MIN, now = LONG_MIN;  // ticks: when the last command takes effect, and the latest tick known

  ~aim() {
    if (fd >= 0) ::close(fd);
  }

  aim_status fail(aim_status status, std::string why) {
    error = std::move(why);
    return status;
  }
  aim_status lost(const char* what) {
    if (fd >= 0) ::close(fd);
    fd = -1;
    return fail(AIM_E_CONNECTION, what);
  }

  bool send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t n = ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
  }
  bool receive(std::string& line) {
    std::size_t searched = 0;
    for (;;) {
      if (const auto end = in.find('\n', searched); end != std::string::npos) {
        line = in.substr(0, end);
        in.erase(0, end + 1);
        return true;
      }
      searched = in.size();
      char buffer[4096];
      const ssize_t n = ::recv(fd, buffer, sizeof buffer, 0);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      in.append(buffer, static_cast<std::size_t>(n));
    }
  }

  // Sends a line and waits for its answer. Skips the events that arrive before it.
  aim_status ask(const std::string& line, bool answered_in_bundles = false) {
    error.clear(), warnings.clear();
    if (fd < 0) return fail(AIM_E_CONNECTION, "the connection is closed");
    if (!send(line + "\n")) return lost("the server closed the connection");
    return bundling && !answered_in_bundles ? AIM_OK : hear();  // a bundle has one answer, at its end
  }
  // The same for a line that bytes follow.
  aim_status ask_with(const std::string& line, std::string_view bytes) {
    error.clear(), warnings.clear();
    if (fd < 0) return fail(AIM_E_CONNECTION, "the connection is closed");
    if (!send(line + "\n") || !send(bytes)) return lost("the server closed the connection");
    return hear();
  }
  aim_status hear() {
    std::string text;
    do {
      if (!receive(text)) return lost("the server closed the connection");
      answer = Json::parse(text, nullptr, false);
      if (!answer.is_object()) return lost("this is not an imaging server");
    } while (!answer.contains("ok"));
    if (answer.value("ok", false)) return note_warnings(), AIM_OK;
    std::string why = answer.value("error", std::string("refused"));
    if (const std::string hint = answer.value("hint", std::string()); !hint.empty()) why += " (" + hint + ")";
    return fail(AIM_E_REFUSED, why);
  }

  // Returns the word of a line that has only one. Otherwise returns an empty string.
  static std::string lone_word(std::string_view line) {
    std::vector<std::string> words = betwixt::line_words(line);
    return words.size() == 1 ? std::move(words[0]) : std::string();
  }
  void note_warnings() {
    for (const std::string& one : answer.value("warnings", std::vector<std::string>())) warnings += one + '\n';
  }

  // Sends a command that is not a row. The server then closes the open display list.
  aim_status say(const std::string& line, std::initializer_list<int> names = {}) {
    if (const aim_status status = named(names); status != AIM_OK) return status;
    interrupted = true;
    return ask(line);
  }
  aim_status opens(const char* verb, int name) {
    if (open != 0) return fail(AIM_E_CALL, "an object is already open");
    const aim_status status = say(fmt::format("{} O{}", verb, name), {name});
    open = status == AIM_OK ? name : 0;
    interrupted = replacing = false;
    return status;
  }
  aim_status row(const std::string& text, std::initializer_list<int> names = {}) {
    if (const aim_status status = named(names); status != AIM_OK) return status;
    if (open == 0) return fail(AIM_E_CALL, "no object is open");
    if (interrupted && replacing)
      return fail(AIM_E_CALL, "another command came after 'replace', so repeat 'replace' first");
    if (interrupted)
      if (const aim_status status = ask(fmt::format("edit O{}", open)); status != AIM_OK) return status;
    interrupted = false;
    return ask("  " + text);
  }
  // Sends a command about environments. It takes effect a little later than it arrives.
  aim_status stamped(const std::string& line, std::initializer_list<int> names = {}) {
    const aim_status status = say(line, names);
    if (status == AIM_OK && !bundling) stamp = answer.value("tick", stamp);
    return status;
  }
  // Reads one value of an environment. Reads it at the tick at which the last command takes effect, if that is still
  // ahead.
  aim_status value(int environment, const char* what, Json& out) {
    if (bundling) return fail(AIM_E_CALL, "a bundle cannot contain questions");
    if (const aim_status status = named({environment}); status != AIM_OK) return status;
    const std::string target = fmt::format("E{}.{}", environment, what);
    if (stamp > now) {
      if (const aim_status status = ask("time"); status != AIM_OK) return status;
      now = answer.value("tick", now);
    }
    const std::string when = stamp > now ? fmt::format(" at {}t", stamp) : std::string();
    if (const aim_status status = ask("eval " + target + when); status != AIM_OK) return status;
    const auto values = answer.find("values");
    if (values == answer.end() || !values->contains(target)) return fail(AIM_E_REFUSED, "the server gave no value");
    out = (*values)[target];
    return AIM_OK;
  }
  aim_status matrix(int environment, const char* what, double m[16]) {
    if (!m) return fail(AIM_E_CALL, "the pointer for the matrix is null");
    Json out;
    if (const aim_status status = value(environment, what, out); status != AIM_OK) return status;
    if (!out.is_array() || out.size() != 16) return fail(AIM_E_REFUSED, "the server gave no matrix");
    for (int i = 0; i < 16; ++i) m[4 * (i % 4) + i / 4] = out[static_cast<std::size_t>(i)].get<double>();
    return AIM_OK;
  }
  aim_status begin_bundle() {
    if (bundling) return fail(AIM_E_CALL, "a bundle is already open");
    bundling = true, open_before_bundle = open;
    const aim_status status = say("bundle");
    bundling = status == AIM_OK;
    return status;
  }
  aim_status end_bundle() {
    if (!bundling) return fail(AIM_E_CALL, "no bundle is open");
    bundling = false, open = open_before_bundle;
    return stamped("end");
  }
  // Sends a line of the language. The server answers the words that begin and end bundles in their own way.
  aim_status command(const std::string& line) {
    const std::string word = lone_word(line);
    if (word == "bundle") return begin_bundle();
    if (word == "end" && !betwixt::indented(line)) return end_bundle();
    return say(line);
  }
  aim_status whole(const char* member, long& out) {
    if (bundling) return fail(AIM_E_CALL, "a bundle cannot contain questions");
    if (const aim_status status = ask("time"); status != AIM_OK) return status;
    out = answer.value(member, 0L);
    return AIM_OK;
  }
  // The server gives every number once, a thousand at a time. An object, a tag and an environment may share a number.
  aim_status name(int* out, int& count) {
    if (!out) return fail(AIM_E_CALL, "the pointer for the name is null");
    const auto block = static_cast<std::size_t>(count / names_at_once);
    if (block == blocks.size()) {
      if (const aim_status status = ask("names", true); status != AIM_OK) return status;
      const int first = answer.value("first", 0);
      if (first <= 0) return lost("this is not an imaging server");
      blocks.push_back(first);
    }
    *out = blocks[block] + count++ % names_at_once;
    error.clear();
    return AIM_OK;
  }
  aim_status named(std::initializer_list<int> names) {
    for (const int n : names)
      if (n <= 0) return fail(AIM_E_CALL, "names must be positive numbers");
    return AIM_OK;
  }
};
