// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The Animation Imaging Model for C. A host program describes objects and how they move; the imaging server (betwixt
// serve) draws and moves them.
//
// Names follow the source (2.2.6, 2.2.7, 3.3.4, appendix A): MAKEOBJ is aim_make_object, BeginAniEnv is
// aim_begin_environment, and so on.
//
// Matrices follow the source's convention: 16 numbers, row by row. A point is a row that is multiplied from the left
// (p' = p M), and the translation is in the last row. In memory this equals column vectors with column-major storage.
// An affine matrix has the last column 0 0 0 1. Times are whole ticks: 30 a second unless the server's film sets
// another rate. Colours are sRGB from 0 to 1.
//
// Every call waits for the server's answer and returns AIM_OK or one of the errors below; aim_error() returns the
// reason. Use a handle from one thread at a time. Each thread may have a handle of its own.
//
// Room: server
#ifndef BETWIXT_AIM_H
#define BETWIXT_AIM_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct aim aim;
typedef enum aim_status {
  AIM_OK = 0,
  AIM_E_REFUSED = -1,    /* the server understood the call and refused it: unknown name, wrong value, E_CEILING … */
  AIM_E_CONNECTION = -2, /* no server answers, or it has ended; the handle can only be closed */
  AIM_E_CALL = -3 /* the call is invalid: a null pointer or handle, a number that is not finite, a name below 1 */
} aim_status;

/* Connects to a server. `where` is the path of a Unix socket; null means the server's default path. For loopback TCP it
 * is "tcp:HOST:PORT", with the server's token. Returns null if no server answers; aim_error(NULL) then returns why. */
aim* aim_connect(const char* where, const char* token);
void aim_disconnect(aim*);
/* Returns why the last call failed, or "" if it succeeded. Valid until the next call with the handle. */
const char* aim_error(const aim*);
/* Returns what the server warned of when it carried out the last call, one warning a line, or "" if there was none. In
 * a bundle, warnings are known only when the bundle ends. Valid until the next call with the handle. */
const char* aim_warnings(const aim*);

/* ---- objects: display lists (2.2.1, 2.2.6) --------------------------------------------------------------------------
 * Names of objects, tags and environments are positive numbers. The library makes them; no other host ever gets the
 * same ones. */
aim_status aim_make_object(aim*, int* object); /* MAKEOBJ: opens a new object; the drawing commands that follow … */
aim_status aim_close_object(aim*);            /* CLOSEOBJ: … up to here belong to it. Other commands may be between */
aim_status aim_edit_object(aim*, int object); /* EDITOBJ: opens an object again, to append or replace commands */
aim_status aim_delete_object(aim*, int object);
aim_status aim_call_object(aim*, int object);      /* CALLOBJ: an instance */
aim_status aim_tag(aim*, int* tag);                /* TAG: gives the next drawing command a name */
aim_status aim_replace(aim*, int tag, int offset); /* REPLACE: the next commands overwrite the one at tag + offset and
                                                      those behind it, until a call that adds none to the object */

aim_status aim_push_matrix(aim*);
aim_status aim_pop_matrix(aim*);
aim_status aim_multiply_matrix(aim*, const double m[16]); /* MULTMATRIX: the top of the stack becomes m * top */

aim_status aim_point(aim*, double x, double y, double z);
aim_status aim_vector(aim*, const double from[3], const double to[3]);
aim_status aim_polygon(aim*, int count, const double* xyz); /* `xyz`: 3 * count numbers */
aim_status aim_text(aim*, const char* utf8);
aim_status aim_color(aim*, double r, double g, double b);
aim_status aim_texture(aim*, const char* file);
aim_status aim_font(aim*, const char* name);
aim_status aim_view(aim*, const double eye[3], const double at[3]);
aim_status aim_perspective(aim*, double horizontal_angle_in_radians);
aim_status aim_orthographic(aim*, double height);

/* ---- environments (2.2.5, 2.2.7, 5.1, 5.2) -------------------------------------------------------------------------
 */
aim_status aim_make_environment(aim*, int* environment); /* makes a name that no environment has */
aim_status aim_begin_environment(aim*, int environment); /* BeginAniEnv, inside an open object */
aim_status aim_end_environment(aim*);                    /* EndAniEnv */
aim_status aim_start(aim*, int main_object);             /* StartAniProc */
aim_status aim_animate(aim*, int environment, long interval, const double m[16]); /* Animate */

/* A motion for Animate with all its options. Start from aim_motion_of() and change the fields that you need. */
typedef struct aim_motion {
  double matrix[16];
  long interval;       /* ticks between updates, at least 1 */
  long change, period; /* the interval grows by `change` ticks every `period` ticks; below 0 it shrinks, 0 keeps it */
  long ceiling;        /* in ticks: the motion stops for good when a growing interval gets there */
  long from, until;    /* ticks from now until it starts and until it stops; -1: starts at once, never stops */
  int keep_phase;      /* 1: the first update comes when the next one of the old motion was due */
} aim_motion;
aim_motion aim_motion_of(long interval, const double m[16]);
aim_status aim_animate_motion(aim*, int environment, const aim_motion*);

aim_status aim_halt(aim*, int environment);   /* HaltAnimation */
aim_status aim_kill(aim*, int environment);   /* KillAnimation */
aim_status aim_cancel(aim*, int environment); /* drops the starts and stops that are still to come */

aim_status aim_get_interval(aim*, int environment, long* interval);         /* GetAniTime */
aim_status aim_get_matrix(aim*, int environment, double m[16]);             /* GetAniMatrix: M, not A */
aim_status aim_get_environment_matrix(aim*, int environment, double a[16]); /* A, accumulated until now */
aim_status aim_get_slot_counter(aim*, int* slot);                           /* 0 … 29 */
aim_status aim_get_tick(aim*, long* tick);

/* Collects the commands between these two calls. They are carried out together, in one tick, or not at all. */
aim_status aim_begin_bundle(aim*);
aim_status aim_end_bundle(aim*);
/* Sends one line of the language (docs/language.md). `said` may be null; else it is set to the text of the answer,
 * valid until the next call. The lines `bundle` and `end` are aim_begin_bundle and aim_end_bundle. */
aim_status aim_command(aim*, const char* line, const char** said);

/* ---- matrices (appendix A)
 * -------------------------------------------------------------------------------------------- */
void aim_identity(double m[16]);
void aim_translate(double m[16], double x, double y, double z);
void aim_scale(double m[16], double x, double y, double z);
void aim_rotate_x(double m[16], double radians);
void aim_rotate_y(double m[16], double radians);
void aim_rotate_z(double m[16], double radians);
/* Sets product = a b, which applies a first, then b. `product` may be the same array as `a` or `b`. */
void aim_multiply(double product[16], const double a[16], const double b[16]);
void aim_transform(double p[3], const double m[16]);

#ifdef __cplusplus
}
#endif
#endif
