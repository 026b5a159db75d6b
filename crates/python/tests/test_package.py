"""The package: its types, its weight, its examples, its notebook, and where unsafe code may be."""

import doctest
import inspect
import re
import subprocess
import sys
from pathlib import Path

import kane
import kane._kane
import nbformat
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


def test_the_stub_lists_what_the_rust_half_has():
    stub = (Path(kane.__file__).parent / "_kane.pyi").read_text(encoding="utf-8")
    listed = set(re.findall(r"^def (\w+)", stub, re.MULTILINE))
    assert listed == {name for name in dir(kane._kane) if not name.startswith("__")}
    assert (Path(kane.__file__).parent / "py.typed").exists()


def test_importing_is_quick_and_loads_no_numpy():
    program = (
        "import time, sys; at = time.perf_counter(); import kane; "
        "print(time.perf_counter() - at, 'numpy' in sys.modules, 'pandas' in sys.modules)"
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
