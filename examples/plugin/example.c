// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A plug-in: a twerper that goes beyond its end and comes back, a filter that moves in steps, and a kind of objects.
// Make it with
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

BETWIXT_PLUGIN(host) {
  host->register_twerper(host, "overshoot", "goes a tenth beyond the end and comes back", overshoot, 0);
  host->register_filter(host, "stairs", "moves in steps: step=0.25", stairs, 0);
  host->register_kind(host, "signal", "a traffic light; its lamps are NAME/top, NAME/middle and NAME/bottom",
                      "create signal box size=(0.6 1.6 0.3) color=#303030\n"
                      "create signal/{bottom,middle,top} sphere radius=0.2 position=(0 0.5*i-1 0.15) color=#505050\n");
  return 0;
}
