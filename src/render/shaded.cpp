// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The style `shaded`: shadow maps, then opaque surfaces, the background, transparent surfaces, and the picture.
#include <algorithm>

#include "render/contact.h"
#include "render/lines.h"
#include "render/module.h"
#include "render/physical.h"
#include "render/surfaces.h"

namespace betwixt {
namespace {

constexpr Backdrop gradient{Lighting::above, Lighting::beneath};

class Shaded final : public Module {
 public:
  Shaded(Canvas canvas, Surfaces surfaces, Shadows shadows, bool unclamped)
      : Module(std::move(canvas), Purpose::surfaces),
        surfaces_(std::move(surfaces)),
        shadows_(std::move(shadows)),
        physical_(unclamped) {}

 private:
  // What is seen, by how it is drawn.
  struct Sorted {
    std::vector<std::uint32_t> solid, glass, hairlines, through;
    bool metal = false;
  };
  Sorted sorted() const {
    Sorted r;
    // In drawings, what is opaque and made after something transparent at its depth lies over it, so it is drawn after
    // it.
    const bool flat = scenery_.surroundings.flat;
    std::vector<double> clear;
    const auto lies_over = [&](const Thing& t) {
      return std::any_of(clear.begin(), clear.end(),
                         [&](double d) { return std::abs(d - t.depth) <= 2e-7 * std::abs(d); });
    };
    for (std::uint32_t i = 0; i < things_.all().size(); ++i) {
      const Thing& t = things_[i];
      if (!t.visible) continue;
      const bool through = t.finish && t.finish->transmission > 0 && !t.transparent;
      const bool over = t.surface && (t.transparent || (flat && !clear.empty() && lies_over(t)));
      (!t.surface ? r.hairlines : over ? r.glass : through ? r.through : r.solid).push_back(i);
      if (flat && t.transparent && (clear.empty() || clear.back() != t.depth)) clear.push_back(t.depth);
      r.metal |= t.look.material == Material::metal;
    }
    return r;
  }
  void draw_anew() override {
    SkyAround sky(scenery_, things_.view(), has_finishes(things_));
    if (needs_physical(things_, scenery_, sky)) return draw_physical(std::move(sky));
    const auto [solid, glass, hairlines, through, metal] = sorted();
    const View& view = things_.view();
    const Surroundings& around = scenery_.surroundings;
    const Lighting lighting = lighting_of(scenery_.lights, view, {}, around);
    const auto shadows =
        shadows_.update(things_, std::span(lighting.lights).first(lighting.casting), around.ground.has_value());
    const bool contact = need_contact();  // making it binds other targets
    const Surfaces::FrameSettings now{view,   lighting, shadows, shadows_.texture(),
                                      around, metal,    contact, canvas_.linear() && around.clear};
    const bool encoded = canvas_.can_write_encoded();
    canvas_.begin(scenery_.background, around.clear);
    surfaces_.set(now);
    surfaces_.write_encoded(encoded);
    surfaces_.draw_opaque(things_, solid);
    if (around.ground || (around.sky && !around.clear))
      surfaces_.draw_setting(now, behind(gradient), encoded);
    else if (!scenery_.plain())
      canvas_.draw_behind(behind(gradient));
    if (contact) contact_->draw(canvas_, view, false);
    if (contact && now.clear) put_opacity_back(now);
    if (!hairlines.empty() || !glass.empty()) {
      canvas_.write_linear();
      draw_hairlines(view, hairlines);
      surfaces_.write_encoded(false);
      surfaces_.draw_transparent(things_, glass);
    }
    canvas_.finish();
  }
  void draw_physical(SkyAround sky) {
    const Sorted all = sorted();
    const View& view = things_.view();
    const Surroundings& around = scenery_.surroundings;
    const bool sky_seen = sky && sky.seen_behind();
    const Lighting lighting = lighting_of(scenery_.lights, view, {}, around, sky.sun());
    const auto shadows =
        shadows_.update(things_, std::span(lighting.lights).first(lighting.casting), around.ground.has_value());
    const bool contact = need_contact();
    const Surfaces::FrameSettings now{view,   lighting,  shadows, shadows_.texture(),
                                      around, all.metal, contact, canvas_.linear() && around.clear};
    const bool encoded = canvas_.can_write_encoded();
    canvas_.begin(scenery_.background, around.clear);
    const auto has_slide = [](const Lighting::One& l) { return l.picture && l.cone > 0; };
    const auto slide = std::find_if(lighting.lights.begin(), lighting.lights.end(), has_slide);
    const bool any = slide != lighting.lights.end();
    physical_.set_slide(any ? things_.store().texture(slide->picture) : nullptr,
                        static_cast<std::size_t>(slide - lighting.lights.begin()));
    physical_.set(now, std::move(sky));
    physical_.write_encoded(encoded);
    physical_.draw_opaque(things_, all.solid);
    if (around.ground || sky_seen)
      physical_.draw_setting(now, behind(gradient), encoded);
    else if (!scenery_.plain())
      canvas_.draw_behind(behind(gradient));
    if (contact) contact_->draw(canvas_, view, true);
    physical_.draw_through(canvas_, things_, all.through);
    if (!all.hairlines.empty() || !all.glass.empty()) {
      canvas_.write_linear();
      draw_hairlines(view, all.hairlines);
      physical_.write_encoded(false);
      physical_.draw_transparent(things_, all.glass);
    }
    canvas_.finish();
  }
  // Restores the alpha of the floor and of empty pixels after contact shading; opaque objects have 1.
  void put_opacity_back(Surfaces::FrameSettings now) {
    now.contact = false;
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    surfaces_.draw_setting(now, {}, false);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  // Returns whether contact shading is in use; if it cannot be made, the film is drawn without.
  bool need_contact() {
    const Surroundings& around = scenery_.surroundings;
    if (!around.contact || around.flat) return false;
    if (contact_) return true;
    if (auto made = ContactShading::create(canvas_)) contact_ = *std::move(made);
    return contact_.has_value();
  }
  // Meshes that have edges but no triangles.
  void draw_hairlines(const View& view, const std::vector<std::uint32_t>& hairlines) {
    if (hairlines.empty()) return;
    if (!lines_) {
      auto made = Lines::create();
      if (!made) return;  // the film is drawn without
      lines_ = *std::move(made);
    }
    std::vector<std::uint32_t> solid, clear;
    for (const std::uint32_t i : hairlines) (things_[i].transparent ? clear : solid).push_back(i);
    if (!solid.empty()) {
      const Batches batches = batches_of(things_, solid);
      line_instances_.set(things_, batches.order);
      lines_->set(view, canvas_.side());
      for (const Batch& b : batches.batches) lines_->draw(b, line_instances_);
    }
    if (clear.empty()) return;
    const Batches batches = sorted_singles(things_, clear);
    clear_instances_.set(things_, batches.order);
    lines_->draw_transparent(batches, clear_instances_, view, canvas_.side());
  }

  Surfaces surfaces_;
  Shadows shadows_;
  PhysicalSurfaces physical_;
  std::optional<Lines> lines_;  // these two are made on first use
  std::optional<ContactShading> contact_;
  Instances line_instances_, clear_instances_;
};

}  // namespace

Result<std::unique_ptr<Module>> make_shaded(const RenderOptions& options) {
  auto canvas = Canvas::create(options);
  if (!canvas) return canvas.error();
  auto surfaces = Surfaces::create(options.unclamped);
  if (!surfaces) return surfaces.error();
  auto shadows = Shadows::create();
  if (!shadows) return shadows.error();
  return std::unique_ptr<Module>(
      std::make_unique<Shaded>(*std::move(canvas), *std::move(surfaces), *std::move(shadows), options.unclamped));
}

}  // namespace betwixt
