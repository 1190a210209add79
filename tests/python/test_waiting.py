"""Long work lets others run, tells how far it is, and ends when it is asked to."""

import os
import signal
import threading
import time

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
    longest, before = 0, time.monotonic()
    while not done.wait(0.001):
        longest, before = max(longest, time.monotonic() - before), time.monotonic()
    worker.join()
    assert 0 < longest < 0.5


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


def test_ctrl_c_ends_the_work_and_it_can_be_asked_for_again():
    simulation = long_work()
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        simulation.factors
    assert time.monotonic() - begin < 2
    timer.join()
    assert (simulation.factors.factors == long_work().factors.factors).all()


def test_ctrl_c_ends_the_light_of_many_points(square):
    simulation = hottel.Simulation(hottel.Scene(square))
    simulation.radiosity
    points = numpy.random.default_rng(1).random((2_000_000, 2))
    timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        simulation.light(points)
    assert time.monotonic() - begin < 2
    timer.join()
