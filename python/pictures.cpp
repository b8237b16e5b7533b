// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "pictures.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <unistd.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "base/files.h"
#include "betwixt/film.h"
#include "betwixt/language.h"
#include "betwixt/picture.h"
#include "betwixt/render.h"
#include "betwixt/sent.h"
#include "errors.h"
#include "playback/film_player.h"
#include "says.h"
#include "times.h"
#include "values.h"

namespace betwixt::python {
namespace {

using Size = std::optional<std::pair<int, int>>;
using Samples = std::optional<std::variant<int, std::string>>;

std::optional<int> number_of(const Samples& samples) {
  if (!samples) return {};
  if (const int* const n = std::get_if<int>(&*samples)) {
    if (*n == RenderOptions::auto_samples) raise(fail(ErrorCode::range, "0 samples per pixel cannot be drawn", "auto"));
    return *n;
  }
  const std::string& word = std::get<std::string>(*samples);
  if (word != "auto") raise(fail(ErrorCode::range, "samples is a number or \"auto\", not \"" + word + "\""));
  return RenderOptions::auto_samples;
}

std::optional<Blur> exposure_of(const Document& document, const std::optional<std::string>& shutter,
                                std::optional<int> subframes) {
  if (subframes && (*subframes < 1 || *subframes > 4096)) raise(fail(ErrorCode::range, "subframes are 1 to 4096"));
  std::optional<double> seconds;
  if (shutter) {
    const Result<double> read = parse_shutter(*shutter, document);
    if (!read) raise(read.error(), *shutter);
    seconds = *read;
  }
  return blur_for(document, seconds, subframes);
}

// Each thread keeps the renderer that it used last, because the next picture mostly has the same options.
Renderer& renderer_for(const RenderOptions& wanted) {
  static thread_local auto kept = std::make_unique<RendererCache>();
  static thread_local pid_t owner = ::getpid();
  // A forked process has only the memory of its parent's renderer, without the threads and the graphics context. It
  // cannot even destroy that renderer.
  if (std::exchange(owner, ::getpid()) != ::getpid()) (void)kept.release(), kept = std::make_unique<RendererCache>();
  return *value_or_raise(kept->get(wanted));
}

Pixels draw(const Program& program, Time t, RenderOptions options, const std::optional<Blur>& exposure,
            std::vector<std::string>& problems) {
  options.linear = program.document().transparent() || exposure;
  Renderer& renderer = renderer_for(options);
  Evaluation evaluation(program);
  Picture shown;
  if (options.linear) {
    LinearPicture light;
    if (!exposure) evaluation.to(t);
    value_or_raise(exposure ? renderer.render_blurred(evaluation, t, *exposure, light)
                            : renderer.render(evaluation, light));
    to_shown(light, shown);
  } else {
    evaluation.to(t);
    value_or_raise(renderer.render(evaluation, shown));
  }
  problems = evaluation.problems();
  return {std::make_shared<const Picture>(std::move(shown))};
}

RenderOptions options_of(const Document& document, const std::string& style, const Size& size, const Samples& samples,
                         const std::optional<std::string>& pixel_filter, bool denoise) {
  RenderOptions made = options_for(document, {.style = style, .denoise = denoise}, size, number_of(samples));
  if (pixel_filter) made.pixel_filter = *pixel_filter;
  return made;
}

Pixels picture(const Film& film, py::handle when, const Size& size, const std::string& style, const Samples& samples,
               const std::optional<std::string>& pixel_filter, const std::optional<std::string>& shutter,
               std::optional<int> subframes, bool denoise) {
  const Program program = unlocked([&] { return film.program(); });
  const Document& document = program.document();
  const Time t = time_of(when, document);
  const RenderOptions options = options_of(document, style, size, samples, pixel_filter, denoise);
  const auto exposure = exposure_of(document, shutter, subframes);
  std::vector<std::string> problems;
  Pixels made = unlocked([&] { return draw(program, t, options, exposure, problems); });
  for (const std::string& p : problems) warn(p);
  return made;
}

// Calls the progress function of the caller. An exception in it ends the film, and raise_again() raises it again.
class Telling {
 public:
  explicit Telling(py::object progress) : progress_(std::move(progress)) {}
  bool operator()(int done, int frames, double seconds) {
    const py::gil_scoped_acquire locked;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      return progress_.is_none() || !progress_(done, frames, seconds).is(py::bool_(false));
    } catch (py::error_already_set& e) {
      raised_ = std::move(e);
      return false;
    }
  }
  void raise_again() {
    if (raised_) throw std::move(*raised_);
  }

 private:
  py::object progress_;
  std::optional<py::error_already_set> raised_;
};

ColorCoding coding_of(const std::string& name) {
  const auto* const at = std::find(color_coding_names.begin(), color_coding_names.end(), name);
  if (at == color_coding_names.end())
    raise(fail(ErrorCode::range, "colors must be srgb, p3, rec2020, pq or hlg, not '" + name.substr(0, 60) + "'"));
  return static_cast<ColorCoding>(at - color_coding_names.begin());
}

FilmStats render(const Film& film, const std::filesystem::path& path,
                 const std::optional<std::pair<py::object, py::object>>& segment, const Size& size,
                 const std::string& style, const Samples& samples, const std::optional<std::string>& pixel_filter,
                 const std::optional<std::string>& shutter, std::optional<int> subframes, bool denoise, int bits,
                 const std::string& colors, int jobs, bool overwrite, bool missing, py::object progress) {
  const Program program = unlocked([&] { return film.program(); });
  const Document& document = program.document();
  auto [first, last] = document.range();
  if (segment) first = time_of(segment->first, document), last = time_of(segment->second, document);
  if (segment && last < first) raise(fail(ErrorCode::range, "the segment ends before it begins"));
  const FrameList frames = value_or_raise(frames_between(first, last, document.rate()));
  RenderJob job =
      render_job(program, path.string(), frames, options_of(document, style, size, samples, pixel_filter, denoise),
                 exposure_of(document, shutter, subframes), bits, coding_of(colors));
  job.film.jobs = jobs, job.film.overwrite = overwrite, job.film.only_missing = missing;
  value_or_raise(check_options(job.pictures));
  std::mutex mutex;
  std::set<std::string> problems;
  const auto tell = [&](const std::vector<std::string>& all) {
    const std::lock_guard lock(mutex);
    problems.insert(all.begin(), all.end());
  };
  Telling telling(std::move(progress));
  const Result<FilmStats> made = unlocked([&] {
    const auto told = [&](int done, int of, double seconds) { return telling(done, of, seconds); };
    return job.pictures.linear ? make_linear_film(
                                     job.film, [&] { return linear_painter_of(program, job, tell); }, told)
                               : make_film(
                                     job.film, [&] { return painter_of(program, job, tell); }, told);
  });
  telling.raise_again();
  for (const std::string& p : problems) warn(p);
  return value_or_raise(made);
}

py::bytes png_of(const Pixels& p) {
  return py::bytes(value_or_raise(unlocked([&] { return to_png(*p.picture); })));
}

Status write_picture(const std::string& path, const Picture& picture, bool overwrite) {
  const std::string kind = ending(path);
  if (kind == "jpg" || kind == "jpeg") return write_jpeg(path, picture, 92, overwrite);
  if (kind == "png") return write_png(path, picture, overwrite);
  return fail(ErrorCode::range, "a picture is written as .png or .jpg, not \"" + path + "\"",
              kind == "exr" ? "betwixt frame FILE --at TIME -o NAME.exr writes OpenEXR" : "");
}

py::array_t<std::uint8_t> pixels_of(const Pixels& p) {
  const py::ssize_t w = p.picture->width, h = p.picture->height;
  return view(p.picture->rgba.data(), {h, w, 4}, {4 * w, 4, 1}, keep(p.picture));
}

}  // namespace

void bind_pictures(py::module_& m, py::class_<Film>& film) {
  py::class_<Pixels>(m, "Picture", "A picture: 8 bits a channel, sRGB, straight opacity, rows from the top.")
      .def_property_readonly(
          "width", [](const Pixels& p) { return p.picture->width; }, "In pixels.")
      .def_property_readonly(
          "height", [](const Pixels& p) { return p.picture->height; }, "In pixels.")
      .def_property_readonly("pixels", pixels_of, "The picture itself, not a copy: [row, column, r g b a].")
      .def(
          "__array__",
          [](const Pixels& p, py::handle dtype) {
            py::object made = pixels_of(p);
            return dtype.is_none() ? made : made.attr("astype")(dtype);
          },
          py::arg("dtype") = py::none(), says("Returns the pixels as an array, for numpy."))
      .def("png", png_of, says("Returns the bytes of a PNG."))
      .def("_repr_png_", png_of, says("The same, for notebooks."))
      .def(
          "write",
          [](const Pixels& p, const std::filesystem::path& path, bool overwrite) {
            value_or_raise(unlocked([&] { return write_picture(path.string(), *p.picture, overwrite); }));
          },
          py::arg("path"), py::kw_only(), py::arg("overwrite") = true,
          says("Writes a PNG or a JPEG; the file's extension chooses."))
      .def(
          "__repr__",
          [](const Pixels& p) {
            return "<Picture " + std::to_string(p.picture->width) + "x" + std::to_string(p.picture->height) + ">";
          },
          says("Returns its size as a text."));
  py::class_<FilmStats>(m, "Made", "The result of making a film: counts and times.")
      .def_readonly("frames", &FilmStats::frames, "How many frames it has.")
      .def_readonly("found", &FilmStats::found, "How many pictures already existed.")
      .def_readonly("seconds", &FilmStats::seconds, "The seconds that it took.")
      .def_readonly("painting", &FilmStats::painting, "Seconds of painting, summed over all painters.")
      .def_readonly("encoding", &FilmStats::encoding, "Seconds of encoding.")
      .def(
          "__repr__", [](const FilmStats& s) { return "<Made of " + std::to_string(s.frames) + " frames>"; },
          says("How many frames it has."));
  film.def("picture", picture, py::arg("time"), py::kw_only(), py::arg("size") = py::none(),
           py::arg("style") = "shaded", py::arg("samples") = py::none(), py::arg("pixel_filter") = py::none(),
           py::arg("shutter") = py::none(), py::arg("subframes") = py::none(), py::arg("denoise") = true,
           says("Returns the picture at a time. Options that you leave out come from the script."));
  film.def("render", render, py::arg("path"), py::kw_only(), py::arg("frames") = py::none(),
           py::arg("size") = py::none(), py::arg("style") = "shaded", py::arg("samples") = py::none(),
           py::arg("pixel_filter") = py::none(), py::arg("shutter") = py::none(), py::arg("subframes") = py::none(),
           py::arg("denoise") = true, py::arg("bits") = 8, py::arg("colors") = "srgb", py::arg("jobs") = 0,
           py::arg("overwrite") = true, py::arg("missing") = false, py::arg("progress") = py::none(),
           says("Makes a film, or numbered pictures, in the format of the ending. `progress(done, frames, seconds)` is "
                "called "
                "now and then. If it returns False, the film ends and no file is left."));
  m.def(
      "send",
      [](const std::string& name, const py::bytes& data) {
        const std::string bytes = data;
        return value_or_raise(unlocked([&] { return send_bytes(name, bytes); }));
      },
      py::arg("name"), py::arg("data"),
      says("Gives this process the contents of a file: a picture, mesh, scene, drawing or sound, as the ending of the "
           "name says. From then on every film can write \"@NAME\" where it can name a file: texture=\"@logo.png\". "
           "Returns "
           "the full name, which means these bytes for ever."));
  m.def(
      "styles",
      [] {
        std::vector<std::string_view> names;
        for (const Style& s : styles()) names.push_back(s.name);
        return names;
      },
      says("Returns the names of all drawing styles."));
}

}  // namespace betwixt::python
