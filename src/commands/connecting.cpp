// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/connecting.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/utf8.h"
#include "commands/command.h"
#include "commands/furnishing.h"
#include "commands/furniture_rows.h"
#include "commands/measuring.h"
#include "commands/translating.h"
#include "language/values.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

constexpr std::array<std::string_view, 3> routes{"straight", "curved", "angled"};

std::string end_in_code(const LinkEnd& e) {
  return fmt::format("'{}', {}, {}, {}, {}", e.name, write_metres(e.middle.x), write_metres(e.middle.y),
                     write_metres(e.width), write_metres(e.height));
}

// Measures the border of an object. A line to a group goes to its origin.
bool find_end(Command& k, ObjectId id, std::string_view about, LinkEnd& out) {
  const Object& o = k.scene.objects[id.index];
  if (!placed(o.kind)) return k.cursor.fail(ErrorCode::type, fmt::format("'{}' has no place", o.name), about);
  out = end_of_link(k.scene, measured(k.scene, {id}, k.time.value_or(Time{}))[0]).value_or(LinkEnd{o.name, {}, 0, 0});
  return true;
}

std::string last_of(const std::string& name) { return name.substr(name.rfind('/') + 1); }

bool connect(Command& k) {
  auto& [s, c, time, layer, script] = k;
  ObjectId a, b;
  c.space();
  const std::string_view first = c.peek_word();
  if (!values(k).object(a)) return false;
  if (!c.accept_word("to"))
    return c.fail_here(ErrorCode::syntax, "'to' is missing here", "as in connect box1 to box2 curved");
  c.space();
  const std::string_view second = c.peek_word();
  if (!values(k).object(b)) return false;
  if (a == b) return c.fail(ErrorCode::name, "an object cannot be connected to itself", second);
  Link link;
  while (!c.at_line_end()) {
    const std::string_view word = c.next_word();
    if (std::find(routes.begin(), routes.end(), word) != routes.end()) {
      link.route = word;
    } else if (word == "as") {
      link.name = c.next_word();
      if (link.name.empty())
        return c.fail_here(ErrorCode::syntax, "a name is missing here", "as in connect a to b as way");
    } else if (word == "label" && c.accept('=')) {
      const char* const written = c.at;
      if (!c.text(link.label)) return false;
      translate_text(script, link.label, c.since(written));
    } else if (word == "arrow" && c.accept('=')) {
      const std::string_view said = c.next_word();
      if (said != "on" && said != "off") return no_choice(c, said, "arrow is on or off");
      link.arrow = said == "on";
    } else {
      return no_choice(c, word, "expected straight, curved, angled, as NAME, label=\"…\" or arrow=off",
                       did_you_mean(word, {routes.begin(), routes.end()}));
    }
  }
  if (!finish(c)) return false;
  if (!find_end(k, a, first, link.from) || !find_end(k, b, second, link.to)) return false;
  link.color = theme_color(s, &Theme::muted), link.label_color = theme_color(s, &Theme::label);
  if (link.name.empty()) link.name = link.from.name + "-" + last_of(link.to.name);
  std::string lines = lines_of_link(link);
  if (time)
    lines +=
        fmt::format("at {} draw {} for {}\n", write_time(*time, s.rate), link.name, write_seconds(from_seconds(0.5)));
  return all_or_none(k, lines, first);
}

constexpr Verb connecting_rows[] = {
    {"connect", "[at TIME] connect A to B [straight|curved|angled] [label=\"…\"] [arrow=off] [as NAME]",
     "Draws a line from A to B that follows both; with a time it is drawn then. Its name is A-B.",
     "create a rectangle position=(-3 0)\ncreate b circle position=(3 1)\nconnect a to b curved", Verb::timed, connect,
     "OBJECT; to; OBJECT; straight curved angled as…"},
};

}  // namespace

std::optional<LinkEnd> end_of_link(const Scene& s, const Measured& m) {
  const Object& o = s.objects[m.id.index];
  const auto inward = inverse(m.world);
  const double wide = length(transform_vector(m.world, {1, 0, 0})), high = length(transform_vector(m.world, {0, 1, 0}));
  if (!m.any || !inward || !(wide > 0) || !(high > 0)) return std::nullopt;
  const bool is_round =
      o.kind == Kind::sphere || o.kind == Kind::disc || o.kind == Kind::ring || o.kind == Kind::regular;
  return LinkEnd{o.name, transform_point(*inward, m.middle()), 0.5 * m.size().x / wide,
                 is_round ? 0 : 0.5 * m.size().y / high};
}

double half_of_label(const std::string& text) {
  const auto letters = static_cast<double>(std::count_if(text.begin(), text.end(), begins_character));
  return std::round(0.3 * 24 * letters) / 100;
}

std::string lines_of_link(const Link& l) {
  const double tip = l.tip();
  std::string out = fmt::format("create {} polyline width={} color={}\n", l.name, write_number(l.width), l.color);
  out += fmt::format("set {}.points = \"link.points({}, {}, '{}', {}, {})\"\n", l.name, end_in_code(l.from),
                     end_in_code(l.to), l.route, write_number(l.gap), write_number(tip));
  if (l.arrow) {
    out += fmt::format("create {}/tip polygon points=(({} 0) (0 {}) (0 {})) color={}\n", l.name, write_number(tip),
                       write_number(0.5 * tip), write_number(-0.5 * tip), l.color);
    out += fmt::format("set {0}/tip.position = \"link.tip('{0}')\"\nset {0}/tip.rotation.z = \"link.turn('{0}')\"\n",
                       l.name);
  }
  if (!l.label.empty()) {
    out += fmt::format("create {}/label text text={} size=0.24 color={}\n", l.name, write_text(l.label), l.label_color);
    const bool usual = l.beside.at == 0.5 && l.beside.side == LinkSide::above;
    out += fmt::format("set {0}/label.position = \"link.middle('{0}', {1}{2}) - vec(0, 0.086)\"\n", l.name,
                       write_number(half_of_label(l.label)),
                       usual ? ""
                             : fmt::format(", {}, '{}'", write_number(l.beside.at),
                                           link_sides[static_cast<std::size_t>(l.beside.side)]));
  }
  return out;
}

std::span<const Verb> connecting_verbs() { return connecting_rows; }

}  // namespace betwixt
