// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/code_match.h"

#include <algorithm>
#include <map>
#include <utility>

#include "scene/code_languages.h"

namespace betwixt {
namespace {

// A line without the blanks at its ends, or a word.
struct Piece {
  std::size_t at = 0, size = 0;
  std::size_t line = 0;
  bool paired = false;
};
using Pieces = std::vector<Piece>;
using Range = std::pair<std::size_t, std::size_t>;  // first, and behind the last

constexpr std::size_t most_cells = 1'000'000;

class CodeMatcher {
 public:
  CodeMatcher(std::string_view from, std::string_view to, std::string_view language)
      : a_(from), b_(to), partner_(from.size(), no_partner) {
    lines_a_ = lines(from), lines_b_ = lines(to);
    words_a_ = words(from, language, lines_a_), words_b_ = words(to, language, lines_b_);
  }

  std::vector<std::size_t> all() {
    in_order(lines_a_, {0, lines_a_.size()}, lines_b_, {0, lines_b_.size()});
    const auto kept = pairs_of_lines();
    strays(lines_a_, lines_b_, 4);
    for (const auto& [own, other] : {std::pair{&words_a_, &lines_a_}, {&words_b_, &lines_b_}})
      for (Piece& w : *own) w.paired = (*other)[w.line].paired;
    // The words between two lines that stay.
    std::size_t i = 0, j = 0;
    for (const auto& [p, q] : kept) {
      in_order(words_a_, words_in(words_a_, i, p), words_b_, words_in(words_b_, j, q));
      i = p + 1, j = q + 1;
    }
    in_order(words_a_, words_in(words_a_, i, lines_a_.size()), words_b_, words_in(words_b_, j, lines_b_.size()));
    strays(words_a_, words_b_, 2);
    return std::move(partner_);
  }

 private:
  static Pieces lines(std::string_view text) {
    Pieces out;
    for (std::size_t at = 0; at <= text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      std::size_t first = at, last = end;
      while (first < last && (text[first] == ' ' || text[first] == '\t')) ++first;
      while (last > first && (text[last - 1] == ' ' || text[last - 1] == '\t')) --last;
      out.push_back({first, last - first, out.size(), false});
      at = end + 1;
    }
    return out;
  }
  static Pieces words(std::string_view text, std::string_view language, const Pieces& lines) {
    Pieces out;
    std::size_t line = 0;
    for (const CodeToken& t : code_tokens(text, language)) {
      while (line + 1 < lines.size() && lines[line + 1].at <= t.at) ++line;
      out.push_back({t.at, t.size, line, false});
    }
    return out;
  }
  // Returns the words of the lines from `first` up to `last`.
  static Range words_in(const Pieces& all, std::size_t first, std::size_t last) {
    const auto at = [&](std::size_t line) {
      return static_cast<std::size_t>(
          std::partition_point(all.begin(), all.end(), [&](const Piece& w) { return w.line < line; }) - all.begin());
    };
    return {at(first), std::max(at(first), at(last))};
  }
  std::vector<Range> pairs_of_lines() const {
    std::vector<Range> out;
    std::size_t j = 0;
    for (std::size_t i = 0; i < lines_a_.size(); ++i) {
      if (!lines_a_[i].paired) continue;
      while (j < lines_b_.size() && !lines_b_[j].paired) ++j;
      out.emplace_back(i, j++);
    }
    return out;
  }

  std::string_view text(const Piece& p) const { return a_.substr(p.at, p.size); }
  std::string_view other(const Piece& p) const { return b_.substr(p.at, p.size); }
  void pair(Piece& p, Piece& q) {
    p.paired = q.paired = true;
    for (std::size_t i = 0; i < p.size; ++i) partner_[p.at + i] = q.at + i;
  }

  // Pairs equal pieces in order, so that as many letters as possible have a partner.
  void in_order(Pieces& a, Range in_a, Pieces& b, Range in_b) {
    std::vector<Piece*> p, q;
    for (std::size_t i = in_a.first; i < in_a.second; ++i)
      if (!a[i].paired && a[i].size > 0) p.push_back(&a[i]);
    for (std::size_t j = in_b.first; j < in_b.second; ++j)
      if (!b[j].paired && b[j].size > 0) q.push_back(&b[j]);
    const std::size_t n = p.size(), m = q.size(), row = m + 1;
    if (n == 0 || m == 0 || n >= most_cells / row) return;
    const auto gain = [&](std::size_t i, std::size_t j) -> std::size_t {
      return text(*p[i]) == other(*q[j]) ? p[i]->size : 0;
    };
    std::vector<std::size_t> best((n + 1) * row);  // from i and j on
    for (std::size_t i = n; i-- > 0;)
      for (std::size_t j = m; j-- > 0;) {
        const std::size_t g = gain(i, j);
        best[i * row + j] =
            std::max({best[(i + 1) * row + j], best[i * row + j + 1], g > 0 ? g + best[(i + 1) * row + j + 1] : 0});
      }
    for (std::size_t i = 0, j = 0; i < n && j < m;) {
      const std::size_t g = gain(i, j);
      if (g > 0 && best[i * row + j] == g + best[(i + 1) * row + j + 1])
        pair(*p[i++], *q[j++]);
      else if (best[(i + 1) * row + j] >= best[i * row + j + 1])
        ++i;
      else
        ++j;
    }
  }

  // Pairs what is left, in order, without pieces shorter than `least`: a bracket should not fly across the block.
  void strays(Pieces& a, Pieces& b, std::size_t least) {
    std::map<std::string_view, std::vector<Piece*>> free;
    for (auto q = b.rbegin(); q != b.rend(); ++q)
      if (!q->paired && q->size >= least) free[other(*q)].push_back(&*q);
    for (Piece& p : a) {
      if (p.paired || p.size < least) continue;
      const auto same = free.find(text(p));
      if (same == free.end() || same->second.empty()) continue;
      pair(p, *same->second.back());
      same->second.pop_back();
    }
  }

  const std::string_view a_, b_;
  std::vector<std::size_t> partner_;
  Pieces lines_a_, lines_b_, words_a_, words_b_;
};

}  // namespace

std::vector<std::size_t> match_code(std::string_view from, std::string_view to, std::string_view language) {
  return CodeMatcher(from, to, language).all();
}

}  // namespace betwixt
