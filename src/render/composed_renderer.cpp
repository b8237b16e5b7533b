// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "render/composer.h"
#include "render/graded_renderer.h"

namespace betwixt {
namespace {

class ComposedRenderer final : public Renderer {
 public:
  ComposedRenderer(std::unique_ptr<Renderer> plain, const RenderOptions& options, MakeRenderer make)
      : plain_(std::move(plain)), options_(options), make_(std::move(make)) {}

  Status render(const Frame& f, Picture& out) override {
    return is_composed(f) ? composed(f, out) : plain_->render(f, out);
  }
  Status render(const Frame& f, LinearPicture& out) override {
    return is_composed(f) && options_.linear ? composed(f, out) : plain_->render(f, out);
  }
  Status render(const Evaluation& e, Picture& out) override {
    return e.composed() ? composed(e.frame(), out) : plain_->render(e, out);
  }
  Status render(const Evaluation& e, LinearPicture& out) override {
    return e.composed() && options_.linear ? composed(e.frame(), out) : plain_->render(e, out);
  }
  Status show(const Evaluation& e) override { return plain_->show(e); }
  // The pictures that are averaged are composed, each at its time; the lens is sharp.
  Status render_blurred(Evaluation& e, Time t, const Blur& how, LinearPicture& out) override {
    e.to(t);
    const bool one = !e.composed();
    if (one || !options_.linear) return plain_->render_blurred(e, t, how, out);
    const double shutter = std::clamp(how.shutter.value_or(e.camera().shutter), 0.0, 60.0);
    const int n = shutter > 0 ? how.subframes : 1;
    std::vector<double> sum;
    for (int k = 0; k < n; ++k) {
      if (shutter > 0) e.to(t + from_seconds(shutter * (k + 0.5) / n));
      if (Status s = render(e, out); !s) return s;
      sum.resize(out.rgba.size());
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<double>(out.rgba[i]);
    }
    for (std::size_t i = 0; i < sum.size(); ++i) out.rgba[i] = static_cast<float>(sum[i] / n);
    return Nothing{};
  }

 private:
  Status composed(const Frame& f, LinearPicture& out) {
    if (!light_) {
      RenderOptions wanted = options_;
      wanted.linear = true;
      auto made = make_(wanted);
      if (!made) return made.error();
      light_ = *std::move(made);
    }
    return compose(
        f, options_.width, options_.height,
        [&](const Frame& one, LinearPicture& picture) { return light_->render(one, picture); }, out);
  }
  Status composed(const Frame& f, Picture& out) {
    LinearPicture light;
    if (Status s = composed(f, light); !s) return s;
    // Without an alpha channel, a transparent background is black.
    if (!options_.linear)
      for (std::size_t i = 3; i < light.rgba.size(); i += 4) light.rgba[i] = 1;
    to_shown(light, out);
    return Nothing{};
  }

  std::unique_ptr<Renderer> plain_, light_;
  const RenderOptions options_;
  const MakeRenderer make_;
};

}  // namespace

std::unique_ptr<Renderer> make_composed_renderer(std::unique_ptr<Renderer> plain, const RenderOptions& options,
                                                 MakeRenderer make_light) {
  return std::make_unique<ComposedRenderer>(std::move(plain), options, std::move(make_light));
}

}  // namespace betwixt
