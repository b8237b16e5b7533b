// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests display lists in the language: what their rows draw, and where, at any time.
#include <random>

#include "commands/reader.h"
#include "scene/document.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// ---- An interpreter of display lists as in the source: only a stack of matrices, for row vectors.

using Rows = std::array<std::array<double, 4>, 4>;
using Point = std::array<double, 4>;

constexpr Rows unit{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

Rows times(const Rows& a, const Rows& b) {
  Rows r{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t n = 0; n < 4; ++n) r[i][k] += a[i][n] * b[n][k];
  return r;
}
Point times(const Point& p, const Rows& m) {
  Point r{};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t n = 0; n < 4; ++n) r[k] += p[n] * m[n][k];
  return r;
}
// The matrices of the source's appendix, A.1 to A.5.
Rows moved(double x, double y, double z) { return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {x, y, z, 1}}}; }
Rows scaled(double x, double y, double z) { return {{{x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}, {0, 0, 0, 1}}}; }
Rows turned(char axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  if (axis == 'x') return {{{1, 0, 0, 0}, {0, c, s, 0}, {0, -s, c, 0}, {0, 0, 0, 1}}};
  if (axis == 'y') return {{{c, 0, -s, 0}, {0, 1, 0, 0}, {s, 0, c, 0}, {0, 0, 0, 1}}};
  return {{{c, s, 0, 0}, {-s, c, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

struct Row {
  std::string text;
  enum { draw, multiply, push, pop, begin, end, call } what = draw;
  std::size_t which = 0;  // environment or list
  Rows m = unit;
  std::vector<Point> points;
};
struct RandomFilm {
  struct Environment {
    Rows m = unit;
    int interval = 1;
    bool there = true;
  };
  std::mt19937 random;
  std::vector<Environment> environments;
  std::vector<std::vector<Row>> lists;

  explicit RandomFilm(unsigned seed) : random(seed) {
    for (int i = 0; i < 4; ++i) environments.push_back({transform().m, pick(1, 5), i < 3});
    const int n = pick(1, 5);
    for (int i = 0; i < n; ++i) {
      lists.emplace_back();
      fill(lists.back(), 0, pick(1, 9), static_cast<std::size_t>(i));
    }
  }
  int pick(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); }
  double number() { return pick(-40, 40) / 10.0; }

  struct Said {
    std::string text;
    Rows m;
  };
  Said transform() {
    const double x = number(), y = number(), z = number();
    switch (pick(0, 2)) {
      case 0:
        return {fmt::format("translate({} {} {})", x, y, z), moved(x, y, z)};
      case 1: {
        const int degrees = pick(-180, 180);
        const char axis = "xyz"[pick(0, 2)];
        return {fmt::format("rotate({}deg, {})", degrees, axis), turned(axis, degrees * pi / 180)};
      }
      default: {
        const double s[] = {pick(7, 13) / 10.0, pick(7, 13) / 10.0, pick(7, 13) / 10.0};
        return {fmt::format("scale({} {} {})", s[0], s[1], s[2]), scaled(s[0], s[1], s[2])};
      }
    }
  }
  Row primitive() {
    Row row;
    static constexpr std::pair<const char*, int> kinds[] = {{"point", 1}, {"vector", 2}, {"polygon", 3}};
    const auto [word, least] = kinds[pick(0, 2)];
    row.text = word;
    for (int i = pick(least, least + 2); i > 0; --i) {
      row.points.push_back({number(), number(), number(), 1});
      const Point& p = row.points.back();
      row.text += fmt::format(" ({} {} {})", p[0], p[1], p[2]);
    }
    return row;
  }
  void fill(std::vector<Row>& rows, int depth, int count, std::size_t self) {
    for (; count > 0; --count) {
      const int what = pick(0, depth < 3 ? 9 : 6);
      if (what <= 2) {
        rows.push_back(primitive());
      } else if (what <= 4) {
        const Said t = transform();
        rows.push_back({pick(0, 1) ? t.text : "multiply " + t.text, Row::multiply, 0, t.m, {}});
      } else if (what <= 6) {
        if (self == 0) continue;
        const auto other = static_cast<std::size_t>(pick(0, static_cast<int>(self) - 1));
        rows.push_back({fmt::format("call list{}", other), Row::call, other, unit, {}});
      } else if (what == 7) {
        rows.push_back({"push", Row::push, 0, unit, {}});
        fill(rows, depth + 1, pick(0, 4), self);
        rows.push_back({"pop", Row::pop, 0, unit, {}});
      } else {
        const auto e = static_cast<std::size_t>(pick(0, 3));
        rows.push_back({fmt::format("begin e{}", e), Row::begin, e, unit, {}});
        fill(rows, depth + 1, pick(0, 4), self);
        rows.push_back({"end", Row::end, 0, unit, {}});
      }
    }
  }

  std::string text(std::vector<std::string> motions) const {
    std::string out = "ticks 30\n";
    for (std::size_t i = 0; i < 3; ++i)
      out += fmt::format("animate e{} every {}t by {}\n", i, environments[i].interval, motions[i]);
    for (std::size_t i = 0; i < lists.size(); ++i) {
      out += fmt::format("make list{}\n", i);
      for (const Row& row : lists[i]) out += "  " + row.text + "\n";
    }
    return out + fmt::format("start list{}\n", lists.size() - 1);
  }

  // Returns the positions of all points of the list after so many ticks.
  void draw(std::size_t list, std::vector<Rows> stack, int tick, std::vector<Point>& out) const {
    for (const Row& row : lists[list]) {
      switch (row.what) {
        case Row::draw:
          for (const Point& p : row.points) out.push_back(times(p, stack.back()));
          break;
        case Row::multiply:
          stack.back() = times(row.m, stack.back());
          break;
        case Row::push:
          stack.push_back(stack.back());
          break;
        case Row::begin:
          stack.push_back(stack.back());
          if (environments[row.which].there)
            for (int n = 0; n <= tick / environments[row.which].interval; ++n)
              stack.back() = times(environments[row.which].m, stack.back());
          break;
        case Row::pop:
        case Row::end:
          stack.pop_back();
          break;
        case Row::call:
          draw(row.which, {stack.back()}, tick, out);
          break;
      }
    }
  }
};

// Returns the positions that the document shows, in the order of the rows.
std::vector<Vec3> drawn_points(const Program& program, Time t) {
  std::vector<Vec3> out;
  const Scene& s = program.document().scene();
  for (const ObjectId id : *s.expansion) {
    const Slot* points = s.objects[id.index].find(fn::points);
    if (!points) continue;
    const Mat4 world = *std::get<Matrix>(program.read({id, Query::world}, t));
    for (const Vec3& p : *std::get<Points>(*points->set)) out.push_back(transform_point(world, p));
  }
  return out;
}

// shows: C18 C19 C20 C22 C23 C24 C25 C26 C27 C28 C29 C31 C32 C33 C35 C36 C37 C38 C39 C56 C57 C58 C61 C62 C64 C65 C67
// shows: C68 C74 C75 C76 C77 C78
TEST(DisplayList, A_thousand_films_are_where_a_stack_of_matrices_puts_them) {
  std::size_t compared = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    RandomFilm film(seed);
    std::vector<std::string> motions;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto t = film.transform();
      film.environments[i].m = t.m;
      motions.push_back(t.text);
    }
    const std::string text = film.text(motions);
    const Loaded loaded = read(text);
    ASSERT_FALSE(has_errors(loaded.diagnostics)) << text << said(loaded.diagnostics);
    const Program program = Program::compile(loaded.document);
    for (const int tick : {0, 1, 4, 7, 12}) {
      std::vector<Point> wanted;
      film.draw(film.lists.size() - 1, {unit}, tick, wanted);
      const auto is = drawn_points(program, Rate{30, 1}.span(tick));
      ASSERT_EQ(is.size(), wanted.size()) << text;
      compared += is.size();
      for (std::size_t i = 0; i < is.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
          ASSERT_NEAR(is[i][static_cast<int>(k)], wanted[i][k], 1e-9 * std::max(1.0, std::abs(wanted[i][k])))
              << "seed " << seed << ", tick " << tick << "\n"
              << text;
    }
    if (seed % 10 != 0) continue;
    const Loaded again = read(write(loaded.document));
    EXPECT_TRUE(again.document == loaded.document) << text << write(loaded.document) << said(again.diagnostics);
    EXPECT_TRUE(read(tidy(text)).document == loaded.document) << tidy(text);
  }
  EXPECT_GT(compared, 30'000u);
}

constexpr std::string_view stars = R"(animate spin every 1t by rotate(6deg, z)
make star
  color gold
  polygon (0 1) (0.2 0.2) (1 0)
make sky
  begin spin
    call star
  end
  translate(3 0 0)
  begin spin
    call star
  end
  vector (0 0) (1 1)
start sky
)";

// shows: C19 C21 C22 C26 C29 C66
TEST(DisplayList, What_it_draws_has_readable_names) {
  const LoadedFilm s(stars);
  EXPECT_EQ(s.loaded.document.names(),
            (std::vector<std::string>{"spin", "sky", "sky/spin-1", "sky/spin-1/star-1", "sky/spin-1/star-1/polygon-1",
                                      "sky/spin-2-base", "sky/spin-2", "sky/spin-2/star-1",
                                      "sky/spin-2/star-1/polygon-1", "sky/vector-1"}));
  expect_numbers(s, "sky/spin-2/star-1.world", "14t",
                 {0, -1, 0, 3, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});  // 15 updates, with the first at once
}

// shows: C27
TEST(DisplayList, An_instance_keeps_its_color_and_its_matrix_to_itself) {
  const LoadedFilm s(R"(make red
  color red
  scale(2)
  push
  translate(9 9 9)
  pop
  polygon (0 0) (1 0) (0 1)
make all
  polygon (0 0) (1 0) (0 1)
  call red
  polygon (0 0) (1 0) (0 1)
  color blue
  call plain
  push
  color green
  pop
  point (1 0 0)
make plain
  polygon (0 0) (1 0) (0 1)
start all
)");
  expect_numbers(s, {{"all/polygon-1.color", "1f", {1, 1, 1}},
                     {"all/red-1/polygon-1.color", "1f", {1, 0, 0}},
                     {"all/polygon-2.color", "1f", {1, 1, 1}},
                     {"all/plain-1/polygon-1.color", "1f", {0, 0, 1}},
                     {"all/red-1/polygon-1.world", "1f", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1}},
                     {"all/polygon-2.world", "1f", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
  // The stack has only matrices, so `pop` does not restore colours.
  expect_numbers(s, "all/point-1.color", "1f", {0, 128.0 / 255, 0}, 1e-9);
}

// shows: C17 C30
TEST(DisplayList, The_main_list_sees_the_film) {
  const LoadedFilm s(R"(create other camera position=(0 0 100)
make all
  perspective 40deg
  translate(1 2 3)
  view from (0 0 10) to (0 0 0)
  call inner
make inner
  orthographic 7
  view from (0 50 0) to (0 0 0)
start all
)");
  const Camera c = s.frame("1f").camera;
  EXPECT_FALSE(c.orthographic);
  EXPECT_NEAR(c.fov, 40 * pi / 180, 1e-12);
  EXPECT_EQ(translation_of(c.world), (Vec3{1, 2, 13}));
  EXPECT_EQ(transform_vector(c.world, {0, 0, -1}), (Vec3{0, 0, -1}));
  const LoadedFilm o("make all\n  orthographic 7\n  view from (0 0 4) to (9 0 4)\nstart all\n");
  EXPECT_TRUE(o.frame("1f").camera.orthographic);
  EXPECT_EQ(o.frame("1f").camera.height, 7);
  // A cut of the author takes precedence.
  const LoadedFilm cut(
      "create eye camera position=(0 0 9)\nmake all\n  view from (1 1 1) to (0 0 0)\nstart all\n"
      "look through eye\n");
  EXPECT_EQ(translation_of(cut.frame("1f").camera.world), (Vec3{0, 0, 9}));
}

// shows: C69 C70 C71
TEST(DisplayList, Rows_are_added_and_replaced) {
  const std::string text = std::string(R"(make a
  tag first
  point (1 0 0)
  point (2 0 0)
  tag last
  point (3 0 0)
start a
edit a
  point (4 0 0)
  replace first 1
  vector (0 0 0) (5 0 0)
  replace last
  tag newer
  point (6 0 0)
  point (7 0 0)
  point (8 0 0)
)");
  const LoadedFilm s(text);
  const auto xs = [](const Document& d) {
    std::vector<double> out;
    for (const Vec3& p : drawn_points(Program::compile(d), {})) out.push_back(p.x);
    return out;
  };
  EXPECT_EQ(xs(s.loaded.document), (std::vector<double>{1, 0, 5, 6, 7, 8}));
  EXPECT_TRUE(read(write(s.loaded.document)).document == s.loaded.document) << write(s.loaded.document);
  EXPECT_EQ(tidy(text), text);
  const auto more = read(text + "edit a\n  replace newer -1\n  point (9 0 0)\n");
  EXPECT_EQ(xs(more.document), (std::vector<double>{1, 9, 6, 7, 8})) << said(more.diagnostics);
}

// shows: C56 C105
TEST(DisplayList, An_environment_may_get_another_name) {
  const LoadedFilm s(std::string(stars) + "rename spin turn\n");
  EXPECT_TRUE(s.loaded.document.find("sky/turn-2/star-1"));
  EXPECT_FALSE(s.loaded.document.find("sky/spin-2/star-1"));
  expect_numbers(s, "sky/turn-2/star-1.world", "14t", {0, -1, 0, 3, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
}

// shows: C66 C67
TEST(DisplayList, A_list_may_get_another_name_and_keeps_what_hangs_on_it) {
  const std::string before = std::string(stars) + "at 10t edit star\n  point (7 7)\ncreate moon sphere\n" +
                             "couple moon to sky/spin-1/star-1\n";
  const LoadedFilm s(before + "rename star sun\nrename sky heaven\nrename spin turn\n");
  const Document& d = s.loaded.document;
  EXPECT_TRUE(d.find("heaven/turn-1/sun-1/polygon-1"));
  EXPECT_FALSE(d.find("sky"));
  EXPECT_EQ(d.scene().main, "heaven");
  EXPECT_TRUE(std::get<bool>(s.read("heaven/turn-2/sun-1/point-1.display", "10t")));
  EXPECT_EQ(s.numbers("moon.world", "4t"), LoadedFilm(before).numbers("moon.world", "4t"));
  EXPECT_NE(s.numbers("moon.world", "4t"), s.numbers("moon.world", "5t"));
  EXPECT_TRUE(read(write(d)).document == d) << write(d);
  EXPECT_EQ(all_told(read(std::string(stars) + "rename star sky\n")), std::vector<std::string>{"name 15:13 sky"});
  EXPECT_EQ(all_told(read("animate a/b every 1t by translate(1 0 0)\nmake b\n  point (0 0)\nrename b a\n")),
            std::vector<std::string>{"name 4:10 a"});
  EXPECT_TRUE(mentions("animate a/b every 1t by translate(1 0 0)\nmake b\n  point (0 0)\nrename b a\n", "'a/b'"));
  EXPECT_EQ(all_told(read("make b\n  push\nrename b c\n")), std::vector<std::string>{"syntax 2:3 push"});
  EXPECT_EQ(all_told(read("make b\n  push\nrename b c\nedit c\n  pop\n")), std::vector<std::string>{});
}

// shows: C72
TEST(DisplayList, A_deleted_list_draws_nothing) {
  const auto loaded = read(std::string(stars) + "delete star\n");
  EXPECT_EQ(said(loaded.diagnostics),
            "test.bx:15:8: warning: 'sky' still calls 'star', which draws nothing now\n  delete star\n         ^~~~\n");
  EXPECT_EQ(loaded.document.names(),
            (std::vector<std::string>{"spin", "sky", "sky/spin-1", "sky/spin-2-base", "sky/spin-2", "sky/vector-1"}));
  const auto again = read(std::string(stars) + "delete star\nmake star\n  point (0 0)\n");
  EXPECT_TRUE(again.document.find("sky/spin-1/star-1/point-1"));
  const auto none = read(std::string(stars) + "delete sky\n");
  EXPECT_EQ(none.document.names(), std::vector<std::string>{"spin"});
}

// shows: C19 C65 C67 C77 C80
TEST(DisplayList, Errors_say_what_and_where) {
  const std::pair<const char*, const char*> table[] = {
      {"make a\n  polygon (0 0) (1 0)\n", "syntax 2:22"},
      {"make a\n  vector (0 0)\n", "syntax 2:15"},
      {"make a\n  point\n", "syntax 2:8"},
      {"make a\n  pop\n", "syntax 2:3 pop"},
      {"make a\n  push\n  end\n  pop\n", "syntax 3:3 end"},
      {"make a\n  push\nstart a\n", "syntax 2:3 push"},
      {"make a\n  begin spin\n  point (0 0)\n", "syntax 2:3 begin"},
      {"make a\n  tag x\n  push\n  pop\nedit a\n  replace x\n  point (0 0)\n", "syntax 5:6 a"},
      {"make a\n  call a\n", "name 2:8 a"},
      {"make a\n  call b\nmake b\n  call c\nmake c\n  call a\n", "name 6:8 a"},
      {"make a\n  spin\n", "name 2:3 spin"},
      {"make a\n  create ball sphere\n", "name 2:3 create"},
      {"make a\n  replace x\n", "name 2:11 x"},
      {"make a\n  tag x\n  tag x\n", "name 3:7 x"},
      {"make a\n  tag x\n  point (0 0)\n  replace x 2\n", "range 4:13 2"},
      {"make a\n  view from (0 0) to (0 0)\n", "range 2:22 (0 0)"},
      {"make a\n  orthographic 0\n", "range 2:16 0"},
      {"make a\nmake a\n", "name 2:6 a"},
      {"create a group\nmake a\n", "name 2:6 a"},
      {"make a\ncreate a group\n", "name 2:8 a"},
      {"make a\ncreate a/b group\n", "name 2:8 a/b"},
      {"edit star\n", "name 1:6 star"},
      {"delete star\n", "name 1:8 star"},
      {"start star\n", "name 1:7 star"},
      {"at 3f start a\n", "syntax 1:7 start"},
      {"create b group\nmake a\n  call b\n", "type 3:8 b"},
      {"make a\n  color rde\n", "name 2:9 rde"},
      {"make\n  point (0 0)\n", "syntax 1:5"},
      {"make a b\n", "syntax 1:8 b"},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(all_told(read(text)), std::vector<std::string>{message}) << text;
  const auto unknown = read("make one\n  call two\nmake three\n  call thee\n");
  EXPECT_EQ(said(unknown.diagnostics),
            "test.bx:2:8: warning: there is no display list 'two' yet, so this draws nothing until then\n    call "
            "two\n         ^~~\ntest.bx:4:8: warning: there is no display list 'thee' yet, so this draws nothing until "
            "then\n    call thee\n         ^~~~\n  did you mean 'three'?\n");
}

TEST(DisplayList, Only_its_rows_say_what_it_draws) {
  for (const char* line :
       {"set sky/vector-1.color red", "at 3f sky/vector-1.color red", "hide sky/vector-1", "remove sky/vector-1",
        "rename sky/vector-1 line", "couple sky/vector-1 to moon", "sky/vector-1.position\n  1f (0 0 0)",
        "filter sky/vector-1.position delay by=2f", "dial /a to sky/vector-1.width"}) {
    const auto all = all_told(read(std::string(stars) + "create moon sphere\n" + line + "\n"));
    ASSERT_EQ(all.size(), 1u) << line;
    EXPECT_TRUE(all[0].starts_with("type 16:") && all[0].find(" sky/vector-1") != std::string::npos) << all[0];
  }
  const auto refused = all_told(read(std::string(stars) + "set sky/vector-1.color red\n"));
  EXPECT_EQ(refused, std::vector<std::string>{"type 15:5 sky/vector-1.color"});
  // Patterns name everything that can be changed, and in questions also everything that can be read.
  const LoadedFilm s(std::string(stars) +
                     "create sky2 group\nset sky*.color red\ncreate copy like sky/vector-1\n"
                     "set copy.color blue\n");
  EXPECT_EQ(find_targets("sky/*.color", s.loaded.document)->size(), 4u);
  expect_numbers(s, "sky2.color", "1f", {1, 0, 0});
}

// shows: C28 C67
TEST(DisplayList, Others_hang_on_what_it_draws) {
  const std::string text = std::string(stars) +
                           "create moon sphere position=(1 0 0)\ncouple moon to sky/spin-2/star-1\n"
                           "create eye camera position=(0 0 9) look-at=sky/spin-1/star-1\n";
  const LoadedFilm s(text);
  expect_numbers(s, "moon.world", "14t", {0, -1, 0, 3, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1});
  EXPECT_TRUE(read(write(s.loaded.document)).document == s.loaded.document) << write(s.loaded.document);
  // When the parent no longer exists, its children have no parent.
  const LoadedFilm gone(text + "edit sky\n  tag x\n  replace x\ndelete star\nmake star\n  point (0 0)\n");
  expect_numbers(gone, "moon.world", "14t", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
}

// Rows that arrive one by one are written below a line that opens the list again, whatever other hosts do in between.
// The text of all lines makes the same document.
TEST(DisplayList, Hosts_write_display_lists_side_by_side) {
  Document document;
  ReaderState progress;
  std::shared_ptr<const OpenSheet> sheets[2];
  std::string history;
  const auto opener = [&](int host) { return sheets[host] ? sheets[host]->opener : ""; };
  const auto enter = [&](int host, const std::string& line) {
    Scene scene = document.scene();
    Diagnostics all;
    progress.left = sheets[host];
    const std::string above = line[0] == ' ' ? opener(host) : "";
    Script script(scene, all, {}, progress, Home());
    read_line(scene, script, line, "host");
    EXPECT_EQ(said(all), "") << line;
    document = Document(std::make_shared<const Scene>(std::move(scene)));
    progress = script;
    sheets[host] = script.left;
    history += above + "\n" + line + "\n";
  };
  for (const auto& [host, line] : {std::pair{0, "make a"},
                                   {1, "make b"},
                                   {0, "  begin e"},
                                   {1, "  tag x"},
                                   {1, "  point (0 0)"},
                                   {0, "  point (1 0)"},
                                   {1, "  point (0 1)"},
                                   {0, "  end"}})
    enter(host, line);
  EXPECT_EQ(opener(0), "edit a");
  enter(1, "  replace x");
  EXPECT_EQ(opener(1), "edit b\n  replace x 0");
  enter(0, "  call b");
  enter(1, "  point (2 0)");
  enter(0, "start a");
  EXPECT_EQ(opener(0), "");
  enter(1, "  point (3 0)");
  EXPECT_EQ(opener(1), "edit b\n  replace x 2");
  const Loaded at_once = read(
      "make b\n  tag x\n  point (2 0)\n  point (3 0)\nmake a\n  begin e\n  point (1 0)\n  end\n"
      "  call b\nstart a\n");
  EXPECT_TRUE(at_once.document == document) << write(document);
  const Loaded again = read(history);
  EXPECT_EQ(told(again.diagnostics), "");
  EXPECT_TRUE(again.document == document) << history;
}

// An edit changes only the objects concerned; all others are shared with the old document.
TEST(DisplayList, What_stays_is_not_touched) {
  const Loaded before = read(stars);
  const Loaded after = read(std::string(stars) + "edit sky\n  vector (0 0) (2 2)\n");
  const Scene &a = before.document.scene(), &b = after.document.scene();
  EXPECT_EQ(b.objects.size(), a.objects.size() + 1);
  EXPECT_EQ(b.names.find("sky/vector-1"), a.names.find("sky/vector-1"));
}

// shows: C77 C79
TEST(DisplayList, A_begin_of_a_live_host_means_the_environment_of_that_time) {
  // The environment is killed at tick 10 and made again at 20. `begin` means the first one, `begin … since` the second.
  const LoadedFilm s(R"(at 0t animate e every 1t by translate(1 0 0)
at 10t kill e
at 20t animate e every 1t by translate(0 1 0)
make a
  begin e
    point (0 0)
  end
  begin e since 15t
    point (0 0)
  end
  begin nobody
    translate(5 5 5)
    point (0 0)
  end
  point (0 0)
start a
)");
  expect_numbers(s, "a/e-1/point-1.world", "30t", {1, 0, 0, 11, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  expect_numbers(s, "a/e-2/point-1.world", "30t", {1, 0, 0, 0, 0, 1, 0, 11, 0, 0, 1, 0, 0, 0, 0, 1});
  expect_numbers(s, "a/e-2/point-1.world", "15t", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  expect_numbers(s, "a/point-1.world", "30t", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  EXPECT_TRUE(read(write(s.loaded.document)).document == s.loaded.document);
  LoadOptions live;
  live.now = Rate{30, 1}.span(15);
  EXPECT_NE(write(load_text("make a\n  begin e\n  end\n", "live", live).document).find("begin e since 15t"),
            std::string::npos);
}

TEST(DisplayList, Too_much_is_refused_in_words) {
  std::string text = "make l0\n  point (0 0)\n";
  for (int i = 1; i < 60; ++i) text += fmt::format("make l{}\n  call l{}\n  call l{}\n", i, i - 1, i - 1);
  EXPECT_EQ(all_told(read(text + "start l59\n")), std::vector<std::string>{"range 180:7 l59"});
  EXPECT_TRUE(all_told(read(text + "start l9\n")).empty());
  // The picture does not change.
  const auto grown = read(text + "make all\n  call l9\nstart all\nedit all\n  call l58\n");
  EXPECT_EQ(all_told(grown), std::vector<std::string>{"range 183:6 all"});
  EXPECT_TRUE(mentions(grown, "'all' would make more than 100000 objects"));
  EXPECT_TRUE(grown.document == read(text + "make all\n  call l9\nstart all\n").document);
  std::string deep = "make l0\n  point (0 0)\n";
  for (int i = 1; i < 3000; ++i) deep += fmt::format("make l{}\n  call l{}\n", i, i - 1);
  EXPECT_EQ(all_told(read(deep + "start l2999\n")), std::vector<std::string>{"range 6001:7 l2999"});
  EXPECT_TRUE(mentions(deep + "start l2999\n",
                       "'l2999' would have instances and environments nested more than 200 levels deep"));
}

}  // namespace
}  // namespace betwixt
