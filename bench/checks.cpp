// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks the values of the benchmarks:
//   bench_checks random [FILMS]   films of mixed types and twerpers: an evaluation that visits many times must give the
//                                 bits of a new one at each time, and of values that are read one by one
//   bench_checks keys             prints numbers of scenes::keyed, interpolated linearly, to compare peers with. A line
//                                 has the object, the frame, position, angles, scale, and the matrix
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "betwixt/language.h"
#include "scenes.h"
#include "support/plain_film.h"
#include "timing.h"

using namespace betwixt;

namespace {

// Checks that the values of every drawable equal the values read from its object.
void compare(const Program& program, const Evaluation& e) {
  for (std::size_t i = 0; i < e.drawables().size(); ++i) {
    const ObjectId id = e.drawables()[i];
    const Value world = program.read({id, Query::world}, e.time());
    for (std::size_t k = 0; k < 16; ++k) {
      const double is = e.worlds()[i].m[k], want = std::get<Matrix>(world)->m[k];
      insist(std::abs(is - want) <= 1e-9 * (1 + std::abs(want)), "a world that is read");
    }
    const auto shown = find_targets(program.document().name(id) + ".display", program.document());
    insist(shown && std::get<bool>(program.read(shown->front(), e.time())) == e.looks()[i].visible, "what is seen");
  }
}

void random_films(int films) {
  int compared = 0;
  for (int seed = 1; seed <= films; ++seed) {
    const Loaded loaded = load_text(PlainFilm(static_cast<std::uint64_t>(seed)).script(), "random.bx");
    const Program program = Program::compile(loaded.document);
    Evaluation going(program);
    for (std::uint32_t k = 0; k < 40; ++k) {
      const auto number = scenes::hash(static_cast<std::uint32_t>(seed) * 64 + (k < 20 ? k / 4 : k)) % 160;
      const Time t = loaded.document.rate().frame(0.5 * number + (k < 20 ? k % 4 : 0));
      going.to(t);
      Evaluation alone(program);
      alone.to(t);
      insist(going.worlds().size() == alone.worlds().size(), "as many worlds");
      for (std::size_t i = 0; i < going.worlds().size(); ++i)
        insist(same_bits(going.worlds()[i], alone.worlds()[i]) && going.looks()[i].color == alone.looks()[i].color &&
                   going.looks()[i].visible == alone.looks()[i].visible &&
                   going.looks()[i].transparency == alone.looks()[i].transparency,
               "an evaluation that was elsewhere before");
      compare(program, going);
      compared += static_cast<int>(going.worlds().size());
    }
  }
  report("films", films);
  report("compared", compared);
}

void keys() {
  const Document document = load_text(scenes::keyed(100, scenes::Times::by_hand, scenes::Blend::linear), "k").document;
  const Program program = Program::compile(document);
  for (int k = 0; k < 100; k += 9)
    for (const double frame : {1.0, 2.5, 77.25, 300.0, 511.5}) {
      const Time t = document.rate().frame(frame);
      fmt::print("{} {}", k, frame);
      for (const char* function : {"position", "rotation", "scale", "world"}) {
        const auto target = find_targets(fmt::format("b{}.{}", k, function), document);
        insist(target && target->size() == 1, "a target");
        for (const double n : numbers(program.read(target->front(), t))) fmt::print(" {}", n);
      }
      fmt::print("\n");
    }
}

}  // namespace

int main(int count, char** words) {
  const std::string what = count > 1 ? words[1] : "";
  if (what == "random")
    random_films(count > 2 ? std::atoi(words[2]) : 100);
  else if (what == "keys")
    keys();
  else
    return std::fputs("usage: bench_checks random [FILMS] | keys\n", stderr), 2;
}
