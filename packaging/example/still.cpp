// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <betwixt/language.h>
#include <betwixt/picture.h>
#include <betwixt/program.h>
#include <betwixt/render.h>

#include <cstdio>

int main() {
  const auto film = betwixt::load_file("bounce.bx");
  for (const auto& d : film.diagnostics) std::fputs(to_string(d).c_str(), stderr);
  const auto program = betwixt::Program::compile(film.document);
  const betwixt::Frame frame = program.frame(film.document.rate().frame(24));
  auto renderer = betwixt::make_renderer({.width = 640, .height = 360});
  betwixt::Picture picture;
  if (!renderer) return std::fputs(to_string(renderer.error()).c_str(), stderr), 1;
  return (*renderer)->render(frame, picture) && write_png("still.png", picture) ? 0 : 1;
}
