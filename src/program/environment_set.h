// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Very many environments at once: all their A at a tick, or from tick to tick only those that are due.
//
// Most environments have one steady motion for good. Those of one interval and one phase share a beat: they are due
// together and lie together, in groups of one form of motion, so a tick reads and writes a few pieces of memory from
// end to end. All others (accelerated, halted, animated again, mirrored, sheared ...) are asked one by one, when they
// are due.
//
// Values are those of Environment::at to 1e-12, and the same bits whether sought or advanced to, on any machine.
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
  // At a tick before all events: every A is the identity.
  explicit EnvironmentSet(std::vector<Member> members);

  std::size_t size() const { return members_.size(); }
  std::int64_t tick() const { return tick_; }
  // A of a member at tick().
  Mat4 matrix(std::size_t member) const;

  // Slots are numbered in the order in which the matrices lie in memory.
  struct Range {
    std::size_t begin = 0, end = 0;
    friend bool operator==(const Range&, const Range&) = default;
  };
  std::size_t slots() const { return steady_slots() + others_.size(); }
  std::size_t slot(std::size_t member) const { return slot_of_[member]; }
  // Some slots are empty.
  std::optional<std::size_t> member(std::size_t slot) const;

  // Goes to any tick; with many, on all cores.
  void seek(std::int64_t tick);
  // Goes to a tick, mostly the next one. Gives the slots whose A may have changed, each at most once; valid until the
  // next call.
  std::span<const Range> advance(std::int64_t tick);
  // The first tick after `tick` at which there is an update. Costs nothing for the tick() of now.
  std::optional<std::int64_t> next_due(std::int64_t tick) const;

 private:
  struct Group {
    std::int64_t first = 0;  // step; those of delay 0 have A = M^(step - first)
    std::int64_t safe = 0;   // to this step no A is near Power::bound
    std::size_t block = 0;   // the first
    std::size_t blocks = 0;
    std::size_t row = 0;  // of motions: the first
    std::size_t major = 0;
    environments::Form form = {};
  };
  struct Block {
    std::uint32_t row = 0;  // of matrices: the first
    environments::Form form = {};
  };
  struct Beat {
    std::int64_t interval = 1, phase = 0;
    std::int64_t begin = 0;  // of the first member's motion
    std::size_t group = 0, groups_end = 0;
  };
  struct Other {
    std::size_t member = 0;
    Mat4 matrix;
  };
  // A beat, or after all beats one of the others.
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
  std::vector<std::int64_t> safe_;  // by slot: as of a group
  std::vector<Due> queue_;          // a heap, the next one in front
  std::vector<std::size_t> due_;    // now
  std::vector<Range> changed_;
  std::int64_t tick_ = 0;
  bool large_ = false;
};

}  // namespace betwixt
