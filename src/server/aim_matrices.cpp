// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Matrices as the Animation Imaging Model defines them: row vectors, multiplied from the left.
#include <cmath>
#include <cstring>

#include "betwixt/aim.h"

extern "C" {

void aim_identity(double m[16]) {
  for (int i = 0; i < 16; ++i) m[i] = i % 5 == 0;
}
void aim_translate(double m[16], double x, double y, double z) {
  aim_identity(m);
  m[12] = x, m[13] = y, m[14] = z;
}
void aim_scale(double m[16], double x, double y, double z) {
  aim_identity(m);
  m[0] = x, m[5] = y, m[10] = z;
}
void aim_rotate_x(double m[16], double a) {
  aim_identity(m);
  m[5] = m[10] = std::cos(a), m[6] = std::sin(a), m[9] = -m[6];
}
void aim_rotate_y(double m[16], double a) {
  aim_identity(m);
  m[0] = m[10] = std::cos(a), m[8] = std::sin(a), m[2] = -m[8];
}
void aim_rotate_z(double m[16], double a) {
  aim_identity(m);
  m[0] = m[5] = std::cos(a), m[1] = std::sin(a), m[4] = -m[1];
}
void aim_multiply(double product[16], const double a[16], const double b[16]) {
  double r[16];
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      r[4 * row + column] = 0;
      for (int k = 0; k < 4; ++k) r[4 * row + column] += a[4 * row + k] * b[4 * k + column];
    }
  std::memcpy(product, r, sizeof r);
}
void aim_transform(double p[3], const double m[16]) {
  double r[3];
  for (int i = 0; i < 3; ++i) r[i] = p[0] * m[i] + p[1] * m[4 + i] + p[2] * m[8 + i] + m[12 + i];
  std::memcpy(p, r, sizeof r);
}

}  // extern "C"
