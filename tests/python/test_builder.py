"""Scenes made step by step, of meshes held as arrays, and of shapes."""

import inspect
import math
from fractions import Fraction
from types import SimpleNamespace

import numpy
import pytest

import hottel
from conftest import ROOT

CORNERS = [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]
SIDES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]  # outward
TRIANGLES = [[face[0], face[k], face[k + 1]] for face in SIDES for k in (1, 2)]


def space():
    return hottel.SceneBuilder(3).add_material("white", reflectivity=0.5)


def plane():
    return hottel.SceneBuilder(2).add_material("white", reflectivity=0.5)


def test_a_scene_made_in_steps_is_that_of_its_dict(square):
    builder = hottel.SceneBuilder(2)
    for name, keys in square["materials"].items():
        builder.add_material(name, **keys)
    builder.add_edge("floor", [2, 0], [0, 0], "warm").add_polyline("walls", square["polylines"][0]["points"], "grey")
    assert builder.build() == hottel.Scene(square)
    builder.set_sky(emission=2).set_unit("mm").set_closed().set_grid(min=[0, 0], max=[2, 1], cells=[4, 2])
    builder.add_light("lamp", type="point", position=[1, Fraction(1, 3)], power=5)
    scene = builder.build()
    assert (scene.unit, scene.closed, scene.lights) == ("mm", True, ("lamp",))
    assert scene.to_dict()["lights"][0]["position"] == [1, "1/3"]


@pytest.mark.parametrize("builder, place", [
    (plane, {"min": [0, 0], "max": [2, Fraction(1, 3)], "cells": [4, 2]}),
    (space, {"origin": [0, 0, 1], "u": [1, 0, 0], "v": [0, 1, 0], "cells": [4, 2]}),
])
def test_grids_are_one_or_several_with_names(builder, place):
    made = builder()
    if builder is plane:
        made.add_edge("wall", [0, 0], [1, 0], "white")
    else:
        made.add_polygon("wall", [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "white")
    made.set_grid(**place).add_grid("desk", **place).add_grid("floor", **place)
    assert [grid["name"] for grid in made.build().to_dict()["grid"]] == ["desk", "floor"]
    made.add_grid("desk", **place)
    with pytest.raises(hottel.InputError, match="two are called 'desk'"):
        made.build()
    assert "name" not in made.set_grid(**place).build().to_dict()["grid"]


def test_meshes_of_every_kind_are_the_same():
    flat = numpy.hstack([[len(face), *face] for face in SIDES])
    vertices = numpy.array(CORNERS, dtype=float)
    scenes = [space().add_mesh("box", mesh, "white").build() for mesh in (
        (vertices, SIDES), (CORNERS, numpy.array(SIDES)), [CORNERS, SIDES],
        SimpleNamespace(vertices=vertices, faces=numpy.array(SIDES)),
        SimpleNamespace(points=vertices.astype("float32"), faces=flat),
        SimpleNamespace(points=vertices, faces=flat, cells=None),
        SimpleNamespace(points=vertices, cells=[SimpleNamespace(type="quad", data=numpy.array(SIDES, dtype="uint64"))]))]
    assert all(scene == scenes[0] for scene in scenes)
    assert scenes[0].names == tuple(f"box[{k}]" for k in range(6))
    assert hottel.Simulation(scenes[0], per="group").factors.names[0] == "box"


def test_a_mesh_from_arrays_is_the_mesh_of_its_file(tmp_path):
    lines = [f"v {x} {y} {z}" for x, y, z in CORNERS] + ["g box"] + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in TRIANGLES]
    (tmp_path / "box.obj").write_text("\n".join(lines) + "\n")
    table = {"dimension": 3, "materials": {"white": {"reflectivity": 0.5}},
             "mesh": {"file": "box.obj", "material": "white"}}
    scene = space().add_mesh("box", (CORNERS, TRIANGLES), "white").build()
    from_file = hottel.Scene(table, tmp_path)
    assert scene.names == from_file.names
    a, b = hottel.Simulation(scene), hottel.Simulation(from_file)
    assert a.factors.factors.tobytes() == b.factors.factors.tobytes()
    assert space().add_mesh("box", (CORNERS, SIDES), "white", triangulate=True).build().names == scene.names


def test_floats_of_lower_precision_are_their_own_shortest_decimals():
    corners = numpy.array([[0, 0, 0.1], [1, 0, 0.1], [0, 1, 0.1]], dtype="float32")
    scene = space().add_mesh("m", (corners, [[0, 1, 2]]), "white").build()
    assert scene == space().add_mesh("m", (corners.astype(str).astype(float), [[0, 1, 2]]), "white").build()
    assert float(scene.points("m[0]")[0, 2]) == 0.1
    exact = hottel.SceneBuilder(3, binary=True).add_material("white").add_mesh("m", (corners, [[0, 1, 2]]), "white").build()
    assert float(exact.points("m[0]")[0, 2]) == float(numpy.float32(0.1))


def test_cells_that_are_no_faces_are_passed_over():
    blocks = [SimpleNamespace(type="line", data=[[0, 1]]), SimpleNamespace(type="triangle", data=[[0, 1, 3]])]
    with pytest.warns(UserWarning, match="passed over"):
        scene = space().add_mesh("m", SimpleNamespace(points=CORNERS, cells=blocks), "white").build()
    assert len(scene) == 1


def test_what_is_no_mesh():
    for mesh in (None, 3, "box", object(), SimpleNamespace(points=CORNERS), (CORNERS, [[0.5, 1, 2]]), (CORNERS, ["abc"]),
                 (numpy.zeros((3, 3), dtype=complex), [[0, 1, 2]]), (numpy.array([["a"] * 3] * 3), [[0, 1, 2]])):
        with pytest.raises(TypeError):
            space().add_mesh("m", mesh, "white")
    broken = SimpleNamespace(points=CORNERS, faces=numpy.array([3, 0, 1]))
    for mesh in ((CORNERS, [[0, 1, 8]]), (CORNERS, [[-1, 0, 1]]), (CORNERS, [[0, 1]]), (CORNERS, []), ([], [[0, 1, 2]]),
                 ([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]), ([[0, 0, 0], [1]], [[0, 1, 2]]), broken):
        with pytest.raises(hottel.InputError) as refused:
            space().add_mesh("m", mesh, "white")
        assert refused.value.surface == "m" and refused.value.reason and refused.value.hints == ()
    for vertices in ([[0, 0, math.nan], [1, 0, 0], [0, 1, 0]], [[0, 0, 0], [0, 0, 0], [0, 1, 0]]):
        with pytest.raises(hottel.InputError):
            space().add_mesh("m", (vertices, [[0, 1, 2]]), "white").build()


class Shape:
    """What looks like a shape of shapely."""

    def __init__(self, kind, coordinates):
        self.__geo_interface__ = {"type": kind, "coordinates": coordinates}


ROOM = (((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.0)),
        ((1.0, 1.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1.0), (1.0, 1.0)))


def test_a_shape_is_a_room_with_solid_holes():
    scene = plane().add_shape("room", Shape("Polygon", ROOM), "white").build()
    assert scene.names == tuple(f"room.{part}[{k}]" for part in (0, 1) for k in range(4))
    factors = hottel.Simulation(scene).factors
    rows = factors.factors.sum(axis=1)
    assert abs(rows[numpy.isfinite(factors.areas) & (rows > 0)] - 1).max() < 1e-12 and factors.factors[:, -1].max() == 0
    outside = plane().add_shape("room", Shape("Polygon", ROOM), "white", front="outside").build()
    assert hottel.Simulation(outside).factors.factors[:, -1].max() == 1


def test_shapes_of_lines():
    scene = plane().add_shape("way", Shape("LineString", ((0, 0), (1, 0.1), (2, 0))), "white", back="white").build()
    assert scene.names == ("way[0]", "way[1]") and scene.points("way[0]")[1, 1] == 0.1
    assert len(plane().add_shape("way", {"type": "LineString", "coordinates": [[0, 0], [1, 0]]}, "white").build()) == 1


def test_what_is_no_shape():
    for shape in (None, 3, "POINT (1 1)", [[0, 0], [1, 1]]):
        with pytest.raises(TypeError):
            plane().add_shape("s", shape, "white")
    for shape in (Shape("Blob", []), Shape("Polygon", []), Shape("LineString", [[0, 0]]), {}):
        with pytest.raises(hottel.InputError):
            plane().add_shape("s", shape, "white")
    with pytest.raises(hottel.UsageError):
        plane().add_shape("s", Shape("Polygon", ROOM), "white", front="above")


def test_what_a_dimension_has_not():
    for work in (lambda: space().add_edge("e", [0, 0], [1, 0], "white"), lambda: space().add_polyline("p", [], "white"),
                 lambda: plane().add_polygon("p", CORNERS[:3], "white"),
                 lambda: plane().add_mesh("m", (CORNERS, TRIANGLES), "white"),
                 lambda: space().add_shape("s", Shape("Polygon", ROOM), "white"), lambda: hottel.SceneBuilder(4),
                 lambda: plane().add_material("white")):
        with pytest.raises(hottel.UsageError):
            work()
    with pytest.raises(hottel.InputError):
        plane().add_edge("e", [0, 0], [1, 0], "grey").build()
    with pytest.raises(hottel.InputError):
        plane().add_edge("e", [0, 0], [1, 0], "white", colour="red").build()


def test_every_step_is_told():
    for name, member in vars(hottel.SceneBuilder).items():
        if not name.startswith("_"):
            assert len(inspect.getdoc(member)) > 20, name
    assert "add_mesh" in (ROOT / "docs/python.md").read_text()
