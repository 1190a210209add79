"""What is said of the module is so: the page, the examples, the docstrings and the types."""

import ast
import doctest
import inspect
import io
import json
import os
import pathlib
import re
import subprocess
import sys

import pytest

import hottel
from hottel import _core
from conftest import ROOT

PAGE = (ROOT / "docs/python.md").read_text()
EXAMPLES = sorted((ROOT / "python/examples").glob("*.py"))
CLASSES = [value for value in vars(_core).values() if inspect.isclass(value)]


def stub_names():
    """The names of the stubs: those of the module, and by class those of its members."""
    module = ast.parse((pathlib.Path(_core.__file__).parent / "_core.pyi").read_text())
    names, members = set(), {}
    for node in module.body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            names.add(node.name)
        if isinstance(node, ast.AnnAssign):
            names.add(node.target.id)
        if isinstance(node, ast.ClassDef):
            members[node.name] = node.body
    return names, members


def test_the_blocks_of_the_page_run_one_after_the_other(capsys, monkeypatch):
    monkeypatch.chdir(ROOT)
    blocks = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    assert len(blocks) >= 7
    exec("\n".join(blocks), {})
    assert "floor#0" in capsys.readouterr().out


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.name)
def test_examples_run_and_are_short(example):
    done = subprocess.run([sys.executable, example], capture_output=True, text=True, env=os.environ)
    assert (done.returncode, done.stderr) == (0, "")
    assert len(done.stdout.splitlines()) >= 3
    assert 10 <= len(example.read_text().splitlines()) <= 30
    assert f"[{example.name}](../python/examples/{example.name})" in PAGE


def test_every_public_name_is_told():
    there = {name for name in dir(_core) if not name.startswith("_")}
    assert set(hottel.__all__) == there | {"__version__", "ProgressBar", "SceneBuilder"}
    for name in hottel.__all__:
        assert name == "__version__" or inspect.getdoc(getattr(hottel, name))


def test_the_notebook_runs_cell_by_cell(monkeypatch, capsys):
    """As a notebook does: one namespace, in its folder, and what a cell ends with is shown."""
    path = ROOT / "python/examples/hottel.ipynb"
    notebook = json.loads(path.read_text())
    assert (notebook["nbformat"], notebook["nbformat_minor"]) == (4, 5)
    assert len({cell["id"] for cell in notebook["cells"]}) == len(notebook["cells"])
    monkeypatch.chdir(path.parent)
    names, pictures = {"__name__": "__main__"}, 0
    for cell in notebook["cells"]:
        if cell["cell_type"] != "code":
            continue
        assert cell["outputs"] == [] and cell["execution_count"] is None, cell["id"]
        body = ast.parse("".join(cell["source"])).body
        last = body.pop() if isinstance(body[-1], ast.Expr) else None
        exec(compile(ast.Module(body, []), cell["id"], "exec"), names)
        shown = eval(compile(ast.Expression(last.value), cell["id"], "eval"), names) if last else None
        if shown is not None:
            assert shown._repr_png_().startswith(b"\x89PNG") if hasattr(shown, "pixels") else "<svg" in shown._repr_svg_()
            pictures += 1
    assert pictures >= 4
    told = capsys.readouterr().out
    for example in EXAMPLES:  # what scripts print, the notebook prints too, but for times
        done = subprocess.run([sys.executable, example], capture_output=True, text=True, env=os.environ, cwd=ROOT)
        assert any(line in told for line in done.stdout.splitlines()), example.name
    assert "(../python/examples/hottel.ipynb)" in PAGE


SHOWN = [name for name in hottel.__all__ if name not in ("__version__", "Error")]  # Error is raised as its kinds


@pytest.mark.parametrize("name", SHOWN)
def test_examples_of_docstrings_give_what_they_show(name, monkeypatch):
    monkeypatch.chdir(ROOT)
    doc = inspect.getdoc(getattr(hottel, name))
    example = doctest.DocTestParser().get_doctest(doc, {"hottel": hottel}, name, None, 0)
    assert example.examples
    told = io.StringIO()
    found = doctest.DocTestRunner(verbose=False).run(example, out=told.write)
    assert found.failed == 0, told.getvalue()


@pytest.mark.parametrize("type_", CLASSES, ids=lambda each: each.__name__)
def test_every_member_has_a_docstring(type_):
    for name, member in vars(type_).items():
        if name.startswith("_"):
            continue
        doc = inspect.getdoc(member) or ""
        described = doc.split("\n\n", 1)[-1] if callable(member) else doc  # after the signature
        assert len(described) > 20, name
        if isinstance(member, property) and name in arrays_of(type_):
            assert re.search(r"shape|as of|same", described), name


def arrays_of(type_):
    """Names of the properties that the stubs call arrays."""
    _, members = stub_names()
    return {
        member.name
        for member in members[type_.__name__]
        if isinstance(member, ast.FunctionDef) and ("NDArray" in ast.unparse(member.returns) or "Doubles" in ast.unparse(member.returns))
    }


def test_the_stubs_have_the_names_of_the_module():
    names, members = stub_names()
    assert names - {"__version__"} == {name for name in dir(_core) if not name.startswith("_")}
    for type_ in CLASSES:
        said = {node.name for node in members[type_.__name__] if isinstance(node, ast.FunctionDef)}
        there = {name for name in vars(type_) if not name.startswith("_")}
        assert {name for name in said if not name.startswith("_")} == there, type_
        assert all(hasattr(type_, name) for name in said), type_


@pytest.mark.parametrize("name", ["Simulation.__init__", "Scene.__init__", "Scene.moved", "Simulation.light",
                                  "Simulation.visible", "Factors.to_scipy", "Factors.arrays", "Simulation.grid",
                                  "Simulation.light_on", "Simulation.picture", "Scene.picture", "Scene.fixed",
                                  "Simulation.frames", "Simulation.compare",
                                  "Simulation.compare_grid", "Simulation.compare_radiosities", "Simulation.script_f"])
def test_the_stubs_have_the_arguments_of_the_module(name):
    type_, member = name.split(".")
    stub = next(node for node in stub_names()[1][type_] if isinstance(node, ast.FunctionDef) and node.name == member)
    said = [argument.arg for argument in stub.args.args + stub.args.kwonlyargs]
    signature = getattr(getattr(_core, type_), member).__doc__.splitlines()[0]
    there = re.findall(r"[(,] \*?,? ?(\w+)\b(?=[:,)])|\((\w+):", signature)
    assert [a or b for a, b in there] == said


def test_the_version_is_that_of_the_program():
    done = subprocess.run([os.environ["HOTTEL_PROGRAM"], "--version"], capture_output=True, text=True)
    assert hottel.__version__ in done.stdout


def test_the_module_takes_memory_as_python_does():
    linked = subprocess.run(["ldd", _core.__file__], capture_output=True, text=True, check=True).stdout
    assert "jemalloc" not in linked and "libtbb" in linked


def test_types_hold_together():
    sources = [ROOT / "python/hottel", *EXAMPLES]
    done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--cache-dir=/dev/null",
                           *sources], capture_output=True, text=True, cwd=ROOT / "python",
                          env={**os.environ, "MYPYPATH": str(ROOT / "python")})
    assert done.returncode == 0, done.stdout + done.stderr
