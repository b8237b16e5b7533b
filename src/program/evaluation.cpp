// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/evaluation.h"

#include <atomic>
#include <cstring>
#include <utility>

#include "base/diagnostic.h"
#include "program/deferred_evaluation.h"
#include "program/evaluator.h"
#include "program/surroundings.h"

namespace betwixt {

// An evaluator with the lights and problems that a frame needs.
struct Whole {
  explicit Whole(const Program::Compiled& compiled, const DeferredEvaluation* deferred = nullptr)
      : evaluator(compiled, deferred) {}
  Evaluator evaluator;
  std::vector<Light> lights;
  std::vector<Layer> layers;
  std::vector<std::int32_t> layer_of;  // by drawable; empty if there are no layers
  std::vector<Problem> reports;
  std::vector<std::string> problems;  // the same in words

  void to(Time, bool news = false);
  void report(const Error&);
  Frame frame() const;
};

void Whole::to(Time t, bool news) {
  if (!news && !evaluator.fresh() && evaluator.time() == t) return evaluator.stay();
  const Program::Compiled& compiled = evaluator.compiled();
  Asking asking;
  asking.deferred = evaluator.deferred();
  const TwerperFailures failed;
  evaluator.to(t, asking);
  lights = evaluator.lights(asking);
  layers = evaluator.layers(layer_of, asking);
  asking.say_all(failed, compiled.document.scene());
  reports.clear();
  for (const std::string& notice : compiled.notices) reports.push_back({Problem::other, {}, {}, notice});
  reports.insert(reports.end(), asking.problems.begin(), asking.problems.end());
  if (asking.deferred)
    for (std::string& late : asking.deferred->late()) reports.push_back({Problem::other, {}, {}, std::move(late)});
  problems = to_strings(reports);
}

void Whole::report(const Error& e) {
  if (std::find(problems.begin(), problems.end(), e.message) != problems.end()) return;
  reports.push_back({Problem::other, {}, {}, e.message}), problems.push_back(e.message);
}

Frame Whole::frame() const {
  const Program::Compiled& compiled = evaluator.compiled();
  Frame f;
  f.time = evaluator.time();
  f.problems = problems, f.reports = reports;
  evaluator.add_items(f, layer_of);
  f.lights = lights, f.layers = layers;
  f.camera = evaluator.camera(), f.change = evaluator.camera_change();
  const Scene& scene = compiled.document.scene();
  f.background = background_of(scene), f.surroundings = surroundings_of(scene);
  for (const Note& n : compiled.document.notes(f.time, f.time)) f.notes.push_back(n.text);
  return f;
}

Program::Compiled::Compiled(Document d) : CompiledFilm(std::move(d)) {}
Program::Compiled::~Compiled() = default;

std::unique_ptr<Whole> IdleEvaluations::take() {
  const std::lock_guard lock(in_use);
  if (all.empty()) return nullptr;
  std::unique_ptr<Whole> one = std::move(all.back());
  all.pop_back();
  return one;
}

void IdleEvaluations::put(std::unique_ptr<Whole> one) {
  const std::lock_guard lock(in_use);
  constexpr std::size_t at_rest = 4;
  if (all.size() < at_rest) all.push_back(std::move(one));
}

Frame Program::frame(Time t) const {
  std::unique_ptr<Whole> whole = code_->caches.idle.take();
  if (!whole) whole = std::make_unique<Whole>(*code_);
  whole->to(t);
  Frame f = whole->frame();
  code_->caches.idle.put(std::move(whole));
  return f;
}

namespace {

// Has no answers: slow values are as they are before the first answer comes.
class NoAnswers final : public DeferredEvaluation {
 public:
  explicit NoAnswers(Time t) : time_(t) {}
  bool ask(const Program&, Time) override { return false; }
  const Answer* answer(const Question&) const override { return nullptr; }
  Time time() const override { return time_; }
  bool quick(const Question&) const override { return false; }
  std::vector<std::string> late() const override { return {}; }

 private:
  const Time time_;
};

}  // namespace

struct Evaluation::State {
  struct Played {
    Played(const Program& p, const DeferredEvaluation* deferred)
        : program(p), whole(std::make_unique<Whole>(p.compiled(), deferred)) {
      for (std::size_t d = 0; d < p.compiled().drawables.size(); ++d)
        drawables.push_back({p.compiled().nodes[d].object});
    }
    Program program;
    std::unique_ptr<Whole> whole;
    std::vector<ObjectId> drawables;
  };

  State(const Program& p, DeferredEvaluation* answers) : deferred(answers), now(p, answers) {}
  DeferredEvaluation* const deferred;
  Played now;
  std::optional<Played> before;  // the last program's state, to compare the next one with
  mutable std::optional<Camera> camera;
  std::optional<Camera> eye;  // replaces the film's camera
  bool prepared = false;      // evaluated in advance, and not yet by `to`
  Revision revision{next_program(), 0};

  static std::uint64_t next_program() {
    static std::atomic<std::uint64_t> programs{0};
    return ++programs;
  }
  const Evaluator& evaluator() const { return now.whole->evaluator; }
  void compare();
};

Evaluation::Evaluation(const Program& program) : state_(std::make_unique<State>(program, nullptr)) {}
Evaluation::Evaluation(const Program& program, DeferredEvaluation& deferred)
    : state_(std::make_unique<State>(program, &deferred)) {}
Evaluation::Evaluation(Evaluation&&) noexcept = default;
Evaluation& Evaluation::operator=(Evaluation&&) noexcept = default;
Evaluation::~Evaluation() = default;

void Evaluation::to(Time t) {
  State& s = *state_;
  const bool news = s.deferred && s.deferred->ask(s.now.program, t);
  s.now.whole->to(t, news || s.prepared);
  if (std::exchange(s.prepared, false)) s.now.whole->evaluator.change_all();
  s.camera.reset();
  ++s.revision.times;
  if (s.before) s.compare();
}

void Evaluation::prepare(Time t) {
  State& s = *state_;
  Evaluator& evaluator = s.now.whole->evaluator;
  const NoAnswers none(t);
  if (s.deferred) evaluator.defer(&none);
  s.now.whole->to(t);
  evaluator.defer(s.deferred);
  s.prepared = true;
}

// Removes from `changed` the drawables that are equal in both programs.
void Evaluation::State::compare() {
  Evaluator& is = now.whole->evaluator;
  const Evaluator& was = before->whole->evaluator;
  const auto same_shape = [&](std::uint32_t a, std::uint32_t b) {
    if (a == Evaluator::nothing || b == Evaluator::nothing) return a == b;
    return is.shape(a) == was.shape(b) || *is.shape(a) == *was.shape(b);
  };
  const auto same = [&](std::size_t i) {
    Look a = is.looks[i], b = was.looks[i];
    if (std::memcmp(&is.worlds()[i], &was.worlds()[i], sizeof(Mat4)) != 0) return false;
    if (!same_shape(a.shape, b.shape) || !same_shape(a.toward, b.toward)) return false;
    a.shape = b.shape, a.toward = b.toward;
    if (is.compiled().picture_key(a.texture) != was.compiled().picture_key(b.texture)) return false;
    a.texture = b.texture;
    if (a.finish == Look::none || b.finish == Look::none ? a.finish != b.finish
                                                         : !(*is.finish(a.finish) == *was.finish(b.finish)))
      return false;
    a.finish = b.finish;
    if (a.gradients == Look::none || b.gradients == Look::none
            ? a.gradients != b.gradients
            : !(*is.gradients(a.gradients) == *was.gradients(b.gradients)))
      return false;
    a.gradients = b.gradients;
    return a == b;
  };
  if (now.drawables == before->drawables) is.unchanged_if(same);
  before.reset();
}

void Evaluation::use(const Program& program) {
  State& s = *state_;
  if (!s.evaluator().fresh() && !s.prepared) s.before = std::move(s.now);
  s.now = State::Played(program, s.deferred), s.prepared = false;
  s.revision = {State::next_program(), 0};
}

const Program& Evaluation::program() const { return state_->now.program; }
Time Evaluation::time() const { return state_->evaluator().time(); }
std::span<const ObjectId> Evaluation::drawables() const { return state_->now.drawables; }
std::span<const Mat4> Evaluation::worlds() const { return state_->evaluator().worlds(); }
std::span<const Evaluation::Look> Evaluation::looks() const { return state_->evaluator().looks; }
const std::shared_ptr<const Shape>& Evaluation::shape(std::uint32_t number) const {
  return state_->evaluator().shape(number);
}
std::shared_ptr<const Picture> Evaluation::texture(std::uint32_t number) const {
  const auto read = state_->now.program.compiled().picture(number);
  if (read) return *read;
  state_->now.whole->report(read.error());
  return nullptr;
}
const std::shared_ptr<const Finish>& Evaluation::finish(std::uint32_t number) const {
  return state_->evaluator().finish(number);
}
const std::shared_ptr<const Gradients>& Evaluation::gradients(std::uint32_t number) const {
  return state_->evaluator().gradients(number);
}
std::span<const std::uint32_t> Evaluation::changed() const { return state_->evaluator().changed; }
Evaluation::Revision Evaluation::revision() const { return state_->revision; }
const std::vector<Light>& Evaluation::lights() const { return state_->now.whole->lights; }
const std::vector<std::string>& Evaluation::problems() const { return state_->now.whole->problems; }
const std::vector<Problem>& Evaluation::reports() const { return state_->now.whole->reports; }
void Evaluation::look_from(std::optional<Camera> eye) { state_->eye = eye; }
const Camera& Evaluation::camera() const {
  if (state_->eye) return *state_->eye;
  if (!state_->camera) state_->camera = state_->evaluator().camera();
  return *state_->camera;
}

bool Evaluation::composed() const {
  const bool changes = !state_->eye && state_->evaluator().compiled().changing_at(time());
  return changes || !state_->now.whole->layers.empty();
}

Frame Evaluation::frame() const {
  Frame f = state_->now.whole->frame();
  f.camera = camera();
  if (state_->eye) f.change.reset();
  return f;
}

}  // namespace betwixt
