"""A room in space, made of numbers: who sees whom, how bright its faces are, and the light in the middle."""

import sys

import hottel

corners = [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0], [0, 0, 2.5], [4, 0, 2.5], [4, 3, 2.5], [0, 3, 2.5]]
faces = {"floor": (0, 1, 2, 3), "ceiling": (7, 6, 5, 4), "south": (4, 5, 1, 0), "east": (5, 6, 2, 1),
         "north": (6, 7, 3, 2), "west": (7, 4, 0, 3)}
scene = hottel.Scene({
    "dimension": 3,
    "closed": True,
    "materials": {"white": {"reflectivity": 0.8}, "panel": {"reflectivity": 0.8, "emission": 100}},
    "polygons": [{"name": name, "material": "panel" if name == "ceiling" else "white",
                  "points": [corners[k] for k in places]} for name, places in faces.items()],
})

simulation = hottel.Simulation(scene, elements=2, tolerance=1e-9)
print(f"{len(simulation.factors) - 1} elements, factors {simulation.factors.guarantee}")
light = simulation.radiosity
for name in ("floor#0", "south#0", "ceiling#0"):
    print(f"{name:10} {light[name]['radiosity'][0]:9.4f} W/m2, within {(light[name]['upper'] - light[name]['lower'])[0]:.0e}")
print(f"in the middle {simulation.light([[2, 1.5, 1.25]])[0, 0]:.4f} W/m2")
if len(sys.argv) > 1:  # a picture, as this file
    simulation.picture(shading="smooth").save(sys.argv[1])
