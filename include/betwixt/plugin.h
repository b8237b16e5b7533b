// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Plug-ins: twerpers (interpolation functions), filters, procedures, commands, display functions and kinds of objects
// in C, or in any language that can call C. You use them exactly like built-in ones. You need only this header to make
// one as a shared library:
//
//     #include <betwixt/plugin.h>
//     static double late(double u, void* user) { (void)user; return u * u * u; }
//     BETWIXT_PLUGIN(host) {
//       host->register_twerper(host, "late", "slow at first", late, 0);
//       return 0;
//     }
//
//     cc -shared -fPIC -o late.so late.c
//
// Every function that a plug-in registers must be pure (the same input gives the same result), and several threads may
// call it at once. Unlike Lua code, it is not stopped if it never ends. A plug-in stays loaded until the program ends.
// Strings that your function receives are valid until it returns. Strings that it gives back are copied at once.
//
// Room: procedure
#ifndef BETWIXT_PLUGIN_H
#define BETWIXT_PLUGIN_H

#include <stddef.h>

/* Grows with each change of this header. A program loads plug-ins of its own version and of lower ones. */
#define BETWIXT_PLUGIN_VERSION 2

#ifdef __cplusplus
extern "C" {
#endif

/* The kind of a value, and the meaning of its numbers[]. Angles are in radians, colours are sRGB from 0 to 1. */
enum betwixt_kind {
  BETWIXT_NUMBER = 1, /* one */
  BETWIXT_VECTOR,     /* x y z */
  BETWIXT_COLOR,      /* r g b */
  BETWIXT_BOOLEAN,    /* 0 or 1 */
  BETWIXT_ANGLES,     /* about x, y and z */
  BETWIXT_QUATERNION, /* w x y z */
  BETWIXT_TEXT,       /* no numbers; the value is in `text` */
  BETWIXT_MATRIX      /* sixteen, row by row; you can read it, not return it */
};

struct betwixt_value {
  int kind;
  double numbers[16];
  const char* text;
};

struct betwixt_parameter {
  const char* name;
  struct betwixt_value value;
};

/* Passed to a procedure. value() reads a target; it returns 0, or 1 with the reason in out->text. */
struct betwixt_questions {
  void* state;
  double seconds;   /* the time at which the value is evaluated */
  const char* self; /* the object whose value it is, or "" */
  int (*value)(void* state, const char* target, double seconds, struct betwixt_value* out);
};

/* Passed to a filter. at() reads the unfiltered track at any time; it returns 0, or 1 with the reason in out->text. */
struct betwixt_input {
  void* state;
  double seconds;
  int (*at)(void* state, double seconds, struct betwixt_value* out);
};

/* Passed to a command. run() carries out a line of the language; it returns null, or the error. */
struct betwixt_commands {
  void* state;
  const char* (*run)(void* state, const char* line);
};

/* The functions that you register. A twerper returns the blending factor at u, the position from 0 to 1 between two
 * events. The others return 0. After an error they set out->text (a command sets *why) to the error in plain words and
 * return 1. `user` is the pointer that you registered with the function. */
typedef double (*betwixt_twerper)(double u, void* user);
typedef int (*betwixt_filter)(const struct betwixt_input* input, const struct betwixt_parameter* parameters,
                              size_t count, struct betwixt_value* out, void* user);
typedef int (*betwixt_procedure)(const struct betwixt_questions* questions, const struct betwixt_value* arguments,
                                 size_t count, struct betwixt_value* out, void* user);
/* Passed to a renderer: what a picture shows, as columns. Space is right-handed with y up, in metres. Matrices are 16
 * numbers row by row, for column vectors. Colours are linear light. The pointers are valid until your function returns.
 */
struct betwixt_mesh_range { /* the part of `position`, `normal` and `triangle` that is the mesh of an object */
  size_t first_vertex, vertices, first_triangle, triangles;
};
struct betwixt_light {
  int sun; /* 1: parallel light along `direction`, otherwise a lamp at `position` */
  double position[3], direction[3], color[3];
  double range; /* of a lamp: metres at which its light has faded to nothing */
};
struct betwixt_frame {
  int width, height;                     /* of the picture, in pixels */
  size_t count;                          /* visible objects, in the order of their creation */
  const double* world;                   /* for each object 16: from mesh space to the world */
  const double* color;                   /* for each object 4: red, green, blue, and opacity from 0 to 1 */
  const struct betwixt_mesh_range* mesh; /* for each object; objects with equal shapes share one */
  const float* position;                 /* for each vertex 3, in mesh space */
  const float* normal;                   /* for each vertex 3 */
  const unsigned* triangle;              /* for each triangle 3 vertices of its mesh, counted from first_vertex */
  size_t light_count;
  const struct betwixt_light* light;
  double camera[16]; /* from camera space to the world; the camera looks along -z */
  int orthographic;
  /* A point (x y z) in camera space is at (scale[0] x, scale[1] y) / -z of the picture, or for an orthographic camera
   * at (scale[0] x, scale[1] y). The picture goes from -1 to 1 in both directions, y up. */
  double scale[2];
  double background[3];
};

typedef int (*betwixt_command)(const struct betwixt_commands* commands, const char* const* words, size_t count,
                               const char** why, void* user);

/* Fills `rgba`, width * height pixels of red, green, blue (sRGB) and opacity, row by row from the top. It is
 * transparent black at first. Runs in a process of its own: it may keep what it likes there, and if it crashes, only
 * its picture is lost. It has 60 seconds for a picture. */
typedef int (*betwixt_renderer)(const struct betwixt_frame* frame, unsigned char* rgba, const char** why, void* user);

/* The program. Each function returns 0, or 1 if the name is taken or not valid (a letter, then letters, digits, -, _).
 */
struct betwixt_host {
  int version; /* the program's */
  void* state;
  int (*register_twerper)(const struct betwixt_host*, const char* name, const char* help, betwixt_twerper, void* user);
  int (*register_filter)(const struct betwixt_host*, const char* name, const char* help, betwixt_filter, void* user);
  int (*register_value)(const struct betwixt_host*, const char* name, const char* help, betwixt_procedure, void* user);
  int (*register_command)(const struct betwixt_host*, const char* name, const char* help, betwixt_command, void* user);
  /* Adds a display function. `type` is a word of the language, such as "number" or "vector"; `numbers` is the default.
   */
  int (*register_function)(const struct betwixt_host*, const char* name, const char* type, const double* numbers,
                           size_t count);
  /* Adds a kind of objects. `lines` are lines of the language that make its model: an object with the name of the kind,
   * and everything below it. Betwixt runs them when a script first uses the kind, and hides the model. Since version 2.
   */
  int (*register_kind)(const struct betwixt_host*, const char* name, const char* help, const char* lines);
  /* Adds a style, which `--style NAME` chooses. Since version 2. */
  int (*register_renderer)(const struct betwixt_host*, const char* name, const char* help, betwixt_renderer,
                           void* user);
};

#ifdef __cplusplus
}
#define BETWIXT_EXPORT extern "C" __attribute__((visibility("default")))
#else
#define BETWIXT_EXPORT __attribute__((visibility("default")))
#endif

/* Defines the function that registers everything; use it once. Return 0, or another number if the plug-in cannot be
 * loaded. */
#define BETWIXT_PLUGIN(host)                                                         \
  BETWIXT_EXPORT int betwixt_plugin_version(void);                                   \
  BETWIXT_EXPORT int betwixt_plugin_version(void) { return BETWIXT_PLUGIN_VERSION; } \
  BETWIXT_EXPORT int betwixt_plugin(const struct betwixt_host* host);                \
  BETWIXT_EXPORT int betwixt_plugin(const struct betwixt_host* host)

#endif
