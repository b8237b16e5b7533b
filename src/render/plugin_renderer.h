// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Renderers of plug-ins. Each runs in a process of its own, which shares a piece of memory with this one: the frame,
// and the picture that the plug-in fills.
#pragma once

#include "betwixt/render.h"

namespace betwixt {

// `patience`: the most milliseconds for a picture. Errors of the pictures: machine (the plug-in's function failed,
// crashed or took too long; or there is no memory). After a crash the next picture begins with a new process.
Result<std::unique_ptr<Renderer>> make_plugin_renderer(const RenderOptions&, int patience = 60'000);

}  // namespace betwixt
