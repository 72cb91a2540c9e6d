#!/usr/bin/env python3
"""Opens what `lole export` wrote in other people's programs, and compares it with the take itself.

    pip install numpy usd-core bpy        # bpy is Blender as a module; what is missing is skipped
    lole export design.lole --format npz,pc2,mdd,obj,csv,usd,usdz --out OUT
    python3 tools/take_check.py OUT

The reference is dance.npz, read by NumPy. Of every file that is there, positions of every mesh at five frames
must agree within 0.1 mm: USD and USDZ by OpenUSD, which also validates them, and OBJ, PC2, MDD, USD and GLB by
Blender, each through its own importer and modifiers. Exit code 1 if anything differs.
"""
import csv
import importlib.util
import sys
from pathlib import Path

import numpy as np

LIMIT_MM = 0.1
FRAMES = 5
failures = []


def say(program, what, worst_mm):
    """One line, and a failure where it is worse than allowed."""
    fits = worst_mm <= LIMIT_MM
    print(f"{program:10} {what:44} {worst_mm:9.5f} mm {'ok' if fits else 'FAILED'}")
    if not fits:
        failures.append(f"{program} {what}")


def fail(program, what):
    print(f"{program:10} {what} FAILED")
    failures.append(f"{program} {what}")


class Take:
    """The arrays, as NumPy reads them."""

    def __init__(self, folder):
        self.arrays = np.load(folder / "dance.npz")
        self.names = [str(name) for name in self.arrays["mesh_names"]]
        self.count = len(self.arrays["times_s"])
        self.rate = float(self.arrays["frame_rate"])
        self.frames = sorted({round(f * (self.count - 1) / (FRAMES - 1)) for f in range(FRAMES)})
        self._positions = {name: self.arrays[f"{name}.positions"] for name in self.names}
        times = self.arrays["times_s"]
        assert np.allclose(times, np.arange(self.count) / self.rate), "times"

    def at(self, name, frame):
        return self._positions[name][frame]

    def worst(self, name, frame, found):
        """Largest distance [mm]; infinite where there are more or fewer points."""
        wanted = self.at(name, frame)
        found = np.asarray(found, dtype=float).reshape(-1, 3)
        if wanted.shape != found.shape:
            return float("inf")
        return 1000 * float(np.abs(wanted - found).max(initial=0.0))


def check_tables(folder, take):
    for name in take.names:
        path = folder / f"{name}.csv"
        if not path.exists():
            continue
        rows = {frame: [] for frame in take.frames}
        with open(path, newline="") as file:
            for row in csv.DictReader(file):
                frame = int(row["frame"])
                if frame in rows:
                    assert abs(float(row["time_s"]) - frame / take.rate) < 1e-5
                    rows[frame].append([float(row[f"{axis}_m"]) for axis in "xyz"])
        say("csv", path.name, max(take.worst(name, f, rows[f]) for f in take.frames))


def check_usd(folder, take):
    from pxr import Usd, UsdGeom, UsdShade

    for path in [folder / "dance.usdc", folder / "dance.usdz"]:
        if not path.exists():
            continue
        stage = Usd.Stage.Open(str(path))
        facts = (UsdGeom.GetStageUpAxis(stage), UsdGeom.GetStageMetersPerUnit(stage))
        if facts != ("Y", 1.0) or stage.GetTimeCodesPerSecond() != take.rate:
            fail("OpenUSD", f"{path.name}: {facts}, {stage.GetTimeCodesPerSecond()}")
        if stage.GetEndTimeCode() - stage.GetStartTimeCode() != take.count - 1:
            fail("OpenUSD", f"{path.name}: time codes")
        worst, triangles, bound = 0.0, 0, 0
        for name in take.names:
            mesh = UsdGeom.Mesh(stage.GetPrimAtPath(f"/dance/{name}"))
            for frame in take.frames:
                worst = max(worst, take.worst(name, frame, mesh.GetPointsAttr().Get(frame)))
                normals = np.asarray(mesh.GetNormalsAttr().Get(frame)).reshape(-1, 3)
                if not np.allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-3):
                    fail("OpenUSD", f"{path.name} {name}: normals")
            corners = np.asarray(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)
            triangles += int((corners != take.arrays[f"{name}.triangles"]).sum())
            prims = UsdShade.MaterialBindingAPI(mesh).GetMaterialBindSubsets() or [mesh]
            for prim in prims:
                material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
                bound += bool(material and material.ComputeSurfaceSource()[0])
        say("OpenUSD", f"{path.name}, {bound} bound materials", worst)
        if triangles:
            fail("OpenUSD", f"{path.name}: {triangles} corners differ")
        validate(stage, path.name)


def validate(stage, name):
    from pxr import UsdValidation

    registry = UsdValidation.ValidationRegistry()
    validators = registry.GetOrLoadAllValidators()
    errors = UsdValidation.ValidationContext(validators).Validate(stage)
    for error in errors:
        fail("OpenUSD", f"{name}: {error.GetName()}: {error.GetMessage()}")
    print(f"{'OpenUSD':10} {name}: {len(validators)} validators, {len(errors)} findings")


class Blender:
    """Blender's importers. It has +Z up and the front at -Y, so (x, y, z) of a file becomes (x, -z, y)."""

    def __init__(self):
        import bpy

        self.bpy = bpy

    def clear(self, rate):
        self.bpy.ops.wm.read_factory_settings(use_empty=True)
        self.bpy.context.scene.render.fps = int(rate)

    def points(self, thing):
        """World positions of an object as it is evaluated in the present frame, in the axes of the file."""
        seen = thing.evaluated_get(self.bpy.context.evaluated_depsgraph_get())
        mesh = seen.to_mesh()
        flat = np.empty(3 * len(mesh.vertices), dtype=np.float32)
        mesh.vertices.foreach_get("co", flat)
        matrix = np.array(seen.matrix_world)
        seen.to_mesh_clear()
        world = flat.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
        return np.stack([world[:, 0], world[:, 2], -world[:, 1]], axis=1)

    def named(self, name):
        return self.bpy.data.objects.get(name)

    def check_obj(self, folder, take):
        width = max(4, len(str(take.count)))
        worst = 0.0
        for frame in take.frames:
            path = folder / f"dance_{frame:0{width}}.obj"
            if not path.exists():
                return
            self.clear(take.rate)
            self.bpy.ops.wm.obj_import(filepath=str(path))
            for name in take.names:
                worst = max(worst, self.worst(take, name, frame))
        say("Blender", "dance_NNNN.obj", worst)
        pictures = [image.filepath for image in self.bpy.data.images if image.size[0]]
        print(f"{'Blender':10} OBJ: {len(self.bpy.data.materials)} materials, {len(pictures)} pictures")

    def check_cache(self, folder, take, kind):
        paths = {name: folder / f"{name}.{kind}" for name in take.names}
        if not all(path.exists() for path in paths.values()):
            return
        worst = 0.0
        for name, path in paths.items():
            self.clear(take.rate)
            self.bpy.ops.wm.obj_import(filepath=str(folder / f"{name}.obj"))
            thing = self.named(name)
            if thing is None:
                continue
            cache = thing.modifiers.new("dance", "MESH_CACHE")
            cache.cache_format, cache.filepath = kind.upper(), str(path)
            cache.play_mode, cache.frame_start = "SCENE", 0
            cache.forward_axis, cache.up_axis = "POS_Y", "POS_Z"
            for frame in take.frames:
                self.bpy.context.scene.frame_set(frame)
                worst = max(worst, self.worst(take, name, frame))
        say("Blender", f"NAME.{kind}", worst)

    def check_usd(self, folder, take, name):
        path = folder / name
        if not path.exists():
            return
        self.clear(take.rate)
        self.bpy.ops.wm.usd_import(filepath=str(path), set_frame_range=True)
        self.compare_frames(take, name)

    def check_glb(self, folder, take):
        """What moves by itself, at keys alone: between them viewers draw a straight line."""
        path = folder / "dance.glb"
        if not path.exists():
            return
        self.clear(take.rate)
        self.bpy.ops.import_scene.gltf(filepath=str(path), merge_vertices=False)
        worst = {}
        for name in take.names:
            thing = self.named(name)
            if thing is None or thing.type != "MESH" or name == "dancer":
                continue
            keys = thing.data.shape_keys
            count = len(keys.key_blocks) if keys else take.count
            stride = max(1, round(take.count / count))
            for frame in take.frames:
                frame -= frame % stride
                self.bpy.context.scene.frame_set(frame)
                worst[name] = max(worst.get(name, 0.0), self.worst(take, name, frame))
            what = f"dance.glb {name}"
            if keys:
                say("Blender", f"{what}, {count} keys", worst[name])
            else:
                print(f"{'Blender':10} {what + ', on bones':44} {worst[name]:9.5f} mm, stated by lole")

    def compare_frames(self, take, what, shift=0):
        worst = 0.0
        for frame in take.frames:
            self.bpy.context.scene.frame_set(frame + shift)
            for name in take.names:
                worst = max(worst, self.worst(take, name, frame))
        say("Blender", what, worst)

    def worst(self, take, name, frame):
        thing = self.named(name)
        if thing is None or thing.type != "MESH":
            # Importers leave out what has no vertex.
            return float("inf") if len(take.at(name, frame)) else 0.0
        return take.worst(name, frame, self.points(thing))


def main():
    folder = Path(sys.argv[1])
    take = Take(folder)
    print(f"{take.count} frames, {take.rate:g} a second, {len(take.names)} meshes, frames {take.frames}")
    check_tables(folder, take)
    if importlib.util.find_spec("pxr"):
        check_usd(folder, take)
    else:
        print("skipped: no OpenUSD here (pip install usd-core)")
    if importlib.util.find_spec("bpy"):
        blender = Blender()
        blender.check_obj(folder, take)
        blender.check_cache(folder, take, "pc2")
        blender.check_cache(folder, take, "mdd")
        blender.check_glb(folder, take)
        for name in ["dance.usdc", "dance.usdz"]:
            blender.check_usd(folder, take, name)
    else:
        print("skipped: no Blender here (pip install bpy)")
    for failure in failures:
        print(f"FAILED: {failure}")
    sys.exit(bool(failures))


main()
