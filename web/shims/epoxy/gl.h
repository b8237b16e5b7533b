// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Replaces libepoxy, because the functions of WebGL 2 need not be looked up.
#pragma once

#include <GLES3/gl3.h>

// Returns whether WebGL has the feature of an OpenGL extension; enables it if necessary.
bool epoxy_has_gl_extension(const char* name);

constexpr GLenum GL_FRAMEBUFFER_SRGB_EXT = 0x8DB9;
