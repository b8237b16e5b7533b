// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Errors are values. A Result holds a value or an Error. The library throws no exceptions to its callers.
//
// Room: base
#pragma once

#if __cplusplus < 202002L
#error "Betwixt needs C++20: compile with -std=c++20"
#endif

#include <cassert>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace betwixt {

// The kind of an error. The exit code of the program follows from it.
enum class ErrorCode : std::uint8_t {
  syntax,   // the text cannot be parsed
  name,     // an unknown name, or a name that is taken
  type,     // a value or operation of the wrong type for its target
  range,    // a number out of range
  file,     // a file of the author's is missing, unreadable or broken
  machine,  // the machine failed: disk full, no such device, a missing program
};

// Something that the program does only if a person permits it with an option.
enum class Permission : std::uint8_t { none, read_anywhere, tex };

// A place in a text. Line and column count from 1, the column in characters. Line 0: the place is unknown.
struct Place {
  std::string file;
  int line = 0, column = 0, length = 1;
};

struct Error {
  ErrorCode code = ErrorCode::syntax;
  std::string message;  // the error in plain words, without a full stop
  std::string hint;     // a suggestion; may be empty
  Place place;
  std::string instead = {};  // the text to write at the place, if the hint is a correction; otherwise empty
  std::string subject = {};  // the name that the error is about, for example of a missing object; may be empty
  Permission needs = Permission::none;  // the permission that is missing
};

// A suggestion to the author. `text` is its words. `instead` is the word to write if the suggestion corrects one word,
// otherwise empty. `needs` is the permission that is missing.
struct Hint {
  std::string text, instead;
  Permission needs = Permission::none;
  Hint(std::string t = {}, std::string word = {}) : text(std::move(t)), instead(std::move(word)) {}
  Hint(const char* t) : text(t) {}
  Hint(Permission p, std::string t) : text(std::move(t)), needs(p) {}
  bool empty() const { return text.empty(); }
};

// A message to the author about a text.
enum class Severity : std::uint8_t { notice, warning, error };
struct Diagnostic {
  Severity severity = Severity::error;
  Error what;
  std::string line;  // the line of text at the place; a long line is cut around the place
  int caret = 0;     // characters of `line` before the place
};
using Diagnostics = std::vector<Diagnostic>;

// Returns "file:line:column: error: message", the line, a caret and the suggestion, with a final newline.
std::string to_string(const Diagnostic&);
// Returns the same of an error, which has no line of text: "error: message" and the suggestion.
std::string to_string(const Error&);
bool has_errors(const Diagnostics&);

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}
  explicit operator bool() const { return state_.index() == 0; }
  T& operator*() & { return get(); }
  const T& operator*() const& { return const_cast<Result*>(this)->get(); }
  T&& operator*() && { return std::move(get()); }
  T* operator->() { return &get(); }
  const T* operator->() const { return &const_cast<Result*>(this)->get(); }
  const Error& error() const { return std::get<1>(state_); }

 private:
  T& get() {
    assert(state_.index() == 0 && "a Result was read without looking");
    return *std::get_if<0>(&state_);
  }
  std::variant<T, Error> state_;
};

struct Nothing {};
using Status = Result<Nothing>;

inline Error fail(ErrorCode code, std::string message, Hint hint = {}) {
  return {code, std::move(message), std::move(hint.text), {}, std::move(hint.instead), {}, hint.needs};
}
inline void set_hint(Error& e, Hint hint) {
  e.hint = std::move(hint.text), e.instead = std::move(hint.instead), e.needs = hint.needs;
}

}  // namespace betwixt
