// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt algebra --css: the frames that a browser shows between two lists, or between `none` and a list that is no
// motion.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/algebra.h"
#include "app/command.h"
#include "base/tell_user.h"
#include "language/values.h"

namespace betwixt::algebra_command {
namespace {

struct Lists {
  CssList from, to;
};

// Reads a list. Returns the exit code.
int read_list(const std::string& text, const Call& call, const char* name, CssList& list) {
  const auto page = read_page(call);
  if (!page) return complain(page.error(), wrong_call);
  const auto read = parse_css(text, *page);
  if (!read) return complain_about(text, read.error(), name);
  list = *read;
  return all_done;
}

int read_lists(const Call& call, Lists& lists) {
  CssList first, second, under;
  int code = read_list(call.motion, call, call.css_to.empty() ? "motion" : "from", first);
  if (code == all_done) code = read_list(call.css_to, call, "to", second);
  if (code == all_done) code = read_list(call.css_under, call, "under", under);
  if (code != all_done) return code;
  // A single list is the end; the start is `none`.
  if (call.css_to.empty()) std::swap(first, second);
  const auto over = [&](const CssList& list) {
    if (call.accumulate) return css_accumulated(under, list);
    CssList both = under;
    both.insert(both.end(), list.begin(), list.end());
    return both;
  };
  lists = {over(first), over(second)};
  return all_done;
}

// Returns whether a list stays in the plane z = 0.
bool planar(const CssList& list) {
  using Kind = CssFunction::Kind;
  return std::all_of(list.begin(), list.end(), [](const CssFunction& f) {
    if (f.kind == Kind::translate) return f.by.z == 0;
    if (f.kind == Kind::rotate) return f.axis.x == 0 && f.axis.y == 0;
    return f.kind != Kind::matrix || (f.matrix(2, 0) == 0 && f.matrix(2, 1) == 0 && f.matrix(2, 3) == 0);
  });
}

// Prints notices about pairs that browsers do not interpolate function by function.
void say_what_is_lost(const CssBetween& now) {
  const auto say = [](const std::string& what) { tell_user(fmt::format("betwixt: notice: {}\n", what)); };
  if (now.mixed != 0)
    say(fmt::format("the lists differ from function {} on, so matrices are blended and whole turns are lost",
                    now.mixed));
  if (now.short_way != 0)
    say(fmt::format("function {} rotates about two axes, so it takes the short way and whole turns are lost",
                    now.short_way));
  if (now.jumps) say("a matrix is flat and cannot be blended, so one list applies up to half way, then the other");
}

// A point behind the eye has no place; it becomes NaN.
Status see(const Mat4& m, double k, const std::vector<Point>& rest, Shown& shown) {
  shown.matrix = m;
  for (std::size_t p = 0; p < rest.size(); ++p) {
    const Vec3 at = rest[p].at;
    const double w = m(3, 0) * at.x + m(3, 1) * at.y + m(3, 2) * at.z + m(3, 3);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    shown.points[p].at = w > 0 ? 1 / w * transform_point(m, at) : Vec3{none, none, none};
    if ((w > 0 && !finite(shown.points[p].at)) || !finite(m))
      return fail(ErrorCode::range, fmt::format("frame {}: a position is not finite", write_number(k)));
  }
  return Nothing{};
}

}  // namespace

bool beyond_motions(const Call& call) {
  if (!call.css_to.empty() || !call.css_under.empty()) return true;
  const auto page = read_page(call);
  return page && !from_css(call.motion, {}, *page);
}

namespace {

// Reads W,H of an option, if it is given.
Status read_size(const std::string& text, const char* option, std::optional<double>& width,
                 std::optional<double>& height) {
  if (text.empty()) return Nothing{};
  const auto size = read_points(text);
  if (!size || size->size() != 1 || (*size)[0].numbers != 2)
    return fail(ErrorCode::syntax, fmt::format("{}: '{}' is not a size", option, text.substr(0, 60)),
                fmt::format("as in {} 100,50", option));
  width = (*size)[0].at.x, height = (*size)[0].at.y;
  return Nothing{};
}

}  // namespace

Result<CssPage> read_page(const Call& call) {
  CssPage page;
  if (const Status s = read_size(call.size, "--size", page.width, page.height); !s) return s.error();
  if (const Status s = read_size(call.viewport, "--viewport", page.viewport_width, page.viewport_height); !s)
    return s.error();
  if (call.font_size.empty()) return page;
  const auto font_size = read_number(call.font_size, "--font-size");
  if (!font_size) return font_size.error();
  page.font_size = page.root_font_size = *font_size;
  return page;
}

int show_css(const Call& call, const Asked& given) {
  Lists lists;
  if (const int code = read_lists(call, lists); code != all_done) return code;
  if (call.lesson || call.symbols || call.count || call.inverse || call.to_css || given.method)
    return complain(
        fail(ErrorCode::type, "these lists are not a motion; only their frames can be printed",
             "methods, counts, inverses, symbolic matrices and lessons need translations, rotations and scalings"),
        wrong_call);
  Asked asked = given;
  if (!planar(lists.from) || !planar(lists.to))
    for (Point& p : asked.points) p.numbers = 3;
  const CssBetween any = css_between(lists.from, lists.to, 0);
  say_what_is_lost(any);
  std::string head;
  if (any.mixed != 0) head += fmt::format("\"mixed\":{},", any.mixed);
  if (any.short_way != 0) head += fmt::format("\"short_way\":{},", any.short_way);
  if (any.jumps) head += "\"jumps\":true,";
  return show_frames(call, asked, head, "", [&](double k, Shown& shown) {
    const Mat4 m = css_between(lists.from, lists.to, k / static_cast<double>(call.steps)).matrix;
    return see(translation(asked.origin) * m * translation(-asked.origin), k, asked.points, shown);
  });
}

}  // namespace betwixt::algebra_command
