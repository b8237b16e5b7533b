// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Generates random films without code. Objects rest and move, hide and show, change their looks and their parents. Also
// collects everything visible in a frame, so that tests can compare it bit by bit.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "betwixt/evaluation.h"

namespace betwixt {

class PlainFilm {
 public:
  explicit PlainFilm(std::uint64_t seed) : random_(seed) {}
  std::string script() {
    std::string s =
        "rate 24\nrange 1f 72f\ncreate lamp light\ncreate eye camera position=(9 9 20)\n"
        "create other camera position=(0 3 30)\ncreate c box\ncreate d torus\ncreate e polyline points=((0 0) (1 0) (1 "
        "1))\n"
        "animate spin every 3t by rotate(7deg, y) @ (1 0 0)\nat 20t halt spin\nset c.drive spin\n";
    for (int i = 0; i < 6; ++i) s += fmt::format("create o{} {} position={}\n", i, kind(), vector());
    s += "set eye.look-at o1\n";
    for (int i = 10 + below(30); i > 0; --i) s += line();
    return s;
  }

  std::string line() {
    const std::string o = object();
    const auto vectors = [this] { return vector(); };
    const auto turns = [this] { return fmt::format("axis({} 1 {}, {}deg)", number(), number(), below(170)); };
    switch (below(20)) {
      case 0:
      case 1:
        return rows(o + ".position", {"", " linear", " hold"}, vectors);
      case 2:
        return rows(o + ".rotation", {"", " slerp", " hold"}, turns);
      case 3:
        return rows(o + ".scale", {"", " linear", " hold"}, vectors);
      case 4:
        return rows(o + ".color", {"", " linear", " hold"}, [this] { return one_of({"gold", "red", "#123456"}); });
      case 5:
        return rows(o + ".transparency", {"", " linear", " hold"}, [this] { return one_of({"0", "0.5", "1"}); });
      case 6:
        return rows("o0.position.x", {"", " linear", " hold"}, [this] { return number(); });
      case 7:
        return fmt::format("at {}f {} {}\n", frame(), one_of({"hide", "show"}), o);
      case 8:
        return fmt::format("at {}f {}.material {}\n", frame(), o, one_of({"metal", "matte", "glow", "plastic"}));
      case 9:
        return rows("c.size", {"", " linear", " hold"}, [this] { return one_of({"(1 2 3)", "(2 2 2)", "(0 1 0)"}); });
      case 10:
        return fmt::format("at {}f {}.geometry shape({}) {}\n", frame(), one_of({"c", "d"}), one_of({"c", "d", "e"}),
                           one_of({"linear", "hold"}));
      case 11:
        return rows("e.points", {"", " linear", " hold"}, [this] {
          return one_of({"((0 0) (1 0) (1 1))", "((0 0) (2 0) (1 3))"});
        });
      case 12:
      case 13: {
        const int i = 1 + below(5);
        return fmt::format("at {}f {} o{} to o{}{}\n", frame(), one_of({"attach", "couple"}), i, below(i),
                           one_of({"", " keep-world"}));
      }
      case 14:
        return fmt::format("at {}f letgo {}\n", frame(), o);
      case 15:
        return fmt::format("at {}f hang o{} on eye\n", frame(), 3 + below(3));
      case 16:
        return fmt::format("at {}f eye.look-at {} {}\n", frame(), object(), one_of({"linear", "hold"}));
      case 17:
        return fmt::format("at {}f..{}f {}.motion T{} R({}deg @ {} 0)\n", 2 + below(20), 30 + below(30), o, vector(),
                           below(900), number());
      case 18:
        return fmt::format("at {}f look through {}\n", frame(), one_of({"eye", "other"}));
      default:
        return fmt::format("at {}f {}.environments spin\n", frame(), o);
    }
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  template <std::size_t n>
  std::string one_of(const char* const (&words)[n]) {
    return words[below(n)];
  }
  std::string kind() { return one_of({"sphere", "sphere", "disc", "group"}); }
  std::string number() { return fmt::format("{}", (below(1000) - 500) / 128.0); }
  std::string vector() { return "(" + number() + " " + number() + " " + number() + ")"; }
  std::string twerper() { return one_of({"", "", " linear", " hold", " hold", " smooth", " bspline"}); }
  int frame() { return 1 + below(70); }
  std::string object() { return fmt::format("o{}", below(6)); }
  template <class Value>
  std::string rows(const std::string& target, const char* const (&twerpers)[3], Value&& value) {
    std::string s = target + "\n", last = value();
    int at = below(20);
    for (int n = 1 + below(6); n > 0; --n, at += 1 + below(20)) {
      if (below(3) > 0) last = value();  // often the value of the event before
      s += fmt::format("  {}f {}{}\n", at, last, one_of(twerpers));
    }
    if (below(4) == 0) s += fmt::format("extend {} {}\n", target, one_of({"linear", "cycle", "bounce"}));
    return s;
  }
  std::mt19937_64 random_;
};

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

// The visible properties of one drawable.
struct Seen {
  Mat4 world;
  Evaluation::Look look;
  std::shared_ptr<const Shape> shape, toward;
  friend bool operator==(const Seen& a, const Seen& b) {
    const auto same = [](const auto& x, const auto& y) { return x == y || (x && y && *x == *y); };
    Evaluation::Look look = a.look;
    look.shape = b.look.shape, look.toward = b.look.toward;
    return same_bits(a.world, b.world) && look == b.look && same(a.shape, b.shape) && same(a.toward, b.toward);
  }
};
inline std::vector<Seen> seen(const Evaluation& e) {
  std::vector<Seen> out;
  const auto shape = [&](std::uint32_t n) { return n == Evaluation::Look::none ? nullptr : e.shape(n); };
  for (std::size_t i = 0; i < e.drawables().size(); ++i)
    out.push_back({e.worlds()[i], e.looks()[i], shape(e.looks()[i].shape), shape(e.looks()[i].toward)});
  return out;
}
inline std::vector<Seen> seen_alone(const Program& p, Time t) {
  Evaluation e(p);
  e.to(t);
  return seen(e);
}
inline std::vector<std::uint32_t> differing(const std::vector<Seen>& a, const std::vector<Seen>& b) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    if (!(a[i] == b[i])) out.push_back(i);
  return out;
}

inline bool same_frame(const Frame& a, const Frame& b) {
  const auto same_item = [](const Item& x, const Item& y) {
    return x.id == y.id && same_bits(x.world, y.world) && *x.shape == *y.shape && x.blend == y.blend &&
           x.color == y.color && x.transparency == y.transparency && x.material == y.material && x.body == y.body;
  };
  const auto same_light = [](const Light& x, const Light& y) {
    return x.position == y.position && x.range == y.range && x.color == y.color;
  };
  return std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(), same_item) &&
         std::equal(a.lights.begin(), a.lights.end(), b.lights.begin(), b.lights.end(), same_light) &&
         same_bits(a.camera.world, b.camera.world) && a.problems == b.problems && a.notes == b.notes;
}

}  // namespace betwixt
