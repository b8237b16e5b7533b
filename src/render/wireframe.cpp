// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The styles `wireframe` and `hidden-line`: edges as wide lines whose borders fade over a pixel.
#include "render/lines.h"
#include "render/module.h"

namespace betwixt {
namespace {

constexpr Backdrop dark_gradient{{0.012, 0.014, 0.018}, {0.028, 0.031, 0.037}};

// Surfaces that only hide what is behind them.
const char* const hide_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 3) in vec4 row_x;
layout(location = 4) in vec4 row_y;
layout(location = 5) in vec4 row_z;
uniform mat4 clip;
void main() {
  vec4 p = vec4(position, 1.0);
  gl_Position = clip * vec4(dot(row_x, p), dot(row_y, p), dot(row_z, p), 1.0);
}
)";
const char* const hide_fragment = "void main() {}";

class Wireframe final : public Module {
 public:
  Wireframe(Canvas canvas, Lines lines, gl::Program hide)
      : Module(std::move(canvas), Purpose::lines), lines_(std::move(lines)), hide_(std::move(hide)) {}

 private:
  void draw_anew() override {
    const View& view = things_.view();
    std::vector<std::uint32_t> seen;
    for (std::uint32_t i = 0; i < things_.all().size(); ++i)
      if (things_[i].visible) seen.push_back(i);
    canvas_.begin(scenery_.background, scenery_.surroundings.clear);
    if (!scenery_.plain()) canvas_.draw_behind(behind(dark_gradient));
    canvas_.write_linear();
    const Batches batches = batches_of(things_, seen);
    instances_.set(things_, batches.order);
    if (hide_.id() != 0) hide(view, batches);
    lines_.set(view, canvas_.side());
    for (const Batch& b : batches.batches) lines_.draw(b, instances_);
    canvas_.finish();
  }
  void hide(const View& view, const Batches& batches) const {
    glUseProgram(hide_.id());
    glUniformMatrix4fv(gl::uniform(hide_, "clip"), 1, GL_FALSE, to_float(view.clip()).data());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0F, 4.0F);
    for (const Batch& b : batches.batches) draw_triangles(b, instances_, true);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }

  Lines lines_;
  gl::Program hide_;  // absent if nothing is hidden
  Instances instances_;
};

Result<std::unique_ptr<Module>> make(RenderOptions options, bool hidden) {
  // Lines are antialiased by themselves: more samples would only be slower.

  if (options.samples == 4) options.samples = 1;
  auto canvas = Canvas::create(options);
  if (!canvas) return canvas.error();
  auto lines = Lines::create();
  if (!lines) return lines.error();
  gl::Program hide;
  if (hidden) {
    auto program = gl::new_program(hide_vertex, hide_fragment);
    if (!program) return program.error();
    hide = *std::move(program);
  }
  return std::unique_ptr<Module>(std::make_unique<Wireframe>(*std::move(canvas), *std::move(lines), std::move(hide)));
}

}  // namespace

Result<std::unique_ptr<Module>> make_wireframe(const RenderOptions& options) { return make(options, false); }
Result<std::unique_ptr<Module>> make_hidden_line(const RenderOptions& options) { return make(options, true); }

}  // namespace betwixt
