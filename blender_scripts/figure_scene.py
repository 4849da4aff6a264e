# SPDX-License-Identifier: GPL-3.0-or-later
"""A photo studio of its own: copies of the surface and its isolines, a camera, lights; gone without a trace after use.

Cycles on the processor, since it needs neither a display nor OpenGL.
"""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType

import bpy
import figure_materials
import numpy as np
from figure_views import View
from mathutils import Matrix, Vector
from numpy.typing import NDArray

_SAMPLES = 48
_NOISE = 0.02  # at which a pixel needs no more of them
_KEY = (-38, 38, 1.75, 25)  # degrees right of and above the viewer, strength, degrees across
_FILL = (48, 12, 0.55, 60)
_AMBIENT = 0.5
_LENS = 90.0
_MARGIN = 0.955  # of the picture that the surface may fill


class Studio:
    """Renders one surface, from several views and in several dresses. Use as a context manager."""

    def __init__(self, addon: ModuleType, obj: bpy.types.Object, width: int, height: int) -> None:
        self.scene = bpy.data.scenes.new("Figure")
        self._before = {kind: set(getattr(bpy.data, kind)) for kind in _KINDS}
        self._ink = figure_materials.ink(addon)
        self.surface = obj.copy()
        self.surface.data = obj.data.copy()
        self.surface.parent, self.surface.matrix_world = None, obj.matrix_world
        self.mesh = self.surface.data
        self.mesh.polygons.foreach_set("use_smooth", np.ones(len(self.mesh.polygons), bool))
        self.points = _world_points(self.surface)
        self.lines: bpy.types.Object | None = None
        self.scene.collection.objects.link(self.surface)
        self._set_up_render(width, height)
        self._camera = self._add("Camera", bpy.data.cameras.new("Figure"))
        self._camera.data.lens = _LENS
        self.scene.camera = self._camera
        self._lights = [(self._add("Light", _sun(*light[2:])), View(*light[:2])) for light in (_KEY, _FILL)]

    def __enter__(self) -> Studio:
        return self

    def __exit__(self, *_: object) -> None:
        bpy.data.scenes.remove(self.scene)
        for kind in _KINDS:
            blocks = getattr(bpy.data, kind)
            for block in set(blocks) - self._before[kind]:
                blocks.remove(block)

    def look(self, view: View) -> None:
        """Points the camera so that the surface fills the picture; the lights go along."""
        self._camera.data.lens, self._camera.data.shift_x, self._camera.data.shift_y = _LENS, 0, 0
        self._camera.rotation_euler = _facing(view)
        self.scene.view_layers[0].update()
        depsgraph = self.scene.view_layers[0].depsgraph
        self._camera.location, _ = self._camera.camera_fit_coords(depsgraph, self.points.ravel().tolist())
        self._camera.data.lens *= _MARGIN
        for light, offset in self._lights:
            light.rotation_euler = _facing(View(view.azimuth + offset.azimuth, view.elevation + offset.elevation))
        self.scene.view_layers[0].update()

    def zoom(self, spot: tuple[float, float], factor: float) -> None:
        """Enlarges the part of the picture around a spot of [0, 1]², without moving: what is seen stays the same."""
        render = self.scene.render
        longest = max(render.resolution_x, render.resolution_y)
        self._camera.data.lens *= factor
        self._camera.data.shift_x = (spot[0] - 0.5) * factor * render.resolution_x / longest
        self._camera.data.shift_y = (spot[1] - 0.5) * factor * render.resolution_y / longest

    def project(self, points: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Places (P, 2) in the picture, [0, 1]² from its lower left, and depths (P,) of world points (P, 3)."""
        render = self.scene.render
        depsgraph = self.scene.view_layers[0].depsgraph
        lens = self._camera.calc_matrix_camera(depsgraph, x=render.resolution_x, y=render.resolution_y)
        matrix = np.array(lens @ self._camera.matrix_world.inverted())
        clip = np.column_stack((points, np.ones(len(points)))) @ matrix.T
        return (clip[:, :2] / clip[:, 3:] + 1) / 2, clip[:, 3]

    def dress(self, material: bpy.types.Material) -> None:
        """Covers the whole surface with one material."""
        self.mesh.materials.clear()
        self.mesh.materials.append(material)
        for slot in self.surface.material_slots:
            slot.link = "DATA"

    def draw(self, curve: bpy.types.Object | None, thickness: float) -> None:
        """Draws a copy of the curve object in ink, `thickness` of the picture's height wide; nothing takes it away."""
        if self.lines:
            bpy.data.objects.remove(self.lines)
            self.lines = None
        if curve is None:
            return
        self.lines = curve.copy()
        self.lines.data = curve.data.copy()
        self.lines.parent, self.lines.matrix_world = None, self.surface.matrix_world
        self.lines.data.bevel_depth = thickness * self._height_seen() / 2 / max(self.surface.matrix_world.to_scale())
        self.lines.data.materials.clear()
        self.lines.data.materials.append(self._ink)
        self.scene.collection.objects.link(self.lines)

    def render(self) -> NDArray[np.float32]:
        """(h, w, 4) sRGB with alpha, not premultiplied, top row first."""
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "tile.png")
            self.scene.render.filepath = path
            with _silent():
                bpy.ops.render.render(write_still=True, scene=self.scene.name)
            image = bpy.data.images.load(path)
            pixels = np.empty(4 * image.size[0] * image.size[1], np.float32)
            image.pixels.foreach_get(pixels)
            pixels = pixels.reshape(image.size[1], image.size[0], 4)[::-1]
            bpy.data.images.remove(image)
        return pixels

    def _height_seen(self) -> float:
        """World units from the bottom of the picture to its top, at the middle of the surface."""
        middle = (self.points.min(axis=0) + self.points.max(axis=0)) / 2
        up = np.array(self._camera.matrix_world.to_3x3() @ Vector((0, 1, 0)))
        step = np.linalg.norm(np.ptp(self.points, axis=0)) / 100
        (low, high), _ = self.project(np.array([middle - step * up, middle + step * up]))
        return 2 * step / float(high[1] - low[1])

    def _set_up_render(self, width: int, height: int) -> None:
        scene, render = self.scene, self.scene.render
        render.engine = "CYCLES"
        render.resolution_x, render.resolution_y, render.resolution_percentage = width, height, 100
        render.film_transparent = True
        render.image_settings.file_format, render.image_settings.color_mode = "PNG", "RGBA"
        scene.view_settings.view_transform = "Standard"
        scene.cycles.device = "CPU"
        scene.cycles.samples, scene.cycles.use_denoising = _SAMPLES, False
        scene.cycles.use_adaptive_sampling, scene.cycles.adaptive_threshold = True, _NOISE
        scene.cycles.max_bounces = scene.cycles.diffuse_bounces = 1
        scene.cycles.glossy_bounces = 0
        scene.world = bpy.data.worlds.new("Figure")
        if bpy.app.version < (5, 0, 0):
            scene.world.use_nodes = True
        light = next(node for node in scene.world.node_tree.nodes if node.type == "BACKGROUND")
        light.inputs["Color"].default_value = (1, 1, 1, 1)
        light.inputs["Strength"].default_value = _AMBIENT

    def _add(self, name: str, data: bpy.types.ID) -> bpy.types.Object:
        obj = bpy.data.objects.new(name, data)
        self.scene.collection.objects.link(obj)
        return obj


_KINDS = ("objects", "meshes", "curves", "cameras", "lights", "worlds", "materials", "images")


@contextmanager
def _silent() -> Iterator[None]:
    """Without the line that Cycles prints for every step."""
    sys.stdout.flush()
    terminal = os.dup(1)
    with open(os.devnull, "wb") as nowhere:
        os.dup2(nowhere.fileno(), 1)
    try:
        yield
    finally:
        os.dup2(terminal, 1)
        os.close(terminal)


def _sun(strength: float, degrees: float) -> bpy.types.Light:
    light = bpy.data.lights.new("Figure", "SUN")
    light.energy, light.angle = strength, np.radians(degrees)
    return light


def _facing(view: View):
    """The rotation of a camera or light that looks from there."""
    return Matrix(view.frame().T.tolist()).to_euler()


def _world_points(obj: bpy.types.Object) -> NDArray[np.float64]:
    points = np.empty(3 * len(obj.data.vertices), np.float32)
    obj.data.vertices.foreach_get("co", points)
    matrix = np.array(obj.matrix_world)
    return points.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
