"""What is seen from 10,000 places of a map: exact visibility polygons, and how far and wide they reach."""

import time

import numpy

import hottel

sea = {"type": "Polygon", "coordinates": [[[0, 0], [100, 0], [100, 100], [0, 100], [0, 0]]] + [
    [[x, y], [x + 3, y + 1], [x + 2, y + 4], [x, y]] for x in range(5, 95, 10) for y in range(5, 95, 10)]}
scene = hottel.SceneBuilder(2).add_material("coast").add_shape("sea", sea, "coast").build()
simulation = hottel.Simulation(scene, per="face")

places = numpy.random.default_rng(1).integers(1, 1000, (10_000, 2)) / 10
begin = time.monotonic()
seen = simulation.visible(places, range=25)
print(f"{len(seen)} places among {len(scene)} coasts: {time.monotonic() - begin:.2f} s, {len(seen.xy)} corners")

on_water = [k for k in range(len(seen)) if len(seen[k]) > 2]
print(f"{len(seen) - len(on_water)} of them on land")
coasts = [len({side for side in seen.sides(k) if not side.startswith("#")}) for k in on_water]
best = on_water[int(numpy.argmax(coasts))]
print(f"most coasts at once, {max(coasts)}, are seen from ({places[best][0]}, {places[best][1]})")
