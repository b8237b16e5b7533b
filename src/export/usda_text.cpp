// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/usda_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace betwixt {

std::string UsdText::number(double v) {
  const std::string s = fmt::format("{:.9g}", v);
  return s == "-0" ? "0" : s;
}

std::string UsdText::moment(double frames) {
  std::string s = fmt::format("{:.9f}", frames);
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s;
}

std::string UsdText::row(const KeyValue& v, std::size_t width) {
  if (width == 1) return number(v[0]);
  std::string all;
  for (std::size_t i = 0; i < width; ++i) all += (i ? ", " : "") + number(v[i]);
  return "(" + all + ")";
}

std::string UsdText::turn(const KeyValue& q, std::size_t) { return row({q[3], q[0], q[1], q[2]}, 4); }

void UsdText::line(int depth, std::string_view text) {
  out_.append(static_cast<std::size_t>(4 * depth), ' ');
  out_ += text;
  out_ += '\n';
}

void UsdText::attribute(int depth, const std::string& name, const Channel& c, Written written) {
  if (c.constant()) return line(depth, fmt::format("{} = {}", name, written(c.pieces[0].begin, c.width)));
  constexpr double apart = 1e-6;  // frames
  std::map<double, std::string> samples;
  const auto at = [&](Time t) { return (t - options_.from).seconds() * rate_; };
  KeyValue last{};
  for (std::size_t i = 0; i < c.pieces.size(); ++i) {
    const KeyPiece& p = c.pieces[i];
    const bool jumps = i + 1 < c.pieces.size() && c.jumps_behind(i);
    KeyValue begin = p.begin, end = p.end;
    for (KeyValue* v : {&begin, &end}) {  // of the two signs of a rotation, take the nearer one
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

std::string UsdText::letters(std::string_view name) {
  std::string out(name.substr(name.rfind('/') + 1));
  for (char& c : out)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return out;
}

std::string UsdText::plain(std::string_view name) {
  const std::string out = letters(name);
  std::string one = out;
  for (int n = 2; !taken_.insert(one).second; ++n) one = fmt::format("{}_{}", out, n);
  return one;
}

std::string UsdText::matrix(const Mat4& m) {  // USD multiplies rows from the left: our columns
  std::string all;
  for (int c = 0; c < 4; ++c) all += (c ? ", " : "") + row({m(0, c), m(1, c), m(2, c), m(3, c)}, 4);
  return "(" + all + ")";
}

void UsdText::together(int depth, const std::string& name, const std::vector<const ObjectKeys*>& joints,
                       Channel ObjectKeys::*channel, Written written) {
  std::set<Time> times{options_.from};
  const Time apart{std::max<std::int64_t>(document_.rate().span(1e-6).flicks, 1)};
  bool still = true;
  for (const ObjectKeys* k : joints) {
    const Channel& c = k->*channel;
    still = still && c.constant();
    for (std::size_t i = 0; i < c.pieces.size(); ++i) {
      times.insert(c.pieces[i].from);
      times.insert(c.jumps_behind(i) ? c.pieces[i].until - apart : c.pieces[i].until);
    }
  }
  std::vector<KeyValue> last(joints.size());
  const auto at = [&](Time t) {
    return [&, t](std::size_t i) {
      const Channel& c = joints[i]->*channel;
      KeyValue v = value_at(c, t);
      const KeyValue& l = last[i];
      if (c.turn && v[0] * l[0] + v[1] * l[1] + v[2] * l[2] + v[3] * l[3] < 0)
        for (double& n : v) n = -n;
      return written(last[i] = v, c.width);
    };
  };
  if (still) return list(depth, name + " =", joints.size(), at(options_.from));
  line(depth, name + ".timeSamples = {");
  for (const Time t : times)
    list(depth + 1, moment((t - options_.from).seconds() * rate_) + ":", joints.size(), at(t), ",");
  line(depth, "}");
  ++made_.channels;
  made_.keys += times.size();
  made_.baked += static_cast<std::size_t>((options_.until - options_.from).seconds() * rate_) + 1;
}

void UsdText::visibility(int depth, const Seen& s, int form) {
  if (s.when.size() == 1 && s.when[0].form == form) return;
  line(depth, "token visibility.timeSamples = {");
  for (const Seen::From& w : s.when)
    line(depth + 1, fmt::format("{}: \"{}\",", moment((w.time - options_.from).seconds() * rate_),
                                w.form == form ? "inherited" : "invisible"));
  line(depth, "}");
}

std::string UsdText::shortest(float f) { return f == 0 ? "0" : fmt::format("{}", f); }

void UsdText::geometry(int depth, const Mesh& mesh) {
  const auto three = [](const std::array<float, 3>& p) {
    return fmt::format("({}, {}, {})", shortest(p[0]), shortest(p[1]), shortest(p[2]));
  };
  const Box box = mesh.box();
  const auto corner = [&](const Vec3& v) { return row({v.x, v.y, v.z, 0}, 3); };
  line(depth, "uniform token subdivisionScheme = \"none\"");
  line(depth, "uniform bool doubleSided = 1");
  line(depth, fmt::format("float3[] extent = [{}, {}]", corner(box.low), corner(box.high)));
  list(depth, "int[] faceVertexCounts =", mesh.triangles.size() / 3, [](std::size_t) { return "3"; });
  list(depth, "int[] faceVertexIndices =", mesh.triangles.size(),
       [&](std::size_t i) { return fmt::format("{}", mesh.triangles[i]); });
  list(depth, "point3f[] points =", mesh.positions.size(), [&](std::size_t i) { return three(mesh.positions[i]); });
  if (mesh.normals.size() == mesh.positions.size())
    list(
        depth, "normal3f[] normals =", mesh.normals.size(), [&](std::size_t i) { return three(mesh.normals[i]); },
        " (interpolation = \"vertex\")");
}

void UsdText::lens(int depth, bool orthographic, double wide) {
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

std::vector<std::pair<std::string_view, double>> finish_inputs(const Finish& f) {
  return {{"metallic", f.metalness},
          {"roughness", f.roughness},
          {"clearcoat", f.clearcoat},
          {"clearcoatRoughness", f.clearcoat_roughness},
          {"ior", f.ior}};
}

}  // namespace betwixt
