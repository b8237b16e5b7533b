// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/sink.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <ranges>

#include "base/files.h"
#include "betwixt/picture.h"
#include "betwixt/sound.h"
#include "film/chapters.h"
#include "film/numbered.h"
#include "film/partial.h"
#include "film/samples.h"
#include "film/yuv.h"

namespace betwixt {
namespace {

class Movie final : public Sink {
 public:
  Movie(const FilmOptions& o, Output place)
      : options_(o), place_(std::move(place)), partial_(place_, Partial::What::file) {
    options_.alpha &= place_.format->alpha;
  }

  Status start() {
    if (Status s = check_place(options_.path, options_.overwrite); !s) return s;
    // Made here and not by ffmpeg, so that a folder without write permission is a clear error of our own.
    if (Status s = partial_.make(); !s) return s;
    if (options_.sounds && !place_.format->sound.empty())
      if (Status s = samples_.make(options_, place_.folder); !s) return s;
    if (!options_.captions.empty() && !place_.format->captions.empty())
      if (Status s = captions_.make(options_.captions, options_, place_.folder); !s) return s;
    if (!options_.chapters.empty() && !place_.format->sound.empty())  // formats with sound have chapters
      if (Status s = chapters_.make(chapters_metadata(options_.chapters), options_, place_.folder); !s) return s;
    const auto path = [](const Samples& file) { return file.made() ? file.path() : std::string(); };
    auto encoder = Encoder::start(encoder_arguments(options_, *place_.format, partial_.path(),
                                                    {path(samples_), path(captions_), path(chapters_)}));
    if (!encoder) return encoder.error();
    encoder_ = *std::move(encoder);
    return Nothing{};
  }

  Status pack(int, Parcel& parcel) override {
    if (!options_.alpha) lay_over_black(parcel);
    if (options_.colors != ColorCoding::srgb) return pack_colors(parcel);
    if (place_.format->sixteen_bits) return pack_16_bits(parcel), Nothing{};
    if (parcel.linear.width > 0) to_shown(parcel.linear, parcel.picture);
    if (place_.format->yuv) to_yuv420(parcel.picture, options_.alpha, parcel.bytes);
    return Nothing{};
  }

  Status take(const Parcel& parcel, const KeepGoing& keep_going) override {
    return encoder_->write(parcel.bytes.empty() ? parcel.picture.rgba : parcel.bytes, keep_going);
  }

  Status finish(const KeepGoing& keep_going) override {
    if (Status s = encoder_->finish(keep_going); !s) return s;
    if (partial_.size() == 0) return encoder_->wrote_nothing();
    if (Status s = partial_.written(); !s) return s;
    if (Status s = put_in_place(partial_.path(), options_.path, options_.overwrite); !s) return s;
    partial_.moved();
    return Nothing{};
  }

 private:
  Status pack_colors(Parcel& parcel) const {
    if (parcel.linear.width == 0) return fail(ErrorCode::range, "pictures of linear light are needed for other colors");
    const std::vector<std::uint16_t> channels = to_coded_16(parcel.linear, options_.colors);
    if (!place_.format->yuv) return in_bytes(channels, parcel.bytes), Nothing{};
    to_yuv420_10(parcel.linear.width, parcel.linear.height, channels,
                 options_.colors == ColorCoding::p3 ? YuvMatrix::bt709 : YuvMatrix::bt2020, parcel.bytes);
    return Nothing{};
  }
  // Adds in linear light, not in bytes.
  static void lay_over_black(Parcel& parcel) {
    if (parcel.linear.width > 0) return make_opaque(parcel.linear);
    Picture& shown = parcel.picture;
    std::uint32_t common = ~0U;  // the bits that all pixels have
    for (std::size_t i = 0; i + 3 < shown.rgba.size(); i += 4) {
      std::uint32_t pixel;
      std::memcpy(&pixel, &shown.rgba[i], 4);
      common &= pixel;
    }
    if (std::bit_cast<std::array<std::uint8_t, 4>>(common)[3] == 255) return;
    LinearPicture light = to_light(shown.width, shown.height, doubled(shown.rgba));
    make_opaque(light);
    to_shown(light, shown);
  }
  static void make_opaque(LinearPicture& light) {
    for (std::size_t i = 3; i < light.rgba.size(); i += 4) light.rgba[i] = 1;
  }
  static std::vector<std::uint16_t> doubled(const std::vector<std::uint8_t>& bytes) {
    std::vector<std::uint16_t> all(bytes.size());
    std::ranges::transform(bytes, all.begin(),
                           [](std::uint8_t byte) { return static_cast<std::uint16_t>(257 * byte); });
    return all;
  }

  static void pack_16_bits(Parcel& parcel) {
    in_bytes(parcel.linear.width > 0 ? to_shown_16(parcel.linear) : doubled(parcel.picture.rgba), parcel.bytes);
  }
  // Sixteen bits a channel, little-endian.
  static void in_bytes(const std::vector<std::uint16_t>& channels, std::vector<std::uint8_t>& bytes) {
    bytes.clear();
    bytes.reserve(2 * channels.size());
    for (const std::uint16_t c : channels)
      bytes.insert(bytes.end(), {static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(c >> 8)});
  }

  FilmOptions options_;
  const Output place_;
  Partial partial_;
  Samples samples_, captions_, chapters_;
  std::unique_ptr<Encoder> encoder_;  // destroyed first: it writes and reads the others
};

// Pictures are collected in a hidden folder and renamed together: a film is complete or not there at all. With
// `missing`, each picture is renamed as soon as it is complete.
class Pictures final : public Sink {
 public:
  Pictures(const FilmOptions& o, Output place)
      : options_(o), place_(std::move(place)), partial_(place_, Partial::What::folder), count_(o.frames) {}

  Status start() {
    for (int k = 0; k < (options_.only_missing ? 1 : count_); ++k)
      if (Status s = check_place(place_.path(number(k)), options_.overwrite); !s) return s;
    for (int k = 0; k < count_ && options_.only_missing && !place_.exr; ++k)
      if (std::string what =
              made_otherwise(place_.path(number(k)), options_.width, options_.height, options_.bits, options_.colors);
          !what.empty())
        return fail(ErrorCode::range, std::move(what),
                    "render the missing pictures with the same settings, or in another folder");
    if (Status s = partial_.make(); !s) return s;
    gathering_ = place_;
    gathering_.folder = partial_.path();
    return Nothing{};
  }

  Status pack(int k, Parcel& parcel) override {
    const std::string hidden = gathering_.path(number(k));
    Status written = write(hidden, parcel);
    if (written) return options_.only_missing ? place(k) : written;
    Error e = written.error();  // with the picture's final name, not its hidden one
    const std::size_t at = e.message.find(hidden);
    if (at != std::string::npos) e.message.replace(at, hidden.size(), place_.path(number(k)));
    e.code = ErrorCode::machine;  // a moment ago the folder was writable
    return e;
  }
  Status take(const Parcel&, const KeepGoing&) override { return Nothing{}; }
  bool single_pictures() const override { return true; }
  bool stands(int k) const override {
    return options_.only_missing && whole_picture(place_.path(number(k)), options_.width, options_.height);
  }

  Status finish(const KeepGoing&) override {
    for (int k = 0; k < count_ && !options_.only_missing; ++k)
      if (Status s = place(k); !s) return s;
    return Nothing{};
  }

 private:
  Status write(const std::string& path, Parcel& parcel) const {
    if (place_.exr || options_.bits == 16 || options_.colors != ColorCoding::srgb) {
      if (parcel.linear.width == 0)
        return fail(ErrorCode::range, "pictures of linear light are needed for " + place_.name);
      return place_.exr ? write_exr(path, parcel.linear, true, options_.colors)
                        : write_png(path, parcel.linear, true, options_.colors);
    }
    if (parcel.linear.width > 0) to_shown(parcel.linear, parcel.picture);
    return write_png(path, parcel.picture);
  }
  Status place(int k) const {
    return put_in_place(gathering_.path(number(k)), place_.path(number(k)), options_.overwrite);
  }
  int number(int k) const { return options_.first_number + k; }

  const FilmOptions options_;
  const Output place_;
  Partial partial_;
  Output gathering_;
  const int count_;
};

template <class T>
Result<std::unique_ptr<Sink>> started(const FilmOptions& o, const Output& place) {
  auto sink = std::make_unique<T>(o, place);
  if (Status s = sink->start(); !s) return s.error();
  return std::unique_ptr<Sink>(std::move(sink));
}

}  // namespace

std::vector<std::string> encoder_arguments(const FilmOptions& o, const Format& format, const std::string& file,
                                           const EncoderFiles& files) {
  const bool yuv = format.yuv;
  const int even = yuv ? 1 : 0;  // to_yuv420 has made the sizes even
  std::vector<std::string> a{"ffmpeg",  "-hide_banner", "-nostdin", "-loglevel", "error",
                             "-xerror", "-y",           "-f",       "rawvideo"};
  const auto add = [&](std::initializer_list<const char*> more) { a.insert(a.end(), more.begin(), more.end()); };
  const auto tags = [&] {
    const std::vector<std::string> all = color_tags(o.colors);
    a.insert(a.end(), all.begin(), all.end());
  };
  add({"-pix_fmt",
       yuv && o.alpha        ? "yuva420p"
       : yuv                 ? (o.colors == ColorCoding::srgb ? "yuv420p" : "yuv420p10le")
       : format.sixteen_bits ? "rgba64le"
                             : "rgba",
       "-video_size"});
  a.push_back(fmt::format("{}x{}", o.width + (o.width & even), o.height + (o.height & even)));
  a.insert(a.end(), {"-framerate", fmt::format("{}/{}", o.rate.num, o.rate.den)});
  if (yuv) tags();
  add({"-i", "pipe:0"});
  const bool sound = !files.samples.empty(), captions = !files.captions.empty(), chapters = !files.chapters.empty();
  if (sound)
    a.insert(a.end(), {"-f", "f32le", "-ar", std::to_string(sound_rate), "-ac", "2", "-i", "file:" + files.samples});
  if (captions) a.insert(a.end(), {"-f", "srt", "-i", "file:" + files.captions});
  if (chapters) {
    a.insert(a.end(), {"-f", "ffmetadata", "-i", "file:" + files.chapters});
    a.insert(a.end(), {"-map_chapters", std::to_string(1 + sound + captions)});
  }
  if (sound || captions) add({"-map", "0:v"});
  if (sound) {
    add({"-map", "1:a"});
    for (const auto word : std::views::split(format.sound, ' ')) a.emplace_back(word.begin(), word.end());
  }
  if (captions) a.insert(a.end(), {"-map", sound ? "2:s" : "1:s", "-c:s", std::string(format.captions)});
  if (yuv) tags();
  const std::vector<std::string> how = arguments_of(format, o);
  a.insert(a.end(), how.begin(), how.end());
  a.push_back("file:" + file);  // "file:" makes it a file, whatever its name looks like
  return a;
}

Result<std::unique_ptr<Sink>> make_sink(const FilmOptions& o) {
  const Result<Output> place = read_output(o.path);
  if (!place) return place.error();
  if (o.bits == 16 && (place->format || place->exr))
    return fail(ErrorCode::range, "--bits 16 is only for numbered PNG; .mov and .exr always have more than 8 bits");
  if (Status s = check_colors(o.path, o.colors, o.alpha); !s) return s.error();
  if (o.only_missing && place->format)
    return fail(ErrorCode::range, "--missing is only for numbered pictures",
                "render to frame-%04d.png; betwixt join makes a film of the pictures");
  return place->format ? started<Movie>(o, *place) : started<Pictures>(o, *place);
}

bool takes_sound(const std::string& path) {
  const Result<Output> place = read_output(path);
  return place && place->format && !place->format->sound.empty();
}

bool takes_captions(const std::string& path) {
  const Result<Output> place = read_output(path);
  return place && place->format && !place->format->captions.empty();
}

bool takes_alpha(const std::string& path) {
  const Result<Output> place = read_output(path);
  return place && (!place->format || place->format->alpha);
}

bool takes_16_bits(const std::string& path) {
  const Result<Output> place = read_output(path);
  return place && (place->format ? place->format->sixteen_bits : place->exr);
}

bool takes_unclamped_light(const std::string& path) {
  const Result<Output> place = read_output(path);
  return place && place->exr;
}

}  // namespace betwixt
