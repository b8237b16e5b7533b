// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A frame: everything that can be seen (or asked) of a document at one time. A pure value.
//
// Room: program
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "betwixt/shape.h"
#include "betwixt/time.h"

namespace betwixt {

// One object that is drawn.
struct Item {
  ObjectId id;
  Mat4 world;                           // object space to world space
  std::shared_ptr<const Shape> shape;   // never null
  std::shared_ptr<const Shape> toward;  // null, or the shape it is on the way to …
  double blend = 0;                     // … and how far, 0 to 1 (and beyond, where a twerper overshoots)
  Vec3 color{1, 1, 1};                  // linear light
  double transparency = 0;              // 0 solid to 1 invisible
  double shininess = 0;                 // 0 dull to 1 a mirror's highlight
  Material material = Material::plastic;
  bool casts = true;                       // keeps light from others
  std::shared_ptr<const Picture> texture;  // null: the mesh's own, if any
  // What it is one body with: the thing drawn that it hangs on in the end, or the whole that it is named as a part of
  // (car/wheel on car); itself where there is none.
  ObjectId body;
};

// Which lights' shadows are drawn: the four strongest of those that cast any.
enum class Casting : std::uint8_t { strongest, off, on, soft };  // strongest: if no other light is stronger

struct Light {
  ObjectId id;
  bool sun = false;     // parallel rays along `direction`; range does not matter
  Vec3 position;        // world
  Vec3 direction;       // world, unit length, away from the light (suns)
  Vec3 color{1, 1, 1};  // linear light, intensity included
  double range = 20;    // metres: the light fades smoothly to nothing there
  Casting casting = Casting::strongest;
};

struct Camera {
  Mat4 world;  // camera space (looks along -z, y up) to world space; a rigid motion
  bool orthographic = false;
  double fov = 0.9;          // horizontal, radians (perspective)
  double height = 10;        // metres seen from bottom to top (orthographic)
  double aspect = 16.0 / 9;  // width by height of the film's pictures, as its script says; others may be made
  double shutter = 0;        // seconds that a picture is exposed, from the frame's time on
  double aperture = 0;       // metres across the lens's opening (perspective); 0: all is sharp
  double focus = 10;         // metres before the eye, along its axis: what is sharp
  // By how many halves of the picture all is moved to the right and up: a lens that is shifted.
  double shift_x = 0, shift_y = 0;
  friend bool operator==(const Camera&, const Camera&) = default;
};

// What is around the things of a film, and what light there is beside its lights. Colours: linear light.
struct Surroundings {
  struct Fog {
    Vec3 color;
    double from = 0, to = 0;  // metres from the eye: where it begins, where nothing else is seen
    friend bool operator==(const Fog&, const Fog&) = default;
  };
  bool flat = false;            // a drawing: things show their own colours, there is no light
  std::optional<Vec3> below;    // what the background goes over to at the bottom of the picture
  std::optional<Vec3> ambient;  // the light from everywhere; none: the renderer's own
  double exposure = 0;          // stops: all light is 2 to the power of this as much
  std::optional<Fog> fog;
  std::optional<Vec3> ground;  // the colour of an endless floor at y = 0; none: there is none
  bool sky = false;
  bool clear = false;    // nothing is behind the things: what pictures have an opacity say so, elsewhere it is black
  bool contact = false;  // it is darker where things meet
  friend bool operator==(const Surroundings&, const Surroundings&) = default;
};

struct Frame {
  Time time;
  std::vector<Item> items;    // in object order
  std::vector<Light> lights;  // empty: the renderer brings its own
  Camera camera;
  std::optional<Vec3> background;  // linear light; none: the renderer's own soft gradient
  Surroundings surroundings;
  std::vector<std::string> notes;  // notes exactly at this time
  // Procedures that erred or did not end, each named once with the reason; what they should have given is the value
  // that the track has without them.
  std::vector<std::string> problems;
  // Those of them in which code of the author's errs. `source`: the code as it was written, to be found in the script.
  struct CodeError {
    std::string message, source;
  };
  std::vector<CodeError> errors;
};

}  // namespace betwixt
