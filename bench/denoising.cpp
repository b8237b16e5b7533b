// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares traced pictures of few samples with one of many: 64 samples as they are, 16 with the denoiser, and as many
// as each pixel needs. PSNR in decibels and SSIM of the shown picture, and processor time.
//
//   bench_denoising FOLDER-OF-EXAMPLES FOLDER-FOR-PICTURES [SAMPLES-OF-THE-REFERENCE]
//
// All pictures are kept in the second folder; a reference that is there already is not drawn again.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "betwixt/language.h"
#include "betwixt/picture.h"
#include "betwixt/program.h"
#include "betwixt/render.h"
#include "timing.h"

using namespace betwixt;

namespace {

struct Shot {
  const char* film;
  const char* at;
};
constexpr Shot shots[] = {{"menagerie", "40f"}, {"funnel", "60f"}, {"four-balls", "70f"}, {"walk", "60f"},
                          {"bounce", "24f"},    {"mirror", "24f"}, {"marbles", "48f"}};

struct Way {
  const char* name;
  int samples;
  bool denoise;
};
constexpr Way ways[] = {{"16 raw", 16, false},     {"64 raw", 64, false},  {"16 denoised", 16, true},
                        {"64 denoised", 64, true}, {"auto raw", 0, false}, {"auto denoised", 0, true}};

double psnr(const Picture& a, const Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::pow(a.rgba[i] - b.rgba[i], 2);
  return sum == 0 ? 99 : 10 * std::log10(255 * 255 / (sum / static_cast<double>(a.rgba.size() / 4 * 3)));
}

double luma(const Picture& p, int x, int y) {
  const std::uint8_t* const c =
      &p.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) + static_cast<std::size_t>(x))];
  return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2];
}

// The mean over squares of 8 pixels (Wang and others, 2004).
double ssim(const Picture& a, const Picture& b) {
  constexpr int side = 8;
  constexpr double n = side * side, c1 = 6.5025, c2 = 58.5225;
  double sum = 0;
  int count = 0;
  for (int top = 0; top + side <= a.height; top += side / 2)
    for (int left = 0; left + side <= a.width; left += side / 2) {
      double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
      for (int y = top; y < top + side; ++y)
        for (int x = left; x < left + side; ++x) {
          const double u = luma(a, x, y), v = luma(b, x, y);
          sa += u, sb += v, saa += u * u, sbb += v * v, sab += u * v;
        }
      const double ma = sa / n, mb = sb / n, va = saa / n - ma * ma, vb = sbb / n - mb * mb, vab = sab / n - ma * mb;
      sum += (2 * ma * mb + c1) * (2 * vab + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2)), ++count;
    }
  return sum / count;
}

Picture drawn(const Program& program, Time t, int samples, bool denoise) {
  RenderOptions options;
  options.width = 320, options.height = 180, options.samples = samples, options.style = "traced";
  options.denoise = denoise;
  auto renderer = make_renderer(options);
  insist(static_cast<bool>(renderer), "a renderer");
  Picture out;
  insist(static_cast<bool>((*renderer)->render(program.frame(t), out)), "a picture");
  return out;
}

Picture reference(const Program& program, Time t, const std::string& path, int samples) {
  if (const auto kept = read_picture(path)) return **kept;
  Picture out = drawn(program, t, samples, false);
  insist(static_cast<bool>(write_png(path, out)), "a file");
  return out;
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) return std::fputs("bench_denoising FOLDER-OF-EXAMPLES FOLDER-FOR-PICTURES [SAMPLES]\n", stderr), 2;
  const std::string folder = words[2];
  const int samples = count > 3 ? std::atoi(words[3]) : 4096;
  fmt::print("| film | way | PSNR (dB) | SSIM | processor time (s) |\n|---|---|---|---|---|\n");
  for (const Shot& shot : shots) {
    const Loaded loaded = load_file(fmt::format("{}/{}.bx", words[1], shot.film));
    insist(!has_errors(loaded.diagnostics), "a film");
    const Program program = Program::compile(loaded.document);
    const Time t = *parse_time(shot.at, loaded.document);
    const Picture exact = reference(program, t, fmt::format("{}/{}-{}.png", folder, shot.film, samples), samples);
    for (const Way& way : ways) {
      Picture out;
      const double ms = processor_milliseconds([&] { out = drawn(program, t, way.samples, way.denoise); });
      fmt::print("| {} | {} | {:.1f} | {:.4f} | {:.2f} |\n", shot.film, way.name, psnr(out, exact), ssim(out, exact),
                 ms / 1000);
      std::fflush(stdout);
      std::string name = way.name;
      name.replace(name.find(' '), 1, "-");
      insist(static_cast<bool>(write_png(fmt::format("{}/{}-{}.png", folder, shot.film, name), out)), "a file");
    }
  }
}
