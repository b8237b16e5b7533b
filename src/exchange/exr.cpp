// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenEXR: half floats, linear light, premultiplied alpha.
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfIO.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>

#include "base/files.h"
#include "betwixt/picture.h"
#include "exchange/pictures.h"

namespace betwixt {
namespace {

// Stores the file in memory, because our own code writes files atomically.
class Written final : public Imf::OStream {
 public:
  explicit Written(const std::string& name) : OStream(name.c_str()) {}
  void write(const char bytes[], int n) override {
    const std::size_t end = at_ + static_cast<std::size_t>(n);
    if (end > all.size()) all.resize(end);
    std::memcpy(all.data() + at_, bytes, static_cast<std::size_t>(n));
    at_ = end;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t to) override { at_ = to; }
  std::string all;

 private:
  std::size_t at_ = 0;
};

class Read final : public Imf::IStream {
 public:
  Read(std::string_view all, const std::string& name) : IStream(name.c_str()), all_(all) {}
  bool read(char to[], int n) override {
    const auto wanted = static_cast<std::size_t>(n);
    if (at_ > all_.size() || all_.size() - at_ < wanted) throw std::runtime_error("it ends too early");
    std::memcpy(to, all_.data() + at_, wanted);
    at_ += wanted;
    return at_ < all_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t to) override { at_ = to; }

 private:
  const std::string_view all_;
  std::size_t at_ = 0;
};

// Clamps to the largest half. NaN becomes 0, because it would spread in every blur.
half half_of(float x) { return std::isnan(x) ? 0.0F : std::clamp(x, -65504.0F, 65504.0F); }

Imf::Chromaticities primaries_of(ColorCoding c) {
  const Imath::V2f white(0.3127F, 0.329F);
  if (c == ColorCoding::srgb) return {};  // those of BT.709
  if (c == ColorCoding::p3) return {{0.68F, 0.32F}, {0.265F, 0.69F}, {0.15F, 0.06F}, white};
  return {{0.708F, 0.292F}, {0.17F, 0.797F}, {0.131F, 0.046F}, white};
}

// Converts light with other primaries and the white of sRGB.
void to_srgb_primaries(LinearPicture& picture, const Imf::Header& head) {
  if (!Imf::hasChromaticities(head)) return;
  const Imf::Chromaticities is = Imf::chromaticities(head), srgb;
  const auto same = [](const Imath::V2f& a, const Imath::V2f& b) { return (a - b).length() < 1e-3F; };
  if ((same(is.red, srgb.red) && same(is.green, srgb.green) && same(is.blue, srgb.blue)) || !same(is.white, srgb.white))
    return;
  const Imath::M44f m = Imf::RGBtoXYZ(is, 1) * Imf::XYZtoRGB(srgb, 1);
  for (std::size_t i = 0; i + 4 <= picture.rgba.size(); i += 4) {
    const Imath::V3f c = Imath::V3f(picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]) * m;
    picture.rgba[i] = c.x, picture.rgba[i + 1] = c.y, picture.rgba[i + 2] = c.z;
  }
}

}  // namespace

Status write_exr(const std::string& path, const LinearPicture& picture, bool overwrite, ColorCoding colors) {
  if (Status s = check_picture(picture.width, picture.height, picture.rgba.size()); !s) return s;
  std::vector<Imf::Rgba> pixels(picture.rgba.size() / 4);
  LinearPicture changed;
  if (colors != ColorCoding::srgb) changed = picture, change_primaries(changed, colors);
  const LinearPicture& light = colors == ColorCoding::srgb ? picture : changed;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const float* const p = &light.rgba[4 * i];
    pixels[i] = {half_of(p[0]), half_of(p[1]), half_of(p[2]), half_of(p[3])};
  }
  try {
    Written out(path);
    {
      Imf::Header head(picture.width, picture.height);
      head.compression() = Imf::ZIP_COMPRESSION;
      Imf::addChromaticities(head, primaries_of(colors));
      Imf::RgbaOutputFile file(out, head, Imf::WRITE_RGBA, 0);
      file.setFrameBuffer(pixels.data(), 1, static_cast<std::size_t>(picture.width));
      file.writePixels(picture.height);
    }
    return write_whole(path, out.all, overwrite);
  } catch (const std::exception& e) {
    return fail(ErrorCode::machine, fmt::format("cannot encode {}: {}", path, e.what()));
  }
}

Result<LinearPicture> decode_exr(std::string_view bytes, const std::string& name) {
  try {
    Read in(bytes, name);
    Imf::RgbaInputFile file(in, 0);
    const auto box = file.dataWindow();
    const std::int64_t width = std::int64_t{box.max.x} - box.min.x + 1,
                       height = std::int64_t{box.max.y} - box.min.y + 1;
    if (Status s = check_size(name, width, height); !s) return s.error();
    if (!file.isComplete()) return fail(ErrorCode::file, fmt::format("{} is broken: it ends too early", name));
    std::vector<Imf::Rgba> pixels(static_cast<std::size_t>(width * height));
    file.setFrameBuffer(pixels.data() - box.min.x - box.min.y * width, 1, static_cast<std::size_t>(width));
    file.readPixels(box.min.y, box.max.y);
    LinearPicture out{static_cast<int>(width), static_cast<int>(height), {}};
    out.rgba.reserve(4 * pixels.size());
    for (const Imf::Rgba& p : pixels) out.rgba.insert(out.rgba.end(), {p.r, p.g, p.b, p.a});
    to_srgb_primaries(out, file.header());
    return out;
  } catch (const std::exception& e) {
    return fail(ErrorCode::file, fmt::format("{} is broken or not a picture: {}", name, e.what()));
  }
}

}  // namespace betwixt
