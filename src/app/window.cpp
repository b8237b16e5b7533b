// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/window.h"

#include <X11/Xutil.h>

#include <cstdint>
#include <vector>

#include "app/x_display.h"

namespace betwixt {
namespace {

class XWindow final : public Window {
 public:
  XWindow(Display* display, const std::string& title, int width, int height)
      : display_(display), width_(width), height_(height) {
    outlive(display_, gone_);
    const int screen = DefaultScreen(display_);
    visual_ = DefaultVisual(display_, screen);
    depth_ = DefaultDepth(display_, screen);
    window_ = XCreateSimpleWindow(display_, RootWindow(display_, screen), 0, 0, static_cast<unsigned>(width),
                                  static_cast<unsigned>(height), 0, 0, 0);
    XStoreName(display_, window_, title.c_str());
    XSizeHints hints{};
    hints.flags = PMinSize | PMaxSize;
    hints.min_width = hints.max_width = width, hints.min_height = hints.max_height = height;
    XSetWMNormalHints(display_, window_, &hints);
    delete_ = XInternAtom(display_, "WM_DELETE_WINDOW", False);
    XSetWMProtocols(display_, window_, &delete_, 1);
    XSelectInput(display_, window_, StructureNotifyMask);
    pixmap_ = XCreatePixmap(display_, window_, static_cast<unsigned>(width), static_cast<unsigned>(height),
                            static_cast<unsigned>(depth_));
    XMapWindow(display_, window_);
    pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    image_ = image_of(display_, pixels_, width, height);
    XFlush(display_);
  }
  ~XWindow() override {
    end_image(image_);
    if (gone_) return;  // the connection is closed
    XFreePixmap(display_, pixmap_);
    XDestroyWindow(display_, window_);
    XCloseDisplay(display_);
  }

  void draw(const Picture& p) override {
    if (p.width == width_ && p.height == height_) to_pixels(p, *visual_, pixels_);
  }
  void show() override {
    if (closed() || !image_) return;
    // Sets the window's background: the display restores it by itself after another window covered it.
    XPutImage(display_, pixmap_, DefaultGC(display_, DefaultScreen(display_)), image_, 0, 0, 0, 0,
              static_cast<unsigned>(width_), static_cast<unsigned>(height_));
    XSetWindowBackgroundPixmap(display_, window_, pixmap_);
    XClearWindow(display_, window_);
    if (!gone_) XFlush(display_);
  }
  bool closed() override {
    while (!gone_ && !closed_ && XPending(display_) > 0) {
      XEvent event;
      XNextEvent(display_, &event);
      closed_ = event.type == DestroyNotify ||
                (event.type == ClientMessage && static_cast<Atom>(event.xclient.data.l[0]) == delete_);
    }
    return gone_ || closed_;
  }

 private:
  Display* display_;
  int width_, height_, depth_ = 24;
  bool gone_ = false, closed_ = false;
  Visual* visual_ = nullptr;
  ::Window window_ = 0;
  Pixmap pixmap_ = 0;
  Atom delete_ = 0;
  XImage* image_ = nullptr;
  std::vector<std::uint32_t> pixels_;
};

}  // namespace

bool Window::has_display() {
  Display* display = XOpenDisplay(nullptr);
  if (display) XCloseDisplay(display);
  return display != nullptr;
}

Result<std::unique_ptr<Window>> Window::open(const std::string& title, int width, int height) {
  const auto display = open_display("a window", "set DISPLAY, or use the terminal, a film or a ring");
  if (!display) return display.error();
  return std::unique_ptr<Window>(std::make_unique<XWindow>(*display, title, width, height));
}

}  // namespace betwixt
