// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The values at a time of those functions of a drawable that a script has given; the others keep what they are.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "program/compile.h"
#include "program/evaluator.h"

namespace betwixt {

// Finds the bindings that are not defaults. Returns whether there is one.
template <class Use>
bool find_given(Use& use, const CompiledFilm& film, std::uint32_t object) {
  bool any = false;
  for (std::size_t i = 0; i < Use::count; ++i) {
    const auto f = static_cast<FunctionId>(Use::first + i);
    if (const Binding& b = film.find_shown(object, f); &b != &film.defaults[f]) use.bound[i] = &b, any = true;
  }
  return any;
}

template <class Use>
class GivenValues {
 public:
  GivenValues(const Use& use, const Program::Compiled& film, const std::vector<double>& numbers, Time t, Asking& asking)
      : use_(use), film_(film), numbers_(numbers), time_(t), asking_(asking) {}

  void number(FunctionId f, double& to) const {
    if (const Binding* b = use_.at(f)) to = numbers_[b->offset];
  }
  void share(FunctionId f, double& to) const { number(f, to), to = std::clamp(to, 0.0, 1.0); }
  void color(FunctionId f, Vec3& to) const {
    if (const Binding* b = use_.at(f)) to = {numbers_[b->offset], numbers_[b->offset + 1], numbers_[b->offset + 2]};
  }
  void pair(FunctionId f, double& x, double& y) const {
    if (const Binding* b = use_.at(f)) x = numbers_[b->offset], y = numbers_[b->offset + 1];
  }
  void picture(FunctionId f, std::shared_ptr<const Picture>& to) const {
    if (!use_.at(f)) return;
    const std::uint32_t number = film_.texture(value(f));
    to = number == Evaluation::Look::none ? nullptr : film_.textures[number];
  }
  std::string word(FunctionId f) const { return use_.at(f) ? *std::get<Text>(value(f)) : std::string(); }
  // Sets `to` to the enumerator of the word; they are in the order of the words of `of`.
  template <class Enum>
  void choice(FunctionId f, FunctionId of, Enum& to) const {
    const std::vector<std::string_view> words = choices(built_in_functions()[of]);
    const auto found = std::find(words.begin(), words.end(), word(f));
    if (found != words.end()) to = static_cast<Enum>(found - words.begin());
  }

 private:
  Value value(FunctionId f) const { return film_.value(*use_.at(f), time_, asking_); }
  const Use& use_;
  const Program::Compiled& film_;
  const std::vector<double>& numbers_;
  const Time time_;
  Asking& asking_;
};

}  // namespace betwixt
