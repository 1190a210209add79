"""Scenes made step by step: of points, of meshes held as arrays, and of shapes in the plane."""

from __future__ import annotations

import json
import os
import tempfile
import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy
import numpy.typing

from hottel._core import InputError, Scene, UsageError, read_scene

if TYPE_CHECKING:
    from hottel._core import Number

Array = numpy.typing.NDArray[Any]

__all__ = ["SceneBuilder"]


def _refusal(reason: str, surface: str) -> InputError:
    error = InputError(reason)
    error.reason, error.surface, error.file, error.line, error.hints = reason, surface, None, None, ()
    return error


def _numbers(array: Array, binary: bool) -> list[Any]:
    """Coordinates as a scene holds them: each float the shortest decimal of its own precision."""
    if array.dtype.kind == "f" and array.dtype.itemsize < 8 and not binary:
        return list(array.astype(str).tolist())
    return list(array.tolist())


def _array(values: Any, name: str) -> Array:
    try:
        return numpy.asarray(values)
    except ValueError:
        raise _refusal(f"mesh '{name}' has vertices that are not of one length", name) from None


def _vertices(values: Any, name: str) -> Array:
    array = _array(values, name)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"mesh '{name}': vertices are an array of real numbers, not of dtype {array.dtype}")
    if array.ndim != 2 or array.shape[1] != 3:
        raise _refusal(f"mesh '{name}' has vertices of the shape {array.shape}, not (n, 3)", name)
    return array


def _counted_faces(flat: Array, name: str) -> list[list[int]]:
    """Faces one after the other, each with the number of its corners before it."""
    faces, place = [], 0
    while place < len(flat):
        count = int(flat[place])
        if count < 0 or place + 1 + count > len(flat):
            raise _refusal(f"mesh '{name}' has a list of faces that breaks off", name)
        faces.append(flat[place + 1 : place + 1 + count].tolist())
        place += 1 + count
    return faces


def _parts(mesh: Any, name: str) -> tuple[Any, Any]:
    """Vertices and faces of a pair, or of an object of trimesh, pyvista or meshio, told by their attributes."""
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return mesh[0], mesh[1]
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return mesh.vertices, mesh.faces
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):
        faces = numpy.asarray(mesh.faces)
        return mesh.points, _counted_faces(faces, name) if faces.ndim == 1 else faces
    if hasattr(mesh, "points") and isinstance(getattr(mesh, "cells", None), (list, tuple)):
        flat = [block for block in mesh.cells if block.type in ("triangle", "quad", "polygon")]
        if len(flat) < len(mesh.cells):
            warnings.warn(f"mesh '{name}': cells that are no faces are passed over", stacklevel=3)
        return mesh.points, [face for block in flat for face in block.data]
    raise TypeError(f"mesh '{name}' is {type(mesh).__name__}: it is a pair of vertices and faces, or has .vertices or "
                    ".points, and .faces or .cells")


def _corners(face: Any, count: int, what: str, name: str) -> list[int]:
    indices = numpy.asarray(face)
    if indices.ndim != 1 or indices.dtype.kind not in "iu":
        raise TypeError(f"{what} of mesh '{name}' is a list of indices of vertices")
    if len(indices) < 3:
        raise _refusal(f"{what} of mesh '{name}' has {len(indices)} corners, where a face has three or more", name)
    if indices.min() < 0 or indices.max() >= count:
        raise _refusal(f"{what} of mesh '{name}' has a corner that is none of its {count} vertices", name)
    return list(indices.tolist())


class SceneBuilder:
    """Makes a scene step by step; build() returns it.

    SceneBuilder(dimension, *, binary=False). dimension: 2, the plane, or 3, space. Numbers are exact as those of a
    Scene: a float is its shortest decimal, a float of lower precision that of its own, with binary=True the double that
    it is. Every add_ and set_ returns the builder. What is wrong is told by build(), as by Scene(), unless said otherwise.

    >>> builder = hottel.SceneBuilder(2).add_material("grey", reflectivity=0.5)
    >>> scene = builder.add_polyline("room", [[0, 0], [0, 1], [2, 1], [0, 0]], "grey").build()
    >>> scene.names
    ('room[0]', 'room[1]', 'room[2]')
    """

    def __init__(self, dimension: Literal[2, 3], *, binary: bool = False) -> None:
        """Makes a builder of an empty scene. UsageError for another dimension."""
        if dimension not in (2, 3):
            raise UsageError(f"the dimension of a scene is 2 or 3, not {dimension!r}")
        self._binary = binary
        self._table: dict[str, Any] = {"dimension": dimension, "materials": {}}

    def _add(self, kind: str, dimension: int, entry: dict[str, Any]) -> SceneBuilder:
        if self._table["dimension"] != dimension:
            raise UsageError(f"{kind} are for scenes of dimension {dimension}")
        self._table.setdefault(kind, []).append(entry)
        return self

    def _set(self, key: str, value: Any) -> SceneBuilder:
        self._table[key] = value
        return self

    def add_material(self, name: str, **keys: Any) -> SceneBuilder:
        """Adds a material with the keys of a scene file: reflectivity and emission, or emissivity and temperature, ...

        UsageError where there is one of that name.
        """
        if name in self._table["materials"]:
            raise UsageError(f"there is a material '{name}' already")
        self._table["materials"][name] = keys
        return self

    def add_edge(self, name: str, start: Sequence[Number], end: Sequence[Number], material: str,
                 **keys: Any) -> SceneBuilder:
        """Adds an edge of the plane; its front is to the right of the way from start to end.

        keys: those of a scene file, such as back="grey", elements=4. UsageError in space.
        """
        return self._add("edges", 2, {"name": name, "points": [start, end], "material": material, **keys})

    def add_polyline(self, name: str, points: Sequence[Sequence[Number]], material: str, **keys: Any) -> SceneBuilder:
        """Adds a polyline of the plane: a room is listed clockwise, what stands in it counter-clockwise.

        keys: those of a scene file, such as closed=True, back="grey". UsageError in space.
        """
        return self._add("polylines", 2, {"name": name, "points": points, "material": material, **keys})

    def add_polygon(self, name: str, points: Sequence[Sequence[Number]], material: str, **keys: Any) -> SceneBuilder:
        """Adds a polygon of space; its front is where it goes counter-clockwise.

        keys: those of a scene file, such as holes, group="box", back="grey". UsageError in the plane.
        """
        return self._add("polygons", 3, {"name": name, "points": points, "material": material, **keys})

    def add_mesh(self, name: str, mesh: Any, material: str, *, triangulate: bool = False, **keys: Any) -> SceneBuilder:
        """Adds the faces of a mesh in space, name[0], name[1], ..., as one group.

        mesh: a pair (vertices, faces), or what has them, as meshes of trimesh, pyvista and meshio do: vertices of shape
        (n, 3), in units of the scene, and for each face the indices of its corners. triangulate: faces of more than
        three corners are cut into triangles from their first corner, as is right where they are convex. keys: of every
        face. TypeError for what is no mesh, InputError for indices of no vertex, UsageError in the plane.
        """
        values, faces = _parts(mesh, name)
        points = _numbers(_vertices(values, name), self._binary)
        lists = [_corners(face, len(points), f"face {k}", name) for k, face in enumerate(faces)]
        if triangulate:
            lists = [[face[0], face[k], face[k + 1]] for face in lists for k in range(1, len(face) - 1)]
        if not lists:
            raise _refusal(f"mesh '{name}' has no faces", name)
        for k, face in enumerate(lists):
            self.add_polygon(f"{name}[{k}]", [points[corner] for corner in face], material, group=name, **keys)
        return self

    def add_shape(self, name: str, shape: Any, material: str, *, front: Literal["inside", "outside"] = "inside",
                  **keys: Any) -> SceneBuilder:
        """Adds the lines of a shape of the plane: of shapely, or of whatever has a __geo_interface__.

        Polygons are rooms with solid holes, with front="outside" solid with courtyards, as those of a map. The lines
        are called name, or name.0, name.1, ... where there are several. keys: of every polyline. TypeError for what is
        no shape, InputError for one that no map holds, UsageError in space.
        """
        geometry = getattr(shape, "__geo_interface__", shape)
        if not isinstance(geometry, dict):
            raise TypeError(f"shape '{name}' is {type(shape).__name__}, which has no __geo_interface__")
        lines = self._lines_of(geometry, front)
        for k, line in enumerate(lines):
            closed = {"closed": True} if line.get("closed") else {}
            self.add_polyline(name if len(lines) == 1 else f"{name}.{k}", line["points"], material, **closed, **keys)
        return self

    @staticmethod
    def _lines_of(geometry: dict[str, Any], front: Literal["inside", "outside"]) -> list[dict[str, Any]]:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "shape.geojson")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(geometry, file)
            table = read_scene(path, front=front).to_dict()
        edges = [{"points": edge["points"]} for edge in table.get("edges", [])]
        return edges + list(table.get("polylines", []))

    def add_light(self, name: str, **keys: Any) -> SceneBuilder:
        """Adds a light with the keys of a scene file: type, position, power, direction, ..."""
        self._table.setdefault("lights", []).append({"name": name, **keys})
        return self

    def set_sky(self, **keys: Any) -> SceneBuilder:
        """Says what the sky sends out: emission [W/m2], or temperature [K]."""
        return self._set("sky", keys)

    def set_grid(self, **keys: Any) -> SceneBuilder:
        """Says where light is asked for, and nowhere else: min, max and cells, in space origin, u, v and cells."""
        return self._set("grid", keys)

    def add_grid(self, name: str, **keys: Any) -> SceneBuilder:
        """Adds one of several grids, with the keys that set_grid takes."""
        if not isinstance(self._table.get("grid"), list):
            self._table["grid"] = []
        self._table["grid"].append({"name": name, **keys})
        return self

    def set_camera(self, **keys: Any) -> SceneBuilder:
        """Says where pictures in space are taken from: eye, target, up, field_of_view, pixels."""
        return self._set("camera", keys)

    def set_closed(self, closed: bool = True) -> SceneBuilder:
        """Promises that no front with a material sees the sky."""
        return self._set("closed", closed)

    def set_unit(self, unit: str) -> SceneBuilder:
        """Says what coordinates are in: "m", "mm", "cm", "km", "in", "ft", or another name."""
        return self._set("unit", unit)

    def build(self) -> Scene:
        """Returns the scene. Throws as Scene() does."""
        return Scene(self._table, binary=self._binary)
