"""Simulations after many edits, from many threads and over many calls are what they are at the first one."""

import hashlib
import os
import random
import subprocess
import sys
import threading
import tracemalloc

import pytest

import hottel
from conftest import ROOT, SCENES

EDITS = 1000
FRESH = """
import hashlib, sys
import hottel
for line in sys.stdin:
    simulation = hottel.Simulation(hottel.Scene(__import__("json").loads(line, parse_float=__import__("decimal").Decimal)))
    print(hashlib.sha256(simulation.factors.factors.tobytes() + simulation.radiosity.upper.tobytes()
                         + simulation.light([[1, 0.25]]).tobytes()).hexdigest())
"""


def digest(simulation):
    parts = (simulation.factors.factors, simulation.radiosity.upper, simulation.light([[1, 0.25]]))
    return hashlib.sha256(b"".join(part.tobytes() for part in parts)).hexdigest()


def edited(scene, chance):
    """The scene with something of it changed."""
    kind = chance.randrange(4)
    if kind == 0:
        return scene.moved("floor", [f"{chance.randrange(-9, 10)}/100", f"{chance.randrange(-9, 1)}/100"])
    if kind == 1:
        return scene.replace(sky={"emission": chance.randrange(5)})
    materials = scene.to_dict()["materials"]
    material = materials[chance.choice(sorted(materials))]
    material["reflectivity" if kind == 2 else "emission"] = f"{chance.randrange(10)}/10"
    return scene.replace(materials=materials)


def test_a_thousand_edits_are_those_of_fresh_simulations(square):
    chance = random.Random(1)
    scene = hottel.Scene(square)
    simulation = hottel.Simulation(scene)
    texts, digests = [], []
    for k in range(EDITS):
        scene = hottel.Scene(square) if k % 50 == 0 else edited(scene, chance)
        simulation = simulation.with_scene(scene)
        texts.append(" ".join(scene.to_json().split()))
        digests.append(digest(simulation))
    done = subprocess.run([sys.executable, "-c", FRESH], input="\n".join(texts), capture_output=True, text=True,
                          env=os.environ, cwd=ROOT)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == digests and len(set(digests)) > EDITS / 3


@pytest.mark.parametrize("threads", [None, 1])
def test_many_threads_ask_one_simulation(threads):
    scene = hottel.read_scene(SCENES / "space/two_boxes.json")
    wanted = hottel.Simulation(scene).radiosity.upper.tobytes()
    simulation = hottel.Simulation(scene, threads=threads)
    found = []
    asks = [lambda: simulation.radiosity.upper.tobytes(), lambda: simulation.factors.factors and 0,
            lambda: simulation.picture(size=80).pixels.tobytes() and 0, lambda: simulation.plan and 0]

    def ask(k):
        try:
            found.append(asks[0]())
            asks[1 + k % 3]()
        except ValueError:  # the truth value of an array
            pass

    workers = [threading.Thread(target=ask, args=(k,)) for k in range(12)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert found == [wanted] * 12


def test_many_calls_leave_nothing_behind(square):
    scene = hottel.Scene(square)
    simulation = hottel.Simulation(scene)
    factors, radiosity = simulation.factors, simulation.radiosity

    def call():
        factors["floor", "walls[1]"]
        radiosity["floor"]["radiosity"]
        simulation.light([[1, 0.5]])
        simulation.visible([[1, 0.5]])[0]
        simulation.light_on([[1, 0.5]], [0, 1]).irradiance
        simulation.plan[0].reason
        scene.points("floor")
        with pytest.raises(hottel.UsageError):
            factors["floor", "nowhere"]

    for _ in range(200):
        call()
    tracemalloc.start()
    try:
        call()
        before = tracemalloc.get_traced_memory()[0]
        counts = [sys.getrefcount(each) for each in (scene, simulation, factors, radiosity, None.__class__)]
        for _ in range(10_000):
            call()
        assert tracemalloc.get_traced_memory()[0] - before < 20_000
        assert counts == [sys.getrefcount(each) for each in (scene, simulation, factors, radiosity, None.__class__)]
    finally:
        tracemalloc.stop()
