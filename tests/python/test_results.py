"""What a simulation gives: arrays that fit together, that nobody can change, that are kept."""

import gc
import math
import pickle
import random
import sys
import threading
import types

import numpy
import pytest

import hottel
from conftest import SCENES


@pytest.fixture
def simulation(square):
    return hottel.Simulation(hottel.Scene(square))


def arrays_of(result):
    """All arrays that an object shows, by name."""
    found = {}
    for name in dir(result):
        value = getattr(result, name) if not name.startswith("_") else None
        if isinstance(value, numpy.ndarray):
            found[name] = value
    return found


def test_arrays_cannot_be_changed(simulation):
    results = [simulation.factors, simulation.radiosity, simulation.temperatures, simulation.flux,
               simulation.visible([[1, 0.5]])]
    arrays = [array for result in results for array in arrays_of(result).values()]
    arrays += [simulation.light([[1, 0.5]]), simulation.scene.points("floor"), simulation.radiosity["floor"]["radiosity"],
               simulation.factors.columns()["factor"], simulation.radiosity.columns()["net"]]
    assert len(arrays) > 25
    for array in arrays:
        assert not array.flags.writeable
        with pytest.raises(ValueError):
            array.flags.writeable = True
        with pytest.raises(ValueError):
            array[...] = 0


def test_what_a_caller_owns_changes_nothing(simulation):
    before = simulation.factors.factors.copy()
    matrix = simulation.factors.to_scipy(copy=True)
    matrix.data[:] = 0
    matrix.indices[:] = 0
    simulation.radiosity.energy["emitted"] = 0
    simulation.factors["floor", "sky"]["factor"] = 7
    assert (simulation.factors.factors == before).all()
    assert (simulation.factors.to_scipy().toarray() == before).all()
    assert simulation.radiosity.energy["emitted"] == 2


@pytest.mark.parametrize("quantity", ["factor", "lower", "upper", "visibility"])
def test_sparse_matrices_share_the_arrays_of_the_library(simulation, quantity):
    matrix, again = simulation.factors.to_scipy(quantity), simulation.factors.to_scipy(quantity)
    own = simulation.factors.to_scipy(quantity, copy=True)
    begins, columns, values = simulation.factors.arrays(quantity)
    for mine, other, told in ((matrix.data, again.data, values), (matrix.indices, again.indices, columns)):
        assert numpy.shares_memory(mine, other) and numpy.shares_memory(mine, told)
        assert not numpy.shares_memory(mine, own.data) and not numpy.shares_memory(mine, own.indices)
    assert (matrix.indptr == begins).all() and matrix.indices.dtype == matrix.indptr.dtype == columns.dtype == numpy.int32
    assert matrix.has_canonical_format
    assert (matrix != own).nnz == 0


def test_what_is_shared_cannot_be_written(simulation):
    before = simulation.factors.factors.copy()
    matrix = simulation.factors.to_scipy()
    for array in (matrix.data, matrix.indices, *simulation.factors.arrays("upper"), *simulation.factors.arrays()):
        with pytest.raises(ValueError):
            array[...] = 0
        with pytest.raises(ValueError):
            array.flags.writeable = True
    with pytest.raises(ValueError):
        matrix *= 2
    with pytest.raises(ValueError):
        matrix[0, matrix.indices[0]] = 7
    assert (simulation.factors.to_scipy().toarray() == before).all()
    assert ((2 * matrix).toarray() == 2 * before).all() and ((matrix @ numpy.ones(9)) == before.sum(axis=1)).all()


def test_sparse_matrices_outlive_what_they_come_from(square):
    simulation = hottel.Simulation(hottel.Scene(square), elements=50)
    matrix, (_, columns, values) = simulation.factors.to_scipy("visibility"), simulation.factors.arrays()
    wanted = matrix.data.copy(), columns.copy(), values.copy()
    del simulation
    gc.collect()
    others = [hottel.Simulation(hottel.Scene(square), elements=49 + k).factors.to_scipy() for k in range(3)]
    assert len(others) == 3
    for array, copy in zip((matrix.data, columns, values), wanted):
        assert (array == copy).all()


def test_a_scene_without_surfaces_has_empty_arrays():
    factors = hottel.Simulation(hottel.Scene({"dimension": 2, "edges": []})).factors
    begins, columns, values = factors.arrays()
    assert begins.tolist() == [0, 0] and columns.shape == values.shape == (0,)
    assert factors.to_scipy().nnz == 0 and not values.flags.writeable and not columns.flags.writeable


def test_a_unit_that_nobody_knows_gives_no_watts(square):
    known = hottel.Simulation(hottel.Scene(dict(square, unit="mm")))
    unknown = hottel.Simulation(hottel.Scene(dict(square, unit="furlong")))
    assert (known.factors.factors == unknown.factors.factors).all()
    assert (known.radiosity.radiosity == unknown.radiosity.radiosity).all()
    assert numpy.allclose(known.radiosity.areas * 1000, unknown.radiosity.areas)
    assert known.radiosity.energy["emitted"] == 0.002
    assert numpy.isfinite(known.flux.net).all()
    assert all(math.isnan(power) for power in unknown.radiosity.energy.values())
    for column in (unknown.flux.net, unknown.flux.lower, unknown.flux.upper):
        assert numpy.isnan(column).all()


def test_arrays_outlive_what_they_come_from(square):
    factors = hottel.Simulation(hottel.Scene(square)).factors.factors
    gc.collect()
    assert sorted(factors.sum(axis=1)) == pytest.approx([0] * 5 + [1] * 4)  # black backs and the sky have no rows


def test_factors_fit_together(simulation):
    factors = simulation.factors
    n = len(factors)
    assert factors.names[-1] == "sky" and len(factors.names) == n == 9
    assert factors.guarantee == "exact"
    for name in ("factors", "lower", "upper", "visibility"):
        assert getattr(factors, name).shape == (n, n) and getattr(factors, name).dtype == numpy.float64
    assert factors.areas.tolist()[:-1] == [2, 2, 1, 1, 2, 2, 1, 1] and math.isnan(factors.areas[-1])
    assert (factors.lower <= factors.factors).all() and (factors.factors <= factors.upper).all()
    floor, top = factors.index("floor"), factors.index("walls[1]")
    assert factors.factors[floor, top] == pytest.approx((math.sqrt(5) - 1) / 2, abs=1e-16)
    assert factors["floor", "walls[1]"] == {"factor": factors.factors[floor, top], "lower": factors.lower[floor, top],
                                            "upper": factors.upper[floor, top], "guarantee": "exact"}
    assert factors["floor", "sky"]["factor"] == 0
    assert factors.visibility[floor, top] == 1 and math.isnan(factors.visibility[floor, floor])
    assert factors.to_names("floor") == factors.from_names("floor") == ("walls[0]", "walls[1]", "walls[2]")
    assert factors.from_names("sky") == ()
    for quantity in ("factor", "lower", "upper"):
        assert (factors.to_scipy(quantity).toarray() == getattr(factors, quantity.replace("factor", "factors"))).all()
    columns = factors.columns()
    assert list(columns) == ["from", "to", "factor", "lower", "upper", "guarantee"]
    assert {len(column) for column in columns.values()} == {factors.to_scipy().nnz}


def test_hidden_pairs_have_the_visibility_0(square):
    square["edges"].append({"name": "screen", "material": "grey", "points": [[0, 0.5], [2, 0.5]]})
    factors = hottel.Simulation(hottel.Scene(square)).factors
    pair = factors.index("floor"), factors.index("walls[1]")
    assert factors.factors[pair] == factors.visibility[pair] == 0


def test_radiosities_solve_their_equations(simulation):
    table, factors = simulation.radiosity, simulation.factors
    assert table.names == ("floor", "walls[0]", "walls[1]", "walls[2]") and table.channels == ("all",)
    places = [factors.index(name) for name in table.names]
    rows = factors.factors[places][:, places]
    assert table.radiosity == pytest.approx(table.emission + table.reflectivity * (rows @ table.radiosity), rel=1e-14)
    assert (table.lower <= table.radiosity).all() and (table.radiosity <= table.upper).all()
    assert (table.upper - table.lower).max() < 1e-14 and table.guarantee == "enclosed"
    assert (table.net == table.radiosity - table.irradiance).all()
    assert table["floor"]["radiosity"] == table.radiosity[table.index("floor")]
    energy = table.energy
    assert energy["emitted"] == pytest.approx(energy["absorbed"] + energy["to_sky"] + energy["defect"])
    assert simulation.flux.net.sum() == pytest.approx(0, abs=1e-14)
    assert len(simulation.temperatures) == 0 and simulation.temperatures.temperature.shape == (0, 1)
    assert list(table.columns())[:4] == ["name", "channel", "area", "radiosity"]


def test_temperatures_have_bounds():
    table = hottel.Simulation(hottel.read_scene(SCENES / "heat/street_canyon.json")).temperatures
    assert len(table) > 0
    assert (table.lower <= table.temperature).all() and (table.temperature <= table.upper).all()
    flux = hottel.Simulation(hottel.read_scene(SCENES / "heat/street_canyon.json")).flux
    assert flux.names[-1] == "sky" and math.isnan(flux.areas[-1])
    assert 200 < table.temperature.min() and table.temperature.max() < 400


def test_light_at_points_in_the_plane(simulation):
    light = simulation.light([[1, 0.5], [0.25, 0.75], [5, 5]])
    assert light.shape == (3, 1)
    table = simulation.radiosity
    assert ((table.radiosity.min() < light[:2]) & (light[:2] < table.radiosity.max())).all()
    assert light[2] == 0  # outside, where backs are black
    assert (simulation.light([[0.1, 0.1]]) != simulation.light([[0.1, 0.1]], binary=True)).sum() <= 1


def test_light_in_an_even_furnace_is_even_everywhere():
    simulation = hottel.Simulation(hottel.read_scene(SCENES / "analytic/furnace.json"))
    value = simulation.radiosity.radiosity[0, 0]
    assert simulation.radiosity.radiosity == pytest.approx(value)
    assert simulation.light([[0.5, 0.5]])[0, 0] == pytest.approx(value, rel=1e-13)


def test_light_at_points_in_space():
    simulation = hottel.Simulation(hottel.read_scene(SCENES / "space/cube.json"))
    light = simulation.light([[0.5, 0.5, 0.5], [0.5, 0.5, 0.75]])
    assert light.shape == (2, len(simulation.radiosity.channels))
    assert (light > simulation.radiosity.radiosity.min()).all() and (light < simulation.radiosity.radiosity.max()).all()


def test_visibility_polygons(simulation):
    seen = simulation.visible([[1, 0.5], [0.1, 0.1]])
    assert len(seen) == 2 and seen.begin.tolist() == [0, 4, 8]
    assert sorted(map(tuple, seen[0].tolist())) == [(0, 0), (0, 1), (2, 0), (2, 1)]
    assert set(seen.sides(0)) == {"floor", "walls[0]", "walls[1]", "walls[2]"} == set(seen.names)
    assert (seen[-1] == seen[1]).all() and seen.xy.shape == (8, 2) and seen.face.shape == (8,)
    near = simulation.visible([[1, 0.5]], range="1/4")
    assert near.names == ("#range",) and near[0].tolist() == [[1.25, 0.5]]


def test_a_wall_that_a_point_is_on_is_exactly_there(square):
    square["edges"].append({"name": "shelf", "material": "grey", "points": [[0.5, 0.1], [1.5, 0.1]]})
    simulation = hottel.Simulation(hottel.Scene(square))
    on, above = simulation.visible([[1, 0.1]]), simulation.visible([[1, 0.1]], binary=True)
    assert on[0][:, 1].min() == 0  # both sides are seen from a wall
    assert above[0][:, 1].min() > 0.09  # the double nearest to one tenth is above it


def test_a_float_is_its_shortest_decimal_at_any_size():
    generator = random.Random(1)
    numbers = [generator.choice([-1, 1]) * round(generator.random(), generator.randrange(1, 17)) * 10.0 ** generator.randrange(-12, 22)
               for _ in range(150)]
    for number in [*numbers, 0.5, 2.5, 1e-19, 1.5e-19, 3e-300, 123456789.0, 1e22, 5e-324, 0.1, -0.3, 7e15, 1 / 3]:
        text = repr(number)
        wall = {"name": "wall", "material": "grey", "points": [[text, -1], [text, 1]]}
        scene = hottel.Scene({"dimension": 2, "materials": {"grey": {"reflectivity": 0.5}}, "edges": [wall]})
        simulation = hottel.Simulation(scene)
        seen = simulation.visible([[number, 0], [numpy.nextafter(number, numpy.inf), 0]])
        assert set(seen.sides(0)) == {"sky"}, text  # on the wall it is in nobody's way
        assert set(seen.sides(1)) > {"sky"}, text


def test_what_many_points_see_is_what_each_sees():
    simulation = hottel.Simulation(hottel.read_scene(SCENES / "showcase/apartment.json"), per="face")
    points = numpy.random.default_rng(1).integers(0, 900, (3000, 2)) / 100
    seen, met = simulation.visible(points), []
    for k in range(0, 3000, 7):
        alone = simulation.visible(points[k:k + 1])
        assert (alone[0] == seen[k]).all() and alone.sides(0) == seen.sides(k)
    for name in (seen.names[place] for place in seen.face):
        if name not in met:
            met.append(name)
    assert tuple(met) == seen.names


def test_results_are_kept(simulation):
    for name in ("factors", "radiosity", "temperatures", "flux", "group_flux", "light_flux"):
        assert getattr(simulation, name) is getattr(simulation, name)
    assert simulation.factors.factors is simulation.factors.factors


def test_edits_share_what_does_not_change(square):
    day = hottel.Simulation(hottel.Scene(square))
    square["materials"]["warm"]["emission"] = 2
    night = day.with_scene(hottel.Scene(square))
    assert night.scene == hottel.Scene(square)
    assert (night.factors.factors == day.factors.factors).all()
    assert (night.radiosity.radiosity == hottel.Simulation(hottel.Scene(square)).radiosity.radiosity).all()
    assert (night.radiosity.radiosity > day.radiosity.radiosity).all()


def test_many_threads_may_ask(square):
    simulation = hottel.Simulation(hottel.Scene(square), elements=8)
    wanted = hottel.Simulation(hottel.Scene(square), elements=8).radiosity.radiosity
    found = []
    threads = [threading.Thread(target=lambda: found.append(simulation.radiosity.radiosity)) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 8 and all((each == wanted).all() for each in found)


def test_errors_can_be_sent_to_other_processes(square):
    square["edges"][0]["points"][1] = square["edges"][0]["points"][0]
    with pytest.raises(hottel.InputError) as refused:
        hottel.Scene(square)
    again = pickle.loads(pickle.dumps(refused.value))
    assert type(again) is hottel.InputError
    assert (again.surface, again.reason, again.hints) == ("floor", refused.value.reason, ())


def test_tables_are_frames_of_pandas(simulation, monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", types.SimpleNamespace(DataFrame=lambda columns: ("frame", list(columns))))
    for table in (simulation.factors, simulation.radiosity, simulation.temperatures, simulation.flux):
        assert table.to_pandas() == ("frame", list(table.columns()))
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError):
        simulation.radiosity.to_pandas()


def test_what_no_light_reaches_is_told():
    table = hottel.Simulation(hottel.read_scene(SCENES / "degenerate/mirror_cell_dark.json")).radiosity
    assert len(table.notes) > 0 and all(isinstance(note, str) for note in table.notes)
