// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The style `shaded`: a shadow map, then solid surfaces, the background, glass, and the picture.
#include "render/canvas.h"
#include "render/lines.h"
#include "render/module.h"
#include "render/surfaces.h"

namespace betwixt {
namespace {

constexpr Gradient gradient{{0.26, 0.28, 0.31}, {0.12, 0.125, 0.13}};

class Shaded final : public Module {
 public:
  Shaded(Canvas canvas, Surfaces surfaces, Shadow shadow, Lines lines)
      : canvas_(std::move(canvas)),
        surfaces_(std::move(surfaces)),
        shadow_(std::move(shadow)),
        lines_(std::move(lines)),
        line_instances_(gl::new_buffer()) {}

  Status draw(const Frame& frame, Picture& out) override {
    store_.next_frame();
    View view;
    const std::vector<Thing> things = gather(frame, canvas_.width(), canvas_.height(), store_, Purpose::surfaces, view);
    std::vector<const Thing*> solid, glass, casters, hairlines;
    for (const Thing& t : things) {
      const bool surface = !t.mesh->parts.empty();
      if (t.visible) (!surface ? hairlines : t.transparent ? glass : solid).push_back(&t);
      if (surface && t.item->material != Material::glow) casters.push_back(&t);
    }
    const Lighting lighting = lighting_of(frame, view, {});
    const bool shadows = !casters.empty() && !lighting.lights.empty();
    if (shadows) shadow_.draw(casters, lighting.lights.front());
    canvas_.begin(frame.background);
    surfaces_.set(view, lighting, &shadow_);
    surfaces_.write_encoded(canvas_.can_write_encoded());
    surfaces_.draw_opaque(solid, store_);
    canvas_.draw_behind(frame.background, gradient);
    if (!hairlines.empty() || !glass.empty()) {
      canvas_.write_linear();
      draw_hairlines(view, hairlines);
      surfaces_.write_encoded(false);
      surfaces_.draw_transparent(glass, store_);
    }
    canvas_.finish(out);
    return Nothing{};
  }

 private:
  // Meshes that have edges but no triangles.
  void draw_hairlines(const View& view, const std::vector<const Thing*>& things) {
    if (things.empty()) return;
    const Batches batches = batches_of(things, false);
    send_instances(line_instances_, batches.instances);
    lines_.set(view, canvas_.side());
    for (const Batch& b : batches.batches) lines_.draw(b, line_instances_, store_);
  }

  Canvas canvas_;
  Surfaces surfaces_;
  Shadow shadow_;
  Lines lines_;
  gl::Buffer line_instances_;
  Store store_;
};

}  // namespace

Result<std::unique_ptr<Module>> make_shaded(const RenderOptions& options) {
  auto canvas = Canvas::create(options);
  if (!canvas) return canvas.error();
  auto surfaces = Surfaces::create();
  if (!surfaces) return surfaces.error();
  auto shadow = Shadow::create();
  if (!shadow) return shadow.error();
  auto lines = Lines::create();
  if (!lines) return lines.error();
  return std::unique_ptr<Module>(
      std::make_unique<Shaded>(*std::move(canvas), *std::move(surfaces), *std::move(shadow), *std::move(lines)));
}

}  // namespace betwixt
