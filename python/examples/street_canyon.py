"""A street between two houses at night: how warm its ground and walls are, between proven bounds."""

import pathlib
import sys

import hottel

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"

scene = hottel.read_scene(SCENES / "heat/street_canyon.json")
simulation = hottel.Simulation(scene)
warm = simulation.temperatures
for row, name in enumerate(warm.names):
    kelvin, lower, upper = warm.temperature[row, 0], warm.lower[row, 0], warm.upper[row, 0]
    if name.startswith("east#"):  # an insulated wall: its temperature is what comes out
        print(f"{name:8} {kelvin - 273.15:7.3f} degrees C, proven within {upper - lower:.0e} K")

sky = simulation.flux["sky"]["net"][0]
print(f"The sky takes {-sky:.3f} W from each metre of the street.")
if len(sys.argv) > 1:  # a picture, as this file
    simulation.picture("temperature", size=800).save(sys.argv[1])
