# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Makes models that ask what Khronos' sample models ask (MetalRoughSpheres, DamagedHelmet, ClearCoatTest …), as GLB files,
# and a sky for them. Nothing of them is kept in the repository.
#   MODELS: name -> function that returns a Glb;  write_sky(path)
import json, struct, zlib
import numpy as np


def png(pixels):
    """The bytes of a PNG of an array of bytes, height × width × 3 or 4."""
    height, width, depth = pixels.shape
    rows = np.zeros((height, 1 + width * depth), np.uint8)
    rows[:, 1:] = pixels.reshape(height, -1)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, {3: 2, 4: 6}[depth], 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)) + chunk(b"IEND", b""))


def as_bytes(values):
    return np.uint8(np.clip(np.asarray(values) * 255 + 0.5, 0, 255))


class Glb:
    def __init__(self):
        self.data = b""
        self.root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                     "materials": [], "accessors": [], "bufferViews": [], "buffers": []}
        self.used = set()

    def view(self, data):
        self.data += b"\0" * (-len(self.data) % 4)
        self.root["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)})
        self.data += data
        return len(self.root["bufferViews"]) - 1

    def accessor(self, values, kind, component):
        made = {"bufferView": self.view(values.tobytes()), "componentType": component, "count": len(values), "type": kind}
        if kind == "VEC3":
            made.update(min=values.min(0).tolist(), max=values.max(0).tolist())
        self.root["accessors"].append(made)
        return len(self.root["accessors"]) - 1

    def texture(self, pixels):
        images, textures = self.root.setdefault("images", []), self.root.setdefault("textures", [])
        images.append({"bufferView": self.view(png(as_bytes(pixels))), "mimeType": "image/png"})
        self.root.setdefault("samplers", [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}])
        textures.append({"source": len(images) - 1, "sampler": 0})
        return {"index": len(textures) - 1}

    def material(self, color=(1, 1, 1), metal=0.0, rough=0.5, pbr=None, ext=None, **more):
        made = {"pbrMetallicRoughness": {"baseColorFactor": [*color, 1][:4], "metallicFactor": metal,
                                         "roughnessFactor": rough, **(pbr or {})}, **more}
        if ext:
            made["extensions"] = {"KHR_materials_" + name: what for name, what in ext.items()}
            self.used |= set(made["extensions"])
        self.root["materials"].append(made)
        return len(self.root["materials"]) - 1

    def mesh(self, *parts):
        """Parts: ((positions, normals, uvs, triangles), material[, colors])."""
        made = []
        for (at, across, uvs, corners), material, *colors in parts:
            attributes = {"POSITION": self.accessor(np.float32(at), "VEC3", 5126),
                          "NORMAL": self.accessor(np.float32(across), "VEC3", 5126),
                          "TEXCOORD_0": self.accessor(np.float32(uvs), "VEC2", 5126)}
            if colors: attributes["COLOR_0"] = self.accessor(np.float32(colors[0]), "VEC4", 5126)
            made.append({"attributes": attributes, "material": material,
                         "indices": self.accessor(np.uint32(corners).ravel(), "SCALAR", 5125)})
        self.root["meshes"].append({"primitives": made})
        return len(self.root["meshes"]) - 1

    def node(self, mesh, at=(0, 0, 0), turn=(0, 0, 0, 1), size=1.0):
        self.root["nodes"].append({"name": f"part{len(self.root['nodes'])}", "mesh": mesh, "translation": list(map(float, at)),
                                   "rotation": list(map(float, turn)), "scale": [float(size)] * 3})
        self.root["scenes"][0]["nodes"].append(len(self.root["nodes"]) - 1)

    def write(self, path):
        self.root["buffers"] = [{"byteLength": len(self.data)}]
        if self.used: self.root["extensionsUsed"] = sorted(self.used)
        text = json.dumps(self.root).encode()
        text += b" " * (-len(text) % 4)
        data = self.data + b"\0" * (-len(self.data) % 4)
        with open(path, "wb") as out:
            out.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)))
            out.write(struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data)


# ---- shapes: positions, normals, texture coordinates, triangles

def grid(f, across, down):
    """The shape of f(u, v) -> position; normals from its derivatives."""
    u, v = np.meshgrid(np.linspace(0, 1, across + 1), np.linspace(0, 1, down + 1))
    step = 1e-4
    at = f(u, v)
    n = np.cross(f(u + step, v) - f(u - step, v), f(u, v - step) - f(u, v + step))
    n /= np.maximum(np.linalg.norm(n, axis=-1, keepdims=True), 1e-30)
    k = (np.arange(down)[:, None] * (across + 1) + np.arange(across)).ravel()
    corners = np.concatenate([np.stack([k, k + across + 1, k + 1], 1), np.stack([k + 1, k + across + 1, k + across + 2], 1)])
    return at.reshape(-1, 3), n.reshape(-1, 3), np.stack([u, v], -1).reshape(-1, 2), corners


def sphere(radius=1.0, across=96, down=48):
    def at(u, v):
        a, b = 2 * np.pi * u, np.pi * v
        return np.stack([-np.cos(a) * np.sin(b), np.cos(b), np.sin(a) * np.sin(b)], -1)
    p, n, uv, corners = grid(at, across, down)
    p = np.round(p, 6)  # so that the seam and the poles are closed
    return radius * p, p, uv, corners


def blob(across=160, down=96):  # the ball of a helmet: no pole is in sight, and it is not convex
    def at(u, v):
        a, b = 2 * np.pi * u, np.pi * (0.02 + 0.96 * v)
        r = 1 + 0.12 * np.cos(3 * a) * np.sin(b) ** 2 + 0.1 * np.cos(4 * b)
        return (r * np.stack([-np.cos(a) * np.sin(b), np.cos(b), np.sin(a) * np.sin(b)], 0)).transpose(1, 2, 0)
    return grid(at, across, down)


def plate(width=2.0, height=2.0, repeat=1.0, mirror=False, waves=0.0, parts=1):
    def at(u, v):
        z = waves * np.sin(9 * u) * np.cos(7 * v)
        return np.stack([width * (u - 0.5), height * (0.5 - v), z], -1)
    p, n, uv, corners = grid(at, parts, parts)
    return p, n, uv * [-repeat if mirror else repeat, repeat], corners


def box():
    parts = []
    for axis in range(3):
        for way in (1, -1):
            p, n, uv, corners = plate(2, 2)
            x, y = (axis + 1) % 3, (axis + 2) % 3
            q, m = np.zeros_like(p), np.zeros_like(p)
            q[:, axis], q[:, x], q[:, y], m[:, axis] = way, p[:, 0] * way, p[:, 1], way
            parts.append((q, m, uv, corners))
    starts = np.cumsum([0] + [len(p[0]) for p in parts])
    return (*[np.concatenate([p[k] for p in parts]) for k in range(3)],
            np.concatenate([p[3] + s for p, s in zip(parts, starts)]))


# ---- pictures, as numbers from 0 to 1

def places(size=256):
    v, u = np.mgrid[0:size, 0:size]
    return (u + 0.5) / size, (v + 0.5) / size


def colored(*channels):
    return np.stack(np.broadcast_arrays(*channels), -1)


def normals_of(height, strength):
    """A normal map of a height that repeats: green goes up."""
    size = height.shape[0]
    x = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) * size / 2 * strength
    y = (np.roll(height, -1, 0) - np.roll(height, 1, 0)) * size / 2 * strength
    n = np.stack([-x, y, np.ones_like(x)], -1)
    return n / np.linalg.norm(n, axis=-1, keepdims=True) / 2 + 0.5


def checks(count, size=256):
    u, v = places(size)
    return (np.floor(u * count) + np.floor(v * count)) % 2


def domes(radius=0.4, count=4, size=256):
    """Parts of balls that cover the same discs; with the least radius they are halves."""
    u, v = places(size)
    x, y = u * count % 1 - 0.5, v * count % 1 - 0.5
    ground = np.sqrt(radius * radius - 0.16)
    return np.maximum(np.sqrt(np.maximum(radius * radius - x * x - y * y, 0)) - ground, 0) / count


# ---- models

def spheres():
    g, ball = Glb(), sphere(0.42)
    rows = [((1.0, 0.766, 0.336), 1), ((0.95, 0.95, 0.95), 1), ((0.8, 0.8, 0.8), 0), ((0.6, 0.03, 0.02), 0)]
    for j, (color, metal) in enumerate(rows):
        for i in range(6):
            g.node(g.mesh((ball, g.material(color, metal, i / 5))), (i - 2.5, 1.5 - j, 0))
    return g


def helmet():
    g = Glb()
    u, v = places()
    worn = 0.5 + 0.5 * np.sin(2 * np.pi * (3 * u + np.sin(2 * np.pi * v))) * np.cos(2 * np.pi * 2 * v)
    metal = np.clip(4 * (worn - 0.55), 0, 1)
    paint = colored(0.55 + 0 * u, 0.5 - 0.2 * worn, 0.25 + 0.2 * checks(8))
    color = paint + metal[..., None] * (np.array([0.8, 0.78, 0.75]) - paint)
    lamps = np.clip(8 * (np.sin(2 * np.pi * 4 * u) * np.sin(2 * np.pi * 6 * v) - 0.8), 0, 1)
    surface = colored(0.55 + 0.45 * np.cos(2 * np.pi * 8 * v) ** 2, 0.25 + 0.5 * (1 - metal) * (0.5 + 0.5 * worn), metal)
    material = g.material(metal=1, rough=1, pbr={
        "baseColorTexture": g.texture(color), "metallicRoughnessTexture": (orm := g.texture(surface))},
        normalTexture=g.texture(normals_of(0.02 * np.sin(2 * np.pi * 8 * u) * np.sin(2 * np.pi * 8 * v), 0.6)),
        occlusionTexture=orm, emissiveTexture=g.texture(colored(lamps, 0.4 * lamps, 0.05 * lamps)), emissiveFactor=[1, 1, 1])
    g.node(g.mesh((blob(), material)), size=1.75)
    return g


def coat():
    g, ball = Glb(), sphere(0.65)
    bases = [((0.5, 0.02, 0.02), 0, 0.6), ((0.02, 0.05, 0.3), 0, 1.0), ((0.9, 0.6, 0.2), 1, 0.5)]
    for j, (color, metal, rough) in enumerate(bases):
        for i, (much, blur) in enumerate([(0, 0), (0.5, 0.0), (1, 0.03), (1, 0.4)]):
            ext = {"clearcoat": {"clearcoatFactor": much, "clearcoatRoughnessFactor": blur}}
            g.node(g.mesh((ball, g.material(color, metal, rough, ext=ext))), (1.45 * (i - 1.5), 1.4 * (1 - j), 0))
    return g


def lamps():
    g, ball = Glb(), sphere(0.5)
    for i, strength in enumerate([0.5, 1, 2, 4]):
        m = g.material((0.1, 0.1, 0.1), 0, 0.5, ext={"emissive_strength": {"emissiveStrength": strength}},
                       emissiveFactor=[0.3, 0.12, 0.02])
        g.node(g.mesh((ball, m)), (1.3 * (i - 1.5), 1.1, 0))
    u, v = places()
    glow = np.clip(6 * np.sin(2 * np.pi * 3 * u) * np.sin(2 * np.pi * 3 * v) - 3, 0, 1)
    m = g.material((0.3, 0.3, 0.32), 0, 0.7, emissiveTexture=g.texture(colored(0.2 * glow, 0.8 * glow, glow)),
                   emissiveFactor=[1, 1, 1])
    g.node(g.mesh((box(), m)), (0, -0.8, 0), (0.13, 0.38, 0.05, 0.914), 0.75)
    return g


def normals(height=None):
    g = Glb()
    bumps = normals_of(domes() if height is None else height, 1.0)
    for i, (metal, rough) in enumerate([(0, 0.5), (1, 0.2), (1, 0.6)]):
        for j, mirror in enumerate([False, True]):
            m = g.material((0.75, 0.7, 0.65), metal, rough, normalTexture={**g.texture(bumps), "scale": 1.0})
            g.node(g.mesh((plate(1.6, 1.6, 1, mirror), m)), (1.9 * (i - 1), 0.9 - 1.8 * j, 0), (-0.1, 0.1, 0, 0.99))
    return g


def bumps():  # so flat that mirrors do not show what is behind them
    return normals(domes(0.75))


def glass(thick=True):
    g, ball = Glb(), sphere(0.6 if thick else 0.75)
    wall = g.material(metal=0, rough=0.9, pbr={"baseColorTexture": g.texture(colored(*[0.15 + 0.6 * checks(8)] * 3))})
    g.node(g.mesh((plate(7, 5), wall)), (0, 0, -1.5))
    for i, (rough, color) in enumerate([(0, (1, 1, 1)), (0.15, (1, 1, 1)), (0.35, (1, 1, 1)), (0, (0.4, 0.8, 0.5))]):
        ext = {"transmission": {"transmissionFactor": 1}, "ior": {"ior": 1.5}}
        if thick: ext["volume"] = {"thicknessFactor": 1.2}
        part = ball if thick else plate(1.3, 3.5)
        g.node(g.mesh((part, g.material(color, 0, rough, ext=ext))), (1.5 * (i - 1.5), 0, 0))
    return g


def panes():
    return glass(False)


def masks():
    g = Glb()
    u, v = places()
    rings = 0.5 + 0.5 * np.cos(2 * np.pi * 6 * np.hypot(u - 0.5, v - 0.5))
    leaf = g.texture(colored(0.2 + 0.3 * u, 0.5 + 0 * u, 0.15 + 0.3 * v, rings))
    for i, more in enumerate([{"alphaMode": "OPAQUE"}, {"alphaMode": "MASK"}, {"alphaMode": "MASK", "alphaCutoff": 0.8},
                              {"alphaMode": "BLEND"}]):
        m = g.material(metal=0, rough=0.8, pbr={"baseColorTexture": leaf}, doubleSided=True, **more)
        g.node(g.mesh((plate(1.35, 1.35), m)), (1.5 * (i - 1.5), 0.85, 0))
        m = g.material((0.8, 0.25, 0.2, (i + 1) / 4), 0, 0.4, doubleSided=True, alphaMode="BLEND")
        g.node(g.mesh((plate(1.35, 1.35), m)), (1.5 * (i - 1.5), -0.85, 0))
    return g


def many():  # one mesh of several materials
    g, parts = Glb(), []
    kinds = [((1.0, 0.766, 0.336), 1, 0.15), ((0.7, 0.05, 0.05), 0, 0.25), ((0.9, 0.9, 0.9), 0, 1.0), ((0.5, 0.55, 0.6), 1, 0.5)]
    for i, kind in enumerate(kinds):
        p, n, uv, corners = sphere(0.95)
        parts.append(((p + [2.1 * (i % 2 - 0.5), 2.1 * (0.5 - i // 2), 0], n, uv, corners), g.material(*kind)))
    g.node(g.mesh(*parts))
    return g


def cloth():
    g = Glb()
    for i, (color, sheen, rough) in enumerate([((0.1, 0.02, 0.15), (0.8, 0.5, 0.9), 0.3), ((0.02, 0.06, 0.2), (0.4, 0.6, 1), 0.5),
                                               ((0.2, 0.05, 0.02), (1, 1, 1), 0.8)]):
        ext = {"sheen": {"sheenColorFactor": sheen, "sheenRoughnessFactor": rough}}
        m = g.material(color, 0, 1, ext=ext)
        g.node(g.mesh((sphere(0.85), m)), (2 * (i - 1), 0.9, 0))
        g.node(g.mesh((plate(1.8, 1.6, waves=0.18, parts=60), m)), (2 * (i - 1), -1.0, 0), (-0.2, 0.05, 0, 0.98))
    return g


def tiles():  # the transform of textures, on boxes
    g, (u, v) = Glb(), places()
    signs = np.where((np.hypot(u - 0.3, v - 0.3) < 0.2)[..., None], [0.9, 0.2, 0.1],
                     colored(0.2 + 0.6 * u, 0.2 + 0.6 * v, 0.3 + 0.3 * checks(4)))
    picture = g.texture(signs)
    for i, how in enumerate([{}, {"scale": [2, 2], "offset": [0.25, 0.1]}, {"rotation": 0.5, "scale": [1.5, 1.5]}]):
        texture = {**picture, "extensions": {"KHR_texture_transform": how}} if how else picture
        m = g.material(metal=0, rough=0.6, pbr={"baseColorTexture": texture})
        g.node(g.mesh((box(), m)), (2.1 * (i - 1), 0, 0), (0.2, 0.35, 0.08, 0.91), 0.75)
    g.used.add("KHR_texture_transform")
    return g


def colors():
    g = Glb()
    p, n, uv, corners = sphere(1.25)
    paint = np.concatenate([0.5 + 0.5 * p / 1.25, np.ones((len(p), 1))], 1)
    for i, (metal, rough) in enumerate([(0, 0.6), (1, 0.4)]):
        g.node(g.mesh(((p, n, uv, corners), g.material((1, 1, 1), metal, rough), paint)), (2.8 * (i - 0.5), 0, 0))
    return g


MODELS = {f.__name__: f for f in (spheres, helmet, coat, lamps, normals, bumps, glass, panes, masks, many, cloth, tiles, colors)}


# ---- skies

def write_sky(path, light):
    """A Radiance picture of an array of light, height × width × 3."""
    most = np.maximum(light.max(-1), 1e-9)
    power = np.ceil(np.log2(most) + 1e-9)
    rgbe = np.concatenate([np.clip(light / 2.0 ** power[..., None] * 256, 0, 255), (power + 128)[..., None]], -1)
    with open(path, "wb") as out:
        out.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + f"-Y {light.shape[0]} +X {light.shape[1]}\n".encode())
        out.write(np.uint8(rgbe).tobytes())


def studio(height=256):
    """Soft boxes before a gradient, each of another colour, so that a turned sky shows."""
    v, u = (np.mgrid[0:height, 0:2 * height] + 0.5) / height
    up = np.cos(np.pi * v)
    x, z = np.sin(np.pi * v) * np.cos(np.pi * (u - 1)), np.sin(np.pi * v) * np.sin(np.pi * (u - 1))
    light = np.array([0.28, 0.3, 0.34]) + np.array([0.22, 0.24, 0.28]) * up[..., None]
    light = np.where(up[..., None] < 0, np.array([0.16, 0.13, 0.1]) * (1 + 0.5 * up[..., None]), light)
    for (ax, ay, az), wide, color in [((-1, 0.9, 1), 0.45, (6, 5.6, 5)), ((1.2, 0.3, 0.6), 0.3, (2.2, 3, 4.5)),
                                      ((0.6, 0.9, -1.2), 0.3, (3, 2, 1.2)), ((0, 1, 0), 0.3, (3, 3, 3))]:
        axis = np.array([ax, ay, az]) / np.linalg.norm([ax, ay, az])
        near = np.arccos(np.clip(x * axis[0] + up * axis[1] + z * axis[2], -1, 1))
        light = light + np.clip((wide - near) / 0.06 + 0.5, 0, 1)[..., None] * np.array(color)
    return light


SKIES = {"studio": studio, "even": lambda: np.full((64, 128, 3), 0.5)}
