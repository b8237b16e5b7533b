// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/gltf_parts.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "export/fit.h"

namespace betwixt::gltf {
namespace {

constexpr int float_type = 5126, short_type = 5123, int_type = 5125;

template <class T>
std::string_view raw(const std::vector<T>& all) {
  static_assert(std::endian::native == std::endian::little);
  return {reinterpret_cast<const char*>(all.data()), all.size() * sizeof(T)};
}

const char* type_of(std::size_t width) {
  return width == 1 ? "SCALAR" : width == 2 ? "VEC2" : width == 3 ? "VEC3" : width == 4 ? "VEC4" : "MAT4";
}

void add(std::vector<float>& to, const std::array<double, 4>& v, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i) to.push_back(static_cast<float>(v[i]));
}

}  // namespace

std::size_t Buffer::view(std::string_view data, Use use) {
  while (bytes.size() % 4 != 0) bytes += '\0';
  Json v{{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}};
  if (use != plain) v["target"] = static_cast<int>(use);
  bytes += data;
  views.push_back(std::move(v));
  return views.size() - 1;
}

std::size_t Buffer::floats(const std::vector<float>& all, std::size_t width, Use use, bool bounds) {
  const auto [known, fresh] =
      known_.try_emplace({std::string(raw(all)), 16 * width + (bounds ? 1 : 0) + use}, accessors.size());
  if (!fresh) return known->second;
  Json a{{"bufferView", view(raw(all), use)},
         {"componentType", float_type},
         {"count", all.size() / width},
         {"type", type_of(width)}};
  if (bounds) {
    Json least = Json::array(), most = Json::array();
    for (std::size_t i = 0; i < width; ++i) {
      float low = all[i], high = all[i];
      for (std::size_t k = i; k < all.size(); k += width) low = std::min(low, all[k]), high = std::max(high, all[k]);
      least.push_back(low), most.push_back(high);
    }
    a["min"] = std::move(least), a["max"] = std::move(most);
  }
  accessors.push_back(std::move(a));
  return accessors.size() - 1;
}

std::size_t Buffer::whole(const std::vector<std::uint32_t>& all) {
  const std::uint32_t most = *std::max_element(all.begin(), all.end());
  Json a;
  if (most < 65535) {
    const std::vector<std::uint16_t> narrow(all.begin(), all.end());
    a = {{"bufferView", view(raw(narrow), indices)}, {"componentType", short_type}};
  } else {
    a = {{"bufferView", view(raw(all), indices)}, {"componentType", int_type}};
  }
  a["count"] = all.size(), a["type"] = "SCALAR";
  accessors.push_back(std::move(a));
  return accessors.size() - 1;
}

std::size_t Buffer::joints(const std::vector<std::array<std::uint16_t, 4>>& all,
                           const std::vector<std::array<float, 4>>& weights) {
  std::vector<std::uint16_t> flat;
  for (std::size_t v = 0; v < all.size(); ++v)
    for (std::size_t i = 0; i < 4; ++i) flat.push_back(weights[v][i] > 0 ? all[v][i] : std::uint16_t{0});
  accessors.push_back({{"bufferView", view(raw(flat), vertices)},
                       {"componentType", short_type},
                       {"count", all.size()},
                       {"type", "VEC4"}});
  return accessors.size() - 1;
}

std::size_t Buffer::picture(std::string_view png) { return view(png, plain); }

Sampled sampled(const Channel& c, Time beginning, bool steps) {
  Sampled s;
  const std::array<double, 4> none{};
  // A key at the time of an existing one replaces it.
  const auto key = [&](Time t, const std::array<double, 4>& v, const std::array<double, 4>* in = nullptr,
                       const std::array<double, 4>* out = nullptr) {
    const auto seconds = static_cast<float>((t - beginning).seconds());
    if (!s.times.empty() && seconds <= s.times.back()) {
      s.times.pop_back();
      s.values.resize(s.values.size() - (in ? 3 : 1) * c.width);
    }
    s.times.push_back(seconds);
    if (in) add(s.values, *in, c.width);
    add(s.values, v, c.width);
    if (out) add(s.values, *out, c.width);
  };
  if (steps && c.steps()) {
    s.way = "STEP";
    for (std::size_t i = 0; i < c.pieces.size(); ++i)
      if (c.pieces[i].shape == KeyPiece::held) key(c.pieces[i].from, c.pieces[i].begin);
    key(c.pieces.back().until, c.pieces.back().end);  // so that the animation is as long as the film
    return s;
  }
  const bool cubic =
      std::any_of(c.pieces.begin(), c.pieces.end(), [](const KeyPiece& p) { return p.shape == KeyPiece::cubic; });
  s.way = cubic ? "CUBICSPLINE" : "LINEAR";
  const auto slope = [&](const KeyPiece& p, bool leaving) {
    if (p.shape == KeyPiece::cubic) return leaving ? p.leaving : p.arriving;
    std::array<double, 4> even{};
    const double seconds = (p.until - p.from).seconds();
    if (p.shape == KeyPiece::straight && seconds > 0)
      for (std::size_t i = 0; i < c.width; ++i) even[i] = (p.end[i] - p.begin[i]) / seconds;
    return even;
  };
  std::array<double, 4> arriving = none;
  for (const KeyPiece& p : c.pieces) {
    const auto leaving = slope(p, true);
    cubic ? key(p.from, p.begin, &arriving, &leaving) : key(p.from, p.begin);
    arriving = slope(p, false);
  }
  cubic ? key(c.pieces.back().until, c.pieces.back().end, &arriving, &none)
        : key(c.pieces.back().until, c.pieces.back().end);
  return s;
}

void Timeline::animate(const Channel& c, Json target) {
  animate(sampled(c, beginning, steps), c.width, std::move(target));
}

void Timeline::animate(const Sampled& s, std::size_t width, Json target) {
  const std::size_t input = buffer.floats(s.times, 1, Buffer::plain, true);
  const std::size_t output = buffer.floats(s.values, width, Buffer::plain, false);
  channels.push_back({{"sampler", samplers.size()}, {"target", std::move(target)}});
  samplers.push_back({{"input", input}, {"output", output}, {"interpolation", s.way}});
  ++made.channels;
  made.keys += s.times.size(), made.baked += frames;
}

void Timeline::point(const std::string& pointer, const Channel& c) {
  use("KHR_animation_pointer");
  animate(c, {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}});
}

void Timeline::use(const char* extension) {
  if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
}

Json numbers(const std::array<double, 4>& v, std::size_t width) {
  Json all = Json::array();
  for (std::size_t i = 0; i < width; ++i) all.push_back(static_cast<float>(v[i]));
  return all;
}

std::array<double, 4> within_one(std::array<double, 4> v) {
  for (double& x : v) x = std::clamp(x, 0.0, 1.0);
  return v;
}

std::vector<Time> keys_of(std::initializer_list<const Channel*> channels, Time from, Time until) {
  std::vector<Time> all;
  for (const Channel* c : channels) add_knots(*c, all);
  return knots_between(std::move(all), from, until);
}

}  // namespace betwixt::gltf
