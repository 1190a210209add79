"""The package as pip installs it: from the build tree, with nothing beyond Python."""

import json
import os
import pathlib
import subprocess
import sys
import zipfile

import hottel
from conftest import ROOT

TREE = pathlib.Path(hottel.__file__).resolve().parents[2]
PIP = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--quiet"]
OFFLINE = ["--no-build-isolation", "--no-deps", "--no-index", "--config-settings", f"tree={TREE}"]


def test_what_pip_installs_is_the_module(tmp_path):
    subprocess.run([*PIP, "install", *OFFLINE, "--target", tmp_path, "."], check=True, cwd=ROOT)
    program = ("import hottel, json\nf = hottel.Simulation(hottel.read_scene('scenes/space/cube.json')).factors\n"
               "print(json.dumps([hottel.__file__, hottel.__version__, f.factors.tobytes().hex()]))")
    done = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True, cwd=ROOT,
                          env={**os.environ, "PYTHONPATH": str(tmp_path)})
    file, version, factors = json.loads(done.stdout)
    assert pathlib.Path(file).is_relative_to(tmp_path) and version == hottel.__version__
    assert factors == hottel.Simulation(hottel.read_scene(ROOT / "scenes/space/cube.json")).factors.factors.tobytes().hex()
    assert (tmp_path / f"hottel-{version}.dist-info/METADATA").exists()


def test_a_wheel_has_the_package_and_is_the_same_each_time(tmp_path):
    wheels = []
    for name in ("first", "second"):
        subprocess.run([*PIP, "wheel", *OFFLINE, "--wheel-dir", tmp_path / name, "."], check=True, cwd=ROOT)
        wheels += (tmp_path / name).glob("hottel-*.whl")
    first, second = wheels
    assert first.read_bytes() == second.read_bytes()
    names = set(zipfile.ZipFile(first).namelist())
    assert {"hottel/__init__.py", "hottel/builder.py", "hottel/_core.pyi", "hottel/py.typed"} < names
    assert len(names) == 9 and not any("cache" in name for name in names)


def test_the_package_says_what_the_program_says_of_its_version():
    sys.path.insert(0, str(ROOT / "python/packaging"))
    try:
        import hottel_wheel
    finally:
        sys.path.pop(0)
    assert hottel_wheel.version() == hottel.__version__
    assert hottel_wheel.is_for_this_python(TREE) and not hottel_wheel.is_for_this_python(TREE / "nowhere")
