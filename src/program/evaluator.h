// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The state of a compiled document at a time. It is kept from one time to the next, so that unchanged values are not
// computed again. It depends only on the program and the time, not on earlier times.
//
// A step in time: the sources that are due (Schedule) write their numbers and mark the nodes they affect.
// Marked nodes get their own matrices. One walk in depth-first order, where a subtree is an interval, then updates the
// nodes below them. At last, marked drawables get their looks.
#pragma once

#include <span>

#include "betwixt/evaluation.h"
#include "program/needed.h"
#include "program/placing.h"
#include "program/playing.h"

namespace betwixt {

using playing::Own;

class Evaluator {
 public:
  explicit Evaluator(const Program::Compiled&, const DeferredEvaluation* = nullptr);

  // `solids`: of the live values, evaluate only those that affect positions and shapes.
  void to(Time, Asking&, bool solids = false);
  void place(Time, Asking&, const Needed&);  // evaluates only what one node's transform needs
  void stay();                               // stays at this time: nothing has changed
  void change_all();                         // lists all drawables as changed
  bool fresh() const { return fresh_; }
  Time time() const { return now_; }

  const double* numbers() const { return numbers_.data(); }
  Mat4 world(std::uint32_t node) const { return compiled_.sited ? around_[node] * worlds_[node] : worlds_[node]; }
  Placed placed(std::uint32_t node) const { return {worlds_[node], turn(node)}; }
  Mat4 around(std::uint32_t node) const { return compiled_.sited ? around_[node] : Mat4{}; }
  std::uint32_t body(std::uint32_t node) const { return body_[node]; }  // the node that it forms one body with

  using Looks = Evaluation::Look;
  static constexpr std::uint32_t nothing = Looks::none;
  std::span<const Mat4> worlds() const {  // for each drawable
    return {compiled_.sited ? shown_.data() : worlds_.data(), looks.size()};
  }
  std::vector<Looks> looks;
  std::vector<std::uint32_t> changed;  // drawables that differ from the last time, in order

  // Removes drawables from `changed` if `same` says so.
  template <class Same>
  void unchanged_if(Same&& same) {
    std::erase_if(changed, same);
  }

  const std::shared_ptr<const Shape>& shape(std::uint32_t number) const {
    return number < compiled_.shapes.size() ? compiled_.shapes[number] : forms_[number - compiled_.shapes.size()];
  }
  const std::shared_ptr<const Finish>& finish(std::uint32_t number) const { return finishes_[number]; }
  const std::shared_ptr<const Gradients>& gradients(std::uint32_t number) const { return gradients_[number]; }
  std::vector<std::uint32_t> joints_of(std::uint32_t hand) const;
  Quat own_turn(std::uint32_t node) const;
  void add_items(Frame&, const std::vector<std::int32_t>& layers) const;
  std::vector<Light> lights(Asking&) const;
  void aim_light(Light&, std::uint32_t node, Asking&) const;
  // Returns the layers, and sets the layer of each drawable, -1 for none.
  std::vector<Layer> layers(std::vector<std::int32_t>& of_drawables, Asking&) const;
  Camera camera() const;
  Camera camera_of(std::uint32_t object) const;
  std::optional<CameraChange> camera_change() const;
  double focus(std::uint32_t object, const Camera&) const;

  const Program::Compiled& compiled() const { return compiled_; }
  const DeferredEvaluation* deferred() const { return deferred_; }
  void defer(const DeferredEvaluation* to) { deferred_ = to; }

 private:
  void play_to(Time);
  void touch(std::uint32_t source, std::int64_t t);
  void collect(std::int64_t t);
  void evaluate(std::uint32_t source, std::int64_t t);
  void play(std::int64_t t);
  bool seek(std::uint32_t source, std::int64_t t, std::uint32_t k);
  void evaluate_lives(Asking&, bool solids);
  void evaluate_coded(Asking&);
  void evaluate(const Schedule::LiveSource&, Asking&);
  void take_hold(Asking&);
  void environments(Asking&, bool own_set);
  bool wants(std::uint32_t object) const;
  void arrange();
  void arrange_eyes();
  Own own_of(std::uint32_t node, Asking&) const;
  void place_marked(Asking&);
  void settle(std::uint32_t node, const Own&);
  void put_world(std::uint32_t node, const Mat4&);
  void compose(std::uint32_t node);
  void show_sited(std::uint32_t node);
  void compose_below(std::uint32_t at);
  void places(Asking&);
  void turn_eyes(Asking&);
  void arrange_reaches();
  std::optional<Time> held_since(std::uint32_t node, std::uint32_t hand, std::span<const std::uint32_t> joints) const;
  void reach(std::uint32_t hand, Asking&);
  Vec3 joint_place(std::uint32_t node) const;
  void turn_joint(std::uint32_t node, Quat);
  Placed own_placed(std::uint32_t node) const;
  void follow_joints();
  std::shared_ptr<const Mesh> posed(std::int32_t skin) const;
  void restyle(Asking&, bool solids);
  void look(std::uint32_t drawable, Asking&, bool solids);
  void take_shape(std::uint32_t drawable, Looks&, Asking&);
  void take_match(std::uint32_t drawable, Looks&, Asking&);
  void mark_pieces();
  bool layer_at(std::uint32_t node, Layer&, std::vector<std::uint32_t>& masks, Asking&) const;
  bool take_finish(std::uint32_t drawable, const MaterialRow&, Looks&, Asking&);
  bool take_gradients(std::uint32_t drawable, Looks&, Asking&);
  bool take_blend(std::uint32_t drawable, Looks&, Asking&);
  std::uint32_t put(std::size_t form, std::shared_ptr<const Shape>);
  std::uint32_t form(std::uint32_t drawable, Asking&);
  std::uint32_t texture(const Drawable&, Asking&) const;
  std::uint32_t shape_of(const Value&, std::uint32_t drawable, Asking&);
  std::shared_ptr<const Shape> made(std::uint32_t drawable, Asking&) const;
  std::uint32_t splined(const StepTrack&, const Between&, std::uint32_t drawable, Asking&);
  Quat turn(std::uint32_t node) const { return turns_.empty() ? Quat{} : turns_[node]; }
  // Its own matrix is stored, because it hangs on something or may be turned.
  bool kept_apart(std::uint32_t node) const { return compiled_.nodes[node].looks || compiled_.nodes[node].bends; }
  bool kept(std::uint32_t node) const { return held_[node] || kept_apart(node); }
  template <class F>
  void each_below(std::uint32_t node, F&& f) const {
    for (std::uint32_t at = at_[node], end = at + size_[at]; at < end; ++at) f(order_[at]);
  }

  const Program::Compiled& compiled_;
  const DeferredEvaluation* deferred_;  // has the answers of slow questions; null to compute them here
  const Needed* only_ = nullptr;        // what place() needs; null for everything
  bool fresh_ = true;
  Time now_;
  std::vector<double> numbers_;

  // Sources: curves that are changing; other sources that are; sources evaluated in this step.
  std::vector<playing::Segment> segments_;  // by source; no channels if it is not a curve
  std::vector<std::uint32_t> curves_, left_;
  std::vector<std::uint32_t> events_;  // parallel to left_: where each segment begins
  struct Active {
    std::uint32_t source = 0;
    Activity now;
  };
  std::vector<Active> active_;
  std::vector<std::uint32_t> due_, asked_;
  std::uint32_t turn_ = 0;
  playing::Marks marks_;  // nodes, and the parts of them

  std::vector<const CompiledSpan*> held_;  // by node
  std::vector<CompiledSpan> by_code_;      // parallel to Compiled::held_by_code
  std::vector<std::int32_t> parent_;
  bool rearrange_ = true;
  // Nodes depth first; a node's index there; the size of the subtree at an index.
  std::vector<std::uint32_t> order_, at_, size_;
  std::vector<playing::Link> links_;  // parallel to `order_`
  std::vector<std::uint32_t> eyes_;   // in the order in which they turn
  std::vector<std::uint32_t> body_;

  std::int64_t tick_ = INT64_MIN;
  std::optional<EnvironmentSet> many_;
  std::vector<Mat4> products_;  // by siting
  std::vector<char> turned_;    // … and whether it has changed
  std::vector<Own> owns_;       // by node, if any hangs on something: the transform before its parent's
  std::vector<Mat4> worlds_;    // by node, without its environments
  std::vector<Quat> turns_;     // by node, if any is needed
  // By node and by drawable, if any is in an environment: product of environments, world transform.
  std::vector<Mat4> around_, shown_;
  std::vector<std::uint32_t> alike_[2];  // nodes to place: those with angles, those with quaternions
  std::vector<std::uint32_t> dirty_places_;
  std::vector<std::vector<Mat4>> palettes_;  // by skin

  // By drawable: shapes that vary; then those on splines, and those of blends; then what these blend into.
  std::vector<std::shared_ptr<const Shape>> forms_;
  std::vector<std::shared_ptr<const Finish>> finishes_;  // of drawables that have one
  std::vector<std::shared_ptr<const Gradients>> gradients_;
  std::vector<std::uint8_t> stale_;     // … and must be made again
  std::vector<std::uint32_t> renewed_;  // the step of its last change
  playing::Marks flags_;                // nodes that have changed; `changed` lists the drawables among them
};

// Returns the joints of an inverse-kinematics chain, with the rotations that give the same pose.
std::vector<std::pair<ObjectId, Quat>> reached_turns(const Program::Compiled&, ObjectId hand, Time, Asking&);

}  // namespace betwixt
