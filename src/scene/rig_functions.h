// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The joints of meshes. Only src/scene/functions.cpp includes this; its row comes after those of
// src/scene/camera_functions.h.
#pragma once

#include "scene/document.h"
#include "scene/functions.h"

namespace betwixt {

inline const FunctionSpec rig_functions[] = {
    {.name = "joints",
     .type = Type::names,
     .rest = Names(),
     .kinds = bit(Kind::mesh),
     .by_script = true,
     .sentence =
         "The objects that the vertices of a mesh with a skin follow, in the order of its file, for the whole film.",
     .written = "(A B), or none",
     .example = "create tree mesh file=\"tree.obj\" joints=(ball)"},
};

}  // namespace betwixt
