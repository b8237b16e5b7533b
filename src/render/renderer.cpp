// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <mutex>
#include <tuple>

#include "base/stages.h"
#include "betwixt/render.h"
#include "commands/plugins.h"
#include "render/blur.h"
#include "render/flat.h"
#include "render/gl.h"
#include "render/graded_renderer.h"
#include "render/module.h"
#include "render/plugin_renderer.h"
#include "render/traced.h"
#include "scene/document.h"
#include "scene/pixel_filter.h"
#include "scene/styles.h"

namespace betwixt {
namespace {

// Returns the columns, with what has changed since the revision that was seen; then that is the evaluation's.
Columns columns_since(Evaluation::Revision& seen, const Evaluation& evaluation) {
  Columns columns = columns_of(evaluation);
  const Evaluation::Revision now = evaluation.revision();
  if (now.program == seen.program && seen.times > 0) {
    if (now.times == seen.times) columns.changed.emplace();
    if (now.times == seen.times + 1) columns.changed = evaluation.changed();
  }
  seen = now;
  return columns;
}

class SurfacelessRenderer final : public Renderer {
 public:
  SurfacelessRenderer(gl::Context context, std::unique_ptr<Module> module, const RenderOptions& options)
      : context_(std::move(context)), module_(std::move(module)), width_(options.width), height_(options.height) {}
  ~SurfacelessRenderer() override {
    const gl::Current current(context_);
    module_.reset();
  }
  Status render(const Frame& frame, Picture& out) override { return draw(frame, out); }
  Status render(const Frame& frame, LinearPicture& out) override { return draw(frame, out); }
  Status render(const Evaluation& evaluation, Picture& out) override { return draw(evaluation, out); }
  Status render(const Evaluation& evaluation, LinearPicture& out) override { return draw(evaluation, out); }
  Status show(const Evaluation& evaluation) override {
    if (!context_.shows()) return Renderer::show(evaluation);
    Module::Shown shown;
    return draw(evaluation, shown);
  }
  Status render_blurred(Evaluation& evaluation, Time t, const Blur& how, LinearPicture& out) override {
    seen_ = {};
    return betwixt::render_blurred(
        evaluation, t, how, width_, height_,
        [&](const Columns& columns, LinearPicture& picture) {
          const InStage draw(Stage::draw);
          const gl::Current current(context_);
          return module_->draw(columns, picture);
        },
        out);
  }

 private:
  template <class Out>
  Status draw(const Frame& frame, Out& out) {
    const InStage draw(Stage::draw);
    const gl::Current current(context_);
    seen_ = {};
    const FrameColumns laid_out(frame);
    return module_->draw(laid_out.columns(), out);
  }
  template <class Out>
  Status draw(const Evaluation& evaluation, Out& out) {
    const InStage draw(Stage::draw);
    const gl::Current current(context_);
    return module_->draw(columns_since(seen_, evaluation), out);
  }

  gl::Context context_;
  std::unique_ptr<Module> module_;
  const int width_, height_;
  Evaluation::Revision seen_;  // of the previous picture
};

template <MakeModule make_module>
Result<std::unique_ptr<Renderer>> surfaceless(const RenderOptions& options) {
  auto context = gl::Context::create(options.device);
  if (!context) return context.error();
  auto module = [&] {
    const gl::Current current(*context);
    return make_module(options);
  }();
  if (!module) return module.error();
  return std::unique_ptr<Renderer>(
      std::make_unique<SurfacelessRenderer>(*std::move(context), *std::move(module), options));
}

// Draws flat pictures itself; the first picture that is not flat makes the renderer for all others.
class ShadedRenderer final : public Renderer {
 public:
  explicit ShadedRenderer(const RenderOptions& options) : options_(options), flat_(options.width, options.height) {}
  Status render(const Frame& frame, Picture& out) override {
    seen_ = {};
    const FrameColumns laid_out(frame);
    return flat_.draw(laid_out.columns(), out) ? Status(Nothing{})
                                               : by_graphics([&](Renderer& r) { return r.render(frame, out); });
  }
  Status render(const Evaluation& evaluation, Picture& out) override {
    if (flat_.draw(columns_since(seen_, evaluation), out)) return Nothing{};
    seen_ = {};
    return by_graphics([&](Renderer& r) { return r.render(evaluation, out); });
  }
  Status render(const Frame& frame, LinearPicture& out) override {
    seen_ = {};
    const FrameColumns laid_out(frame);
    if (options_.linear && flat_.draw(laid_out.columns(), out)) return Nothing{};
    return by_graphics([&](Renderer& r) { return r.render(frame, out); });
  }
  Status render(const Evaluation& evaluation, LinearPicture& out) override {
    if (options_.linear && flat_.draw(columns_since(seen_, evaluation), out)) return Nothing{};
    seen_ = {};
    return by_graphics([&](Renderer& r) { return r.render(evaluation, out); });
  }
  Status show(const Evaluation& evaluation) override {
    return by_graphics([&](Renderer& r) { return r.show(evaluation); });
  }
  Status render_blurred(Evaluation& evaluation, Time t, const Blur& how, LinearPicture& out) override {
    seen_ = {};
    return by_graphics([&](Renderer& r) { return r.render_blurred(evaluation, t, how, out); });
  }

 private:
  template <class Draw>
  Status by_graphics(const Draw& draw) {
    if (graphics_ == nullptr) {
      auto made = surfaceless<make_shaded>(options_);
      if (!made) return made.error();
      graphics_ = *std::move(made);
    }
    return draw(*graphics_);
  }

  const RenderOptions options_;
  FlatPainter flat_;
  Evaluation::Revision seen_;  // of the previous flat picture
  std::unique_ptr<Renderer> graphics_;
};

// One sample a pixel has no soft edges, other filters spread them, and linear pictures have alpha.
Result<std::unique_ptr<Renderer>> make_shaded_renderer(const RenderOptions& options) {
  if (options.linear || options.samples == 1 || options.pixel_filter != pixel_filters().front().name)
    return surfaceless<make_shaded>(options);
  return std::unique_ptr<Renderer>(std::make_unique<ShadedRenderer>(options));
}

// The same, for light that is composed and graded: flat pictures have their exact edges there too.
Result<std::unique_ptr<Renderer>> make_shaded_light(const RenderOptions& options) {
  if (options.samples == 1 || options.pixel_filter != pixel_filters().front().name)
    return surfaceless<make_shaded>(options);
  return std::unique_ptr<Renderer>(std::make_unique<ShadedRenderer>(options));
}

constexpr std::string_view squares = "1, 4, 9 or 16", any = "1 to 4096";
bool is_square(int samples) { return samples == 1 || samples == 4 || samples == 9 || samples == 16; }
bool is_any(int samples) { return samples >= 1 && samples <= 4096; }

struct Entry {
  Style style;
  Result<std::unique_ptr<Renderer>> (*make)(const RenderOptions&);
  Result<std::unique_ptr<Renderer>> (*make_light)(const RenderOptions&) = nullptr;  // of light that is composed
  Result<std::unique_ptr<Renderer>> light(const RenderOptions& o) const { return (make_light ? make_light : make)(o); }
};
constexpr Entry table[] = {
    {{style_names[0], "lit surfaces with soft shadows, highlights and glass", squares, is_square, 1},
     make_shaded_renderer,
     make_shaded_light},
    {{style_names[1], "all edges as fine lines", squares, is_square, 1}, surfaceless<make_wireframe>},
    {{style_names[2], "edges as fine lines, without hidden ones", squares, is_square, 1},
     surfaceless<make_hidden_line>},
    {{style_names[3], "path tracing, for final pictures", any, is_any, 64},
     [](const RenderOptions& options) { return make_traced(options); }},
};

static_assert(std::size(table) == style_names.size());

// Returns the edit distance: letters to change, add or drop from `a` to `b`.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, change}));
    }
  }
  return row.back();
}

Error no_such_style(const std::string& name) {
  std::string all, near;
  for (const Style& s : styles()) {
    all += (all.empty() ? "" : ", ") + std::string(s.name);
    if (distance(name.substr(0, 64), s.name) <= 3) near = s.name;
  }
  return fail(ErrorCode::name, fmt::format("there is no style '{}'", name.substr(0, 64)),
              near.empty() ? "the styles are " + all : near);
}

// The styles of the program and of plug-ins. Lists that were given out stay valid when plug-ins are loaded.
class StyleList {
 public:
  const std::vector<Style>& all() {
    const std::lock_guard lock(mutex_);
    const std::vector<PluginRenderer> more = plugin_renderers();
    const auto same = [](const Style& s, const PluginRenderer& r) { return s.name == r.name && s.what == r.help; };
    if (!lists_.empty() &&
        std::equal(lists_.back().begin() + std::size(table), lists_.back().end(), more.begin(), more.end(), same))
      return lists_.back();
    std::vector<Style>& list = lists_.emplace_back();
    for (const Entry& e : table) list.push_back(e.style);
    for (const PluginRenderer& renderer : more) {
      const std::string &name = texts_.emplace_back(renderer.name), &what = texts_.emplace_back(renderer.help);
      list.push_back({name, what, any, is_any, 1});
    }
    return list;
  }

 private:
  std::mutex mutex_;
  std::deque<std::vector<Style>> lists_;
  std::deque<std::string> texts_;
};

}  // namespace

const std::vector<Style>& styles() {
  static StyleList list;
  return list.all();
}

bool has_blur(const Document& document) {
  const Objects& objects = document.scene().objects;
  for (std::uint32_t i = 0; i < objects.size(); ++i)
    if (objects[i].kind == Kind::camera && (objects[i].find(fn::shutter) || objects[i].find(fn::f_stop))) return true;
  return false;
}

RenderOptions options_for(const Document& document, RenderOptions made, std::optional<std::pair<int, int>> size,
                          std::optional<int> samples) {
  int least = 1;
  for (const Entry& e : table)
    if (e.style.name == made.style) least = e.style.least_samples;
  if (const auto pixels = size ? size : document.size()) std::tie(made.width, made.height) = *pixels;
  // A script's number of samples is for drawn styles; the path tracer needs more. `samples auto` is for all of them.
  constexpr int automatic = RenderOptions::auto_samples;
  const auto said = document.samples();
  const auto n = samples || (least > 1 && said != automatic) ? samples : said;
  made.samples = n ? *n : std::max(made.samples, least);
  if (made.samples == automatic && least == 1) made.samples = RenderOptions().samples;
  if (const std::string_view filter = document.scene().appearance.pixel_filter; !filter.empty())
    made.pixel_filter = filter;
  return made;
}

std::optional<Blur> blur_for(const Document& document, std::optional<double> shutter, std::optional<int> subframes) {
  Blur made;
  made.subframes = subframes.value_or(document.subframes().value_or(made.subframes));
  made.shutter = shutter;
  const bool blurs = has_blur(document) || shutter.value_or(0) > 0;
  return blurs && made.subframes > 1 ? std::optional(made) : std::nullopt;
}

namespace {

Result<const Entry*> find(const RenderOptions& options) {
  const auto fits = [](int n) { return n >= 1 && n <= 8192; };
  if (!fits(options.width) || !fits(options.height))
    return fail(ErrorCode::range,
                fmt::format("a picture of {}x{} pixels cannot be drawn", options.width, options.height),
                "each side must have from 1 to 8192 pixels");
  const auto* entry =
      std::find_if(std::begin(table), std::end(table), [&](const Entry& e) { return e.style.name == options.style; });
  static constexpr Entry of_plugins{{"", "", any, is_any, 1},
                                    [](const RenderOptions& o) { return make_plugin_renderer(o); }};
  if (entry == std::end(table) && plugin_renderer(options.style)) entry = &of_plugins;
  if (entry == std::end(table)) return no_such_style(options.style);
  if (options.samples != RenderOptions::auto_samples && !entry->style.takes(options.samples))
    return fail(ErrorCode::range, fmt::format("{} samples per pixel cannot be drawn", options.samples),
                std::string(entry->style.samples));
  if (!find_pixel_filter(options.pixel_filter)) {
    std::vector<std::string_view> names;
    for (const PixelFilter& f : pixel_filters()) names.push_back(f.name);
    return fail(ErrorCode::name, fmt::format("there is no pixel filter '{}'", options.pixel_filter.substr(0, 64)),
                fmt::format("pixel filters are {}", fmt::join(names, ", ")));
  }
  if (!(options.peak >= 1 && options.peak <= 100))
    return fail(ErrorCode::range, fmt::format("a peak of {} times white cannot be drawn", options.peak), "1 to 100");
  return entry;
}

}  // namespace

Status Renderer::show(const Evaluation&) {
  return fail(ErrorCode::machine, "this renderer has no window", "use render() to get the picture");
}

Status check_options(const RenderOptions& options) {
  const auto found = find(options);
  return found ? Status(Nothing{}) : found.error();
}

Result<std::unique_ptr<Renderer>> make_renderer(const RenderOptions& options) {
  const auto found = find(options);
  if (!found) return found.error();
  RenderOptions wanted = options;
  const Entry& style = **found;
  if (wanted.samples == RenderOptions::auto_samples && style.style.least_samples <= 1)
    wanted.samples = RenderOptions().samples;
  auto plain = style.make(wanted);
  if (!plain) return plain;
  const auto light = [&style](const RenderOptions& o) { return style.light(o); };
  const auto make_light = [&style, light](const RenderOptions& o) -> Result<std::unique_ptr<Renderer>> {
    auto made = style.light(o);
    return made ? make_composed_renderer(*std::move(made), o, light) : std::move(made);
  };
  return make_graded_renderer(make_composed_renderer(*std::move(plain), wanted, light), wanted, make_light);
}

}  // namespace betwixt
