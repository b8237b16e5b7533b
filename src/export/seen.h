// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What is drawn of a film, object by object over time: triangles, and how they look.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "betwixt/export.h"
#include "betwixt/frame.h"

namespace betwixt {

struct Skin;  // program/compiled.h

struct Seen {
  ObjectId id;
  // One mesh after the other, where its shape varies beyond being stretched; each in object space but for `stretch`.
  struct Form {
    std::shared_ptr<const Mesh> mesh;
    Mat4 local;  // a scaling
  };
  std::vector<Form> forms;
  struct From {
    Time time;
    int form = -1;  // -1: it is not seen
  };
  std::vector<From> when;  // by time; the first one is the beginning
  Channel stretch;         // along its axes; no pieces: it is `local` of its form
  Channel color, opacity;  // linear light; 1 is solid
  Material material = Material::plastic;
  double shininess = 0;
  std::shared_ptr<const Picture> texture;
  std::int32_t skin = -1;  // of Compiled::skins: its one form is the mesh at rest
};

// Of all that is ever seen. Shapes are looked at once a frame, and where something may jump. Errors: range (more
// triangles than anybody can take).
// `as_skin`: whether a mesh that is deformed is told as that; else it is a form after the other.
Result<std::vector<Seen>> all_seen(const Program&, const ExportOptions&, Exported&,
                                   const std::function<bool(const Skin&)>& as_skin = {});

// Those of the objects that are asked for, and what they hang on; all, where nobody is asked for.
void keep_asked(std::vector<ObjectKeys>&, const std::vector<ObjectId>& asked);
bool is_asked(ObjectId, const std::vector<ObjectId>& asked);

// The frames of the film, and when something may jump in between.
std::vector<Time> looks_of(const Program&, Time from, Time until);

// Says what is around the things and goes into no file of motion; with or without the background.
void leave_out_surroundings(const Program&, const ExportOptions&, bool background, Exported&);
// Each sentence once.
void leave_out(Exported&, std::string sentence);

}  // namespace betwixt
