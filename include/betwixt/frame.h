// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A frame: everything that can be seen of a document at one time. It does not refer to the document.
//
// Room: program
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "betwixt/finish.h"
#include "betwixt/gradient.h"
#include "betwixt/layer.h"
#include "betwixt/problem.h"
#include "betwixt/setting.h"
#include "betwixt/shape.h"
#include "betwixt/time.h"

namespace betwixt {

// One drawn object.
struct Item {
  ObjectId id;
  Mat4 world;                           // object space to world space
  std::shared_ptr<const Shape> shape;   // never null
  std::shared_ptr<const Shape> toward;  // the shape that it is turning into; null if none
  double blend = 0;                     // how far towards that, 0 to 1 (and outside, if a twerper overshoots)
  Vec3 color{1, 1, 1};                  // linear light
  double transparency = 0;              // 0 opaque to 1 invisible
  double shininess = 0;                 // 0 dull to 1 a mirror-like highlight
  Material material = Material::plastic;
  bool casts = true;                       // whether it casts shadows
  std::shared_ptr<const Picture> texture;  // null if it has none, or only that of its mesh file
  // Its physical finish; null: shininess and material say how it looks. With a finish, these two are an approximation.
  std::shared_ptr<const Finish> finish;
  // In place of its colour and of that of its stroke; null if it has none. The colour is then that of the first stop.
  std::shared_ptr<const Gradients> gradients;
  // The body that it belongs to. For an attached object, this is the drawn object that you reach last if you go from
  // parent to parent. For a part by name it is the whole (car for car/wheel). Otherwise it is the object itself.
  ObjectId body;
  std::int32_t layer = -1;  // the innermost one of Frame::layers that it belongs to; -1: none
};

// Whether a light casts shadows. `strongest`: only if no other light is stronger. A renderer draws the shadows of at
// most four lights, the strongest of those that cast shadows.
enum class Casting : std::uint8_t { strongest, off, on, soft };

enum class LightShape : std::uint8_t { point, disc, rectangle };

// A lamp that is a disc or a rectangle shines from its front alone. Its light becomes less with the square of the
// distance; at a quarter of the range it is as bright as that of a sun with the same colour.
struct Light {
  ObjectId id;
  bool sun = false;     // parallel rays along `direction`, without a range
  Vec3 position;        // in the world
  Vec3 direction;       // in the world, unit length, away from the light (suns, areas, cones)
  Vec3 color{1, 1, 1};  // linear light, intensity included
  double range = 20;    // metres at which the light has faded smoothly to nothing
  Casting casting = Casting::strongest;
  LightShape shape = LightShape::point;
  Vec3 across{1, 0, 0};                    // of areas and cones: the direction of `width`, unit length
  double width = 1, height = 1;            // of areas, metres
  double cone = 0;                         // whole angle in radians; 0: it shines everywhere
  double cone_edge = 0.2;                  // how much of the cone is its soft edge, 0 to 1
  std::shared_ptr<const Picture> picture;  // projected by a cone; null if it has none
};

struct Camera {
  Mat4 world;  // camera space (looks along -z, y up) to world space; rotation and translation only
  bool orthographic = false;
  double fov = 0.9;          // horizontal, radians (perspective)
  double height = 10;        // metres seen from bottom to top (orthographic)
  double aspect = 16.0 / 9;  // width / height of the film's pictures, from the script; you may use another
  double shutter = 0;        // seconds of exposure, from the frame's time on
  double aperture = 0;       // metres, the diameter of the lens opening (perspective); 0: all is sharp
  double focus = 10;         // metres from the camera, along its axis, at which things are sharp
  // Lens shift: to the right, in halves of the width, and up, in halves of the height.
  double shift_x = 0, shift_y = 0;
  friend bool operator==(const Camera&, const Camera&) = default;
};

// The surroundings of the objects, and all light that does not come from a Light. Colours are linear light.
struct Surroundings {
  struct Fog {
    Vec3 color;
    double from = 0, to = 0;  // metres from the eye: where fog begins, and where it hides everything
    friend bool operator==(const Fog&, const Fog&) = default;
  };
  bool flat = false;            // a drawing: objects show their own colours, unlit
  std::optional<Vec3> below;    // the background's colour at the bottom of the picture, if it is a gradient
  std::optional<Vec3> ambient;  // light from all directions; nullopt: the renderer's default
  double exposure = 0;          // in stops: all light is multiplied by 2 to this power
  std::optional<Fog> fog;
  std::optional<Vec3> ground;  // colour of an infinite floor at y = 0; nullopt: no floor
  bool sky = false;            // the simple blue sky
  Sky environment;             // visible if there is no background
  Grade grade;
  bool clear = false;    // a transparent background; black in pictures without alpha
  bool contact = false;  // darkens places where objects meet (ambient occlusion)
  friend bool operator==(const Surroundings&, const Surroundings&) = default;
};

// The change of the camera that is going on.
struct CameraChange {
  Camera from;       // the camera of before
  double share = 1;  // of the new one, 0 to 1
  ChangeKind kind = ChangeKind::dissolve;
};

struct Frame {
  Time time;
  std::vector<Item> items;    // in the order in which the objects were created
  std::vector<Light> lights;  // if empty, the renderer adds its own
  Camera camera;
  std::optional<CameraChange> change;
  std::vector<Layer> layers;       // a layer comes after those that it is within
  std::optional<Vec3> background;  // linear light; nullopt: the renderer's soft gradient
  Surroundings surroundings;
  std::vector<std::string> notes;  // the notes exactly at this time
  // Procedures that failed or did not end, each once, with the reason. In their place the frame uses the value that the
  // track has without them.
  std::vector<std::string> problems;
  // The same as data, in the same order. Those with `source` are errors in the author's code.
  std::vector<Problem> reports;
};

}  // namespace betwixt
