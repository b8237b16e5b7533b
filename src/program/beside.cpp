// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/beside.h"

namespace betwixt {

std::vector<Question> questions_of(const Program::Compiled& c) {
  std::vector<Question> all;
  for (std::uint32_t i = 0; i < c.lives.size(); ++i) all.push_back({Question::live, i});
  for (std::uint32_t i = 0; i < c.slow_shapes.size(); ++i) all.push_back({Question::shape, i});
  if (c.asks_for_camera()) all.push_back({Question::camera, 0});
  return all;
}

Answer work_out(const Program::Compiled& c, const Question& q, Time t) {
  Answer a;
  Asking asking;
  const TwerperFailures failed;
  if (q.what == Question::live) a.value = c.live_value(static_cast<std::int32_t>(q.index), t, asking);
  if (q.what == Question::shape)
    a.shape = std::make_shared<const Shape>(c.shape(c.nodes[c.slow_shapes[q.index]].object, t, nullptr, asking));
  if (q.what == Question::camera) a.camera = c.own_camera();
  c.say(failed, asking);
  a.problems = std::move(asking.problems);
  a.errors = std::move(asking.errors);
  return a;
}

}  // namespace betwixt
