// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/color_program.h"

#include <OpenColorIO/OpenColorIO.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "base/names.h"
#include "scene/light_in_stops.h"

namespace ocio = OCIO_NAMESPACE;

namespace betwixt {
namespace {

using Colors = Result<std::shared_ptr<const ColorTable>>;
using Names = std::vector<std::string>;

const OpenForLibrary* open_for_library = nullptr;

constexpr int cube_side = 65, curve_size = 4097;
constexpr std::size_t most_told = 12;  // names in an error

std::string some_of(const Names& all) {
  const Names first(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), most_told)));
  return fmt::format("{}{}", fmt::join(first, ", "), all.size() > most_told ? ", …" : "");
}

// Variables that would make the same configuration another one on another machine.
void forget_surroundings() {
  for (const char* name : {"OCIO", "OCIO_ACTIVE_DISPLAYS", "OCIO_ACTIVE_VIEWS", "OCIO_INACTIVE_COLORSPACES",
                           "OCIO_OPTIMIZATION_FLAGS", "OCIO_USER_CATEGORIES"})
    ::unsetenv(name);
}

// ---- which conversion

// Returns the name that is meant, which the configuration must have.
Result<std::string> choice(const std::string& asked, const Names& all, const std::string& otherwise, const char* what,
                           const std::string& of) {
  if (asked.empty()) return otherwise;
  if (std::find(all.begin(), all.end(), asked) != all.end()) return asked;
  const std::string has = all.empty() ? fmt::format("it has none") : fmt::format("it has {}", some_of(all));
  const Hint near = did_you_mean(asked, {all.begin(), all.end()});
  return fail(ErrorCode::name, fmt::format("{} has no {} '{}'; {}", of, what, asked, has), near);
}

// What configurations call linear light with the primaries of Rec.709.
constexpr const char* known_spaces[] = {
    "Linear Rec.709 (sRGB)",   "lin_rec709_scene", "lin_rec709",    "Linear Rec.709", "Utility - Linear - Rec.709",
    "Utility - Linear - sRGB", "lin_srgb",         "Linear sRGB",   "linear_srgb",    "lin_sRGB",
    "Linear BT.709",           "Linear Rec 709",   "linear_rec709", "Linear"};

// Rec.709 to ACES2065-1, with Bradford's adaptation from D65 to ACES' white.
constexpr double to_aces[16] = {0.4396329819,
                                0.3829886982,
                                0.1773783199,
                                0,
                                0.0897764430,
                                0.8134394287,
                                0.0967841283,
                                0,
                                0.0175411704,
                                0.1115465533,
                                0.8709122763,
                                0,
                                0,
                                0,
                                0,
                                1};

struct Start {
  std::string space;
  bool by_aces = false;  // the light must become ACES2065-1 first
};
Result<Start> start_of(const ocio::ConstConfigRcPtr& config, const std::string& asked, const std::string& name) {
  Names all;
  for (int i = 0; i < config->getNumColorSpaces(); ++i) all.emplace_back(config->getColorSpaceNameByIndex(i));
  if (!asked.empty()) {
    if (config->getColorSpace(asked.c_str())) return Start{asked};
    const auto space = choice(asked, all, "", "color space", name);
    return space.error();
  }
  for (const char* known : known_spaces)
    if (const auto space = config->getColorSpace(known)) return Start{space->getName()};
  if (config->hasRole("aces_interchange")) return Start{"aces_interchange", true};
  return fail(ErrorCode::name,
              fmt::format("{} names no color space that is linear light of Rec.709, and has no role aces_interchange; "
                          "it has {}",
                          name, some_of(all)),
              "name the one that it is: space=\"…\"");
}

Result<ocio::ConstTransformRcPtr> aces_matrix() {
  const auto matrix = ocio::MatrixTransform::Create();
  matrix->setMatrix(to_aces);
  return ocio::ConstTransformRcPtr(matrix);
}

struct Baking {
  ocio::ConstProcessorRcPtr first, then;  // `first` may be null
};

Result<Baking> of_configuration(const std::string& text, const std::string& path, const ColorQuery& q) {
  const std::string name = std::filesystem::path(path).filename().string();
  std::istringstream in(text);
  const auto config = ocio::Config::CreateFromStream(in)->createEditableCopy();
  config->setWorkingDir(std::filesystem::path(path).parent_path().c_str());
  Names displays, views, looks;
  for (int i = 0; i < config->getNumDisplays(); ++i) displays.emplace_back(config->getDisplay(i));
  if (displays.empty()) return fail(ErrorCode::file, fmt::format("{} has no display", name));
  const auto display = choice(q.display, displays, config->getDefaultDisplay(), "display", name);
  if (!display) return display.error();
  for (int i = 0; i < config->getNumViews(display->c_str()); ++i)
    views.emplace_back(config->getView(display->c_str(), i));
  if (views.empty()) return fail(ErrorCode::file, fmt::format("the display '{}' of {} has no view", *display, name));
  const auto view = choice(q.through, views, config->getDefaultView(display->c_str()), "view",
                           fmt::format("the display '{}' of {}", *display, name));
  if (!view) return view.error();
  for (int i = 0; i < config->getNumLooks(); ++i) looks.emplace_back(config->getLookNameByIndex(i));
  const auto look = choice(q.look, looks, "", "look", name);
  if (!look) return look.error();
  const auto start = start_of(config, q.space, name);
  if (!start) return start.error();
  const auto shown = ocio::DisplayViewTransform::Create();
  shown->setSrc(start->space.c_str()), shown->setDisplay(display->c_str()), shown->setView(view->c_str());
  const auto pipeline = ocio::LegacyViewingPipeline::Create();
  pipeline->setDisplayViewTransform(shown);
  if (!look->empty()) pipeline->setLooksOverrideEnabled(true), pipeline->setLooksOverride(look->c_str());
  Baking b;
  if (start->by_aces) b.first = config->getProcessor(*aces_matrix());
  b.then = pipeline->getProcessor(config, config->getCurrentContext());
  return b;
}

Baking of_look_file(const std::string& path) {
  const auto config = ocio::Config::CreateRaw()->createEditableCopy();
  config->setWorkingDir(std::filesystem::path(path).parent_path().c_str());
  const auto file = ocio::FileTransform::Create();
  file->setSrc(path.c_str()), file->setInterpolation(ocio::INTERP_BEST);
  return {nullptr, config->getProcessor(file)};
}

// ---- the table

std::vector<float> places(int size, bool in_stops) {
  std::vector<float> out(static_cast<std::size_t>(size));
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double place = static_cast<double>(i) / (size - 1);
    out[i] =
        static_cast<float>(in_stops ? (std::exp2(place * stops_to_white / place_of_white) - 1) / dark_stops : place);
  }
  return out;
}

Colors baked(const Baking& b, bool in_stops, const std::string& name) {
  auto table = std::make_shared<ColorTable>();
  table->takes = in_stops ? ColorTable::stops : ColorTable::picture;
  table->cube = (b.first && b.first->hasChannelCrosstalk()) || b.then->hasChannelCrosstalk();
  table->size = table->cube ? cube_side : curve_size;
  const std::vector<float> at = places(table->size, in_stops);
  const auto side = static_cast<std::size_t>(table->size), all = table->cube ? side * side * side : side;
  std::vector<float> rgb(3 * all);
  for (std::size_t i = 0; i < all; ++i)
    for (std::size_t c = 0, step = 1; c < 3; ++c, step *= side) rgb[3 * i + c] = at[table->cube ? i / step % side : i];
  for (const auto& processor : {b.first, b.then}) {
    if (!processor) continue;
    ocio::PackedImageDesc pixels(rgb.data(), static_cast<long>(all), 1, 3);
    processor->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS)->apply(pixels);
  }
  table->signals.resize(rgb.size());
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    if (std::isnan(rgb[i]))
      return fail(ErrorCode::file, fmt::format("{} makes no number of the color {} {} {}", name, at[i / 3 % side],
                                               at[table->cube ? i / 3 / side % side : i / 3],
                                               at[table->cube ? i / 3 / side / side : i / 3]));
    table->signals[i] = static_cast<std::uint16_t>(std::lround(65535 * std::clamp(rgb[i], 0.0F, 1.0F)));
  }
  return std::shared_ptr<const ColorTable>(std::move(table));
}

// ---- files for the library

// Notes the first file that the library asked for and did not get.
class Shelf {
 public:
  Shelf(FileSource& files, const OpenForLibrary& open, std::string path)
      : files_(files),
        open_([this, &open](const std::string& p) {
          const int file = open(p);
          if (file < 0) miss(p);
          return file;
        }),
        path_(std::move(path)) {
    open_for_library = &open_;
    ocio::SetComputeHashFunction([this](const std::string& p) {
      if (files_.has(p)) return p;
      miss(p);
      return std::string();
    });
  }
  ~Shelf() {
    open_for_library = nullptr;
    ocio::ResetComputeHashFunction();
  }
  Shelf(const Shelf&) = delete;
  Shelf& operator=(const Shelf&) = delete;
  // Returns the error if `why` is that of a file that is not there.
  Error explain(const ocio::Exception& e) const {
    const std::string name = std::filesystem::path(path_).filename().string();
    if (dynamic_cast<const ocio::ExceptionMissingFile*>(&e) != nullptr && !missed_.empty()) {
      const auto folder = std::filesystem::path(path_).parent_path();
      const std::string beside = std::filesystem::path(missed_).lexically_normal().lexically_relative(folder).string();
      if (beside.starts_with("..") || beside.empty())
        return fail(ErrorCode::file, fmt::format("{} names {}, which is outside its folder", name, missed_),
                    "copy it to a folder below that of the configuration");
      return fail(ErrorCode::file, fmt::format("{} names {}, which cannot be read", name, beside));
    }
    const std::string why = in_one_line(e.what());
    if (why.find("All formats have been tried") != why.npos)
      return fail(ErrorCode::file, fmt::format("{} is no look file that OpenColorIO can read", name));
    return fail(ErrorCode::file, fmt::format("{} cannot be read by OpenColorIO: {}", name, why));
  }

 private:
  void miss(const std::string& path) {
    if (missed_.empty()) missed_ = path;
  }
  static std::string in_one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.substr(0, 400);
  }
  FileSource& files_;
  const OpenForLibrary open_;
  const std::string path_;
  std::string missed_;
};

}  // namespace

Colors colors_by_ocio(const std::string& path, FileSource& files, const ColorQuery& q, const OpenForLibrary& open) {
  forget_surroundings();
  ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE);
  const std::string name = std::filesystem::path(path).filename().string();
  const Shelf shelf(files, open, path);
  try {
    if (!is_configuration(path)) return baked(of_look_file(path), q.of_light, name);
    const auto text = files.read(path);
    if (!text) return text.error();
    const auto baking = of_configuration(*text, path, q);
    if (!baking) return baking.error();
    return baked(*baking, true, name);
  } catch (const ocio::Exception& e) {
    return shelf.explain(e);
  }
}

}  // namespace betwixt

// Replaces that of the C library in this program, also for the libraries.
extern "C" __attribute__((visibility("default"))) FILE* fopen64(const char* path, const char* mode) {
  if (betwixt::open_for_library != nullptr) {
    const int file = (*betwixt::open_for_library)(path);
    return file < 0 ? nullptr : ::fdopen(file, mode);
  }
  using Open = FILE* (*)(const char*, const char*);
  static const auto next = reinterpret_cast<Open>(::dlsym(RTLD_NEXT, "fopen64"));
  return next != nullptr ? next(path, mode) : nullptr;
}
