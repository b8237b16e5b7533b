// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/seen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "betwixt/evaluation.h"
#include "betwixt/object.h"
#include "exchange/geometry.h"
#include "export/fit.h"
#include "program/compiled.h"
#include "scene/patterns.h"

namespace betwixt {
namespace {

// Other programs do not have the patterns: they show their mean.
std::pair<std::shared_ptr<const Finish>, Vec3> without_pattern(std::shared_ptr<const Finish> finish, Vec3 color) {
  if (!finish || finish->pattern == Pattern::none) return {std::move(finish), color};
  const PatternPoint mean = mean_of_pattern(*finish, color);
  Finish even = *finish;  // its pattern stays, so that writers can say what they leave out
  even.roughness = mean.roughness, even.metalness = mean.metalness;
  return {std::make_shared<const Finish>(even), mean.color};
}

constexpr std::size_t most_triangles = 20'000'000, usual_triangles = 4'000'000;
constexpr std::size_t most_points = 1'000'000, fewest_forms = 24, most_forms = 600;  // of one object

class Watch {
 public:
  Watch(const Program& program, const ExportOptions& options, const std::function<bool(const Skin&)>& as_skin)
      : program_(program), options_(options) {
    for (const Skin& skin : program.compiled().skins) as_skin_.push_back(as_skin && as_skin(skin));
  }

  Status look(const Evaluation& e, Time t) {
    for (const std::uint32_t i : e.changed()) {
      const ObjectId id = e.drawables()[i];
      const Evaluation::Look& look = e.looks()[i];
      if (!look.visible) {
        if (const auto known = at_.find(id.index); known != at_.end()) seen(all_[known->second], t, -1);
        continue;
      }
      const auto [place, fresh] = at_.try_emplace(id.index, all_.size());
      if (fresh) {
        all_.emplace_back();
        all_.back().id = id;
        known_.emplace_back();
        if (t > options_.from) all_.back().when.push_back({options_.from, -1});
      }
      Seen& s = all_[place->second];
      if (s.forms.empty()) {
        s.material = look.material, s.shininess = look.shininess;
        if (look.texture != Evaluation::Look::none) s.texture = e.texture(look.texture);
        if (look.gradients != Evaluation::Look::none) graded_ = true;
        s.video = program_.compiled().drawables[i].video >= 0;
        if (look.finish != Evaluation::Look::none)
          std::tie(s.finish, s.own_color) = without_pattern(e.finish(look.finish), look.color);
      }
      const Shape& shape = *e.shape(look.shape);
      const std::int32_t skin = program_.compiled().drawables[i].skin;
      const bool rests = skin >= 0 && as_skin_[static_cast<std::size_t>(skin)];
      const Geometry g = rests ? Geometry{program_.compiled().skins[static_cast<std::size_t>(skin)].rest, {}}
                         : look.toward == Evaluation::Look::none
                             ? realise(shape)
                             : realise_blend(shape, *e.shape(look.toward), look.blend);
      if (rests) s.skin = skin;
      if (Status ok = add(s, known_[place->second], t, g); !ok) return ok;
    }
    return Nothing{};
  }

  // A shape that is only scaled is one form.
  std::vector<Seen> finish(Exported& made) {
    if (graded_) leave_out(made, "gradients are left out: objects have their plain colours");
    for (Seen& s : all_) {
      s.color = value_keys(program_, {s.id, fn::color}, options_.from, options_.until, options_.keys);
      s.opacity = value_keys(program_, {s.id, fn::transparency}, options_.from, options_.until, options_.keys);
      for (KeyPiece& p : s.opacity.pieces) {
        p.begin[0] = 1 - p.begin[0], p.end[0] = 1 - p.end[0];
        p.leaving[0] = -p.leaving[0], p.arriving[0] = -p.arriving[0];
      }
      const bool one =
          std::all_of(s.forms.begin(), s.forms.end(), [&](const Seen::Form& f) { return f.mesh == s.forms[0].mesh; });
      if (one && s.forms.size() > 1) stretch(s);
      if (s.forms.size() > 1) thin_out(s);
      if (s.forms.size() > 1)
        leave_out(made, fmt::format("the shape of {} changes, so it becomes {} meshes, one after the other",
                                    program_.document().name(s.id), s.forms.size()));
    }
    return std::move(all_);
  }

 private:
  static void seen(Seen& s, Time t, int form) {
    if (s.when.empty() || s.when.back().form != form) s.when.push_back({t, form});
  }

  // The forms that an object has had; of a new one, only each n-th is kept.
  struct Known {
    std::map<std::pair<const Mesh*, std::array<double, 16>>, int> forms;
    std::size_t each = 1, left_out = 0;
  };

  Status add(Seen& s, Known& known, Time t, const Geometry& g) {
    if (g.mesh->triangles.empty() && g.mesh->edges.empty()) {
      if (!s.when.empty())
        seen(s, t, -1);
      else
        s.when.push_back({t, -1});
      return Nothing{};
    }
    auto place = known.forms.find({g.mesh.get(), g.local.m});
    if (place == known.forms.end()) {
      if (!s.forms.empty() && ++known.left_out < known.each) {
        seen(s, t, static_cast<int>(s.forms.size()) - 1);
        return Nothing{};
      }
      known.left_out = 0;
      place = known.forms.emplace(std::pair{g.mesh.get(), g.local.m}, static_cast<int>(s.forms.size())).first;
      if (s.forms.empty() || s.forms.back().mesh != g.mesh) triangles_ += g.mesh->triangles.size() / 3;
      s.forms.push_back({g.mesh, g.local});
    }
    seen(s, t, place->second);
    if (triangles_ > thin_at_) thin_largest();
    if (triangles_ > most_triangles)
      return fail(ErrorCode::range,
                  fmt::format("the visible objects need more than {} million triangles", most_triangles / 1'000'000),
                  "choose fewer frames: --frames 1f..24f");
    return Nothing{};
  }

  static std::size_t triangles(const Seen& s) {
    std::size_t all = 0;
    const Mesh* last = nullptr;
    for (const Seen::Form& f : s.forms)
      if (f.mesh.get() != std::exchange(last, f.mesh.get())) all += f.mesh->triangles.size() / 3;
    return all;
  }

  // Keeps every second form of the objects with the most triangles until the film is of a usual size.
  void thin_largest() {
    std::vector<std::size_t> sizes(all_.size());
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (all_[i].forms.size() > fewest_forms) sizes[i] = triangles(all_[i]);
    while (triangles_ > usual_triangles) {
      const auto largest = std::max_element(sizes.begin(), sizes.end());
      if (*largest == 0) break;
      const auto i = static_cast<std::size_t>(largest - sizes.begin());
      Seen& s = all_[i];
      keep_each(s, 2);
      Known& known = known_[i];
      known.each *= 2, known.forms.clear();
      for (const Seen::Form& f : s.forms)
        known.forms.emplace(std::pair{f.mesh.get(), f.local.m}, static_cast<int>(known.forms.size()));
      const std::size_t left = triangles(s);
      triangles_ -= *largest - left;
      *largest = s.forms.size() > fewest_forms && left < *largest ? left : 0;
    }
    thin_at_ = std::max(usual_triangles, triangles_) + usual_triangles / 2;
  }

  // A shape that grows would be too large with all its frames: each n-th form is used up to the next.
  static void thin_out(Seen& s) {
    std::size_t largest = 1;
    for (const Seen::Form& f : s.forms) largest = std::max(largest, f.mesh->positions.size());
    const std::size_t most = std::clamp(most_points / largest, fewest_forms, most_forms);
    const std::size_t step = (s.forms.size() + most - 1) / most;
    if (step > 1) keep_each(s, step);
  }

  // Keeps each n-th form, the middle one of its n.
  static void keep_each(Seen& s, std::size_t step) {
    std::vector<Seen::Form> forms;
    for (std::size_t i = 0; i < s.forms.size(); i += step)
      forms.push_back(s.forms[std::min(i + step / 2, s.forms.size() - 1)]);
    s.forms = std::move(forms);
    std::vector<Seen::From> when;
    for (Seen::From w : s.when) {
      if (w.form >= 0) w.form /= static_cast<int>(step);
      if (when.empty() || when.back().form != w.form) when.push_back(w);
    }
    s.when = std::move(when);
  }

  void stretch(Seen& s) {
    const auto& compiled = program_.compiled();
    Vec3 last{1, 1, 1};
    const Followed f = followed(program_.document(), 3, options_.keys.metres, [&](Time t) -> KeyValue {
      Asking asking;
      const Shape shape = compiled.shape(s.id.index, t, nullptr, asking);
      if (const Geometry g = realise(shape); !g.mesh->triangles.empty())
        last = {g.local(0, 0), g.local(1, 1), g.local(2, 2)};
      return {last.x, last.y, last.z, 0};
    });
    const auto knots =
        knots_between(program_.discontinuities(options_.from, options_.until), options_.from, options_.until);
    s.stretch = follow(f, knots, options_.keys);
    s.forms.resize(1);
    s.forms[0].local = {};
    std::vector<Seen::From> when;
    for (Seen::From w : s.when)
      if (w.form = std::min(w.form, 0); when.empty() || when.back().form != w.form) when.push_back(w);
    s.when = std::move(when);
  }

  const Program& program_;
  const ExportOptions& options_;
  std::vector<bool> as_skin_;  // by skin
  bool graded_ = false;        // whether an object has a gradient
  std::vector<Seen> all_;
  std::vector<Known> known_;  // by index into all_
  std::unordered_map<std::uint32_t, std::size_t> at_;
  std::size_t triangles_ = 0, thin_at_ = usual_triangles + usual_triangles / 2;
};

}  // namespace

std::vector<Time> looks_of(const Program& program, Time from, Time until) {
  const Rate rate = program.document().rate();
  std::vector<Time> all = program.discontinuities(from, until);
  const double first = std::ceil(rate.frame_number(from));
  for (double n = first; rate.frame(n) <= until; ++n) all.push_back(rate.frame(n));
  all.push_back(from);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::erase_if(all, [&](Time t) { return t < from; });
  return all;
}

void leave_out(Exported& made, std::string sentence) {
  if (std::find(made.left_out.begin(), made.left_out.end(), sentence) == made.left_out.end())
    made.left_out.push_back(std::move(sentence));
}

bool is_asked(ObjectId id, const std::vector<ObjectId>& asked) {
  return asked.empty() || std::find(asked.begin(), asked.end(), id) != asked.end();
}

void keep_asked(std::vector<ObjectKeys>& all, const std::vector<ObjectId>& asked) {
  if (asked.empty()) return;
  std::unordered_map<std::uint32_t, ObjectId> above;
  for (const ObjectKeys& k : all) above[k.id.index] = k.parent;
  std::set<std::uint32_t> kept;
  for (ObjectId id : asked)
    while (id && kept.insert(id.index).second) id = above[id.index];
  std::erase_if(all, [&](const ObjectKeys& k) { return !kept.contains(k.id.index); });
}

// Adds a sentence for each part of the surroundings that no file of motion holds.
void leave_out_surroundings(const Program& program, const ExportOptions& options, bool background, Exported& made) {
  const std::vector<ObjectId> all = objects(program.document());
  const auto any = [&](Kind k) {
    return std::any_of(all.begin(), all.end(), [&](ObjectId id) { return kind(program.document(), id) == k; });
  };
  std::set<std::string_view> there;
  for (const double share : {0.0, 0.5, 1.0}) {
    const Frame frame = program.frame(
        {options.from.flicks + std::llround(share * static_cast<double>((options.until - options.from).flicks))});
    const Surroundings& s = frame.surroundings;
    const auto add = [&](bool is, std::string_view what) {
      if (is) there.insert(what);
    };
    const bool seen = !frame.items.empty(), lit = seen && !s.flat;
    const bool casts = frame.lights.empty() || std::any_of(frame.lights.begin(), frame.lights.end(),
                                                           [](const Light& l) { return l.casting != Casting::off; });
    add(background && (frame.background || s.below), "background"), add(s.fog.has_value(), "fog"), add(s.sky, "sky");
    add(s.ground.has_value(), "ground"), add(lit && frame.lights.empty(), "light");
    add(lit, "ambient"), add(lit && casts, "shadows"), add(lit && s.contact, "contact"),
        add(s.exposure != 0, "exposure");
    add(frame.camera.shutter > 0, "blur"), add(frame.camera.aperture > 0, "focus");
    add(!(s.grade == Grade()), "grade"), add(!frame.layers.empty(), "groups"), add(frame.change.has_value(), "changes");
  }
  if (any(Kind::sound)) there.insert("sounds");
  if (!program.document().notes(options.from, options.until).empty()) there.insert("notes");
  if (any(Kind::text)) there.insert("texts");
  constexpr std::pair<std::string_view, std::string_view> sentences[] = {
      {"background", "the background is left out"},
      {"fog", "fog is left out"},
      {"sky", "the sky and its light are left out"},
      {"ground", "the ground is left out"},
      {"light", "the film has no lights; Betwixt's default light is left out"},
      {"ambient", "ambient light is left out"},
      {"shadows", "shadows are left out; the program that reads the file may make its own"},
      {"contact", "contact shading is left out"},
      {"exposure", "the exposure is left out"},
      {"blur", "motion blur (shutter) is left out"},
      {"focus", "depth of field (aperture) is left out"},
      {"grade", "view, white balance, bloom, vignette and grain are left out"},
      {"groups", "opacity, blend, mask, blur, glow and shadow of groups are left out"},
      {"changes", "changes from one camera to the next become cuts"},
      {"sounds", "sounds are left out"},
      {"notes", "notes are left out"},
      {"texts", "texts are written as shapes and cannot be edited as texts"},
  };
  for (const auto& [what, sentence] : sentences)
    if (there.contains(what)) leave_out(made, std::string(sentence));
}

Result<std::vector<Seen>> all_seen(const Program& program, const ExportOptions& options, Exported& made,
                                   const std::function<bool(const Skin&)>& as_skin) {
  Watch watch(program, options, as_skin);
  leave_out_surroundings(program, options, true, made);
  Evaluation e(program);
  const std::vector<Time> looks = looks_of(program, options.from, options.until);
  std::optional<Time> next = options.from;  // nothing differs before it
  for (std::size_t i = 0; i < looks.size() && next; ++i) {
    if (options.keys.go_on && i % 64 == 0 &&
        !options.keys.go_on(static_cast<double>(i) / static_cast<double>(looks.size())))
      return fail(ErrorCode::machine, "stopped");
    if (looks[i] < *next) continue;
    e.to(looks[i]);
    if (Status s = watch.look(e, looks[i]); !s) return s.error();
    next = program.next_change(looks[i]);
  }
  return watch.finish(made);
}

}  // namespace betwixt
