// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/formula_symbols.h"

#include <algorithm>
#include <utility>

namespace betwixt {
namespace {

constexpr FormulaFunction math_functions[] = {
    {"Pr", "Pr", true},          {"arccos", "arccos", false}, {"arcsin", "arcsin", false}, {"arctan", "arctan", false},
    {"arg", "arg", false},       {"argmax", "arg max", true}, {"argmin", "arg min", true}, {"cos", "cos", false},
    {"cosh", "cosh", false},     {"cot", "cot", false},       {"coth", "coth", false},     {"csc", "csc", false},
    {"deg", "deg", false},       {"det", "det", true},        {"dim", "dim", false},       {"exp", "exp", false},
    {"gcd", "gcd", true},        {"hom", "hom", false},       {"inf", "inf", true},        {"ker", "ker", false},
    {"lcm", "lcm", true},        {"lg", "lg", false},         {"lim", "lim", true},        {"liminf", "lim inf", true},
    {"limsup", "lim sup", true}, {"ln", "ln", false},         {"log", "log", false},       {"max", "max", true},
    {"min", "min", true},        {"sec", "sec", false},       {"sin", "sin", false},       {"sinh", "sinh", false},
    {"sup", "sup", true},        {"tan", "tan", false},       {"tanh", "tanh", false},
};

constexpr FormulaAccent accents[] = {
    {"acute", 0x301, false},    {"bar", 0x304, false},           {"breve", 0x306, false},
    {"check", 0x30C, false},    {"ddot", 0x308, false},          {"dddot", 0x20DB, false},
    {"dot", 0x307, false},      {"grave", 0x300, false},         {"hat", 0x302, false},
    {"mathring", 0x30A, false}, {"overleftarrow", 0x20D6, true}, {"overrightarrow", 0x20D7, true},
    {"tilde", 0x303, false},    {"vec", 0x20D7, false},          {"widehat", 0x302, true},
    {"widetilde", 0x303, true}, {"widecheck", 0x30C, true},
};

constexpr double mu = 1.0 / 18;
constexpr std::pair<std::string_view, double> spaces[] = {
    {"!", -3 * mu},       {",", 3 * mu},          {":", 4 * mu},
    {">", 4 * mu},        {";", 5 * mu},          {" ", 1.0 / 3},
    {"quad", 1},          {"qquad", 2},           {"thinspace", 3 * mu},
    {"medspace", 4 * mu}, {"thickspace", 5 * mu}, {"negthinspace", -3 * mu},
    {"enspace", 0.5},     {"enskip", 0.5},        {"/", 0},
};

constexpr std::pair<std::string_view, Alphabet> alphabets[] = {
    {"bb", Alphabet::hollow},         {"bf", Alphabet::bold},
    {"bm", Alphabet::bold_italic},    {"boldsymbol", Alphabet::bold_italic},
    {"cal", Alphabet::script},        {"frak", Alphabet::gothic},
    {"it", Alphabet::italic},         {"mathbb", Alphabet::hollow},
    {"mathbf", Alphabet::bold},       {"mathcal", Alphabet::script},
    {"mathfrak", Alphabet::gothic},   {"mathit", Alphabet::italic},
    {"mathnormal", Alphabet::usual},  {"mathrm", Alphabet::upright},
    {"mathscr", Alphabet::script},    {"mathsf", Alphabet::sans},
    {"mathtt", Alphabet::typewriter}, {"mathup", Alphabet::upright},
    {"rm", Alphabet::upright},        {"sf", Alphabet::sans},
    {"tt", Alphabet::typewriter},
};

// Where Unicode's alphabets begin: capitals, small letters, digits, Greek capitals, small Greek letters; 0: none.
struct AlphabetRow {
  char32_t capitals, small, digits, greek_capitals, greek_small;
};
constexpr AlphabetRow rows[] = {
    {0x1D434, 0x1D44E, 0, 0, 0x1D6FC},              // usual: Greek capitals are upright
    {0, 0, 0, 0, 0},                                // upright
    {0x1D400, 0x1D41A, 0x1D7CE, 0x1D6A8, 0x1D6C2},  // bold
    {0x1D434, 0x1D44E, 0, 0x1D6E2, 0x1D6FC},        // italic
    {0x1D468, 0x1D482, 0x1D7CE, 0x1D71C, 0x1D736},  // bold italic
    {0x1D538, 0x1D552, 0x1D7D8, 0, 0},              // hollow
    {0x1D49C, 0x1D4B6, 0, 0, 0},                    // script
    {0x1D504, 0x1D51E, 0, 0, 0},                    // gothic
    {0x1D5A0, 0x1D5BA, 0x1D7E2, 0, 0},              // sans
    {0x1D670, 0x1D68A, 0x1D7F6, 0, 0},              // typewriter
};

// Letters that Unicode had before it had the alphabets.
constexpr std::pair<char32_t, char32_t> elsewhere[] = {
    {0x1D455, 0x210E}, {0x1D49D, 0x212C}, {0x1D4A0, 0x2130}, {0x1D4A1, 0x2131}, {0x1D4A3, 0x210B}, {0x1D4A4, 0x2110},
    {0x1D4A7, 0x2112}, {0x1D4A8, 0x2133}, {0x1D4AD, 0x211B}, {0x1D4BA, 0x212F}, {0x1D4BC, 0x210A}, {0x1D4C4, 0x2134},
    {0x1D506, 0x212D}, {0x1D50B, 0x210C}, {0x1D50C, 0x2111}, {0x1D515, 0x211C}, {0x1D51D, 0x2128}, {0x1D53A, 0x2102},
    {0x1D53F, 0x210D}, {0x1D545, 0x2115}, {0x1D547, 0x2119}, {0x1D548, 0x211A}, {0x1D549, 0x211D}, {0x1D551, 0x2124},
};

// Greek letters that stand behind omega in each alphabet, in its order.
constexpr char32_t greek_variants[] = {0x2202, 0x3F5, 0x3D1, 0x3F0, 0x3D5, 0x3F1, 0x3D6};

constexpr std::pair<char32_t, char32_t> negatives[] = {
    {'=', 0x2260},    {'<', 0x226E},    {'>', 0x226F},    {0x2208, 0x2209}, {0x220B, 0x220C}, {0x2261, 0x2262},
    {0x223C, 0x2241}, {0x2248, 0x2249}, {0x2245, 0x2247}, {0x2264, 0x2270}, {0x2265, 0x2271}, {0x2282, 0x2284},
    {0x2283, 0x2285}, {0x2286, 0x2288}, {0x2287, 0x2289}, {0x2223, 0x2224}, {0x2225, 0x2226}, {0x2203, 0x2204},
    {0x2192, 0x219B}, {0x21D2, 0x21CF}, {0x22A2, 0x22AC},
};

template <class Rows>
auto find_row(const Rows& all, std::string_view name) -> decltype(&all[0]) {
  const auto at = std::find_if(std::begin(all), std::end(all), [&](const auto& row) { return row.name == name; });
  return at == std::end(all) ? nullptr : &*at;
}

template <class Pairs, class Key>
auto find_pair(const Pairs& all, const Key& key) -> decltype(&all[0].second) {
  const auto at = std::find_if(std::begin(all), std::end(all), [&](const auto& row) { return row.first == key; });
  return at == std::end(all) ? nullptr : &at->second;
}

}  // namespace

const FormulaSign* find_sign(std::string_view name) {
  const auto at = std::lower_bound(math_signs().begin(), math_signs().end(), name,
                                   [](const FormulaSign& s, std::string_view n) { return s.name < n; });
  return at == math_signs().end() || at->name != name ? nullptr : &*at;
}

FormulaSign sign_of(char32_t c) {
  switch (c) {
    case '+':
      return {"", '+', AtomClass::bin};
    case '-':
      return {"", 0x2212, AtomClass::bin};
    case '*':
      return {"", 0x2217, AtomClass::bin};
    case '=':
    case '<':
    case '>':
    case ':':
      return {"", c, AtomClass::rel};
    case ',':
    case ';':
      return {"", c, AtomClass::punct};
    case '(':
    case '[':
      return {"", c, AtomClass::open};
    case ')':
    case ']':
    case '!':
    case '?':
      return {"", c, AtomClass::close};
    default:
      break;
  }
  const auto at =
      std::find_if(math_signs().begin(), math_signs().end(), [&](const FormulaSign& s) { return s.code == c; });
  return c > 127 && at != math_signs().end() ? FormulaSign{"", c, at->is} : FormulaSign{"", c, AtomClass::ord};
}

const FormulaFunction* find_math_function(std::string_view name) { return find_row(math_functions, name); }
const FormulaAccent* find_math_accent(std::string_view name) { return find_row(accents, name); }

std::optional<double> find_math_space(std::string_view name) {
  const double* const found = find_pair(spaces, name);
  return found ? std::optional(*found) : std::nullopt;
}

std::optional<Alphabet> find_alphabet(std::string_view command) {
  const Alphabet* const found = find_pair(alphabets, command);
  return found ? std::optional(*found) : std::nullopt;
}

char32_t in_alphabet(char32_t c, Alphabet alphabet) {
  const AlphabetRow& row = rows[static_cast<std::size_t>(alphabet)];
  const auto moved = [&](char32_t first, char32_t to) { return to != 0 ? to + (c - first) : c; };
  char32_t out = c;
  if (c >= 'A' && c <= 'Z') out = moved('A', row.capitals);
  if (c >= 'a' && c <= 'z') out = moved('a', row.small);
  if (c >= '0' && c <= '9') out = moved('0', row.digits);
  if (c >= 0x391 && c <= 0x3A9) out = moved(0x391, row.greek_capitals);
  if (c >= 0x3B1 && c <= 0x3C9) out = moved(0x3B1, row.greek_small);
  const auto* const variant = std::find(std::begin(greek_variants), std::end(greek_variants), c);
  if (variant != std::end(greek_variants) && row.greek_small != 0)
    out = row.greek_small + 25 + static_cast<char32_t>(variant - std::begin(greek_variants));
  const char32_t* const before = find_pair(elsewhere, out);
  return before ? *before : out;
}

char32_t negated(char32_t sign) {
  const char32_t* const found = find_pair(negatives, sign);
  return found ? *found : 0;
}

std::vector<std::string_view> sign_names() {
  std::vector<std::string_view> all;
  for (const auto& s : math_signs()) all.push_back(s.name);
  for (const auto& f : math_functions) all.push_back(f.name);
  for (const auto& a : accents) all.push_back(a.name);
  for (const auto& s : spaces) all.push_back(s.first);
  for (const auto& a : alphabets) all.push_back(a.first);
  return all;
}

}  // namespace betwixt
