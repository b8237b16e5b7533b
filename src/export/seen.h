// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The drawn objects of a film over time: triangles, and their look.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "betwixt/export.h"
#include "betwixt/frame.h"

namespace betwixt {

struct Skin;  // program/compiled_film.h

struct Seen {
  ObjectId id;
  // Meshes, one after the other, if the shape varies beyond scaling; each in object space except for `stretch`.
  struct Form {
    std::shared_ptr<const Mesh> mesh;
    Mat4 local;  // a scaling
  };
  std::vector<Form> forms;
  struct From {
    Time time;
    int form = -1;  // -1: not visible
  };
  std::vector<From> when;  // in order of time, from the beginning on
  Channel stretch;         // the scale along its axes; without pieces: `local` of its form
  Channel color, opacity;  // linear light; 1 is opaque
  Material material = Material::plastic;
  double shininess = 0;
  std::shared_ptr<const Finish> finish;  // null if material and shininess say all of it
  Vec3 own_color{1, 1, 1};               // with a finish: its colour, or that of its material
  std::shared_ptr<const Picture> texture;
  bool video = false;      // the texture is a picture of one
  std::int32_t skin = -1;  // index into Compiled::skins: its one form is the mesh at rest
};

// Returns everything that is ever visible. Shapes are sampled at each frame, and where they may jump. Errors: range
// (too many triangles for any program). `as_skin`: exports a deformed mesh as a skin; otherwise as a sequence of forms.
Result<std::vector<Seen>> all_seen(const Program&, const ExportOptions&, Exported&,
                                   const std::function<bool(const Skin&)>& as_skin = {});

// Keeps the requested objects and their parents; all, if none are requested.
void keep_asked(std::vector<ObjectKeys>&, const std::vector<ObjectId>& asked);
bool is_asked(ObjectId, const std::vector<ObjectId>& asked);

// Returns the times of the film's frames, and of possible jumps between them.
std::vector<Time> looks_of(const Program&, Time from, Time until);

// Lists the surroundings that no file of motion holds, with or without the background.
void leave_out_surroundings(const Program&, const ExportOptions&, bool background, Exported&);
// Adds each sentence once.
void leave_out(Exported&, std::string sentence);

}  // namespace betwixt
