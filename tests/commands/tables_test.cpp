// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests tables of data: reading them, their cells in formulas, and tracks made of their rows. Derived columns are
// worked out again by brute force over random tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "exchange/table_file.h"
#include "scene/document.h"
#include "scene/table.h"
#include "support/folder.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

constexpr const char* cities =
    "data pop of \"\"\"city,year,people,area\nBern,1990,1,51.6\nChur,1990,4,28\nBern,2000,3,51.6\nChur,2000,2,28\n"
    "Bern,2010,,51.6\nChur,2010,6,28\"\"\" key=city over=year\n";

double number_at(const LoadedFilm& s, std::string_view target, std::string_view when) {
  return std::get<double>(s.read(target, when));
}

TEST(Tables, MakeAnObjectForEachKeyInOrderOfAppearance) {
  const LoadedFilm s(std::string(cities) +
                     "create bar{pop} box size=(row.people row.area i)\ncreate t{pop} text text=row.city\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(s.loaded.document.names(), (std::vector<std::string>{"barBern", "barChur", "tBern", "tChur"}));
  EXPECT_EQ(std::get<Vec3>(s.read("barBern.size", "1f")), (Vec3{1, 51.6, 1}));
  EXPECT_EQ(std::get<Vec3>(s.read("barChur.size", "1f")), (Vec3{4, 28, 2}));
  EXPECT_EQ(s.text("tChur.text", "1f"), "Chur");
}

TEST(Tables, RowsBecomeEventsAtTheirTimes) {
  const LoadedFilm s(std::string(cities) +
                     "create bar{pop} box\nfill bar*.size.y from pop.people*10 over year 1f..41f linear\n"
                     "fill bar*.position from (pop.people 0 rank(pop.people)) over year 1f..41f hold\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_NEAR(number_at(s, "barBern.size.y", "1f"), 10, 1e-12);
  EXPECT_NEAR(number_at(s, "barBern.size.y", "11f"), 20, 1e-12);
  EXPECT_NEAR(number_at(s, "barBern.size.y", "41f"), 30, 1e-12);  // 2010 has no number: no event
  EXPECT_NEAR(number_at(s, "barChur.size.y", "41f"), 60, 1e-12);
  EXPECT_EQ(std::get<Vec3>(s.read("barBern.position", "1f")), (Vec3{1, 0, 2}));
  EXPECT_EQ(std::get<Vec3>(s.read("barBern.position", "21f")), (Vec3{3, 0, 1}));
  EXPECT_EQ(std::get<Vec3>(s.read("barChur.position", "41f")), (Vec3{6, 0, 1}));
}

TEST(Tables, AColumnOfSecondsNeedsNoSegment) {
  const LoadedFilm s(
      "data log of \"\"\"t,y\n0.5,1\n2,4\"\"\"\ncreate ball sphere\nfill ball.position.y from log.y over t linear\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_NEAR(number_at(s, "ball.position.y", "1.25s"), 2.5, 1e-12);
}

TEST(Tables, DatesAreDays) {
  double a = 0, b = 0;
  ASSERT_TRUE(read_date("2024-02-28", a) && read_date("2024-03-01T12:00", b));
  EXPECT_EQ(b - a, 2.5);  // a leap year
  ASSERT_TRUE(read_date("1970-01", a));
  EXPECT_EQ(a, 0);
  for (const char* wrong : {"2024-13-01", "2024-00-01", "24-01-01", "2024/01/01", "2024-01-01x", "2024-01-1"})
    EXPECT_FALSE(read_date(wrong, a)) << wrong;
}

TEST(Tables, CellsAreNumbersAsPeopleWriteThem) {
  const auto reads = [](std::string_view cell, bool comma = false) {
    double v = NAN;
    return read_cell_number(cell, comma, v) ? v : NAN;
  };
  EXPECT_EQ(reads("1,234,567.5"), 1234567.5);
  EXPECT_EQ(reads("-12,000"), -12000);
  EXPECT_EQ(reads("+3e2"), 300);
  EXPECT_EQ(reads("1.234,5", true), 1234.5);
  for (const char* wrong : {"12,34", ",123", "1,2345", "1e999", "0x10", "12 %", "inf"})
    EXPECT_TRUE(std::isnan(reads(wrong))) << wrong;
}

TEST(Tables, AreReadWithTheSeparatorTheyHave) {
  for (const char separator : {',', ';', '\t'}) {
    std::string text = "a|b b|\"c|\"\"x\"\"\"\r\n\"one|two\"|2|3\r\n\r\n x |NA|-1";
    for (char& c : text) c = c == '|' ? separator : c;
    const auto read = parse_table(text, "t.csv");
    ASSERT_TRUE(read) << read.error().message;
    const Table& t = **read;
    EXPECT_EQ(t.column_names(), (std::vector<std::string_view>{"a", "b_b", "c_x"}));
    EXPECT_EQ(t.columns[0].cells[0], std::string("one") + separator + "two");
    EXPECT_EQ(t.columns[0].cells[1], "x");
    EXPECT_EQ(t.columns[1].numbers[0], 2);
    EXPECT_FALSE(t.columns[1].has(1));
    EXPECT_EQ(t.lines, (std::vector<std::uint32_t>{2, 4}));
  }
}

// Tables of this form with some empty cells, and times and values that repeat.
struct RandomTable {
  std::vector<std::string> keys;
  std::vector<double> times, values;
  std::string text = "k,t,v\n";
  explicit RandomTable(unsigned seed) {
    std::mt19937 random(seed);
    const int things = 1 + static_cast<int>(random() % 6), steps = 1 + static_cast<int>(random() % 8);
    for (int t = 0; t < steps; ++t)
      for (int k = 0; k < things; ++k) {
        if (random() % 5 == 0) continue;
        keys.push_back(fmt::format("k{}", k)), times.push_back(t * 3);
        values.push_back(random() % 6 == 0 ? NAN : static_cast<double>(random() % 7));
        text += fmt::format("{},{},{}\n", keys.back(), times.back(),
                            std::isnan(values.back()) ? "" : fmt::format("{}", values.back()));
      }
  }
};

void expect_same(const std::vector<double>& a, const std::vector<double>& b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(b[i]))
      EXPECT_TRUE(std::isnan(a[i])) << what << " of row " << i;
    else
      EXPECT_NEAR(a[i], b[i], 1e-12) << what << " of row " << i;
  }
}

TEST(Tables, DerivedColumnsAreThoseOfBruteForce) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const RandomTable r(seed);
    if (r.keys.empty() || std::all_of(r.values.begin(), r.values.end(), [](double v) { return std::isnan(v); }))
      continue;
    const auto read = parse_table(r.text, "t");
    ASSERT_TRUE(read);
    Table& t = **read;
    for (std::size_t i = 0; i < r.keys.size(); ++i)
      t.key_of.push_back(static_cast<std::uint32_t>(r.keys[i].back() - '0'));
    const std::size_t n = r.values.size();
    std::vector<double> rank(n, NAN), share(n, NAN), sum(n, NAN), change(n, NAN), smooth(n, NAN);
    for (std::size_t i = 0; i < n; ++i) {
      if (std::isnan(r.values[i])) continue;
      double before = 1, all = 0, until = 0, last = NAN;
      std::vector<double> own;
      std::size_t place = 0;
      for (std::size_t j = 0; j < n; ++j) {
        if (std::isnan(r.values[j])) continue;
        const bool same_time = r.times[j] == r.times[i];
        if (same_time) all += r.values[j];
        if (same_time && (r.values[j] > r.values[i] || (r.values[j] == r.values[i] && j < i))) ++before;
        if (r.keys[j] != r.keys[i]) continue;
        if (j == i) place = own.size();
        if (j <= i) until += r.values[j];
        if (j < i) last = r.values[j];
        own.push_back(r.values[j]);
      }
      rank[i] = before, share[i] = all == 0 ? NAN : r.values[i] / all, sum[i] = until;
      change[i] = std::isnan(last) ? NAN : r.values[i] - last;
      double near = 0, count = 0;
      for (std::size_t j = place < 1 ? 0 : place - 1; j < std::min(own.size(), place + 2); ++j) near += own[j], ++count;
      smooth[i] = near / count;
    }
    expect_same(tables::ranks(t, 2, 1), rank, "rank");
    expect_same(tables::shares(t, 2, 1), share, "share");
    expect_same(tables::sums_until(t, 2, 1), sum, "cumulative");
    expect_same(tables::changes(t, 2, 1), change, "change");
    expect_same(tables::smoothed(t, 2, 1, 3), smooth, "smooth");
  }
}

TEST(Tables, WholeColumnsInFormulasAndLists) {
  const LoadedFilm s(std::string(cities) +
                     "create a sphere position=(max(pop.people) sum(pop.people) mean(pop.people))\n"
                     "create b sphere position=(count(pop.people) min(pop.people) pop.people[2])\n"
                     "let areas = pop.area\ncreate c sphere radius=areas[2]\n"
                     "create chart bars of=pop.people keys=pop.city\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(std::get<Vec3>(s.read("a.position", "1f")), (Vec3{6, 16, 3.2}));
  EXPECT_EQ(std::get<Vec3>(s.read("b.position", "1f")), (Vec3{5, 1, 4}));
  EXPECT_EQ(number_at(s, "c.radius", "1f"), 28);
  EXPECT_EQ(number_at(s, "chart/Chur.value", "1f"), 4);
}

TEST(Tables, RowsAreChosenAndSorted) {
  const LoadedFilm s(
      "data a of \"\"\"n,v\nb,2\na,3\nd,\nc,1\"\"\" key=n sort=-v\ncreate x{a} group\n"
      "data b of \"\"\"n,v\nb,2\na,3\nd,\nc,1\"\"\" key=n where v>=2 where n != a\ncreate y{b} group\n"
      "data c of \"\"\"n,v\nb,2\na,3\nd,\nc,1\"\"\" key=n sort=n first=2\ncreate z{c} group\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(s.loaded.document.names(), (std::vector<std::string>{"xa", "xb", "xc", "xd", "yb", "za", "zb"}));
}

TEST(Tables, KeysBecomeNames) {
  const LoadedFilm s(
      "data a of \"\"\"n\nNew York\nSão Paulo\nNew-York\n東京\n12.5\"\"\" key=n\ncreate x{a} text text=row.n\n");
  ASSERT_TRUE(!has_errors(s.loaded.diagnostics)) << said(s.loaded.diagnostics);
  EXPECT_EQ(s.loaded.document.names(),
            (std::vector<std::string>{"xNew-York", "xSao-Paulo", "xNew-York-2", "x4", "x125"}));
  EXPECT_EQ(s.text("x4.text", "1f"), "東京");
}

TEST(Tables, QuotationMarksAreWrittenTwice) {
  const auto read = parse_table("a,b\n\"He said \"\"no\"\", twice\",\"\"\"\"\n\"\",x", "t.csv");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ((*read)->columns[0].cells[0], "He said \"no\", twice");
  EXPECT_EQ((*read)->columns[1].cells[0], "\"");
  EXPECT_EQ((*read)->columns[0].cells[1], "");
}

TEST(Tables, CellsAreNeverCode) {
  const LoadedFilm s("data a of \"\"\"n,v\n\"remove *\",\"= os.exit()\"\n\"\"\" key=n\ncreate x{a} text text=row.v\n");
  ASSERT_FALSE(has_errors(s.loaded.diagnostics)) << said(s.loaded.diagnostics);
  EXPECT_EQ(s.text("xremove.text", "1f"), "= os.exit()");
}

TEST(Tables, AWrittenFilmHasItsTables) {
  const Folder folder;
  folder.put("pop.csv", "city,people\nBern,2\nChur,3\n");
  folder.put("film.bx", "data pop from \"pop.csv\" key=city\ncreate b{pop} box size=(row.people 1 1)\n");
  const Loaded first = load_file(folder / "film.bx");
  ASSERT_TRUE(first.diagnostics.empty()) << said(first.diagnostics);
  folder.put("again.bx", write(first.document));
  const Loaded second = load_file(folder / "again.bx");
  ASSERT_TRUE(second.diagnostics.empty()) << said(second.diagnostics);
  EXPECT_TRUE(first.document == second.document);
}

struct WrongTable {
  const char *script, *message;
  ErrorCode code;
  int line, column;
};
class WrongTables : public testing::TestWithParam<WrongTable> {};
TEST_P(WrongTables, AreErrorsWithAPlace) {
  const auto& [script, message, code, line, column] = GetParam();
  const Loaded loaded = load_text(std::string(cities) + script, "film.bx");
  ASSERT_FALSE(loaded.diagnostics.empty()) << script;
  const Diagnostic& d = loaded.diagnostics[0];
  EXPECT_EQ(d.what.message, message) << script;
  EXPECT_EQ(d.what.code, code) << script;
  EXPECT_EQ(d.what.place.line, 7 + line) << script;
  EXPECT_EQ(d.what.place.column, column) << script;
}
INSTANTIATE_TEST_SUITE_P(
    All, WrongTables,
    testing::Values(
        WrongTable{"data a of \"\"\"a,b\n1,2,3\"\"\"\n",
                   "line 2, column 5 of the table: this row has 3 cells, but there are 2 columns", ErrorCode::file, 1,
                   11},
        WrongTable{"data a of \"\"\"a,b\n1,\"x\"\"\"\n",
                   "line 2, column 3 of the table: this quotation mark is never closed", ErrorCode::file, 1, 11},
        WrongTable{"data a of \"\"\"a,a\n1,2\"\"\"\n", "line 1, column 3 of the table: there are two columns 'a'",
                   ErrorCode::file, 1, 11},
        WrongTable{"data a of \"\"\"a\n\"\"\"\n", "the table has no rows below its first line", ErrorCode::file, 1, 11},
        WrongTable{"data a from \"none.csv\"\n", "there is no file 'none.csv'", ErrorCode::file, 1, 13},
        WrongTable{"data a from \"/etc/passwd\"\n", "'/etc/passwd' is outside the script's folder", ErrorCode::file, 1,
                   13},
        WrongTable{"data pop of \"\"\"a\n1\"\"\"\n", "'data pop' already exists", ErrorCode::name, 1, 6},
        WrongTable{"let pop = 3\n", "'data pop' already exists", ErrorCode::name, 1, 5},
        WrongTable{"data a of \"\"\"n\n1\"\"\" key=m\n", "the table has no column 'm'", ErrorCode::name, 2, 10},
        WrongTable{"data a of \"\"\"n,v\nx,1\n,2\"\"\" key=n\n", "line 3 of the table has no n", ErrorCode::file, 3,
                   11},
        WrongTable{"data a of \"\"\"n\nx\"\"\" over=n\n", "'n' is a column of texts, not of times", ErrorCode::type, 2,
                   11},
        WrongTable{"data a of \"\"\"n\n1\"\"\" where n>x\n",
                   "'n' is a column of numbers, so it cannot be compared with 'x'", ErrorCode::type, 2, 12},
        WrongTable{"data a of \"\"\"n\n1\"\"\" where n>1\n", "no row of the table is left", ErrorCode::range, 1, 11},
        WrongTable{"data a of \"\"\"n,v\nx,\"\"\" key=n\ncreate y{a} box size=(row.v 1 1)\n",
                   "line 2 of the table has no v", ErrorCode::range, 3, 23},
        WrongTable{"data a of \"\"\"n\nx\"\"\"\ncreate y{a} box\n", "the table 'a' has no keys, so it makes no names",
                   ErrorCode::type, 3, 10},
        WrongTable{"create x{poq} box\n", "there is no table 'poq'", ErrorCode::name, 1, 10},
        WrongTable{"create x{pop} box size=(row.peple 1 1)\n", "the table has no column 'peple'", ErrorCode::name, 1,
                   29},
        WrongTable{"create x box size=(pop.people 1 1)\n", "'pop.people' is a whole column", ErrorCode::type, 1, 20},
        WrongTable{"create x box size=(pop.people[3] 1 1)\n",
                   "'pop' has 2 keys, counted from 1; there is no pop.people[3]", ErrorCode::range, 1, 30},
        WrongTable{"create x box size=(rank(pop.people) 1 1)\n", "rank needs a row of 'pop'", ErrorCode::type, 1, 20},
        WrongTable{"create x box size=(sum(pop.city) 1 1)\n",
                   "'pop.city' is a column of texts: line 2 of the table has 'Bern'", ErrorCode::type, 1, 24},
        WrongTable{"create x{pop} box\nfill x*.size.y from pop.people over city 1f..24f\n",
                   "'city' is a column of texts, not of times", ErrorCode::type, 2, 37},
        WrongTable{"create x{pop} box\nfill x*.size.y from pop.people over year 1f\n",
                   "expected a segment here, from the time of the first row to that of the last", ErrorCode::syntax, 2,
                   42},
        WrongTable{"create y box\nfill y.size.y from pop.people over year 1f..24f\n",
                   "no key of the table is in the names of 'y'", ErrorCode::name, 2, 6},
        WrongTable{"data a of \"\"\"n,t,v\nx,1,2\nx,1,3\"\"\" key=n\ncreate y{a} box\nfill y*.size.y from a.v over t "
                   "1f..24f\n",
                   "lines 2 and 3 of the table are for one t of 'x'", ErrorCode::file, 5, 30}));

// One bad date makes a column one of texts. The hint says which cell it is.
TEST(WrongTimes, AreNamedWithTheirLine) {
  const auto hint = [](const std::string& cells) {
    const Loaded l = read("data a of \"\"\"n\n" + cells + "\"\"\" over=n\n");
    return l.diagnostics.empty() ? "" : l.diagnostics[0].what.hint;
  };
  EXPECT_EQ(hint("1990-01-02\n2026-13-45"), "'2026-13-45' in line 3 is no date; as in 1990-07-31");
  EXPECT_EQ(hint("1990\n1991\nsoon"), "'soon' in line 4 is no number and no date");
}

}  // namespace
}  // namespace betwixt
