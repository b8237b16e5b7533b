// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A film as text of USD. Time samples go straight, turns by the shortest arc; a jump takes a millionth of a frame.
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
#include "scene/functions.h"

namespace betwixt {
namespace {

class UsdMaker {
 public:
  UsdMaker(const Program& program, ExportOptions options, Exported& made)
      : program_(program),
        document_(program.document()),
        options_(std::move(options)),
        made_(made),
        rate_(document_.rate().per_second()) {
    if (options_.keys.style == KeyStyle::cubic) options_.keys.style = KeyStyle::linear;
    options_.keys.in_floats = false;
  }

  Result<std::string> make() {
    Result<std::vector<Seen>> seen = all_seen(program_, options_, made_);
    if (!seen) return seen.error();
    for (Seen& s : *seen)
      if (is_asked(s.id, options_.objects)) seen_[s.id.index] = &s;
    keys_ = motion_keys(program_, options_.from, options_.until, options_.keys);
    keep_asked(keys_, options_.objects);
    made_.objects = keys_.size();
    std::set<std::uint32_t> known;
    for (const ObjectKeys& k : keys_) known.insert(k.id.index);
    for (const ObjectKeys& k : keys_)
      below_[k.parent && known.contains(k.parent.index) ? k.parent.index : ObjectId::nothing].push_back(&k);
    const double last = (options_.until - options_.from).seconds() * rate_;
    out_ = fmt::format(
        "#usda 1.0\n(\n    defaultPrim = \"film\"\n    doc = \"Made by Betwixt\"\n    metersPerUnit = 1\n    upAxis = "
        "\"Y\"\n"
        "    timeCodesPerSecond = {0}\n    framesPerSecond = {0}\n    startTimeCode = 0\n    endTimeCode = {1}\n)\n\n"
        "def Xform \"film\"\n{{\n",
        number(rate_), number(last));
    add_below(ObjectId::nothing, 1, "/film");
    add_own_camera();
    out_ += "}\n";
    return std::move(out_);
  }

 private:
  static std::string number(double v) {
    const std::string s = fmt::format("{:.9g}", v);
    return s == "-0" ? "0" : s;
  }
  // Without an exponent, for readers that know none there.
  static std::string moment(double frames) {
    std::string s = fmt::format("{:.9f}", frames);
    s.erase(s.find_last_not_of('0') + 1);
    if (s.back() == '.') s.pop_back();
    return s;
  }
  static std::string row(const KeyValue& v, std::size_t width) {
    if (width == 1) return number(v[0]);
    std::string all;
    for (std::size_t i = 0; i < width; ++i) all += (i ? ", " : "") + number(v[i]);
    return "(" + all + ")";
  }
  // USD has the real part first.
  static std::string turn(const KeyValue& q, std::size_t) { return row({q[3], q[0], q[1], q[2]}, 4); }

  void line(int depth, std::string_view text) {
    out_.append(static_cast<std::size_t>(4 * depth), ' ');
    out_ += text;
    out_ += '\n';
  }

  // Of an attribute: its value, or its samples.
  void attribute(int depth, const std::string& name, const Channel& c,
                 std::string (*written)(const KeyValue&, std::size_t) = row) {
    if (c.constant()) return line(depth, fmt::format("{} = {}", name, written(c.pieces[0].begin, c.width)));
    constexpr double apart = 1e-6;  // frames
    std::map<double, std::string> samples;
    const auto at = [&](Time t) { return (t - options_.from).seconds() * rate_; };
    KeyValue last{};
    for (std::size_t i = 0; i < c.pieces.size(); ++i) {
      const KeyPiece& p = c.pieces[i];
      const bool jumps = i + 1 < c.pieces.size() && c.jumps_behind(i);
      KeyValue begin = p.begin, end = p.end;
      for (KeyValue* v : {&begin, &end}) {  // of both signs of a turn the one that is near
        const double cosine = (*v)[0] * last[0] + (*v)[1] * last[1] + (*v)[2] * last[2] + (*v)[3] * last[3];
        if (c.turn && cosine < 0)
          for (double& n : *v) n = -n;
        last = *v;
      }
      samples[at(p.from)] = written(begin, c.width);
      samples[at(p.until) - (jumps ? apart : 0)] = written(end, c.width);
    }
    line(depth, name + ".timeSamples = {");
    for (const auto& [t, v] : samples) line(depth + 1, fmt::format("{}: {},", moment(t), v));
    line(depth, "}");
    ++made_.channels;
    made_.keys += samples.size();
    made_.baked += static_cast<std::size_t>(std::max(1.0, at(options_.until) + 1));
  }

  // Letters, digits and '_'. No two are the same in the whole file, as some readers look for names only.
  std::string plain(std::string_view name) {
    std::string out(name.substr(name.rfind('/') + 1));
    for (char& c : out)
      if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    std::string one = out;
    for (int n = 2; !taken_.insert(one).second; ++n) one = fmt::format("{}_{}", out, n);
    return one;
  }

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

  // ---- What is seen

  void draw(int depth, const Seen& s, const std::string& path) {
    for (std::size_t form = 0; form < s.forms.size(); ++form) {
      const Mesh& mesh = *s.forms[form].mesh;
      if (mesh.triangles.empty()) {
        leave_out(made_, fmt::format("{} is a line without a width, which is not written", document_.name(s.id)));
        continue;
      }
      const std::string name = plain(path.substr(path.rfind('/') + 1) + "_shape");
      line(depth, fmt::format("def Mesh \"{}\"", name));
      line(depth, "{");
      visibility(depth + 1, s, static_cast<int>(form));
      geometry(depth + 1, mesh);
      attribute(depth + 1, "color3f[] primvars:displayColor", s.color,
                [](const KeyValue& v, std::size_t) { return "[" + row(v, 3) + "]"; });
      if (!s.opacity.constant() || s.opacity.pieces[0].begin[0] < 1)
        attribute(depth + 1, "float[] primvars:displayOpacity", s.opacity,
                  [](const KeyValue& v, std::size_t) { return "[" + number(v[0]) + "]"; });
      const Mat4& local = s.forms[form].local;
      if (!s.stretch.pieces.empty())
        attribute(depth + 1, "float3 xformOp:scale", s.stretch);
      else
        line(depth + 1, "float3 xformOp:scale = " + row({local(0, 0), local(1, 1), local(2, 2), 0}, 3));
      line(depth + 1, "uniform token[] xformOpOrder = [\"xformOp:scale\"]");
      material(depth + 1, s, path + "/" + name);
      line(depth, "}");
    }
    if (s.texture) leave_out(made_, "pictures on things (textures)");
  }

  void visibility(int depth, const Seen& s, int form) {
    if (s.when.size() == 1 && s.when[0].form == form) return;
    line(depth, "token visibility.timeSamples = {");
    for (const Seen::From& w : s.when)
      line(depth + 1, fmt::format("{}: \"{}\",", moment((w.time - options_.from).seconds() * rate_),
                                  w.form == form ? "inherited" : "invisible"));
    line(depth, "}");
  }

  void geometry(int depth, const Mesh& mesh) {
    const auto list = [&](const char* name, std::size_t count, auto&& one) {
      std::string all = fmt::format("{} = [", name);
      for (std::size_t i = 0; i < count; ++i) all += (i ? ", " : "") + one(i);
      line(depth, all + "]");
    };
    const auto three = [](const std::array<float, 3>& p) { return row({p[0], p[1], p[2], 0}, 3); };
    line(depth, "uniform token subdivisionScheme = \"none\"");
    line(depth, "uniform bool doubleSided = 1");
    list("int[] faceVertexCounts", mesh.triangles.size() / 3, [](std::size_t) { return std::string("3"); });
    list("int[] faceVertexIndices", mesh.triangles.size(),
         [&](std::size_t i) { return fmt::format("{}", mesh.triangles[i]); });
    list("point3f[] points", mesh.positions.size(), [&](std::size_t i) { return three(mesh.positions[i]); });
    if (mesh.normals.size() != mesh.positions.size()) return;
    list("normal3f[] normals", mesh.normals.size(), [&](std::size_t i) { return three(mesh.normals[i]); });
    line(depth, "uniform token normals:interpolation = \"vertex\"");
  }

  // In the same place as the mesh, so that nothing has to be found.
  void material(int depth, const Seen& s, const std::string& path) {
    const KeyValue& color = s.color.pieces[0].begin;
    line(depth, fmt::format("rel material:binding = <{}/look>", path));
    line(depth, "def Material \"look\"");
    line(depth, "{");
    line(depth + 1, fmt::format("token outputs:surface.connect = <{}/look/surface.outputs:surface>", path));
    line(depth + 1, "def Shader \"surface\"");
    line(depth + 1, "{");
    line(depth + 2, "uniform token info:id = \"UsdPreviewSurface\"");
    line(depth + 2, "color3f inputs:diffuseColor = " + row(s.material == Material::glow ? KeyValue{} : color, 3));
    if (s.material == Material::glow) line(depth + 2, "color3f inputs:emissiveColor = " + row(color, 3));
    line(depth + 2, fmt::format("float inputs:metallic = {}", s.material == Material::metal ? 1 : 0));
    line(depth + 2, "float inputs:roughness = " + number(s.material == Material::matte ? 1 : 1 - s.shininess));
    line(depth + 2, "float inputs:opacity = " + number(s.opacity.pieces[0].begin[0]));
    line(depth + 2, "token outputs:surface");
    line(depth + 1, "}");
    line(depth, "}");
  }

  // ---- Cameras and lights

  double number_of(ObjectId id, FunctionId f) const {
    const std::vector<double> n = numbers(program_.read({id, f}, options_.from));
    return n.empty() ? 0 : n[0];
  }
  // In tenths of a unit, as USD has them.
  void lens(int depth, bool orthographic, double wide) {
    const double gate = orthographic ? 10 * wide : 36;
    line(depth, "def Camera \"camera\"");
    line(depth, "{");
    line(depth + 1, fmt::format("token projection = \"{}\"", orthographic ? "orthographic" : "perspective"));
    line(depth + 1, "float horizontalAperture = " + number(gate));
    line(depth + 1, "float verticalAperture = " + number(gate / document_.aspect()));
    if (!orthographic) line(depth + 1, "float focalLength = " + number(18 / std::tan(wide / 2)));
    line(depth + 1, "float2 clippingRange = (0.01, 1000000)");
    line(depth, "}");
  }
  void camera(int depth, ObjectId id) {
    has_camera_ = true;
    if (const double height = number_of(id, fn::camera_height); height > 0)
      return lens(depth, true, height * document_.aspect());
    const double fov = number_of(id, fn::fov), length = number_of(id, fn::lens);
    lens(depth, false, fov > 0 ? std::min(fov, 3.1) : 2 * std::atan(18 / std::max(length, 0.1)));
    for (const FunctionId f : {fn::fov, fn::lens})
      if (!value_keys(program_, {id, f}, options_.from, options_.until, options_.keys).constant())
        leave_out(made_, fmt::format("the lens of {} stays as it is at the beginning", document_.name(id)));
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
    if (found->sun) return leave_out(made_, fmt::format("{} is a sun, and is left out", document_.name(id)));
    line(depth, "def SphereLight \"light\"");
    line(depth, "{");
    line(depth + 1, "float inputs:radius = 0.1");
    line(depth + 1, "color3f inputs:color = " + row({found->color.x, found->color.y, found->color.z, 0}, 3));
    line(depth + 1, "float inputs:intensity = " + number(found->range * found->range));
    line(depth, "}");
  }

  const Program& program_;
  const Document& document_;
  ExportOptions options_;
  Exported& made_;
  const double rate_;
  std::string out_;
  std::vector<ObjectKeys> keys_;
  std::unordered_map<std::uint32_t, Seen*> seen_;
  std::unordered_map<std::uint32_t, std::vector<const ObjectKeys*>> below_;
  std::set<std::string> taken_{"film", "camera", "light", "look", "surface", "view"};
  bool has_camera_ = false;
};

}  // namespace

Result<std::string> make_usda(const Program& program, const ExportOptions& options, Exported& made) {
  return UsdMaker(program, options, made).make();
}

}  // namespace betwixt
