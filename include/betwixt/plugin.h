// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Plug-ins: twerpers, filters, procedures, commands and display functions in C (or anything that speaks C), used
// exactly like built-in ones. A plug-in is a shared library made with this header alone:
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
// What it registers must be pure (the same questions, the same answer) and may be called from several threads at once;
// it is not stopped when it never ends, as Lua is. It stays loaded until the program ends. Strings given to a plug-in
// live until its function returns; what it gives back is copied at once.
//
// Room: procedure
#ifndef BETWIXT_PLUGIN_H
#define BETWIXT_PLUGIN_H

#include <stddef.h>

/* Grows when what is written here changes; a program loads plug-ins of its own version and of lower ones. */
#define BETWIXT_PLUGIN_VERSION 1

#ifdef __cplusplus
extern "C" {
#endif

/* What numbers[] of a value are. Angles are radians, colors sRGB from 0 to 1. */
enum betwixt_kind {
  BETWIXT_NUMBER = 1, /* one */
  BETWIXT_VECTOR,     /* x y z */
  BETWIXT_COLOR,      /* r g b */
  BETWIXT_BOOLEAN,    /* 0 or 1 */
  BETWIXT_ANGLES,     /* about x, y and z */
  BETWIXT_QUATERNION, /* w x y z */
  BETWIXT_TEXT,       /* none: text */
  BETWIXT_MATRIX      /* sixteen, row by row; only ever read */
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

/* What a procedure may ask. value() gives 0, or 1 where there is no such value: out->text then says why. */
struct betwixt_questions {
  void* state;
  double seconds;   /* the time that a value is wanted for */
  const char* self; /* the object that it is wanted of, or "" */
  int (*value)(void* state, const char* target, double seconds, struct betwixt_value* out);
};

/* What a filter may ask: the track it stands on, unfiltered, at any time. Gives 0, or 1 and why in out->text. */
struct betwixt_input {
  void* state;
  double seconds;
  int (*at)(void* state, double seconds, struct betwixt_value* out);
};

/* What a command may do: run a line of the language. Gives null, or what was wrong with it. */
struct betwixt_commands {
  void* state;
  const char* (*run)(void* state, const char* line);
};

/* A twerper gives the blending factor at u, 0 to 1 along the segment. The others give 0, or 1 after setting out->text
 * (a command: *why) to what is wrong, in plain words. `user` is what was registered with the function. */
typedef double (*betwixt_twerper)(double u, void* user);
typedef int (*betwixt_filter)(const struct betwixt_input* input, const struct betwixt_parameter* parameters,
                              size_t count, struct betwixt_value* out, void* user);
typedef int (*betwixt_procedure)(const struct betwixt_questions* questions, const struct betwixt_value* arguments,
                                 size_t count, struct betwixt_value* out, void* user);
typedef int (*betwixt_command)(const struct betwixt_commands* commands, const char* const* words, size_t count,
                               const char** why, void* user);

/* The program. Each gives 0, or 1 where the name is taken or none (a letter, then letters, digits, - and _). */
struct betwixt_host {
  int version; /* the program's */
  void* state;
  int (*register_twerper)(const struct betwixt_host*, const char* name, const char* help, betwixt_twerper, void* user);
  int (*register_filter)(const struct betwixt_host*, const char* name, const char* help, betwixt_filter, void* user);
  int (*register_value)(const struct betwixt_host*, const char* name, const char* help, betwixt_procedure, void* user);
  int (*register_command)(const struct betwixt_host*, const char* name, const char* help, betwixt_command, void* user);
  /* A display function; `type` as the language writes it, such as "number" or "vector"; its value before any event. */
  int (*register_function)(const struct betwixt_host*, const char* name, const char* type, const double* numbers,
                           size_t count);
};

#ifdef __cplusplus
}
#define BETWIXT_EXPORT extern "C" __attribute__((visibility("default")))
#else
#define BETWIXT_EXPORT __attribute__((visibility("default")))
#endif

/* Once in a plug-in: the function that registers what is in it. Gives 0, or another number: it is then refused. */
#define BETWIXT_PLUGIN(host)                                                         \
  BETWIXT_EXPORT int betwixt_plugin_version(void);                                   \
  BETWIXT_EXPORT int betwixt_plugin_version(void) { return BETWIXT_PLUGIN_VERSION; } \
  BETWIXT_EXPORT int betwixt_plugin(const struct betwixt_host* host);                \
  BETWIXT_EXPORT int betwixt_plugin(const struct betwixt_host* host)

#endif
