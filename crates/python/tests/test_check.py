"""Logs of impacts: whatever holds the table, the answer is the same."""

import csv
import json
from pathlib import Path

import kane
import numpy as np
import pandas
import pyarrow
import pytest

DATA = Path(__file__).parents[2] / "records/tests/data"
LOG = DATA / "pymunk-7.3.1_default.csv"


def told(check):
    data = json.loads(check.json())
    del data["command"]
    for key in ("log", "file", "name"):
        data.pop(key, None)
    return [data["headline"], check.as_expected, check.laws] + [
        (c["check"], c["rows"], c["failed"]) for c in data["checks"]
    ]


@pytest.fixture(scope="module")
def file():
    return kane.check(LOG)


def rows():
    lines = [line for line in LOG.read_text(encoding="utf-8").splitlines() if line[:1] != "#"]
    return list(csv.DictReader(lines))


def number(cell):
    try:
        return float(cell)
    except ValueError:
        return cell or None


def test_a_path(file):
    assert file.as_expected and "Coulomb" in file.headline or file.checks


def test_rows_and_columns(file):
    as_rows = [{name: number(cell) for name, cell in row.items()} for row in rows()]
    assert told(kane.check(as_rows)) == told(file)
    as_columns = {name: [row[name] for row in as_rows] for name in as_rows[0]}
    assert told(kane.check(as_columns)) == told(file)
    arrays = {
        name: np.array(cells) if all(isinstance(c, float) for c in cells) else cells
        for name, cells in as_columns.items()
    }
    assert told(kane.check(arrays)) == told(file)


def test_pandas_and_arrow(file):
    frame = pandas.read_csv(LOG, comment="#")
    assert told(kane.check(frame, nan_is_missing=True)) == told(file)
    assert told(kane.check(frame.convert_dtypes())) == told(file)
    table = pyarrow.Table.from_pandas(frame)
    assert told(kane.check(table)) == told(file)
    assert told(kane.check(table.to_batches()[0])) == told(file)


SMALL = {
    "mass": [1.0, 1.0],
    "radius": [1.0, 1.0],
    "inertia": [0.4, 0.4],
    "mu": [0.25, 0.25],
    "e": [0.5, 0.5],
    "vx_pre": [2.0, 2.0],
    "vy_pre": [-1.0, -1.0],
    "omega_pre": [0.0, 0.0],
    "vx_post": [1.625, 1.625],
    "vy_post": [0.5, 0.5],
    "omega_post": [-0.9375, -0.9375],
}


def small(**change):
    return {**SMALL, **change}


def test_a_law_is_named():
    checked = kane.check(small())
    assert checked.as_expected and "kane-levinson" in checked.laws
    assert checked["moment"].failed == 0 and "<table>" in checked._repr_html_()
    with pytest.raises(KeyError):
        checked["mood"]


def test_a_nan_is_a_fault_and_a_none_is_missing():
    nan = float("nan")
    rejected = kane.check(small(mu=[0.25, nan]))
    assert not rejected.as_expected and rejected["moment"].rows == 1
    for column in ([0.25, None], pandas.array([0.25, None], dtype="Float64"), pyarrow.array([0.25, None])):
        table = small(mu=column)
        assert kane.check(table)["moment"].rows == 2, type(column)
    assert kane.check(small(mu=[0.25, nan]), nan_is_missing=True)["moment"].rows == 2


def test_names_units_and_formats():
    renamed = {("speed_in" if name == "vx_pre" else name): cells for name, cells in SMALL.items()}
    assert kane.check(renamed, map={"vx_pre_m_s": "speed_in"}).as_expected
    with pytest.raises(ValueError, match="missing"):
        kane.check(renamed)
    assert kane.check(small(), float="f32", extent=0.0).as_expected
    turned = kane.check(small(omega_post=[0.9375, 0.9375]))
    assert not turned.as_expected and turned["moment"].failed == 2


@pytest.mark.parametrize(
    "log",
    [
        {},
        [],
        [1, 2],
        7,
        None,
        small(mu=[0.25]),
        small(mu=0.25),
        small(mu=np.zeros((2, 2))),
        {name: [] for name in SMALL},
        {name: cells for name, cells in SMALL.items() if name != "mass"},
    ],
)
def test_what_is_no_log_is_an_error(log):
    with pytest.raises(ValueError):
        kane.check(log)


def test_words_among_numbers_reject_their_row():
    checked = kane.check(small(vx_pre=[2.0, "fast"]))
    assert not checked.as_expected and checked["moment"].rows == 1


def test_bad_options_are_errors(tmp_path):
    with pytest.raises(ValueError, match="float is"):
        kane.check(small(), float="f16")
    with pytest.raises(ValueError, match="extent"):
        kane.check(small(), extent=float("nan"))
    with pytest.raises(OSError):
        kane.check(tmp_path / "none.csv")
    empty = tmp_path / "empty.csv"
    empty.write_text("")
    with pytest.raises(ValueError):
        kane.check(empty)


def test_the_page_on_engines_shows_a_program_that_runs(tmp_path, monkeypatch):
    pytest.importorskip("pymunk", reason="the engine of the page is not installed")
    page = Path(__file__).parents[3] / "docs/checking-your-engine.md"
    program = page.read_text(encoding="utf-8").split("```python\n")[1].split("```")[0]
    monkeypatch.chdir(tmp_path)
    names = {}
    exec(program, names)  # noqa: S102 - a page of this repository
    names["out"] = None  # the file is closed, and all of it is there
    check = kane.check(tmp_path / "log.csv")
    assert json.loads(check.json())["headline"].startswith(
        "Restitution as stated; friction is Coulomb's, which stops the slip"
    )


def test_a_masked_cell_is_missing():
    masked = np.ma.array([0.25, 9.0], mask=[False, True])
    assert told(kane.check(small(mu=masked))) == told(kane.check(small(mu=[0.25, None])))


def test_a_number_beyond_all_floats_rejects_its_row():
    checked = kane.check(small(mu=[0.25, 10**400]))
    assert not checked.as_expected and checked["moment"].rows == 1
    with pytest.raises(ValueError, match="extent"):
        kane.check(small(), extent=10**400)
