"""Pictures: pixels, files, and what a notebook shows."""

import struct
import zlib

import numpy
import pytest

import hottel
from conftest import SCENES

PLANE, SPACE = SCENES / "analytic/square_radiosity.json", SCENES / "space/cube.json"


def unpacked(png):
    """The pixels of a PNG whose rows are each less the one above."""
    width, height, *kind = struct.unpack(">IIBBBBB", png[16:33 - 4])
    assert kind == [8, 2, 0, 0, 0]
    place, packed = 8, b""
    while place < len(png):
        length, name = struct.unpack(">I4s", png[place:place + 8])
        packed += png[place + 8:place + 8 + length] if name == b"IDAT" else b""
        place += length + 12
    rows = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).reshape(height, 1 + 3 * width)
    assert (rows[:, 0] == 2).all()
    return numpy.add.accumulate(rows[:, 1:], axis=0, dtype=numpy.uint8).reshape(height, width, 3)


@pytest.mark.parametrize("scene", [PLANE, SPACE], ids=["plane", "space"])
def test_pixels_are_those_of_the_file(scene):
    simulation = hottel.Simulation(hottel.read_scene(scene))
    for picture in (simulation.picture(size=240), simulation.picture("radiosity", size=240), simulation.scene.picture(size=240)):
        assert picture.pixels.dtype == numpy.uint8 and abs(picture.pixels.shape[1] - 240) < 30
        assert (picture.pixels == unpacked(picture.file())).all()
        assert picture.pixels.std() > 5  # something is drawn
        with pytest.raises(ValueError):
            picture.pixels[0, 0] = 0
        with pytest.raises(ValueError):
            picture.pixels.flags.writeable = True


def test_a_notebook_shows_plans_as_shapes_and_views_as_pixels():
    plane, space = hottel.read_scene(PLANE), hottel.read_scene(SPACE)
    assert plane._repr_svg_().startswith("<?xml") and plane._repr_png_() is None
    assert space._repr_png_().startswith(b"\x89PNG") and space._repr_svg_() is None
    assert plane.picture()._repr_png_() == plane.picture().file("png")


def test_a_scene_in_the_dark_is_shown_all_the_same():
    table = hottel.read_scene(SPACE).to_dict()
    for material in table["materials"].values():
        material.pop("emission", None)
    assert hottel.Scene(table).picture(size=100).pixels.std() > 5


def test_files_end_as_they_are():
    picture = hottel.read_scene(PLANE).picture(size=300)
    assert picture.file("svg").startswith(b"<?xml") and picture.file("pdf").startswith(b"%PDF")
    assert picture.file("svg") is not None and picture.file("svg") == picture.file("svg")


def test_the_light_of_a_grid_is_drawn_with_square_pixels():
    over = {"origin": [0, 0, "1/2"], "u": [1, 0, 0], "v": [0, "1/2", 0], "cells": [4, 2]}
    picture = hottel.Simulation(hottel.read_scene(SPACE)).picture(of="grid", over=over, size=40)
    assert picture.pixels.shape == (20, 40, 3)
    with pytest.raises(hottel.UsageError, match="pixels"):
        picture.file("svg")


def test_a_scene_that_cannot_be_drawn_is_shown_as_text(square):
    square["edges"].append({"name": "far", "material": "grey", "points": [["1e400", 0], ["2e400", 0]]})
    scene = hottel.Scene(square)
    with pytest.raises(hottel.RequestError):
        scene.picture()
    assert scene._repr_svg_() is None and "far" in repr(scene)
