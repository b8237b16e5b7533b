// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What stands between the brackets of CSS: numbers, lengths and angles, and what is worked out of them.
#pragma once

#include "algebra/text.h"

namespace betwixt::algebra {

// CSS does not tell capitals from small letters.
bool same_in_css(std::string_view, std::string_view);

struct CssNumbers : Cursor {
  enum class Part : std::uint8_t { none, width, height };
  std::optional<double> width = {}, height = {};  // what percentages are of

  char peek(std::size_t further = 0) const { return at + further < text.size() ? text[at + further] : '\0'; }
  // Past blanks and comments.
  void space();
  std::string_view word();

  // Each reads its own value, or calc() and its like. False: it is none, and the error says why.
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
  // calc() and its like.
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
