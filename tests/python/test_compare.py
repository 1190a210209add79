"""Methods and results of others, judged as `hottel compare` judges them."""

import json
import math

import numpy
import pytest
import scipy.sparse

import hottel
from conftest import ROOT, run_program, table_of

PLANE, SPACE = "scenes/analytic/strip_obstructed.json", "scenes/space/two_boxes.json"


def simulation_of(scene, **options):
    return hottel.Simulation(hottel.read_scene(ROOT / scene), **options)


def compared(scene, folder, *options):
    """What the program compares: lines of compare.csv, lines of worst.csv, notes by method."""
    code, text, message = run_program("compare", scene, "-o", folder, "--repeat", 1, "--json", *options)
    assert code == 0, message
    notes = {method["method"]: method["notes"] for method in json.loads(text)["methods"]}
    return table_of((folder / "compare.csv").read_text()), table_of((folder / "worst.csv").read_text()), notes


def assert_same_numbers(judgement, line):
    for column in ("max_error", "rms_error", "closure", "max_radiosity_error"):
        assert float(line[column]) == getattr(judgement, column), column


@pytest.mark.parametrize("scene", [PLANE, SPACE])
@pytest.mark.parametrize("method", ["exact", "gauss:2", "rays:64", "hemicube:64:normalised", "center"])
def test_methods_are_judged_as_by_the_program(scene, method, tmp_path):
    lines, worst, _ = compared(scene, tmp_path, "--methods", method)
    judgement = simulation_of(scene).compare(method, repeat=1)
    assert judgement.method == method and judgement.seconds > 0 and judgement.verdict is None
    assert_same_numbers(judgement, lines[0])
    assert len(judgement.worst) == len(worst)
    for pair, line in zip(judgement.worst, worst):
        assert (pair.from_name, pair.to_name, pair.reason) == (line["from"], line["to"], line["reason"])
        assert (pair.value, pair.exact) == (float(line["value"]), float(line["exact"]))


def wrong(factors):
    """A matrix in which a mistake is made: half of everything."""
    return factors / 2


@pytest.mark.parametrize("scene", [PLANE, SPACE])
@pytest.mark.parametrize("mistake", [lambda f: f, wrong, numpy.transpose, lambda f: f.astype(numpy.float32)])
def test_a_matrix_is_judged_as_its_file_is(scene, mistake, tmp_path):
    simulation = simulation_of(scene)
    matrix = numpy.ascontiguousarray(mistake(simulation.factors.factors))
    numpy.save(tmp_path / "own.npy", matrix)
    lines, _, notes = compared(scene, tmp_path, "--methods", f"file:{tmp_path / 'own.npy'}")
    judgement = simulation.compare(matrix)
    assert_same_numbers(judgement, lines[0])
    assert judgement.method == "array" and math.isnan(judgement.seconds)
    told = next(iter(notes.values()))
    assert list(judgement.verdict.sentences) == told[len(told) - len(judgement.verdict.sentences):]
    assert (judgement.verdict.off == 0) == (judgement.max_error < 1e-7)


def test_a_fault_is_named_with_its_evidence():
    simulation = simulation_of(PLANE)
    verdict = simulation.compare(wrong(simulation.factors.factors)).verdict
    assert verdict.off == verdict.pairs > 0 and verdict.unexplained == 0 and verdict.rows_off > 0
    fault = verdict.findings[0]
    assert fault.parts == ("constant-factor",)
    assert fault.kind == "constant-factor" and fault.explained == verdict.off and "1/2" in fault.words
    from_name, to_name, value, exact = fault.worst[0]
    assert value == exact / 2 == simulation.factors[from_name, to_name]["factor"] / 2
    assert "Verdict" in repr(verdict) and "constant-factor" in repr(fault)


class Frame:
    """What looks like a data frame."""

    def __init__(self, values, names):
        self.values, self.index, self.columns = values, names, names

    def to_numpy(self):
        return self.values


def test_matrices_of_every_kind_are_the_same():
    simulation = simulation_of(PLANE)
    factors, names = simulation.factors.factors, simulation.factors.names
    order = numpy.arange(len(names))[::-1]
    turned, turned_names = factors[numpy.ix_(order, order)], [names[k] for k in order]
    for each in (factors, factors.tolist(), scipy.sparse.csr_matrix(factors), scipy.sparse.coo_matrix(factors),
                 scipy.sparse.csc_array(factors), simulation.factors, Frame(turned, turned_names), factors[:-1, :-1]):
        assert simulation.compare(each).max_error <= 1e-16
    assert simulation.compare(turned, names=turned_names).verdict.off == 0
    assert simulation.compare(turned).verdict.off > 0


def test_what_is_no_matrix():
    simulation = simulation_of(PLANE)
    n = len(simulation.factors)
    for matrix in (numpy.zeros((2, 3)), numpy.zeros(n), numpy.zeros((n, n, 1)), numpy.full((n, n), math.nan), [],
                   numpy.zeros((0, 0)), [[1, 2], [3]], 3.0):
        with pytest.raises(hottel.InputError):
            simulation.compare(matrix)
    for matrix in (None, numpy.zeros((n, n), dtype=complex), numpy.zeros((n, n), dtype=object), [["a"]], b"x", {1: 2},
                   numpy.zeros((n, n), dtype=bool), scipy.sparse.eye(n, dtype=complex)):
        with pytest.raises(TypeError):
            simulation.compare(matrix)
    matrix = simulation.factors.factors
    with pytest.raises(hottel.InputError, match="names"):
        simulation.compare(matrix, names=["a"])
    with pytest.raises(hottel.InputError, match="no face"):
        simulation.compare(matrix, names=["x"] + list(simulation.factors.names[1:]))
    for names in ("abc", [1] * n, 3):
        with pytest.raises(TypeError):
            simulation.compare(matrix, names=names)
    for options in ({"beyond": -1}, {"beyond": math.nan}, {"worst": -1}, {"repeat": 0}):
        with pytest.raises(hottel.UsageError):
            simulation.compare(matrix, **options)
    for method in ("guess", "gauss:-1", "", "file:"):
        with pytest.raises(hottel.UsageError):
            simulation.compare(method)
    with pytest.raises(hottel.UsageError):
        simulation.compare("exact", names=["a"])
    with pytest.raises(hottel.InputError):
        simulation.compare("file:/nowhere/own.csv")


@pytest.mark.parametrize("scene", ["scenes/analytic/square_radiosity.json", SPACE])
def test_radiosities_are_judged_as_their_file_is(scene, tmp_path):
    simulation = simulation_of(scene)
    exact = simulation.radiosity
    judgement = simulation.compare_radiosities(exact.radiosity)
    assert (judgement.outside, judgement.max_error, judgement.hypothesis) == (0, 0, "")
    assert judgement.count == exact.radiosity.size
    judgement = simulation.compare_radiosities(exact.irradiance)
    assert judgement.outside > 0 and judgement.worst and "irradiance" in judgement.hypothesis
    code, _, _ = run_program("solve", scene, "-o", tmp_path, "--no-picture", "--no-illumination")
    text = (tmp_path / "radiosity.csv").read_text()
    lines = table_of(text)
    with open(tmp_path / "own.csv", "w") as own:
        own.write("face,element,channel,radiosity\n")
        for line in lines:
            own.write(f"{line['face']},{line['element']},{line['channel']},{2 * float(line['radiosity'])!r}\n")
    _, _, notes = compared(scene, tmp_path / "out", "--methods", f"file:{tmp_path / 'own.csv'}")
    judgement = simulation.compare_radiosities(2 * exact.radiosity)
    assert list(judgement.sentences) == notes[f"file:{tmp_path / 'own.csv'}"]


def test_what_are_no_radiosities():
    simulation = simulation_of("scenes/analytic/square_radiosity.json")
    n = len(simulation.radiosity)
    assert simulation.compare_radiosities(simulation.radiosity.radiosity.ravel()).outside == 0
    for values in (numpy.zeros(n + 1), numpy.zeros((n, 2)), numpy.full(n, math.inf), [], [[1], [1, 2]], 1.0):
        with pytest.raises(hottel.InputError):
            simulation.compare_radiosities(values)
    for values in (None, "text", numpy.zeros(n, dtype=complex)):
        with pytest.raises(TypeError):
            simulation.compare_radiosities(values)


def test_grids_are_judged_as_their_file_is(tmp_path):
    scene = "scenes/heat/street_canyon.json"
    simulation = simulation_of(scene)
    light = simulation.grid().values
    exact = simulation.compare_grid(light)
    assert exact.off.sum() == 0 and exact.max_error.max() < 1e-9 * exact.largest.max() and exact.reading == ""
    turned = numpy.ascontiguousarray(light[::-1] * 2)
    numpy.save(tmp_path / "own.npy", turned)
    code, text, message = run_program("compare", scene, "--grid-file", tmp_path / "own.npy", "-o", tmp_path, "--json")
    assert code == 0, message
    judgement = simulation.compare_grid(turned)
    line = table_of((tmp_path / "grid.csv").read_text())[0]
    assert float(line["max_error"]) == judgement.max_error[0] and int(line["cells"]) == judgement.cells[0]
    assert float(line["rms_error"]) == judgement.rms_error[0] and int(line["missing"]) == judgement.missing[0]
    assert "upside down" in judgement.reading and any(judgement.reading in each for each in judgement.sentences)


def test_what_is_no_grid():
    simulation = simulation_of(PLANE)
    for values in (numpy.zeros(3), numpy.zeros((2, 2, 3)), numpy.zeros((2, 2, 1, 1)), [[1], [1, 2]]):
        with pytest.raises(hottel.InputError):
            simulation.compare_grid(values)
    with pytest.raises(hottel.UsageError):
        simulation.compare_grid(numpy.zeros((0, 2)))
    with pytest.raises(TypeError):
        simulation.compare_grid("text")
    over = {"origin": [0, 0, "1/2"], "u": [1, 0, 0], "v": [0, 1, 0], "cells": [4, 3]}
    space = simulation_of("scenes/space/cube.json")
    assert space.compare_grid(space.grid(over=over).values, over=over).max_error[0] < 1e-12
    with pytest.raises(hottel.UsageError):
        space.compare_grid(numpy.zeros((2, 2)))
