#!/usr/bin/env python3
"""A window that shrinks in the end wall of a room of 5 m by 4 m by 2.6 m: what hemicubes make of it.

From 125 elements of floor, ceiling and three walls, the factor to the window by `hemicube:R`, against that of the same
point by exact visibility (points:1). The table of docs/accuracy_in_space.md; run from the root of the repository.
"""
import csv
import json
import math
import subprocess
import tempfile

HOTTEL = "build/release/hottel"


def scene(side):
    y0, y1, z0, z1 = (round(v, 6) for v in (2 - side / 2, 2 + side / 2, 1.6, 1.6 + side))
    walls = {
        "floor": [[0, 0, 0], [5, 0, 0], [5, 4, 0], [0, 4, 0]],
        "ceiling": [[0, 0, 2.6], [0, 4, 2.6], [5, 4, 2.6], [5, 0, 2.6]],
        "south": [[0, 0, 0], [0, 0, 2.6], [5, 0, 2.6], [5, 0, 0]],
        "north": [[0, 4, 0], [5, 4, 0], [5, 4, 2.6], [0, 4, 2.6]],
        "west": [[0, 0, 0], [0, 4, 0], [0, 4, 2.6], [0, 0, 2.6]],
    }
    window = [[5, y0, z0], [5, y0, z1], [5, y1, z1], [5, y1, z0]]
    polygons = [{"name": n, "points": p, "material": "m", "elements": 5} for n, p in walls.items()]
    polygons.append({"name": "east", "points": [[5, 0, 0], [5, 0, 2.6], [5, 4, 2.6], [5, 4, 0]], "holes": [window], "material": "m"})
    polygons.append({"name": "window", "points": window, "material": "m"})
    return {"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": polygons, "closed": True}


def to_window(folder, method):
    command = [HOTTEL, "factors", f"{folder}/room.json", "--per", "element", "--method", method, "--quiet", "-o", f"{folder}/f.csv"]
    subprocess.run(command, check=True)
    with open(f"{folder}/f.csv") as file:
        return {r["from"]: float(r["factor"]) for r in csv.DictReader(file) if r["to"] == "window"}


def deviation(found, reference):
    return math.sqrt(sum((found.get(k, 0) / f - 1) ** 2 for k, f in reference.items()) / len(reference))


with tempfile.TemporaryDirectory() as folder:
    print("| window | centre | " + " | ".join(f"{r} pixels" for r in (64, 128, 256, 512, 1024)) + " |")
    for side in (1, 0.4, 0.2, 0.1, 0.05, 0.02):
        with open(f"{folder}/room.json", "w") as file:
            json.dump(scene(side), file)
        exact, point = to_window(folder, "exact"), to_window(folder, "points:1")
        cells = [f"{side} m", f"{deviation(point, exact):.2g}"]
        for resolution in (64, 128, 256, 512, 1024):
            cube = to_window(folder, f"hemicube:{resolution}")
            lost = sum(cube.get(k, 0) == 0 for k in point)
            cells.append(f"{deviation(cube, point):.2g}" + (f", {lost} lost" if lost else ""))
        print("| " + " | ".join(cells) + " |", flush=True)
