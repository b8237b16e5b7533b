// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// create NAME scene file="…": the nodes of a file become objects below NAME, and its animations become tracks.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/cancellation.h"
#include "base/files.h"
#include "base/names.h"
#include "commands/command.h"
#include "commands/drawings.h"
#include "exchange/scene_names.h"

namespace betwixt {
namespace {

// Returns the exact time of a frame if the file's time, a float, is the nearest float to it.
Time at_frames(double seconds, Rate rate) {
  const Time t = from_seconds(seconds), frame = rate.frame(std::round(rate.frame_number(t)));
  const auto f = static_cast<float>(std::abs(seconds));
  const double half = 0.51 * static_cast<double>(std::nextafter(f, 1e30F) - f);
  return std::abs((t - frame).seconds()) <= half ? frame : t;
}

constexpr double sun_away = 1e6;  // metres: the rays are practically parallel, wherever the node is

// The arguments of the word `scene`.
struct Wanted {
  std::string path;
  std::string animation;  // name or number; empty for the first
  Time start;
  Object root;
};

bool clip_said(Command& k, std::string& out) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  if (c.peek() == '"') return c.text(out);
  out = c.word();
  return !out.empty() || c.fail_here(ErrorCode::syntax, "the name or the number of an animation is missing here",
                                     "as in animation=\"Walk\", animation=2 or animation=none");
}

// Reads the words of `scene` first, then the values of the root object.
bool read_wanted(Command& k, Wanted& w, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  for (c.space();; c.space()) {
    const std::string_view key = c.peek_word();
    if (key != "file" && key != "animation" && key != "start") break;
    c.word();
    if (!c.accept('=')) return c.fail(ErrorCode::syntax, fmt::format("'{}' needs a value", key), key);
    if (key == "file" && !c.text(w.path)) return false;
    if (key == "animation" && !clip_said(k, w.animation)) return false;
    if (key == "start" && !c.time(w.start)) return false;
  }
  if (w.path.empty())
    return c.fail(ErrorCode::syntax, "a scene needs its file first", about,
                  "as in create truck scene file=\"truck.glb\"");
  return parameters(k, w.root);
}

std::string clip_names(const SceneFile& file) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < file.clips.size() && i < 12; ++i)
    names.push_back(file.clips[i].name.empty() ? fmt::format("{}", i + 1) : fmt::format("\"{}\"", file.clips[i].name));
  return fmt::format("{}{}", fmt::join(names, ", "), file.clips.size() > names.size() ? ", …" : "");
}

// Finds the animation. Sets `out` to nullptr if the file has none or if `none` is chosen.
bool find_clip(Command& k, const SceneFile& file, const Wanted& w, std::string_view about, const SceneClip*& out) {
  if (w.animation == "none") return true;
  const auto& clips = file.clips;
  const auto by_name = std::find_if(clips.begin(), clips.end(), [&](const auto& c) { return c.name == w.animation; });
  const bool number = !w.animation.empty() && w.animation.size() < 6 &&
                      w.animation.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t n = number ? std::stoul(w.animation) : 1;
  if (!w.animation.empty() && by_name != clips.end())
    out = &*by_name;
  else if ((number || w.animation.empty()) && n >= 1 && n <= clips.size())
    out = &clips[n - 1];
  else if (!w.animation.empty())
    return k.cursor.fail(ErrorCode::name, fmt::format("{} has no animation '{}'", w.path, w.animation.substr(0, 60)),
                         about,
                         clips.empty() ? "the file has no animations" : "its animations are " + clip_names(file));
  if (w.animation.empty() && clips.size() > 1)
    k.script.note(Severity::notice, fmt::format("the file has {} animations; this uses the first one", clips.size()),
                  about, "choose one by animation=…: " + clip_names(file));
  return true;
}

// Makes the objects of a file, below a named root.
class SceneMaker {
 public:
  SceneMaker(const Scene& s, const SceneFile& file, const Wanted& wanted, const SceneClip* clip)
      : s_(s), file_(file), wanted_(wanted) {
    for (const SceneNode& n : file.nodes) names_.take(n.name);
    tracks_.resize(file.nodes.size());
    for (std::size_t i = 0; clip && i < clip->tracks.size(); ++i)
      tracks_[clip->tracks[i].node].push_back(&clip->tracks[i]);
    used_.resize(file.nodes.size());
    for (const SceneNode& n : file.nodes) {
      if (n.parent >= 0) used_[static_cast<std::size_t>(n.parent)] = true;
      for (const std::uint32_t j : n.joints) used_[j] = true;
    }
  }

  // Returns the objects in order; the first one is the root.
  std::vector<Object> objects(const std::string& name) {
    root_ = name;
    all_.assign(1, wanted_.root), parents_.assign(1, -1);
    all_[0].name = name;
    for (std::size_t i = 0; i < file_.nodes.size(); ++i) {
      Cancellation::check();
      node(i);
    }
    if (file_.meshes.empty()) bones();
    return std::move(all_);
  }
  const std::vector<std::int32_t>& parents() const { return parents_; }  // indexes of objects; -1: that of the root

 private:
  std::string path_of(const std::string& part) const { return root_ + "/" + part; }

  std::size_t add(Object o, std::int32_t parent) {
    all_.push_back(std::move(o)), parents_.push_back(parent);
    return all_.size() - 1;
  }

  void node(std::size_t i) {
    const SceneNode& n = file_.nodes[i];
    const std::int32_t parent = n.parent < 0 ? 0 : object_of_[static_cast<std::size_t>(n.parent)];
    Object o;
    o.name = path_of(n.name);
    const bool follows = n.mesh >= 0 && !n.joints.empty();
    const bool lamp = n.light >= 0 && !file_.lights[static_cast<std::size_t>(n.light)].sun;
    // A mesh with a skin follows its joints, not its node.
    const bool mesh = n.mesh >= 0 && (!follows || !used_[i]), camera = !mesh && n.camera >= 0,
               light = !mesh && !camera && lamp;
    if (mesh) show_mesh(n, o, tracks_[i]);
    if (camera) show_camera(n, o);
    if (light) show_light(n, o);
    if (mesh && follows) {
      object_of_.push_back(static_cast<std::int32_t>(add(std::move(o), 0)));
    } else {
      place(n, o, tracks_[i]);
      object_of_.push_back(static_cast<std::int32_t>(add(std::move(o), parent)));
    }
    const std::int32_t here = object_of_.back();
    const auto besides = [&](const char* what, auto&& show, std::int32_t on) {
      Object part;
      part.name = path_of(names_.give(n.name + "-" + what, what));
      show(part);
      add(std::move(part), on);
    };
    if (n.mesh >= 0 && !mesh)
      besides(
          "skin", [&](Object& p) { show_mesh(n, p, tracks_[i]); }, 0);
    if (n.camera >= 0 && !camera)
      besides(
          "camera", [&](Object& p) { show_camera(n, p); }, here);
    if (n.light >= 0 && !light)
      besides(
          "light", [&](Object& p) { show_light(n, p); }, here);
  }

  void place(const SceneNode& n, Object& o, const std::vector<const SceneTrack*>& tracks) const {
    const auto said = [&](FunctionId f, SceneTrack::Path path, Value v, bool plain) {
      const auto moves = std::find_if(tracks.begin(), tracks.end(), [&](const auto* t) { return t->path == path; });
      if (moves != tracks.end())
        put_events(o.slot(f), **moves, path == SceneTrack::rotation ? turn : vector);
      else if (!plain)
        o.slot(f).set = std::move(v);
    };
    said(fn::position, SceneTrack::position, n.position, n.position == Vec3{});
    said(fn::rotation, SceneTrack::rotation, normalize(n.rotation), n.rotation == Quat{});
    said(fn::scale, SceneTrack::scale, n.scale, n.scale == Vec3{1, 1, 1});
  }

  static Value vector(const double* n) { return Vec3{n[0], n[1], n[2]}; }
  static Value turn(const double* n) { return Quat{n[3], n[0], n[1], n[2]}; }
  static Value unit_turn(const double* n) { return normalize(Quat{n[3], n[0], n[1], n[2]}); }

  // Adds the events of a track. `first`: the index of the number to take, if the function holds one of several.
  void put_events(Slot& slot, const SceneTrack& t, Value (*value)(const double*), std::size_t first = 0) const {
    const std::size_t width = t.width(), per = t.way == SceneTrack::cubic ? 3 : 1;
    Events& events = slot.track.edit().events;
    for (std::size_t i = 0; i < t.times.size(); ++i) {
      if (i % 4096 == 0) Cancellation::check();
      const double* here = &t.values[i * width * per + first];
      Event e;
      e.time = wanted_.start + at_frames(t.times[i], s_.rate);
      e.value = (value == turn ? unit_turn : value)(here + (per == 3 ? width : 0));
      e.twerper = t.way == SceneTrack::step     ? Twerper::hold
                  : t.way == SceneTrack::linear ? (value == turn ? Twerper::slerp : Twerper::linear)
                                                : Twerper::hermite;
      if (t.way == SceneTrack::cubic)
        e.detail.edit().tangent_in = value(here), e.detail.edit().tangent_out = value(here + 2 * width);
      events.put(std::move(e));
    }
  }

  void show_mesh(const SceneNode& n, Object& o, const std::vector<const SceneTrack*>& tracks) const {
    const SceneMesh& m = file_.meshes[static_cast<std::size_t>(n.mesh)];
    o.kind = Kind::mesh;
    o.slot(fn::file).set = Text(wanted_.path + "#" + m.name);
    if (m.material != Material::plastic)
      o.slot(fn::material).set =
          Text(std::string(choices(spec_of(s_, fn::material))[static_cast<std::size_t>(m.material)]));
    if (m.shininess > 0) o.slot(fn::shininess).set = m.shininess;
    if (m.transparency > 0) o.slot(fn::transparency).set = m.transparency;
    if (m.finish) put_finish(o, *m.finish, wanted_.path + "#" + m.name);
    if (!n.joints.empty()) {
      std::vector<std::string> joints;
      for (const std::uint32_t j : n.joints) joints.push_back(path_of(file_.nodes[j].name));
      o.slot(fn::joints).set = Names(std::move(joints));
    }
    if (m.mesh->rig) weigh(n, *m.mesh->rig, o, tracks);
  }

  // `path`: of the mesh, below which its pictures have their names.
  static void put_finish(Object& o, const Finish& f, const std::string& path) {
    const Finish plain;
    constexpr std::pair<FunctionId, double Finish::*> numbers[] = {
        {fn::metalness, &Finish::metalness},
        {fn::roughness, &Finish::roughness},
        {fn::clearcoat, &Finish::clearcoat},
        {fn::clearcoat_roughness, &Finish::clearcoat_roughness},
        {fn::sheen_roughness, &Finish::sheen_roughness},
        {fn::transmission, &Finish::transmission},
        {fn::ior, &Finish::ior},
        {fn::thickness, &Finish::thickness},
        {fn::normal_strength, &Finish::normal_strength},
        {fn::texture_turn, &Finish::turn}};
    for (const auto& [function, is] : numbers)
      if (f.*is != plain.*is || function == fn::metalness || function == fn::roughness) o.slot(function).set = f.*is;
    if (const double most = std::max({f.emission.x, f.emission.y, f.emission.z}); most > 0) {
      o.slot(fn::emission).set = to_srgb(most > 1 ? 1 / most * f.emission : f.emission);
      if (most > 1) o.slot(fn::emission_strength).set = most;
    }
    if (!(f.sheen == Vec3{})) o.slot(fn::sheen).set = to_srgb(f.sheen);
    if (f.tile_x != 1 || f.tile_y != 1) o.slot(fn::texture_tile).set = Vec3{f.tile_x, f.tile_y, 0};
    if (f.move_x != 0 || f.move_y != 0) o.slot(fn::texture_move).set = Vec3{f.move_x, f.move_y, 0};
    constexpr FunctionId maps[] = {fn::normal_map, fn::roughness_map, fn::metalness_map, fn::occlusion_map,
                                   fn::emission_map};
    const auto rows = pictures_of_finish();
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (f.*rows[i].is) o.slot(maps[i]).set = Text(fmt::format("{}/{}", path, rows[i].name));
  }

  void weigh(const SceneNode& n, const Rig& rig, Object& o, const std::vector<const SceneTrack*>& tracks) const {
    const auto moves =
        std::find_if(tracks.begin(), tracks.end(), [](const auto* t) { return t->path == SceneTrack::weights; });
    for (std::size_t i = 0; i < rig.targets.size(); ++i) {
      const auto f = find_function(s_, Kind::mesh, rig.targets[i].name);
      if (!f || spec_of(s_, *f).type != Type::scalar) continue;  // already reported
      if (moves != tracks.end())
        put_events(
            o.slot(*f), **moves, [](const double* at) { return Value(*at); }, i);
      else if (i < n.weights.size() && n.weights[i] != 0)
        o.slot(*f).set = n.weights[i];
    }
  }

  void show_camera(const SceneNode& n, Object& o) const {
    const SceneCamera& c = file_.cameras[static_cast<std::size_t>(n.camera)];
    o.kind = Kind::camera;
    if (c.fov > 0)
      o.slot(fn::fov).set = c.fov;
    else
      o.slot(fn::camera_height).set = c.height;
  }

  void show_light(const SceneNode& n, Object& o) const {
    const SceneLight& l = file_.lights[static_cast<std::size_t>(n.light)];
    o.kind = Kind::light;
    if (!(l.color == Vec3{1, 1, 1})) o.slot(fn::color).set = to_srgb(l.color);
    if (l.intensity != 1) o.slot(fn::intensity).set = l.intensity;
    if (!l.sun) {
      o.slot(fn::range).set = l.range;
      return;
    }
    o.slot(fn::shines).set = Text(std::string("sun"));
    o.slot(fn::position).set = Vec3{0, 0, sun_away};
  }

  // For a file without anything visible, draws lines from each joint to its children.
  void bones() {
    double size = 0;
    for (const SceneNode& n : file_.nodes) size = std::max(size, length(n.position));
    for (std::size_t i = 0; i < file_.nodes.size(); ++i) {
      const SceneNode& n = file_.nodes[i];
      if (n.parent < 0 || !(length(n.position) > 1e-6 * size)) continue;
      Object bone;
      bone.kind = Kind::line;
      bone.name = path_of(names_.give(n.name + "-bone", "bone"));
      bone.slot(*find_built_in(Kind::line, "to")).set = n.position;
      bone.slot(fn::width).set = size / 20;
      add(std::move(bone), object_of_[static_cast<std::size_t>(n.parent)]);
    }
  }

  const Scene& s_;
  const SceneFile& file_;
  const Wanted& wanted_;
  SceneNames names_;
  std::vector<std::vector<const SceneTrack*>> tracks_;  // by node
  std::vector<bool> used_;                              // by node: it has children or followers
  std::string root_;
  std::vector<Object> all_;
  std::vector<std::int32_t> parents_, object_of_;  // by object; by node
};

// Returns a command that makes the same objects again, even if another animation has become the first.
std::string command_of(const Wanted& w, const SceneFile& file, const SceneClip* clip) {
  std::string out = "scene file=" + write_text(w.path);
  if (clip)
    out += fmt::format(" animation={}", clip - file.clips.data() + 1);
  else if (!file.clips.empty())
    out += " animation=none";
  if (w.start != Time{}) out += " start=" + write_seconds(w.start);
  return out;
}

// Defines the weights of morph targets as display functions, which every object has.
bool define_weights(Command& k, const SceneFile& file, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  for (const SceneMesh& m : file.meshes)
    for (std::size_t i = 0; m.mesh->rig && i < m.mesh->rig->targets.size(); ++i) {
      const std::string& name = m.mesh->rig->targets[i].name;
      if (const auto f = find_function(s, Kind::mesh, name)) {
        if (spec_of(s, *f).type != Type::scalar)
          script.note(
              Severity::warning,
              fmt::format(
                  "the morph target '{}' cannot have a weight: a function of that name already exists, and is {}", name,
                  to_string(spec_of(s, *f).type)),
              about);
        continue;
      }
      if (s.defined->size() >= OwnFunctions::most)
        return c.fail(ErrorCode::range, fmt::format("a film can define at most {} functions", OwnFunctions::most),
                      about);
      s.defined.edit().push_back({.name = name, .type = Type::scalar, .rest = 0.0, .kinds = 0xffffffff});
    }
  return true;
}

}  // namespace

bool create_scene(Command& k, const std::vector<std::string>& names, const std::vector<ObjectId>& parents,
                  std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  Wanted wanted;
  if (!read_wanted(k, wanted, about)) return false;
  if (ending(wanted.path) == "svg") return create_drawing(k, names, parents, wanted.root, wanted.path, about);
  std::filesystem::path where;
  if (!may_use(k, wanted.path, about, where)) return false;
  const auto loaded = scene_of_file(k, where);
  if (!loaded) return c.fail(loaded.error(), about);
  const SceneFile& file = **loaded;
  const SceneClip* clip = nullptr;
  if (!find_clip(k, file, wanted, about, clip)) return false;
  Rollback back(s);
  if (!define_weights(k, file, about)) return false;
  if (!keep_meshes(k, wanted.path, file, about)) return false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    SceneMaker maker(s, file, wanted, clip);
    std::vector<Object> all = maker.objects(names[i]);
    if (s.objects.size() + all.size() > most_objects)
      return c.fail(ErrorCode::range, fmt::format("a film can have at most {} objects", most_objects), about);
    for (const Object& o : all)
      if (!free_name(k, o.name, about)) return false;
    FromFile made{{}, names[i], command_of(wanted, file, clip), {}};
    std::vector<ObjectId> ids;
    for (std::size_t n = 0; n < all.size(); ++n) {
      ids.push_back(
          add_child(s, std::move(all[n]), n == 0 ? parents[i] : ids[static_cast<std::size_t>(maker.parents()[n])]));
      if (n > 0) made.parts.push_back(s.objects[ids[n].index]);
    }
    made.root = ids[0];
    s.from_files.edit().push_back(std::move(made));
  }
  for (const std::string& sentence : file.left_out)
    script.note(Severity::warning, fmt::format("in {}: {}", wanted.path, sentence), about);
  back.keep();
  return true;
}

}  // namespace betwixt
