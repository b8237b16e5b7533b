// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A film as glTF 2.0: objects are nodes below what they hang on, their motion is keys, what varies of their looks is
// animated by KHR_animation_pointer, and shapes that change are meshes of which one at a time has a size.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "betwixt/picture.h"
#include "betwixt/pose.h"
#include "export/fit.h"
#include "export/formats.h"
#include "export/gltf_parts.h"
#include "export/seen.h"
#include "program/compiled.h"

namespace betwixt {
namespace {

Json numbers(const std::array<double, 4>& v, std::size_t width) {
  Json all = Json::array();
  for (std::size_t i = 0; i < width; ++i) all.push_back(static_cast<float>(v[i]));
  return all;
}

Channel held(std::array<double, 4> v, std::size_t width, Time from, Time until) {
  return {width, false, {{KeyPiece::held, from, until, v, v, {}, {}}}};
}

class Maker {
 public:
  Maker(const Program& program, ExportOptions options, Exported& made)
      : program_(program), document_(program.document()), options_(std::move(options)), made_(made) {
    options_.keys.in_floats = true;
    frames_ = static_cast<std::size_t>(std::max(
        1.0, document_.rate().frame_number(options_.until) - document_.rate().frame_number(options_.from) + 1));
  }

  Status make() {
    place_objects();
    if (options_.keys.go_on && !options_.keys.go_on(1)) return fail(ErrorCode::machine, "stopped");
    Result<std::vector<Seen>> seen =
        all_seen(program_, options_, made_, [&](const Skin& skin) { return one_tree(skin); });
    if (!seen) return seen.error();
    for (const Seen& s : *seen)
      if (Status ok = draw(s); !ok) return ok;
    lights();
    cameras();
    finish();
    return Nothing{};
  }

  const Json& json() const { return file_; }
  Json& json() { return file_; }
  const std::string& bytes() const { return buffer_.bytes; }

 private:
  std::size_t add_node(Json node) {
    nodes_.push_back(std::move(node));
    children_.emplace_back();
    return nodes_.size() - 1;
  }
  void animate(const Channel& c, Json target) { animate(gltf::sampled(c, options_.from), c.width, std::move(target)); }
  void animate(const gltf::Sampled& s, std::size_t width, Json target) {
    const std::size_t input = buffer_.floats(s.times, 1, gltf::Buffer::plain, true);
    const std::size_t output = buffer_.floats(s.values, width, gltf::Buffer::plain, false);
    channels_.push_back({{"sampler", samplers_.size()}, {"target", std::move(target)}});
    samplers_.push_back({{"input", input}, {"output", output}, {"interpolation", s.way}});
    ++made_.channels;
    made_.keys += s.times.size(), made_.baked += frames_;
  }
  // A property of a node: for good, or with keys. `rest`: what it is where nothing is said.
  void put(std::size_t node, const char* path, const Channel& c, const std::array<double, 4>& rest) {
    const auto& first = c.pieces.front().begin;
    const auto same = [&](double a, double b) { return static_cast<float>(a) == static_cast<float>(b); };
    if (!std::equal(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(c.width), rest.begin(), same))
      nodes_[node][path] = numbers(first, c.width);
    if (!c.constant()) animate(c, {{"node", node}, {"path", path}});
  }
  void point(const std::string& pointer, const Channel& c) {
    use("KHR_animation_pointer");
    animate(c, {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}});
  }
  void use(const char* extension) {
    if (std::find(used_.begin(), used_.end(), extension) == used_.end()) used_.push_back(extension);
  }

  void place_objects() {
    std::vector<ObjectKeys> all = motion_keys(program_, options_.from, options_.until, options_.keys);
    keep_asked(all, options_.objects);
    for (const ObjectKeys& k : all) {
      const std::size_t node = add_node({{"name", document_.name(k.id)}});
      inner_of_[k.id.index] = node_of_[k.id.index] = node;
      put(node, "translation", k.translation, {});
      put(node, "rotation", k.rotation, {0, 0, 0, 1});
      put(node, "scale", k.scale, {1, 1, 1});
      if (!k.sheared) continue;
      const std::size_t inner = add_node({{"name", document_.name(k.id) + " turned"}});
      put(inner, "rotation", k.inner, {0, 0, 0, 1});
      children_[node].push_back(inner);
      inner_of_[k.id.index] = inner;
    }
    for (const ObjectKeys& k : all) {
      const auto parent = k.parent ? inner_of_.find(k.parent.index) : inner_of_.end();
      parent == inner_of_.end() ? roots_.push_back(node_of_[k.id.index])
                                : children_[parent->second].push_back(node_of_[k.id.index]);
    }
    made_.objects = all.size();
    parent_.assign(nodes_.size(), nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (const std::size_t child : children_[i]) parent_[child] = i;
  }

  bool asked(ObjectId id) const { return is_asked(id, options_.objects); }

  // ---- what is deformed

  std::size_t joint(const Skin& skin, std::size_t i) const {
    const std::int32_t node = skin.joints[i];
    const std::uint32_t object =
        program_.compiled().nodes[node < 0 ? skin.drawable : static_cast<std::uint32_t>(node)].object;
    return inner_of_.at(object);
  }
  // Whether all joints hang on one node in the end, as glTF wants it.
  bool one_tree(const Skin& skin) const {
    for (const std::int32_t joint : skin.joints)
      if (joint >= 0 && !inner_of_.contains(program_.compiled().nodes[static_cast<std::uint32_t>(joint)].object))
        return false;
    std::optional<std::size_t> root;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      std::size_t top = joint(skin, i);
      while (parent_[top] < parent_.size()) top = parent_[top];
      if (root.value_or(top) != top) return false;
      root = top;
    }
    return true;
  }
  // Of a mesh with joints the node counts for nothing: it is the scene's own. The node that has it.
  std::size_t add_skin(const Seen& s, const std::string& name) {
    const Skin& skin = program_.compiled().skins[static_cast<std::size_t>(s.skin)];
    if (skin.joints.empty()) return inner_of_[s.id.index];
    std::vector<float> inverse_bind;
    Json joints = Json::array();
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const Mat4 m = skin.joints[i] < 0 ? Mat4{} : s.forms[0].mesh->rig->inverse_bind[i];
      for (const double x : m.m) inverse_bind.push_back(static_cast<float>(x));
      joints.push_back(joint(skin, i));
    }
    const std::size_t node = add_node({{"name", name + " skin"}});
    roots_.push_back(node);
    nodes_[node]["skin"] = skins_.size();
    skins_.push_back({{"name", name},
                      {"joints", joints},
                      {"inverseBindMatrices", buffer_.floats(inverse_bind, 16, gltf::Buffer::plain, false)}});
    if (s.when.size() > 1)
      leave_out(made_, fmt::format("{} is hidden at times: with its joints it is always seen", name));
    return node;
  }
  void add_rig(const Rig& rig, bool joints, Json& attributes, Json& targets) {
    if (joints) {
      std::vector<float> weights;
      for (const auto& w : rig.weights) weights.insert(weights.end(), w.begin(), w.end());
      attributes["JOINTS_0"] = buffer_.joints(rig.joints, rig.weights);
      attributes["WEIGHTS_0"] = buffer_.floats(weights, 4, gltf::Buffer::vertices, false);
    }
    for (const Rig::Target& t : rig.targets) {
      Json one = Json::object();
      const auto add = [&](const char* path, const Rig::Vectors& vectors) {
        std::vector<float> all;
        for (const auto& v : vectors) all.insert(all.end(), v.begin(), v.end());
        if (!all.empty()) one[path] = buffer_.floats(all, 3, gltf::Buffer::vertices, true);
      };
      add("POSITION", t.positions), add("NORMAL", t.normals);
      targets.push_back(one);
    }
  }
  // All weights of a mesh have their keys at the same times: what each is at the times of all.
  void add_weights(const Seen& s, std::size_t node) {
    const Skin& skin = program_.compiled().skins[static_cast<std::size_t>(s.skin)];
    const auto& targets = s.forms[0].mesh->rig->targets;
    KeyOptions straight = options_.keys;
    straight.style = straight.style == KeyStyle::baked ? KeyStyle::baked : KeyStyle::linear;
    std::vector<Channel> all;
    std::set<Time> times;
    bool still = true;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      all.push_back(held({}, 1, options_.from, options_.until));
      if (skin.weights[i])
        all.back() = value_keys(program_, {s.id, skin.weights[i]->function}, options_.from, options_.until, straight);
      still = still && all.back().constant();
      for (const KeyPiece& p : all.back().pieces) times.insert(p.from), times.insert(p.until);
    }
    if (all.empty()) return;
    Json first = Json::array();
    for (const Channel& c : all) first.push_back(static_cast<float>(c.pieces.front().begin[0]));
    nodes_[node]["weights"] = first;
    if (still) return;
    gltf::Sampled keys{"LINEAR", {}, {}};
    for (const Time t : times) {
      const auto seconds = static_cast<float>((t - options_.from).seconds());
      if (!keys.times.empty() && seconds <= keys.times.back()) continue;
      keys.times.push_back(seconds);
      for (const Channel& c : all) keys.values.push_back(static_cast<float>(value_at(c, t)[0]));
    }
    animate(keys, 1, {{"node", node}, {"path", "weights"}});
  }

  // ---- what is seen

  Status draw(const Seen& s) {
    if (s.forms.empty() || !inner_of_.contains(s.id.index) || !asked(s.id)) return Nothing{};
    const std::string name = document_.name(s.id);
    const bool always = s.when.size() == 1 && s.when[0].form == 0;
    const bool stretched = !s.stretch.pieces.empty();
    for (std::size_t form = 0; form < s.forms.size(); ++form) {
      const Result<std::size_t> mesh = add_mesh(s, form, name);
      if (!mesh) return mesh.error();
      std::size_t node = s.skin >= 0 ? add_skin(s, name) : inner_of_[s.id.index];
      if (s.skin >= 0) add_weights(s, node);
      if (s.skin < 0 && (!always || stretched)) {
        node = add_node({{"name", s.forms.size() > 1 ? fmt::format("{} shape {}", name, form + 1) : name + " shape"}});
        children_[inner_of_[s.id.index]].push_back(node);
        put(node, "scale", always ? s.stretch : sizes(s, static_cast<int>(form)), {1, 1, 1});
      }
      nodes_[node]["mesh"] = *mesh;
    }
    return Nothing{};
  }

  // How large a form is: nothing, while it is not seen.
  Channel sizes(const Seen& s, int form) const {
    Channel c{3, false, {}};
    for (std::size_t i = 0; i < s.when.size(); ++i) {
      const Time from = s.when[i].time, until = i + 1 < s.when.size() ? s.when[i + 1].time : options_.until;
      const bool here = s.when[i].form == form;
      if (until <= from && i + 1 < s.when.size()) continue;
      if (!here && i > 0 && s.when[i - 1].form != form) {
        c.pieces.back().until = std::max(from, until);
        continue;
      }
      if (!here || s.stretch.pieces.empty()) {
        const double size = here ? 1 : 0;
        c.pieces.push_back(
            {KeyPiece::held, from, std::max(from, until), {size, size, size}, {size, size, size}, {}, {}});
        continue;
      }
      const Followed f = followed(document_, 3, options_.keys.metres, [&](Time t) { return value_at(s.stretch, t); });
      for (const KeyPiece& p : follow(f, knots({&s.stretch}, from, until), options_.keys).pieces) c.pieces.push_back(p);
    }
    return with_leaps(c);
  }
  static std::vector<Time> knots(std::initializer_list<const Channel*> channels, Time from, Time until) {
    std::vector<Time> all;
    for (const Channel* c : channels) add_knots(*c, all);
    return knots_between(std::move(all), from, until);
  }
  // Where pieces that were put together jump, a leap of one float.
  Channel with_leaps(Channel c) const {
    if (c.steps()) return c;
    Channel out{c.width, c.turn, {}};
    for (KeyPiece p : c.pieces) {
      if (!out.pieces.empty() && out.pieces.back().end != p.begin) {
        const float now = static_cast<float>((p.from - options_.from).seconds());
        const Time before = options_.from + from_seconds(static_cast<double>(std::nextafter(now, -1.0F)));
        out.pieces.back().until = before;
        out.pieces.push_back({KeyPiece::leap, before, p.from, out.pieces.back().end, p.begin, {}, {}});
      }
      out.pieces.push_back(p);
    }
    return out;
  }

  Result<std::size_t> add_mesh(const Seen& s, std::size_t form, const std::string& name) {
    const Seen::Form& f = s.forms[form];
    const auto known = meshes_of_.find({f.mesh.get(), f.local.m});
    Json attributes, targets = Json::array();
    if (known != meshes_of_.end()) {
      attributes = known->second;
    } else {
      std::vector<float> places, normals, uvs;
      const Mat4 turn =
          Mat4{{1 / f.local(0, 0), 0, 0, 0, 0, 1 / f.local(1, 1), 0, 0, 0, 0, 1 / f.local(2, 2), 0, 0, 0, 0, 1}};
      for (const auto& p : f.mesh->positions) {
        const Vec3 at = transform_point(f.local, {p[0], p[1], p[2]});
        places.insert(places.end(), {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)});
      }
      for (const auto& n : f.mesh->normals) {
        const Vec3 at = normalize(transform_vector(turn, {n[0], n[1], n[2]}));
        normals.insert(normals.end(), {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)});
      }
      for (const auto& uv : f.mesh->uvs) uvs.insert(uvs.end(), {uv[0], uv[1]});
      attributes["POSITION"] = buffer_.floats(places, 3, gltf::Buffer::vertices, true);
      if (normals.size() == places.size())
        attributes["NORMAL"] = buffer_.floats(normals, 3, gltf::Buffer::vertices, false);
      if (!uvs.empty()) attributes["TEXCOORD_0"] = buffer_.floats(uvs, 2, gltf::Buffer::vertices, false);
      meshes_of_[{f.mesh.get(), f.local.m}] = attributes;
      kept_.push_back(f.mesh);  // no other mesh comes to lie where it was
    }
    Json primitives = Json::array();
    std::vector<MeshPart> parts = f.mesh->parts;
    if (parts.empty()) {
      parts.emplace_back();
      parts[0].count = static_cast<std::uint32_t>(f.mesh->triangles.size());
    }
    if (s.skin >= 0)
      add_rig(*f.mesh->rig, !program_.compiled().skins[static_cast<std::size_t>(s.skin)].joints.empty(), attributes,
              targets);
    for (const MeshPart& part : parts) {
      if (part.count == 0) continue;
      const auto first = f.mesh->triangles.begin() + part.first;
      const Result<std::size_t> look = material(s, part, name);
      if (!look) return look.error();
      primitives.push_back(
          {{"attributes", attributes}, {"indices", indices({first, first + part.count})}, {"material", *look}});
      if (!targets.empty()) primitives.back()["targets"] = targets;
    }
    if (primitives.empty()) {  // lines
      MeshPart line;
      const Result<std::size_t> look = material(s, line, name);
      if (!look) return look.error();
      Json only{{"POSITION", attributes["POSITION"]}};
      primitives.push_back(
          {{"attributes", only}, {"indices", indices(f.mesh->edges)}, {"material", *look}, {"mode", 1}});
    }
    // Meshes that are the same in all are one.
    const auto [same, fresh] = meshes_known_.try_emplace(primitives.dump(), meshes_.size());
    if (fresh)
      meshes_.push_back(
          {{"name", s.forms.size() > 1 ? fmt::format("{} {}", name, form + 1) : name}, {"primitives", primitives}});
    if (fresh && !targets.empty()) {
      Json names = Json::array();
      for (const Rig::Target& t : f.mesh->rig->targets) names.push_back(t.name);
      meshes_.back()["extras"] = {{"targetNames", names}};
    }
    return same->second;
  }
  std::size_t indices(std::vector<std::uint32_t> all) {
    const auto [known, fresh] = indices_.try_emplace(all, 0);
    if (fresh) known->second = buffer_.whole(all);
    return known->second;
  }

  Result<std::size_t> material(const Seen& s, const MeshPart& part, const std::string& name) {
    std::array<double, 4> tint{1, 1, 1, 1};
    for (std::size_t i = 0; i < 3; ++i) tint[i] = part.color[i];
    const bool tinted = part.tinted;
    const Channel color = colors(s, tint, tinted);
    const bool flat = document_flat();
    Json pbr{{"baseColorFactor", numbers(within_one(color.pieces.front().begin), 4)},
             {"metallicFactor", s.material == Material::metal ? 1 : 0},
             {"roughnessFactor",
              s.material == Material::matte ? 1 : static_cast<float>(1 - std::clamp(s.shininess, 0.0, 1.0))}};
    const auto& picture = s.texture ? s.texture : part.texture;
    if (picture) {
      const Result<std::size_t> texture = add_texture(picture);
      if (!texture) return texture.error();
      pbr["baseColorTexture"] = {{"index", *texture}};
    }
    Json m{{"pbrMetallicRoughness", pbr}, {"doubleSided", true}};
    const bool clear = std::any_of(color.pieces.begin(), color.pieces.end(),
                                   [](const KeyPiece& p) { return p.begin[3] < 1 || p.end[3] < 1; });
    if (clear || (picture && see_through(*picture))) m["alphaMode"] = "BLEND";
    if (s.material == Material::glow || flat) {
      m["extensions"] = {{"KHR_materials_unlit", Json::object()}};
      use("KHR_materials_unlit");
    }
    // One that varies is its object's own; all meshes of that share it.
    std::string key = m.dump();
    if (!color.constant()) key += fmt::format(" {} {} {} {}", s.id.index, tint[0], tint[1], tint[2]);
    const auto [known, fresh] = materials_known_.try_emplace(key, materials_.size());
    if (!fresh) return known->second;
    Json named{{"name", name}};
    named.update(m);
    materials_.push_back(named);
    if (!color.constant())
      point(fmt::format("/materials/{}/pbrMetallicRoughness/baseColorFactor", known->second), color);
    return known->second;
  }
  static std::array<double, 4> within_one(std::array<double, 4> v) {
    for (double& x : v) x = std::clamp(x, 0.0, 1.0);
    return v;
  }
  static bool see_through(const Picture& p) {
    for (std::size_t i = 3; i < p.rgba.size(); i += 4)
      if (p.rgba[i] != 255) return true;
    return false;
  }
  bool document_flat() {
    if (!flat_) flat_ = program_.frame(options_.from).surroundings.flat;
    return *flat_;
  }
  // Colour and opacity as one channel.
  Channel colors(const Seen& s, const std::array<double, 4>& tint, bool tinted) const {
    const auto at = [&](Time t) {
      std::array<double, 4> v{1, 1, 1, 1};
      if (tinted && !s.color.pieces.empty()) v = value_at(s.color, t);
      for (std::size_t i = 0; i < 3; ++i) v[i] *= tint[i];
      v[3] = s.opacity.pieces.empty() ? 1 : value_at(s.opacity, t)[0];
      return within_one(v);
    };
    if ((!tinted || s.color.pieces.empty() || s.color.constant()) && (s.opacity.pieces.empty() || s.opacity.constant()))
      return held(at(options_.from), 4, options_.from, options_.until);
    return follow(followed(document_, 4, options_.keys.radians, at),
                  knots({&s.color, &s.opacity}, options_.from, options_.until), options_.keys);
  }

  Result<std::size_t> add_texture(const std::shared_ptr<const Picture>& picture) {
    const auto [known, fresh] = textures_known_.try_emplace(picture.get(), textures_.size());
    if (!fresh) return known->second;
    const Result<std::string> png = to_png(*picture);
    if (!png) return png.error();
    images_.push_back({{"bufferView", buffer_.picture(*png)}, {"mimeType", "image/png"}});
    textures_.push_back({{"sampler", 0}, {"source", images_.size() - 1}});
    pictures_.push_back(picture);
    return known->second;
  }

  // ---- lights and cameras

  void lights() {
    std::unordered_map<std::uint32_t, Light> all;
    for (double share : {0.0, 0.5, 1.0})
      for (const Light& l :
           program_
               .frame({options_.from.flicks +
                       static_cast<std::int64_t>(share * static_cast<double>((options_.until - options_.from).flicks))})
               .lights)
        if (l.id) all.try_emplace(l.id.index, l);
    for (const auto& [index, l] : std::map(all.begin(), all.end())) {
      if (!inner_of_.contains(index) || !asked({index})) continue;
      const Target intensity{{index}, fn::intensity}, color{{index}, fn::color};
      Channel power = value_keys(program_, intensity, options_.from, options_.until, options_.keys);
      const Channel tint = value_keys(program_, color, options_.from, options_.until, options_.keys);
      // Full light is pi lux; of a lamp a twentieth of that is left where its reach ends, as scenes are read.
      const double unit = l.sun ? pi : pi * l.range * l.range / 20;
      for (KeyPiece& p : power.pieces)
        for (auto* v : {&p.begin, &p.end, &p.leaving, &p.arriving}) (*v)[0] *= unit;
      Json light{{"type", l.sun ? "directional" : "point"},
                 {"color", numbers(within_one(tint.pieces.front().begin), 3)},
                 {"intensity", static_cast<float>(power.pieces.front().begin[0])}};
      if (!l.sun && l.range > 0) light["range"] = static_cast<float>(l.range);
      const std::size_t number = lights_.size();
      lights_.push_back(light);
      use("KHR_lights_punctual");
      std::size_t node = inner_of_[index];
      if (l.sun) node = sun(l.id);
      nodes_[node]["extensions"] = {{"KHR_lights_punctual", {{"light", number}}}};
      if (!power.constant()) point(fmt::format("/extensions/KHR_lights_punctual/lights/{}/intensity", number), power);
      if (!tint.constant()) point(fmt::format("/extensions/KHR_lights_punctual/lights/{}/color", number), tint);
    }
  }
  // A sun shines to the middle of the world, whichever way it is turned.
  std::size_t sun(ObjectId id) {
    const std::size_t node = add_node({{"name", document_.name(id) + " rays"}});
    roots_.push_back(node);
    Followed f = followed(document_, 4, options_.keys.radians, [&](Time t) -> KeyValue {
      const Vec3 from = translation_of(pose(program_, id, t).world);
      const Quat q = from_matrix(look_at({}, normalize(-from, {0, -1, 0})));
      return {q.x, q.y, q.z, q.w};
    });
    f.turn = true;
    const auto knots = knots_between(program_.breaks(options_.from, options_.until), options_.from, options_.until);
    put(node, "rotation", follow(f, knots, options_.keys), {0, 0, 0, 1});
    return node;
  }

  void cameras() {
    const Evaluation first = [&] {
      Evaluation e(program_);
      e.to(options_.from);
      return e;
    }();
    const double aspect = document_.aspect();
    bool any = false;
    for (const ObjectId id : objects(document_)) {
      if (kind(document_, id) != Kind::camera || !inner_of_.contains(id.index) || !asked(id)) continue;
      const auto number = [&](FunctionId f) { return betwixt::numbers(program_.read({id, f}, options_.from))[0]; };
      any = true;
      if (const double height = number(fn::camera_height); height > 0) {
        add_camera(inner_of_[id.index], document_.name(id), orthographic(height, aspect));
        continue;
      }
      const auto view = [&](Time t) {
        const double fov = betwixt::numbers(program_.read({id, fn::fov}, t))[0];
        const double lens = betwixt::numbers(program_.read({id, fn::lens}, t))[0];
        const double wide = fov > 0 ? std::min(fov, 3.1) : 2 * std::atan(18 / std::max(lens, 0.1));
        return 2 * std::atan(std::tan(wide / 2) / aspect);
      };
      const std::size_t number_of =
          add_camera(inner_of_[id.index], document_.name(id), perspective(view(options_.from), aspect));
      Channel lens = value_keys(program_, {id, fn::lens}, options_.from, options_.until, options_.keys);
      Channel fov = value_keys(program_, {id, fn::fov}, options_.from, options_.until, options_.keys);
      if (lens.constant() && fov.constant()) continue;
      const Followed f = followed(document_, 1, options_.keys.radians, [&](Time t) -> KeyValue { return {view(t)}; });
      point(fmt::format("/cameras/{}/perspective/yfov", number_of),
            follow(f, knots({&lens, &fov}, options_.from, options_.until), options_.keys));
    }
    if (!any && options_.objects.empty()) {
      const Camera& c = first.camera();
      const std::size_t node = add_node({{"name", "camera"}});
      roots_.push_back(node);
      const Quat q = from_matrix(c.world);
      const Vec3 at = translation_of(c.world);
      nodes_[node]["translation"] = numbers({at.x, at.y, at.z}, 3);
      nodes_[node]["rotation"] = numbers({q.x, q.y, q.z, q.w}, 4);
      add_camera(node, "camera",
                 c.orthographic ? orthographic(c.height, aspect)
                                : perspective(2 * std::atan(std::tan(c.fov / 2) / aspect), aspect));
    }
    if (document_.cuts().size() > 1)
      leave_out(made_, "cuts from camera to camera: they are in the scene's extras only");
  }
  static Json perspective(double yfov, double aspect) {
    return {{"type", "perspective"},
            {"perspective",
             {{"yfov", static_cast<float>(yfov)},
              {"aspectRatio", static_cast<float>(aspect)},
              {"znear", 0.01},
              {"zfar", 10000}}}};
  }
  static Json orthographic(double height, double aspect) {
    return {{"type", "orthographic"},
            {"orthographic",
             {{"xmag", static_cast<float>(height / 2 * aspect)},
              {"ymag", static_cast<float>(height / 2)},
              {"znear", 0.01},
              {"zfar", 10000}}}};
  }
  std::size_t add_camera(std::size_t node, const std::string& name, Json camera) {
    camera["name"] = name;
    cameras_.push_back(std::move(camera));
    nodes_[node]["camera"] = cameras_.size() - 1;
    return cameras_.size() - 1;
  }

  // ---- the file

  void finish() {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!children_[i].empty()) nodes_[i]["children"] = children_[i];
    Json cuts = Json::array();
    for (const auto& [t, id] : document_.cuts())
      cuts.push_back({{"at", (t - options_.from).seconds()}, {"camera", document_.name(id)}});
    Json scene{{"nodes", roots_},
               {"extras",
                {{"rate", document_.rate().per_second()},
                 {"first_frame", document_.rate().frame_number(options_.from)},
                 {"frames", frames_}}}};
    if (!cuts.empty()) scene["extras"]["cuts"] = cuts;
    if (roots_.empty()) scene.erase("nodes");
    file_ = {{"asset", {{"version", "2.0"}, {"generator", "Betwixt"}}}, {"scene", 0}, {"scenes", Json::array({scene})}};
    const auto add = [&](const char* name, const Json& all) {
      if (!all.empty()) file_[name] = all;
    };
    add("extensionsUsed", used_);
    add("nodes", nodes_), add("meshes", meshes_), add("materials", materials_), add("textures", textures_),
        add("images", images_);
    if (!textures_.empty()) file_["samplers"] = Json::array({{{"wrapS", 10497}, {"wrapT", 10497}}});
    add("skins", skins_), add("cameras", cameras_);
    if (!lights_.empty()) file_["extensions"] = {{"KHR_lights_punctual", {{"lights", lights_}}}};
    if (!channels_.empty())
      file_["animations"] = Json::array({{{"name", "film"}, {"channels", channels_}, {"samplers", samplers_}}});
    add("accessors", buffer_.accessors), add("bufferViews", buffer_.views);
    if (!buffer_.bytes.empty()) file_["buffers"] = Json::array({{{"byteLength", buffer_.bytes.size()}}});
  }

  const Program& program_;
  const Document& document_;
  ExportOptions options_;
  Exported& made_;
  std::size_t frames_ = 1;
  std::optional<bool> flat_;

  gltf::Buffer buffer_;
  Json file_, nodes_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array(), textures_ = Json::array(),
              images_ = Json::array(), skins_ = Json::array(), cameras_ = Json::array(), lights_ = Json::array(),
              channels_ = Json::array(), samplers_ = Json::array();
  std::vector<std::string> used_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<std::size_t> roots_, parent_;                            // parents of objects' nodes; their number: none
  std::unordered_map<std::uint32_t, std::size_t> node_of_, inner_of_;  // by object: its node, and what hangs on it
  std::map<std::pair<const Mesh*, std::array<double, 16>>, Json> meshes_of_;
  std::map<std::vector<std::uint32_t>, std::size_t> indices_;
  std::unordered_map<std::string, std::size_t> meshes_known_, materials_known_;
  std::unordered_map<const Picture*, std::size_t> textures_known_;
  std::vector<std::shared_ptr<const Mesh>> kept_;
  std::vector<std::shared_ptr<const Picture>> pictures_;
};

void put_word(std::string& to, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) to += static_cast<char>(word >> 8 * i & 255);
}

std::string base64(std::string_view bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

}  // namespace

Result<std::string> make_glb(const Program& program, const ExportOptions& options, Exported& made) {
  Maker maker(program, options, made);
  if (Status s = maker.make(); !s) return s.error();
  std::string text = maker.json().dump(-1, ' ', false, Json::error_handler_t::replace), bytes = maker.bytes();
  while (text.size() % 4 != 0) text += ' ';
  while (bytes.size() % 4 != 0) bytes += '\0';
  std::string out = "glTF";
  put_word(out, 2),
      put_word(out, static_cast<std::uint32_t>(12 + 8 + text.size() + (bytes.empty() ? 0 : 8 + bytes.size())));
  put_word(out, static_cast<std::uint32_t>(text.size()));
  out += "JSON" + text;
  if (bytes.empty()) return out;
  put_word(out, static_cast<std::uint32_t>(bytes.size()));
  out += std::string("BIN\0", 4) + bytes;
  return out;
}

Result<std::string> make_gltf(const Program& program, const ExportOptions& options, Exported& made) {
  Maker maker(program, options, made);
  if (Status s = maker.make(); !s) return s.error();
  if (!maker.bytes().empty())
    maker.json()["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(maker.bytes());
  return maker.json().dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace betwixt
