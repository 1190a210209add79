"""Long work lets others run, tells how far it is, and ends when it is asked to."""

import io
import os
import signal
import sys
import threading
import time
import types

import numpy
import pytest

import hottel
from conftest import SCENES


def long_work(**options):
    """A simulation that takes some seconds."""
    return hottel.Simulation(hottel.read_scene(SCENES / "space/two_boxes.json"), elements=4, tolerance=1e-6, **options)


def test_other_threads_run_meanwhile():
    done = threading.Event()
    simulation = long_work()

    def work():
        try:
            simulation.factors
        finally:
            done.set()

    worker = threading.Thread(target=work)
    worker.start()
    turns = 0
    while not done.wait(0.001):
        turns += 1
    worker.join()
    assert turns > 20  # with the lock of the interpreter held there would be one


def test_progress_is_told():
    told = []
    long_work(progress=lambda stage, fraction: told.append((stage, fraction))).radiosity
    assert "view factors" in {stage for stage, _ in told}
    assert all(0 <= fraction <= 1 for _, fraction in told)
    fractions = [fraction for stage, fraction in told if stage == "view factors"]
    assert fractions == sorted(fractions)


def test_what_progress_throws_ends_the_work():
    def stop(stage, fraction):
        raise LookupError("enough")

    simulation = long_work(progress=stop)
    for _ in range(2):
        begin = time.monotonic()
        with pytest.raises(LookupError, match="enough"):
            simulation.factors
        assert time.monotonic() - begin < 2


class CtrlC:
    """Progress that has Ctrl-C pressed, by another thread, when a stage is first told of."""

    def __init__(self, stage):
        self.stage = stage
        self.hand = threading.Thread(target=os.kill, args=(os.getpid(), signal.SIGINT))

    def __call__(self, stage, fraction):
        if stage == self.stage and not self.hand.ident:
            self.hand.start()


def test_ctrl_c_ends_the_work_and_it_can_be_asked_for_again():
    simulation = long_work(progress=CtrlC("view factors"))
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        simulation.factors
    assert time.monotonic() - begin < 2
    assert (simulation.factors.factors == long_work().factors.factors).all()


def test_ctrl_c_ends_the_light_of_many_points(square):
    simulation = hottel.Simulation(hottel.Scene(square), progress=CtrlC("light at points"))
    points = numpy.random.default_rng(1).random((1_000_000, 2))
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        simulation.light(points)
    assert time.monotonic() - begin < 2


def test_a_bar_is_a_line_for_each_stage(monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)  # as where it is not installed
    file = io.StringIO()
    bar = hottel.ProgressBar(file)
    long_work(progress=bar).radiosity
    bar.close()
    lines = file.getvalue().splitlines()
    assert any("view factors: " in line for line in lines) and file.getvalue().endswith("\n")
    bar.close()  # once more ends nothing
    assert file.getvalue().splitlines() == lines


def test_a_bar_is_that_of_tqdm_where_it_is_installed(monkeypatch):
    told = []

    class Bar:
        def __init__(self, **options):
            told.append(options["desc"])

        def update(self, percent):
            told.append(percent)

        def close(self):
            told.append("closed")

    monkeypatch.setitem(sys.modules, "tqdm.auto", types.SimpleNamespace(tqdm=Bar))
    bar = hottel.ProgressBar()
    for stage, fraction in (("one", 0), ("one", 0.5), ("one", 0.5), ("two", 1)):
        bar(stage, fraction)
    bar.close()
    assert told == ["one", 0, 50, "closed", "two", 100, "closed"]
