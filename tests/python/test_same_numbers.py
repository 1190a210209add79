"""The module gives the numbers of the program, bit for bit, and refuses what it refuses, in the same words."""

import fractions
import json
import math
import re

import numpy
import pytest

import hottel
from conftest import ROOT, SCENES, run_program, table_of

QUICK = sorted(
    path.relative_to(ROOT).as_posix()
    for pattern in ("analytic/*.json", "degenerate/*.json", "degenerate/refused/*.json", "heat/*.json", "lights/*.json",
                    "analytic/space/*.json", "space/cube.json", "space/two_boxes.json", "space/crate.vs3", "drawings/*",
                    "showcase/apartment.json")
    for path in SCENES.glob(pattern)
)


def same(a, b):
    """Whether two doubles are the same bits, or both no numbers."""
    return a == b and math.copysign(1, a) == math.copysign(1, b) or (math.isnan(a) and math.isnan(b))


def assert_refused_alike(message, work):
    """The program ended with this on standard error; the module ends with the same sentence."""
    with pytest.raises(hottel.Error) as refused:
        work()
    assert str(refused.value).splitlines()[0] in message


def assert_same_table(lines, names, table, columns):
    """The lines of a csv are the rows and channels of a table, in order."""
    values = iter(lines)
    for row, name in enumerate(table.names):
        for channel, channel_name in enumerate(table.channels):
            wanted = [getattr(table, column)[row, channel] for column in columns.values()]
            if all(math.isnan(value) for value in wanted):
                continue  # a band without temperatures
            line = next(values)
            assert (names(line), line["channel"]) == (name, channel_name)
            for column, value in zip(columns, wanted):
                assert same(float(line[column]), value), (name, column)
    assert next(values, None) is None


def element_names(table):
    """What lines of a csv call a row: an element is 0 where the face is not divided."""
    whole = set(table.names)
    return lambda line: line["face"] if line["face"] in whole else line["face"] + "#" + line["element"]


@pytest.mark.parametrize("scene", QUICK)
def test_factors_are_those_of_the_program(scene):
    code, listed, message = run_program("factors", scene)
    if code != 0:
        return assert_refused_alike(message, lambda: hottel.Simulation(hottel.read_scene(scene), per="face").factors)
    factors = hottel.Simulation(hottel.read_scene(scene), per="group" if scene.endswith(".vs3") else "face").factors
    shares = factors.visibility
    lines = table_of(listed)
    assert len(lines) == factors.to_scipy().nnz
    for line in lines:
        place = factors.index(line["from"]), factors.index(line["to"])
        for column, values in (("factor", factors.factors), ("lower", factors.lower), ("upper", factors.upper)):
            assert same(float(line[column]), values[place]), (line, column)
        assert same(float(line["visibility"] or "nan"), shares[place]), line
        assert line["guarantee"] == factors[line["from"], line["to"]]["guarantee"]


@pytest.mark.parametrize("scene", QUICK)
def test_radiosities_temperatures_and_fluxes_are_those_of_the_program(scene, tmp_path):
    code, _, message = run_program("solve", scene, "-o", tmp_path, "--no-illumination", "--no-picture")
    if code != 0:
        return assert_refused_alike(message, lambda: hottel.Simulation(hottel.read_scene(scene)).radiosity)
    simulation = hottel.Simulation(hottel.read_scene(scene))
    columns = {c: c for c in ("emission", "reflectivity", "radiosity", "lower", "upper", "irradiance", "net")}
    table = simulation.radiosity
    assert_same_table(table_of((tmp_path / "radiosity.csv").read_text()), element_names(table), table, columns)
    fluxes = table_of((tmp_path / "flux.csv").read_text())
    for per, table in (("face", simulation.flux), ("group", simulation.group_flux), ("light", simulation.light_flux)):
        assert_same_table([line for line in fluxes if line["per"] == per], lambda line: line["name"], table,
                          {"net": "net", "lower": "lower", "upper": "upper"})
    table, warm = simulation.temperatures, tmp_path / "temperature.csv"
    assert_same_table(table_of(warm.read_text()) if warm.exists() else [], element_names(table), table,
                      {"temperature": "temperature", "lower": "lower", "upper": "upper"})


@pytest.mark.parametrize("scene", ["scenes/analytic/strip_obstructed.json", "scenes/space/cube.json"])
def test_elements_are_divided_as_the_program_divides_them(scene):
    code, listed, _ = run_program("factors", scene, "--per", "element", "--elements", 2)
    assert code == 0
    factors = hottel.Simulation(hottel.read_scene(scene), elements=2).factors
    lines = table_of(listed)
    assert len(lines) == factors.to_scipy().nnz
    for line in lines:
        assert float(line["factor"]) == factors[line["from"], line["to"]]["factor"]


@pytest.mark.parametrize("scene", ["scenes/analytic/strip_obstructed.json", "scenes/degenerate/kettner_a1.json"])
def test_closed_forms_are_those_of_the_program(scene):
    code, listed, _ = run_program("factors", scene, "--exact-form")
    lines = table_of(listed)
    assert code == 0 and len(lines) > 1
    simulation = hottel.Simulation(hottel.read_scene(scene), per="face")
    for line in lines:
        form = simulation.exact_form(line["from"], line["to"])
        assert (form["exchange"], form["area_from"]) == (line["exchange"], line["area"])


def test_an_approximate_method_is_that_of_the_program():
    scene = "scenes/analytic/strip_obstructed.json"
    code, listed, _ = run_program("factors", scene, "--method", "gauss:4", "--elements", 8)
    assert code == 0
    factors = hottel.Simulation(hottel.read_scene(scene), method="gauss:4", elements=8, per="face").factors
    for line in table_of(listed):
        assert float(line["factor"]) == factors[line["from"], line["to"]]["factor"]
    assert factors.guarantee == "estimated"
    assert factors.upper[0, 0] == 1
    with pytest.raises(hottel.UsageError, match="method 'exact'"):
        factors.visibility


def test_threads_change_nothing():
    scene = hottel.read_scene("scenes/space/two_boxes.json")
    one, all_of_them = (hottel.Simulation(scene, threads=threads) for threads in (1, None))
    assert (one.factors.factors == all_of_them.factors.factors).all()
    assert (one.radiosity.upper == all_of_them.radiosity.upper).all()


def test_light_and_polygons_of_points_are_those_of_the_program(tmp_path):
    scene, points = "scenes/showcase/apartment.json", [[0.3 + 0.7 * i, 0.2 + 0.45 * j] for i in range(12) for j in range(12)]
    (tmp_path / "points.csv").write_text("x,y\n" + "".join(f"{x!r},{y!r}\n" for x, y in points))
    code, _, message = run_program("visibility", scene, "--points", tmp_path / "points.csv", "--irradiance", "-o",
                                   tmp_path / "seen.npz")
    assert code == 0, message
    wanted = numpy.load(tmp_path / "seen.npz")
    simulation = hottel.Simulation(hottel.read_scene(scene), per="face")
    seen, light = simulation.visible(points), simulation.light(points)
    assert seen.xy.tobytes() == wanted["xy"].tobytes() and (seen.begin == wanted["begin"]).all()
    assert [seen.names[k] for k in seen.face] == [wanted["names"][k] for k in wanted["face"]]
    assert numpy.array_equal(light, wanted["irradiance"], equal_nan=True) and numpy.isfinite(light).any()


def test_proven_bounds_of_points_in_space_are_the_same_in_arrays_and_in_lines(tmp_path):
    (tmp_path / "points.csv").write_text("x,y,z\n0.2,0.3,0.4\n0.6,0.5,0.9\n")
    for name in ["seen.npz", "seen.csv"]:
        code, _, message = run_program("visibility", "scenes/space/two_boxes.json", "--points", tmp_path / "points.csv",
                                       "--guarantee", "enclosed", "-o", tmp_path / name)
        assert code == 0, message
    seen = numpy.load(tmp_path / "seen.npz")
    lines = [line.split(",") for line in (tmp_path / "seen.csv").read_text().splitlines()]
    lower, upper = lines[0].index("lower"), lines[0].index("upper")
    wanted = [[float(line[lower]), float(line[upper])] for line in lines[1:]]
    assert seen["fraction_bounds"].tolist() == wanted and len(wanted) > 2
    fraction = seen["solid_angle"] / (4 * numpy.pi)
    assert (seen["fraction_bounds"][:, 0] <= fraction * (1 + 1e-15)).all()
    assert (fraction * (1 - 1e-15) <= seen["fraction_bounds"][:, 1]).all()


def test_light_in_space_is_that_of_the_grid_of_the_program(tmp_path):
    grid = {"origin": [0, 0, "1/4"], "u": [1, 0, 0], "v": [0, 1, 0], "cells": [4, 2]}
    scene = hottel.read_scene("scenes/space/cube.json").replace(grid=grid)
    (tmp_path / "scene.json").write_text(scene.to_json())
    code, _, message = run_program("solve", tmp_path / "scene.json", "-o", tmp_path, "--no-picture")
    assert code == 0, message
    centres = [[(2 * i + 1) / 8, (2 * j + 1) / 4, 0.25] for j in range(2) for i in range(4)]
    light = hottel.Simulation(scene).light(centres)
    assert light.tobytes() == numpy.load(tmp_path / "illumination.npy").tobytes()


GRID = {"origin": [0, 0, "1/4"], "u": [1, 0, 0], "v": [0, 1, 0], "cells": [4, 2]}


def solved(scene, folder, *options):
    """The folder of what `solve` writes of a scene."""
    (folder / "scene.json").write_text(scene.to_json())
    code, _, message = run_program("solve", folder / "scene.json", "-o", folder, *options)
    assert code == 0, message
    return folder


@pytest.mark.parametrize("illumination", ["point", "average", "inverse-square"])
def test_grids_in_the_plane_are_those_of_the_program(illumination, tmp_path):
    scene = hottel.read_scene("scenes/showcase/apartment.json")
    solved(scene, tmp_path, "--grid", "20x15", "--illumination", illumination, "--no-picture")
    wanted = numpy.load(tmp_path / "illumination.npy")
    grid = hottel.Simulation(scene).grid((20, 15), illumination=illumination)
    assert grid.values.tobytes() == wanted.tobytes() and grid.values.shape == wanted.shape
    assert (grid.max_error is not None) == (illumination == "average")


@pytest.mark.parametrize("show", ["irradiance", "temperature", "sky"])
def test_what_grids_show_is_that_of_the_program(show, tmp_path):
    scene = hottel.read_scene("scenes/heat/street_canyon.json")
    solved(scene, tmp_path, "--grid", "12x9", "--show", show)
    simulation = hottel.Simulation(scene)
    assert simulation.grid((12, 9), show=show).values.tobytes() == numpy.load(tmp_path / "shown.npy").tobytes()
    assert simulation.picture(show, cells=(12, 9)).file() == (tmp_path / "illumination.png").read_bytes()


@pytest.mark.parametrize("scene, show, options", [
    ("scenes/showcase/apartment.json", "irradiance", {"channel": "g"}),
    ("scenes/showcase/apartment.json", "net", {"channel": "r", "bar": "-1:2"}),
    ("scenes/showcase/apartment.json", "radiosity", {"bar": "1e-3::log", "axes": True}),
    ("scenes/heat/street_by_day.json", "irradiance", {"channel": "solar"}),
    ("scenes/heat/street_by_day.json", "temperature", {"shading": "smooth"}),
    ("scenes/analytic/square_radiosity.json", "factor:top", {}),
    ("scenes/space/two_boxes.json", "radiosity", {"channel": "b", "shading": "smooth"}),
    ("scenes/space/cube.json", "irradiance", {"axes": True}),
    ("scenes/space/cube.json", "net", {"shading": "gathered"}),
    ("scenes/lights/stage.json", "light", {"shading": "gathered"}),
    ("scenes/lights/stage.json", "light", {}),
    ("scenes/space/cube.json", "light", {"outlines": True, "axes": True}),
])
def test_pictures_of_quantities_are_those_of_the_program(scene, show, options, tmp_path):
    scene = hottel.read_scene(scene)
    words = [f"--{name}" if value is True else f"--{name}={value}" for name, value in options.items()]
    solved(scene, tmp_path, "--show", show, "--size", 320, *words)
    picture = hottel.Simulation(scene).picture(show, size=320, **options)
    name = "illumination.png" if scene.dimension == 2 else "render.png"
    assert picture.file() == (tmp_path / name).read_bytes()


@pytest.mark.parametrize("show", ["irradiance", "sky"])
def test_what_grids_in_space_show_is_that_of_the_program(show, tmp_path):
    scene = hottel.read_scene("scenes/space/cube.json").replace(grid=GRID)
    solved(scene, tmp_path, "--show", show, "--grid", "5x3")
    simulation = hottel.Simulation(scene)
    assert simulation.grid((5, 3), show=show).values.tobytes() == numpy.load(tmp_path / "shown.npy").tobytes()
    assert simulation.grid((5, 3)).values.tobytes() == numpy.load(tmp_path / "illumination.npy").tobytes()
    assert simulation.picture(show).file() == (tmp_path / "render.png").read_bytes()
    assert simulation.picture(show, cells=(5, 3), of="grid").file() == (tmp_path / "illumination.png").read_bytes()
    plain = simulation.picture(show, outlines=False).file()
    assert plain != (tmp_path / "render.png").read_bytes()
    solved(scene, tmp_path, "--show", show, "--grid", "5x3", "--no-outlines", "--axes")
    assert simulation.picture(show, outlines=False, axes=True).file() == (tmp_path / "render.png").read_bytes()
    assert simulation.picture(show, cells=(5, 3), of="grid", axes=True).file() == (
        tmp_path / "illumination.png").read_bytes()


def test_each_of_several_grids_in_space_is_that_of_the_program(tmp_path):
    scene = hottel.read_scene("scenes/space/cube.json").replace(grid=[{"name": "low", **GRID}, {"name": "high", **GRID}])
    solved(scene, tmp_path, "--illumination", "average", "--contours", "3")
    simulation = hottel.Simulation(scene)
    found = simulation.grid(over="high", illumination="average")
    assert found.values.tobytes() == numpy.load(tmp_path / "illumination-high.npy").tobytes()
    assert 0 <= found.max_error < 1e-6
    picture = simulation.picture(over="low", of="grid", illumination="average", contours=3)
    assert picture.file() == (tmp_path / "illumination-low.png").read_bytes()
    for options in ({}, {"over": "nowhere"}):
        with pytest.raises(hottel.UsageError, match="'low', 'high'"):
            simulation.grid(**options)


def test_each_of_several_grids_in_the_plane_is_that_of_the_program(tmp_path):
    grids = [{"name": "low", "min": [0, 0], "max": [2, 1], "cells": [6, 3]},
             {"name": "high", "min": [0, 1], "max": [2, 2], "cells": [5, 4]}]
    scene = hottel.read_scene("scenes/heat/street_canyon.json").replace(grid=grids)
    solved(scene, tmp_path, "--show", "temperature")
    simulation = hottel.Simulation(scene)
    for name in ("low", "high"):
        found = simulation.grid(over=name)
        assert found.values.tobytes() == numpy.load(tmp_path / f"illumination-{name}.npy").tobytes()
        warmth = simulation.grid(over=name, show="temperature")
        assert warmth.values.tobytes() == numpy.load(tmp_path / f"shown-{name}.npy").tobytes()
        picture = simulation.picture("temperature", over=name)
        assert picture.file() == (tmp_path / f"illumination-{name}.png").read_bytes()
    assert simulation.grid((3, 2), over="high").values.shape[:2] == (2, 3)
    assert simulation.grid(over=grids[0]["name"]).centres.shape[:2] == (3, 6)
    assert not simulation.compare_grid(simulation.grid(over="high").values, over="high").off.any()
    for options in ({}, {"over": "nowhere"}):
        with pytest.raises(hottel.UsageError, match="'low', 'high'"):
            simulation.grid(**options)
    with pytest.raises(hottel.UsageError, match="'low', 'high'"):
        simulation.picture()
    assert simulation.picture("radiosity").file() == simulation.picture("radiosity", over="low").file()


@pytest.mark.parametrize("ending", ["png", "svg", "pdf"])
@pytest.mark.parametrize("scene", ["scenes/showcase/apartment.json", "scenes/space/two_boxes.json"])
def test_pictures_of_light_are_those_of_the_program(scene, ending, tmp_path):
    scene = hottel.read_scene(scene)
    solved(scene, tmp_path, "--render", tmp_path / f"picture.{ending}", "--size", 300, "--tone", "reinhard")
    picture = hottel.Simulation(scene).picture(size=300, tone="reinhard")
    picture.save(tmp_path / f"own.{ending}")
    wanted, own = ((tmp_path / f"{name}.{ending}").read_bytes() for name in ("picture", "own"))
    if ending == "pdf":  # a PDF tells when it was made
        wanted, own = (re.sub(rb"CreationDate.*", b"", text) for text in (wanted, own))
    assert own == wanted


@pytest.mark.parametrize("scene", ["scenes/heat/street_canyon.json", "scenes/space/two_boxes.json"])
def test_light_on_areas_is_that_of_the_program(scene, tmp_path):
    scene = hottel.read_scene(scene)
    names = "xyz"[: scene.dimension]
    points = [[0.5 + 0.75 * k] * (scene.dimension - 1) + [0.5] for k in range(4)]
    normals = [[0.5, 1, -0.25][: scene.dimension]] * 4
    head = ",".join([*names, *("n" + name for name in names)])
    (tmp_path / "points.csv").write_text(
        "\n".join([head, *(",".join(map(repr, p + n)) for p, n in zip(points, normals))]) + "\n")
    (tmp_path / "scene.json").write_text(scene.to_json())
    code, listed, message = run_program("visibility", tmp_path / "scene.json", "--points", tmp_path / "points.csv")
    assert code == 0, message
    light = hottel.Simulation(scene).light_on(points, normals)
    assert len(light) == len(table_of(listed)) == 4
    for k, line in enumerate(table_of(listed)):
        for c, channel in enumerate(light.channels):
            column = "irradiance" if channel == "all" else "irradiance_" + channel
            assert same(float(line[column] or "nan"), light.irradiance[k, c])
        for column in ("sky_view_factor", "mean_radiant_temperature"):
            assert same(float(line[column] or "nan"), getattr(light, column)[k])


@pytest.mark.parametrize("scene, points", [
    ("scenes/space/cube.json", ["1/2,1/4,3/4", "0,0.5,0.5", "2,2,2"]),
    ("scenes/space/two_boxes.json", ["1,1,1", "2,3,4", "0.5,0.25,1.5"]),
])
def test_maps_of_points_in_space_are_those_of_the_program(scene, points):
    numbers = [[float(eval(each)) for each in point.split(",")] for point in points]
    seen = hottel.Simulation(hottel.read_scene(scene)).visible(numbers)
    assert len(seen) == len(points)
    for k, point in enumerate(points):
        code, text, message = run_program("visibility", scene, "--at", point, "--json")
        assert code == 0, message
        wanted = json.loads(text)
        if "solid" in wanted:
            assert math.isnan(seen[k]["sky"]) and len(seen[k]) == 1
            continue
        fractions = {face["name"]: face["fraction"] for face in wanted["faces"]}
        assert seen[k] == {**fractions, "sky": wanted["sky"]["fraction"]}
        pieces = [(face["name"], piece) for face in wanted["faces"] for piece in face["pieces"]]
        assert len(pieces) == len(seen.pieces(k))
        for (name, piece), (own_name, directions, corners) in zip(pieces, seen.pieces(k)):
            assert own_name == name
            assert directions.tolist() == piece["directions"] and corners.tolist() == piece["points"]


@pytest.mark.parametrize("scene", ["scenes/analytic/strip_obstructed.json", "scenes/showcase/apartment.json",
                                   "scenes/degenerate/kettner_a1.json", "scenes/space/two_boxes.json"])
def test_the_visibility_graph_is_that_of_the_program(scene):
    code, listed, message = run_program("visibility", scene, "--graph")
    assert code == 0, message
    graph = hottel.Simulation(hottel.read_scene(scene)).visibility_graph()
    lines = table_of(listed)
    assert len(lines) == len(graph.pairs) == len(graph.lengths) > 0
    for line, (v, w), length, along in zip(lines, graph.pairs, graph.lengths, graph.along):
        assert [int(line["vertex0"]), int(line["vertex1"])] == [v, w] and float(line["length"]) == length
        axes = "xyz"[:graph.vertices.shape[1]]
        assert [float(line[axis + end]) for end in "01" for axis in axes] == [*graph.vertices[v], *graph.vertices[w]]
        assert line["along"] == (graph.names[along] if along >= 0 else "")
        assert (line["surface0"], line["surface1"]) == (graph.surfaces[v], graph.surfaces[w])


def test_closed_forms_in_space_are_those_of_the_program():
    _, listed, _ = run_program("factors", "scenes/space/cube.json", "--exact-form", "floor", "ceiling")
    simulation = hottel.Simulation(hottel.read_scene("scenes/space/cube.json"))
    assert simulation.exact_form("floor", "ceiling") == {"exchange": table_of(listed)[0]["exchange"]}


PAIRS = [("scenes/analytic/strip_obstructed.json", "bottom", "top"), ("scenes/analytic/strip_obstructed.json", "top", "sky"),
         ("scenes/analytic/triangle_345.json", "three", "four")]


@pytest.mark.parametrize("scene, a, b", PAIRS)
def test_critical_points_are_those_of_the_program(scene, a, b):
    _, text, _ = run_program("visibility", scene, "--from", a, "--to", b, "--json")
    wanted = json.loads(text)["critical_points"]
    found = hottel.Simulation(hottel.read_scene(scene), elements=2).critical_points(a, b)
    assert len(found) == len(wanted) and (len(found) > 0) == ("strip" in scene)
    for k, point in enumerate(wanted):
        assert same(found.t[k], point["t"]["value"]) and found.exact_t[k] == fractions.Fraction(point["t"]["exact"])
        assert found.points[k].tolist() == [point["at"]["x"], point["at"]["y"]]
        assert [[each["x"], each["y"]] for each in point["past"]] == [found.near[k].tolist(), found.far[k].tolist()]
        assert found.is_jump[k] == (point["kind"] == "D0")


def test_critical_points_of_a_contact_are_jumps(square):
    square["edges"].append({"name": "screen", "material": "grey", "points": [[1, 0], [1, "1/2"]]})
    found = hottel.Simulation(hottel.Scene(square)).critical_points("floor", "walls[0]")
    assert found.is_jump.any() and found.is_jump.dtype == bool
    assert (found.points[found.is_jump] == found.near[found.is_jump]).all()


@pytest.mark.parametrize("scene", ["scenes/analytic/strip_obstructed.json", "scenes/degenerate/kettner_a1.json",
                                   "scenes/showcase/apartment.json"])
def test_critical_lines_are_those_of_the_program(scene):
    code, listed, message = run_program("visibility", scene, "--events", "-o", "-")
    assert code == 0, message
    lines, found = table_of(listed), hottel.Simulation(hottel.read_scene(scene)).critical_lines()
    assert len(lines) == len(found) > 0
    sides = ["behind_left", "behind_right", "ahead_left", "ahead_right"]
    for k, line in enumerate(lines):
        assert [float(line[each]) for each in ("x0", "y0", "x1", "y1")] == found.vertices[k].ravel().tolist()
        ends = [float(line[each] or "nan") for each in ("behind_x", "behind_y", "ahead_x", "ahead_y")]
        assert all(map(same, ends, found.ends[k].ravel().tolist()))
        assert line["along"] == found.along[k]
        assert tuple(line[side] for side in sides) == found.met[k]
        assert tuple(line[f"from_{side}"] for side in sides) == found.seen[k]


def test_what_a_face_in_space_sees_is_that_of_the_program():
    scene = "scenes/space/two_boxes.json"
    _, text, _ = run_program("visibility", scene, "--face", "lamp", "--json")
    sight = hottel.Simulation(hottel.read_scene(scene)).faces_seen_by("lamp")
    answer = json.loads(text)
    wanted = [(each["face"], not each["hidden_in_part"]) for each in answer["faces"]]
    found = list(zip(sight.names, sight.is_whole))
    assert [each for each in found if each[0] != "sky"] == wanted and len(wanted) > 3
    assert ("sky" in sight.names) == answer["sees_sky"]


def test_event_surfaces_are_those_of_the_program():
    scene = "scenes/space/two_boxes.json"
    code, listed, message = run_program("visibility", scene, "--events", "--from", "lamp", "--to", "floor")
    assert code == 0, message
    events, lines = hottel.Simulation(hottel.read_scene(scene)).event_surfaces("lamp", "floor"), table_of(listed)
    assert len(lines) == len(events.t) == events.begin[-1] and "EEE" in events.kinds
    def numbers(text):
        return [float(x) for x in text.replace(";", " ").split()]
    for e, kind in enumerate(events.kinds):
        for k in range(events.begin[e], events.begin[e + 1]):
            line = lines[k]
            assert (line["event"], line["kind"]) == (str(e), kind) and float(line["t"]) == events.t[k]
            assert [float(line[x]) for x in ("x0", "y0", "z0", "x1", "y1", "z1")] == events.rulings[k].ravel().tolist()
            assert numbers(line["edge"]) == events.edges[e].ravel().tolist()
            assert "|".join(events.edge_of[e]) == line["edge_of"]
            assert "|".join(events.crossing[e]) == line["crossing"]
            if kind == "EV":
                assert numbers(line["vertex"]) == events.vertices[e].tolist()
            else:
                assert all(map(math.isnan, events.vertices[e]))
            for other, name in zip(events.others[e], ("edge_2", "edge_3")):
                assert numbers(line[name]) == other.ravel().tolist() if line[name] else math.isnan(other[0, 0])


def test_light_in_a_volume_is_that_of_the_program(tmp_path):
    scene = json.loads((ROOT / "scenes/space/two_boxes.json").read_text())
    scene["grid"] = {"origin": [0, 0, 0], "u": [5, 0, 0], "v": [0, 5, 0], "w": [0, 0, 5], "cells": [4, 3, 2]}
    file = tmp_path / "volume.json"
    file.write_text(json.dumps(scene))
    code, _, message = run_program("solve", str(file), "-o", str(tmp_path / "out"), "--no-picture")
    assert code == 0, message
    grid = hottel.Simulation(hottel.read_scene(file)).grid()
    assert grid.values.shape == (2, 3, 4, 3) and grid.centres.shape == (2, 3, 4, 3)
    assert numpy.array_equal(grid.values, numpy.load(tmp_path / "out/illumination.npy"), equal_nan=True)
    assert grid.centres[1, 0, 3].tolist() == [4.375, 0.8333333333333334, 3.75]
    other = hottel.Simulation(hottel.read_scene(file))
    assert other.grid((1, 1, 1)).values.shape == (1, 1, 1, 3)
    for wrong in ({"cells": (2, 2)}, {"show": "sky"}, {"illumination": "average"}):
        with pytest.raises(hottel.UsageError):
            other.grid(**wrong)


def test_arrays_of_what_points_in_space_see_are_those_of_the_program(tmp_path):
    scene, points = "scenes/space/two_boxes.json", ["1,1,1.5", "1/5,0.15,0.6", "9,9,9"]
    (tmp_path / "points.csv").write_text("\n".join(points))
    seen = {}
    for kind, options in (("npz", ["--pieces"]), ("vtu", []), ("csv", [])):
        file = tmp_path / f"seen.{kind}"
        code, _, message = run_program("visibility", scene, "--points", str(tmp_path / "points.csv"), "-o", str(file), *options)
        assert code == 0, message
        seen[kind] = file
    found = hottel.Simulation(hottel.read_scene(scene)).visible([[1, 1, 1.5], [0.2, 0.15, 0.6], [9, 9, 9]])
    lines = table_of(seen["csv"].read_text())
    with numpy.load(seen["npz"]) as arrays:
        assert arrays["xyz"].tolist() == [[1, 1, 1.5], [0.2, 0.15, 0.6], [9, 9, 9]]
        assert (arrays["solid"] == -1).all() and len(arrays["begin"]) == 4
        assert [float(line["solid_angle"]) for line in lines] == arrays["solid_angle"].tolist()
        assert [line["face"] for line in lines] == arrays["names"][arrays["face"]].tolist()
        pieces = 0
        for k in range(3):
            for m in range(arrays["begin"][k], arrays["begin"][k + 1]):
                name = arrays["names"][arrays["face"][m]]
                assert same(float(lines[m]["fraction"]), found[k][name])
                own = [piece for piece in found.pieces(k) if piece[0] == name] if name != "sky" else []
                assert len(own) == arrays["piece_begin"][m + 1] - arrays["piece_begin"][m]
                for piece, p in zip(own, range(arrays["piece_begin"][m], arrays["piece_begin"][m + 1])):
                    corners = slice(arrays["corner_begin"][p], arrays["corner_begin"][p + 1])
                    assert numpy.array_equal(piece[1], arrays["direction"][corners])
                    assert numpy.array_equal(piece[2], arrays["place"][corners])
                    pieces += 1
        assert pieces == len(arrays["corner_begin"]) - 1 > 30
        assert f'NumberOfCells="{pieces}"'.encode() in seen["vtu"].read_bytes()
