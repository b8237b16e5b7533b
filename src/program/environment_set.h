// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A large set of environments: computes every A at a tick, or from tick to tick only those that are due.
//
// Most environments have one steady motion. Those of one interval and phase share a beat: they are due together and are
// stored together, in groups of one form of motion, so a tick reads and writes few contiguous pieces of memory. All
// others (accelerated, halted, animated again, mirrored, sheared ...) are evaluated one by one when they are due.
//
// Values equal Environment::at to 1e-12, and have the same bits after seek() and advance(), on any machine.
//
// Source: Animation Imaging Model 3.3.3, the slot structure; the value of an environment never depends on the load.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/large_pages.h"
#include "betwixt/math.h"
#include "program/environment_kernels.h"
#include "scene/environment.h"

namespace betwixt {

class EnvironmentSet {
 public:
  struct Member {
    std::shared_ptr<const Environment> environment;
    int generation = 0;
  };
  // Starts at a tick before all events: every A is the identity.
  explicit EnvironmentSet(std::vector<Member> members);

  std::size_t size() const { return members_.size(); }
  std::int64_t tick() const { return tick_; }
  // Returns A of a member at tick().
  Mat4 matrix(std::size_t member) const;

  // Slots are numbered in the order of the matrices in memory.
  struct Range {
    std::size_t begin = 0, end = 0;
    friend bool operator==(const Range&, const Range&) = default;
  };
  std::size_t slots() const { return steady_slots() + others_.size(); }
  std::size_t slot(std::size_t member) const { return slot_of_[member]; }
  // Returns the member in a slot, or nullopt if the slot is empty.
  std::optional<std::size_t> member(std::size_t slot) const;

  // Moves to any tick. A large set uses all cores.
  void seek(std::int64_t tick);
  // Moves to a tick, usually the next one. Returns the slots whose A may have changed, each at most once. The span is
  // valid until the next call.
  std::span<const Range> advance(std::int64_t tick);
  // Returns the tick of the first update after `tick`, or nullopt. Costs nothing for the present tick().
  std::optional<std::int64_t> next_due(std::int64_t tick) const;

 private:
  struct Group {
    std::int64_t first = 0;  // step; members of delay 0 have A = M^(step - first)
    std::int64_t safe = 0;   // up to this step, no A is near Power::bound
    std::size_t block = 0;   // its first block
    std::size_t blocks = 0;
    std::size_t row = 0;  // its first row of motions
    std::size_t major = 0;
    environments::Form form = {};
  };
  struct Block {
    std::uint32_t row = 0;  // its first row of matrices
    environments::Form form = {};
  };
  struct Beat {
    std::int64_t interval = 1, phase = 0;
    std::int64_t begin = 0;  // start of the earliest motion
    std::size_t group = 0, groups_end = 0;
  };
  struct Other {
    std::size_t member = 0;
    Mat4 matrix;
  };
  // `what`: a beat, or beyond all beats one of the others.
  struct Due {
    std::int64_t tick = 0;
    std::size_t what = 0;
    friend auto operator<=>(const Due&, const Due&) = default;
  };
  struct Steady;
  using Iterator = std::vector<Steady>::const_iterator;

  static std::optional<Steady> steady(const Member&, std::size_t index);
  void add_beat(Iterator first, Iterator last);
  void add_group(Iterator first, Iterator last);
  std::size_t steady_slots() const { return blocks_.size() * environments::lanes; }
  std::size_t things() const { return beats_.size() + others_.size(); }
  const environments::Row* motions_of(std::size_t what) const;
  void evaluate(const Beat&, Range blocks, const environments::Row* then);
  void evaluate(const Group&, Range blocks, std::int64_t step, const environments::Row* then);
  void evaluate(Other&);
  void hold(const Group&, Range slots, std::int64_t step);
  environments::Run run(const Group&, std::size_t begin, std::size_t end);
  template <class Rows, class F>
  static void for_each_element(Rows&, const Block&, const F&);
  std::optional<std::int64_t> due(std::size_t what, std::int64_t tick) const;
  Range slots_of(std::size_t what) const;
  void touch(Range);

  std::vector<Member> members_;
  std::vector<Group> groups_;
  std::vector<Beat> beats_;
  std::vector<Other> others_;
  std::vector<Block> blocks_;
  std::vector<environments::Row, LargePages<environments::Row>> motions_, matrices_;
  std::vector<std::uint32_t> slot_of_, member_at_;
  std::vector<environments::Delays, LargePages<environments::Delays>> delays_;
  std::vector<std::int64_t> safe_;  // by slot, as Group::safe
  std::vector<Due> queue_;          // a heap with the next one in front
  std::vector<std::size_t> due_;    // at the present tick
  std::vector<Range> changed_;
  std::int64_t tick_ = 0;
  bool large_ = false;
};

}  // namespace betwixt
