// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// One evaluation in progress: its open questions, the answers known so far, its cost, and what there is to report.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "betwixt/frame.h"
#include "scene/document.h"

namespace betwixt {

struct Answer;
struct OpenStep;
struct Question;
struct Contacts;
class DeferredEvaluation;
class TwerperFailures;

// A value to evaluate: of a live, or of one of its components, at a time.
struct Sought {
  std::int32_t live = 0;
  int component = -1;
  std::int64_t time = 0;
  friend auto operator<=>(const Sought&, const Sought&) = default;
};

// The state of one evaluation. It caches the values found on the way, except those that depend on a cut cycle.
struct Asking {
  struct Taken {  // the cost and the inputs of an answer
    std::uint64_t cost = 0;
    std::vector<Sought> asked;  // itself and all values it read; the answer may differ while one of these is open
  };
  template <class T>
  struct Found {
    T value;
    Taken taken;
  };
  std::vector<Sought> open;    // being evaluated, outermost first
  std::vector<Sought> asked;   // read by the open ones up to now
  std::size_t cut = SIZE_MAX;  // depth in `open` of the outermost value that a cut cycle reached
  std::map<Sought, Found<Value>> found;
  std::map<std::int64_t, Found<std::shared_ptr<const Contacts>>> found_contacts;
  std::uint64_t cost = 0;   // in steps
  std::uint64_t begun = 0;  // the cost when the outermost question began …
  bool given_up = false;    // … and whether it has exceeded its limit: then it has no answer
  // The limit for the whole evaluation; a caller that lowers it discards an answer that exceeds it.
  std::uint64_t most = UINT64_MAX;
  bool in_haste() const { return most < UINT64_MAX; }
  std::vector<Problem> problems;
  std::vector<Target> read;  // values that procedures have read
  OpenStep* step = nullptr;  // of a stepped procedure, for which these values are evaluated
  const DeferredEvaluation* deferred =
      nullptr;  // has the answers of the outermost questions; null to compute them here

  // The limit of work for one question: steps of procedures, inputs of filters, nested questions. The count ignores the
  // cache, so it does not depend on earlier questions.
  static constexpr std::uint64_t most_work = 10'000'000;
  // The limit for all questions of one frame together.
  static constexpr std::uint64_t most_of_a_frame = 50'000'000;
  // Adds to the cost. Returns true if a limit is exceeded, now or earlier.
  bool work(std::uint64_t steps) {
    cost += steps;
    given_up = given_up || cost - begun > most_work || cost > most;
    if (given_up) cut = 0;  // caches no value from here on
    return given_up;
  }

  // Whether an answer from `deferred` counts, and which; null before the first one.
  struct Deferred {
    bool yes = false;
    const Answer* answer = nullptr;
  };
  Deferred deferred_answer(const Question&, Time) const;
  void note_read(const Target&);
  void say(Problem);
  void say(std::string subject, std::string message);  // of Problem::other
  void say_all(const Answer&);                         // reports its problems
  void say_all(const TwerperFailures&, const Scene&);  // reports each failed twerper once
  bool is_open(const Taken&) const;                    // one of the values it read is still open
  void take(const Taken&);                             // adds its cost and inputs to the present question
};

// An evaluation in progress: measures its cost and inputs.
class Working {
 public:
  explicit Working(Asking&);
  // Ends the evaluation. Returns nullopt if the answer must not be cached, because a cycle through an outer value was
  // cut.
  std::optional<Asking::Taken> done();

 private:
  Asking& asking_;
  std::uint64_t before_;
  std::size_t depth_, outer_cut_;
  std::ptrdiff_t first_;
};

}  // namespace betwixt
