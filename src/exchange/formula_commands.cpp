// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// TeX's commands in formulas.
#include <fmt/format.h>

#include "base/names.h"
#include "base/utf8.h"
#include "exchange/formula_reader.h"

namespace betwixt {
namespace {

// Commands that are no signs, for suggestions.
constexpr std::string_view structures[] = {"frac",
                                           "dfrac",
                                           "tfrac",
                                           "cfrac",
                                           "binom",
                                           "dbinom",
                                           "tbinom",
                                           "sqrt",
                                           "left",
                                           "right",
                                           "middle",
                                           "big",
                                           "Big",
                                           "bigg",
                                           "Bigg",
                                           "bigl",
                                           "bigr",
                                           "overline",
                                           "underline",
                                           "overbrace",
                                           "underbrace",
                                           "overset",
                                           "underset",
                                           "stackrel",
                                           "substack",
                                           "text",
                                           "operatorname",
                                           "displaystyle",
                                           "textstyle",
                                           "scriptstyle",
                                           "scriptscriptstyle",
                                           "cancel",
                                           "bcancel",
                                           "xcancel",
                                           "boxed",
                                           "phantom",
                                           "hphantom",
                                           "vphantom",
                                           "xrightarrow",
                                           "xleftarrow",
                                           "begin",
                                           "end",
                                           "limits",
                                           "nolimits",
                                           "not",
                                           "pmod",
                                           "bmod",
                                           "mod",
                                           "over",
                                           "choose",
                                           "mathop",
                                           "mathbin",
                                           "mathrel",
                                           "mathord",
                                           "hline"};

constexpr std::pair<std::string_view, AtomClass> classes[] = {
    {"mathord", AtomClass::ord},     {"mathop", AtomClass::op},      {"mathbin", AtomClass::bin},
    {"mathrel", AtomClass::rel},     {"mathopen", AtomClass::open},  {"mathclose", AtomClass::close},
    {"mathpunct", AtomClass::punct}, {"mathinner", AtomClass::inner}};

std::u32string decoded(std::string_view s) {
  std::u32string out;
  for (std::size_t i = 0; i < s.size();) {
    const std::size_t length = character_length(s, i);
    out.push_back(length > 0 ? character_at(s, i, length) : 0xFFFD);
    i += std::max<std::size_t>(length, 1);
  }
  return out;
}

}  // namespace

bool FormulaReader::command(FormulaList& out, const Token& t) {
  if (const FormulaFunction* const f = find_math_function(t.name)) {
    FormulaAtom a = made(AtomForm::letters, t, AtomClass::op);
    a.letters = decoded(f->shown), a.takes_limits = f->limits;
    out.push_back(std::move(a));
    return true;
  }
  if (const auto space = find_math_space(t.name)) {
    out.push_back(made(AtomForm::space, t, AtomClass::none));
    out.back().amount = *space;
    return true;
  }
  bool known = false;
  for (const auto read : {&FormulaReader::structure, &FormulaReader::decoration, &FormulaReader::style_command,
                          &FormulaReader::letters_command, &FormulaReader::sized_fence})
    if (!(this->*read)(out, t, known) || known) return known && failed.what.message.empty();
  if (const FormulaSign* const s = find_sign(t.name)) {
    FormulaAtom a = sign(*s, t);
    a.large = s->is == AtomClass::op;
    a.takes_limits = a.large && !(s->code >= 0x222B && s->code <= 0x2233);  // integrals have theirs beside them
    out.push_back(std::move(a));
    return true;
  }
  std::vector<std::string_view> all = sign_names();
  all.insert(all.end(), std::begin(structures), std::end(structures));
  Hint near = did_you_mean(t.name, all);
  if (!near.empty()) near = Hint(fmt::format("did you mean '\\{}'?", near.instead));
  if (t.name == "color" || t.name == "textcolor") near = "mark it as a part, {{x}}, and give the part a color";
  return fail_at(t, ErrorCode::name,
                 t.name.empty() ? "a backslash begins a command" : fmt::format("there is no command {}", said(t)),
                 near);
}

bool FormulaReader::fraction(FormulaList& out, const Token& t, int level, bool rule, char32_t left, char32_t right) {
  FormulaAtom a = made(AtomForm::fraction, t, AtomClass::inner);
  a.level = static_cast<std::int8_t>(level), a.rule = rule, a.left = left, a.right = right;
  a.lists.resize(2);
  if (!argument(a.lists[0], t) || !argument(a.lists[1], t)) return false;
  out.push_back(std::move(a));
  return true;
}

bool FormulaReader::root(FormulaList& out, const Token& t) {
  FormulaAtom a = made(AtomForm::root, t);
  a.lists.resize(2);
  bool there = false;
  if (!optional_argument(a.lists[1], there) || !argument(a.lists[0], t)) return false;
  out.push_back(std::move(a));
  return true;
}

bool FormulaReader::fence(char32_t& out, const Token& of) {
  const Token t = take();
  if (is(t, '.')) return out = 0, true;
  if (is(t, '<')) return out = 0x27E8, true;
  if (is(t, '>')) return out = 0x27E9, true;
  if (t.what == Token::character && std::string_view("()[]|/").find(static_cast<char>(t.c)) != std::string_view::npos &&
      t.c < 128)
    return out = t.c, true;
  if (const FormulaSign* const s = t.what == Token::command ? find_sign(t.name) : nullptr)
    if (s->is == AtomClass::open || s->is == AtomClass::close || is(t, "vert") || is(t, "Vert") || is(t, "|") ||
        is(t, "backslash") || t.name.find("arrow") != t.name.npos)
      return out = s->code, true;
  return fail_at(t.what == Token::nothing ? of : t, ErrorCode::syntax,
                 fmt::format("{} needs a delimiter behind it, not {}", said(of), said(t)),
                 "such as ( [ \\{ | or . for none");
}

bool FormulaReader::fenced(FormulaList& out, const Token& t) {
  FormulaAtom a = made(AtomForm::fenced, t, AtomClass::inner);
  a.fences.push_back(0);
  if (!fence(a.fences.back(), t)) return false;
  for (;;) {
    a.lists.emplace_back();
    End end = End::text;
    const int brackets = std::exchange(brackets_, 0);
    if (!list(a.lists.back(), end)) return false;
    brackets_ = brackets;
    if (end != End::right && end != End::middle) {
      if (end == End::text) return fail_at(t, ErrorCode::syntax, "this \\left has no \\right");
      return fail_at(peek(), ErrorCode::syntax, fmt::format("{} comes before the \\right of a \\left", said(peek())));
    }
    const Token closes = take();
    a.fences.push_back(0);
    if (!fence(a.fences.back(), closes)) return false;
    if (end == End::right) break;
  }
  out.push_back(std::move(a));
  return true;
}

bool FormulaReader::sized_fence(FormulaList& out, const Token& t, bool& known) {
  static constexpr std::pair<std::string_view, double> sizes[] = {
      {"Bigg", 3}, {"bigg", 2.4}, {"Big", 1.8}, {"big", 1.2}};
  for (const auto& [name, size] : sizes) {
    const std::string_view rest = t.name.starts_with(name) ? t.name.substr(name.size()) : "none";
    if (rest != "" && rest != "l" && rest != "r" && rest != "m") continue;
    known = true;
    FormulaAtom a = made(AtomForm::fence, t,
                         rest == "l"   ? AtomClass::open
                         : rest == "r" ? AtomClass::close
                         : rest == "m" ? AtomClass::rel
                                       : AtomClass::ord);
    a.amount = size;
    if (!fence(a.symbol, t)) return false;
    out.push_back(std::move(a));
    return true;
  }
  return true;
}

bool FormulaReader::structure(FormulaList& out, const Token& t, bool& known) {
  known = true;
  const std::string_view n = t.name;
  if (n == "frac") return fraction(out, t, -1, true, 0, 0);
  if (n == "dfrac" || n == "cfrac") return fraction(out, t, 0, true, 0, 0);
  if (n == "tfrac") return fraction(out, t, 1, true, 0, 0);
  if (n == "binom") return fraction(out, t, -1, false, '(', ')');
  if (n == "dbinom") return fraction(out, t, 0, false, '(', ')');
  if (n == "tbinom") return fraction(out, t, 1, false, '(', ')');
  if (n == "sqrt") return root(out, t);
  if (n == "left") return fenced(out, t);
  if (n == "begin") return environment(out, t);
  if (n == "not") return negation(out, t);
  if (n == "substack") {
    FormulaAtom a = made(AtomForm::table, t);
    a.alignment = "c", a.level = 2, a.stretch = 0;
    const Token opened = peek();
    if (!is(opened, '{')) return fail_at(t, ErrorCode::syntax, fmt::format("{} needs braces behind it", said(t)));
    take();
    if (!cells(a, End::brace, opened)) return false;
    take();
    out.push_back(std::move(a));
    return true;
  }
  return known = false, true;
}

bool FormulaReader::decoration(FormulaList& out, const Token& t, bool& known) {
  known = true;
  const std::string_view n = t.name;
  const auto around = [&](AtomForm form, AtomClass is, auto&& set) {
    FormulaAtom a = made(form, t, is);
    set(a);
    a.lists.emplace_back();
    if (!argument(a.lists[0], t)) return false;
    out.push_back(std::move(a));
    return true;
  };
  if (const FormulaAccent* const accent = find_math_accent(n))
    return around(AtomForm::accent, AtomClass::ord,
                  [&](FormulaAtom& a) { a.symbol = accent->code, a.wide = accent->wide; });
  if (n == "overline" || n == "underline")
    return around(AtomForm::line, AtomClass::ord, [&](FormulaAtom& a) { a.below = n[0] == 'u'; });
  if (n == "overbrace" || n == "underbrace")
    return around(AtomForm::brace, AtomClass::op, [&](FormulaAtom& a) {
      a.below = n[0] == 'u', a.symbol = a.below ? 0x23DF : 0x23DE, a.limits = FormulaAtom::Limits::on;
    });
  if (n == "cancel" || n == "bcancel" || n == "xcancel")
    return around(AtomForm::crossed, AtomClass::ord, [&](FormulaAtom& a) {
      a.symbol = n[0] == 'c' ? '/' : n[0] == 'b' ? '\\' : 'x';
    });
  if (n == "boxed") return around(AtomForm::boxed, AtomClass::ord, [](FormulaAtom&) {});
  if (n == "phantom" || n == "hphantom" || n == "vphantom")
    return around(AtomForm::invisible, AtomClass::ord,
                  [&](FormulaAtom& a) { a.wide = n[0] == 'h', a.below = n[0] == 'v'; });
  if (n == "overset" || n == "underset" || n == "stackrel") {
    FormulaAtom a = made(AtomForm::stack, t, n == "stackrel" ? AtomClass::rel : AtomClass::ord);
    a.below = n[0] == 'u';
    a.lists.resize(2);
    if (!argument(a.lists[1], t) || !argument(a.lists[0], t)) return false;
    if (a.lists[0].size() == 1) a.is = a.lists[0][0].is;
    out.push_back(std::move(a));
    return true;
  }
  if (n == "xrightarrow" || n == "xleftarrow" || n == "xleftrightarrow" || n == "xRightarrow" || n == "xmapsto") {
    FormulaAtom a = made(AtomForm::arrow, t, AtomClass::rel);
    a.symbol = find_sign(n.substr(1))->code;
    a.lists.resize(2);
    bool there = false;
    if (!optional_argument(a.lists[1], there) || !argument(a.lists[0], t)) return false;
    out.push_back(std::move(a));
    return true;
  }
  return known = false, true;
}

bool FormulaReader::style_command(FormulaList& out, const Token& t, bool& known) {
  static constexpr std::string_view levels[] = {"displaystyle", "textstyle", "scriptstyle", "scriptscriptstyle"};
  known = true;
  for (std::size_t i = 0; i < std::size(levels); ++i)
    if (t.name == levels[i]) {
      out.push_back(made(AtomForm::style, t, AtomClass::none));
      out.back().level = static_cast<std::int8_t>(i);
      return true;
    }
  if (t.name == "bmod") {
    out.push_back(made(AtomForm::letters, t, AtomClass::bin));
    out.back().letters = U"mod";
    return true;
  }
  if (t.name == "pmod" || t.name == "mod") {
    FormulaList inside;
    if (!argument(inside, t)) return false;
    const auto add = [&](AtomForm form, AtomClass is) -> FormulaAtom& { return out.emplace_back(made(form, t, is)); };
    add(AtomForm::space, AtomClass::none).amount = 1;
    if (t.name == "pmod") add(AtomForm::symbol, AtomClass::open).symbol = '(';
    add(AtomForm::letters, AtomClass::ord).letters = U"mod";
    add(AtomForm::space, AtomClass::none).amount = 1.0 / 3;
    std::move(inside.begin(), inside.end(), std::back_inserter(out));
    if (t.name == "pmod") add(AtomForm::symbol, AtomClass::close).symbol = ')';
    return true;
  }
  return known = false, true;
}

// Reads the argument in an alphabet, or changes that of the rest of the list (\bf).
bool FormulaReader::in_letters(FormulaList& out, const Token& t, Alphabet alphabet) {
  const Alphabet before = std::exchange(alphabet_, alphabet);
  if (t.name.size() <= 3 && t.name != "bm" && t.name != "bb") return true;
  FormulaAtom a = made(AtomForm::group, t);
  a.lists.resize(1);
  if (!argument(a.lists[0], t)) return false;
  alphabet_ = before;
  if (a.lists[0].size() == 1 && a.lists[0][0].form == AtomForm::symbol) a = FormulaAtom(a.lists[0][0]);
  out.push_back(std::move(a));
  return true;
}

bool FormulaReader::named_text(FormulaList& out, const Token& t, AtomClass is) {
  std::string_view raw;
  const bool star = is == AtomClass::op && text_.substr(at_, 1) == "*";
  if (star) ++at_;
  if (!raw_argument(raw, t)) return false;
  FormulaAtom a = made(AtomForm::letters, t, is);
  a.letters = decoded(raw), a.takes_limits = star;
  if (is == AtomClass::op) std::erase(a.letters, U' ');
  // In a text, \ before a sign is that sign.
  std::erase(a.letters, U'\\');
  if (t.name == "textbf" || t.name == "textit")
    for (char32_t& c : a.letters) c = in_alphabet(c, t.name == "textbf" ? Alphabet::bold : Alphabet::italic);
  out.push_back(std::move(a));
  return true;
}

bool FormulaReader::letters_command(FormulaList& out, const Token& t, bool& known) {
  known = true;
  if (const auto alphabet = find_alphabet(t.name)) return in_letters(out, t, *alphabet);
  const std::string_view n = t.name;
  if (n == "text" || n == "textrm" || n == "mbox" || n == "textbf" || n == "textit" || n == "textup")
    return named_text(out, t, AtomClass::ord);
  if (n == "operatorname") return named_text(out, t, AtomClass::op);
  for (const auto& [name, is] : classes)
    if (n == name) {
      FormulaAtom a = made(AtomForm::group, t, is);
      a.takes_limits = is == AtomClass::op;
      a.lists.resize(1);
      if (!argument(a.lists[0], t)) return false;
      out.push_back(std::move(a));
      return true;
    }
  return known = false, true;
}

bool FormulaReader::negation(FormulaList& out, const Token& t) {
  FormulaList of;
  if (!argument(of, t)) return false;
  if (of.size() == 1 && of[0].form == AtomForm::symbol && negated(of[0].symbol) != 0) {
    of[0].symbol = negated(of[0].symbol);
    out.push_back(std::move(of[0]));
    return true;
  }
  FormulaAtom a = made(AtomForm::crossed, t, of.size() == 1 ? of[0].is : AtomClass::rel);
  a.symbol = '/';
  a.lists.push_back(std::move(of));
  out.push_back(std::move(a));
  return true;
}

}  // namespace betwixt
