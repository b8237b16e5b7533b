// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests edits of display lists at a time. Before this time a film shows the old list, and from this time on the new
// one.
#include <algorithm>
#include <random>

#include "scene/document.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// All that is drawn, whatever objects it has become: kind, color, text and corners, in an order of its own.
using Seen = std::vector<std::string>;
Seen seen(const Program& program, Time t) {
  Seen out;
  const Scene& s = program.document().scene();
  for (const ObjectId id : *s.expansion) {
    const Object& o = s.objects[id.index];
    if (!drawable(o.kind) || !std::get<bool>(program.read({id, fn::display}, t))) continue;
    std::string one(name_of(o.kind));
    for (const double v : numbers(program.read({id, fn::color}, t))) one += fmt::format(" {:.3f}", v);
    const Mat4 world = *std::get<Matrix>(program.read({id, Query::world}, t));
    const Slot* points = o.find(fn::points);
    for (const Vec3& p : points ? **std::get_if<Points>(&*points->set) : std::vector<Vec3>{{}}) {
      const Vec3 at = transform_point(world, p);
      for (int k = 0; k < 3; ++k)
        one += fmt::format(" {:.6f}", at[k] + 0.0 == 0 ? 0.0 : std::round(at[k] * 1e6) / 1e6 + 0.0);
    }
    out.push_back(std::move(one));
  }
  std::sort(out.begin(), out.end());
  return out;
}
Seen seen(const std::string& text, Time t) {
  const Loaded loaded = read(text);
  EXPECT_FALSE(has_errors(loaded.diagnostics)) << text << said(loaded.diagnostics);
  return seen(Program::compile(loaded.document), t);
}

// Lists that are written down as rows, edited by hand in the test, and told to the language as edits.
struct Author {
  std::mt19937 random;
  static constexpr int lists = 4;
  std::array<std::size_t, lists> made{};  // rows that there were when tags were written
  // A list calls only those before it; the last one is shown. Tags stand on rows 0, 2 and 4.
  using Film = std::vector<std::optional<std::vector<std::string>>>;

  explicit Author(unsigned seed) : random(seed) {}
  int pick(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); }
  std::string row(int self) {
    const auto number = [&] { return pick(-30, 30) / 10.0; };
    switch (pick(0, self > 0 ? 7 : 5)) {
      case 0:
        return fmt::format("point ({} {} {})", number(), number(), number());
      case 1:
        return fmt::format("vector (0 0) ({} {})", number(), number());
      case 2:
        return "polygon (0 0) (1 0) (0 1)";
      case 3:
        return fmt::format("translate({} {} 0)", number(), number());
      case 4:
        return fmt::format("rotate({}deg, z)", pick(-90, 90));
      case 5:
        return pick(0, 1) ? "color red" : "color blue";
      default:
        return fmt::format("call list{}", pick(0, self - 1));
    }
  }
  std::vector<std::string> rows(int self, int least) {
    std::vector<std::string> all;
    for (int n = pick(least, 7); n > 0; --n) all.push_back(row(self));
    return all;
  }
  static std::string written(const std::vector<std::string>& rows) {
    std::string out;
    for (std::size_t i = 0; i < rows.size(); ++i)
      out += (i % 2 == 0 && i < 6 ? fmt::format("  tag t{}\n", i) : "") + "  " + rows[i] + "\n";
    return out;
  }
  static std::string written(const Film& film) {
    std::string out = environments;
    for (std::size_t i = 0; i < film.size(); ++i)
      if (film[i]) out += fmt::format("make list{}\n", i) + written(*film[i]);
    return out +
           "make top\n  begin e\n  call list3\n  end\n  translate(9 0 0)\n  call list3\n  call list1\nstart top\n";
  }
  static constexpr const char* environments = "animate e every 1t by rotate(5deg, z)\n";

  // One edit of the film: what is said, and what becomes of it.
  std::string edit(Film& film, const std::string& at) {
    const int i = pick(0, lists - 1);
    auto& list = film[static_cast<std::size_t>(i)];
    const std::string name = fmt::format("list{}", i);
    if (!list || pick(0, 9) == 0) {
      list = rows(i, 1);
      made[static_cast<std::size_t>(i)] = list->size();
      return at + "make " + name + "\n" + written(*list);
    }
    if (i != lists - 1 && pick(0, 9) == 0) {
      list.reset();
      return at + "delete " + name + "\n";
    }
    std::string out = at + "edit " + name + "\n";
    if (pick(0, 1)) {  // at the end
      const std::string added = row(i);
      list->push_back(added);
      return out + "  " + added + "\n";
    }
    const int tags = std::min<int>(3, (static_cast<int>(made[static_cast<std::size_t>(i)]) + 1) / 2);
    const auto tag = static_cast<std::size_t>(2 * pick(0, tags - 1));
    out += fmt::format("  replace t{}\n", tag);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string put = row(i);
      if (tag + k < list->size())
        (*list)[tag + k] = put;
      else
        list->push_back(put);
      out += "  " + put + "\n";
    }
    return out;
  }
};

// shows: R-E12 R-E16 C69 C71
TEST(LaterLists, Four_hundred_films_show_the_old_list_before_and_the_new_one_after) {
  std::size_t things = 0, shared = 0, alone = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    Author author(seed);
    Author::Film film(Author::lists);
    for (std::size_t i = 0; i < film.size(); ++i) {
      film[i] = author.rows(static_cast<int>(i), 2);
      author.made[i] = film[i]->size();
    }
    std::string text = Author::written(film);
    std::vector<std::pair<Time, Author::Film>> is{{Time{INT64_MIN}, film}};
    int frame = 1;
    for (int n = author.pick(1, 5); n > 0; --n) {
      frame += author.pick(1, 20);
      for (int k = author.pick(1, 2); k > 0; --k) text += author.edit(film, fmt::format("at {}f ", frame));
      is.emplace_back(Rate{}.frame(frame), film);
    }
    const Loaded loaded = read(text);
    ASSERT_FALSE(has_errors(loaded.diagnostics)) << text << said(loaded.diagnostics);
    const Program program = Program::compile(loaded.document);
    shared += loaded.document.scene().expansion->size();
    std::vector<std::pair<Time, std::size_t>> asked;
    for (std::size_t i = 0; i < is.size(); ++i) {
      const Time from = i == 0 ? Time{} : is[i].first;
      asked.push_back({from, i});
      asked.push_back({(i + 1 < is.size() ? is[i + 1].first : from + Rate{}.span(50)) - Time{1}, i});
    }
    std::shuffle(asked.begin(), asked.end(), author.random);
    std::vector<Program> alone_is;  // each version, as the only one of its film
    for (const auto& [from, version] : is)
      alone_is.push_back(Program::compile(read(Author::written(version)).document));
    for (const auto& [t, i] : asked) {
      const Seen wanted = seen(alone_is[i], t);
      EXPECT_EQ(seen(program, t), wanted) << "seed " << seed << ", version " << i << "\n" << text;
      things += wanted.size(), alone += wanted.size();
    }
    const std::string again = write(loaded.document);
    EXPECT_TRUE(read(again).document == loaded.document) << text << again;
    EXPECT_EQ(write(read(again).document), again);
    EXPECT_TRUE(read(tidy(text)).document == loaded.document) << tidy(text);
    if (HasFailure()) break;
  }
  EXPECT_GT(things, 10'000u);
  EXPECT_LT(shared, alone);
}

constexpr std::string_view star = R"(rate 24
make star
  tag look
  color red
  polygon (0 0) (1 0) (0 1)
  vector (0 0) (2 2)
make sky
  view from (0 0 9) to (0 0 0)
  call star
start sky
)";

std::vector<std::string> names(const Loaded& l) { return l.document.names(); }

TEST(LaterLists, What_is_the_same_before_and_after_is_one_object) {
  const std::string text = std::string(star) + "at 25f edit star\n  point (5 0 0)\n";
  const LoadedFilm s(text);
  EXPECT_EQ(names(s.loaded), (std::vector<std::string>{"sky", "sky/star-1", "sky/star-1/polygon-1",
                                                       "sky/star-1/vector-1", "sky/camera", "sky/star-1/point-1"}));
  const auto shown = [&](const LoadedFilm& of, const char* name, const char* t) {
    return std::get<bool>(of.read(std::string(name) + ".display", t));
  };
  EXPECT_FALSE(shown(s, "sky/star-1/point-1", "24.999f"));
  EXPECT_TRUE(shown(s, "sky/star-1/point-1", "25f"));
  EXPECT_EQ(s.loaded.document.range().second, Rate{}.frame(25));
  // There and back: two polygons, the first of which comes again. A name that another has tells its time.
  const LoadedFilm twice(
      std::string(star) +
      "at 25f edit star\n  replace look\n  color blue\nat 2.0004s edit star\n  replace look\n  color red\n");
  EXPECT_EQ(names(twice.loaded),
            (std::vector<std::string>{"sky", "sky/star-1", "sky/star-1/polygon-1", "sky/star-1/vector-1", "sky/camera",
                                      "sky/star-1/polygon-1-at-1000ms", "sky/star-1/vector-1-at-1000ms"}));
  for (const auto& [t, first] : {std::pair("24f", true), std::pair("25f", false), std::pair("3s", true)}) {
    EXPECT_EQ(shown(twice, "sky/star-1/polygon-1", t), first) << t;
    EXPECT_EQ(shown(twice, "sky/star-1/polygon-1-at-1000ms", t), !first) << t;
  }
  // Two edits within a millisecond.
  const LoadedFilm near(
      std::string(star) +
      "at 1s edit star\n  replace look\n  color blue\nat 1.0001s edit star\n  replace look\n  color green\n");
  EXPECT_TRUE(near.loaded.document.find("sky/star-1/vector-1-at-1000ms-2"));
}

TEST(LaterLists, An_edit_without_a_time_is_for_the_whole_film_and_one_at_a_time_until_the_next) {
  const std::string text = std::string(star) + "at 25f edit star\n  point (5 0 0)\n" + "edit star\n  point (7 0 0)\n" +
                           "at 13f edit star\n  point (6 0 0)\n";
  const std::string old(star);
  EXPECT_EQ(seen(text, Rate{}.frame(1)), seen(old + "edit star\n  point (7 0 0)\n", {}));
  EXPECT_EQ(seen(text, Rate{}.frame(13)), seen(old + "edit star\n  point (6 0 0)\n  point (7 0 0)\n", {}));
  EXPECT_EQ(seen(text, Rate{}.frame(25)), seen(old + "edit star\n  point (5 0 0)\n  point (7 0 0)\n", {}));
  // Where a version has no such tag it is passed over.
  const std::string other = old + "at 25f make star\n  point (5 0 0)\nedit star\n  replace look\n  color blue\n";
  EXPECT_EQ(seen(other, {}), seen(old + "edit star\n  replace look\n  color blue\n", {}));
  EXPECT_EQ(seen(other, Rate{}.frame(25)), (Seen{"points 1.000 1.000 1.000 5.000000 0.000000 0.000000"}));
  // Deleted at all times, or from one on.
  EXPECT_EQ(seen(other + "delete star\n", Rate{}.frame(25)), Seen{});
  EXPECT_EQ(seen(text + "at 30f delete star\n", Rate{}.frame(29)), seen(text, Rate{}.frame(29)));
  EXPECT_EQ(seen(text + "at 30f delete star\n", Rate{}.frame(30)), Seen{});
  EXPECT_EQ(seen(text + "at 30f delete star\nat 31f make star\n  point (1 0 0)\n", Rate{}.frame(31)),
            (Seen{"points 1.000 1.000 1.000 1.000000 0.000000 0.000000"}));
}

TEST(LaterLists, The_camera_of_the_main_list_changes_with_it) {
  const LoadedFilm s(std::string(star) +
                     "create other camera position=(0 0 100)\nat 25f make sky\n  orthographic 4\n"
                     "  view from (0 3 0) to (0 0 0)\nat 49f make sky\n  point (0 0)\nat 73f look through other\n");
  EXPECT_EQ(translation_of(s.frame("24f").camera.world), (Vec3{0, 0, 9}));
  EXPECT_EQ(translation_of(s.frame("25f").camera.world), (Vec3{0, 3, 0}));
  EXPECT_TRUE(s.frame("25f").camera.orthographic);
  EXPECT_EQ(translation_of(s.frame("49f").camera.world), (Vec3{0, 0, 100}));  // the only other one
  EXPECT_EQ(translation_of(s.frame("10f").camera.world), (Vec3{0, 0, 9}));
}

// shows: R-E9
TEST(LaterLists, A_begin_means_the_environment_of_the_time_of_its_edit) {
  const LoadedFilm s(R"(at 0t animate e every 1t by translate(1 0 0)
at 10t kill e
at 20t animate e every 1t by translate(0 1 0)
make a
  point (9 9)
start a
at 15t edit a
  begin e
    point (0 0)
  end
)");
  EXPECT_NE(write(s.loaded.document).find("begin e since 15t"), std::string::npos);
  expect_numbers(s, "a/e-1/point-1.world", "30t", {1, 0, 0, 0, 0, 1, 0, 11, 0, 0, 1, 0, 0, 0, 0, 1});
}

TEST(LaterLists, Lists_may_call_one_another_the_other_way_round_later) {
  const std::string text =
      "make a\n  point (1 0 0)\nmake b\n  call a\nstart b\nat 3f make b\n  point (2 0 0)\nat 3f edit a\n  call b\n";
  EXPECT_TRUE(all_told(read(text)).empty()) << said(read(text).diagnostics);
  EXPECT_TRUE(read(write(read(text).document)).document == read(text).document) << write(read(text).document);
  EXPECT_EQ(all_told(read(text + "at 5f edit b\n  call a\n")), std::vector<std::string>{"name 11:8 a"});
  EXPECT_EQ(all_told(read(text + "edit b\n  call a\n")), std::vector<std::string>{"name 11:8 a"});
  for (const char* again : {"at 5f edit b\n  call a\n", "edit b\n  call a\n"})
    EXPECT_TRUE(mentions(text + again, "b → a → b")) << again;
  EXPECT_EQ(all_told(read(text + "at 2f edit b\n  call a\n")), std::vector<std::string>{});
}

TEST(LaterLists, Errors_say_what_and_where) {
  const std::pair<std::string, std::string> table[] = {
      {"at 3f start a\n", "syntax 1:7 start"},
      {"at 3f edit a\n", "name 1:12 a"},
      {"at 3f make a\nat 2f edit a\n", "name 2:12 a"},
      {"at 3f make a\nat 4f delete a\nat 5f edit a\n  point (0 0)\n", "name 3:12 a"},
      {"at 3f make a\nmake a\n", "name 2:6 a"},
      {"at 3f make a\ncreate a sphere\n", "name 2:8 a"},
      {"make a\n  point (0 0)\nat 3f edit a\n  end\n", "syntax 4:3 end"},
      {"make a\n  point (0 0)\nat 3f edit a\n  push\n", "syntax 4:3 push"},
      {"make a\n  point (0 0)\nat 3f edit a\n  replace x\n", "name 4:11 x"},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(all_told(read(text)), std::vector<std::string>{message}) << text;
  EXPECT_EQ(remarks_told(std::string(star) + "at 3f delete star\n"),
            std::vector<std::string>{"warning syntax 11:14 star"});
  EXPECT_TRUE(mentions(std::string(star) + "at 3f delete star\n", "'sky'"));
  EXPECT_EQ(said(read(std::string(star) + "at 3f delete sky\n").diagnostics),
            "test.bx:11:14: warning: 'sky' is the main object, so from then on no display list is visible\n  at 3f "
            "delete sky\n               ^~~\n");
}

TEST(LaterLists, Too_many_versions_are_refused_in_words) {
  std::string text = "make a\n";
  for (int i = 0; i < 60'000; ++i) text += "  point (0 0)\n";
  text += "start a\n";
  for (int i = 0; i < 9; ++i) text += fmt::format("at {}f edit a\n  point ({} 0)\n", i + 2, i);
  const Loaded l = read(text);
  EXPECT_EQ(told(l), "range 60009:12 a");
  EXPECT_TRUE(
      mentions(l, "'a' changes too often for its size: all its versions together would make more than 300000 objects"));
}

}  // namespace
}  // namespace betwixt
