"""The package: its types, its weight, its examples, its notebook, and where unsafe code may be."""

import ast
import doctest
import inspect
import re
import subprocess
import sys
import types
import typing
from pathlib import Path

import kane
import kane._kane
import nbformat
import numpy as np
import pytest
from nbclient import NotebookClient

ROOT = Path(__file__).parents[3]


def test_the_examples_of_the_docstring_hold():
    assert doctest.testmod(kane).attempted >= 4
    assert doctest.testmod(kane).failed == 0


def test_everything_public_is_documented_and_typed():
    for name in kane.__all__:
        thing = getattr(kane, name)
        assert inspect.getdoc(thing), name
        if inspect.isfunction(thing):
            hints = thing.__annotations__
            assert "return" in hints and len(hints) == len(inspect.signature(thing).parameters) + 1


def stub():
    """The functions of the stub, by name."""
    path = Path(kane.__file__).parent / "_kane.pyi"
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}


def test_the_stub_lists_what_the_rust_half_has():
    assert set(stub()) == {name for name in dir(kane._kane) if not name.startswith("__")}
    assert (Path(kane.__file__).parent / "py.typed").exists()


@pytest.mark.parametrize("name", stub())
def test_the_stub_has_the_parameters_of_the_rust_half(name):
    written = stub()[name]
    asked = written.args
    assert not (asked.posonlyargs or asked.kwonlyargs or asked.vararg or asked.kwarg or asked.defaults)
    has = inspect.signature(getattr(kane._kane, name)).parameters.values()
    assert [one.arg for one in asked.args] == [one.name for one in has]
    assert all(one.default is inspect.Parameter.empty for one in has), "the stub has no defaults"
    assert written.returns is not None and all(one.annotation is not None for one in asked.args)


def test_the_stub_says_what_is_returned():
    """The return types, held against values, all the way down."""
    text = "```kane\nvar x > 0\ngiven square: x^2 = 2\nclaim small: x < 1 from square\n```\n"
    ball = (Path(__file__).parents[3] / "docs/collisions/double-pendulum.toml").read_text(encoding="utf-8")
    fall = (Path(__file__).parents[3] / "docs/scenes/backspin.toml").read_text(encoding="utf-8")
    log = Path(__file__).parents[3] / "docs/examples/as-a-test/impacts.csv"
    log, asked = log.read_text(encoding="utf-8"), ([], None, None)
    alpha, out = np.ones(2), [np.zeros(2) for _ in range(3)]
    calls = {
        "version": (),
        "audit": (text, "name", 1),
        "explain": (text, "name", 1, 0),
        "batched": (),
        "batch": ("walton", alpha, *out),
        "batch_contacts": ("walton", [alpha] * 3, *out),
        "survey": ("walton", alpha),
        "laws": (),
        "collide": (ball, "name", None, []),
        "scene": (fall, "name", None),
        "check_text": (log, "name", False, asked),
        "check_columns": (columns(log), [], "name", asked),
    }
    assert set(calls) == set(stub())
    names = {}
    exec(aliases(), names)  # noqa: S102 - the stub of this package
    for name, arguments in calls.items():
        said = eval(ast.unparse(stub()[name].returns), names)  # noqa: S307 - likewise
        value = getattr(kane._kane, name)(*arguments)
        assert fits(value, said), f"{name} is not {said}: {value!r:.300}"


def test_mypy_finds_no_fault_in_the_stub_or_in_the_package(tmp_path):
    for check in (["mypy.stubtest", "kane"], ["mypy", "--strict", "--no-incremental", "-p", "kane"]):
        run = subprocess.run([sys.executable, "-m", *check], capture_output=True, text=True, cwd=tmp_path)
        assert run.returncode == 0, run.stdout + run.stderr


def aliases():
    """What the stub says before its functions."""
    path = Path(kane.__file__).parent / "_kane.pyi"
    tree = ast.parse(path.read_text(encoding="utf-8"))
    kept = [node for node in tree.body if isinstance(node, (ast.Import, ast.ImportFrom, ast.Assign))]
    return "\n".join(map(ast.unparse, kept))


def columns(log):
    """The columns of a small log as `check_columns` takes them."""
    rows = [line.split(",") for line in log.splitlines() if line and not line.startswith("#")]
    return [(name, np.array(cells, dtype=np.float64), []) for name, *cells in zip(*rows)]


def fits(value, said):
    """Whether a value is of a type, with what it contains."""
    if said is None or said is type(None):
        return value is None
    if isinstance(said, types.UnionType):
        return any(fits(value, one) for one in said.__args__)
    origin, inner = typing.get_origin(said), typing.get_args(said)
    if origin is list:
        return type(value) is list and all(fits(one, inner[0]) for one in value)
    if origin is tuple:
        return type(value) is tuple and len(value) == len(inner) and all(map(fits, value, inner))
    return type(value) is said


def test_importing_is_quick_and_loads_no_numpy():
    # processor time: how long a busy machine lets it wait says nothing of the package
    program = (
        "import time, sys; at = time.process_time(); import kane; "
        "print(time.process_time() - at, 'numpy' in sys.modules, 'pandas' in sys.modules)"
    )
    runs = [
        subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
        for _ in range(5)
    ]
    took = [run.stdout.split() for run in runs]
    assert all(loaded == ["False", "False"] for _, *loaded in took)
    assert min(float(seconds) for seconds, *_ in took) < 0.2


def test_no_unsafe_code_is_written_by_hand():
    for source in (ROOT / "crates/python/src").glob("*.rs"):
        code = [line.split("//")[0] for line in source.read_text(encoding="utf-8").splitlines()]
        assert not any(re.search(r"\bunsafe\b", line) for line in code), source


def test_the_version_is_that_of_the_workspace():
    manifest = (ROOT / "Cargo.toml").read_text(encoding="utf-8")
    found = re.search(r'^version = "(.+)"', manifest, re.MULTILINE)
    assert found is not None and kane.__version__ == found.group(1)


@pytest.mark.filterwarnings("ignore")
def test_the_notebook_runs(tmp_path):
    notebook = nbformat.read(ROOT / "docs/kane.ipynb", as_version=4)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert len(code) == 4
    client = NotebookClient(notebook, timeout=120, resources={"metadata": {"path": ROOT / "docs"}})
    client.execute()
    shown = [output for cell in code for output in cell.outputs]
    assert any("text/html" in output.get("data", {}) for output in shown)
