// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A plug-in: a twerper that goes beyond its end and comes back, a filter that moves in steps, a kind of objects, and a
// renderer. Make it with
//
//     cc -std=c99 -O2 -shared -fPIC -I ../../include -o example.so example.c
//
// (where Betwixt is installed without the -I), then start the program with it, or load it in the shell:
//
//     betwixt play film.bx --load ./example.so
//     betwixt shell film.bx        and there: load ./example.so
//
// and write in the film
//
//     ball.position
//       1f  (0 0 0) overshoot
//       24f (4 0 0)
//     filter ball.color stairs step=0.5
//     create left signal position=(-2 0 0)
//     set left/top.color red
//
//     betwixt frame film.bx --load ./example.so --style dots      draws a dot at each vertex
#include <betwixt/plugin.h>
#include <math.h>

static double overshoot(double u, void* user) {
  const double v = u - 1, more = 1.70158; /* a tenth beyond */
  (void)user;
  return 1 + v * v * ((more + 1) * v + more);
}

static int stairs(const struct betwixt_input* input, const struct betwixt_parameter* parameters, size_t count,
                    struct betwixt_value* out, void* user) {
  double step = 0.25;
  size_t i;
  (void)user;
  for (i = 0; i < count; ++i)
    if (parameters[i].name[0] == 's' && parameters[i].value.kind == BETWIXT_NUMBER)
      step = parameters[i].value.numbers[0];
  if (!(step > 0)) {
    out->text = "the step must be more than 0";
    return 1;
  }
  if (input->at(input->state, input->seconds, out)) return 1;
  if (out->kind <= BETWIXT_COLOR)
    for (i = 0; i < 3; ++i) out->numbers[i] = step * floor(out->numbers[i] / step + 0.5);
  return 0;
}

/* Draws a dot at each vertex, in the object's colour. */
static int dots(const struct betwixt_frame* f, unsigned char* rgba, const char** why, void* user) {
  size_t o, v;
  int i, x, y, k;
  (void)user;
  if (f->width < 2 || f->height < 2) {
    *why = "the picture is too small";
    return 1;
  }
  for (i = 0; i < f->width * f->height; ++i) rgba[4 * i + 3] = 255;
  for (o = 0; o < f->count; ++o)
    for (v = 0; v < f->mesh[o].vertices; ++v) {
      const float* p = f->position + 3 * (f->mesh[o].first_vertex + v);
      const double *m = f->world + 16 * o, *c = f->camera;
      double w[3], e[3], depth;
      for (k = 0; k < 3; ++k) w[k] = m[4 * k] * p[0] + m[4 * k + 1] * p[1] + m[4 * k + 2] * p[2] + m[4 * k + 3] - c[4 * k + 3];
      for (k = 0; k < 3; ++k) e[k] = c[k] * w[0] + c[4 + k] * w[1] + c[8 + k] * w[2]; /* the camera's matrix only turns */
      depth = f->orthographic ? 1 : -e[2];
      if (depth <= 0) continue;
      x = (int)floor((f->scale[0] * e[0] / depth + 1) / 2 * f->width);
      y = (int)floor((1 - f->scale[1] * e[1] / depth) / 2 * f->height);
      if (x < 0 || y < 0 || x >= f->width || y >= f->height) continue;
      for (k = 0; k < 3; ++k) rgba[4 * (y * f->width + x) + k] = (unsigned char)(255 * sqrt(f->color[4 * o + k] < 1 ? f->color[4 * o + k] : 1));
    }
  return 0;
}

BETWIXT_PLUGIN(host) {
  host->register_twerper(host, "overshoot", "goes a tenth beyond the end and comes back", overshoot, 0);
  host->register_filter(host, "stairs", "moves in steps: step=0.25", stairs, 0);
  host->register_kind(host, "signal", "a traffic light; its lamps are NAME/top, NAME/middle and NAME/bottom",
                      "create signal box size=(0.6 1.6 0.3) color=#303030\n"
                      "create signal/{bottom,middle,top} sphere radius=0.2 position=(0 0.5*i-1 0.15) color=#505050\n");
  host->register_renderer(host, "dots", "a dot at each vertex", dots, 0);
  return 0;
}
