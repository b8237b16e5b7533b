// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/line_merge.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "syntax/script_text.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

using Lines = std::vector<std::string_view>;

Lines lines_of_text(std::string_view text) {
  Lines all;
  for (const std::size_t at : line_starts(text)) all.push_back(line_at(text, at));
  return all;
}

constexpr int none = -1;

// For each line of `a` its equal in `b`, in order, or `none`: a longest common subsequence, by Myers' algorithm.
class Matching {
 public:
  Matching(const Lines& a, const Lines& b) : a_(a), b_(b), match_(a.size(), none) {
    int head = 0;
    const int n = static_cast<int>(a.size()), m = static_cast<int>(b.size());
    while (head < n && head < m && a[at(head)] == b[at(head)]) match_[at(head)] = head, ++head;
    int tail = 0;
    while (tail < n - head && tail < m - head && a[at(n - 1 - tail)] == b[at(m - 1 - tail)]) {
      match_[at(n - 1 - tail)] = m - 1 - tail;
      ++tail;
    }
    middle(head, n - head - tail, m - head - tail);
  }
  std::vector<int> take() && { return std::move(match_); }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  // `from`: where the middle begins in both; n and m: its lines.
  void middle(int from, int n, int m) {
    constexpr int most_steps = 3000;  // texts with more differences count as wholly different there
    if (n == 0 || m == 0) return;
    std::vector<std::vector<int>> trace;
    std::vector<int> far(at(2 * std::min(n + m, most_steps) + 3), 0);
    const int zero = static_cast<int>(far.size()) / 2;
    for (int d = 0; d <= std::min(n + m, most_steps); ++d) {
      trace.push_back(std::vector<int>(far.begin() + zero - d, far.begin() + zero + d + 1));
      for (int k = -d; k <= d; k += 2) {
        const bool down = k == -d || (k != d && far[at(zero + k - 1)] < far[at(zero + k + 1)]);
        int x = down ? far[at(zero + k + 1)] : far[at(zero + k - 1)] + 1;
        while (x < n && x - k < m && a_[at(from + x)] == b_[at(from + x - k)]) ++x;
        far[at(zero + k)] = x;
        if (x >= n && x - k >= m) return walk_back(from, n, m, trace);
      }
    }
  }
  // Goes back through the steps. trace[d] holds the farthest places before step d, for the diagonals -d … d.
  void walk_back(int from, int x, int m, const std::vector<std::vector<int>>& trace) {
    int y = m;
    for (int d = static_cast<int>(trace.size()) - 1; d > 0; --d) {
      const auto far = [&](int k) { return std::abs(k) <= d ? trace[at(d)][at(k + d)] : 0; };
      const int k = x - y;
      const int before = k == -d || (k != d && far(k - 1) < far(k + 1)) ? k + 1 : k - 1;
      const int old_x = far(before), old_y = old_x - before;
      while (x > old_x && y > old_y) --x, --y, match_[at(from + x)] = from + y;
      x = old_x, y = old_y;
    }
    while (x > 0 && y > 0) --x, --y, match_[at(from + x)] = from + y;
  }

  const Lines &a_, &b_;
  std::vector<int> match_;
};

class Regions {
 public:
  Regions(std::string_view base, std::string_view mine, std::string_view theirs)
      : base_(lines_of_text(base)), mine_(lines_of_text(mine)), theirs_(lines_of_text(theirs)) {}

  std::vector<LineRegion> all() {
    const std::vector<int> to_mine = equal_lines(base_, mine_), to_theirs = equal_lines(base_, theirs_);
    std::size_t b = 0, m = 0, t = 0;
    while (b < base_.size() || m < mine_.size() || t < theirs_.size()) {
      std::size_t next = b;
      while (next < base_.size() && (to_mine[next] == none || to_theirs[next] == none)) ++next;
      const bool end = next == base_.size();
      const auto next_m = end ? mine_.size() : static_cast<std::size_t>(to_mine[next]);
      const auto next_t = end ? theirs_.size() : static_cast<std::size_t>(to_theirs[next]);
      if (next > b || next_m > m || next_t > t)
        apart(part(base_, b, next), part(mine_, m, next_m), part(theirs_, t, next_t));
      b = next, m = next_m, t = next_t;
      if (!end) all_.push_back({{base_[b]}, {mine_[m]}, {theirs_[t]}, false}), ++b, ++m, ++t;
    }
    return std::move(all_);
  }

 private:
  static Lines part(const Lines& of, std::size_t from, std::size_t to) {
    return {of.begin() + static_cast<std::ptrdiff_t>(from), of.begin() + static_cast<std::ptrdiff_t>(to)};
  }
  void apart(Lines base, Lines mine, Lines theirs) {
    // Lines that were changed side by side are compared one by one.
    if (base.size() > 1 && base.size() == mine.size() && base.size() == theirs.size()) {
      for (std::size_t i = 0; i < base.size(); ++i) apart({base[i]}, {mine[i]}, {theirs[i]});
      return;
    }
    const bool conflict = mine != base && theirs != base && mine != theirs;
    if (conflict && (cut(base, mine, theirs, false) || cut(base, theirs, mine, true))) return;
    all_.push_back({std::move(base), std::move(mine), std::move(theirs), conflict});
  }

  // Cuts a region in two if the changes of `first` end before those of `second` begin.
  bool cut(const Lines& base, const Lines& first, const Lines& second, bool swapped) {
    const auto front = std::mismatch(base.begin(), base.end(), second.begin(), second.end());
    const auto back = std::mismatch(base.rbegin(), base.rend(), first.rbegin(), first.rend());
    const auto begin = static_cast<std::size_t>(front.first - base.begin());
    const auto same = static_cast<std::size_t>(back.first - base.rbegin());
    const std::size_t end = base.size() - same;
    const bool both_add = end == begin && first.size() > base.size() && second.size() > base.size();
    if (end > begin || both_add) return false;
    const Lines left = part(base, 0, end), right = part(base, end, base.size());
    const Lines changed = part(first, 0, first.size() - same), kept = part(first, first.size() - same, first.size());
    const Lines before = part(second, 0, end), after = part(second, end, second.size());
    if (swapped) {
      apart(left, before, changed), apart(right, after, kept);
    } else {
      apart(left, changed, before), apart(right, kept, after);
    }
    return true;
  }

  Lines base_, mine_, theirs_;
  std::vector<LineRegion> all_;
};

void put(std::string& text, std::string_view line) {
  if (!text.empty() && text.back() != '\n') text += '\n';  // after a last line without a line feed
  text += line;
}
void put(std::string& text, const Lines& lines) {
  for (const std::string_view line : lines) put(text, line);
}

std::optional<std::string_view> comment_of(std::string_view line) {
  Lexer lexer(line);
  while (const auto token = lexer.next())
    if (token->kind == TokenKind::comment) return lexer.of(*token);
  return std::nullopt;
}
// Puts the comments of a region that only one side has.
void put_own_comments(std::string& text, const LineRegion& r) {
  const auto has = [](const Lines& lines, std::string_view comment) {
    return std::ranges::any_of(lines, [&](std::string_view line) { return comment_of(line) == comment; });
  };
  for (const std::string_view line : r.theirs) {
    const auto comment = comment_of(line);
    if (!comment || has(r.base, *comment) || has(r.mine, *comment)) continue;
    put(text, std::string(line.substr(0, line.size() - without_indent(line).size())) + std::string(*comment) + "\n");
  }
}

}  // namespace

std::vector<int> equal_lines(const Lines& a, const Lines& b) { return Matching(a, b).take(); }

std::vector<LineRegion> regions_of(std::string_view base, std::string_view mine, std::string_view theirs) {
  return Regions(base, mine, theirs).all();
}

std::string text_of(const std::vector<LineRegion>& regions, InConflict how) {
  std::string text;
  for (const LineRegion& r : regions) {
    if (!r.conflict) {
      put(text, r.merged());
    } else if (how == InConflict::marks) {
      put(text, "<<<<<<< mine\n");
      put(text, r.mine);
      put(text, "=======\n");
      put(text, r.theirs);
      put(text, ">>>>>>> theirs\n");
    } else if (r.base.empty() && how != InConflict::mine) {
      put(text, how == InConflict::mine_theirs ? r.mine : r.theirs);
      put(text, how == InConflict::mine_theirs ? r.theirs : r.mine);
    } else {
      put(text, r.mine);
      put_own_comments(text, r);
    }
  }
  return text;
}

}  // namespace betwixt
