// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/x_display.h"

#include <X11/Xutil.h>
#include <fmt/format.h>

#include <bit>

namespace betwixt {

Result<Display*> open_display(std::string_view what, Hint hint) {
  Display* const display = XOpenDisplay(nullptr);
  if (!display) return fail(ErrorCode::machine, fmt::format("{} needs a display", what), std::move(hint));
  const int screen = DefaultScreen(display);
  const Visual* visual = DefaultVisual(display, screen);
  if (DefaultDepth(display, screen) >= 24 && visual->red_mask && visual->green_mask && visual->blue_mask)
    return display;
  XCloseDisplay(display);
  return fail(ErrorCode::machine, "the display must have 24-bit colours");
}

void outlive(Display* display, bool& gone) {
  XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
  XSetIOErrorHandler([](Display*) { return 0; });
  XSetIOErrorExitHandler(
      display, [](Display*, void* flag) { *static_cast<bool*>(flag) = true; }, &gone);
}

void to_pixels(const Picture& p, const Visual& visual, std::vector<std::uint32_t>& out) {
  const auto place = [](std::uint8_t v, unsigned long mask) {
    return static_cast<std::uint32_t>(v) << std::countr_zero(mask);
  };
  out.resize(static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height));
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::uint8_t* rgba = &p.rgba[4 * i];
    out[i] = place(rgba[0], visual.red_mask) | place(rgba[1], visual.green_mask) | place(rgba[2], visual.blue_mask);
  }
}

XImage* image_of(Display* display, std::vector<std::uint32_t>& pixels, int width, int height) {
  const int screen = DefaultScreen(display);
  XImage* const image = XCreateImage(
      display, DefaultVisual(display, screen), static_cast<unsigned>(DefaultDepth(display, screen)), ZPixmap, 0,
      reinterpret_cast<char*>(pixels.data()), static_cast<unsigned>(width), static_cast<unsigned>(height), 32, 0);
  if (image) image->byte_order = std::endian::native == std::endian::little ? LSBFirst : MSBFirst;
  return image;
}

void end_image(XImage* image) {
  if (!image) return;
  image->data = nullptr;
  XDestroyImage(image);
}

}  // namespace betwixt
