// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/symbols.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "algebra/text.h"

namespace betwixt {
namespace {

using LetterKind = Symbol::Kind;
using FactorKind = Factor::Kind;

// A sum of products, with the count of each; no count is 0.
using Sum = std::map<std::vector<std::size_t>, int>;
using Sums = std::array<Sum, 12>;

Sum number(int n) { return n == 0 ? Sum{} : Sum{{{}, n}}; }

void add(Sum& to, const std::vector<std::size_t>& letters, int count) {
  if ((to[letters] += count) == 0) to.erase(letters);
}
Sum operator+(Sum a, const Sum& b) {
  for (const auto& [letters, count] : b) add(a, letters, count);
  return a;
}
Sum operator*(const Sum& a, const Sum& b) {
  Sum product;
  for (const auto& [left, m] : a)
    for (const auto& [right, n] : b) {
      std::vector<std::size_t> letters;
      std::merge(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(letters));
      add(product, letters, m * n);
    }
  return product;
}
Sum operator-(const Sum& a, const Sum& b) { return a + number(-1) * b; }

// Makes the matrices of factors and gives out the letters.
class LetterMaker {
 public:
  LetterMaker(const Motion& motion, std::vector<Symbol>& letters) : motion_(motion), letters_(letters) {}

  Sums of(std::size_t factor) {
    at_ = factor;
    const Factor& f = motion_.factors[factor];
    if (f.kind == FactorKind::translate) return shifted(three(LetterKind::way, f.by));
    return f.kind == FactorKind::rotate ? turned(f) : grown(f);
  }

 private:
  using Three = std::array<Sum, 3>;

  Sum letter(LetterKind kind, int along) {
    constexpr const char* names[] = {"c", "s", "ghk", "lmn", "uvw", "xyz"};
    const char name = names[static_cast<std::size_t>(kind)][along];
    const std::string index = motion_.factors.size() > 1 ? std::to_string(at_ + 1) : "";
    letters_.push_back({kind, at_, along, name + index});
    return {{{letters_.size() - 1}, 1}};
  }
  Three three(LetterKind kind, Vec3 v) {
    Three sums;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      // A displacement of 1 is t after a part of the motion, and centres always have all their letters.
      const bool plain = kind == LetterKind::axis && std::abs(v[i]) == 1;
      if (v[i] != 0) sums[at] = plain ? number(v[i] < 0 ? -1 : 1) : letter(kind, i);
    }
    return sums;
  }

  static Sums shifted(const Three& by) {
    Sums m;
    for (std::size_t i = 0; i < 3; ++i) m[5 * i] = number(1), m[4 * i + 3] = by[i];
    return m;
  }
  // About a centre: adds c - L c.
  static Sums about(const Three& centre, Sums m) {
    for (std::size_t i = 0; i < 3; ++i) {
      m[4 * i + 3] = centre[i];
      for (std::size_t k = 0; k < 3; ++k) m[4 * i + 3] = m[4 * i + 3] - m[4 * i + k] * centre[k];
    }
    return m;
  }
  // After Rodrigues.
  Sums turned(const Factor& f) {
    const Sum c = letter(LetterKind::cosine, 0), s = letter(LetterKind::sine, 0), rest = number(1) - c;
    const Three a = three(LetterKind::axis, normalize(f.axis));
    Sums m;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        m[4 * i + k] = rest * a[i] * a[k];
        if (i == k) m[4 * i + k] = m[4 * i + k] + c;
        if (k == (i + 1) % 3) m[4 * i + k] = m[4 * i + k] - s * a[(i + 2) % 3];
        if (k == (i + 2) % 3) m[4 * i + k] = m[4 * i + k] + s * a[(i + 1) % 3];
      }
    return about(three(LetterKind::centre, f.centre), std::move(m));
  }
  Sums grown(const Factor& f) {
    Sums m;
    for (int i = 0; i < 3; ++i) {
      int like = 0;
      while (f.by[like] != f.by[i]) ++like;
      const auto at = static_cast<std::size_t>(i);
      m[5 * at] = f.by[i] == 1 ? number(1)
                  : like < i   ? m[5 * static_cast<std::size_t>(like)]
                               : letter(LetterKind::growth, i);
    }
    return about(three(LetterKind::centre, f.centre), std::move(m));
  }

  const Motion& motion_;
  std::vector<Symbol>& letters_;
  std::size_t at_ = 0;
};

Sums times(const Sums& a, const Sums& b) {
  Sums m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      Sum& to = m[4 * i + k];
      if (k == 3) to = a[4 * i + 3];
      for (std::size_t j = 0; j < 3; ++j) to = to + a[4 * i + j] * b[4 * j + k];
    }
  return m;
}

bool is_length(const Symbol& letter) { return letter.kind == LetterKind::way || letter.kind == LetterKind::centre; }

// Returns "2 c1 s2^2", or "1" for an empty product.
std::string product_text(const Term& term, const Symbols& symbols) {
  std::string text;
  const auto put = [&](const std::string& word) { text += (text.empty() ? "" : " ") + word; };
  if (std::abs(term.count) != 1) put(std::to_string(std::abs(term.count)));
  for (std::size_t i = 0; i < term.letters.size(); ++i) {
    std::size_t power = 1;
    while (i + 1 < term.letters.size() && term.letters[i + 1] == term.letters[i]) ++i, ++power;
    put(symbols.letters[term.letters[i]].name + (power > 1 ? "^" + std::to_string(power) : ""));
  }
  return text.empty() ? "1" : text;
}
std::string sum_text(const std::vector<Term>& sum, const Symbols& symbols) {
  std::string text;
  for (const Term& term : sum)
    text += (text.empty() ? (term.count < 0 ? "-" : "") : term.count < 0 ? " - " : " + ") + product_text(term, symbols);
  return text;
}

// The terms with the same length as a factor; terms without a length are a group of their own.
struct Together {
  std::optional<std::size_t> length;
  std::vector<Term> terms;
};
std::vector<Together> by_lengths(const std::vector<Term>& sum, const Symbols& symbols) {
  std::map<std::optional<std::size_t>, std::vector<Term>> groups;
  for (Term term : sum) {
    const auto length = std::find_if(term.letters.begin(), term.letters.end(),
                                     [&](std::size_t l) { return is_length(symbols.letters[l]); });
    std::optional<std::size_t> of;
    if (length != term.letters.end()) of = *length, term.letters.erase(length);
    groups[of].push_back(std::move(term));
  }
  std::vector<Together> all;
  for (auto& [length, terms] : groups) {
    std::sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.letters < b.letters; });
    all.push_back({length, std::move(terms)});
  }
  return all;
}

}  // namespace

Result<Symbols> in_symbols(const Motion& motion) {
  Symbols symbols;
  LetterMaker make(motion, symbols.letters);
  Sums product;
  for (std::size_t i = 0; i < 3; ++i) product[5 * i] = number(1);
  for (std::size_t i = 0; i < motion.factors.size(); ++i) {
    product = times(product, make.of(i));
    for (const Sum& sum : product)
      if (sum.size() > most_terms)
        return fail(ErrorCode::range, fmt::format("an element of this matrix has more than {} terms", most_terms),
                    "use fewer factors");
  }
  for (std::size_t i = 0; i < product.size(); ++i)
    for (const auto& [letters, count] : product[i]) symbols.sums[i].push_back({count, letters});
  return symbols;
}

std::vector<double> values_of(const Symbols& symbols, const Motion& motion, double t) {
  std::vector<double> values;
  for (const Symbol& letter : symbols.letters) {
    Factor f = motion.factors[letter.factor];
    const int i = letter.along;
    if (letter.kind == LetterKind::centre) {
      values.push_back(f.centre[i]);
    } else if (letter.kind == LetterKind::axis) {
      values.push_back(normalize(f.axis)[i]);
    } else {
      if (f.kind == FactorKind::rotate) f.axis = {0, 0, 1}, f.centre = {};
      const Mat4 m = at({{f}}, t);
      const bool turn = f.kind == FactorKind::rotate;
      values.push_back(turn ? m(letter.kind == LetterKind::sine ? 1 : 0, 0)
                            : m(i, f.kind == FactorKind::translate ? 3 : i));
    }
  }
  return values;
}

double value_of(const std::vector<Term>& sum, std::span<const double> letters) {
  double all = 0;
  for (const Term& term : sum) {
    double product = term.count;
    for (const std::size_t l : term.letters) product *= letters[l];
    all += product;
  }
  return all;
}

std::string to_string(const std::vector<Term>& sum, const Symbols& symbols) {
  if (sum.empty()) return "0";
  std::string text;
  for (const auto& [length, terms] : by_lengths(sum, symbols)) {
    std::string part = sum_text(terms, symbols);
    if (length) {
      const std::string& name = symbols.letters[*length].name;
      if (terms.size() > 1)
        part = "(" + part + ") " + name;
      else if (terms[0].letters.empty() && std::abs(terms[0].count) == 1)
        part = (terms[0].count < 0 ? "-" : "") + name;
      else
        part += " " + name;
    }
    const bool less = part[0] == '-';
    if (!text.empty()) text += less ? " - " : " + ";
    text += !text.empty() && less ? part.substr(1) : part;
  }
  return text;
}

std::string meaning_of(const Symbol& letter, const Motion& motion) {
  const Factor& f = motion.factors[letter.factor];
  const double by = f.by[letter.along];
  switch (letter.kind) {
    case LetterKind::cosine:
    case LetterKind::sine:
      return fmt::format("{}({} t)", letter.kind == LetterKind::sine ? "sin" : "cos",
                         algebra::angle_text({f.angle, f.angle_rest}));
    case LetterKind::growth:
      return f.law == Factor::Law::linear
                 ? fmt::format("1 {} {} t", by < 1 ? '-' : '+', algebra::written(std::abs(by - 1)))
                 : algebra::written(by) + "^t";
    case LetterKind::way:
      return algebra::written(by) + " t";
    case LetterKind::axis:
      return fmt::format("{:.15g}", normalize(f.axis)[letter.along]);
    case LetterKind::centre:
      break;
  }
  return algebra::written(f.centre[letter.along]);
}

}  // namespace betwixt
