"""What is asked of whole scenes: checks and repairs, plans, stores, frames, scenes made to order."""

import json

import numpy
import pytest

import hottel
from conftest import ROOT, run_program, table_of

CHECKED = ["scenes/showcase/apartment.json", "scenes/degenerate/kettner_a1.json", "scenes/space/cube.json",
           "scenes/space/two_boxes.json", "scenes/drawings/room.svg", "scenes/heat/street_canyon.json"]
CHECKED = [scene for scene in CHECKED if (ROOT / scene).exists()]


@pytest.mark.parametrize("scene", CHECKED)
def test_findings_are_those_of_the_program(scene):
    _, text, _ = run_program("check", scene, "--json")
    wanted = json.loads(text)["findings"]
    found = hottel.read_scene(scene).check()
    assert len(found) == len(wanted)
    for finding, line in zip(found, wanted):
        for key in ("severity", "kind", "message", "suggestion"):
            assert getattr(finding, key) == line[key].replace("--fix OUT --within D", "fixed(within=D)")
        assert list(finding.surfaces) == line["surfaces"]
        assert (finding.at is None) == (line["at"] is None) and (finding.at is None or finding.at.tolist() == line["at"])


@pytest.mark.parametrize("scene, within", [("scenes/showcase/maze.json", "1e-6"),
                                           ("scenes/space/room_six_digits.json", "1e-5"),
                                           ("scenes/showcase/apartment.json", 0)])
def test_repairs_are_those_of_the_program(scene, within, tmp_path):
    out = tmp_path / "fixed.json"
    _, text, message = run_program("check", scene, "--fix", out, *(["--within", within] if within else []), "--json")
    report = json.loads(text)
    repair = hottel.read_scene(scene).fixed(within)
    assert [(step.kind, step.surface, step.message) for step in repair.steps] == [
        (step["kind"], step["surface"], step["message"]) for step in report["repairs"]]
    assert repair.scene == hottel.read_scene(out)
    assert [finding.kind for finding in repair.findings] == [finding["kind"] for finding in report["findings"]]
    if repair.changes is not None:
        assert [list(change) for change in repair.changes] == [
            [change[key] for key in ("from", "to", "before", "after")] for change in report["changes"]]


def test_a_gap_is_closed_within_a_distance(square):
    square["edges"][0]["points"] = [["2.000001", 0], [0, 0]]
    scene = hottel.Scene(square)
    assert not scene.fixed().steps
    repair = scene.fixed(within="1e-5")
    assert repair.steps and repair.scene != scene
    for within in (-1, "x", float("nan")):
        with pytest.raises((hottel.UsageError, hottel.InputError)):
            scene.fixed(within)
    with pytest.raises(TypeError):
        scene.fixed(None)


@pytest.mark.parametrize("scene", ["scenes/showcase/apartment.json", "scenes/space/two_boxes.json"])
def test_the_plan_is_that_of_the_program(scene):
    _, text, _ = run_program("plan", scene, "--json")
    wanted = [(line["effect"], line["used"], line["reason"].replace("--per group", "per group").replace("--light-levels", "light_levels"))
              for line in json.loads(text)["plan"]]
    plan = hottel.Simulation(hottel.read_scene(scene)).plan
    assert [(effect.effect, effect.used, effect.reason) for effect in plan] == wanted
    assert all((effect.seconds > 0) <= effect.used for effect in plan)


@pytest.mark.parametrize("scene", ["scenes/analytic/square_radiosity.json", "scenes/heat/street_canyon.json",
                                   "scenes/space/cube.json"])
def test_script_f_is_that_of_the_program(scene):
    code, listed, message = run_program("factors", scene, "--script-f")
    assert code == 0, message
    gray = hottel.Simulation(hottel.read_scene(scene), per="face").script_f()
    lines = table_of(listed)
    assert len(lines) == gray.to_scipy().nnz > 0
    for line in lines:
        entry = gray[line["from"], line["to"]]
        assert (entry["factor"], entry["lower"], entry["upper"]) == tuple(
            float(line[column]) for column in ("factor", "lower", "upper"))


def test_script_f_of_coloured_materials_has_a_channel(square):
    square["materials"]["grey"]["reflectivity"] = [0.5, 0.25, 0]
    simulation = hottel.Simulation(hottel.Scene(square))
    with pytest.raises(hottel.RequestError, match="not gray"):
        simulation.script_f()
    red, green = simulation.script_f("r"), simulation.script_f("g")
    assert red.factors.sum() < green.factors.sum() and simulation.script_f("r") is red
    for channel in ("red", "x", "rg"):
        with pytest.raises(hottel.UsageError):
            simulation.script_f(channel)
    with pytest.raises(hottel.UsageError):
        red.visibility
    with pytest.raises(hottel.UsageError):
        hottel.Simulation(hottel.Scene(square), method="gauss:2").script_f()


@pytest.mark.parametrize("scene", ["scenes/analytic/strip_obstructed.json", "scenes/space/two_boxes.json"])
def test_a_store_keeps_factors_bit_for_bit(scene, tmp_path):
    scene, store = hottel.read_scene(scene), tmp_path / "factors.db"
    plain = hottel.Simulation(scene)
    first, second = hottel.Simulation(scene, store=store), hottel.Simulation(scene, store=str(store))
    for simulation in (first, second):
        assert (simulation.factors.factors == plain.factors.factors).all()
        assert (simulation.factors.upper == plain.factors.upper).all()
    assert plain.store_use is None and first.store_use["computed"] > 0
    assert second.store_use == {"computed": 0, "read": first.store_use["computed"], "damaged": 0}


def test_stores_that_cannot_be(square, tmp_path):
    (tmp_path / "text").write_text("no store")
    scene = hottel.Scene(square)
    with pytest.raises(hottel.InputError):
        hottel.Simulation(scene, store=tmp_path / "text").factors
    with pytest.raises(OSError):
        hottel.Simulation(scene, store=tmp_path / "nowhere" / "store").factors
    with pytest.raises(hottel.UsageError):
        hottel.Simulation(scene, store=tmp_path / "store", method="file:own.csv")
    with pytest.raises(TypeError):
        hottel.Simulation(scene, store=3)


@pytest.mark.parametrize("scene, options", [("scenes/lights/lighthouse.json", {"light_levels": 2}),
                                            ("scenes/space/cube.json", {"levels": 1})])
def test_levels_divide_as_the_program_divides(scene, options, tmp_path):
    words = [word for name, value in options.items() for word in ("--" + name.replace("_", "-"), value)]
    code, _, message = run_program("solve", scene, "-o", tmp_path, "--no-picture", "--no-illumination", *words)
    assert code == 0, message
    simulation = hottel.Simulation(hottel.read_scene(scene), **options)
    lines = table_of((tmp_path / "radiosity.csv").read_text())
    assert [float(line["radiosity"]) for line in lines] == simulation.radiosity.radiosity.ravel().tolist()
    again = simulation.with_scene(simulation.scene.replace(sky={"emission": 1}))
    assert again.radiosity.names == simulation.radiosity.names


@pytest.mark.parametrize("options", [{"levels": -1}, {"levels": 99}, {"levels": 2, "light_levels": 1},
                                     {"levels": 1, "per": "face"}])
def test_levels_that_make_no_sense(square, options):
    with pytest.raises(hottel.UsageError):
        hottel.Simulation(hottel.Scene(square), **options)


def moving(scene):
    """A scene with a light that goes along a path."""
    middle = [1, 0.5, 0.5][: scene.dimension] if scene.dimension == 2 else [0.5, 0.5, 0.5]
    return scene.replace(lights=[{"name": "lamp", "type": "point", "position": middle, "power": 10,
                                  "path": {"points": [middle, [0.25] + middle[1:]], "seconds": 1}}])


@pytest.mark.parametrize("scene", ["scenes/lights/lighthouse.json", "scenes/space/cube.json"])
def test_frames_are_those_of_the_program(scene, tmp_path):
    scene = hottel.read_scene(scene)
    if not scene.lights:
        scene = moving(scene)
    (tmp_path / "scene.json").write_text(scene.to_json())
    code, _, message = run_program("animate", tmp_path / "scene.json", "--frames", 3, "--fps", 2, "--size", 200, "-o",
                                   tmp_path, "--no-film")
    assert code == 0, message
    frames = hottel.Simulation(scene).frames(3, fps=2, size=200)
    assert len(frames) == 3 and iter(frames) is frames
    made = list(frames)
    assert [frame.seconds for frame in made] == [0, 0.5, 1] and [frame.index for frame in made] == [0, 1, 2]
    for frame in made:
        assert frame.picture.file() == (tmp_path / f"frame_{frame.index:05}.png").read_bytes()
        assert numpy.isfinite(frame.simulation.radiosity.radiosity).all()
    assert list(frames) == []
    with pytest.raises(hottel.UsageError):
        made[0].picture.file("svg")


def test_frames_that_cannot_be(square):
    scene = hottel.Scene(square)
    simulation = hottel.Simulation(scene)
    for options in ({"count": 0}, {"count": -1}, {"count": 10**6}, {"count": 2, "fps": 0}, {"count": 2, "fps": -1},
                    {"count": 2, "shading": "smooth"}, {"count": 2, "tone": "x"}, {"count": 2, "exposure": 0},
                    {"count": 2, "size": -1}, {"count": 2, "cells": (0, 1)}):
        with pytest.raises(hottel.UsageError):
            simulation.frames(**options)
    lamp = {"name": "lamp", "type": "point", "position": [1, 0.5], "power": 1,
            "path": {"points": [[1, 0.5], [1, 0]], "seconds": 1}}
    with pytest.raises(hottel.RequestError, match="frame 2"):
        hottel.Simulation(scene.replace(lights=[lamp])).frames(4, fps=2)


@pytest.mark.parametrize("options", [{"kind": "room", "n": 40, "seed": 3}, {"kind": "lattice", "n": 30, "k": 5, "seed": 7},
                                     {"kind": "clutter", "n": 50, "view": "long", "digits": 17},
                                     {"kind": "clutter", "n": 50, "length": "1/2"}, {"kind": "room-turned", "n": 2, "seed": 3},
                                     {"kind": "street-blocks", "n": 3, "bottoms": False}])
def test_generated_scenes_are_those_of_the_program(options):
    words = [word for name, value in options.items() if name not in ("kind", "bottoms") for word in ("--" + name, value)]
    words += ["--no-bottoms"] if not options.get("bottoms", True) else []
    code, text, message = run_program("generate", options["kind"], *words)
    assert code == 0, message
    assert hottel.generate(**options).to_json() == text


@pytest.mark.parametrize("options", [{"kind": "castle"}, {"kind": "room", "n": 0}, {"kind": "room", "k": 3},
                                     {"kind": "room", "bottoms": False}, {"kind": "room", "view": "long"},
                                     {"kind": "clutter", "view": "wide"}, {"kind": "clutter", "length": 5},
                                     {"kind": "clutter", "length": 1, "view": "long"}, {"kind": "room", "digits": 99},
                                     {"kind": "room-boxes", "digits": 3}, {"kind": "room-boxes", "n": 10**9},
                                     {"kind": "room", "n": 10**9}, {"kind": "room", "digits": -1}])
def test_scenes_that_cannot_be_generated(options):
    with pytest.raises(hottel.UsageError):
        hottel.generate(**options)


def test_what_generates_has_whole_numbers():
    for options in ({"n": -1}, {"n": 1.5}, {"seed": -1}, {"seed": 2**64}, {"n": "3"}):
        with pytest.raises(TypeError):
            hottel.generate("room", **options)
