// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where WebGL 2 is the graphics interface, there is nothing to be found out about where its functions are.
#pragma once

#include <GLES3/gl3.h>

// Those of WebGL that are asked for are either part of it or switched on here.
bool epoxy_has_gl_extension(const char* name);

constexpr GLenum GL_FRAMEBUFFER_SRGB_EXT = 0x8DB9;
