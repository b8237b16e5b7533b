# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Makes the small scene files of the tests, and the figure of the examples. Needs numpy.
#   python3 tests/peers/scenes.py   writes tests/commands/data/scenes/* and examples/meshes/figure.glb
import json, math, os, struct
import numpy as np

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
CODES = {"f4": 5126, "u2": 5123, "u1": 5121, "i2": 5122, "i1": 5120, "u4": 5125}
KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


class Glb:
    """A glTF file that is being made: numbers go into its buffer, everything else into its JSON."""

    def __init__(self):
        self.bytes = b""
        self.json = {"asset": {"version": "2.0", "generator": "Betwixt's tests"}, "scene": 0, "scenes": [{"nodes": [0]}],
                     "nodes": [], "bufferViews": [], "accessors": []}

    def view(self, raw):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(raw)})
        self.bytes += raw
        return len(self.json["bufferViews"]) - 1

    def numbers(self, values, code="f4", normalized=False):
        all = np.asarray(values, dtype="<" + code)
        width = 1 if all.ndim == 1 else all.shape[1]
        made = {"bufferView": self.view(all.tobytes()), "componentType": CODES[code], "count": len(all),
                "type": KINDS[width]}
        if code == "f4":
            made["min"] = np.atleast_1d(all.min(axis=0)).tolist()
            made["max"] = np.atleast_1d(all.max(axis=0)).tolist()
        if normalized:
            made["normalized"] = True
        self.json["accessors"].append(made)
        return len(self.json["accessors"]) - 1

    def add(self, where, what):
        self.json.setdefault(where, []).append(what)
        return len(self.json[where]) - 1

    def node(self, name, parent=None, **what):
        i = self.add("nodes", {"name": name, **what})
        if parent is not None:
            self.json["nodes"][parent].setdefault("children", []).append(i)
        return i

    def animation(self, name=None):
        a = {"channels": [], "samplers": []}
        if name:
            a["name"] = name
        self.add("animations", a)
        return a

    def track(self, animation, node, path, times, values, way="LINEAR", **kind):
        animation["samplers"].append({"input": self.numbers(times), "output": self.numbers(values, **kind),
                                      "interpolation": way})
        animation["channels"].append({"sampler": len(animation["samplers"]) - 1,
                                      "target": {"node": node, "path": path}})

    def write(self, path):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.json["buffers"] = [{"byteLength": len(self.bytes)}]
        text = json.dumps(self.json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        with open(os.path.join(ROOT, path), "wb") as f:
            f.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(self.bytes)))
            f.write(struct.pack("<I4s", len(text), b"JSON") + text)
            f.write(struct.pack("<I4s", len(self.bytes), b"BIN\0") + self.bytes)


def turn(axis, degrees):
    a = np.asarray(axis, float)
    a /= np.linalg.norm(a)
    h = math.radians(degrees) / 2
    return [*(math.sin(h) * a), math.cos(h)]


def tube(around, rings, radius, low, high):
    """Returns a tube around the y axis: positions, normals, triangles."""
    at, out, faces = [], [], []
    for r in range(rings):
        y = low + (high - low) * r / (rings - 1)
        for k in range(around):
            c, s = math.cos(2 * math.pi * k / around), math.sin(2 * math.pi * k / around)
            at.append((radius * c, y, radius * s)), out.append((c, 0, s))
    for r in range(rings - 1):
        for k in range(around):
            a, b = r * around + k, r * around + (k + 1) % around
            faces += [a, a + around, b, b, a + around, b + around]
    return np.array(at), np.array(out), np.array(faces)


def box(size=1.0):
    at, out, faces = [], [], []
    for axis in range(3):
        for sign in (1, -1):
            n = np.zeros(3)
            n[axis] = sign
            u, v = np.roll(n, 1) * sign, np.roll(n, 2)
            base = len(at)
            for p, q in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                at.append(size / 2 * (n + p * u + q * v)), out.append(n)
            faces += [base + i for i in (0, 1, 2, 0, 2, 3)]
    return np.array(at), np.array(out), np.array(faces)


def skin(path):
    """A tube with three joints. Its armature is translated, rotated and scaled. The joints rotate, and one moves."""
    g = Glb()
    root = g.node("Armature", translation=[1, 0, -2], rotation=turn([0, 1, 0], 30), scale=[1, 2, 1.5])
    hip = g.node("Hip", root, translation=[0, 0.5, 0])
    knee = g.node("Knee", hip, translation=[0, 1, 0], rotation=turn([1, 0, 0], 10))
    foot = g.node("Foot", knee, translation=[0, 1, 0])
    at, out, faces = tube(8, 9, 0.3, 0.5, 2.5)
    bind = []
    for y in (0.5, 1.5, 2.5):
        m = np.eye(4)
        m[1, 3] = -y
        bind.append(m.T.flatten())
    joints, weights = [], []
    for p in at:
        t = p[1] - 0.5
        k = min(int(t), 1)
        joints.append([k, k + 1, 0, 0]), weights.append([3 * (1 - (t - k)), 3 * (t - k), 0, 0])
    s = g.add("skins", {"joints": [hip, knee, foot], "inverseBindMatrices": g.numbers(bind)})
    m = g.add("meshes", {"name": "Leg", "primitives": [{"attributes": {
        "POSITION": g.numbers(at), "NORMAL": g.numbers(out), "JOINTS_0": g.numbers(joints, "u1"),
        "WEIGHTS_0": g.numbers(weights)}, "indices": g.numbers(faces, "u2")}]})
    g.node("Leg", root, mesh=m, skin=s, translation=[7, 7, 7])  # without effect: a skinned mesh follows only its joints
    a = g.animation("Bend")
    g.track(a, knee, "rotation", [0.25, 1, 2], [turn([1, 0, 0], 0), turn([1, 0.2, 0], 80), turn([0, 0, 1], -40)])
    g.track(a, foot, "rotation", [0, 1.5], [turn([0, 1, 0], 0), turn([0, 1, 0], 170)])
    g.track(a, hip, "translation", [0, 0.7, 2], [[0, 0.5, 0], [0.5, 0.7, 0], [0, 0.5, 0.5]])
    a = g.animation("Still")
    g.track(a, hip, "scale", [0], [[1, 1, 1]])
    g.write(path)


def morph(path):
    g = Glb()
    at, out, faces = box()
    up = np.where(at[:, 1:2] > 0, [[0, 1.0, 0]], [[0, 0, 0]])
    wide = np.where(at[:, :1] > 0, [[0.5, 0, 0.25]], [[0, 0, 0]])
    bent = np.full(out.shape, 0.125)
    m = g.add("meshes", {"name": "Face", "weights": [0.25, 0], "extras": {"targetNames": ["smile", "scale"]},
                         "primitives": [{"attributes": {"POSITION": g.numbers(at), "NORMAL": g.numbers(out)},
                                         "indices": g.numbers(faces, "u2"),
                                         "targets": [{"POSITION": g.numbers(up)},
                                                     {"POSITION": g.numbers(wide), "NORMAL": g.numbers(bent)}]}]})
    g.node("Faces")
    g.node("Calm", 0, mesh=m)
    g.node("Lively", 0, mesh=m, translation=[2, 0, 0], weights=[0, 0.5])
    a = g.animation()
    g.track(a, 2, "weights", [0, 1, 3], [0, 0.5, 1, 0, 0.25, 1])
    g.write(path)


def cubic(path):
    """All paths with CUBICSPLINE keys and explicit tangents."""
    random = np.random.default_rng(7)
    g = Glb()
    at, out, faces = box()
    up = np.where(at[:, 1:2] > 0, [[0, 1.0, 0]], [[0, 0, 0]])
    m = g.add("meshes", {"primitives": [{"attributes": {"POSITION": g.numbers(at), "NORMAL": g.numbers(out)},
                                         "indices": g.numbers(faces, "u2"), "targets": [{"POSITION": g.numbers(up)}]}]})
    g.node("Thing", mesh=m)
    g.node("Tip", 0, translation=[0, 1, 0])
    a = g.animation("Swing")
    times = [0, 0.4, 1.1, 2]

    def three(values, scale):
        values = np.asarray(values, float)
        rows = []
        for v in values:
            rows += [random.normal(0, scale, values.shape[1]), v, random.normal(0, scale, values.shape[1])]
        return np.array(rows)

    g.track(a, 0, "translation", times, three(random.normal(0, 2, (4, 3)), 3), "CUBICSPLINE")
    turns = [turn([0, 1, 0], 0), turn([0, 1, 0.2], 50), turn([0.3, 1, 0], 110), turn([0.3, 1, 0], 170)]
    g.track(a, 0, "rotation", times, three(turns, 0.6), "CUBICSPLINE")
    g.track(a, 0, "scale", times, three(1 + random.random((4, 3)), 0.8), "CUBICSPLINE")
    rows = three(random.random((4, 1)), 1)
    g.track(a, 0, "weights", times, rows[:, 0], "CUBICSPLINE")
    g.write(path)


def step(path):
    """STEP keys, and numbers that are no floats: quantised positions, rotations in 16 bits, a sparse accessor."""
    g = Glb()
    at, out, faces = box(2.0)
    quantised = np.round(at * 127).astype(int)
    quantised = np.hstack([quantised, np.zeros((len(at), 1), int)])  # elements begin at multiples of four
    raw = quantised.astype("<i1").tobytes()
    view = g.view(raw)
    g.json["bufferViews"][view]["byteStride"] = 4
    g.json["accessors"].append({"bufferView": view, "componentType": 5120, "count": len(at), "type": "VEC3",
                                "normalized": True, "min": [-127] * 3, "max": [127] * 3})
    position = len(g.json["accessors"]) - 1
    g.json["extensionsUsed"] = g.json["extensionsRequired"] = ["KHR_mesh_quantization"]
    m = g.add("meshes", {"primitives": [{"attributes": {"POSITION": position, "NORMAL": g.numbers(out)},
                                         "indices": g.numbers(faces, "u2")}]})
    g.node("Box", mesh=m, scale=[2, 2, 2])
    sparse = g.numbers([[0, 0, 0], [1, 0, 0], [2, 0, 0]])
    g.json["accessors"][sparse]["sparse"] = {
        "count": 1, "indices": {"bufferView": g.view(struct.pack("<H", 1)), "componentType": 5123},
        "values": {"bufferView": g.view(struct.pack("<3f", 1, 5, 0))}}
    a = g.animation()
    a["samplers"].append({"input": g.numbers([0.5, 1, 1.5]), "output": sparse, "interpolation": "STEP"})
    a["channels"].append({"sampler": 0, "target": {"node": 0, "path": "translation"}})
    turns = np.round(np.array([turn([0, 0, 1], 0), turn([0, 0, 1], 180)]) * 32767).astype(int)
    g.track(a, 0, "rotation", [0, 2], turns, code="i2", normalized=True)
    g.write(path)


def stage(path):
    """Cameras, lights, materials, a node with a matrix, and names that collide or are invalid in Betwixt."""
    g = Glb()
    g.json["scenes"][0]["nodes"] = [0]
    g.node("Stage")
    at, out, faces = box()
    plain = {"POSITION": g.numbers(at), "NORMAL": g.numbers(out)}
    index = g.numbers(faces, "u2")
    looks = [{"name": "Gold", "pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0.1, 1], "metallicFactor": 1,
                                                       "roughnessFactor": 0.25}},
             {"name": "Glass", "alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.25],
                                                                              "metallicFactor": 0}},
             {"name": "Lamp", "emissiveFactor": [1, 0, 0], "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1],
                                                                                     "metallicFactor": 0}}]
    for i, look in enumerate(looks):
        m = g.add("meshes", {"primitives": [{"attributes": plain, "indices": index, "material": g.add("materials", look)}]})
        g.node(["Wheel.001", "Wheel 001", "3 \u00e4pfel"][i], 0, mesh=m, translation=[2 * i, 0, 0])
    g.add("cameras", {"type": "perspective", "perspective": {"yfov": 0.8, "aspectRatio": 1.5, "znear": 0.1}})
    g.add("cameras", {"type": "orthographic", "orthographic": {"xmag": 4, "ymag": 3, "znear": 0.1, "zfar": 100}})
    g.node("Eye", 0, camera=0, translation=[0, 1, 9])
    g.node("Plan", 0, camera=1, translation=[0, 9, 0], rotation=turn([1, 0, 0], -90))
    g.json["extensionsUsed"] = ["KHR_lights_punctual"]
    g.json["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "directional", "intensity": 2 * math.pi, "color": [1, 1, 0.5]},
        {"type": "point", "intensity": 20 * math.pi, "range": 0}, {"type": "spot", "intensity": 10, "range": 7, "spot": {}}]}}
    for i, name in enumerate(["Sun", "Bulb", "Spot"]):
        g.node(name, 0, extensions={"KHR_lights_punctual": {"light": i}}, translation=[0, 5, 0],
               rotation=turn([1, 0, 0], -90))
    m = np.eye(4)
    m[:3, :3] = 2 * np.array([[0, -1, 0], [1, 0, 0], [0, 0, -1]])  # rotated, twice as large, mirrored
    m[:3, 3] = [1, 2, 3]
    g.node("Matrix", 0, matrix=m.T.flatten().tolist())
    g.write(path)


def figure(path):
    """A figure that walks on the spot and waves: one mesh, eleven joints, and a morph target for a smile."""
    g = Glb()
    g.node("Figure")
    joints, places, bones = [], [], {}

    def joint(name, above, at):
        parent = bones[above] if above else 0
        origin = np.array(places[joints.index(parent)]) if above else np.zeros(3)
        bones[name] = g.node(name, parent, translation=(np.array(at) - origin).round(6).tolist())
        joints.append(bones[name]), places.append(at)

    joint("Hips", None, (0, 0.95, 0))
    joint("Chest", "Hips", (0, 1.15, 0))
    joint("Head", "Chest", (0, 1.55, 0))
    for side, x in (("Left", 1), ("Right", -1)):
        joint(side + "Arm", "Chest", (0.24 * x, 1.45, 0))
        joint(side + "Hand", side + "Arm", (0.24 * x, 1.13, 0))
        joint(side + "Leg", "Hips", (0.12 * x, 0.9, 0))
        joint(side + "Foot", side + "Leg", (0.12 * x, 0.48, 0))
    order = {j: i for i, j in enumerate(joints)}
    at, out, faces, follows, weights, smile = [], [], [], [], [], []

    def limb(radius, low, high, x, upper, lower, bend=None, rings=9):
        """Returns a limb, closed by half balls. The part below `bend` follows the joint `lower`."""
        around, base = 14, sum(map(len, at))
        p, n, _ = tube(around, rings, radius, low, high)
        for cap, y, sign in ((range(1, 5), high, 1), (range(1, 5), low, -1)):
            for c in cap:
                a = c / 4 * math.pi / 2
                q, m, _ = tube(around, 2, max(radius * math.cos(a), 1e-3), 0, 1)
                q, m = q[:around].copy(), m[:around] * math.cos(a)
                q[:, 1] = y + sign * radius * math.sin(a)
                m[:, 1] = sign * math.sin(a)
                p, n = (np.vstack([p, q]), np.vstack([n, m])) if sign > 0 else (np.vstack([q, p]), np.vstack([m, n]))
        count = len(p) // around
        for r in range(count - 1):
            for k in range(around):
                a, b = base + r * around + k, base + r * around + (k + 1) % around
                faces.extend([a, a + around, b, b, a + around, b + around])
        p = p + [x, 0, 0]
        for q in p:
            t = 0.0 if bend is None else min(max((bend + 0.07 - q[1]) / 0.14, 0), 1)
            follows.append([order[bones[upper]], order[bones[lower]], 0, 0]), weights.append([1 - t, t, 0, 0])
        at.append(p), out.append(n)

    limb(0.17, 1.0, 1.38, 0, "Chest", "Hips", 1.1)
    limb(0.15, 1.68, 1.7, 0, "Head", "Head", rings=2)
    for side, x in (("Left", 1), ("Right", -1)):
        limb(0.06, 0.85, 1.43, 0.25 * x, side + "Arm", side + "Hand", 1.13, 13)
        limb(0.085, 0.1, 0.88, 0.12 * x, side + "Leg", side + "Foot", 0.48, 13)
    at, out = np.vstack(at), np.vstack(out)
    bind = []
    for p in places:
        m = np.eye(4)
        m[:3, 3] = -np.array(p)
        bind.append(m.T.flatten())
    s = g.add("skins", {"joints": joints, "inverseBindMatrices": g.numbers(bind)})
    look = g.add("materials", {"pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.45, 0.15, 1], "metallicFactor": 0,
                                                        "roughnessFactor": 0.5}})
    m = g.add("meshes", {"name": "Body", "primitives": [{"attributes": {
        "POSITION": g.numbers(at), "NORMAL": g.numbers(out), "JOINTS_0": g.numbers(follows, "u1"),
        "WEIGHTS_0": g.numbers(weights)}, "indices": g.numbers(faces, "u2"), "material": look}]})
    g.node("Body", 0, mesh=m, skin=s)
    walk = g.animation("Walk")
    times = np.linspace(0, 1, 9)
    wave = np.sin(2 * math.pi * times)
    for side, x in (("Left", 1), ("Right", -1)):
        g.track(walk, bones[side + "Leg"], "rotation", times, [turn([1, 0, 0], -32 * x * w) for w in wave])
        g.track(walk, bones[side + "Foot"], "rotation", times,
                [turn([1, 0, 0], 25 - 25 * x * math.cos(2 * math.pi * t)) for t in times])
    g.track(walk, bones["RightArm"], "rotation", times, [turn([1, 0, 0], -25 * w) for w in wave])
    g.track(walk, bones["LeftArm"], "rotation", times, [turn([0, 0.1, 1], 140 + 4 * w) for w in wave])
    g.track(walk, bones["LeftHand"], "rotation", times, [turn([0, 0, 1], 28 * math.sin(4 * math.pi * t)) for t in times])
    g.track(walk, bones["Head"], "rotation", times, [turn([0, 1, 0], 14 * w) for w in wave])
    g.track(walk, bones["Hips"], "translation", times, [[0, 0.95 - 0.03 * abs(w), 0] for w in wave])
    g.write(path)


def bones(path):
    """A motion capture file: no mesh, all channels of the root, other orders of rotations below it."""
    random = np.random.default_rng(3)
    text = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Leg
  {
    OFFSET 1 -1 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT Foot
    {
      OFFSET 0 -4 0.5
      CHANNELS 3 Xrotation Yrotation Zrotation
      End Site
      {
        OFFSET 0 0 1
      }
    }
  }
  JOINT Chest
  {
    OFFSET 0 3 0
    CHANNELS 3 Zrotation Yrotation Xrotation
    End Site
    {
      OFFSET 0 2 0
    }
  }
}
MOTION
Frames: 6
Frame Time: 0.05
"""
    for _ in range(6):
        text += " ".join(f"{x:.4f}" for x in [*random.normal(0, 3, 3), *random.uniform(-80, 80, 12)]) + "\n"
    with open(os.path.join(ROOT, path), "w") as f:
        f.write(text)


scenes = "tests/commands/data/scenes/"
os.makedirs(os.path.join(ROOT, scenes), exist_ok=True)
for make in (skin, morph, cubic, step, stage):
    make(f"{scenes}{make.__name__}.glb")
bones(f"{scenes}bones.bvh")
figure("examples/meshes/figure.glb")
