/* SPDX-FileCopyrightText: 2026 The Betwixt authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * A host in C: says every call of the interface to a server, and looks at what comes back. Prints what failed. */
#include <betwixt/aim.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failed = 0, passed = 0;

static void check(int good, const char* what) {
  if (good)
    ++passed;
  else
    ++failed, printf("FAILED: %s\n", what);
}

static int near(const double* a, const double* b, int n) {
  for (int i = 0; i < n; ++i)
    if (!(fabs(a[i] - b[i]) < 1e-9)) return 0;
  return 1;
}

/* The rows of appendix A, written out. */
static void matrices(void) {
  const double c = cos(0.7), s = sin(0.7);
  const double translate[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 2, 3, 4, 1};
  const double scale[16] = {2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 0, 0, 0, 1};
  const double x[16] = {1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1};
  const double y[16] = {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1};
  const double z[16] = {c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  double m[16], t[16], r[16], p[3] = {1, 0, 0};
  aim_translate(m, 2, 3, 4), check(near(m, translate, 16), "Translate (A.1)");
  aim_scale(m, 2, 3, 4), check(near(m, scale, 16), "Scale (A.2)");
  aim_rotate_x(m, 0.7), check(near(m, x, 16), "Rotate_x (A.3)");
  aim_rotate_y(m, 0.7), check(near(m, y, 16), "Rotate_y (A.4)");
  aim_rotate_z(m, 0.7), check(near(m, z, 16), "Rotate_z (A.5)");
  /* S and then T is S T: the point is scaled first. */
  aim_scale(m, 2, 2, 2), aim_translate(t, 1, 0, 0), aim_multiply(r, m, t), aim_transform(p, r);
  check(fabs(p[0] - 3) < 1e-12, "a scale and then a translation is S T");
}

/* Every call without a handle says so, and does nothing. */
static void null_handles(void) {
  const double v[16] = {0};
  const aim_motion motion = aim_motion_of(1, v);
  double m[16];
  int name = 0;
  long number = 0;
  const char* said = 0;
  check(aim_make_object(0, &name) == AIM_E_CALL && aim_close_object(0) == AIM_E_CALL &&
            aim_edit_object(0, 1) == AIM_E_CALL && aim_delete_object(0, 1) == AIM_E_CALL &&
            aim_call_object(0, 1) == AIM_E_CALL && aim_tag(0, &name) == AIM_E_CALL &&
            aim_replace(0, 1, 0) == AIM_E_CALL,
        "objects without a handle");
  check(aim_push_matrix(0) == AIM_E_CALL && aim_pop_matrix(0) == AIM_E_CALL &&
            aim_multiply_matrix(0, v) == AIM_E_CALL && aim_point(0, 0, 0, 0) == AIM_E_CALL &&
            aim_vector(0, v, v) == AIM_E_CALL && aim_polygon(0, 3, v) == AIM_E_CALL && aim_text(0, "") == AIM_E_CALL &&
            aim_color(0, 0, 0, 0) == AIM_E_CALL && aim_texture(0, "") == AIM_E_CALL && aim_font(0, "") == AIM_E_CALL &&
            aim_view(0, v, v) == AIM_E_CALL && aim_perspective(0, 1) == AIM_E_CALL &&
            aim_orthographic(0, 1) == AIM_E_CALL,
        "rows without a handle");
  check(aim_make_environment(0, &name) == AIM_E_CALL && aim_begin_environment(0, 1) == AIM_E_CALL &&
            aim_end_environment(0) == AIM_E_CALL && aim_start(0, 1) == AIM_E_CALL &&
            aim_animate(0, 1, 1, v) == AIM_E_CALL && aim_animate_motion(0, 1, &motion) == AIM_E_CALL &&
            aim_halt(0, 1) == AIM_E_CALL && aim_kill(0, 1) == AIM_E_CALL && aim_cancel(0, 1) == AIM_E_CALL,
        "environments without a handle");
  check(aim_get_interval(0, 1, &number) == AIM_E_CALL && aim_get_matrix(0, 1, m) == AIM_E_CALL &&
            aim_get_environment_matrix(0, 1, m) == AIM_E_CALL && aim_get_slot_counter(0, &name) == AIM_E_CALL &&
            aim_get_tick(0, &number) == AIM_E_CALL && aim_begin_bundle(0) == AIM_E_CALL &&
            aim_end_bundle(0) == AIM_E_CALL && aim_command(0, "time", &said) == AIM_E_CALL,
        "questions without a handle");
  check(strstr(aim_error(0), "the handle is null") != 0 && aim_warnings(0)[0] == 0, "and why");
  aim_disconnect(0);
}

static void refused_names(aim* a, const double m[16]) {
  double got[16];
  long interval;
  for (int name = -1; name <= 0; ++name)
    check(aim_animate(a, name, 1, m) == AIM_E_CALL && aim_halt(a, name) == AIM_E_CALL &&
              aim_kill(a, name) == AIM_E_CALL && aim_cancel(a, name) == AIM_E_CALL &&
              aim_get_interval(a, name, &interval) == AIM_E_CALL && aim_get_matrix(a, name, got) == AIM_E_CALL &&
              aim_begin_environment(a, name) == AIM_E_CALL && aim_edit_object(a, name) == AIM_E_CALL &&
              aim_start(a, name) == AIM_E_CALL && strstr(aim_error(a), "positive") != 0,
          "names below 1");
}

/* `bundle` has no answer of its own: nothing waits for it, however it is said. */
static void lone_bundles(aim* a) {
  const char* said = 0;
  int names[2] = {0, 0};
  check(aim_command(a, "end", 0) == AIM_E_CALL, "no bundle is open");
  check(aim_command(a, " bundle  # together", &said) == AIM_OK && aim_command(a, "bundle", 0) == AIM_E_CALL,
        "a bundle by its word");
  for (int k = 0; k < 2500; ++k) aim_make_environment(a, &names[k % 2]);
  check(names[1] > 0 && names[1] != names[0], "names in a bundle");
  check(aim_command(a, "create lonely sphere", 0) == AIM_OK && aim_command(a, "end", 0) == AIM_OK, "and its end");
  check(aim_command(a, "describe lonely", &said) == AIM_OK && strstr(said, "lonely") != 0, "what it has done");
  check(aim_command(a, "undo", 0) == AIM_OK, "and back");
}

/* A picture of 1 x 1 pixels. */
static const unsigned char dot[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0,    0,    0,    0x0d, 0x49, 0x48, 0x44, 0x52, 0,    0,
    0,    1,    0,    0,    0,    1,    8,    0,    0,    0,    0,    0x3a, 0x7e, 0x9b, 0x55, 0,    0,    0,
    0x0a, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x60, 0,    0,    0,    2,    0,    1,    0x48, 0xaf, 0xa4,
    0x71, 0,    0,    0,    0,    0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

static void sent(aim* a) {
  check(aim_send(0, "dot.png", dot, sizeof dot) == AIM_E_CALL && aim_send(a, 0, dot, sizeof dot) == AIM_E_CALL &&
            aim_send(a, "dot.png", 0, 5) == AIM_E_CALL && aim_send(a, "a dot.png", dot, sizeof dot) == AIM_E_CALL,
        "calls that send nothing");
  check(aim_send(a, "dot.png", dot, 20) == AIM_E_REFUSED && aim_send(a, "dot.exe", dot, sizeof dot) == AIM_E_REFUSED,
        "bytes that are no picture");
  check(aim_send(a, "dot.png", dot, sizeof dot) == AIM_OK &&
            aim_command(a, "create photo rectangle texture=\"@dot.png\"", 0) == AIM_OK,
        "a picture from memory");
  check(aim_command(a, "undo", 0) == AIM_OK, "and back");
  aim_begin_bundle(a);
  check(aim_send(a, "dot.png", dot, sizeof dot) == AIM_E_CALL, "not in a bundle");
  aim_end_bundle(a);
}

static void warnings(aim* a) {
  check(aim_command(a, "halt nobody*", 0) == AIM_OK && strstr(aim_warnings(a), "nothing is named 'nobody*'") != 0,
        "warnings reach the caller");
  check(aim_command(a, "undo", 0) == AIM_OK, "and back");
  check(aim_command(a, "time", 0) == AIM_OK && aim_warnings(a)[0] == 0, "and only of the last call");
}

/* Names are nobody else's, however many hosts there have been. */
static void many_hosts(const char* where, const char* token) {
  static int names[2300];
  int twice = 0;
  for (int k = 0; k < 2300; ++k) {
    aim* a = aim_connect(where, token);
    if (!a || aim_make_environment(a, &names[k]) != AIM_OK || names[k] <= 0) ++twice;
    for (int before = 0; before < k; ++before) twice += names[before] == names[k];
    aim_disconnect(a);
  }
  check(twice == 0, "2,300 hosts have names of their own");
}

int main(int argc, char** argv) {
  const double triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const double eye[3] = {0, 0, 10}, at[3] = {0, 0, 0};
  double m[16], half[16], got[16];
  long interval = 0, now = -1, later = -1;
  int object = 0, scene = 0, spin = 0, drift = 0, tag = 0, slot = -1;
  const char* said = 0;
  matrices();
  check(aim_connect("/nowhere/at/all", 0) == 0 && strstr(aim_error(0), "no server listens") != 0, "nobody listens");
  aim* a = argc > 1 ? aim_connect(argv[1], argc > 2 ? argv[2] : 0) : 0;
  if (!a) return printf("FAILED: connecting: %s\n", aim_error(0)), 1;
#define OK(call) check((call) == AIM_OK, #call), (void)(aim_error(a)[0] && printf("  %s\n", aim_error(a)))

  OK(aim_make_object(a, &object));
  OK(aim_color(a, 1, 0.5, 0));
  OK(aim_tag(a, &tag));
  OK(aim_polygon(a, 3, triangle));
  OK(aim_push_matrix(a));
  aim_translate(m, 0, 0, 1);
  OK(aim_multiply_matrix(a, m));
  OK(aim_point(a, 0, 0, 0));
  OK(aim_vector(a, eye, at));
  OK(aim_pop_matrix(a));
  OK(aim_text(a, "say \"spin\""));
  OK(aim_close_object(a));
  OK(aim_make_environment(a, &spin));
  OK(aim_make_environment(a, &drift));
  OK(aim_make_object(a, &scene));
  OK(aim_view(a, eye, at));
  OK(aim_perspective(a, 0.8));
  OK(aim_begin_environment(a, drift));
  OK(aim_begin_environment(a, spin));
  OK(aim_call_object(a, object));
  OK(aim_end_environment(a));
  OK(aim_end_environment(a));
  OK(aim_close_object(a));
  OK(aim_start(a, scene));
  aim_rotate_z(m, 0.1);
  OK(aim_animate(a, spin, 1, m));
  aim_translate(m, 0.25, 0, 0);
  OK(aim_animate(a, drift, 3, m));
  OK(aim_get_interval(a, drift, &interval));
  check(interval == 3, "GetAniTime gives the interval");
  OK(aim_get_matrix(a, drift, got));
  check(near(got, m, 16), "GetAniMatrix gives M, in rows as it was given");
  OK(aim_get_slot_counter(a, &slot));
  check(slot >= 0 && slot < 30, "the slot counter is below 30");
  OK(aim_get_tick(a, &now));
  OK(aim_halt(a, drift));
  OK(aim_get_interval(a, drift, &interval));
  check(interval == 3, "a halted environment still says its interval");
  /* Twice the speed: M squared. */
  aim_rotate_z(half, 0.2);
  aim_motion motion = aim_motion_of(2, half);
  motion.change = 1, motion.period = 30, motion.ceiling = 6, motion.until = 900, motion.keep_phase = 1;
  OK(aim_animate_motion(a, spin, &motion));
  OK(aim_cancel(a, spin));
  OK(aim_get_environment_matrix(a, spin, got));
  check(fabs(got[0] * got[0] + got[1] * got[1] - 1) < 1e-9 && fabs(got[0] - got[5]) < 1e-9, "A is a turn");

  OK(aim_edit_object(a, object));
  OK(aim_replace(a, tag, 0));
  OK(aim_polygon(a, 3, triangle));
  OK(aim_close_object(a));

  /* Other commands may come between those of an object. */
  OK(aim_edit_object(a, object));
  OK(aim_point(a, 1, 1, 1));
  OK(aim_animate(a, spin, 1, half));
  OK(aim_begin_bundle(a));
  OK(aim_point(a, 2, 2, 2));
  OK(aim_halt(a, spin));
  OK(aim_kill(a, drift));
  OK(aim_end_bundle(a));
  OK(aim_point(a, 3, 3, 3));
  OK(aim_replace(a, tag, 0));
  OK(aim_cancel(a, spin));
  check(aim_point(a, 4, 4, 4) == AIM_E_CALL && strstr(aim_error(a), "repeat 'replace' first") != 0,
        "a replacing that ended");
  OK(aim_replace(a, tag, 0));
  OK(aim_polygon(a, 3, triangle));
  OK(aim_close_object(a));
  char line[64];
  snprintf(line, sizeof line, "describe O%d", object);
  OK(aim_command(a, line, &said));
  check(said && strstr(said, "point (1 1 1)\n  point (2 2 2)\n  point (3 3 3)") != 0, "points between other commands");
  check(aim_begin_bundle(a) == AIM_OK && aim_halt(a, spin) == AIM_OK && aim_halt(a, 77) == AIM_OK &&
            aim_end_bundle(a) == AIM_E_REFUSED,
        "a bundle with an error is refused as a whole");
  OK(aim_get_tick(a, &later));
  check(later >= now, "time goes on");
  OK(aim_command(a, "help animate", &said));
  check(said && strstr(said, "environment") != 0, "a line of the language is answered");

  check(aim_halt(a, 4711) == AIM_E_REFUSED && strstr(aim_error(a), "there is no environment") != 0, "unknown names");
  check(aim_point(a, 0, 0, 0) == AIM_E_CALL && strstr(aim_error(a), "no object is open") != 0, "no object is open");
  check(aim_get_interval(a, drift, 0) == AIM_E_CALL, "null pointers");
  check(aim_get_interval(a, drift, &interval) == AIM_E_REFUSED && strstr(aim_error(a), "it was killed") != 0,
        "killed environments are unknown");
  null_handles();
  refused_names(a, m);
  lone_bundles(a);
  sent(a);
  warnings(a);
  OK(aim_delete_object(a, object));
  aim_disconnect(a);
  many_hosts(argv[1], argc > 2 ? argv[2] : 0);
  printf("%d passed, %d failed\n", passed, failed);
  return failed != 0;
}
