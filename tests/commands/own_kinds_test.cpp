// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the author's own kinds. An instance that was made early must be what a copy made at the end is, except in what
// was changed on it.
#include <algorithm>
#include <map>
#include <random>

#include "betwixt/kind.h"
#include "betwixt/object.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// Returns everything that can be read of an object and of all below it, at some times; in order of names, because the
// objects of two films may have been made in another order.
std::vector<std::string> everything(const std::string& text, const std::string& whole) {
  const LoadedFilm film(text);
  const Document& d = film.loaded.document;
  std::vector<std::string> out;
  std::vector<std::string> names = d.names();
  std::erase_if(names, [&](const std::string& name) { return name != whole && !name.starts_with(whole + "/"); });
  std::ranges::sort(names);
  for (const std::string& name : names) {
    const ObjectId id = d.find(name);
    out.push_back(d.name(id) + " " + std::string(name_of(kind(d, id))));
    for (const char* time : {"1f", "5f", "12.5f", "24f", "31f"}) {
      const Time t = *parse_time(time, d);
      for (const FunctionView& f : functions(d, id)) {
        const Value v = film.program.read(Target(id, f.id), t);
        std::string said = fmt::format("{} {} {}:", d.name(id), time, f.name);
        for (const double n : numbers(v)) said += fmt::format(" {}", n);
        if (const auto* a = std::get_if<Attachment>(&v)) said += d.name(a->parent);
        if (const auto* o = std::get_if<ObjectId>(&v)) said += d.name(*o);
        if (const auto* word = std::get_if<Text>(&v)) said += **word;
        if (const auto* names = std::get_if<Names>(&v))
          for (const std::string& one : **names) said += one;
        out.push_back(said);
      }
      for (const double n : film.numbers(d.name(id) + ".world", time)) out.push_back(fmt::format("{}", n));
    }
  }
  return out;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at) + 1;
    if (text[at] == ' ') out.back() += text.substr(at, end - at);  // a row belongs to its sheet
    if (text[at] != ' ') out.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return out;
}

constexpr std::string_view model =
    "create man group position=(1 0 0)\ncreate man/arm box size=(1 2 3)\ncreate man/arm/hand sphere radius=0.2\n"
    "create man/eye camera look-at=man/arm/hand\nlayer man/sway mix weight=0.5\n"
    "animate man/spin every 1t by rotate(6deg, z)\nman/eye.look-at\n  1f man/arm\n  9f man/arm/hand\n"
    "man/arm.motion\n  1f..9f R(90deg @ man) T(1 0)\n  9f..20f R(1turn @ man/arm/hand) S(2 @ man/arm)\n"
    "set man/arm.environments (man/spin)\n"
    "set man/arm.color = \"rgb(value('man/arm/hand.position.x'), 0.5, value('man.position.y'))\"\n"
    "on man/sway man/arm.position\n  1f (0 0 0)\n  24f (0 1 0)\n"
    "create man/road curve points=((0 0) (1 2) (3 0))\ncreate man/sign text text=\"a\"\n"
    "man/sign.position\n  1f..9f along man/road turned\nfilter man/arm.position wobble frequency=2\n"
    "man/arm.position.x.velocity\n  30f 1\n  40f release\nman/arm/hand.position.x\n  1f 0\n  24f 2 smooth\n"
    "rename man/arm/hand man/arm/fist\nset man/sign.text \"b\"\nremove man/sign\nset man.position.y 3\n";

// shows: S5
TEST(OwnKinds, AnInstanceFollowsWhateverTheModelSaysLater) {
  const std::vector<std::string> lines = lines_of(model);
  std::string all;
  for (const std::string& line : lines) all += line;
  const auto wanted = everything(all + "create twin like man\n", "twin");
  ASSERT_GT(wanted.size(), 500u);
  for (std::size_t made = 1; made <= lines.size(); ++made) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      text += lines[i];
      if (i + 1 == made) text += "define kind human like man\ncreate twin human\n";
    }
    EXPECT_EQ(everything(text, "twin"), wanted) << "made after " << lines[made - 1];
    EXPECT_EQ(everything(text + "unlink kind human\nset man/arm.size (9 9 9)\n", "twin"), wanted);
  }
}

// Random values of the model and of two instances, beside a table of what each should be.
TEST(OwnKinds, WhatIsChangedOnAnInstanceStays) {
  std::mt19937_64 random(7);
  const auto below = [&](unsigned n) { return random() % n; };
  const std::vector<std::string> parts{"", "/arm", "/arm/hand"}, functions{"position.x", "shininess", "scale"};
  for (int film = 0; film < 60; ++film) {
    std::string text =
        "create man sphere\ncreate man/arm sphere\ncreate man/arm/hand sphere\ndefine kind human like man\n"
        "create anna human\ncreate bert human\n";
    std::map<std::string, double> model_says, own;
    double next = 1;
    for (int line = 0; line < 12; ++line) {
      const std::string who = std::vector<std::string>{"man", "man", "anna", "bert"}[below(4)];
      const std::string what = parts[below(3)] + "." + functions[below(3)];
      next += 0.125;
      const double value = what.ends_with("shininess") ? next / 16 : next;
      text += fmt::format("set {}{} {}\n", who, what,
                          what.ends_with("scale") ? fmt::format("({0} {0} {0})", value) : fmt::format("{}", value));
      (who == "man" ? model_says : own)[(who == "man" ? "" : who) + what] = value;
    }
    const LoadedFilm made(text);
    for (const char* who : {"anna", "bert"})
      for (const std::string& part : parts)
        for (const std::string& f : functions) {
          const std::string what = part + "." + f;
          const auto mine = own.find(who + what), shared = model_says.find(what);
          const double rest = f == "scale"       ? 1
                              : f == "shininess" ? LoadedFilm("create a sphere\n").numbers("a.shininess", "1f")[0]
                                                 : 0;
          const double wanted = mine != own.end() ? mine->second : shared != model_says.end() ? shared->second : rest;
          EXPECT_NEAR(made.numbers(who + what, "1f")[0], wanted, 1e-12) << who << what << "\n" << text;
        }
  }
}

constexpr std::string_view people =
    "create man group\ncreate man/body box color=teal\ncreate man/head sphere color=gold\n"
    "define kind human like man\ncreate anna human position=(1 0 0)\ncreate {bert,carl} human\n";

TEST(OwnKinds, EachAspectOfAFunctionFollowsByItself) {
  // The value set is anna's own, the track is the model's.
  const LoadedFilm film(std::string(people) +
                        "set anna/body.position (5 0 0)\nset man/body.position (7 0 0)\n"
                        "filter man/body.position wobble frequency=0\n"
                        "man/head.position\n  12f (1 0 0)\n  24f (2 0 0)\n");
  expect_numbers(film, "anna/body.position", "1f", {5, 0, 0}, 1);
  expect_numbers(film, "anna/head.position", "24f", {2, 0, 0});
  expect_numbers(film, "bert/body.position", "1f", {7, 0, 0}, 1);
}

TEST(OwnKinds, WhatWasOwnStaysOwnIfTheModelHasTheSameForAWhile) {
  const LoadedFilm film(std::string(people) +
                        "set anna/body.color red\nset man/body.color red\nset man/body.color blue\n");
  expect_numbers(film, "anna/body.color", "1f", {1, 0, 0}, 1e-6);
  expect_numbers(film, "bert/body.color", "1f", {0, 0, 1}, 1e-6);
  // What `create` says is its own from the beginning, even if it is what the model says.
  expect_numbers(LoadedFilm(std::string(people) + "create dora human position=(0 0 0)\nset man.position (9 9 9)\n"),
                 "dora.position", "1f", {0, 0, 0});
}

TEST(OwnKinds, PartsComeGoAndAreRenamed) {
  const Loaded film = read(std::string(people) +
                           "create anna/hat cone color=red\ncreate man/hat cone color=black\nremove bert/head\n"
                           "rename man/body man/trunk\nset man/trunk.color navy\nremove man/head\n");
  EXPECT_FALSE(has_errors(film.diagnostics)) << said(film.diagnostics);
  std::vector<std::string> names = film.document.names();
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"anna", "anna/hat", "anna/trunk", "bert", "bert/hat", "bert/trunk", "carl",
                                             "carl/hat", "carl/trunk", "man", "man/hat", "man/trunk"}));
  // The name was taken: the author's own hat stays, and it is said.
  EXPECT_EQ(all_told(film).size(), 0u);
  EXPECT_TRUE(std::ranges::any_of(film.diagnostics, [](const Diagnostic& d) {
    return d.severity == Severity::warning && d.what.message.find("anna/hat") != std::string::npos;
  })) << said(film.diagnostics);
}

TEST(OwnKinds, KindsCanConsistOfKinds) {
  const std::string text =
      "create hand sphere radius=0.1\ndefine kind paw like hand\ncreate man box\ncreate man/left paw\n"
      "create man/right paw\ndefine kind human like man\ncreate anna human\ncreate boss like anna\n"
      "define kind chief like boss\ncreate dora chief\ncreate eve human\nset eve/left.radius 7\n"
      "set hand.radius 0.5\nset boss/left.color red\nset man.size (2 2 2)\n";
  const LoadedFilm film(text);
  for (const char* name : {"man/left", "man/right", "anna/left", "anna/right", "eve/right"})
    expect_numbers(film, std::string(name) + ".radius", "1f", {0.5});
  expect_numbers(film, "eve/left.radius", "1f", {7});
  expect_numbers(film, "dora/left.color", "1f", {1, 0, 0}, 1e-6);
  expect_numbers(film, "dora/left.radius", "1f", {0.1});  // its model is a copy, and copies follow nothing
  expect_numbers(film, "eve.size", "1f", {2, 2, 2});
}

// What was changed on an instance is gone, and the instance is as one that was never changed.
TEST(OwnKinds, GoBackToTheModel) {
  const std::string changes =
      "set anna/body.color red\nset man/body.color navy\nanna/head.position\n  1f (0 0 1)\n  9f (2 0 1)\n"
      "filter anna/head.position wobble\nat 1f anna.shininess.velocity 1\nat 3f hide anna/head\n";
  const std::string later =
      "set man/body.color teal\nset man/head.radius 3\nfilter man/head.position smooth width=1s\n";
  const auto plain = everything(std::string(people) + "set man/body.color navy\n" + later, "anna");
  const auto with = [&](const std::string& lines) {
    return everything(std::string(people) + changes + lines + later, "anna");
  };
  EXPECT_NE(with(""), plain);
  EXPECT_EQ(with("revert anna\n"), plain);
  EXPECT_EQ(with("revert {anna,bert,carl}\n"), plain);
  EXPECT_EQ(with("revert anna/head anna/body.color anna.shininess\n"), plain);
  EXPECT_EQ(with("revert nobody* anna\n"), plain);
  const LoadedFilm film(std::string(people) + "set anna.position (7 7 7)\nrevert anna\n");
  expect_numbers(film, "anna.position", "1f", {7, 7, 7});
  const LoadedFilm moved(std::string(people) +
                         "set man.position (1 2 3)\nset anna.position (7 7 7)\nrevert anna.position\n");
  expect_numbers(moved, "anna.position", "1f", {1, 2, 3});
}

TEST(OwnKinds, AreWrittenAndFollowAgain) {
  const std::string text = std::string(people) +
                           "set anna/body.color red\nremove carl/head\nrename bert bruno\n"
                           "set man/head.color = \"value('man/body.color')\"\n";
  const Loaded first = read(text), second = read(write(first.document));
  EXPECT_FALSE(has_errors(second.diagnostics)) << said(second.diagnostics);
  EXPECT_EQ(first.document, second.document) << write(first.document);
  EXPECT_EQ(write(first.document), write(second.document));
  const std::string later = "set man/body.color navy\ncreate man/foot box\n";
  for (const char* who : {"anna", "bruno", "carl"})
    EXPECT_EQ(everything(text + later, who), everything(write(first.document) + later, who));
}

TEST(OwnKinds, TheModelCanBeHidden) {
  const LoadedFilm film(
      "create man box\ncreate man/lamp light\ncreate man/eye camera position=(0 0 30)\n"
      "define kind human like man hidden\ncreate anna human\nshow man\n"
      "create man/hat cone position=(0 2 0)\ncreate twin like man position=(3 0 0)\n");
  std::vector<std::string> seen;
  const Frame frame = film.frame("1f");
  for (const Item& item : frame.items) seen.push_back(film.loaded.document.name(item.id));
  std::ranges::sort(seen);
  EXPECT_EQ(seen, (std::vector<std::string>{"anna", "anna/hat", "twin", "twin/hat"}));
  EXPECT_EQ(film.frame("1f").lights.size(), 2u);
  const LoadedFilm shown("create man box\ndefine kind human like man hidden\nunlink kind human\n");
  EXPECT_EQ(shown.frame("1f").items.size(), 1u);
}

TEST(OwnKinds, AreListedWithWhatIsOwn) {
  const Loaded film = read(std::string(people) +
                           "set anna/body.color red\nset man/body.color blue\nremove bert\n"
                           "carl/head.position\n  1f (0 0 1)\n");
  const auto kinds = own_kinds(film.document);
  ASSERT_EQ(kinds.size(), 1u);
  EXPECT_EQ(kinds[0].name, "human");
  EXPECT_EQ(film.document.name(kinds[0].model), "man");
  std::vector<std::string> all;
  for (const InstanceView& one : kinds[0].instances) {
    all.push_back(film.document.name(one.root));
    for (const Target& t : one.own) all.push_back(film.document.name(t));
  }
  EXPECT_EQ(all, (std::vector<std::string>{"anna", "anna.position", "anna/body.color", "carl", "carl/head.position"}));
}

TEST(OwnKinds, WhatIsBelowALostPartGoesWithIt) {
  const Loaded film = read(std::string(people) + "create anna/head/hat cone\nremove bert/body\nremove man/head\n");
  EXPECT_FALSE(has_errors(film.diagnostics));
  EXPECT_FALSE(film.document.find("anna/head/hat"));
  EXPECT_TRUE(std::ranges::any_of(film.diagnostics, [](const Diagnostic& d) {
    return d.severity == Severity::warning && d.what.message.find("anna/head/hat") != std::string::npos;
  }));
  const auto kinds = own_kinds(film.document);
  EXPECT_TRUE(kinds[0].instances[0].missing.empty());
  EXPECT_EQ(kinds[0].instances[1].missing, std::vector<std::string>{"/body"});
}

TEST(OwnKinds, EndWithTheirModel) {
  const Loaded film = read(std::string(people) + "remove man\nset anna/body.color red\n");
  EXPECT_FALSE(has_errors(film.diagnostics));
  EXPECT_TRUE(own_kinds(film.document).empty());
  EXPECT_TRUE(film.document.find("anna/body"));
}

TEST(OwnKinds, ErrorsByTheirPlace) {
  const std::string head = std::string(people) + "define kind other like man/body\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"define kind human like man", "name 1:13 human"},
      {"define kind sphere like man", "name 1:13 sphere"},
      {"define kind a/b like man", "syntax 1:13 a/b"},
      {"define kind x like nobody", "name 1:20 nobody"},
      {"define kind x like man of anna", "syntax 1:27"},
      {"define kind x like man of (anna", "syntax"},
      {"define kind x like man of (nobody)", "name 1:28 nobody"},
      {"define kind x like man of (anna)", "name 1:24 of (anna)"},
      {"define kind x like man of (man/head)", "type 1:24 of (man/head)"},
      {"define kind x like man loud", "syntax 1:24 loud"},
      {"create x humen", "name 1:10 humen"},
      {"create anna human", "name 1:8 anna"},
      {"create man/child human", "name 1:8 man/child"},
      {"create man/body/x other", "name 1:8 man/body/x"},
      {"rename anna man/anna", "name 1:13 man/anna"},
      {"unlink man", "type 1:8 man"},
      {"unlink nobody", "name 1:8 nobody"},
      {"unlink kind humen", "name 1:13 humen"},
      {"unlink", "syntax 1:7"},
      {"revert man", "type 1:8 man"},
      {"revert man/body.color", "type 1:8 man/body.color"},
      {"revert nobody", "name 1:8 nobody"},
      {"revert anna.colour", "name 1:13 colour"},
      {"revert", "syntax 1:7"},
  };
  for (const auto& [line, wanted] : cases) {
    expect_refused(head, line, wanted);
  }
}

// Random lines about models, instances and their parts; many are errors. What is made can be written, and is the same
// when it is read again.
TEST(OwnKinds, RandomFilmsAreWrittenAndReadBack) {
  const std::vector<std::string> names{"m",   "m/a", "m/b", "m/a/c", "n",     "n/a", "x",
                                       "x/a", "y",   "y/q", "m/z",   "m/a/i", "n/k"};
  const std::vector<std::string> forms{"create # @",
                                       "create # @ position=(% 0 0)",
                                       "create # like #",
                                       "define kind @ like #",
                                       "set #.position (% 1 2)",
                                       "#.scale\n  1f (1 1 1)\n  %f (2 2 2)",
                                       "rename # #",
                                       "remove #",
                                       "unlink #",
                                       "unlink kind k1",
                                       "revert #",
                                       "revert #.position #",
                                       "couple # to #",
                                       "define kind @ like # hidden of (#)",
                                       "filter #.position wobble",
                                       "at 3f hide #",
                                       "set #.shininess 0.%"};
  for (unsigned seed = 0; seed < 250; ++seed) {
    std::mt19937_64 random(seed);
    const auto pick = [&](const std::vector<std::string>& all) { return all[random() % all.size()]; };
    const auto line = [&] {
      std::string out;
      for (const char c : pick(forms))
        out += c == '#'   ? pick(names)
               : c == '@' ? pick({"k1", "k2", "sphere", "box", "group"})
               : c == '%' ? std::to_string(2 + random() % 8)
                          : std::string(1, c);
      return out + "\n";
    };
    std::string text = "create m group\ncreate m/a box\ndefine kind k1 like m\n";
    for (std::size_t k = random() % 40; k > 0; --k) text += line();
    const Loaded first = read(text);
    const std::string written = write(first.document);
    const Loaded second = read(written);
    ASSERT_FALSE(has_errors(second.diagnostics)) << text << "\n" << written << said(second.diagnostics);
    ASSERT_EQ(first.document, second.document) << text << "\n" << written << "\n" << write(second.document);
  }
}

TEST(OwnKinds, AThousandFollowAtOnce) {
  std::string text =
      "create man group\ncreate man/part{1..20} box position=(i 0 0)\ndefine kind human like man\n"
      "create one{1..1000} human position=(0 i 0)\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("set man/part{}.size ({} 1 1)\n", i + 1, i + 2);
  const LoadedFilm film(text);
  expect_numbers(film, "one777/part20.size", "1f", {21, 1, 1});
  expect_numbers(film, "one777.position", "1f", {0, 777, 0});
}

}  // namespace
}  // namespace betwixt
