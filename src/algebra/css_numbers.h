// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the arguments of CSS functions: numbers, lengths and angles, and expressions of these.
#pragma once

#include "algebra/text.h"
#include "betwixt/css.h"

namespace betwixt::algebra {

// Compares as CSS does, ignoring case.
bool same_in_css(std::string_view, std::string_view);

struct CssNumbers : Cursor {
  enum class Part : std::uint8_t { none, width, height };
  CssPage page = {};

  char peek(std::size_t further = 0) const { return at + further < text.size() ? text[at + further] : '\0'; }
  // Skips blanks and comments.
  void space();
  std::string_view word();

  // Each reads a value of its type, or calc() and the like. Returns false if there is none; the error says why.
  bool length(double& pixels, Part percent_of);
  bool angle(Angle&);
  bool plain(double&);

 private:
  enum class Type : std::uint8_t { number, length, angle };
  struct Value {
    double number = 0;
    Type type = Type::number;
  };

  bool too_large(std::size_t from);
  bool number(double&);
  std::string_view unit();
  bool pixels(double& number, std::string_view unit, std::size_t from, std::size_t unit_from, Part percent_of);
  // Returns true if calc() or the like is next.
  bool at_function() const;
  bool worked_out(double&, Type wanted, Part percent_of);
  bool function(Value&, Part percent_of);
  bool arguments(std::string_view name, std::size_t from, Value&, Part percent_of);
  bool sum(Value&, Part percent_of);
  bool term(Value&, Part percent_of);
  bool value(Value&, Part percent_of);
  int depth_ = 0;
};

}  // namespace betwixt::algebra
