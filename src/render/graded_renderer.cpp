// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/graded_renderer.h"

#include "base/stages.h"
#include "render/grade.h"
#include "render/picture_screen.h"
#include "scene/document.h"

namespace betwixt {
namespace {

// What of a film says how its light is shown.
struct ToGrade {
  Grade grade;
  bool drawing = false;  // `film flat`
  Time time;
  bool clear = false;  // a transparent background
};
ToGrade to_grade(const Frame& f) { return {f.surroundings.grade, f.surroundings.flat, f.time, f.surroundings.clear}; }
ToGrade to_grade(const Evaluation& e) {
  const auto& a = e.program().document().scene().appearance;
  return {a.grade, a.flat, e.time(), a.clear};
}

class GradedRenderer final : public Renderer {
 public:
  GradedRenderer(std::unique_ptr<Renderer> plain, const RenderOptions& options, MakeRenderer make)
      : plain_(std::move(plain)), options_(options), make_(std::move(make)) {}

  Status render(const Frame& f, Picture& out) override { return draw(f, out); }
  Status render(const Evaluation& e, Picture& out) override { return draw(e, out); }
  Status render(const Frame& f, LinearPicture& out) override { return give(f, out); }
  Status render(const Evaluation& e, LinearPicture& out) override { return give(e, out); }
  // Pages show finished pictures; where they cannot draw light, the film is shown without a grade and without layers.
  Status show(const Evaluation& e) override {
    if (to_grade(e).grade == Grade() && !e.composed()) return plain_->show(e);
    Picture picture;
    const Status drawn = render(e, picture);
    return drawn ? screen_.show(picture) : plain_->show(e);
  }
  Status render_blurred(Evaluation& e, Time t, const Blur& how, LinearPicture& out) override {
    ToGrade g = to_grade(e);
    if (shows_plainly(g) || !options_.linear) return plain_->render_blurred(e, t, how, out);
    g.time = t;
    return finish(
        g, [&](Renderer& r) { return r.render_blurred(e, t, how, out); }, out);
  }

 private:
  template <class Source>
  Status draw(const Source& source, Picture& out) {
    const ToGrade g = to_grade(source);
    if (g.grade == Grade()) return plain_->render(source, out);
    if (Status s = light(
            g, [&](Renderer& r) { return r.render(source, light_); }, light_);
        !s)
      return s;
    const InStage drawing(Stage::draw);
    develop(light_, development(g), out);
    return Nothing{};
  }
  template <class Source>
  Status give(const Source& source, LinearPicture& out) {
    const ToGrade g = to_grade(source);
    if (shows_plainly(g) || !options_.linear) return plain_->render(source, out);
    return finish(
        g, [&](Renderer& r) { return r.render(source, out); }, out);
  }
  // Light that may be above white is for further processing: it has no view and no grain.
  template <class Render>
  Status finish(const ToGrade& g, const Render& render, LinearPicture& out) {
    if (Status s = light(g, render, out); !s || options_.unclamped) return s;
    develop(out, development(g));
    return Nothing{};
  }
  template <class Render>
  Status light(const ToGrade& g, const Render& render, LinearPicture& out) {
    const auto renderer = renderer_of_light(options_.unclamped || !rolls_off_first(g));
    if (!renderer) return renderer.error();
    if (Status s = render(**renderer); !s) return s;
    const InStage drawing(Stage::draw);
    grade_light(out, g.grade);
    return Nothing{};
  }

  // With the view `neutral`, surfaces roll off as they do without a grade, and colours that need no light stay. But
  // bloom needs to know how bright they are.
  bool rolls_off_first(const ToGrade& g) const {
    return g.grade.view == Grade::neutral && !(g.grade.bloom > 0) && (options_.peak <= 1 || g.grade.table);
  }
  // Without a grade, the style makes the picture; but it rolls off at white.
  bool shows_plainly(const ToGrade& g) const {
    return g.grade == Grade() && (options_.peak <= 1 || options_.unclamped);
  }
  Development development(const ToGrade& g) const {
    return {g.grade, g.drawing || rolls_off_first(g), g.time, !(options_.linear && g.clear), options_.peak};
  }
  Result<Renderer*> renderer_of_light(bool unclamped) {
    RenderOptions wanted = options_;
    wanted.linear = true, wanted.unclamped = unclamped;
    if (!of_light_ || !(options_of_light_ == wanted)) {
      of_light_.reset();
      auto made = make_(wanted);
      if (!made) return made.error();
      of_light_ = *std::move(made), options_of_light_ = wanted;
    }
    return of_light_.get();
  }

  std::unique_ptr<Renderer> plain_, of_light_;
  const RenderOptions options_;
  RenderOptions options_of_light_;
  const MakeRenderer make_;
  LinearPicture light_;
  PictureScreen screen_;
};

}  // namespace

std::unique_ptr<Renderer> make_graded_renderer(std::unique_ptr<Renderer> plain, const RenderOptions& options,
                                               MakeRenderer make) {
  return std::make_unique<GradedRenderer>(std::move(plain), options, std::move(make));
}

}  // namespace betwixt
