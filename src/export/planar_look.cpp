// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/planar_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "betwixt/object.h"
#include "export/fit.h"
#include "export/joined_lines.h"
#include "export/planar_watch.h"
#include "export/seen.h"
#include "scene/functions.h"
#include "scene/kinds.h"
#include "track/track.h"

namespace betwixt {
namespace {

// A sample that is kept: the look is linear from it to the next kept one, or held until then.
struct PlanarKey {
  std::size_t look;
  bool goes_on;
};
// `off(a, k, b)`: the distance of sample k from the linear blend of a and b; below 0: there is no such blend.
template <class Off>
std::vector<PlanarKey> needed(const PlanarLooks& looks, double tolerance, Off off) {
  constexpr std::size_t longest = 100;
  const auto straight = [&](std::size_t a, std::size_t b) {
    if ((looks[b].jumps && b == a + 1) || b - a > longest) return false;
    for (std::size_t k = a + 1; k <= b; ++k)
      if (const double o = off(a, k, b); o < 0 || o > tolerance) return false;
    return true;
  };
  std::vector<PlanarKey> out;
  for (std::size_t i = 0; i < looks.size();) {
    std::size_t end = i;
    while (end + 1 < looks.size() && straight(i, end + 1)) ++end;
    out.push_back({i, end > i});
    i = std::max(end, i + 1);
  }
  return out;
}
double share_between(const PlanarLooks& looks, std::size_t a, std::size_t k, std::size_t b) {
  return (looks[k].time - looks[a].time).seconds() / (looks[b].time - looks[a].time).seconds();
}

using Parts = std::vector<DrawnPart> PlanarDrawn::*;

bool same(const PlanarForm& a, const PlanarForm& b) {
  return std::equal(
      a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
      [](const DrawnPart& p, const DrawnPart& q) { return p.closed == q.closed && p.points == q.points; });
}
// Removes forms that repeat the one before, except before a change.
void thin_out(PlanarForms& forms) {
  PlanarForms kept;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (!kept.empty() && same(kept.back(), forms[i])) {
      kept.back().goes_on = false;
      const bool leaves = forms[i].goes_on && i + 1 < forms.size() && !same(forms[i], forms[i + 1]);
      if (!leaves) continue;
    }
    kept.push_back(std::move(forms[i]));
  }
  forms = std::move(kept);
}

// Returns the contours `parts` of the drawing.
PlanarForms forms_of(const PlanarLooks& looks, Parts parts, double tolerance) {
  const auto off = [&](std::size_t a, std::size_t k, std::size_t b) -> double {
    const auto &p = looks[a].drawn, &q = looks[b].drawn, &there = looks[k].drawn;
    if (!p || !q || !there) return p == q && q == there ? 0 : -1;
    if (!goes_over(*p, *q) || !goes_over(*p, *there)) return -1;
    return off_between(*p, *q, share_between(looks, a, k, b), *there);
  };
  PlanarForms out;
  bool any = false;
  for (const PlanarKey& s : needed(looks, tolerance, off)) {
    PlanarForm form{looks[s.look].time, s.goes_on, {}};
    if (looks[s.look].drawn) form.parts = (*looks[s.look].drawn).*parts;
    any = any || !form.parts.empty();
    out.push_back(std::move(form));
  }
  thin_out(out);
  return any ? out : PlanarForms{};
}

// Fits linear pieces to numbers of the samples.
template <class At>
Channel channel_of(const PlanarLooks& looks, const ExportOptions& options, std::size_t width, double tolerance, At at) {
  std::vector<KeyValue> values;
  std::optional<KeyValue> last;
  for (const SeenThen& l : looks)
    if (l.drawn && !last) last = at(*l.drawn);
  for (const SeenThen& l : looks) values.push_back(*(last = l.drawn ? at(*l.drawn) : last.value_or(KeyValue{})));
  const auto off = [&](std::size_t a, std::size_t k, std::size_t b) {
    const double s = share_between(looks, a, k, b);
    double most = 0;
    for (std::size_t i = 0; i < width; ++i)
      most = std::max(most, std::abs((1 - s) * values[a][i] + s * values[b][i] - values[k][i]));
    return most;
  };
  Channel out{width, false, {}};
  const std::vector<PlanarKey> said = needed(looks, tolerance, off);
  for (std::size_t i = 0; i < said.size(); ++i) {
    const KeyValue& begin = values[said[i].look];
    const bool last_one = i + 1 == said.size();
    const Time until = last_one ? std::max(options.until, looks[said[i].look].time) : looks[said[i + 1].look].time;
    const KeyValue& end = said[i].goes_on ? values[said[i + 1].look] : begin;
    const auto shape = begin == end ? KeyPiece::held : KeyPiece::straight;
    if (!out.pieces.empty() && shape == KeyPiece::held && out.pieces.back().shape == KeyPiece::held &&
        out.pieces.back().begin == begin)
      out.pieces.back().until = until;
    else
      out.pieces.push_back({shape, looks[said[i].look].time, until, begin, end, {}, {}});
  }
  if (out.pieces.empty()) out.pieces.push_back({KeyPiece::held, options.from, options.until, {}, {}, {}, {}});
  return out;
}

// ---- The whole object

constexpr double line_tolerance = 1.0 / 4000;  // of the length over which a line is drawn on: half a pixel

double extent_of(const PlanarLooks& looks) {
  Box all;
  for (const SeenThen& l : looks)
    if (l.drawn)
      for (const DrawnPart& part : l.drawn->stroked)
        for (const Vec3 p : part.points) all.add(p);
  return all.empty() ? 0 : 2 * length(all.half());
}

// ---- Gradients

// Where stops are between two colours, so that a mixture of sRGB is within 2/255 of that of light: closer where a
// channel may be dark.
constexpr double steps_between[] = {0,   0.003, 0.01, 0.02, 0.035, 0.06, 0.09, 0.125, 0.18, 0.25, 0.36,
                                    0.5, 0.64,  0.75, 0.82, 0.875, 0.91, 0.94, 0.965, 0.98, 0.99, 0.997};

const Gradient* gradient_in(const PlanarDrawn& d, bool stroke) {
  if (!d.gradients) return nullptr;
  const Gradient& own = stroke ? d.gradients->stroke : d.gradients->fill;
  const bool as_filled = stroke && own.kind == GradientKind::none && !d.color;
  const Gradient& g = as_filled ? d.gradients->fill : own;
  return g.kind == GradientKind::none ? nullptr : &g;
}

KeyValue place_on_plane(const Gradient& g, const Box& box) {
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  const double x = (box.low.x + box.high.x) / 2 + g.move_x * width,
               y = (box.low.y + box.high.y) / 2 + g.move_y * height;
  const double circle = g.size * std::max(width, height) / 2;
  if (g.kind == GradientKind::circular) return {x, y, circle, circle};
  if (g.kind == GradientKind::radial) return {x, y, g.size * width / 2, g.size * height / 2};
  const auto [sine, cosine] = sine_cosine(g.turn);
  const double half = g.size * (width * std::abs(cosine) + height * std::abs(sine)) / 2;
  return {x - half * cosine, y - half * sine, x + half * cosine, y + half * sine};
}

// The colour between two stops, which are mixed by their opacities.
KeyValue between_stops(const Gradient::Stop& a, const Gradient::Stop& b, double s) {
  const double from = (1 - s) * a.opacity, to = s * b.opacity, opacity = from + to;
  const Vec3 light = opacity > 0 ? 1 / opacity * (from * a.color + to * b.color) : s < 0.5 ? a.color : b.color;
  const Color c = to_srgb(light);
  return {c.r, c.g, c.b, opacity};
}

// The mean of all colours, for drawings that cannot have the gradient.
Vec3 mean_color(const Gradient& g) {
  Vec3 sum;
  double opacity = 0;
  for (std::size_t i = 0; i < g.stops.size(); ++i) {
    const double from = i == 0 ? 0 : (g.stops[i - 1].at + g.stops[i].at) / 2;
    const double to = i + 1 == g.stops.size() ? 1 : (g.stops[i].at + g.stops[i + 1].at) / 2;
    sum = sum + (to - from) * g.stops[i].opacity * g.stops[i].color, opacity += (to - from) * g.stops[i].opacity;
  }
  return opacity > 0 ? 1 / opacity * sum : g.stops.front().color;
}

// Returns the gradient of the fill or of the stroke, if there is one all the time; `lost` if a drawing cannot have it.
std::optional<PlanarGradient> gradient_of(const PlanarLooks& looks, const ExportOptions& options, bool stroke,
                                          bool& lost) {
  const Gradient* one = nullptr;
  bool alike = true, any = false;
  for (const SeenThen& l : looks) {
    if (!l.drawn) continue;
    const Gradient* const g = gradient_in(*l.drawn, stroke);
    alike = alike && (!any || (g == nullptr) == (one == nullptr));
    any = true;
    if (g != nullptr && one != nullptr)
      alike = alike && g->kind == one->kind && g->spread == one->spread && g->stops.size() == one->stops.size();
    if (one == nullptr) one = g;
  }
  if (one == nullptr) return std::nullopt;
  if (!alike || one->kind == GradientKind::conic) return lost = true, std::nullopt;
  PlanarGradient out{one->kind, one->spread, {}, {}, {}};
  const double tolerance = options.keys.style == KeyStyle::baked ? 0 : options.keys.metres;
  out.place = channel_of(looks, options, 4, tolerance,
                         [&](const PlanarDrawn& d) { return place_on_plane(*gradient_in(d, stroke), d.gradient_box); });
  for (std::size_t i = 0; i < one->stops.size(); ++i) {
    const std::size_t next = std::min(i + 1, one->stops.size() - 1);
    for (const double s : std::span(steps_between).first(next > i ? std::size(steps_between) : 1)) {
      out.stops.push_back(channel_of(looks, options, 4, 1.0 / 512, [&](const PlanarDrawn& d) {
        const auto& stops = gradient_in(d, stroke)->stops;
        return between_stops(stops[i], stops[next], s);
      }));
      out.places.push_back(channel_of(looks, options, 1, 1e-4, [&](const PlanarDrawn& d) {
        const auto& stops = gradient_in(d, stroke)->stops;
        return KeyValue{(1 - s) * stops[i].at + s * stops[next].at, 0, 0, 0};
      }));
    }
  }
  return out;
}

class LookMaker {
 public:
  LookMaker(const Program& program, const ExportOptions& options, bool in_unit)
      : program_(program), options_(options), in_unit_(in_unit) {}

  PlanarLook look(ObjectId id, const Watched& w) const {
    const PlanarLooks& looks = w.looks;
    const double tolerance = options_.keys.style == KeyStyle::baked ? 0 : options_.keys.metres;
    PlanarLook out;
    out.color = planar_color(program_, options_, id), out.opacity = planar_opacity(program_, options_, id);
    out.filled = forms_of(looks, &PlanarDrawn::filled, tolerance);
    out.bordered = forms_of(looks, &PlanarDrawn::bordered, tolerance);
    bool own = false, trimmed = false, alone = !w.turns_out;
    for (const SeenThen& l : looks) {
      if (!l.drawn) continue;
      const PlanarDrawn& d = *l.drawn;
      own = own || d.color, out.round = out.round || d.round, out.hairline = out.hairline || d.hairline;
      trimmed = trimmed || d.from > 0 || d.to < 1 - 1e-12;
      alone = alone && !d.toward && d.from <= d.to;
    }
    out.width = channel_of(looks, options_, 1, tolerance, [](const PlanarDrawn& d) {
      return KeyValue{d.width, 0, 0, 0};
    });
    out.stroke = own ? channel_of(looks, options_, 3, 1.0 / 512, stroke_of) : out.color;
    const auto grade = [&](bool stroke, std::optional<PlanarGradient>& to, Channel& plain) {
      bool lost = false;
      to = gradient_of(looks, options_, stroke, lost);
      if (!lost) return;
      out.lost_gradient = true;
      plain = channel_of(looks, options_, 3, 1.0 / 512, [&](const PlanarDrawn& d) {
        const Gradient* const g = gradient_in(d, stroke);
        if (g == nullptr) return stroke_of(d);
        const Color c = to_srgb(mean_color(*g));
        return KeyValue{c.r, c.g, c.b, 0};
      });
    };
    grade(false, out.fill_gradient, out.color), grade(true, out.stroke_gradient, out.stroke);
    if (auto drawing = joined_lines(looks, line_tolerance * extent_of(looks))) {
      out.stroked = {{options_.from, false, {{drawing->line, false}}}};
      PlanarLooks times;
      for (std::size_t i = 0; i < looks.size(); ++i) {
        PlanarDrawn d;
        std::tie(d.from, d.to) = drawing->shares[i];
        times.push_back({looks[i].time, std::make_shared<const PlanarDrawn>(std::move(d)), looks[i].jumps});
      }
      out.trim = sampled_trim(times);
    } else {
      out.stroked = forms_of(looks, &PlanarDrawn::stroked, tolerance);
      if (trimmed) out.trim = alone ? said_trim(id) : sampled_trim(looks);
    }
    return out;
  }

 private:
  static KeyValue stroke_of(const PlanarDrawn& d) {
    const Color c = to_srgb(d.color.value_or(Vec3{}));
    return {c.r, c.g, c.b, 0};
  }
  PlanarTrim sampled_trim(const PlanarLooks& looks) const {
    const Channel both = channel_of(looks, options_, 2, 1e-5, [](const PlanarDrawn& d) {
      const double from = std::clamp(d.from, 0.0, 1.0);
      return KeyValue{from, std::clamp(d.to, from, 1.0), 0, 0};
    });
    return {planar_curves(both, 0, in_unit_), planar_curves(both, 1, in_unit_)};
  }
  PlanarTrim said_trim(ObjectId id) const {
    const FunctionId f = *find_built_in(kind(program_.document(), id), "trim");
    const Channel both = value_keys(program_, {id, f}, options_.from, options_.until, options_.keys);
    return {planar_curves(both, 0, in_unit_), planar_curves(both, 1, in_unit_)};
  }

  const Program& program_;
  const ExportOptions& options_;
  const bool in_unit_;
};

Channel shown_in(const StackPlace& place, const ExportOptions& options) {
  Channel out{1, false, {}};
  if (place.spans.empty()) return out;
  Time at = options.from;
  const auto add = [&](Time until, double v) {
    if (until > at) out.pieces.push_back({KeyPiece::held, at, until, {v}, {v}, {}, {}});
    at = std::max(at, until);
  };
  for (const auto& [from, until] : place.spans) add(from, 0), add(until, 1);
  add(options.until, 0);
  if (out.pieces.empty()) out.pieces.push_back({KeyPiece::held, at, at, {0}, {0}, {}, {}});
  return out;
}

std::string names_of(const Document& d, const std::vector<ObjectId>& ids) {
  constexpr std::size_t most = 6;
  std::string out;
  for (std::size_t i = 0; i < std::min(ids.size(), most); ++i)
    out += fmt::format("{}'{}'", out.empty() ? "" : ", ", d.name(ids[i]));
  return ids.size() > most ? fmt::format("{} and {} more", out, ids.size() - most) : out;
}

}  // namespace

Result<PlanarFilm> planar_film(const Program& program, const ExportOptions& options, Exported& made, bool in_unit) {
  const Document& document = program.document();
  PlanarFilm film;
  auto view = planar_view(program, options, in_unit);
  if (!view) return view.error();
  film.view = *std::move(view);
  std::vector<ObjectId> turned;
  auto motions = planar_motions(program, options, in_unit, &turned);
  if (!motions) return motions.error();
  PlanarWatch watch(program, options);
  for (const PlanarMotion& m : *motions) watch.add(m.id, std::find(turned.begin(), turned.end(), m.id) != turned.end());
  if (Status s = watch.run(); !s) return s.error();
  std::vector<PlanarDepths> depths;
  std::vector<ObjectId> textured, plain;
  std::map<std::string, std::vector<ObjectId>> undrawn;
  const LookMaker maker(program, options, in_unit);
  for (PlanarMotion& m : *motions) {
    Watched& w = watch.of(m.id);
    if (!w.no_drawing.empty()) undrawn[w.no_drawing].push_back(m.id);
    const bool seen = std::any_of(w.looks.begin(), w.looks.end(), [](const SeenThen& l) { return l.drawn != nullptr; });
    if (!seen) continue;
    if (w.textured) textured.push_back(m.id);
    depths.push_back(std::move(w.depths));
    PlanarLook look = maker.look(m.id, w);
    if (look.lost_gradient) plain.push_back(m.id);
    film.things.push_back({std::move(m), std::move(look)});
  }
  for (const auto& [what, ids] : undrawn) {
    if (film.things.empty())
      return fail(ErrorCode::range, fmt::format("'{}' is {}, which is not flat", document.name(ids[0]), what),
                  "name the objects to draw, or write glTF (.glb), which supports all objects");
    leave_out(made, fmt::format("left out, as {} is not flat: {}", what, names_of(document, ids)));
  }
  if (film.things.empty() && motions->empty())
    return fail(ErrorCode::range, "the film has no visible objects",
                "name the objects, as in betwixt export film.bx ball -o ball.css");
  if (!plain.empty())
    leave_out(made, "left out: conic gradients, and gradients that become another kind, of " +
                        names_of(document, plain) + "; their mean colours are used");
  if (!textured.empty()) leave_out(made, "left out: the textures of " + names_of(document, textured));
  const Frame first = program.frame(options.from);
  if (!first.surroundings.flat) leave_out(made, "left out: lighting; objects have their own colours");
  if (!first.surroundings.clear && !first.background)
    leave_out(made, "left out: the background, because the film sets none");
  leave_out_surroundings(program, options, false, made);
  bool whole = true;
  for (const StackPlace& place : stack_of(depths, options.until, whole)) {
    const bool again =
        std::any_of(film.order.begin(), film.order.end(), [&](const PlanarPlace& p) { return p.thing == place.thing; });
    film.order.push_back({place.thing, shown_in(place, options), !again});
  }
  if (!whole) leave_out(made, "left out: changes of the drawing order; it stays as at the beginning");
  made.objects = film.things.size();
  return film;
}

std::vector<Vec3> planar_background(const Program& program, const ExportOptions& options) {
  const Frame frame = program.frame(options.from);
  if (frame.surroundings.clear || !frame.background) return {};
  if (!frame.surroundings.below) return {*frame.background};
  constexpr int stops = 9;
  std::vector<Vec3> out;
  for (int i = 0; i < stops; ++i) {
    const double s = static_cast<double>(i) / (stops - 1);
    out.push_back((1 - s) * *frame.background + s * *frame.surroundings.below);
  }
  return out;
}

}  // namespace betwixt
