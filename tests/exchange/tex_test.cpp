// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests formulas: how the drawings of dvisvgm are read, and how the programs are called.
#include "exchange/tex.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/child.h"
#include "exchange/outlines.h"
#include "exchange/parser_process.h"
#include "support/fake_programs.h"
#include "support/told.h"

namespace betwixt {
namespace {

constexpr double em = 10 * 72 / 72.27;  // a point of TeX's is 1/72.27 in

Box box_of_letter(const Outline& o, std::size_t letter) {
  const std::size_t end = letter + 1 < o.letters.size() ? o.letters[letter + 1].first : o.contours.size();
  Box all;
  for (std::size_t i = o.letters[letter].first; i < end; ++i)
    for (const Vec3 p : o.contours[i]) all.add(p);
  return all;
}
void expect_box(const Box& b, Vec3 low, Vec3 high, double within) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(b.low[i], low[i], within) << i;
    EXPECT_NEAR(b.high[i], high[i], within) << i;
  }
}
double filled_area(const Outline& o) {
  const Mesh mesh = fill(o);
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      const auto& p = mesh.positions[mesh.triangles[i + k]];
      return Vec3{p[0], p[1], p[2]};
    };
    area += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  return area;
}
Outline read(const std::string& rest, const std::string& defs = "") {
  auto outline = read_tex_drawing(drawing_of(rest, defs));
  EXPECT_TRUE(outline) << rest << (outline ? "" : outline.error().message);
  return outline ? *outline : Outline{};
}
std::vector<Contour> path(const std::string& d) { return read("<path d='" + d + "'/>").contours; }
std::string refused(std::string_view svg) {
  const auto outline = read_tex_drawing(svg);
  return outline ? "" : outline.error().message;
}

// By the measures of cmsy10, cmex10 and the letters, in tenths of a point: the axis is at 2.5pt, bars are 0.4pt, the
// space beside a fraction is 1.2pt, `a` is 5.28589pt wide; numerators go up by 6.76508pt, denominators down by 6.85951.
TEST(Tex, AFractionIsWhereTeXPutsIt) {
  const auto o = read_tex_drawing(fraction_drawing);
  ASSERT_TRUE(o) << o.error().message;
  ASSERT_EQ(o->letters.size(), 3U);
  expect_box(box_of_letter(*o, 1), {0.12, 0.23, 0}, {0.12 + 0.528589, 0.27, 0}, 1e-4);
  EXPECT_NEAR(box_of_letter(*o, 0).low.y, 0.676508 - 0.011, 1e-4);
  EXPECT_NEAR(box_of_letter(*o, 0).high.y, 0.676508 + 0.442, 1e-4);
  EXPECT_NEAR(box_of_letter(*o, 2).low.y, -0.685951 - 0.011, 1e-4);
  EXPECT_NE(o->letters[0].text, o->letters[2].text);
}

TEST(Tex, PathsSayTheSameInManyWords) {
  const auto square = path("M72,72L82,72L82 62L72 62L72 72Z");
  ASSERT_EQ(square.size(), 1U);
  EXPECT_EQ(square[0].size(), 4U);
  for (const char* d : {"M72 72 82 72 82 62 72 62Z", "M72 72H82V62H72Z", "m72 72h10v-10h-10z", "m72,72 10,0 0-10-10,0z",
                        "M+7.2e1 72.H82V62H72V72", "M72 72H82V62H72"})
    EXPECT_EQ(path(d), square) << d;
  EXPECT_EQ(path("M72 72C72 62 82 62 82 72S92 82 92 72V92H72Z"),
            path("M72 72C72 62 82 62 82 72C82 82 92 82 92 72V92H72Z"));
  EXPECT_EQ(path("M72 72Q77 62 82 72T92 72V92H72Z"), path("m72 72q5-10 10 0q5 10 10 0v20h-20z"));
  EXPECT_EQ(path("M72 72Q77 62 82 72T92 72V92H72Z"), path("m72 72q5-10 10 0t10 0v20h-20z"));
  EXPECT_EQ(path("M72 72S82 62 82 72V92H72Z"), path("M72 72C72 72 82 62 82 72V92H72Z"));
  EXPECT_EQ(path("M72 72H82V62Zl0-5h-5z"), path("M72 72H82V62ZM72 72V67H67Z")) << "another begins where one began";
  EXPECT_TRUE(path("M72 72H82Z").empty());
}

// A circle of radius 5 made of four cubic curves is one to 2.7e-4 of its radius.
TEST(Tex, CurvesAreRound) {
  const auto c = path("M77 67C77 69.76142 74.76142 72 72 72S67 69.76142 67 67S69.23858 62 72 62S77 64.23858 77 67Z");
  ASSERT_EQ(c.size(), 1U);
  EXPECT_GT(c[0].size(), 20U);
  for (const Vec3 p : c[0]) EXPECT_NEAR(std::hypot(p.x, p.y - 5 / em), 5 / em, 5 / em * 3e-4);
}

TEST(Tex, TransformationsAndUsesPlaceThings) {
  const std::string defs = "<path id='g' d='M0 0H10V-10H0Z'/>";
  const Outline plain = read("<use x='72' y='72' xlink:href='#g'/>", defs);
  expect_box(box_of_letter(plain, 0), {0, 0, 0}, {10 / em, 10 / em, 0}, 1e-12);
  for (const char* same : {"<g transform='translate(72 72)'><use href='#g'/></g>",
                           "<g transform='matrix(1 0 0 1 70,70) translate(2 2)'><use x='0' y='0' xlink:href='#g'/></g>",
                           "<g transform='scale(2)'><g transform='matrix(.5 0 0 .5 0 0)'><use x=\"72\" y=\"72\" "
                           "xlink:href='#g' transform='translate(0)'/></g></g>",
                           "<rect x='72' y='62' width='10' height='10'/>"}) {
    const Outline o = read(same, defs);
    ASSERT_EQ(o.contours.size(), 1U) << same;
    expect_box(box_of_letter(o, 0), {0, 0, 0}, {10 / em, 10 / em, 0}, 1e-12);
  }
  const Outline mirrored = read("<g transform='matrix(-1 0 0 1 144 0)'><use x='72' y='72' xlink:href='#g'/></g>", defs);
  expect_box(box_of_letter(mirrored, 0), {-10 / em, 0, 0}, {0, 10 / em, 0}, 1e-12);
}

// What contours go round at all is filled; whose outer ones went clockwise are turned round.
TEST(Tex, FilledByTheNonZeroRule) {
  const double unit = em * em;
  EXPECT_NEAR(filled_area(read("<path d='M72 72h10v-10h-10zM74 70h6v-6h-6z'/>")), 100 / unit, 1e-5);
  for (const char* d : {"M72 72h10v-10h-10zM74 70v-6h6v6z", "M72 72v-10h10v10zM74 70h6v-6h-6z"}) {
    const Outline o = read(fmt::format("<path d='{}'/>", d));
    EXPECT_NEAR(filled_area(o), 64 / unit, 1e-5) << d;
    EXPECT_GT(cross(o.contours[0][1] - o.contours[0][0], o.contours[0][2] - o.contours[0][1]).z, 0) << d;
    EXPECT_LT(cross(o.contours[1][1] - o.contours[1][0], o.contours[1][2] - o.contours[1][1]).z, 0) << d;
  }
}

TEST(Tex, WhatIsNoFormulaIsSaid) {
  for (const char* d : {"72 72", "L72 72", "M72", "M72 72L", "M72 72A1 1 0 2 0 9 9", "M72 72Z5 5", "Mnan 1", "M1 -nan",
                        "M72 72Linf 1", "M1e300 0", "M1e7 0", "M72 72L1e999 0", "M72 72\xff", "M- 1", "M72 72L1 2 3"})
    EXPECT_EQ(refused(drawing_of(fmt::format("<path d='{}'/>", d))),
              "the output of dvisvgm cannot be read: a path that is not valid")
        << d;
  for (const auto& [rest, why] :
       {std::pair("<use xlink:href='#none'/>", "a glyph that is not valid"),
        {"<use x='1' y='1'/>", "a glyph that is not valid"},
        {"<rect x='1' y='1' width='-1' height='1'/>", "a bar that is not valid"},
        {"<rect x='1' y='1' width='1pt' height='1'/>", "a bar that is not valid"},
        {"<g transform='turn(5)'></g>", "a transformation that is not valid"},
        {"<g transform='matrix(1 0 0 1 0)'></g>", "a transformation that is not valid"},
        {"<g transform='scale(1e5) scale(1e5)'></g>", "a number that is too large"},
        {"<g transform='scale(1e5)'><rect x='99' y='9' width='9' height='9'/></g>", "a point that is too far away"},
        {"<path d='M999999 0l999999 0 0 9z'/>", "a point that is too far away"},
        {"<image href='x.png'/>", "<image>"},
        {"<text>a</text>", "<text>"},
        {"<g>", "broken SVG"},
        {"</svg>", "broken SVG"},
        {"<path d='M1 1", "broken SVG"},
        {"<path d=5/>", "broken SVG"},
        {"< >", "broken SVG"}})
    EXPECT_EQ(refused(drawing_of(rest)), std::string("the output of dvisvgm cannot be read: ") + why) << rest;
  for (const char* none : {"", "no SVG", "<svg/>", "<svg></svg>", "<!-- <svg/> "})
    EXPECT_EQ(refused(none), "the output of dvisvgm cannot be read: nothing") << none;
  EXPECT_EQ(refused("<svg><path d='M0 0H1V1Z'/></svg>"), "the output of dvisvgm cannot be read: no baseline");
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "<g>";
  EXPECT_EQ(refused(drawing_of(deep)), "the output of dvisvgm cannot be read: groups that are nested too deep");
  std::string many;
  for (int i = 0; i < 20'001; ++i) many += "<use x='1' y='1' xlink:href='#g'/>";
  EXPECT_EQ(refused(drawing_of(many, "<path id='g' d='M0 0H1V1Z'/>")),
            "the formula is too large: too many letters and points");
}

// Wherever it breaks off, and whichever letter of it is another, it is read or refused.
TEST(Tex, BrokenDrawingsAreNoHarm) {
  const std::string whole = fraction_drawing;
  for (std::size_t n = 0; n + 8 < whole.size(); ++n) EXPECT_NE(refused(whole.substr(0, n)), "") << n;
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (const char c : {'<', '\'', '9', 'z', ' ', '\0'}) {
      std::string other = whole;
      other[i] = c;
      const auto o = read_tex_drawing(other);
      for (const Contour& contour : o ? o->contours : std::vector<Contour>())
        for (const Vec3 p : contour) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
    }
}

// ---- the programs

TEST(Tex, TheProgramsWorkInAFolderOfTheirOwn) {
  const FakePrograms fake;
  fake.draw(fraction_drawing);
  fake.put(
      "latex",
      "sleep 0.3; { pwd; stat -c %a .; echo $openin_any$openout_any; [ $TEXMFOUTPUT = $PWD ] && echo own; echo $*; "
      "ulimit -t; ulimit -v; ulimit -f; ls; } >" +
          (fake / "said") + "; : >formula.dvi");
  fake.put("dvisvgm",
           "[ -f formula.dvi ] && echo $* >>" + (fake / "said") + "; cp " + (fake / "drawing.svg") + " formula.svg");
  const auto o = set_by_tex("\\frac{a}{b} % done");
  ASSERT_TRUE(o) << o.error().message;
  EXPECT_EQ((*o)->letters.size(), 3U);
  std::string said = fake.folder().get("said");
  EXPECT_TRUE(said.starts_with((fake / "tmp/betwixt-tex-"))) << said;
  EXPECT_EQ(said.substr(said.find('\n') + 1),
            "700\npp\nown\n-no-shell-escape -halt-on-error -interaction=nonstopmode formula.tex\n"
            "20\n2097152\n" +
                std::to_string(64 * 2048) +
                "\nformula.tex\n--no-fonts --exact-bbox --no-specials --cache=none -o formula.svg formula.dvi\n");
  EXPECT_TRUE(fake.tidied());
}

TEST(Tex, WhatTeXSaysIsPassedOn) {
  const FakePrograms fake;
  const auto refused_by_latex = [&](const std::string& log) {
    fake.put("latex", "cat >formula.log <<'END'\n" + log + "\nEND\nexit 1");
    const auto o = set_by_tex("\\fracc{a}{b}");
    EXPECT_TRUE(fake.tidied());
    return o ? Error{} : o.error();
  };
  const Error e =
      refused_by_latex("(/usr/share/article.cls)\n! Undefined control sequence.\nl.7 \\fracc\n          {a}{b}");
  EXPECT_EQ(e.message, "the formula has an error: Undefined control sequence: \\fracc");
  EXPECT_EQ(e.code, ErrorCode::syntax);
  EXPECT_EQ(refused_by_latex("! Emergency stop.").message, "the formula has an error: Emergency stop");
  const Error long_one = refused_by_latex("! " + std::string(9999, 'x'));
  EXPECT_EQ(told(long_one), "syntax");
  EXPECT_TRUE(long_one.message.ends_with(" " + std::string(200, 'x'))) << long_one.message;
  EXPECT_TRUE(refused_by_latex("! \x1b[31m\xff").message.ends_with(" ?[31m?"));
  EXPECT_EQ(refused_by_latex("nothing\nl.").message, "latex failed without an error message");
}

TEST(Tex, WhatFailsIsSaid) {
  const FakePrograms fake;
  const auto error = [&](const std::string& formula = "x", int most = 30'000) {
    const auto o = set_by_tex(formula, std::chrono::milliseconds(most));
    EXPECT_TRUE(fake.tidied());
    return o ? Error{} : o.error();
  };
  fake.draw(fraction_drawing);
  EXPECT_EQ(error(std::string(10'001, 'x')).message, "a formula can have at most 10000 characters");
  EXPECT_EQ(fake.latex_calls(), 0U);
  EXPECT_EQ(error(std::string(10'000, 'x')).message, "");
  fake.put("dvisvgm", "echo broken >formula.svg");
  EXPECT_EQ(told(error()), "machine");
  EXPECT_TRUE(error().message.ends_with(": nothing")) << error().message;
  fake.put("dvisvgm", "exit 1");
  EXPECT_EQ(error().message, "dvisvgm failed to draw the formula");
  fake.put("dvisvgm", ":");
  EXPECT_EQ(told(error()), "machine") << "it wrote nothing";
  EXPECT_NE(error().message.find("dvisvgm"), std::string::npos);
  fake.put("dvisvgm", "head -c 1048577 /dev/zero >formula.svg");
  EXPECT_EQ(error().message, "the formula is too large: more than 1 MiB of paths");
  const auto begun = std::chrono::steady_clock::now();
  fake.put("dvisvgm", "sleep 100 & sleep 100");
  EXPECT_EQ(error("x", 300).message, "dvisvgm takes too long for this formula");
  fake.put("latex", "kill -XCPU $$");
  const Error late = error();
  EXPECT_EQ(told(late), "machine") << "of the processor's time";
  EXPECT_NE(late.message.find("latex"), std::string::npos) << late.message;
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(60));
}

TEST(Tex, AMissingProgramIsNamed) {
  const FakePrograms fake;
  fake.put("latex", ": >formula.dvi");
  fake.put("env", "exec /usr/bin/env \"$@\"");
  fake.alone();
  auto o = set_by_tex("x");
  ASSERT_FALSE(o);
  EXPECT_EQ(o.error().message, "formulas need the programs latex and dvisvgm, but dvisvgm is not installed");
  EXPECT_EQ(o.error().hint, "sudo apt-get install texlive-latex-base dvisvgm");
  EXPECT_EQ(o.error().code, ErrorCode::machine);
  const FakePrograms none;
  none.alone();
  o = set_by_tex("x");
  ASSERT_FALSE(o);
  EXPECT_EQ(told(o), "machine");
  EXPECT_TRUE(mentions(o, "latex is not"));
}

// A latex of our own tells, in its log, what it can do in the jail. The shell ends where it cannot start a process.
TEST(Tex, TheProgramsAreInAJail) {
  const FakePrograms fake;
  ::unsetenv("BETWIXT_PARSER");
  ASSERT_NE(find_parser(), "");
  const std::string outside = fake.folder().put("secret", "x\n");
  fake.put("latex",
           "can=; tell() { echo \"! can:$can\" >formula.log; }\n"
           "for file in " +
               outside +
               " /etc/passwd formula.tex; do read -r x <$file && can=\"$can $file\"; done\n"
               "for file in " +
               outside +
               " ../new mine; do echo x >$file && can=\"$can >$file\"; done\n"
               "tell; x=$(exec echo x); can=\"$can start\"; tell; exit 1");
  const auto o = set_by_tex("x");
  ASSERT_FALSE(o);
  EXPECT_EQ(o.error().message, "the formula has an error: can: formula.tex >mine");
  EXPECT_EQ(fake.folder().get("secret"), "x\n");
  EXPECT_TRUE(fake.tidied());
}

// With its own guards off, TeX is still refused by the jail.
TEST(Tex, RealProgramsReachNothing) {
  const std::string latex = find_program("latex");
  if (latex.empty() || find_program("dvisvgm").empty()) GTEST_SKIP() << "no TeX";
  const FakePrograms fake;
  ::unsetenv("BETWIXT_PARSER");
  fake.put("latex", "export openin_any=a openout_any=a\nexec " + latex +
                        " -shell-escape -halt-on-error -interaction=nonstopmode formula.tex");
  const std::string secret = fake.folder().put("secret.tex", "y"), made = fake / "new.tex";
  for (const std::string& hostile : {"\\input{" + secret + "}", std::string("\\input{/etc/passwd}"),
                                     "x\\newwrite\\w\\immediate\\openout\\w=" + made + "\\immediate\\write\\w{x}"})
    EXPECT_FALSE(set_by_tex(hostile)) << hostile;
  EXPECT_EQ(told(set_by_tex("x\\immediate\\write18{touch " + made + "}")), "");
  EXPECT_FALSE(fake.folder().has("new.tex"));
  EXPECT_TRUE(fake.tidied());
}

TEST(Tex, FormulasAreTheSameInTheJail) {
  if (find_program("latex").empty() || find_program("dvisvgm").empty()) GTEST_SKIP() << "no TeX";
  for (const char* formula :
       {"\\frac{a}{b}", "\\sum_{n=1}^\\infty \\frac{1}{n^2} = \\frac{\\pi^2}{6}",
        "\\begin{pmatrix} 1 & 0 \\\\ 0 & 1 \\end{pmatrix} \\in \\mathbb{R}", "\\text{area} \\approx \\sqrt{x}"}) {
    const auto in_jail = set_by_tex(formula);
    const FakePrograms no_jail;  // it has no latex
    const auto free = set_by_tex(formula);
    ASSERT_TRUE(in_jail && free) << formula << (in_jail ? "" : in_jail.error().message);
    EXPECT_EQ((*in_jail)->contours, (*free)->contours) << formula;
  }
}

}  // namespace
}  // namespace betwixt
