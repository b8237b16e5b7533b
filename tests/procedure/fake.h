// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A fake film for procedures: the value of every target is the square of its time, and a test chooses the procedures.
#pragma once

#include <map>
#include <memory>

#include "scene/axes.h"
#include "track/procedure.h"

namespace betwixt {

struct FakeQuestions : Questions {
  double time = 0;
  std::string name = "ball";
  std::map<std::string, std::shared_ptr<const Routine>, std::less<>> procedures;
  std::map<std::string, Value, std::less<>> readings;
  double seconds() const override { return time; }
  Rate rate() const override { return {25, 1}; }
  std::string_view self() const override { return name; }
  Result<Value> value(std::string_view target, double seconds, std::uint64_t& cost) override {
    cost += 10;
    if (const auto r = readings.find(target); r != readings.end()) return r->second;
    if (const auto p = procedures.find(target); p != procedures.end()) {
      FakeQuestions inner = *this;
      inner.time = seconds;
      auto v = p->second->value(inner, {}, cost);
      if (!v) return v.error();
      return v;
    }
    if (target == "nowhere") return fail(ErrorCode::name, "there is no 'nowhere'");
    return Value(seconds * seconds);
  }
  Result<Vec3> place(std::string_view, double share, double seconds, std::uint64_t&) override {
    return Vec3{share, seconds, 0};
  }
  Result<State> state(std::string_view, double seconds, std::uint64_t&) override { return State{Value(seconds)}; }
  Turn turn(std::string_view) override { return {}; }
  Status axes(std::string_view object, double, AxesSpace& out, std::uint64_t&) override {
    if (object == "nowhere") return fail(ErrorCode::name, "there is no object 'nowhere'");
    return out = space, Nothing{};
  }
  AxesSpace space;
  const Routine* procedure(std::string_view name) override {
    const auto p = procedures.find(name);
    return p == procedures.end() ? nullptr : p->second.get();
  }
};

struct FakeInput : Input {
  Value at(double seconds) override { return Value(10 * seconds); }
  Rate rate() const override { return {25, 1}; }
};

struct FakeHost : Host {
  std::vector<std::string> lines;
  Status run(std::string_view line) override {
    if (line.starts_with("bad")) return fail(ErrorCode::syntax, "there is no command 'bad'");
    lines.emplace_back(line);
    return Nothing{};
  }
  Result<Value> value(std::string_view, double seconds) override { return Value(2 * seconds); }
  std::vector<std::string> objects(std::string_view pattern) override { return {"a" + std::string(pattern), "b"}; }
  Result<Vec3> place(std::string_view, double share, double seconds) override { return Vec3{share, seconds, 0}; }
  Status sheet(std::string_view target, const std::vector<HostRow>& rows) override {
    for (const HostRow& row : rows)
      lines.push_back(std::string(target) + " " + std::to_string(row.from) + " " + row.rest);
    return Nothing{};
  }
  std::string when(double seconds) override { return std::to_string(seconds) + "s"; }
};

}  // namespace betwixt
