// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The state of one evaluation: open questions, known answers and the cost.
#include <algorithm>
#include <utility>

#include "program/deferred_evaluation.h"

namespace betwixt {

void Asking::note_read(const Target& target) {
  if (read.size() < 10'000 && std::find(read.begin(), read.end(), target) == read.end()) read.push_back(target);
}

void Asking::say(Problem problem) {
  if (std::find(problems.begin(), problems.end(), problem) == problems.end() && problems.size() < 100)
    problems.push_back(std::move(problem));
}

void Asking::say(std::string subject, std::string message) {
  say({Problem::other, std::move(subject), {}, std::move(message)});
}

void Asking::say_all(const Answer& a) {
  for (const Problem& p : a.problems) say(p);
}

void Asking::say_all(const TwerperFailures& failed, const Scene& scene) {
  for (const auto& [i, why] : failed.all) {
    const NamedProcedure& p = (*scene.procedures)[i];
    say({Problem::twerper, {}, p.name, why.message, p.code->source, why.place.line});
  }
}

bool Asking::is_open(const Taken& taken) const {
  return std::any_of(taken.asked.begin(), taken.asked.end(),
                     [&](const Sought& i) { return std::find(open.begin(), open.end(), i) != open.end(); });
}

void Asking::take(const Taken& taken) {
  cost += taken.cost;
  asked.insert(asked.end(), taken.asked.begin(), taken.asked.end());
}

Working::Working(Asking& asking)
    : asking_(asking),
      before_(asking.cost),
      depth_(asking.open.size()),
      outer_cut_(std::exchange(asking.cut, SIZE_MAX)),
      first_(static_cast<std::ptrdiff_t>(asking.asked.size())) {}

std::optional<Asking::Taken> Working::done() {
  std::vector<Sought>& asked = asking_.asked;
  const auto first = asked.begin() + first_;
  std::sort(first, asked.end());
  asked.erase(std::unique(first, asked.end()), asked.end());
  std::optional<Asking::Taken> taken;
  if (asking_.cut >= depth_) taken = Asking::Taken{asking_.cost - before_, {first, asked.end()}};
  if (asking_.open.empty()) asked.clear();
  asking_.cut = std::min(outer_cut_, taken ? SIZE_MAX : asking_.cut);
  return taken;
}

}  // namespace betwixt
