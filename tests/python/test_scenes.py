"""Scenes as dicts, files and pickles are the same scene."""

import copy
import fractions
import decimal
import json
import pickle
import warnings

import numpy
import pytest

import hottel
from conftest import SCENES

JSON = sorted(SCENES.glob("analytic/*.json")) + sorted(SCENES.glob("space/*.json")) + sorted(SCENES.glob("heat/*.json"))


def float_where_it_has_the_digits(text):
    exact = decimal.Decimal(text)
    return float(text) if decimal.Decimal(repr(float(text))) == exact else exact


@pytest.mark.parametrize("path", JSON, ids=lambda path: path.name)
def test_a_dict_is_its_file(path):
    table = json.loads(path.read_text(), parse_float=float_where_it_has_the_digits)
    assert hottel.Scene(table, path.parent) == hottel.read_scene(path)


@pytest.mark.parametrize("path", JSON, ids=lambda path: path.name)
def test_a_scene_is_its_dict_and_its_pickle(path):
    scene = hottel.read_scene(path)
    for same in (hottel.Scene(scene.to_dict()), pickle.loads(pickle.dumps(scene)), copy.deepcopy(scene)):
        assert same == scene
        assert hash(same) == hash(scene)
        assert same.names == scene.names


def test_numbers_are_exact(square):
    square["edges"][0]["points"][1][0] = 0.1
    as_float = hottel.Scene(square)
    for tenth in ("0.1", "1/10", fractions.Fraction(1, 10), decimal.Decimal("0.1"), numpy.float64(0.1)):
        square["edges"][0]["points"][1][0] = tenth
        assert hottel.Scene(square) == as_float
    square["edges"][0]["points"][1][0] = fractions.Fraction(0.1)
    assert hottel.Scene(square) != as_float
    binary = hottel.Scene(square)
    square["edges"][0]["points"][1][0] = 0.1
    square["materials"]["grey"]["reflectivity"] = "1/2"
    square["materials"]["warm"]["reflectivity"] = "0.2"
    assert hottel.Scene(square, binary=True) == binary


def test_arrays_and_integers_of_numpy_are_numbers(square):
    scene = hottel.Scene(square)
    square["polylines"][0]["points"] = numpy.array(square["polylines"][0]["points"])
    square["edges"][0]["points"][0] = (numpy.int32(2), numpy.float32(0))
    assert hottel.Scene(square) == scene


def test_a_scene_says_what_it_is(square):
    scene = hottel.Scene(square)
    assert (scene.dimension, len(scene), scene.closed, scene.unit) == (2, 4, False, "m")
    assert scene.names == ("floor", "walls[0]", "walls[1]", "walls[2]")
    assert set(scene.materials) == {"grey", "warm"}
    assert scene.channels == ("all",) and scene.lights == ()
    assert scene.points("floor").tolist() == [[2, 0], [0, 0]]
    assert "4 edges" in repr(scene) and "floor  warm" in repr(scene)
    with pytest.raises(hottel.UsageError, match="flor") as refused:
        scene.points("flor")
    assert "floor" in refused.value.hints[0]
    with pytest.raises(AttributeError):
        scene.names = ()


def test_polygons_have_their_corners():
    scene = hottel.read_scene(SCENES / "space/cube.json")
    assert scene.dimension == 3
    assert scene.points("floor").shape == (4, 3)


def test_surfaces_move_exactly(square):
    square["edges"].append({"name": "lamp", "material": "warm", "points": [[1, 0.5], [1.5, 0.5]]})
    scene = hottel.Scene(square)
    moved = scene.moved("lamp", (0.1, "1/3"))
    square["edges"][-1].update({"points": [["1.1", "5/6"], ["1.6", "5/6"]]})
    assert moved == hottel.Scene(square)
    assert moved.moved("lamp", ["-1/10", fractions.Fraction(-1, 3)]) == scene
    cube = hottel.read_scene(SCENES / "space/cube.json")
    assert cube.moved("*", (1, 0, 0)).points("floor")[0, 0] == cube.points("floor")[0, 0] + 1
    for vector, error in (((1,), hottel.UsageError), ((1, float("nan")), hottel.InputError), ((1, None), TypeError)):
        with pytest.raises(error):
            scene.moved("lamp", vector)
    with pytest.raises(hottel.UsageError):
        scene.moved("lmp", (0, 0))


def test_keys_are_replaced(square):
    scene = hottel.Scene(square)
    square["materials"]["grey"]["reflectivity"] = 0.25
    assert scene.replace(materials=square["materials"]) == hottel.Scene(square)
    closed = scene.replace(closed=True)
    assert closed.closed and not closed.replace(closed=None).closed
    with pytest.raises(hottel.InputError):
        scene.replace(colour="red")


def test_what_is_passed_over_is_told(tmp_path):
    (tmp_path / "map.wkt").write_text("POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0))\nPOINT (1 1)\n")
    with pytest.warns(UserWarning, match="point"):
        scene = hottel.read_scene(tmp_path / "map.wkt")
    assert len(scene) == 4
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(UserWarning):
            hottel.read_scene(tmp_path / "map.wkt")
        hottel.read_scene(SCENES / "drawings/hall.wkt")


def test_large_floats_are_their_shortest_decimals_too(square):
    square["edges"][0]["points"] = [[-4.95435087091941e17, 1e22], [1.2345678901234567e300, 0.1]]
    told = json.dumps(square)
    assert hottel.Scene(square) == hottel.Scene(json.loads(told, parse_float=decimal.Decimal))
    assert hottel.Scene(square) != hottel.Scene(square, binary=True)
