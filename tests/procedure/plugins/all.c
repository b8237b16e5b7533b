// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// One of each that a plug-in can bring.
#include <betwixt/plugin.h>

static double power(double u, void* user) { return *(const double*)user > 1 ? u * u : u; }
static double endless(double u, void* user) {
  (void)user;
  return 1 / (u - u);
}
static int faster(const struct betwixt_questions* q, const struct betwixt_value* arguments, size_t count,
                  struct betwixt_value* out, void* user) {
  (void)user;
  if (q->value(q->state, q->self, q->seconds + 1, out)) return 1;
  out->numbers[0] *= count > 0 ? arguments[0].numbers[0] : 1;
  return 0;
}
static int lost(const struct betwixt_questions* q, const struct betwixt_value* arguments, size_t count,
                struct betwixt_value* out, void* user) {
  (void)arguments, (void)count, (void)user;
  return q->value(q->state, "nowhere", 0, out);
}
static int twice(const struct betwixt_commands* c, const char* const* words, size_t count, const char** why,
                 void* user) {
  (void)user;
  if (count < 1) {
    *why = "twice what?";
    return 1;
  }
  *why = c->run(c->state, words[0]);
  if (!*why) *why = c->run(c->state, words[0]);
  return *why != 0;
}
static double two = 2;

BETWIXT_PLUGIN(host) {
  const double start[] = {1, 2, 3};
  return host->register_twerper(host, "power", "u squared", power, &two) ||
         host->register_twerper(host, "endless", "no number", endless, 0) ||
         host->register_value(host, "faster", "a second ahead", faster, 0) ||
         host->register_value(host, "lost", "asks in vain", lost, 0) ||
         host->register_command(host, "twice", "runs a line twice", twice, 0) ||
         host->register_function(host, "wind", "vector", start, 3);
}
