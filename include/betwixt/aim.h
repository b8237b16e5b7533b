// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The Animation Imaging Model for C: a host says what moves how, the imaging server (betwixt serve) makes it move.
// Names follow the source (2.2.6, 2.2.7, 3.3.4, appendix A): MAKEOBJ is aim_make_object, BeginAniEnv
// aim_begin_environment, and so on.
//
// Matrices are the source's: 16 numbers row by row, points are rows multiplied from the left (p' = p M), a translation
// stands in the last row. (The same 16 numbers in memory as column vectors in column-major memory.) Affine: the last
// column is 0 0 0 1. Times are whole ticks, 30 a second unless the server's film says otherwise. Colours are sRGB from
// 0 to 1.
//
// Every call waits for the server's answer. It gives AIM_OK or one of the errors below; what went wrong stands in
// aim_error(). A handle is used by one thread at a time; every thread may have its own.
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
  AIM_E_REFUSED = -1,    /* the server understood and says no: unknown names, wrong values, E_CEILING … */
  AIM_E_CONNECTION = -2, /* there is no server, or it has gone; the handle is of no more use but to be closed */
  AIM_E_CALL = -3 /* the call itself makes no sense: a null pointer or handle, a number that is none, a name below 1 */
} aim_status;

/* WHERE is the path of a Unix socket; null: the server's default. For loopback TCP "tcp:HOST:PORT", with its token.
 * Null where nobody listens; then aim_error(NULL) says why. */
aim* aim_connect(const char* where, const char* token);
void aim_disconnect(aim*);
/* Why the last call failed; "" if it did not. Lives until the next call with the handle. */
const char* aim_error(const aim*);
/* What the server warned of when it carried out the last call, a line each: "" if it did not. In a bundle nothing is
 * known before its end. Lives until the next call with the handle. */
const char* aim_warnings(const aim*);

/* ---- objects: display lists (2.2.1, 2.2.6) --------------------------------------------------------------------------
 * Names of objects, tags and environments are positive numbers made by the library, that no other host has or had. */
aim_status aim_make_object(aim*, int* object); /* MAKEOBJ: opens it; the commands that follow are its own … */
aim_status aim_close_object(aim*);             /* CLOSEOBJ: … until here; others may come between */
aim_status aim_edit_object(aim*, int object);  /* EDITOBJ: opens it again, to add and replace */
aim_status aim_delete_object(aim*, int object);
aim_status aim_call_object(aim*, int object);      /* CALLOBJ: an instance */
aim_status aim_tag(aim*, int* tag);                /* TAG: names the next command */
aim_status aim_replace(aim*, int tag, int offset); /* REPLACE: what follows takes the place of tag + offset …
                                                      and what is behind it, until another command comes between */

aim_status aim_push_matrix(aim*);
aim_status aim_pop_matrix(aim*);
aim_status aim_multiply_matrix(aim*, const double m[16]); /* MULTMATRIX: top of stack <- m top */

aim_status aim_point(aim*, double x, double y, double z);
aim_status aim_vector(aim*, const double from[3], const double to[3]);
aim_status aim_polygon(aim*, int count, const double* xyz); /* 3 * count numbers */
aim_status aim_text(aim*, const char* utf8);
aim_status aim_color(aim*, double r, double g, double b);
aim_status aim_texture(aim*, const char* file);
aim_status aim_font(aim*, const char* name);
aim_status aim_view(aim*, const double eye[3], const double at[3]);
aim_status aim_perspective(aim*, double horizontal_angle_in_radians);
aim_status aim_orthographic(aim*, double height);

/* ---- environments (2.2.5, 2.2.7, 5.1, 5.2) -------------------------------------------------------------------------
 */
aim_status aim_make_environment(aim*, int* environment);                          /* a name nobody has */
aim_status aim_begin_environment(aim*, int environment);                          /* BeginAniEnv, in an open object */
aim_status aim_end_environment(aim*);                                             /* EndAniEnv */
aim_status aim_start(aim*, int main_object);                                      /* StartAniProc */
aim_status aim_animate(aim*, int environment, long interval, const double m[16]); /* Animate */

/* Animate with what it may have besides. Begin with aim_motion_of() and change what is to be different. */
typedef struct aim_motion {
  double matrix[16];
  long interval;       /* ticks between updates, at least 1 */
  long change, period; /* the interval grows by `change` (below 0: shrinks) every `period` ticks; 0: it stays */
  long ceiling;        /* where a growing interval stops for good */
  long from, until;    /* it starts, it stops so many ticks from now; -1: at once, never */
  int keep_phase;      /* the first update when the old motion's next one was due */
} aim_motion;
aim_motion aim_motion_of(long interval, const double m[16]);
aim_status aim_animate_motion(aim*, int environment, const aim_motion*);

aim_status aim_halt(aim*, int environment);   /* HaltAnimation */
aim_status aim_kill(aim*, int environment);   /* KillAnimation */
aim_status aim_cancel(aim*, int environment); /* drops starts and stops that are still to come */

aim_status aim_get_interval(aim*, int environment, long* interval);         /* GetAniTime */
aim_status aim_get_matrix(aim*, int environment, double m[16]);             /* GetAniMatrix: M, not A */
aim_status aim_get_environment_matrix(aim*, int environment, double a[16]); /* A, as it is now */
aim_status aim_get_slot_counter(aim*, int* slot);                           /* 0 … 29 */
aim_status aim_get_tick(aim*, long* tick);

/* Commands between these are carried out together, in one tick, or not at all. */
aim_status aim_begin_bundle(aim*);
aim_status aim_end_bundle(aim*);
/* A line of the language (docs/language.md); the answer's text, if wanted, lives until the next call. `bundle` and
 * `end` are aim_begin_bundle and aim_end_bundle. */
aim_status aim_command(aim*, const char* line, const char** said);

/* ---- matrices (appendix A)
 * -------------------------------------------------------------------------------------------- */
void aim_identity(double m[16]);
void aim_translate(double m[16], double x, double y, double z);
void aim_scale(double m[16], double x, double y, double z);
void aim_rotate_x(double m[16], double radians);
void aim_rotate_y(double m[16], double radians);
void aim_rotate_z(double m[16], double radians);
/* product = a b: first a, then b. `product` may be either. */
void aim_multiply(double product[16], const double a[16], const double b[16]);
void aim_transform(double p[3], const double m[16]);

#ifdef __cplusplus
}
#endif
#endif
