// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What windows of the X window system share.
#pragma once

#include <X11/Xlib.h>

#include <cstdint>
#include <string_view>
#include <vector>

#include "betwixt/picture.h"
#include "betwixt/result.h"

namespace betwixt {

// `what` needs the display, and `hint` is the way without. Errors: machine (no display, or too few colours).
Result<Display*> open_display(std::string_view what, Hint hint);
// Sets `gone` when the display disappears or another program closes the window; Xlib would end the program.
void outlive(Display*, bool& gone);
// Makes the picture's pixels those of the display.
void to_pixels(const Picture&, const Visual&, std::vector<std::uint32_t>& out);
// Returns an image of these pixels, which stay the caller's: end_image() ends only the image. nullptr if there is no
// memory.
XImage* image_of(Display*, std::vector<std::uint32_t>& pixels, int width, int height);
void end_image(XImage*);

}  // namespace betwixt
