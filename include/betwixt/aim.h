// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The Animation Imaging Model for C. A host program describes objects and how they move. The imaging server (betwixt
// serve) draws and moves them.
//
// The source is the original description of this model; numbers such as 2.2.6 are its sections. Names follow its
// sections 2.2.6, 2.2.7, 3.3.4 and appendix A: MAKEOBJ is aim_make_object, BeginAniEnv is aim_begin_environment, and so
// on.
//
// Matrices follow the source's convention: 16 numbers, row by row. A point is a row vector (p' = p M), and the
// translation is in the last row. The 16 numbers are the same in memory as for column vectors with column-major
// storage. All matrices are affine: their last column is 0 0 0 1. Times are whole ticks. There are 30 ticks a second
// unless the server's film sets another rate. Colours are sRGB from 0 to 1.
//
// Every call waits for the server's answer and returns AIM_OK or one of the errors below; aim_error() returns the
// reason. In a bundle, aim_end_bundle() waits for the answer to all commands, and the functions aim_get_… return
// AIM_E_CALL. Use a handle from one thread at a time. Each thread may have a handle of its own.
//
// Room: server
#ifndef BETWIXT_AIM_H
#define BETWIXT_AIM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct aim aim;
typedef enum aim_status {
  AIM_OK = 0,
  AIM_E_REFUSED = -1,    /* the server understood the call and refused it: unknown name, wrong value, E_CEILING … */
  AIM_E_CONNECTION = -2, /* no server answers, or the server has ended; you can only close the handle */
  AIM_E_CALL = -3 /* the call is invalid, and nothing was sent: a null pointer, a number that is not finite, a name
                     below 1, no object is open … */
} aim_status;

/* Connects to a server. `where` is the path of a Unix socket, or "tcp:HOST:PORT" for loopback TCP. Null means the
 * server's default path. TCP needs the server's token; otherwise `token` may be null. Returns null if no server answers
 * or the token is wrong; aim_error(NULL) then returns the reason. */
aim* aim_connect(const char* where, const char* token);
void aim_disconnect(aim*);
/* Returns why the last call with the handle failed, or "" if it succeeded. Valid until the next call. */
const char* aim_error(const aim*);
/* Returns the server's warnings about the last call, one on each line, or "" if there are none. The warnings about a
 * bundle come when the bundle ends. Valid until the next call with the handle. */
const char* aim_warnings(const aim*);

/* ---- objects: display lists (2.2.1, 2.2.6) --------------------------------------------------------------------------
 * Names of objects, tags and environments are positive numbers. The library makes them; no other host ever gets the
 * same ones. */
aim_status aim_make_object(aim*, int* object); /* MAKEOBJ: makes an object and opens it; the drawing commands that
                                                  follow are added to it */
aim_status aim_close_object(aim*);             /* CLOSEOBJ. You may send other commands while an object is open */
aim_status aim_edit_object(aim*, int object);  /* EDITOBJ: opens an object again, to append or replace commands */
aim_status aim_delete_object(aim*, int object);
aim_status aim_call_object(aim*, int object);      /* CALLOBJ: draws an instance */
aim_status aim_tag(aim*, int* tag);                /* TAG: gives the next drawing command a name */
aim_status aim_replace(aim*, int tag, int offset); /* REPLACE: the next drawing commands overwrite, one by one, those
                                                      from tag + offset on. Any other command ends this */

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
aim_status aim_make_environment(aim*, int* environment); /* returns a name that no environment has */
aim_status aim_begin_environment(aim*, int environment); /* BeginAniEnv, inside an open object */
aim_status aim_end_environment(aim*);                    /* EndAniEnv */
aim_status aim_start(aim*, int main_object);             /* StartAniProc */
aim_status aim_animate(aim*, int environment, long interval, const double m[16]); /* Animate */

/* A motion for Animate with all its options. Start from aim_motion_of() and change the fields that you need. */
typedef struct aim_motion {
  double matrix[16];
  long interval;       /* ticks from one update to the next, at least 1 */
  long change, period; /* every `period` ticks, `change` ticks are added to the interval; may be negative or 0 */
  long ceiling;        /* in ticks: when a growing interval reaches it, the motion stops */
  long from, until;    /* ticks from now until the motion starts and stops; -1: starts at once, never stops */
  int keep_phase;      /* 1: the first update comes when the old motion would have had its next one */
} aim_motion;
aim_motion aim_motion_of(long interval, const double m[16]);
aim_status aim_animate_motion(aim*, int environment, const aim_motion*);

aim_status aim_halt(aim*, int environment);   /* HaltAnimation */
aim_status aim_kill(aim*, int environment);   /* KillAnimation */
aim_status aim_cancel(aim*, int environment); /* removes the starts and stops that are still to come */

aim_status aim_get_interval(aim*, int environment, long* interval); /* GetAniTime */
aim_status aim_get_matrix(aim*, int environment, double m[16]);     /* GetAniMatrix: M, the matrix of one update */
aim_status aim_get_environment_matrix(aim*, int environment, double a[16]); /* A, the product of all updates */
aim_status aim_get_slot_counter(aim*, int* slot);                           /* the tick modulo 30 */
aim_status aim_get_tick(aim*, long* tick);

/* Bundle the commands between these two calls: the server carries out all of them in one tick, or none. */
aim_status aim_begin_bundle(aim*);
aim_status aim_end_bundle(aim*);
/* Sends one line of the language (docs/language.md). Sets `said`, unless it is null, to the text of the answer, valid
 * until the next call. The lines `bundle` and `end` act as aim_begin_bundle and aim_end_bundle. */
aim_status aim_command(aim*, const char* line, const char** said);
/* Gives the server the contents of a file: a picture, mesh, scene, drawing or sound, as the ending of the name says.
 * From then on commands can name it "@NAME": aim_command(h, "set lonely.texture \"@logo.png\"", 0). Cannot be in a
 * bundle. */
aim_status aim_send(aim*, const char* name, const void* bytes, size_t size);

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
