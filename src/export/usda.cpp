// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A film as text of USD. Time samples are linear, rotations take the shortest arc; a jump takes a millionth of a frame.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "betwixt/object.h"
#include "betwixt/pose.h"
#include "export/fit.h"
#include "export/formats.h"
#include "export/seen.h"
#include "export/usda_text.h"
#include "program/compiled.h"
#include "scene/functions.h"
#include "scene/rig.h"

namespace betwixt {
namespace {

class UsdMaker : UsdText {
 public:
  UsdMaker(const Program& program, ExportOptions options, Exported& made)
      : UsdText(program.document(), std::move(options), made), program_(program) {
    if (options_.keys.style == KeyStyle::cubic) options_.keys.style = KeyStyle::linear;
    options_.keys.in_floats = false;
  }

  Result<std::string> make() {
    keys_ = motion_keys(program_, options_.from, options_.until, options_.keys);
    keep_asked(keys_, options_.objects);
    made_.objects = keys_.size();
    for (const ObjectKeys& k : keys_) keys_of_[k.id.index] = &k;
    for (const ObjectKeys& k : keys_)
      below_[k.parent && keys_of_.contains(k.parent.index) ? k.parent.index : ObjectId::nothing].push_back(&k);
    Result<std::vector<Seen>> seen =
        all_seen(program_, options_, made_, [&](const Skin& skin) { return !joints_of(skin).empty(); });
    if (!seen) return seen.error();
    for (Seen& s : *seen)
      if (is_asked(s.id, options_.objects) && keys_of_.contains(s.id.index)) seen_[s.id.index] = &s;
    for (const auto& [index, s] : seen_)
      for (std::size_t form = 0; form < s->forms.size() && s->skin < 0; ++form) ++users_[s->forms[form].mesh.get()];
    const double last = (options_.until - options_.from).seconds() * rate_;
    out_ = fmt::format(
        "#usda 1.0\n(\n    defaultPrim = \"film\"\n    doc = \"Made by Betwixt\"\n    metersPerUnit = 1\n    upAxis = "
        "\"Y\"\n"
        "    timeCodesPerSecond = {0}\n    framesPerSecond = {0}\n    startTimeCode = 0\n    endTimeCode = {1}\n)\n\n"
        "def Xform \"film\"\n{{\n",
        number(rate_), number(last));
    add_below(ObjectId::nothing, 1, "/film");
    for (const auto& [index, s] : std::map(seen_.begin(), seen_.end()))
      if (s->skin >= 0) skinned(*s);
    for (const auto& [index, l] : suns_) sun(l);
    add_own_camera();
    add_shared();
    out_ += "}\n";
    return std::move(out_);
  }

 private:
  void add_below(std::uint32_t parent, int depth, const std::string& path) {
    for (const ObjectKeys* k : below_[parent]) {
      const std::string name = document_.name(k->id);
      const std::string own = plain(name);
      std::string here = path + "/" + own;
      line(depth, fmt::format("def Xform \"{}\"", own));
      line(depth, "{");
      line(depth + 1, fmt::format("custom string betwixt:name = \"{}\"", name));
      place(depth + 1, *k);
      int inside = depth + 1;
      if (k->sheared) {
        const std::string turned = plain(own + "_turned");
        line(inside, fmt::format("def Xform \"{}\"", turned));
        line(inside, "{");
        here += "/" + turned;
        attribute(++inside, "quatf xformOp:orient", k->inner, turn);
        line(inside, "uniform token[] xformOpOrder = [\"xformOp:orient\"]");
      }
      if (const auto s = seen_.find(k->id.index); s != seen_.end()) draw(inside, *s->second, here);
      if (kind(document_, k->id) == Kind::camera) camera(inside, k->id);
      if (kind(document_, k->id) == Kind::light) light(inside, k->id);
      add_below(k->id.index, inside, here);
      if (k->sheared) line(--inside, "}");
      line(depth, "}");
    }
  }

  void place(int depth, const ObjectKeys& k) {
    attribute(depth, "double3 xformOp:translate", k.translation);
    attribute(depth, "quatf xformOp:orient", k.rotation, turn);
    attribute(depth, "float3 xformOp:scale", k.scale);
    line(depth, "uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\", \"xformOp:scale\"]");
  }

  // ---- Objects

  void draw(int depth, const Seen& s, const std::string& path) {
    for (std::size_t form = 0; form < s.forms.size() && s.skin < 0; ++form) {
      const Mesh& mesh = *s.forms[form].mesh;
      if (mesh.triangles.empty()) {
        leave_out(made_, fmt::format("the line {} has no width and is left out", document_.name(s.id)));
        continue;
      }
      const std::string name = plain(path.substr(path.rfind('/') + 1) + "_shape");
      // A mesh that several objects use is written once, and each of them is an instance of it.
      const bool shared = users_[&mesh] > 1;
      if (shared) {
        const auto [known, fresh] = shared_.try_emplace(&mesh, fmt::format("shape_{}", shared_.size() + 1));
        line(depth, fmt::format("def Xform \"{}\" (", name));
        line(depth + 1, "prepend apiSchemas = [\"MaterialBindingAPI\"]");
        line(depth + 1, "instanceable = true");
        line(depth + 1, fmt::format("prepend references = </film/shapes/{}>", known->second));
        line(depth, ")");
        if (fresh) meshes_.push_back(s.forms[form].mesh);
      } else {
        line(depth, fmt::format("def Mesh \"{}\" (", name));
        line(depth + 1, "prepend apiSchemas = [\"MaterialBindingAPI\"]");
        line(depth, ")");
      }
      line(depth, "{");
      visibility(depth + 1, s, static_cast<int>(form));
      if (!shared) geometry(depth + 1, mesh);
      looks(depth + 1, s);
      const Mat4& local = s.forms[form].local;
      if (!s.stretch.pieces.empty())
        attribute(depth + 1, "float3 xformOp:scale", s.stretch);
      else
        line(depth + 1, "float3 xformOp:scale = " + row({local(0, 0), local(1, 1), local(2, 2), 0}, 3));
      line(depth + 1, "uniform token[] xformOpOrder = [\"xformOp:scale\"]");
      line(depth, "}");
    }
    if (s.texture) leave_out(made_, "textures are left out");
  }

  // Writes colours for readers without materials, and the material.
  void looks(int depth, const Seen& s) {
    attribute(depth, "color3f[] primvars:displayColor", s.color,
              [](const KeyValue& v, std::size_t) { return "[" + row(v, 3) + "]"; });
    if (!s.opacity.constant() || s.opacity.pieces[0].begin[0] < 1)
      attribute(depth, "float[] primvars:displayOpacity", s.opacity,
                [](const KeyValue& v, std::size_t) { return "[" + number(v[0]) + "]"; });
    if (!s.color.constant() || !s.opacity.constant())
      leave_out(made_,
                fmt::format("the material of {} keeps its first values; displayColor and displayOpacity are animated",
                            document_.name(s.id)));
    line(depth, fmt::format("rel material:binding = </film/looks/{}>", material(s)));
  }

  // Writes shared parts: meshes as prototypes, which are not visible by themselves, and materials.
  void add_shared() {
    if (!meshes_.empty()) {
      line(1, "class Scope \"shapes\"");
      line(1, "{");
      for (const auto& mesh : meshes_) {
        line(2, fmt::format("def Xform \"{}\"", shared_.at(mesh.get())));
        line(2, "{");
        line(3, "def Mesh \"mesh\"");
        line(3, "{");
        geometry(4, *mesh);
        line(3, "}");
        line(2, "}");
      }
      line(1, "}");
    }
    if (materials_.empty()) return;
    line(1, "def Scope \"looks\"");
    line(1, "{");
    std::map<std::size_t, const std::string*> in_order;
    for (const auto& [inputs, number] : materials_) in_order[number] = &inputs;
    for (const auto& [number, inputs] : in_order) {
      line(2, fmt::format("def Material \"look_{}\"", number));
      line(2, "{");
      line(3, fmt::format("token outputs:surface.connect = </film/looks/look_{}/surface.outputs:surface>", number));
      line(3, "def Shader \"surface\"");
      line(3, "{");
      line(4, "uniform token info:id = \"UsdPreviewSurface\"");
      out_ += *inputs;
      line(4, "token outputs:surface");
      line(3, "}");
      line(2, "}");
    }
    line(1, "}");
  }

  // ---- Skins

  // Returns the joints of a skin and all their parents, parents first, or an empty list if they cannot be a skeleton.
  std::vector<const ObjectKeys*> joints_of(const Skin& skin) const {
    if (skin.joints.empty() || !skin.rest->rig || !skin.rest->rig->targets.empty()) return {};
    std::vector<const ObjectKeys*> all;
    std::set<std::uint32_t> known, once;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      if (!once.insert(joint(skin, i)).second) return {};  // two poses at rest, and a skeleton has one
      std::vector<const ObjectKeys*> chain;
      for (ObjectId at{joint(skin, i)}; at && !known.contains(at.index);) {
        const auto found = keys_of_.find(at.index);
        if (found == keys_of_.end() || found->second->sheared) return {};
        chain.push_back(found->second), known.insert(at.index);
        at = found->second->parent;
      }
      all.insert(all.end(), chain.rbegin(), chain.rend());
    }
    return all;
  }
  std::uint32_t joint(const Skin& skin, std::size_t i) const {
    const std::int32_t node = skin.joints[i];
    return program_.compiled().nodes[node < 0 ? skin.drawable : static_cast<std::uint32_t>(node)].object;
  }

  static Mat4 local_of(const ObjectKeys& k, Time t) {
    const KeyValue move = value_at(k.translation, t), turn = value_at(k.rotation, t), grow = value_at(k.scale, t);
    return translation({move[0], move[1], move[2]}) * rotation({turn[3], turn[0], turn[1], turn[2]}) *
           scaling({grow[0], grow[1], grow[2]});
  }
  // Writes a skeleton with a joint for each object that moves the mesh, parents included; it is in world space.
  void skinned(const Seen& s) {
    const Skin& skin = program_.compiled().skins[static_cast<std::size_t>(s.skin)];
    const std::vector<const ObjectKeys*> joints = joints_of(skin);
    const Mesh& mesh = *s.forms[0].mesh;
    std::unordered_map<std::uint32_t, std::size_t> place;
    std::vector<std::string> tokens;
    std::vector<Mat4> bind;
    for (const ObjectKeys* k : joints) {
      const auto above = k->parent ? place.find(k->parent.index) : place.end();
      const Mat4 local = local_of(*k, options_.from);
      bind.push_back(above == place.end() ? local : bind[above->second] * local);
      const std::string one = plain(letters(document_.name(k->id)) + "_joint");
      const std::string token = above == place.end() ? one : tokens[above->second] + "/" + one;
      place[k->id.index] = tokens.size();
      tokens.push_back(token);
    }
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      index.push_back(place.at(joint(skin, i)));
      if (const auto back = inverse(skin.joints[i] < 0 ? Mat4{} : mesh.rig->inverse_bind[i]))
        bind[index.back()] = *back;
    }
    const std::string name = plain(letters(document_.name(s.id)) + "_skin"), path = "/film/" + name;
    line(1, fmt::format("def SkelRoot \"{}\"", name));
    line(1, "{");
    line(2, "def Skeleton \"skeleton\" (");
    line(3, "prepend apiSchemas = [\"SkelBindingAPI\"]");
    line(2, ")");
    line(2, "{");
    const auto word = [&](std::size_t i) { return "\"" + tokens[i] + "\""; };
    list(3, "uniform token[] joints =", tokens.size(), word);
    list(3, "uniform matrix4d[] bindTransforms =", bind.size(), [&](std::size_t i) { return matrix(bind[i]); });
    list(3, "uniform matrix4d[] restTransforms =", joints.size(),
         [&](std::size_t i) { return matrix(local_of(*joints[i], options_.from)); });
    line(3, fmt::format("rel skel:animationSource = <{}/skeleton/animation>", path));
    line(3, "def SkelAnimation \"animation\"");
    line(3, "{");
    list(4, "uniform token[] joints =", tokens.size(), word);
    together(4, "float3[] translations", joints, &ObjectKeys::translation, row);
    together(4, "quatf[] rotations", joints, &ObjectKeys::rotation, turn);
    together(4, "half3[] scales", joints, &ObjectKeys::scale, row);
    line(3, "}");
    line(2, "}");
    line(2, "def Mesh \"mesh\" (");
    line(3, "prepend apiSchemas = [\"SkelBindingAPI\", \"MaterialBindingAPI\"]");
    line(2, ")");
    line(2, "{");
    visibility(3, s, 0);
    geometry(3, mesh);
    looks(3, s);
    constexpr std::string_view four =
        " (\n                elementSize = 4\n                interpolation = \"vertex\"\n            )";
    const Rig& rig = *mesh.rig;
    list(
        3, "int[] primvars:skel:jointIndices =", 4 * rig.joints.size(),
        [&](std::size_t i) { return fmt::format("{}", index[rig.joints[i / 4][i % 4]]); }, four);
    list(
        3, "float[] primvars:skel:jointWeights =", 4 * rig.weights.size(),
        [&](std::size_t i) { return shortest(rig.weights[i / 4][i % 4]); }, four);
    line(3, "matrix4d primvars:skel:geomBindTransform = " + matrix({}));
    line(3, fmt::format("rel skel:skeleton = <{}/skeleton>", path));
    line(2, "}");
    line(1, "}");
  }

  // Equal materials are written once. Returns the name.
  std::string material(const Seen& s) {
    const KeyValue& color = s.color.pieces[0].begin;
    std::string inputs;
    const auto input = [&](const std::string& text) { inputs += "                " + text + "\n"; };
    const auto of = [](Vec3 c) { return KeyValue{c.x, c.y, c.z, 1}; };
    if (s.finish) {
      const Finish& f = *s.finish;
      input("color3f inputs:diffuseColor = " + row(s.color.constant() ? of(s.own_color) : color, 3));
      input("color3f inputs:emissiveColor = " + row(of(f.emission), 3));
      for (const auto& [name, is] : finish_inputs(f)) input(fmt::format("float inputs:{} = {}", name, number(is)));
      if (f.pattern != Pattern::none || f.has_pictures())
        leave_out(made_, "the patterns and pictures of materials are left out: their mean colors and numbers stay");
    } else {
      input("color3f inputs:diffuseColor = " + row(s.material == Material::glow ? KeyValue{} : color, 3));
      if (s.material == Material::glow) input("color3f inputs:emissiveColor = " + row(color, 3));
      input(fmt::format("float inputs:metallic = {}", s.material == Material::metal ? 1 : 0));
      input("float inputs:roughness = " + number(s.material == Material::matte ? 1 : 1 - s.shininess));
    }
    input("float inputs:opacity = " + number(s.opacity.pieces[0].begin[0]));
    return fmt::format("look_{}", materials_.try_emplace(inputs, materials_.size() + 1).first->second);
  }

  // ---- Cameras and lights

  double number_of(ObjectId id, FunctionId f) const {
    const std::vector<double> n = numbers(program_.read({id, f}, options_.from));
    return n.empty() ? 0 : n[0];
  }
  void camera(int depth, ObjectId id) {
    has_camera_ = true;
    if (const double height = number_of(id, fn::camera_height); height > 0)
      return lens(depth, true, height * document_.aspect());
    const double fov = number_of(id, fn::fov), length = number_of(id, fn::lens);
    lens(depth, false, fov > 0 ? std::min(fov, 3.1) : 2 * std::atan(18 / std::max(length, 0.1)));
    for (const FunctionId f : {fn::fov, fn::lens})
      if (!value_keys(program_, {id, f}, options_.from, options_.until, options_.keys).constant())
        leave_out(made_, fmt::format("the lens of {} keeps its first value", document_.name(id)));
  }
  void add_own_camera() {
    if (has_camera_) return;
    const Camera c = program_.frame(options_.from).camera;
    const Quat q = from_matrix(c.world);
    const Vec3 at = translation_of(c.world);
    line(1, "def Xform \"view\"");
    line(1, "{");
    line(2, "double3 xformOp:translate = " + row({at.x, at.y, at.z, 0}, 3));
    line(2, "quatf xformOp:orient = " + turn({q.x, q.y, q.z, q.w}, 4));
    line(2, "uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]");
    lens(2, c.orthographic, c.orthographic ? c.height * c.aspect : c.fov);
    line(1, "}");
  }

  void light(int depth, ObjectId id) {
    const Frame frame = program_.frame(options_.from);
    const auto found =
        std::find_if(frame.lights.begin(), frame.lights.end(), [&](const Light& l) { return l.id == id; });
    if (found == frame.lights.end()) return;
    if (found->sun) {
      suns_.emplace(id.index, *found);
      return;
    }
    line(depth, "def SphereLight \"light\"");
    line(depth, "{");
    line(depth + 1, "float inputs:radius = 0.1");
    line(depth + 1, "color3f inputs:color = " + row({found->color.x, found->color.y, found->color.z, 0}, 3));
    line(depth + 1, "float inputs:intensity = " + number(found->range * found->range));
    line(depth, "}");
  }

  // It shines towards the world's origin, whatever its rotation; full light is pi lux.
  void sun(const Light& l) {
    Channel power = value_keys(program_, {l.id, fn::intensity}, options_.from, options_.until, options_.keys);
    for (KeyPiece& p : power.pieces) p.begin[0] *= pi, p.end[0] *= pi;
    Followed f = followed(document_, 4, options_.keys.radians, [&](Time t) -> KeyValue {
      const Vec3 from = translation_of(pose(program_, l.id, t).world);
      const Quat q = from_matrix(look_at({}, normalize(-from, {0, -1, 0})));
      return {q.x, q.y, q.z, q.w};
    });
    f.turn = true;
    const auto knots =
        knots_between(program_.discontinuities(options_.from, options_.until), options_.from, options_.until);
    line(1, fmt::format("def DistantLight \"{}\"", plain(letters(document_.name(l.id)) + "_rays")));
    line(1, "{");
    attribute(2, "float inputs:intensity", power);
    attribute(2, "color3f inputs:color",
              value_keys(program_, {l.id, fn::color}, options_.from, options_.until, options_.keys));
    line(2, "bool inputs:normalize = 1");
    attribute(2, "quatf xformOp:orient", follow(f, knots, options_.keys), turn);
    line(2, "uniform token[] xformOpOrder = [\"xformOp:orient\"]");
    line(1, "}");
  }

  const Program& program_;
  std::vector<ObjectKeys> keys_;
  std::unordered_map<std::uint32_t, const ObjectKeys*> keys_of_;
  std::unordered_map<std::uint32_t, Seen*> seen_;
  std::unordered_map<const Mesh*, std::size_t> users_;      // how many forms use it
  std::unordered_map<const Mesh*, std::string> shared_;     // its prototype
  std::vector<std::shared_ptr<const Mesh>> meshes_;         // of prototypes, in order
  std::unordered_map<std::string, std::size_t> materials_;  // by content
  std::map<std::uint32_t, Light> suns_;
  std::unordered_map<std::uint32_t, std::vector<const ObjectKeys*>> below_;
  bool has_camera_ = false;
};

}  // namespace

Result<std::string> make_usda(const Program& program, const ExportOptions& options, Exported& made) {
  return UsdMaker(program, options, made).make();
}

}  // namespace betwixt
