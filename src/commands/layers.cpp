// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that add layers of motion.
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "commands/verbs.h"

namespace betwixt {
namespace {

bool layer(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view word = c.next_word();
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "a name is missing here");
  if (!free_name(k, std::string(word), word)) return false;
  const std::string_view mode = c.next_word();
  if (mode != "add" && mode != "mix")
    return no_choice(c, mode, mode.empty() ? "add or mix is missing here" : "the mode of a layer must be add or mix",
                     "add adds its values on top; mix blends to them by its weight");
  Object object;
  object.name = word;
  object.kind = Kind::layer;
  object.slot(fn::mode).set = Text(std::string(mode));
  if (!parameters(k, object)) return false;
  add_object(s, std::move(object));
  return true;
}

bool on_layer(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view word = c.next_word();
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "the name of a layer is missing here");
  const ObjectId id = s.names.find(word);
  c.space();
  const std::string_view next = c.peek_word();
  // The rows of its sheet would have no destination.
  if (!time && first_dot(next) != std::string_view::npos) script.sheet.open = script.sheet.broken = true;
  if (!id) {
    std::vector<std::string_view> layers;
    for (std::size_t i = 0; i < s.objects.size(); ++i)
      if (s.objects[i].kind == Kind::layer && !s.objects[i].removed) layers.push_back(s.objects[i].name);
    const Hint near = did_you_mean(word, layers);
    return c.fail(
        unknown_name("layer", word, near.empty() ? fmt::format("to make one: layer {} add", word.substr(0, 40)) : near),
        word);
  }
  if (s.objects[id.index].kind != Kind::layer)
    return c.fail(ErrorCode::type, fmt::format("'{}' is not a layer", word), word,
                  fmt::format("to make one: layer NAME add"));
  if (layer) return c.fail(ErrorCode::syntax, "a command can have only one layer", word);
  c.space();
  if (c.at_line_end())
    return c.fail_here(ErrorCode::syntax, "a command is missing here", "as in on sway set ball.position (0 1 0)");
  const std::string_view verb = c.peek_word();
  const Verb* known = find_verb(verb);
  if (verb.find('.') == std::string_view::npos && !(known && known->flags & Verb::layered)) return on_no_layer(c, verb);
  Command layered{s, c, time, id, script};
  if (time && verb.find('.') != std::string_view::npos) {  // at T on LAYER TARGET VALUE
    const std::string_view w = c.next_word();
    return to_each_type(layered, w, w.data(), [&](const Selected& to) { return event(layered, to, *layered.time); });
  }
  return carry_out(layered);
}

constexpr Verb layers_rows[] = {
    {"layer", "layer NAME add|mix [weight=1]",
     "An animation layer on top of the objects' own motion: `add` adds its values, `mix` blends over to them. Its "
     "weight, 0 to 1, can be animated.",
     "layer sway add weight=0.5", Verb::makes_thing, layer, "NEW; add mix"},
    {"on", "on LAYER COMMAND, or on LAYER TARGET to open a sheet", "Runs a command on a layer.",
     "layer sway add\non sway at 12f ball.position (0 1 0)", Verb::timed | Verb::prefix, on_layer, "LAYER"},
};

}  // namespace

bool on_no_layer(Cursor& c, std::string_view verb) {
  return c.fail(ErrorCode::syntax, fmt::format("'{}' cannot be used on a layer", verb.substr(0, 40)), verb,
                "a layer can have events, set, show, hide, filters and track operations");
}

std::span<const Verb> layers_verbs() { return layers_rows; }

}  // namespace betwixt
