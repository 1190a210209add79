"""Exact view factors and light of scenes in the plane and in space: the library hottel itself.

read_scene(path) or Scene(dict) make a scene; Simulation(scene) computes what is asked of it, when it is asked for.
Errors are InputError, RequestError and UsageError, all of them Error. All arrays are NumPy's, and read only.
"""

from hottel._core import (
    Error,
    Factors,
    Finding,
    Frame,
    Frames,
    Grid,
    InputError,
    NetFlux,
    OrientedLight,
    Picture,
    PlannedEffect,
    Radiosity,
    Repair,
    RepairStep,
    RequestError,
    Scene,
    Simulation,
    Temperatures,
    UsageError,
    Visible,
    __version__,
    generate,
    read_scene,
)

__all__ = [
    "Error",
    "Factors",
    "Finding",
    "Frame",
    "Frames",
    "Grid",
    "InputError",
    "NetFlux",
    "OrientedLight",
    "Picture",
    "PlannedEffect",
    "Radiosity",
    "Repair",
    "RepairStep",
    "RequestError",
    "Scene",
    "Simulation",
    "Temperatures",
    "UsageError",
    "Visible",
    "__version__",
    "generate",
    "read_scene",
]
