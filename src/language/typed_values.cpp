// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a value of each type: one row for each, as in track/types.
#include <fmt/format.h>

#include <algorithm>

#include "base/memory_budget.h"
#include "base/names.h"
#include "base/utf8.h"
#include "language/code_names.h"
#include "language/values.h"
#include "scene/gradient_stops.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

// The requested type, and the beginning of the value.
struct TypedReader {
  ValueReader& values;
  const FunctionSpec& spec;
  const int component;
  const FunctionId function;
  Cursor& c = values.c;
  const Type type = component < 0 ? spec.type : component_type(spec.type);
  const char* const start = (c.space(), c.at);

  bool number(Value& out) {
    double d = 0;
    if (spec.name == "f-stop" && c.accept_word("off")) return out = spec.rest, true;
    return values.scalar(d, spec.unit) && in_range(d) && (out = d, true);
  }
  bool angle(Value& out) {
    double d = 0;
    return values.angle(d) && (component >= 0 || in_range(d)) && (out = d, true);
  }
  bool vector(Value& out) {
    Vec3 v;
    const int n = component_count(type);
    // In the plane a place needs two numbers. The sides of a box are three.
    const bool open = spec.open || (spec.unit == Unit::metres && spec.name != "size");
    if (!values.vector(n, v, spec.unit, open)) return false;
    for (int i = 0; i < n; ++i)
      if (!in_range(v[i])) return false;
    out = v;
    return true;
  }
  bool truth(Value& out) {
    double number = 0;
    if (values.translates() && values.looks_like_number()) {  // 0 is off
      if (!values.scalar(number)) return false;
      out = number != 0;
      values.translate(start, number != 0 ? "on" : "off");
      return true;
    }
    const std::string_view w = c.word();
    if (w != "on" && w != "off") return wanted(w);
    out = w == "on";
    return true;
  }
  bool color(Value& out) {
    Color color = no_color;
    const bool none = component < 0 && spec.rest == Value(no_color) && c.accept_word("none");
    return (none || values.color(color)) && (out = color, true);
  }
  bool points(Value& out) {
    Points all;
    return (spec.name == "holes" ? values.holes(all) : values.points(all)) && (out = all, true);
  }
  bool rotation(Value& out) { return values.orientation(out, true); }
  bool orientation(Value& out) { return values.orientation(out, false); }
  bool shape(Value& out) {
    const std::string_view w = c.word();
    if (w == "none") return out = ObjectId{}, true;
    if (w != "shape") return wanted(w, "write shape(NAME), the geometry of another object, or none");
    ObjectId id;
    if (!c.open()) return false;
    const char* name = (c.space(), c.at);
    if (!values.object(id)) return false;
    if (const Kind kind = values.scene.objects[id.index].kind; !drawable(kind))
      return c.fail(ErrorCode::type, fmt::format("{} has no geometry", a_kind(kind)), c.since(name));
    out = id;
    return c.close();
  }
  // A distance is stored as a point at that distance before the camera, in the camera's space.
  bool focus(Value& out) {
    double far = 0;
    if (c.peek() == '(') return c.fail_here(ErrorCode::type, "expected a distance or the name of an object here");
    if (!values.looks_like_number()) return false;
    if (!values.scalar(far, spec.unit)) return false;
    if (!(far > 0 && far <= 1e12))
      return c.fail(ErrorCode::range, "a focus distance must be greater than 0 m and at most 1e12 m", c.since(start));
    return out = Vec3{0, 0, -far}, true;
  }
  bool aim(Value& out) {
    Vec3 v;
    ObjectId id;
    if (spec.name == "focus") {
      if (focus(out)) return true;
      if (c.error) return false;
      if (c.at_line_end()) return c.fail_here(ErrorCode::syntax, "a distance or the name of an object is missing here");
    }
    if (c.peek() == '(') return values.vector(3, v, spec.unit) && (out = v, true);
    if (c.accept_word("none")) return out = id, true;
    if (c.at_line_end())
      return c.fail_here(ErrorCode::syntax, "a point (x y z) or the name of an object is missing here");
    return values.object(id) && (out = id, true);
  }
  bool text(Value& out) {
    std::string s;
    const auto named = c.peek() == '"' ? std::nullopt : values.let<Text>();
    if (c.error) return false;
    if (named) {
      s = **named;
    } else if (spec.written == "\"FORMULA\"" && values.scene.names.find(c.peek_word())) {
      s = c.word();  // the name of a plot
    } else if (spec.words.empty() && (values.looks_like_number() || formula_begins(c))) {
      double number = 0;  // its digits
      if (!values.scalar(number)) return false;
      s = fmt::format("{:.12g}", number);                // not 1.7000000000000002
    } else if (spec.words.empty() || c.peek() == '"') {  // a word may also be in quotes
      if (!c.text(s)) return false;
      if (spec.name == "tex" && !is_formula(c.since(start))) return false;
    } else {
      s = c.word();
    }
    // A formula that is one word may be the name of a plot.
    if (spec.written == "\"FORMULA\"" && !values.scene.names.find(s.substr(0, s.find('\''))))
      s = with_values(s, c.lets, c.place);
    if (!spec.words.empty() && !is_choice(s)) return false;
    if (spec.name.ends_with("gradient-stops") && !s.empty() && !are_stops(s)) return false;
    if (spec.name == "text" && s.size() > most_letters && count_characters(s) > most_letters)
      return c.fail(ErrorCode::range, fmt::format("a text can have at most {} letters", most_letters),
                    std::string_view(start, 1));
    if (values.file && !values.file(function, s, c.since(start))) return false;
    MemoryBudget::charge(s.size());
    out = Text(std::move(s));
    return true;
  }
  // The error is about the wrong one of the stops, as it is written.
  bool are_stops(const std::string& s) {
    std::string_view wrong;
    auto stops = read_stops(s, &wrong);
    if (stops) return true;
    std::string_view written = c.since(start);
    if (written.size() == s.size() + 2 && written.substr(1, s.size()) == s)
      written =
          written.substr(1 + static_cast<std::size_t>(wrong.data() - s.data()), std::max<std::size_t>(wrong.size(), 1));
    return c.fail(stops.error(), written);
  }
  // Fails for a formula that has a tab or a new line because of a single backslash, as in "\times".
  bool is_formula(std::string_view written) {
    if (written.starts_with("\"\"\"")) return true;
    for (std::size_t i = 0; i + 2 < written.size(); ++i) {
      if (written[i] != '\\') continue;
      const bool word = std::isalpha(static_cast<unsigned char>(written[i + 2]));
      if ((written[i + 1] == 't' || written[i + 1] == 'n') && word) {
        const std::string_view from = written.substr(i);
        return c.fail(ErrorCode::syntax, "a single backslash makes a tab or a new line here", from.substr(0, 2),
                      hint_of_escape(from));
      }
      ++i;  // what follows the backslash
    }
    return true;
  }
  bool attachment(Value& out) {
    static constexpr std::string_view words[] = {"detach", "letgo", "hang", "attach", "couple"};
    const std::string_view w = c.word();
    const auto at = std::find(std::begin(words), std::end(words), w);
    if (at == std::end(words)) return wanted(w, "write couple to NAME, attach to NAME, hang on NAME, detach or letgo");
    Attachment a{static_cast<AttachmentKind>(at - std::begin(words)), {}, false};
    if (a.kind >= AttachmentKind::hang) {
      const std::string_view link = a.kind == AttachmentKind::hang ? "on" : "to";
      if (!c.accept_word(link)) return c.fail_here(ErrorCode::syntax, fmt::format("'{}' is missing here", link));
      c.space();
      if (!values.object(a.parent)) return false;
      a.keep_world = c.accept_word("keep-world");
    }
    out = a;
    return true;
  }
  bool transform(Value& out) {
    Mat4 m;
    return values.transform(m) && (out = Matrix(m), true);
  }
  // Reads a type that has a reader of its own.
  template <class T, bool (ValueReader::*read)(T&)>
  bool plainly(Value& out) {
    T v;
    return (values.*read)(v) && (out = std::move(v), true);
  }

  bool wanted(std::string_view instead, std::string_view hint = {}) {
    return c.fail(ErrorCode::type, fmt::format("expected {} here", to_string(type)),
                  instead.empty() ? std::string_view(start, 0) : instead, std::string(hint));
  }
  bool in_range(double d) {
    if (d >= spec.low && d <= spec.high) return true;
    const double limit = d < spec.low ? spec.low : spec.high;
    return c.fail(ErrorCode::range,
                  fmt::format("{} must be at {} {}", spec.name, d < spec.low ? "least" : "most",
                              row_of(type).angles ? fmt::format("{:.4g}deg", limit * 180 / pi) : write_number(limit)),
                  c.since(start), function == fn::fov ? "the angle of view of a camera must be less than 180deg" : "");
  }
  Hint hint_for(const std::string& s, const std::vector<std::string_view>& words) const {
    for (const OtherWord& other : spec.instead)
      if (other.word == s) return std::string(other.leads);
    return did_you_mean(s, words);
  }
  bool is_choice(const std::string& s) {
    const auto words = choices(spec);
    if (std::find(words.begin(), words.end(), s) != words.end()) return true;
    std::string all;
    for (auto w : words) all += (all.empty() ? "" : w == words.back() ? " or " : ", ") + std::string(w);
    const std::string_view about = s.empty() ? std::string_view(start, 0) : c.since(start);
    constexpr std::size_t most_listed = 12;
    if (words.size() <= most_listed)
      return c.fail(ErrorCode::type, fmt::format("{} must be {}", spec.name, all), about, hint_for(s, words));
    const Hint near = did_you_mean(s, words);
    return c.fail(ErrorCode::type, fmt::format("there is no {} '{}'", spec.name, s.substr(0, 60)), about,
                  near.empty() ? fmt::format("{} is {}", spec.name, all) : near);
  }
};

struct TypeReaderRow {
  Type type;
  bool (TypedReader::*read)(Value& out);
};
using Typed = TypedReader;
constexpr TypeReaderRow readers[] = {
    {Type::scalar, &Typed::number},
    {Type::angle, &Typed::angle},
    {Type::pair, &Typed::vector},
    {Type::vector, &Typed::vector},
    {Type::color, &Typed::color},
    {Type::boolean, &Typed::truth},
    {Type::rotation, &Typed::rotation},
    {Type::orientation, &Typed::orientation},
    {Type::shape, &Typed::shape},
    {Type::aim, &Typed::aim},
    {Type::text, &Typed::text},
    {Type::points, &Typed::points},
    {Type::names, &Typed::plainly<Names, &ValueReader::names>},
    {Type::attachment, &Typed::attachment},
    {Type::transform, &Typed::transform},
    {Type::motion, &Typed::plainly<Moves, &ValueReader::motion>},
};
consteval bool readers_in_order() {
  for (std::size_t i = 0; i < std::size(readers); ++i)
    if (readers[i].type != static_cast<Type>(i)) return false;
  return true;
}
static_assert(readers_in_order());

}  // namespace

bool ValueReader::value(const FunctionSpec& spec, int component, Value& out, FunctionId f) {
  TypedReader wanted{*this, spec, component, f};
  return (wanted.*readers[static_cast<std::size_t>(wanted.type)].read)(out);
}

}  // namespace betwixt
