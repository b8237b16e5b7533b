// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/text_match.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace betwixt {
namespace {

using Indices = std::vector<std::size_t>;

class SignMatcher {
 public:
  SignMatcher(const std::vector<MatchedSign>& from, const std::vector<MatchedSign>& to)
      : a_(from), b_(to), of_a_(from.size(), none), of_b_(to.size(), none) {}

  std::vector<std::pair<std::size_t, std::size_t>> all() {
    std::map<std::string_view, std::pair<Indices, Indices>> parts;
    for (std::size_t i = 0; i < a_.size(); ++i)
      if (!a_[i].part.empty()) parts[a_[i].part].first.push_back(i);
    for (std::size_t j = 0; j < b_.size(); ++j)
      if (!b_[j].part.empty()) parts[b_[j].part].second.push_back(j);
    for (const auto& [part, both] : parts) pair(both.first, both.second);
    pair(unpaired(of_a_), unpaired(of_b_));
    std::vector<std::pair<std::size_t, std::size_t>> out;
    for (std::size_t i = 0; i < a_.size(); ++i)
      if (of_a_[i] != none) out.emplace_back(i, of_a_[i]);
    return out;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr std::size_t most_cells = 1'000'000;

  static Indices unpaired(const Indices& partners) {
    Indices out;
    for (std::size_t i = 0; i < partners.size(); ++i)
      if (partners[i] == none) out.push_back(i);
    return out;
  }
  void put(std::size_t i, std::size_t j) { of_a_[i] = j, of_b_[j] = i; }

  void pair(const Indices& a, const Indices& b) {
    if (a.empty() || b.empty()) return;
    if (a.size() < most_cells / (b.size() + 1)) in_order(a, b);
    nearest(a, b);
  }

  // Whether both follow equal signs, as an exponent follows its base.
  bool follow_alike(std::size_t i, std::size_t j) const {
    return i > 0 && j > 0 && a_[i - 1].sign == b_[j - 1].sign && a_[i - 1].part == b_[j - 1].part;
  }

  // The longest common subsequence. It prefers signs that follow equal ones, and then those at similar places.
  void in_order(const Indices& a, const Indices& b) {
    const std::size_t n = a.size(), m = b.size(), row = m + 1;
    const auto gain = [&](std::size_t i, std::size_t j) {
      if (a_[a[i]].sign != b_[b[j]].sign) return 0.0;
      const auto place = [](std::size_t k, std::size_t of) {
        return (static_cast<double>(k) + 0.5) / static_cast<double>(of);
      };
      return 1 + 0.4 * follow_alike(a[i], b[j]) +
             0.4 / static_cast<double>(std::max(n, m)) * (1 - std::abs(place(i, n) - place(j, m)));
    };
    std::vector<double> best((n + 1) * row);  // from i and j on
    for (std::size_t i = n; i-- > 0;)
      for (std::size_t j = m; j-- > 0;) {
        const double g = gain(i, j);
        best[i * row + j] =
            std::max({best[(i + 1) * row + j], best[i * row + j + 1], g > 0 ? g + best[(i + 1) * row + j + 1] : 0.0});
      }
    for (std::size_t i = 0, j = 0; i < n && j < m;) {
      const double g = gain(i, j);
      if (g > 0 && best[i * row + j] <= g + best[(i + 1) * row + j + 1])
        put(a[i++], b[j++]);
      else if (best[(i + 1) * row + j] >= best[i * row + j + 1])
        ++i;
      else
        ++j;
    }
  }

  // Pairs what is left, each sign with the nearest equal one, but better with one that follows an equal sign.
  void nearest(const Indices& a, const Indices& b) {
    std::map<std::string_view, Indices> free;
    for (const std::size_t j : b)
      if (of_b_[j] == none) free[b_[j].sign].push_back(j);
    for (const std::size_t i : a) {
      if (of_a_[i] != none) continue;
      const auto same = free.find(a_[i].sign);
      if (same == free.end() || same->second.empty()) continue;
      Indices& all = same->second;
      const auto away = [&](std::size_t j) { return length(b_[j].at - a_[i].at) + (follow_alike(i, j) ? 0 : 1e6); };
      const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(all.size(), 200));
      const auto best =
          std::min_element(all.begin(), end, [&](std::size_t p, std::size_t q) { return away(p) < away(q); });
      put(i, *best);
      all.erase(best);
    }
  }

  const std::vector<MatchedSign>&a_, &b_;
  Indices of_a_, of_b_;  // the partners
};

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> match_signs(const std::vector<MatchedSign>& from,
                                                             const std::vector<MatchedSign>& to) {
  return SignMatcher(from, to).all();
}

}  // namespace betwixt
