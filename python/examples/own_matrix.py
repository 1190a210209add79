"""A matrix of one's own solver, here by random rays, held against the exact one: where it is off, and what by."""

import pathlib

import hottel

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"

scene = hottel.read_scene(SCENES / "analytic/strip_obstructed.json")
simulation = hottel.Simulation(scene)
own = hottel.Simulation(scene, method="rays:256").factors.factors.copy()

judgement = simulation.compare(own)
print(f"off by {judgement.max_error:.1e} at most, radiosities by {judgement.max_radiosity_error:.1e}")
worst = judgement.worst[0]
print(f"worst: {worst.from_name} -> {worst.to_name}, {worst.reason}: {worst.value:.6f}, exact {worst.exact:.6f}")

own *= 2  # a mistake that is often made: half angles for whole ones
verdict = simulation.compare(own).verdict
assert verdict is not None  # there is one of every matrix
print(*verdict.sentences, sep="\n")
