// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// From light to a picture as a film's Grade says: white balance, bloom and vignette change the light; the view makes
// the picture of it, and grain is on the picture.
#pragma once

#include <array>

#include "betwixt/linear_picture.h"
#include "betwixt/math.h"
#include "betwixt/setting.h"
#include "betwixt/time.h"

namespace betwixt {

struct Development {
  Grade grade;
  bool cut = false;  // the view `neutral` cuts off at white: the light has rolled off already, or is that of a drawing
  Time time;         // of the picture; the grain of each time is another one
  bool opaque = true;  // light over black, instead of straight colours with opacities
  double peak = 1;     // how bright the brightest light may be; 1 is white
};

// Changes light by white balance, bloom and vignette.
void grade_light(LinearPicture&, const Grade&);
// Shows graded light, as sRGB with straight alpha or as linear light from 0 to the peak with premultiplied alpha. Views
// with a white of their own (filmic, agx, tables) stay below it.
void develop(const LinearPicture&, const Development&, Picture& out);
void develop(LinearPicture&, const Development&);

// Returns the matrix that makes the light of a black body of this temperature as white as that of 6500 K is now.
std::array<Vec3, 3> white_balance(double kelvin);  // rows

}  // namespace betwixt
