// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
/* Renderers: one that writes what it is given into its first pixels, and others that misbehave. */
#include <betwixt/plugin.h>
#include <stdlib.h>
#include <string.h>

static void put(unsigned char* rgba, int pixel, double r, double g, double b, double a) {
  rgba[4 * pixel] = (unsigned char)(r + 0.5), rgba[4 * pixel + 1] = (unsigned char)(g + 0.5);
  rgba[4 * pixel + 2] = (unsigned char)(b + 0.5), rgba[4 * pixel + 3] = (unsigned char)(a + 0.5);
}

static int probe(const struct betwixt_frame* f, unsigned char* rgba, const char** why, void* user) {
  static int calls = 0;
  size_t o;
  (void)why, (void)user;
  put(rgba, 0, (double)f->count, (double)f->light_count, f->orthographic, ++calls);
  put(rgba, 1, f->width, f->height, 255 * f->background[1], 255);
  for (o = 0; o < f->count; ++o) {
    const struct betwixt_mesh_range* m = f->mesh + o;
    const float* p = f->position + 3 * m->first_vertex;
    float low = 1e9F, high = -1e9F;
    size_t v, bad = 0;
    for (v = 0; v < m->vertices; ++v) low = p[3 * v] < low ? p[3 * v] : low, high = p[3 * v] > high ? p[3 * v] : high;
    for (v = 0; v < 3 * m->triangles; ++v) bad += f->triangle[3 * m->first_triangle + v] >= m->vertices;
    put(rgba, 2 + 3 * (int)o, 255 * f->color[4 * o], 255 * f->color[4 * o + 1], 255 * f->color[4 * o + 2],
        255 * f->color[4 * o + 3]);
    put(rgba, 3 + 3 * (int)o, 10 * f->world[16 * o + 3], 10 * f->world[16 * o + 7], 10 * f->world[16 * o], (double)bad);
    put(rgba, 4 + 3 * (int)o, (double)m->triangles, 10 * (double)(high - low), (double)m->first_vertex, 255);
  }
  return 0;
}

static int crashes(const struct betwixt_frame* f, unsigned char* rgba, const char** why, void* user) {
  (void)why, (void)user;
  if (f->count > 1) abort();
  memset(rgba, 77, 4);
  return 0;
}

static int fails(const struct betwixt_frame* f, unsigned char* rgba, const char** why, void* user) {
  (void)f, (void)rgba, (void)user;
  *why = "it does not like this picture";
  return 1;
}

static int endless(const struct betwixt_frame* f, unsigned char* rgba, const char** why, void* user) {
  volatile int on = 1;
  (void)f, (void)rgba, (void)why, (void)user;
  while (on) {
  }
  return 0;
}

BETWIXT_PLUGIN(host) {
  return host->register_renderer(host, "probe", "shows what it is given", probe, 0) ||
         host->register_renderer(host, "crashes", "crashes", crashes, 0) ||
         host->register_renderer(host, "fails", "fails", fails, 0) ||
         host->register_renderer(host, "endless", "never ends", endless, 0);
}
