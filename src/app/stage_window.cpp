// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/stage_window.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/keysym.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "app/x_display.h"

namespace betwixt {
namespace {

struct KeyMeaning {
  KeySym key;
  StageKey means;
};
constexpr KeyMeaning key_meanings[] = {
    {XK_Right, StageKey::next},       {XK_Down, StageKey::next},
    {XK_Page_Down, StageKey::next},   {XK_space, StageKey::next},
    {XK_Return, StageKey::next},      {XK_KP_Enter, StageKey::next},
    {XK_Left, StageKey::previous},    {XK_Up, StageKey::previous},
    {XK_Page_Up, StageKey::previous}, {XK_BackSpace, StageKey::previous},
    {XK_Home, StageKey::first},       {XK_End, StageKey::last},
    {XK_b, StageKey::blank},          {XK_period, StageKey::blank},
    {XK_p, StageKey::pause},          {XK_f, StageKey::fill},
    {XK_F11, StageKey::fill},         {XK_q, StageKey::quit},
    {XK_Escape, StageKey::quit},
};

std::optional<StageKey> meaning_of(KeySym key) {
  for (const KeyMeaning& k : key_meanings)
    if (k.key == key) return k.means;
  return std::nullopt;
}

class XStage final : public StageWindow {
 public:
  XStage(Display* display, const std::string& title, int width, int height, bool fills)
      : display_(display), width_(width), height_(height) {
    outlive(display_, gone_);
    const int screen = DefaultScreen(display_);
    visual_ = DefaultVisual(display_, screen);
    window_ = XCreateSimpleWindow(display_, RootWindow(display_, screen), 0, 0, static_cast<unsigned>(width),
                                  static_cast<unsigned>(height), 0, 0, 0);
    XStoreName(display_, window_, title.c_str());
    XChangeProperty(display_, window_, atom("_NET_WM_NAME"), atom("UTF8_STRING"), 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(title.data()), static_cast<int>(title.size()));
    if (fills) {  // before it is mapped, the property says it
      const Atom state = atom("_NET_WM_STATE_FULLSCREEN");
      XChangeProperty(display_, window_, atom("_NET_WM_STATE"), XA_ATOM, 32, PropModeReplace,
                      reinterpret_cast<const unsigned char*>(&state), 1);
    }
    delete_ = atom("WM_DELETE_WINDOW");
    XSetWMProtocols(display_, window_, &delete_, 1);
    XSelectInput(display_, window_, StructureNotifyMask | ExposureMask | KeyPressMask | ButtonPressMask);
    XMapWindow(display_, window_);
    XFlush(display_);
  }
  ~XStage() override {
    if (gone_) return;  // the connection is closed
    XDestroyWindow(display_, window_);
    XCloseDisplay(display_);
  }

  std::pair<int, int> size() const override { return {width_, height_}; }
  int connection() const override { return ConnectionNumber(display_); }

  void fill_screen(bool on) override {
    if (gone_) return;
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window_;
    event.xclient.message_type = atom("_NET_WM_STATE");
    event.xclient.format = 32;
    event.xclient.data.l[0] = on ? 1 : 0;
    event.xclient.data.l[1] = static_cast<long>(atom("_NET_WM_STATE_FULLSCREEN"));
    XSendEvent(display_, DefaultRootWindow(display_), False, SubstructureRedirectMask | SubstructureNotifyMask, &event);
    XFlush(display_);
  }

  void show(const Picture& p) override {
    if (gone_ || p.width <= 0 || p.height <= 0) return;
    to_pixels(p, *visual_, pixels_);
    XImage* const image = image_of(display_, pixels_, p.width, p.height);
    if (!image) return;
    XPutImage(display_, window_, DefaultGC(display_, DefaultScreen(display_)), image, 0, 0,
              std::max(0, (width_ - p.width) / 2), std::max(0, (height_ - p.height) / 2),
              static_cast<unsigned>(p.width), static_cast<unsigned>(p.height));
    end_image(image);
    if (!gone_) XSync(display_, False);
  }

  Events events() override {
    Events all;
    while (!gone_ && XPending(display_) > 0) {
      XEvent event;
      XNextEvent(display_, &event);
      if (event.type == KeyPress) {
        if (const auto key = meaning_of(XLookupKeysym(&event.xkey, 0))) all.keys.push_back(*key);
      } else if (event.type == ButtonPress) {
        if (event.xbutton.button == Button1) all.keys.push_back(StageKey::next);
        if (event.xbutton.button == Button3) all.keys.push_back(StageKey::previous);
      } else if (event.type == ConfigureNotify) {
        all.uncovered |= width_ != event.xconfigure.width || height_ != event.xconfigure.height;
        width_ = event.xconfigure.width, height_ = event.xconfigure.height;
      } else if (event.type == Expose) {
        all.uncovered = true;
      } else if (event.type == DestroyNotify ||
                 (event.type == ClientMessage && static_cast<Atom>(event.xclient.data.l[0]) == delete_)) {
        all.closed = true;
      }
    }
    all.closed |= gone_;
    return all;
  }

 private:
  Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

  Display* display_;
  int width_, height_;
  bool gone_ = false;
  Visual* visual_ = nullptr;
  ::Window window_ = 0;
  Atom delete_ = 0;
  std::vector<std::uint32_t> pixels_;
};

}  // namespace

Result<std::unique_ptr<StageWindow>> StageWindow::open(const std::string& title, int width, int height,
                                                       bool fills_screen) {
  const auto opened = open_display("a talk", "set DISPLAY, or write --pdf OUT.pdf");
  if (!opened) return opened.error();
  Display* const display = *opened;
  const int screen = DefaultScreen(display);
  if (fills_screen) width = DisplayWidth(display, screen), height = DisplayHeight(display, screen);
  return std::unique_ptr<StageWindow>(std::make_unique<XStage>(display, title, width, height, fills_screen));
}

}  // namespace betwixt
