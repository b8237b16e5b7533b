// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads TeX's notation of formulas.
#pragma once

#include <map>

#include "exchange/formula_symbols.h"

namespace betwixt {

// A list ends before its end's token. All functions return false after an error, which `failed` has.
class FormulaReader {
 public:
  explicit FormulaReader(std::string_view text) : text_(text) {}
  bool whole(FormulaList& out);
  FormulaError failed;

 private:
  enum class End : std::uint8_t { text, brace, bracket, cell, row, right, middle, end };
  struct Token {
    enum What : std::uint8_t { nothing, command, character } what = nothing;
    std::string_view name;  // of a command, without its backslash
    char32_t c = 0;
    std::size_t at = 0, length = 0;
  };

  Token peek();
  Token take();
  bool fail_at(const Token&, ErrorCode, std::string message, Hint hint = {});
  std::string said(const Token&) const;  // in messages
  bool skip_spaces();
  bool is(const Token& t, char c) const { return t.what == Token::character && t.c == static_cast<char32_t>(c); }
  static bool is(const Token& t, std::string_view name) { return t.what == Token::command && t.name == name; }

  bool list(FormulaList& out, End& end);
  bool list_until(FormulaList& out, End wanted, const Token& opened);
  bool ends_list(const Token&, End&);
  bool infix(FormulaList& out, const Token&, End& end);
  bool part_of_list(FormulaList& out);
  bool scripts(FormulaAtom&);
  bool script(FormulaAtom&, bool above, const Token&);
  bool nucleus(FormulaList& out);
  bool group(FormulaList& out, const Token& opened);
  bool marked_part(FormulaList& out);
  std::size_t end_of_part(std::size_t at) const;
  bool argument(FormulaList& out, const Token& of);
  bool optional_argument(FormulaList& out, bool& there);
  bool raw_argument(std::string_view& out, const Token& of);
  void characters(FormulaList& out, const Token&);
  bool command(FormulaList& out, const Token&);
  bool structure(FormulaList& out, const Token&, bool& known);
  bool decoration(FormulaList& out, const Token&, bool& known);
  bool style_command(FormulaList& out, const Token&, bool& known);
  bool letters_command(FormulaList& out, const Token&, bool& known);
  bool in_letters(FormulaList& out, const Token&, Alphabet);
  bool named_text(FormulaList& out, const Token&, AtomClass);
  bool fraction(FormulaList& out, const Token&, int level, bool rule, char32_t left, char32_t right);
  bool root(FormulaList& out, const Token&);
  bool fenced(FormulaList& out, const Token&);
  bool fence(char32_t& out, const Token& of);
  bool sized_fence(FormulaList& out, const Token&, bool& known);
  bool environment(FormulaList& out, const Token&);
  bool array_columns(FormulaAtom& table, const Token&);
  bool cells(FormulaAtom& table, End wanted, const Token& opened);
  bool cells_from(FormulaAtom& table, FormulaList first, End end, End wanted, const Token& opened);
  bool negation(FormulaList& out, const Token&);
  FormulaAtom made(AtomForm form, const Token& t, AtomClass is = AtomClass::ord) const;
  FormulaAtom sign(const FormulaSign&, const Token&) const;

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0, brackets_ = 0;
  Alphabet alphabet_ = Alphabet::usual;
  std::map<std::string, int, std::less<>> parts_;  // how often each content was marked
};

// Sets the part of atoms that have none yet, with everything in them.
void mark_part(FormulaList&, const std::string& part);

}  // namespace betwixt
