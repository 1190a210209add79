"""A matrix of one's own solver, here by random rays, held against the exact one: where it is off, and what by."""

import pathlib

import numpy

import hottel

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"

scene = hottel.read_scene(SCENES / "analytic/strip_obstructed.json")
exact = hottel.Simulation(scene).factors
own = hottel.Simulation(scene, method="rays:256").factors.factors

difference = own - exact.factors
worst = numpy.unravel_index(numpy.abs(difference).argmax(), difference.shape)
print("worst:", exact.names[worst[0]], "->", exact.names[worst[1]])
print(f"  exact {exact.factors[worst]:.6f}, own {own[worst]:.6f}, off by {difference[worst]:+.1e}")

areas = numpy.nan_to_num(exact.areas)
for name, matrix in (("exact", exact.factors), ("own", own)):
    rows = matrix.sum(axis=1)[:-1]
    exchange = areas[:, None] * matrix
    print(f"{name}: rows sum to 1 within {numpy.abs(rows[rows > 0] - 1).max():.0e},", end=" ")
    print(f"reciprocity within {numpy.abs(exchange - exchange.T)[:-1, :-1].max():.0e}")
