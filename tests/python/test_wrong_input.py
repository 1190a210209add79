"""Whatever is wrong is refused by the exception that is documented, and nothing crashes."""

import decimal
import math
import re

import numpy
import pytest

import hottel
from conftest import SCENES


@pytest.fixture
def simulation(square):
    return hottel.Simulation(hottel.Scene(square))


@pytest.mark.parametrize(
    "number", [math.nan, math.inf, -math.inf, pytest.param(10**5000, id="long"), decimal.Decimal("NaN"), decimal.Decimal("Infinity"),
               numpy.float64("nan"), "wide", "1/0", True, "", None]
)
def test_coordinates_that_are_no_numbers(square, number):
    square["edges"][0]["points"][0][0] = number
    with pytest.raises((hottel.InputError, TypeError)):
        hottel.Scene(square)


def test_the_place_of_a_wrong_number_is_told(square):
    square["edges"][0]["points"][0][0] = math.nan
    with pytest.raises(hottel.InputError, match=r"edges\[0\]\.points\[0\]\[0\]"):
        hottel.Scene(square)
    square["edges"][0]["points"][0][0] = {1, 2}
    with pytest.raises(TypeError, match=r"edges\[0\]\.points\[0\]\[0\] is set"):
        hottel.Scene(square)


@pytest.mark.parametrize(
    "table", [{}, {"dimension": 4}, {"dimension": 2, "edges": {}}, {"dimension": 2, "edges": 3},
              {"dimension": 2, "edges": [[]]}, {"\udc80": 1}, {"dimension": 2, "unknown": 1}]
)
def test_dicts_that_are_no_scene(table):
    with pytest.raises(hottel.InputError) as refused:
        hottel.Scene(table)
    assert refused.value.reason and refused.value.file is None and refused.value.line is None


def test_what_is_no_dict(square):
    for wrong in (None, 3, [], "text", b"bytes", object()):
        with pytest.raises(TypeError):
            hottel.Scene(wrong)
    with pytest.raises(TypeError):
        hottel.Scene({1: 2})
    square["edges"].append(square)
    with pytest.raises(hottel.InputError, match="nested too deep"):
        hottel.Scene(square)


def test_a_wrong_surface_is_named(square):
    square["edges"][0]["points"][1] = square["edges"][0]["points"][0]
    with pytest.raises(hottel.InputError) as refused:
        hottel.Scene(square)
    assert refused.value.surface == "floor"
    assert refused.value.reason == str(refused.value) == "edge 'floor' has length zero"


def test_files_of_a_dict_are_found_in_its_folder():
    meshes = {"dimension": 3, "materials": {"foil": {}},
              "mesh": {"name": "bus", "file": "satellite_bus.stl", "material": "foil"}}
    with pytest.raises(hottel.InputError) as refused:
        hottel.Scene(meshes, SCENES)
    assert "satellite_bus.stl" in str(refused.value)
    assert len(hottel.Scene(meshes, SCENES / "heat")) > 6
    with pytest.raises(hottel.InputError) as refused:
        hottel.Scene({"dimension": 3, "colour": 1}, SCENES)
    assert refused.value.file is None and refused.value.line is None


def test_a_wrong_file_is_named(tmp_path):
    path = SCENES / "degenerate/refused/zero_length_edge.json"
    with pytest.raises(hottel.InputError) as refused:
        hottel.read_scene(path)
    assert refused.value.file == str(path) and refused.value.line == 12 and refused.value.surface == "point"
    assert isinstance(refused.value, hottel.Error) and isinstance(refused.value, ValueError)
    for text in ("", "{", "\0\xff", "[" * 5000):
        (tmp_path / "scene.json").write_text(text, encoding="latin-1")
        with pytest.raises(hottel.InputError):
            hottel.read_scene(tmp_path / "scene.json")
    with pytest.raises(hottel.InputError):
        hottel.read_scene(tmp_path / "none.json")
    with pytest.raises(hottel.UsageError):
        hottel.read_scene(path, front="above")
    with pytest.raises(TypeError):
        hottel.read_scene(3)


@pytest.mark.parametrize(
    "points", [[[math.nan, 0]], [[0, math.inf]], [[1, 2], [3]], [1, 2], [[1, 2, 3]], [[[1, 2]]], 3.0, None]
)
def test_points_that_are_none(simulation, points):
    for ask in (simulation.light, simulation.visible):
        with pytest.raises((hottel.InputError, TypeError)):
            ask(points)


@pytest.mark.parametrize("dtype", ["U5", "complex128", "bool", "O", "datetime64[s]", "longdouble"])
def test_points_of_another_dtype(simulation, dtype):
    with pytest.raises(TypeError):
        simulation.light(numpy.zeros((2, 2), dtype="int64").astype(dtype))


@pytest.mark.parametrize("dtype", ["float64", "float32", "float16", "int64", "int8", "uint8", ">f8"])
def test_points_of_any_real_dtype_and_layout(simulation, dtype):
    points = numpy.array([[1, 0.5], [0.5, 0.25], [1.5, 0.75]]).astype(dtype)
    assert (simulation.light(points) == simulation.light(points.tolist())).all()
    assert (simulation.light(points[::-1]) == simulation.light(points)[::-1]).all()
    assert (simulation.light(numpy.asfortranarray(points)) == simulation.light(points)).all()


def test_no_points_and_far_points(simulation):
    assert simulation.light([]).shape == simulation.light(numpy.zeros((0, 2))).shape == (0, 1)
    assert len(simulation.visible([])) == 0
    assert simulation.light([[1e300, -1e300], [5e-324, 0.5], [1e308, 1e308]]).shape == (3, 1)
    assert len(simulation.visible([[1e300, -1e300], [5e-324, 0.5]])) == 2
    cube = hottel.Simulation(hottel.read_scene(SCENES / "space/cube.json"))
    assert cube.light([[1e300, -1e300, 1e300], [5e-324, 0.5, 0.5]]).shape == (2, 1)
    assert cube.light([]).shape == (0, 1)


@pytest.mark.parametrize(
    "options",
    [{"elements": 0}, {"elements": -1}, {"elements": 10**7}, {"element_size": 0}, {"element_size": -1},
     {"element_size": "1e-30"}, {"element_size": math.nan}, {"elements": 2, "element_size": 1}, {"per": "wall"},
     {"method": "guess"}, {"method": "gauss:-1"}, {"solver": "guess"}, {"iterations": 0}, {"until": 0},
     {"until": math.nan}, {"solver": "cholesky", "iterations": 5}, {"tolerance": 1e-6}, {"sky": "closure"},
     {"guarantee": "enclosed"}, {"threads": 0}, {"threads": -1}, {"threads": 10**6}, {"memory": 0}, {"memory": -1},
     {"simulate": "some"}, {"method": "gauss:4", "memory": 100}]
)
def test_options_that_make_no_sense(square, options):
    with pytest.raises((hottel.UsageError, hottel.InputError)):
        hottel.Simulation(hottel.Scene(square), **options)


@pytest.mark.parametrize(
    "options", [{"elements": 1.5}, {"elements": "2"}, {"elements": 10**30}, {"progress": 3}, {"threads": 1.5},
                {"method": 3}, {"unknown": 1}, {"element_size": []}, {"tolerance": "small"}]
)
def test_options_of_another_type(square, options):
    with pytest.raises(TypeError):
        hottel.Simulation(hottel.Scene(square), **options)


def test_a_simulation_is_of_a_scene(square):
    for wrong in (None, square, "scene.json"):
        with pytest.raises(TypeError):
            hottel.Simulation(wrong)


@pytest.mark.parametrize("tolerance", [0, -1, math.nan, math.inf])
def test_tolerances_in_space_are_positive(tolerance):
    with pytest.raises(hottel.UsageError):
        hottel.Simulation(hottel.read_scene(SCENES / "space/cube.json"), tolerance=tolerance)


def test_requests_that_cannot_be_met(square):
    square["closed"] = True
    square["edges"][0]["points"][1] = [0.5, 0]
    with pytest.raises(hottel.RequestError, match="closed") as refused:
        hottel.Simulation(hottel.Scene(square)).factors
    assert isinstance(refused.value, RuntimeError) and not isinstance(refused.value, ValueError)
    with pytest.raises(hottel.RequestError, match="the limit is 1.0 kB"):
        hottel.Simulation(hottel.read_scene(SCENES / "showcase/museum.json"), memory=1000).factors


def test_names_that_there_are_not(simulation):
    for ask in (lambda: simulation.factors["floor", "celing"], lambda: simulation.factors["sky", "floor"],
                lambda: simulation.factors.index("x"), lambda: simulation.radiosity["x"],
                lambda: simulation.radiosity.index("sky"), lambda: simulation.factors.to_names("x"),
                lambda: simulation.exact_form("x", "floor"), lambda: simulation.exact_form("sky", "floor"),
                lambda: simulation.factors.from_names("x"), lambda: simulation.factors.to_scipy("colour"),
                lambda: simulation.factors.arrays("colour")):
        with pytest.raises(hottel.UsageError):
            ask()
    for key in ("floor", ("floor",), 3, None, ("a", 1)):
        with pytest.raises(TypeError):
            simulation.factors[key]
    seen = simulation.visible([[1, 0.5]])
    for place in (1, -2, 10**9):
        with pytest.raises(IndexError):
            seen[place]


def test_what_space_has_not():
    simulation = hottel.Simulation(hottel.read_scene(SCENES / "space/cube.json"))
    with pytest.raises(hottel.UsageError, match="in the plane"):
        simulation.visible([[0.5, 0.5, 0.5]], range=1)
    for points in ([[0, 0]], [[math.nan, 0, 0]], 3.0):
        with pytest.raises((hottel.InputError, TypeError)):
            simulation.visible(points)
    seen = simulation.visible([[0.5, 0.5, 0.5]])
    for place in (1, -2, 10**9):
        with pytest.raises(IndexError):
            seen[place]
        with pytest.raises(IndexError):
            seen.pieces(place)
    with pytest.raises(hottel.UsageError, match="sky"):
        simulation.exact_form("floor", "sky")
    boxes = hottel.Simulation(hottel.read_scene(SCENES / "space/two_boxes.json"))
    with pytest.raises(hottel.RequestError, match="something hides"):
        boxes.exact_form("floor", "ceiling")
    with pytest.raises(hottel.UsageError, match="dimension"):
        simulation.with_scene(hottel.read_scene(SCENES / "analytic/hexagon.json"))


def test_grids_that_are_none(simulation):
    for cells in ((0, 1), (1, 0), (-1, 2), (20000, 1), (10**30, 1), (1,), (1, 2, 3)):
        with pytest.raises(hottel.UsageError):
            simulation.grid(cells)
    for cells in (3, "ab", (1.5, 2), (True, 2), ("1", "2"), {1: 2}):
        with pytest.raises(TypeError):
            simulation.grid(cells)
    for over in ({}, {"min": [0, 0], "max": [0, 0], "cells": [2, 2]}, {"min": [0, 0], "max": [math.nan, 1]}):
        with pytest.raises(hottel.InputError):
            simulation.grid(over=over)
    for options in ({"show": "light"}, {"show": "net"}, {"show": "x"}, {"illumination": "some"}, {"channel": "r"},
                    {"show": "irradiance", "channel": "r"}, {"show": "temperature"},
                    {"show": "sky", "illumination": "inverse-square"}):
        with pytest.raises(hottel.UsageError):
            simulation.grid((2, 2), **options)
    space = hottel.Simulation(hottel.read_scene(SCENES / "space/cube.json"))
    for options in ({}, {"cells": (2, 2)}, {"illumination": "average"}):
        with pytest.raises(hottel.UsageError):
            space.grid(**options)
    with pytest.raises(hottel.RequestError, match="memory"):
        hottel.Simulation(simulation.scene, memory=1000).grid((100, 100))


def test_pictures_that_cannot_be_had(simulation, tmp_path):
    for options in ({"show": "x"}, {"show": "factor:nowhere"}, {"size": -1}, {"size": 10**6}, {"tone": "blue"},
                    {"exposure": 0}, {"exposure": math.inf}, {"shading": "x"}, {"shading": "smooth"},
                    {"show": "net", "shading": "gathered"}, {"contours": -1}, {"outlines": True},
                    {"show": "net", "bar": "a:b"}, {"show": "net", "tone": "max"}, {"show": "net", "contours": 3},
                    {"of": "grid"}, {"channel": "r"}, {"show": "net", "size": 10}):
        with pytest.raises(hottel.UsageError):
            simulation.picture(**options)
    space = hottel.Simulation(hottel.read_scene(SCENES / "space/cube.json"))
    for options in ({"of": "grid", "outlines": True}, {"contours": 2}, {"cells": (2, 2)}, {"of": "room"}, {"of": "grid"},
                    {"illumination": "average"}):
        with pytest.raises(hottel.UsageError):
            space.picture(**options)
    with pytest.raises(hottel.UsageError):
        space.scene.picture(axes=True)
    picture = simulation.scene.picture()
    with pytest.raises(hottel.UsageError):
        picture.file("gif")
    with pytest.raises(hottel.UsageError):
        picture.save(tmp_path / "picture.gif")
    with pytest.raises(OSError):
        picture.save(tmp_path / "nowhere" / "picture.png")


def test_normals_that_are_none(simulation):
    points = [[1, 0.5], [0.5, 0.5]]
    for normals in ([0, 0], [[1, 0], [0, 0]], [[1, 0, 0]], [1, 2, 3], [[math.nan, 1]], [[1, 2], [3]]):
        with pytest.raises(hottel.InputError):
            simulation.light_on(points, normals)
    with pytest.raises(hottel.UsageError, match="2 points and 3 normals"):
        simulation.light_on(points, [[0, 1]] * 3)
    for normals in ("up", None, [[1j, 0]]):
        with pytest.raises(TypeError):
            simulation.light_on(points, normals)
    assert len(simulation.light_on([], [0, 1])) == len(simulation.light_on([], [])) == 0


def test_messages_name_arguments_and_no_options_of_the_program(square):
    coloured = hottel.read_scene(SCENES / "showcase/museum.json")
    asks = [lambda: hottel.Simulation(coloured).script_f(), lambda: hottel.Simulation(coloured).picture("irradiance", channel="x"),
            lambda: hottel.Simulation(hottel.Scene(square)).picture("irradiance", channel="r"),
            lambda: hottel.Simulation(hottel.Scene(square)).picture("irradiance", bar="wide"),
            lambda: hottel.Simulation(hottel.Scene(square)).picture("temperature"),
            lambda: hottel.generate("clutter", n=0), lambda: hottel.generate("lattice", n=10, digits=500),
            lambda: hottel.generate("lattice", n=10, bottoms=False), lambda: hottel.generate("clutter", n=10, length=100)]
    said = []
    for ask in asks:
        with pytest.raises(hottel.Error) as refused:
            ask()
        said.append(str(refused.value))
        assert not re.search(r"(^|\s|`)--[a-z]", said[-1]), said[-1]
    words = " ".join(said)
    for word in ("channel", "bar", "show", "digits", "length"):
        assert word in words


def test_plans_and_findings_name_arguments():
    plan = hottel.Simulation(hottel.read_scene(SCENES / "lights/lighthouse.json")).plan
    reasons = " ".join(effect.reason + repr(effect) for effect in plan)
    assert "light_levels" in reasons and "--" not in reasons
    scene = hottel.read_scene(SCENES / "space/room_six_digits.json")
    suggestions = " ".join(finding.suggestion for finding in scene.check())
    assert "fixed(" in suggestions and "--" not in suggestions


def test_critical_points_of_what_has_none(simulation):
    for a, b in (("floor", "nobody"), ("nobody", "floor"), ("sky", "floor")):
        with pytest.raises(hottel.UsageError):
            simulation.critical_points(a, b)
    cube = hottel.Simulation(hottel.read_scene(SCENES / "space/cube.json"))
    for ask in (cube.critical_lines, lambda: cube.critical_points("floor", "ceiling")):
        with pytest.raises(hottel.UsageError, match="in the plane"):
            ask()
    for ask in (lambda: simulation.faces_seen_by("floor"), lambda: simulation.event_surfaces("floor", "ceiling")):
        with pytest.raises(hottel.UsageError, match="in space"):
            ask()
    for ask in (lambda: cube.faces_seen_by("sky"), lambda: cube.event_surfaces("floor", "sky"),
                lambda: cube.faces_seen_by("nobody")):
        with pytest.raises(hottel.UsageError):
            ask()
    far = hottel.Scene({"dimension": 2, "materials": {"m": {}}, "edges": [
        {"name": name, "material": "m", "points": [[0, y], ["1e400", y]]} for name, y in (("a", 0), ("b", 1))]})
    with pytest.raises(hottel.RequestError, match="range of doubles"):
        hottel.Simulation(far).critical_lines()
