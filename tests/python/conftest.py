"""What the tests of the module share: the scenes of the repository, and the program."""

import csv
import os
import pathlib
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "scenes"


def table_of(text):
    """The lines of a csv as dicts."""
    return list(csv.DictReader(text.splitlines()))


def run_program(*arguments):
    """Runs the program; returns its exit code, standard output and standard error."""
    done = subprocess.run(
        [os.environ["HOTTEL_PROGRAM"], *map(str, arguments)], capture_output=True, text=True, cwd=ROOT
    )
    return done.returncode, done.stdout, done.stderr


@pytest.fixture
def square():
    """A room of 2 by 1, its floor warm, its walls grey."""
    return {
        "dimension": 2,
        "materials": {"grey": {"reflectivity": 0.5}, "warm": {"reflectivity": 0.2, "emission": 1}},
        "polylines": [
            {"name": "walls", "material": "grey", "points": [[0, 0], [0, 1], [2, 1], [2, 0]]},
        ],
        "edges": [{"name": "floor", "material": "warm", "points": [[2, 0], [0, 0]]}],
    }
