// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/composer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "render/bloom.h"
#include "render/view.h"
#include "scene/extent.h"

namespace betwixt {
namespace {

// below + share · (with - without)
void add_difference(LinearPicture& below, const LinearPicture& with, const LinearPicture& without, double share) {
  const auto s = static_cast<float>(share);
  each_pixel_of(below, [&](std::size_t i) {
    for (std::size_t c = i; c < i + 4; ++c)
      below.rgba[c] = std::max(below.rgba[c] + s * (with.rgba[c] - without.rgba[c]), 0.0F);
  });
}

// The picture, moved by a whole or broken number of pixels; what comes in from outside is transparent.
LinearPicture moved_by(const LinearPicture& p, double right, double down) {
  LinearPicture out{p.width, p.height, std::vector<float>(p.rgba.size())};
  const double whole_x = std::floor(right), whole_y = std::floor(down);
  const auto part_x = static_cast<float>(right - whole_x), part_y = static_cast<float>(down - whole_y);
  const auto at = [&](double x, double y) -> const float* {
    const bool inside = x >= 0 && y >= 0 && x < p.width && y < p.height;
    return inside ? &p.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) +
                                 static_cast<std::size_t>(x))]
                  : nullptr;
  };
  for_rows(p.width, p.height, [&](int first, int end) {
    for (int y = first; y < end; ++y)
      for (int x = 0; x < p.width; ++x) {
        float* const to = &out.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) +
                                         static_cast<std::size_t>(x))];
        for (int k = 0; k < 4; ++k) {
          const float share = (k % 2 ? part_x : 1 - part_x) * (k / 2 ? part_y : 1 - part_y);
          const float* const from = share > 0 ? at(x - whole_x - k % 2, y - whole_y - k / 2) : nullptr;
          for (std::size_t c = 0; from && c < 4; ++c) to[c] += share * from[c];
        }
      }
  });
  return out;
}

// An object that hides what is behind it, and sends no light; or one that shows only where it is.
Item as_shade(const Item& item, double light) {
  Item shade = item;
  shade.color = {light, light, light}, shade.material = Material::glow;
  shade.texture = nullptr, shade.finish = nullptr;
  if (!item.gradients) return shade;
  Gradients all = *item.gradients;
  for (Gradient* g : {&all.fill, &all.stroke})
    for (Gradient::Stop& stop : g->stops) stop.color = shade.color;
  shade.gradients = std::make_shared<const Gradients>(std::move(all));
  return shade;
}

class Composer {
 public:
  Composer(const Frame& frame, int width, int height, const DrawLight& draw)
      : frame_(frame), width_(width), height_(height), draw_(draw), items_(frame.layers.size() + 1) {
    view_ = make_view(frame.camera, width, height, good_);
    scenery_ = frame;
    scenery_.items.clear(), scenery_.layers.clear(), scenery_.change.reset();
    for (const Item& item : frame.items) of(item.layer).push_back(item);
    for (std::size_t k = frame.layers.size(); k-- > 0;) {
      double& nearest = nearest_[static_cast<std::int32_t>(k)];
      nearest = 1e300;
      for (const Item& item : of(static_cast<std::int32_t>(k)))
        nearest = std::min(nearest, depth(translation_of(item.world)));
      for (std::size_t child = k + 1; child < frame.layers.size(); ++child)
        if (frame.layers[child].within == static_cast<std::int32_t>(k))
          nearest = std::min(nearest, nearest_[static_cast<std::int32_t>(child)]);
    }
  }

  Status whole(LinearPicture& out) {
    std::vector<std::int32_t> fading, others;
    for (const std::int32_t k : inside(-1)) (fades(k) ? fading : others).push_back(k);
    Frame now = scenery_;
    now.items = of(-1);
    if (Status s = draw_(now, out); !s) return s;
    LinearPicture with, without = fading.empty() ? LinearPicture{} : out;
    for (const std::int32_t k : fading) {
      const std::vector<Item>& more = of(k);
      if (layer(k).opacity == 0 || more.empty()) continue;
      now.items.insert(now.items.end(), more.begin(), more.end());
      if (Status s = draw_(now, with); !s) return s;
      add_difference(out, with, without, layer(k).opacity);
      std::swap(with, without);
    }
    return add_layers(others, out);
  }

 private:
  std::vector<Item>& of(std::int32_t layer) { return items_[static_cast<std::size_t>(layer + 1)]; }
  const Layer& layer(std::int32_t k) const { return frame_.layers[static_cast<std::size_t>(k)]; }
  double depth(Vec3 at) const { return view_.depth(at - view_.eye); }

  // Returns the layers that are parts of the picture of a layer, the farthest first.
  std::vector<std::int32_t> inside(std::int32_t outer) {
    std::vector<std::int32_t> found;
    for (std::size_t k = 0; k < frame_.layers.size(); ++k)
      if (frame_.layers[k].within == outer && !frame_.layers[k].is_mask) found.push_back(static_cast<std::int32_t>(k));
    std::stable_sort(found.begin(), found.end(),
                     [&](std::int32_t a, std::int32_t b) { return nearest_[a] > nearest_[b]; });
    return found;
  }

  // Returns whether a layer of a lit film is only not opaque. Then its shadows and reflections fade with it.
  bool fades(std::int32_t k) {
    const Layer& l = layer(k);
    return !frame_.surroundings.flat && l.blend == LayerBlend::normal && l.masks.empty() && l.blur == 0 &&
           l.glow == 0 && l.shadow == Vec3{} && inside(k).empty();
  }

  Status add_layers(const std::vector<std::int32_t>& layers, LinearPicture& out) {
    for (const std::int32_t k : layers) {
      if (layer(k).opacity == 0) continue;
      LinearPicture one;
      if (Status s = picture(k, one); !s) return s;
      lay_over(out, one, layer(k).blend, layer(k).opacity);
    }
    return Nothing{};
  }

  // Draws the picture of a layer with its effects. Objects wholly in front of it hide what the effects have made.
  Status picture(std::int32_t k, LinearPicture& out) {
    const Layer& l = layer(k);
    const bool spreads = l.blur > 0 || l.glow > 0 || !(l.shadow == Vec3{});
    std::vector<Item> front = spreads ? in_front_of(k) : std::vector<Item>{};
    for (const Item& item : front) aside_.insert(item.id.index);
    Status drawn = own_picture(k, out);
    if (drawn) drawn = add_layers(inside(k), out);
    for (const Item& item : front) aside_.erase(aside_.find(item.id.index));
    if (!drawn) return drawn;
    const double scale = pixels_of_metre(l.place);
    if (l.blur > 0) blur_light(out, scale * l.blur);
    if (!(l.shadow == Vec3{})) drop_shadow(l, scale, out);
    if (l.glow > 0) add_glow(l, scale, out);
    if (!front.empty()) drawn = hide_behind(std::move(front), out);
    return !drawn || l.masks.empty() ? drawn : mask(k, out);
  }

  template <class F>
  void each_item_within(std::int32_t k, const F& f) {
    for (const Item& item : of(k)) f(item);
    for (const std::int32_t child : inside(k)) each_item_within(child, f);
  }
  template <class F>
  void each_item_around(std::int32_t k, const F& f) {
    for (std::int32_t outer = k; outer >= 0 && !layer(outer).is_mask;) {
      outer = layer(outer).within;
      for (const Item& item : of(outer)) f(item);
    }
  }

  // Returns the objects around a layer that are wholly in front of all of its objects; in drawings also those of the
  // same depth that were created later.
  std::vector<Item> in_front_of(std::int32_t k) {
    double nearest = 1e300;
    std::uint32_t last = 0;
    each_item_within(k, [&](const Item& item) {
      nearest = std::min(nearest, depths(item).nearest), last = std::max(last, item.id.index);
    });
    std::vector<Item> front;
    each_item_around(k, [&](const Item& item) {
      const double farthest = depths(item).farthest;
      if (farthest < nearest || (frame_.surroundings.flat && farthest == nearest && item.id.index > last))
        front.push_back(item);
    });
    return front;
  }
  Status hide_behind(std::vector<Item> front, LinearPicture& out) {
    Frame now = scenery_;
    now.surroundings.clear = true, now.surroundings.ground.reset();
    for (Item& item : front) now.items.push_back(as_shade(item, 1));
    LinearPicture where;
    if (Status s = draw_(now, where); !s) return s;
    each_pixel_of(out, [&](std::size_t i) {
      const float seen = 1 - std::clamp(where.rgba[i + 3], 0.0F, 1.0F);
      for (std::size_t c = i; c < i + 4; ++c) out.rgba[c] *= seen;
    });
    return Nothing{};
  }

  // Draws the objects of a layer, where those of the layers around it do not hide them.
  Status own_picture(std::int32_t k, LinearPicture& out) {
    if (of(k).empty()) {
      out = {width_, height_,
             std::vector<float>(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_))};
      return Nothing{};
    }
    Frame now = scenery_;
    now.surroundings.clear = true, now.surroundings.ground.reset();
    now.items = of(k);
    std::vector<Item> before;
    double farthest = -1e300;
    for (const Item& item : of(k)) farthest = std::max(farthest, depths(item).farthest);
    each_item_around(k, [&](const Item& item) {
      if (depths(item).nearest <= farthest && aside_.count(item.id.index) == 0) before.push_back(as_shade(item, 0));
    });
    put_before(now.items, before);
    if (Status s = draw_(now, out); !s || before.empty()) return s;
    for (Item& item : now.items)
      if (item.layer == k) item = as_shade(item, 1);
    LinearPicture where;
    if (Status s = draw_(now, where); !s) return s;
    each_pixel_of(out, [&](std::size_t i) { out.rgba[i + 3] = std::min(where.rgba[i], 1.0F); });
    return Nothing{};
  }
  // Adds items in the order in which their objects were created, which matters to those of one depth.
  static void put_before(std::vector<Item>& items, const std::vector<Item>& others) {
    items.insert(items.end(), others.begin(), others.end());
    std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.id.index < b.id.index; });
  }
  // From which to which depth an object reaches: those of the box around it.
  struct Depths {
    double nearest = 1e300, farthest = -1e300;
  };
  Depths depths(const Item& item) const {
    Depths all;
    for (const Shape* const shape : {item.shape.get(), item.toward.get()}) {
      if (shape == nullptr) continue;
      const Extent box = extent(*shape);
      const double middle = depth(transform_point(item.world, box.middle()));
      double half = 0;
      for (int i = 0; i < 3; ++i) half += box.half()[i] * std::abs(dot(column(item.world, i), view_.backward));
      all.nearest = std::min(all.nearest, middle - half), all.farthest = std::max(all.farthest, middle + half);
    }
    return all;
  }

  double pixels_of_metre(Vec3 place) const {
    if (!good_) return 0;
    const double away = view_.orthographic ? 1 : std::max(depth(place), 1e-3);
    return std::min(0.5 * width_ * view_.sx / away, 1e6);
  }

  static void drop_shadow(const Layer& l, double scale, LinearPicture& out) {
    LinearPicture shadow = moved_by(out, scale * l.shadow.x, -scale * l.shadow.y);
    blur_light(shadow, scale * l.shadow.z);
    each_pixel_of(out, [&](std::size_t i) {
      const float opacity = std::clamp(shadow.rgba[i + 3], 0.0F, 1.0F) * static_cast<float>(l.shadow_opacity);
      const float left = 1 - std::min(out.rgba[i + 3], 1.0F);
      for (std::size_t c = 0; c < 3; ++c)
        out.rgba[i + c] += left * opacity * static_cast<float>(l.shadow_color[static_cast<int>(c)]);
      out.rgba[i + 3] += left * opacity;
    });
  }

  static void add_glow(const Layer& l, double scale, LinearPicture& out) {
    LinearPicture glow = out;
    blur_light(glow, scale * l.glow_size);
    each_pixel_of(out, [&](std::size_t i) {
      const float around = static_cast<float>(l.glow) * (1 - std::clamp(out.rgba[i + 3], 0.0F, 1.0F));
      for (std::size_t c = i; c < i + 3; ++c) out.rgba[c] += around * glow.rgba[c];
    });
  }

  // Leaves a picture only where its masks are. A mask that needs itself does not count.
  Status mask(std::int32_t k, LinearPicture& out) {
    std::vector<float> hidden(out.rgba.size() / 4, 1.0F);
    bool any = false;
    for (const std::int32_t m : layer(k).masks) {
      if (drawing_.count(m) > 0) continue;
      any = true;
      auto known = masks_.find(m);
      if (known == masks_.end()) {
        drawing_.insert(m);
        LinearPicture drawn;
        Status s = picture(m, drawn);
        drawing_.erase(m);
        if (!s) return s;
        known = masks_.emplace(m, std::move(drawn)).first;
      }
      const auto opacity = static_cast<float>(layer(m).opacity);
      for (std::size_t i = 0; i < hidden.size(); ++i)
        hidden[i] *= 1 - opacity * std::clamp(known->second.rgba[4 * i + 3], 0.0F, 1.0F);
    }
    if (any)
      each_pixel_of(out, [&](std::size_t i) {
        for (std::size_t c = i; c < i + 4; ++c) out.rgba[c] *= 1 - hidden[i / 4];
      });
    return Nothing{};
  }

  const Frame& frame_;
  const int width_, height_;
  const DrawLight& draw_;
  Frame scenery_;  // without objects
  View view_;
  bool good_ = false;
  std::vector<std::vector<Item>> items_;    // by layer; first those without one
  std::map<std::int32_t, double> nearest_;  // by layer: the depth of its nearest object
  std::map<std::int32_t, LinearPicture> masks_;
  std::set<std::int32_t> drawing_;      // masks
  std::multiset<std::uint32_t> aside_;  // objects that hide a picture only when it has its effects
};

// Returns the share of the new picture at a place; (0 0) is the middle, (1 1) the right top.
double share_at(const CameraChange& change, double x, double y, double aspect) {
  const double soft = 0.02, part = change.share * (1 + soft);
  const auto passed = [&](double place) { return std::clamp((part - place) / soft, 0.0, 1.0); };
  switch (change.kind) {
    case ChangeKind::left:
      return passed((1 - x) / 2);
    case ChangeKind::right:
      return passed((1 + x) / 2);
    case ChangeKind::up:
      return passed((1 + y) / 2);
    case ChangeKind::down:
      return passed((1 - y) / 2);
    case ChangeKind::iris:
      return passed(std::sqrt((x * x * aspect * aspect + y * y) / (aspect * aspect + 1)));
    case ChangeKind::dissolve:
      break;
  }
  return change.share;
}

}  // namespace

Status compose(const Frame& frame, int width, int height, const DrawLight& draw, LinearPicture& out) {
  if (Status s = Composer(frame, width, height, draw).whole(out); !s || !frame.change) return s;
  const CameraChange& change = *frame.change;
  Frame old = frame;
  old.camera = change.from, old.change.reset();
  LinearPicture before;
  if (Status s = Composer(old, width, height, draw).whole(before); !s) return s;
  for_rows(out.width, out.height, [&](int first, int end) {
    for (int y = first; y < end; ++y)
      for (int x = 0; x < out.width; ++x) {
        const auto share =
            static_cast<float>(share_at(change, (2 * x + 1.0) / out.width - 1, 1 - (2 * y + 1.0) / out.height,
                                        static_cast<double>(out.width) / out.height));
        const std::size_t i =
            4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) + static_cast<std::size_t>(x));
        for (std::size_t c = i; c < i + 4; ++c) out.rgba[c] = share * out.rgba[c] + (1 - share) * before.rgba[c];
      }
  });
  return Nothing{};
}

}  // namespace betwixt
