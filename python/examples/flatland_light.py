"""Ground truth of flatland light: how the error of a sampled picture falls, against the exact light of the same cells."""

import pathlib
import sys

import hottel

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"

scene = hottel.read_scene(SCENES / "showcase/apartment.json")
exact = hottel.Simulation(scene)
rays, errors = [16, 64, 256, 1024], []
for count in rays:
    sampled = hottel.Simulation(scene, method=f"rays:{count}").grid((40, 30))
    judged = exact.compare_grid(sampled.values)
    errors.append((judged.rms_error / judged.largest).max())
    print(f"{count:5} rays a face: the light is off by {errors[-1]:.1e} of the largest, root mean square")

if len(sys.argv) > 1:  # a plot, as this file; needs matplotlib
    from matplotlib import pyplot

    pyplot.loglog(rays, errors, "o-")
    pyplot.xlabel("rays a face")
    pyplot.ylabel("error of light / largest")
    pyplot.savefig(sys.argv[1])
