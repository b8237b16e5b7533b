// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures each command over N objects and over 2N. The time for one object should stay the same: a ratio near 1 means
// linear growth, a ratio near 2 quadratic growth.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <tuple>

#include "betwixt/document.h"
#include "betwixt/evaluation.h"
#include "betwixt/export.h"
#include "betwixt/language.h"
#include "betwixt/program.h"
#include "betwixt/session.h"
#include "editor/editor.h"
#include "timing.h"

using namespace betwixt;

namespace {

using Size = std::size_t;

std::string film(Size) { return "rate 24\ncreate eye camera position=(0 2 10)\ncreate hand sphere\n"; }
std::string balls(Size n) { return film(n) + fmt::format("create o{{1..{}}} sphere\n", n); }
std::string moving(Size n) { return balls(n) + "o*.position\n  1f (0 0 0)\n  24f (1 0 0) linear\n"; }
std::string held(Size n) { return balls(n) + "couple o* to hand\n"; }
std::string grouped(Size n) { return film(n) + "create g group\n" + fmt::format("create g/o{{1..{}}} sphere\n", n); }
std::string swaying(Size n) { return balls(n) + "layer sway add\n"; }
std::string spinning(Size n) { return balls(n) + "animate spin every 1t by rotate(6deg, z)\n"; }
std::string nested(Size n) {  // a hundred groups
  return film(n) + "create g{1..100} group\n" + fmt::format("create g{{1..100}}/o{{1..{}}} sphere\n", n / 100);
}
std::string turning(Size n) { return film(n) + fmt::format("animate e{{1..{}}} every 1t by rotate(6deg, z)\n", n); }
std::string listed(Size n) {
  std::string out = film(n) + "make all\n";
  for (Size i = 0; i < n; ++i) out += fmt::format("  point ({} 0)\n", i);
  return out + "start all\n";
}

// Returns a line for each object, in which # is replaced by its number.
std::string lines(Size n, std::string_view line) {
  std::string out;
  for (Size i = 1; i <= n; ++i) {
    const std::string number = std::to_string(i);
    for (const char c : line) c == '#' ? out += number : out += c;
    out += '\n';
  }
  return out;
}

// A model of twenty parts, and so many instances that there are n objects in all.
std::string instances(Size n) {
  return film(n) + "create m group\ncreate m/p{1..19} box position=(i 0 0)\ndefine kind k like m hidden\n" +
         fmt::format("create o{{1..{}}} k position=(0 i 0)\n", std::max<Size>(n / 20, 1));
}
std::string kind(Size n) { return film(n) + "define kind k like hand\n"; }

std::string flat(Size n) { return "film flat\n" + moving(n); }

Size kept = 0;
void keep(Size n) { kept += n; }  // so that the compiler does not remove the work

void exported(const Document& d, const char* ending) {
  ExportOptions options;
  const auto file = std::filesystem::temp_directory_path() / fmt::format("bench-{}.{}", getpid(), ending);
  options.path = file.string();
  std::tie(options.from, options.until) = d.range();
  const auto done = export_film(Program::compile(d), options);
  if (!done) std::fprintf(stderr, "%s\n", done.error().message.c_str());
  std::filesystem::remove(file);
}

struct Row {
  const char* name;
  std::string (*before)(Size);
  const char* said = nullptr;               // one line about all objects; @ is their number …
  const char* each = nullptr;               // … or a line for each
  void (*done)(const Document&) = nullptr;  // … or something else
  // Whether the lines are a bundle: `again` in the history of an earlier session, `live` of a live host.
  enum class Bundle : unsigned char { none, again, live } bundle = Bundle::none;
};

const Row rows[] = {
    // One line for all objects.
    {"create", film, "create p{1..@} sphere"},
    {"create at i", film, "create p{1..@} sphere position=(i 0 0)"},
    {"create below", grouped, "create g/p{1..@} sphere"},
    {"create like", balls, "create p{1..@} like hand"},
    {"create like group", grouped, "create h like g"},
    {"row", balls, "at 1f o*.position (1 0 0)"},
    {"row of i", balls, "at 1f o*.position (i 0 0)"},
    {"row of braces", balls, "at 1f o{1..@}.position (1 0 0)"},
    {"row of braces of i", balls, "at 1f o{1..@}.position (i1 0 0)"},
    {"row of too many braces", balls, "set o{1..1@}.position (i1 0 0)"},
    {"set", balls, "set o*.color gold"},
    {"set of i", balls, "set o*.position (i 0 0)"},
    {"set of code", balls, "set o*.position = \"return vec(t, 0, 0)\""},
    {"row of code", balls, "at 1f o*.position = \"return vec(t, i, 0)\""},
    {"along", balls, "at 1f..24f o*.position along hand"},
    {"hang", balls, "hang o* on hand"},
    {"hang at", balls, "at 12f hang o* on hand keep-world"},
    {"couple", balls, "couple o* to hand"},
    {"detach", held, "detach o*"},
    {"letgo", held, "at 12f letgo o*"},
    {"hide", balls, "at 12f hide o*"},
    {"fall", balls, "at 1f fall o* for 24f"},
    {"copy", moving, "copy o*.position 1f..24f to 48f"},
    {"copy of one", moving, "copy o1.position 1f..24f to 48f on o*.position"},
    {"move", moving, "move o*.position 1f..24f by 12f"},
    {"stretch", moving, "stretch o*.position 1f..24f by 2"},
    {"reverse", moving, "reverse o*.position 1f..24f"},
    {"scale", moving, "scale o*.position 1f..24f (1 2 1)"},
    {"rotate", moving, "rotate o*.position 1f..24f 90deg y"},
    {"translate", moving, "translate o*.position 1f..24f (0 1 0)"},
    {"clear", moving, "clear o*.position 1f..24f"},
    {"stagger", moving, "stagger o*.position by 1f"},
    {"stagger from random", moving, "stagger o*.position by 1f from random 7"},
    {"stagger by way", moving, "stagger o*.position by 1f per 1m from hand"},
    {"spread", balls, "spread o*.position from (0 0 0) to (9 0 0)"},
    {"filter", moving, "filter o*.position delay by=6f"},
    {"bake", moving, "bake o*.position 1f..24f"},
    {"twerper", moving, "twerper o*.position smooth"},
    {"extend", moving, "extend o*.position cycle"},
    {"arrange", balls, "arrange o* in grid"},
    {"place", balls, "place o* next-to hand"},
    {"frame", balls, "frame o*"},
    {"animate", film, "animate e{1..@} every 1t by rotate(6deg, z)"},
    {"halt", turning, "at 10t halt e*"},
    {"alias", balls, "alias all = o{1..@}"},
    {"remove", balls, "remove o*"},
    {"remove group", grouped, "remove g"},
    {"rename group", grouped, "rename g h"},
    {"environments", spinning, "set o*.environments (spin)"},
    {"change of a model", instances, "set m/p7.color gold"},
    {"new part of a model", instances, "create m/q sphere"},
    {"unlink", instances, "unlink o*"},
    // A line for each object.
    {"create, each", film, nullptr, "create p# sphere"},
    {"create like, each", film, nullptr, "create p# like hand"},
    {"create like many, each", balls, nullptr, "create p# like o#"},
    {"create of a kind, each", kind, nullptr, "create p# k"},
    {"create below, each", grouped, nullptr, "create g/p# sphere"},
    {"set, each", balls, nullptr, "set o#.color gold"},
    {"event, each", balls, nullptr, "at 1f o#.position (1 0 0)"},
    {"sheet, each", balls, nullptr, "o#.position\n  1f (i 0 0)\n  24f (i 1 0)"},
    {"set of code, each", balls, nullptr, "set o#.position = \"return vec(t, 0, 0)\""},
    {"hang, each", balls, nullptr, "hang o# on hand"},
    {"hang at, each", balls, nullptr, "at 12f hang o# on hand keep-world"},
    {"chain, each", film, nullptr, "create q# sphere\nhang q# on hand\nhang hand on eye"},
    {"hide, each", balls, nullptr, "at 12f hide o#"},
    {"copy, each", moving, nullptr, "copy o#.position 1f..24f to 48f"},
    {"move, each", moving, nullptr, "move o#.position 1f..24f by 12f"},
    {"scale, each", moving, nullptr, "scale o#.position 1f..24f (1 2 1)"},
    {"clear, each", moving, nullptr, "clear o#.position 1f..24f"},
    {"filter, each", moving, nullptr, "filter o#.position delay by=6f"},
    {"twerper, each", moving, nullptr, "twerper o#.position smooth"},
    {"extend, each", moving, nullptr, "extend o#.position cycle"},
    {"velocity, each", moving, nullptr, "at 1f o#.position.velocity (1 0 0)"},
    {"release, each", moving, nullptr, "at 1f o#.position.velocity release"},
    {"animate, each", film, nullptr, "animate e# every 1t by rotate(6deg, z)"},
    {"animate again, each", film, nullptr, "at #t animate e every 1t by rotate(6deg, z)"},
    {"halt, each", turning, nullptr, "at 10t halt e#"},
    {"environments, each", turning, nullptr, "create q# sphere environments=(e#)"},
    {"alias, each", balls, nullptr, "alias a# = o#"},
    {"let, each", film, nullptr, "let a# = #"},
    {"define, each", film, nullptr, "define f# number"},
    {"procedure, each", film, nullptr, "procedure p# lua \"return t\""},
    {"note, each", film, nullptr, "at #f note \"#\""},
    {"look, each", film, nullptr, "at #f look through eye"},
    {"layer, each", film, nullptr, "layer l# add"},
    {"on layer, each", swaying, nullptr, "on sway at 1f o#.position (0 1 0)"},
    {"dial, each", balls, nullptr, "dial /fader/# to o#.radius"},
    {"remove, each", balls, nullptr, "remove o#"},
    {"rename, each", balls, nullptr, "rename o# p#"},
    {"make, each", film, nullptr, "make s#\n  point (0 0)"},
    {"rename below, each", nested, nullptr, "create q# sphere\nrename q# g1/q#"},
    {"make, each", film, nullptr, "make s#\n  point (0 0)"},
    // A bundle of an earlier session.
    {"bundle of create", film, nullptr, "create p# sphere", nullptr, Row::Bundle::again},
    {"bundle of set", balls, nullptr, "set o#.color gold", nullptr, Row::Bundle::again},
    {"bundle of sheets", balls, nullptr, "o#.position\n  1f (i 0 0)\n  24f (i 1 0)", nullptr, Row::Bundle::again},
    {"bundle of hang", balls, nullptr, "hang o# on hand", nullptr, Row::Bundle::again},
    {"bundle of remove", balls, nullptr, "remove o#", nullptr, Row::Bundle::again},
    {"bundle of animate", film, nullptr, "animate e# every 1t by rotate(6deg, z)", nullptr, Row::Bundle::again},
    {"bundle of note", film, nullptr, "at #f note \"#\"", nullptr, Row::Bundle::again},
    {"bundle of alias", balls, nullptr, "alias a# = o#", nullptr, Row::Bundle::again},
    {"bundle of make", film, nullptr, "make s#\n  point (0 0)", nullptr, Row::Bundle::again},
    // A bundle of a live host.
    {"live bundle of note", film, nullptr, "at #f note \"#\"", nullptr, Row::Bundle::live},
    {"live bundle of note from behind", film, nullptr, "at -#f note \"#\"", nullptr, Row::Bundle::live},
    {"live bundle of alias", balls, nullptr, "alias a# = o#", nullptr, Row::Bundle::live},
    {"live bundle of let", film, nullptr, "let n# = #", nullptr, Row::Bundle::live},
    {"live bundle of define", film, nullptr, "define f# number #", nullptr, Row::Bundle::live},
    {"live bundle of make", film, nullptr, "make s#\n  point (0 0)", nullptr, Row::Bundle::live},
    {"live bundle of lists, shown", listed, nullptr, "make s#\n  point (0 0)", nullptr, Row::Bundle::live},
    {"live bundle of set", balls, nullptr, "set o#.color gold", nullptr, Row::Bundle::live},
    {"live bundle of sheets", balls, nullptr, "o#.position\n  1f (1 0 0)\n  24f (2 1 0)", nullptr, Row::Bundle::live},
    // Commands of the shell.
    {"list", balls, "list"},
    {"list pattern", balls, "list o*"},
    {"describe", balls, "describe o*"},
    {"describe targets", moving, "describe o*.position"},
    {"describe environments", turning, "describe e*"},
    {"eval", balls, "eval o*"},
    {"eval position", balls, "eval o*.position"},
    {"eval all functions", balls, "eval o*.*"},
    // Operations on a document.
    {"write", moving, nullptr, nullptr, [](const Document& d) { keep(write(d).size()); }},
    {"write held", held, nullptr, nullptr, [](const Document& d) { keep(write(d).size()); }},
    {"write environments", turning, nullptr, nullptr, [](const Document& d) { keep(write(d).size()); }},
    {"tidy", moving, nullptr, nullptr, [](const Document& d) { keep(tidy(write(d)).size()); }},
    {"read again", moving, nullptr, nullptr,
     [](const Document& d) { insist(load_text(write(d), "").document == d, "written"); }},
    {"compile", moving, nullptr, nullptr, [](const Document& d) { keep(Program::compile(d).frame({}).items.size()); }},
    {"compile held", held, nullptr, nullptr,
     [](const Document& d) { keep(Program::compile(d).frame({}).items.size()); }},
    {"compile environments", turning, nullptr, nullptr,
     [](const Document& d) { keep(Program::compile(d).frame({}).items.size()); }},
    {"compile list", listed, nullptr, nullptr,
     [](const Document& d) { keep(Program::compile(d).frame({}).items.size()); }},
    {"export gltf", moving, nullptr, nullptr, [](const Document& d) { exported(d, "glb"); }},
    {"export usda", moving, nullptr, nullptr, [](const Document& d) { exported(d, "usda"); }},
    {"export json", moving, nullptr, nullptr, [](const Document& d) { exported(d, "json"); }},
    {"export lottie", flat, nullptr, nullptr, [](const Document& d) { exported(d, "lottie.json"); }},
};

struct Spent {
  double ms = 0;
  bool done = true;
};

std::string with_count(std::string_view line, Size n) {
  std::string out;
  for (const char c : line) c == '@' ? out += std::to_string(n) : out += c;
  return out;
}

double loading(const std::string& text) {
  return processor_milliseconds([&] { keep(load_text(text, "").diagnostics.size()); });
}

// Carries out one step of a history. The result must equal that of a script with the same lines.
double doing_again(const std::string& before, const std::string& text) {
  Step bundle;
  for (Size at = 0, end; at < text.size(); at = end + 1) {
    end = std::min(text.find('\n', at), text.size());
    bundle.lines.push_back(text.substr(at, end - at));
  }
  Editor editor;
  editor.begin(before, "");
  const double ms = processor_milliseconds([&] { insist(editor.restore({&bundle, 1}, 1).empty(), "done again"); });
  insist(editor.now().document == load_text(before + text, "").document, "the same film");
  return ms;
}

// Sends a bundle as a live host.
double doing_live(const std::string& before, const std::string& text) {
  Editor editor;
  editor.begin(before, "");
  Document made;
  const double ms = processor_milliseconds([&] {
    Editor::Draft draft(editor, editor.now());
    for (Size at = 0, end; at < text.size(); at = end + 1) {
      end = std::min(text.find('\n', at), text.size());
      insist(draft.carry_out(std::string_view(text).substr(at, end - at), Time{}).done, "done");
    }
    made = std::move(draft).point().document;
  });
  insist(made == load_text(before + text, "").document, "the same film");
  return ms;
}

Spent spent(const Row& row, Size n) {
  Spent out;
  const std::string before = row.before(n);
  if (row.bundle != Row::Bundle::none) {
    const auto how = row.bundle == Row::Bundle::again ? doing_again : doing_live;
    out.ms = how(before, lines(n, row.each));
  } else if (row.each) {
    const Loaded all = load_text(before + lines(3, row.each), "");
    for (const Diagnostic& d : all.diagnostics)
      if (d.severity == Severity::error) return std::fputs(to_string(d).c_str(), stderr), Spent{0, false};
    const double base = loading(before);
    out.ms = loading(before + lines(n, row.each)) - base;
  } else if (row.said) {
    Session session;
    session.begin(before, "");
    Session::Answer answer;
    out.ms = processor_milliseconds([&] { answer = session.enter(with_count(row.said, n)); });
    if (!answer.done) return std::fputs(answer.said.substr(0, 300).c_str(), stderr), Spent{0, false};
  } else {
    const Document d = load_text(before, "").document;
    out.ms = processor_milliseconds([&] { row.done(d); });
  }
  return out;
}

}  // namespace

// bench_growing [N] [PART OF A NAME …]
int main(int argc, char** argv) {
  Size n = 10'000;
  int first = 1;
  if (argc > 1 && std::atoi(argv[1]) > 0) n = static_cast<Size>(std::atoi(argv[first++]));
  fmt::print("{:28} {:>12} {:>12} {:>8}\n", "", fmt::format("us, {}", n), fmt::format("us, {}", 2 * n), "ratio");
  for (const Row& row : rows) {
    const auto asked = [&](const char* part) { return std::strstr(row.name, part) != nullptr; };
    if (first < argc && !std::any_of(argv + first, argv + argc, asked)) continue;
    const Spent one = spent(row, n), two = one.done ? spent(row, 2 * n) : one;
    if (!one.done || !two.done) {
      fmt::print("{:28} refused\n", row.name);
      continue;
    }
    const double a = 1e3 * one.ms / static_cast<double>(n), b = 1e3 * two.ms / static_cast<double>(2 * n);
    fmt::print("{:28} {:12.3f} {:12.3f} {:8.2f}\n", row.name, a, b, b / a);
    std::fflush(stdout);
  }
}
