// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A film as glTF 2.0. Objects are nodes below their parents, their motion is keys, changes of look are animated by
// KHR_animation_pointer, and shapes that change are meshes of which one at a time has a size.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/base64.h"
#include "export/fit.h"
#include "export/formats.h"
#include "export/gltf_surfaces.h"
#include "export/gltf_views.h"
#include "export/seen.h"
#include "program/compiled.h"

namespace betwixt {
namespace {

class Maker {
 public:
  Maker(const Program& program, ExportOptions options, Exported& made)
      : program_(program),
        document_(program.document()),
        options_(std::move(options)),
        made_(made),
        film_{options_.from, 1, options_.keys.style != KeyStyle::linear, made, {}},
        surfaces_(program, options_, film_),
        nodes_(film_),
        views_(program, options_, film_, nodes_) {
    options_.keys.in_floats = true;
    film_.frames = static_cast<std::size_t>(std::max(
        1.0, document_.rate().frame_number(options_.until) - document_.rate().frame_number(options_.from) + 1));
  }

  Status make() {
    made_.objects = nodes_.place_objects(program_, options_);
    if (options_.keys.go_on && !options_.keys.go_on(1)) return fail(ErrorCode::machine, "stopped");
    Result<std::vector<Seen>> seen =
        all_seen(program_, options_, made_, [&](const Skin& skin) { return one_tree(skin); });
    if (!seen) return seen.error();
    for (const Seen& s : *seen)
      if (Status ok = draw(s); !ok) return ok;
    views_.add_lights();
    views_.add_cameras();
    finish();
    return Nothing{};
  }

  const Json& json() const { return file_; }
  Json& json() { return file_; }
  const std::string& bytes() const { return film_.buffer.bytes; }

 private:
  // ---- skins

  std::size_t joint(const Skin& skin, std::size_t i) const {
    const std::int32_t node = skin.joints[i];
    const std::uint32_t object =
        program_.compiled().nodes[node < 0 ? skin.drawable : static_cast<std::uint32_t>(node)].object;
    return nodes_.of({object});
  }
  // Returns whether all joints have a common root, as glTF requires.
  bool one_tree(const Skin& skin) const {
    for (const std::int32_t joint : skin.joints)
      if (joint >= 0 && !nodes_.has({program_.compiled().nodes[static_cast<std::uint32_t>(joint)].object}))
        return false;
    std::optional<std::size_t> root;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const std::size_t top = nodes_.root_above(joint(skin, i));
      if (root.value_or(top) != top) return false;
      root = top;
    }
    return true;
  }
  // A node with a skin has no effect itself, so it is at the root of the scene. Returns its number.
  std::size_t add_skin(const Seen& s, const std::string& name) {
    const Skin& skin = program_.compiled().skins[static_cast<std::size_t>(s.skin)];
    if (skin.joints.empty()) return nodes_.of(s.id);
    std::vector<float> inverse_bind;
    Json joints = Json::array();
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const Mat4 m = skin.joints[i] < 0 ? Mat4{} : s.forms[0].mesh->rig->inverse_bind[i];
      for (const double x : m.m) inverse_bind.push_back(static_cast<float>(x));
      joints.push_back(joint(skin, i));
    }
    const std::size_t node = nodes_.add_root({{"name", name + " skin"}});
    nodes_[node]["skin"] = skins_.size();
    skins_.push_back({{"name", name},
                      {"joints", joints},
                      {"inverseBindMatrices", film_.buffer.floats(inverse_bind, 16, gltf::Buffer::plain, false)}});
    if (s.when.size() > 1)
      leave_out(made_, fmt::format("{} is hidden at times, but with joints it is always visible", name));
    return node;
  }
  // All weights of a mesh have keys at the same times, so each is evaluated at the times of all.
  void add_weights(const Seen& s, std::size_t node) {
    const Skin& skin = program_.compiled().skins[static_cast<std::size_t>(s.skin)];
    const auto& targets = s.forms[0].mesh->rig->targets;
    KeyOptions straight = options_.keys;
    straight.style = straight.style == KeyStyle::baked ? KeyStyle::baked : KeyStyle::linear;
    std::vector<Channel> all;
    std::set<Time> times;
    bool still = true;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      all.push_back({1, false, {{KeyPiece::held, options_.from, options_.until, {}, {}, {}, {}}}});
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
    film_.animate(keys, 1, {{"node", node}, {"path", "weights"}});
  }

  // ---- objects

  Status draw(const Seen& s) {
    if (s.forms.empty() || !nodes_.has(s.id) || !is_asked(s.id, options_.objects)) return Nothing{};
    const std::string name = document_.name(s.id);
    const bool always = s.when.size() == 1 && s.when[0].form == 0;
    const bool stretched = !s.stretch.pieces.empty();
    for (std::size_t form = 0; form < s.forms.size(); ++form) {
      const Result<std::size_t> mesh = surfaces_.add_mesh(s, form, name);
      if (!mesh) return mesh.error();
      std::size_t node = s.skin >= 0 ? add_skin(s, name) : nodes_.of(s.id);
      if (s.skin >= 0) add_weights(s, node);
      if (s.skin < 0 && (!always || stretched)) {
        node = nodes_.add_below(
            node, {{"name", s.forms.size() > 1 ? fmt::format("{} shape {}", name, form + 1) : name + " shape"}});
        nodes_.put(node, "scale", always ? s.stretch : sizes(s, static_cast<int>(form)), {1, 1, 1});
      }
      nodes_[node]["mesh"] = *mesh;
    }
    return Nothing{};
  }

  // Returns the scale of a form: zero while it is not visible.
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
      for (const KeyPiece& p : follow(f, gltf::keys_of({&s.stretch}, from, until), options_.keys).pieces)
        c.pieces.push_back(p);
    }
    return with_leaps(c);
  }
  // Inserts leaps where joined pieces jump.
  Channel with_leaps(const Channel& c) const {
    const Time step{std::max<std::int64_t>(document_.rate().span(0.5).flicks, 1)};
    Channel out{c.width, c.turn, {}};
    for (KeyPiece p : c.pieces) {
      if (!out.pieces.empty() && out.pieces.back().end != p.begin) {
        KeyPiece& last = out.pieces.back();
        auto [before, after] = around_jump(p.from, options_.from, step, options_.keys);
        before = std::max(before, last.from), after = std::max(after, before);
        last.until = before, p.from = after;
        out.pieces.push_back({KeyPiece::leap, before, after, last.end, p.begin, {}, {}});
      }
      out.pieces.push_back(p);
    }
    return out;
  }

  // ---- the file

  // assimp takes a channel without a node for the translation of the node that it read first, and refuses files where
  // it does not fit. The last channel of a node counts there: so these come first, and that translation is said behind
  // them.
  void put_pointers_first() {
    const auto points = [](const Json& channel) { return channel["target"]["path"] == "pointer"; };
    auto& all = film_.channels.get_ref<Json::array_t&>();
    const auto rest = std::stable_partition(all.begin(), all.end(), points);
    if (rest == all.begin()) return;
    const std::size_t first = nodes_.first_read();
    const Json target{{"node", first}, {"path", "translation"}};
    if (std::any_of(rest, all.end(), [&](const Json& c) { return c["target"] == target; })) return;
    const auto place = nodes_[first].value("translation", std::vector<float>{0, 0, 0});
    film_.animate({"LINEAR", {0}, place}, 3, target);
  }

  void finish() {
    put_pointers_first();
    Json cuts = Json::array();
    for (const auto& [t, id] : document_.cuts())
      cuts.push_back({{"at", (t - options_.from).seconds()}, {"camera", document_.name(id)}});
    Json scene{{"nodes", nodes_.roots()},
               {"extras",
                {{"rate", document_.rate().per_second()},
                 {"first_frame", document_.rate().frame_number(options_.from)},
                 {"frames", film_.frames}}}};
    if (!cuts.empty()) scene["extras"]["cuts"] = cuts;
    if (nodes_.roots().empty()) scene.erase("nodes");
    file_ = {{"asset", {{"version", "2.0"}, {"generator", "Betwixt"}}}, {"scene", 0}, {"scenes", Json::array({scene})}};
    const auto add = [&](const char* name, const Json& all) {
      if (!all.empty()) file_[name] = all;
    };
    add("extensionsUsed", film_.used);
    add("nodes", nodes_.all()), add("meshes", surfaces_.meshes), add("materials", surfaces_.materials);
    add("textures", surfaces_.textures), add("images", surfaces_.images);
    if (!surfaces_.textures.empty()) file_["samplers"] = Json::array({{{"wrapS", 10497}, {"wrapT", 10497}}});
    add("skins", skins_), add("cameras", views_.cameras);
    if (!views_.lights.empty()) file_["extensions"] = {{"KHR_lights_punctual", {{"lights", views_.lights}}}};
    if (!film_.channels.empty())
      file_["animations"] =
          Json::array({{{"name", "film"}, {"channels", film_.channels}, {"samplers", film_.samplers}}});
    add("accessors", film_.buffer.accessors), add("bufferViews", film_.buffer.views);
    if (!film_.buffer.bytes.empty()) file_["buffers"] = Json::array({{{"byteLength", film_.buffer.bytes.size()}}});
  }

  const Program& program_;
  const Document& document_;
  ExportOptions options_;
  Exported& made_;
  gltf::Timeline film_;
  gltf::Surfaces surfaces_;
  gltf::Nodes nodes_;
  gltf::Views views_;

  Json file_, skins_ = Json::array();
};

void put_word(std::string& to, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) to += static_cast<char>(word >> 8 * i & 255);
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
