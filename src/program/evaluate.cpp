// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "program/code.h"
#include "scene/extent.h"

namespace betwixt {
namespace {

Vec3 mix(Vec3 a, Vec3 b, double s) { return a + s * (b - a); }

}  // namespace

std::vector<double> Program::Compiled::at(Time t, Asking& asking) const {
  std::vector<double> numbers = rest;
  for (const CurveUse& use : curves) evaluate(use, t, &numbers[use.offset]);
  if (!lives.empty())
    for (const Binding& b : bindings)
      if (b.live >= 0 && b.channels > 0) evaluate(b, t, asking, &numbers[b.offset]);
  return numbers;
}

void Program::Compiled::evaluate(const CurveUse& use, Time t, double* out) const {
  set.evaluate(use.curve, t, out);
  if (!use.bounded) return;
  for (int i = 0; i < use.curve.channels; ++i) out[i] = std::clamp(out[i], use.low, use.high);
}

void Program::Compiled::evaluate(const Binding& b, Time t, Asking& asking, double* out) const {
  if (b.live >= 0) {
    held_numbers(live_value(b.live, t, asking), b.orientation, out);
    return;
  }
  std::copy_n(&rest[b.offset], 4, out);
  for (std::uint32_t i = 0; i < b.curves; ++i) {
    const CurveUse& use = curves[b.first_curve + i];
    evaluate(use, t, out + (use.offset - b.offset));
  }
}

Value Program::Compiled::value(const Binding& b, Time t, Asking& asking) const {
  if (b.live >= 0) return live_value(b.live, t, asking);
  if (b.steps < 0) return b.constant;
  const Between w = between(b, t);
  return steps[static_cast<std::size_t>(b.steps)].values()[w.s >= 1 ? w.b : w.a];
}

namespace {

// What the tracks of one object say about its place.
struct Said {
  Quat turn;
  Vec3 scale, pivot, position, attach;
};

// Scale and rotation about the pivot, then the move (R-H7).
Mat4 local(const Said& said) {
  Mat4 m = rotation(said.turn);
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) m(i, c) *= said.scale[c];
  const Vec3 move = said.position + said.pivot - transform_vector(m, said.pivot);
  m(0, 3) = move.x, m(1, 3) = move.y, m(2, 3) = move.z;
  return m;
}

Mat4 linear_part(Mat4 m) {
  m(0, 3) = m(1, 3) = m(2, 3) = 0;
  return m;
}

// None where the matrix is singular.
std::optional<Mat4> inverse(const Mat4& m) {
  const auto column = [&](int c) { return Vec3{m(0, c), m(1, c), m(2, c)}; };
  const Vec3 a = column(0), b = column(1), c = column(2);
  const double det = dot(a, cross(b, c));
  if (!(std::abs(det) > 1e-12 * length(a) * length(b) * length(c))) return std::nullopt;
  const Vec3 rows[] = {1 / det * cross(b, c), 1 / det * cross(c, a), 1 / det * cross(a, b)};
  Mat4 out;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) out(i, k) = rows[i][k];
  const Vec3 move = -transform_vector(out, translation_of(m));
  out(0, 3) = move.x, out(1, 3) = move.y, out(2, 3) = move.z;
  return out;
}

Mat4 held_turn(Hold hold, const Placed& parent) {
  return hold == Hold::couple ? linear_part(parent.world) : hold == Hold::attach ? rotation(parent.turn) : Mat4{};
}

// R-H1 to R-H5. `parent`: of hang, attach and couple, at this time.
Placed hang(const Said& said, const Hand* hand, const Frozen* frozen, const Placed* parent) {
  Mat4 m = local(said);
  Quat turn = said.turn;
  if (!hand || hand->hold == Hold::detach || (hand->hold == Hold::letgo && !frozen->held)) return {m, turn};
  Vec3 attach = said.attach;
  if (frozen) m = frozen->before * m, turn = frozen->before_turn * turn;
  Mat4 turn3, above;
  Quat above_turn;
  if (hand->hold == Hold::letgo) {
    turn3 = frozen->turn3, above = frozen->parent, above_turn = frozen->parent_turn, attach = frozen->attach;
  } else {
    turn3 = held_turn(hand->hold, *parent), above = parent->world;
    if (hand->hold != Hold::hang) above_turn = parent->turn;
  }
  const Vec3 place = transform_point(above, translation_of(m) + attach);
  Mat4 world = turn3 * linear_part(m);
  world(0, 3) = place.x, world(1, 3) = place.y, world(2, 3) = place.z;
  return {world, above_turn * turn};
}

Said said_by(const Node& n, const double* numbers) {
  const double* r = numbers + n.rotation;
  return {n.orientation ? Quat{r[0], r[1], r[2], r[3]} : from_angles(vec3(r)), vec3(numbers + n.scale),
          vec3(numbers + n.pivot), vec3(numbers + n.position), vec3(numbers + n.attach)};
}

}  // namespace

const Hand* Program::Compiled::hand(const Node& n, Time t) const {
  const Hand *first = hands.data() + n.first_hand, *last = first + n.hands;
  const Hand* next = std::upper_bound(first, last, t, [](Time time, const Hand& h) { return time < h.from; });
  return next == first ? nullptr : next - 1;
}

// What a letgo or a keep-world keeps: worked out once, from the world at its time.
void Program::Compiled::thaw(std::int32_t index, Asking& asking) const {
  Frozen& f = frozen[static_cast<std::size_t>(index)];
  if (f.state != Frozen::asleep) return;
  f.state = Frozen::busy;
  const Node& n = nodes[f.node];
  const Hand& now = hands[n.first_hand + static_cast<std::uint32_t>(f.hand)];
  const Hand* before = f.hand > 0 ? &now - 1 : nullptr;
  const Time t = now.from.flicks == INT64_MIN ? Time{} : now.from;
  const auto numbers = [&](FunctionId function, double* out) {
    evaluate(find(n.object, function), t, asking, out);
    return vec3(out);
  };
  double r[4] = {}, x[4] = {};
  Said said;
  numbers(fn::rotation, r);
  said.turn = n.orientation ? Quat{r[0], r[1], r[2], r[3]} : from_angles(vec3(r));
  said.scale = numbers(fn::scale, x), said.pivot = numbers(fn::pivot, x), said.position = numbers(fn::position, x);
  said.attach = numbers(fn::attach_position, x);
  const Frozen* kept = before && before->frozen >= 0 ? &frozen[static_cast<std::size_t>(before->frozen)] : nullptr;
  if (kept) thaw(before->frozen, asking);
  Placed old_parent;
  if (before && before->hold >= Hold::hang)
    old_parent = placement(static_cast<std::uint32_t>(before->parent), t, asking);
  if (now.hold == Hold::letgo) {
    if (before && before->hold == Hold::letgo) {  // nobody holds it: what was kept stays
      const auto hand = f.hand;
      f = *kept;
      f.hand = hand;
    } else if (before && before->hold >= Hold::hang) {
      f.held = true;
      if (kept) f.before = kept->before, f.before_turn = kept->before_turn;
      f.turn3 = held_turn(before->hold, old_parent);
      f.parent = old_parent.world;
      if (before->hold != Hold::hang) f.parent_turn = old_parent.turn;
      f.attach = said.attach;
    }
  } else {
    const Placed was = hang(said, before, kept, &old_parent);
    const Placed parent = placement(static_cast<std::uint32_t>(now.parent), t, asking);
    const auto turned = inverse(held_turn(now.hold, parent)), above = inverse(parent.world);
    const auto own = inverse(local(said));
    if (turned && above && own) {
      Mat4 wanted = *turned * linear_part(was.world);
      const Vec3 place = transform_point(*above, translation_of(was.world)) - said.attach;
      wanted(0, 3) = place.x, wanted(1, 3) = place.y, wanted(2, 3) = place.z;
      f.before = wanted * *own;
      const Quat above_turn = now.hold == Hold::hang ? Quat{} : parent.turn;
      f.before_turn = normalize(conjugate(above_turn) * was.turn * conjugate(said.turn));
    }
  }
  f.state = Frozen::done;
}

Mat4 look_at(Vec3 eye, Vec3 target) {
  const Vec3 back = normalize(eye - target);
  const Vec3 up = std::abs(back.y) > 1 - 1e-12 ? Vec3{0, 0, back.y > 0 ? -1.0 : 1.0} : Vec3{0, 1, 0};
  const Vec3 right = normalize(cross(up, back)), over = cross(back, right);
  Mat4 m = translation(eye);
  for (int i = 0; i < 3; ++i) m(i, 0) = right[i], m(i, 1) = over[i], m(i, 2) = back[i];
  return m;
}

// Where all nodes are. For each one up to the root and, unwinding, down again; nothing is worked out twice (G85, G86).
// A camera that looks at something turns with it, and so does what hangs on the camera: cameras take their turn in this
// order, each seeing the ones before it already turned.
std::vector<Placed> Program::Compiled::placements(Time t, const double* numbers, Asking& asking) const {
  constexpr std::int32_t unknown = -2;
  std::vector<Placed> w(nodes.size());
  std::vector<std::int32_t> above(nodes.size(), unknown);
  std::vector<std::uint32_t> order, chain;
  order.reserve(nodes.size());
  const auto put = [&](std::uint32_t i) {
    const Hand* h = hand(nodes[i], t);
    const Frozen* f = h && h->frozen >= 0 ? &frozen[static_cast<std::size_t>(h->frozen)] : nullptr;
    w[i] = hang(said_by(nodes[i], numbers), h, f, above[i] >= 0 ? &w[static_cast<std::size_t>(above[i])] : nullptr);
  };
  for (std::uint32_t start = 0; start < nodes.size(); ++start) {
    for (std::int32_t i = static_cast<std::int32_t>(start); i >= 0 && above[static_cast<std::size_t>(i)] == unknown;) {
      const auto at = static_cast<std::uint32_t>(i);
      const Hand* h = hand(nodes[at], t);
      chain.push_back(at);
      i = above[at] = h && h->hold >= Hold::hang ? h->parent : -1;
    }
    for (; !chain.empty(); chain.pop_back()) {
      put(chain.back());
      order.push_back(chain.back());
    }
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t eye = order[i];
    if (nodes[eye].kind != Kind::camera) continue;
    const auto target = aim(nodes[eye].object, t, numbers, &w, asking);
    if (!target || *target == translation_of(w[eye].world)) continue;
    w[eye].world = look_at(translation_of(w[eye].world), *target);
    w[eye].turn = from_matrix(w[eye].world);
    std::vector<bool> below(nodes.size());
    below[eye] = true;
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      const std::int32_t p = above[order[k]];
      if (p < 0 || !below[static_cast<std::size_t>(p)]) continue;
      below[order[k]] = true;
      put(order[k]);
    }
  }
  return w;
}

std::vector<Mat4> Program::Compiled::worlds(Time t, const double* numbers, Asking& asking) const {
  const auto all = placements(t, numbers, asking);
  std::vector<Mat4> w(all.size());
  for (std::size_t i = 0; i < w.size(); ++i) w[i] = all[i].world;
  return w;
}

Placed Program::Compiled::placement(std::uint32_t node, Time t, Asking& asking) const {
  std::vector<std::uint32_t> chain;
  for (std::int32_t i = static_cast<std::int32_t>(node); i >= 0;) {
    const Node& n = nodes[static_cast<std::size_t>(i)];
    chain.push_back(static_cast<std::uint32_t>(i));
    if (n.kind == Kind::camera && &find(n.object, fn::look_at) != &defaults[fn::look_at])
      return placements(t, at(t, asking).data(), asking)[node];  // it turns with what it looks at
    const Hand* h = hand(n, t);
    i = h && h->hold >= Hold::hang ? h->parent : -1;
  }
  Placed placed;
  for (; !chain.empty(); chain.pop_back()) {
    const Node& n = nodes[chain.back()];
    const Hand* h = hand(n, t);
    if (h && h->frozen >= 0) thaw(h->frozen, asking);
    double x[4] = {};
    const auto numbers = [&](FunctionId f) {
      evaluate(find(n.object, f), t, asking, x);
      return vec3(x);
    };
    Said said;
    numbers(fn::rotation);
    said.turn = n.orientation ? Quat{x[0], x[1], x[2], x[3]} : from_angles(vec3(x));
    said.scale = numbers(fn::scale), said.pivot = numbers(fn::pivot), said.position = numbers(fn::position);
    said.attach = numbers(fn::attach_position);
    placed = hang(said, h, h && h->frozen >= 0 ? &frozen[static_cast<std::size_t>(h->frozen)] : nullptr, &placed);
  }
  return placed;
}

std::optional<Vec3> Program::Compiled::aim(std::uint32_t camera, Time t, const double* numbers,
                                           const std::vector<Placed>* placed, Asking& asking) const {
  const Binding& b = find(camera, fn::look_at);
  if (b.channels == 3 && b.live < 0) return vec3(numbers + b.offset);
  const auto point = [&](const Value& v) -> std::optional<Vec3> {
    if (const auto* p = std::get_if<Vec3>(&v)) return *p;
    const auto* id = std::get_if<ObjectId>(&v);
    if (!id || !find_object(document.scene(), *id)) return std::nullopt;
    return translation_of((*placed)[node_of[id->index]].world);
  };
  if (b.live >= 0) return point(live_value(b.live, t, asking));
  if (b.steps < 0) return point(b.constant);
  const Between w = between(b, t);
  const auto values = steps[static_cast<std::size_t>(b.steps)].values();
  const auto from = point(values[w.a]), to = point(values[w.b]);
  if (!from || !to || w.a == w.b) return w.s >= 1 ? to : from;
  return mix(*from, *to, w.s);
}

Shape Program::Compiled::shape(std::uint32_t object, Time t, const double* numbers, Asking& asking) const {
  const Scene& scene = document.scene();
  Shape s;
  s.kind = scene.objects[object].kind;
  const auto number = [&](FunctionId f) { return numbers[find(object, f).offset]; };
  const auto text = [&](FunctionId f) { return std::get<Text>(value(find(object, f), t, asking)); };
  switch (s.kind) {
    case Kind::sphere:
    case Kind::disc:
      s.radius = number(fn::radius);
      break;
    case Kind::box:
      s.size = vec3(numbers + find(object, fn::box_size).offset);
      break;
    case Kind::plane: {
      const double* n = numbers + find(object, fn::plane_size).offset;
      s.size = {n[0], n[1], 1};
      break;
    }
    case Kind::cylinder:
    case Kind::cone:
      s.radius = number(fn::radius), s.height = number(fn::height);
      break;
    case Kind::torus:
      s.radius = number(fn::radius), s.tube = number(fn::tube);
      break;
    case Kind::polygon:
    case Kind::polyline:
    case Kind::points: {
      const Binding& b = find(object, fn::points);
      s.points = std::get<Points>(value(b, t, asking));
      if (b.steps >= 0) {
        const Between w = between(b, t);
        const auto values = steps[static_cast<std::size_t>(b.steps)].values();
        const auto &from = *std::get<Points>(values[w.a]), &to = *std::get<Points>(values[w.b]);
        if (w.a != w.b && from.size() == to.size()) {
          std::vector<Vec3> between_them(from.size());
          for (std::size_t i = 0; i < from.size(); ++i) between_them[i] = mix(from[i], to[i], w.s);
          s.points = Points(std::move(between_them));
        }
      }
      if (s.kind == Kind::polyline) s.width = number(fn::width);
      if (s.kind == Kind::points) s.width = number(fn::point_size);
      break;
    }
    case Kind::text:
      s.text = text(fn::text), s.font = text(fn::font), s.depth = number(fn::depth);
      s.size = {1, number(fn::text_size), 1};
      break;
    case Kind::mesh: {
      const auto found = scene.meshes->find(*text(fn::file));
      if (found != scene.meshes->end()) s.mesh = found->second;
      break;
    }
    default:
      break;
  }
  return s;
}

namespace {

Material material_of(const std::string& word) {
  return word == "matte"   ? Material::matte
         : word == "metal" ? Material::metal
         : word == "glow"  ? Material::glow
                           : Material::plastic;
}

}  // namespace

void Program::Compiled::add_items(Frame& frame, const double* numbers, const std::vector<Mat4>& w,
                                  Asking& asking) const {
  const Scene& scene = document.scene();
  const Time t = frame.time;
  const auto shape_of = [&](std::uint32_t object) {
    const Node& n = nodes[node_of[object]];
    return n.shape ? n.shape : std::make_shared<const Shape>(shape(object, t, numbers, asking));
  };
  for (std::uint32_t object = 0; object < node_of.size(); ++object) {
    if (node_of[object] == ObjectId::nothing) continue;
    const Node& n = nodes[node_of[object]];
    if (!drawn(n.kind) || numbers[n.display] == 0) continue;
    Item item;
    item.id = {object};
    item.world = w[node_of[object]];
    item.color = vec3(numbers + n.color);
    item.transparency = std::clamp(numbers[find(object, fn::transparency).offset], 0.0, 1.0);
    item.shininess = std::clamp(numbers[find(object, fn::shininess).offset], 0.0, 1.0);
    item.material = material_of(*std::get<Text>(value(find(object, fn::material), t, asking)));
    const auto picture = scene.pictures->find(*std::get<Text>(value(find(object, fn::texture), t, asking)));
    if (picture != scene.pictures->end()) item.texture = picture->second;

    // Its own shape, another object's, or on the way between two.
    const auto look = [&](const Value& v) {
      const ObjectId other = std::get<ObjectId>(v);
      const Object* o = find_object(scene, other);
      return shape_of(o && drawn(o->kind) ? other.index : object);
    };
    const Binding& geometry = find(object, fn::geometry);
    if (geometry.steps < 0) {
      item.shape = look(value(geometry, t, asking));
    } else {
      const Between b = between(geometry, t);
      const auto values = steps[static_cast<std::size_t>(geometry.steps)].values();
      item.shape = look(values[b.a]);
      if (b.a != b.b && b.s != 0) item.toward = look(values[b.b]), item.blend = b.s;
    }
    frame.items.push_back(std::move(item));
  }
}

void Program::Compiled::add_lights(Frame& frame, const double* numbers, const std::vector<Mat4>& w,
                                   Asking& asking) const {
  for (std::uint32_t object = 0; object < node_of.size(); ++object) {
    if (node_of[object] == ObjectId::nothing) continue;
    const Node& n = nodes[node_of[object]];
    if (n.kind != Kind::light || numbers[n.display] == 0) continue;
    Light l;
    l.id = {object};
    l.position = translation_of(w[node_of[object]]);
    l.sun = *std::get<Text>(value(find(object, fn::shines), frame.time, asking)) == "sun";
    // A sun shines from where it stands towards the middle of the world; one that stands there shines down.
    l.direction = normalize(-l.position, {0, -1, 0});
    l.color = numbers[find(object, fn::intensity).offset] * vec3(numbers + n.color);
    const Vec3 own = vec3(numbers + n.scale);
    l.range = numbers[find(object, fn::range).offset] *
              std::max({std::abs(own.x), std::abs(own.y), std::abs(own.z)});  // R-H9
    frame.lights.push_back(l);
  }
}

Camera Program::Compiled::camera(Time t, const double* numbers, const std::vector<Mat4>& w) const {
  const Scene& scene = document.scene();
  ObjectId through;
  const auto cut = scene.cuts->upper_bound(t);
  if (cut != scene.cuts->begin()) through = std::prev(cut)->second;
  for (std::uint32_t object = 0; !through && object < node_of.size(); ++object)
    if (node_of[object] != ObjectId::nothing && nodes[node_of[object]].kind == Kind::camera) through = {object};
  if (!through) return own_camera();

  const std::uint32_t object = through.index;
  const auto number = [&](FunctionId f) { return numbers[find(object, f).offset]; };
  Camera c;
  const Mat4& m = w[node_of[object]];
  const Vec3 at = translation_of(m);
  // A rigid motion, whatever scales the camera has been put through.
  const Vec3 back = normalize(transform_vector(m, {0, 0, 1})), up = transform_vector(m, {0, 1, 0});
  const Mat4 upright = look_at({}, -back);  // for a camera whose own up is scaled to nothing
  const Vec3 right = normalize(cross(up, back), transform_vector(upright, {1, 0, 0})), over = cross(back, right);
  c.world = translation(at);
  for (int i = 0; i < 3; ++i) c.world(i, 0) = right[i], c.world(i, 1) = over[i], c.world(i, 2) = back[i];
  constexpr double gate = 36;  // mm
  const double fov = number(fn::fov);
  c.fov = fov > 0 ? std::min(fov, 3.1) : 2 * std::atan(gate / (2 * std::max(number(fn::lens), 0.1)));
  c.height = number(fn::camera_height);
  c.orthographic = c.height > 0;
  return c;
}

// A box around all that is seen during the film. Planes are grounds and walls for the rest, and count only where there
// is nothing else.
Extent Program::Compiled::stage() const {
  Extent things, planes;
  const auto [from, to] = document.range();
  constexpr int looks = 24;
  for (int k = 0; k <= looks; ++k) {
    Frame f;
    f.time = {from.flicks + (to - from).flicks / looks * k};
    Asking asking;
    const auto numbers = at(f.time, asking);
    add_items(f, numbers.data(), worlds(f.time, numbers.data(), asking), asking);
    for (const Item& item : f.items) {
      const Extent e = extent(*item.shape);
      if (e.empty()) continue;
      Extent& all = item.shape->kind == Kind::plane ? planes : things;
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p = transform_point(item.world, {corner & 1 ? e.high.x : e.low.x, corner & 2 ? e.high.y : e.low.y,
                                                    corner & 4 ? e.high.z : e.low.z});
        if (!std::isfinite(p.x + p.y + p.z)) continue;
        if (all.empty()) all = {p, p};
        for (int i = 0; i < 3; ++i) all.low[i] = std::min(all.low[i], p[i]), all.high[i] = std::max(all.high[i], p[i]);
      }
    }
  }
  if (!things.empty()) return things;
  return planes.empty() ? Extent{{-1, -1, -1}, {1, 1, 1}} : planes;
}

const Camera& Program::Compiled::own_camera() const {
  std::call_once(own_camera_once, [this] {
    const Extent all = stage();
    Camera& c = own_camera_made;
    c.fov = 2 * std::atan(36.0 / 70);
    // The widest picture people make is 16:9; what fits its height and width fits taller ones better.
    const Vec3 middle = 0.5 * (all.low + all.high), half = 0.5 * (all.high - all.low);
    const double across = std::tan(c.fov / 2), up = across * 9 / 16;
    const Mat4 turned = look_at(normalize(Vec3{0, 0.12, 1}), {});
    double distance = 1e-3;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p = half * Vec3{corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0};
      const auto along = [&](int axis) {
        return p.x * turned(0, axis) + p.y * turned(1, axis) + p.z * turned(2, axis);
      };
      distance = std::max(distance, along(2) + 1.1 * std::max(std::abs(along(0)) / across, std::abs(along(1)) / up));
    }
    c.world = look_at(middle + distance * normalize(Vec3{0, 0.12, 1}), middle);
  });
  return own_camera_made;
}

Frame Program::frame(Time t) const {
  Frame f;
  f.time = t;
  Asking asking;
  const auto numbers = code_->at(t, asking);
  const auto worlds = code_->worlds(t, numbers.data(), asking);
  code_->add_items(f, numbers.data(), worlds, asking);
  code_->add_lights(f, numbers.data(), worlds, asking);
  f.camera = code_->camera(t, numbers.data(), worlds);
  const Scene& scene = code_->document.scene();
  if (scene.background) f.background = to_linear(*scene.background);
  for (auto& [when, text] : code_->document.notes(t, t)) f.notes.push_back(text);
  f.problems = code_->notices;
  f.problems.insert(f.problems.end(), asking.problems.begin(), asking.problems.end());
  return f;
}

}  // namespace betwixt
