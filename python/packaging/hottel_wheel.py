"""Builds the module by CMake and packs it as a wheel: what pip asks for (PEP 517), with nothing beyond Python itself.

The module is taken from build/release where that is configured for this Python, else from a tree of its own,
build/python; `--config-settings tree=DIR` names another one.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAME = "hottel"
DATE = (1980, 1, 1, 0, 0, 0)  # the same files make the same wheel


def version():
    text = (ROOT / "kernel/version.h").read_text()
    return re.search(r'kVersion = "(.*)"', text).group(1)


def interpreter():
    """The Python that the module is for: of an environment, the one that it was made of."""
    return os.path.realpath(getattr(sys, "_base_executable", sys.executable))


def is_for_this_python(tree):
    cache = tree / "CMakeCache.txt"
    if not (cache.exists() and (tree / "build.ninja").exists()):
        return False
    found = re.search(r"^Python_EXECUTABLE:\w+=(.*)$", cache.read_text(), re.MULTILINE)
    return bool(found) and os.path.realpath(found.group(1)) == interpreter()


def built_package(settings):
    """Builds the module; returns the folder of the package."""
    wanted = (settings or {}).get("tree")
    tree = pathlib.Path(wanted) if wanted else ROOT / "build/release"
    if not is_for_this_python(tree):
        tree = tree if wanted else ROOT / "build/python"
        subprocess.run(
            ["cmake", "-S", ROOT, "-B", tree, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG", "-DHOTTEL_BATCHES=ON", "-DHOTTEL_BUILD_TESTS=OFF",
             "-DHOTTEL_WINDOW=OFF", f"-DPython_EXECUTABLE={interpreter()}"], check=True)
    subprocess.run(["cmake", "--build", tree, "--target", "hottel_python"], check=True)
    return tree / "python" / NAME


def metadata():
    return (f"Metadata-Version: 2.1\nName: {NAME}\nVersion: {version()}\n"
            "Summary: The exact reference for diffuse light\nRequires-Python: >=3.9\nRequires-Dist: numpy\n")


def tag():
    """Of this Python and this machine: the module is linked with libraries of the system."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def digest(content):
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    package = built_package(config_settings)
    info = f"{NAME}-{version()}.dist-info"
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    files = {f"{NAME}/{path.name}": path.read_bytes() for path in sorted(package.iterdir())
             if path.suffix in (".py", ".pyi", ".typed") or path.name in ("py.typed", "_core" + suffix)}
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: hottel\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode()
    record = "".join(f"{name},sha256={digest(content)},{len(content)}\n" for name, content in files.items())
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    wheel = f"{NAME}-{version()}-{tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    raise RuntimeError("the sources are the repository: install from a clone of it")
