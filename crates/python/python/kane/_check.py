"""Logs of impacts."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any, Mapping, Union

from . import _kane
from ._report import Report
from ._table import code, coloured, table


@dataclass(frozen=True)
class Checked:
    """How one check fares over the log."""

    #: its id, as in docs/records.md
    check: str
    #: what it asks, in a sentence
    asks: str
    #: rows that it could be asked of
    rows: int
    #: rows that fail it
    failed: int
    #: the law that gives every row and has it so, or None
    excused_by: Union[str, None]
    as_expected: bool
    #: the worst row: "line" (of a table the row, from 1), "residual", "tolerance" and "size"; or None
    worst: Union[dict[str, Any], None]


class Check(Report):
    """What a log of impacts follows. `check["id"]` is one check."""

    def __init__(self, name: str, report: str, html: str, text: str, as_expected: bool) -> None:
        #: the whole report; see docs/records.md
        self.data: dict[str, Any] = json.loads(report)
        self._json, self._html, self._text = report, html, text
        self.name = name
        #: whether every check holds, or fails as a law that gives every row has it, and no row is rejected
        self.as_expected = as_expected
        self.checks: tuple[Checked, ...] = tuple(
            Checked(
                check=c["check"],
                asks=c["asks"],
                rows=c["rows"],
                failed=c["failed"],
                excused_by=c["excused_by"],
                as_expected=c["as_expected"],
                worst=c["worst"],
            )
            for c in self.data["checks"]
        )

    @property
    def headline(self) -> str:
        """What the log follows, in a sentence."""
        return str(self.data["headline"])

    @property
    def laws(self) -> list[str]:
        """The ids of the rigid laws that give every row."""
        return [law["law"] for law in self.data["laws"] if law["consistent"] == law["rows"] > 0]

    def __getitem__(self, id: str) -> Checked:
        for checked in self.checks:
            if checked.check == id:
                return checked
        raise KeyError(f"there is no check {id!r}")

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<kane.Check of {self.name}: {self.headline}>"

    def _repr_html_(self) -> str:
        rows = (
            [
                coloured("holds" if c.failed == 0 else "fails"),
                code(c.check),
                c.asks,
                f"{c.failed} of {c.rows}",
                c.excused_by or "",
            ]
            for c in self.checks
            if c.rows > 0
        )
        return table(self.headline, ["", "check", "asks", "rows that fail", "excused by"], rows)


def check(
    log: Any,
    *,
    map: Union[Mapping[str, str], None] = None,
    float: Union[str, None] = None,
    extent: Union[float, None] = None,
    nan_is_missing: bool = False,
    name: Union[str, None] = None,
) -> Check:
    """Checks a log of impacts row by row, and names the law that it follows.

    `log` is a path (.csv, or .jsonl, .ndjson and .json for JSON lines), a pandas or polars data frame, an Arrow
    table or record batch, a mapping of names to columns, or a list of rows, each a mapping. Columns are named as in
    docs/records.md, in SI units: m, kg, s, rad. `map` has, for a name of the schema, the name that the log has.

    Columns of float64 without gaps are read where they stand. A cell that is None, pandas.NA or null in Arrow is
    missing. A NaN is a fault of its row, which is then rejected and not checked; with `nan_is_missing` it is a
    missing cell, as pandas has it. `float` says in which format the engine computed ("f32", "f64" or a count of
    decimals), if the numbers do not tell; `extent` how far coordinates reach in its world, in contact arms.

    Raises `ValueError` if columns are missing, or there is no row that could be checked.
    """
    try:
        asked = (list((map or {}).items()), float, None if extent is None else 1.0 * extent)
    except OverflowError:
        raise ValueError("extent must be between 0 and 1e12 arms") from None
    if isinstance(log, (str, os.PathLike)):
        path = os.fspath(log)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        lines = path.lower().endswith((".jsonl", ".ndjson", ".json"))
        name = name or path
        return Check(name, *_kane.check_text(text, name, lines, asked))
    numbers: list[Any] = []
    words: list[Any] = []
    for column, values in _columns(log):
        _sort(str(column), values, nan_is_missing, numbers, words)
    name = name or "table"
    return Check(name, *_kane.check_columns(numbers, words, name, asked))


def _columns(log: Any) -> list[tuple[str, Any]]:
    """The columns of a table, whatever it is."""
    # Arrow: a table or a record batch
    if hasattr(log, "column_names") and hasattr(log, "column"):
        return [(name, log.column(at)) for at, name in enumerate(log.column_names)]
    if hasattr(log, "schema") and hasattr(log.schema, "names") and hasattr(log, "column"):
        return [(name, log.column(at)) for at, name in enumerate(log.schema.names)]
    # pandas, polars, and whatever has columns by name
    if hasattr(log, "columns") and hasattr(log, "__getitem__"):
        return [(name, log[name]) for name in log.columns]
    if isinstance(log, Mapping):
        return list(log.items())
    # a structured array of NumPy
    names = getattr(getattr(log, "dtype", None), "names", None)
    if names:
        return [(name, log[name]) for name in names]
    try:
        rows = list(log)
    except TypeError:
        raise ValueError(f"a log is a path or a table, not {type(log).__name__}") from None
    if not all(isinstance(row, Mapping) for row in rows):
        raise ValueError("a list of rows has a mapping for each row")
    found = {name: None for row in rows for name in row}
    return [(name, [row.get(name) for row in rows]) for name in found]


def _sort(name: str, values: Any, nan_is_missing: bool, numbers: list[Any], words: list[Any]) -> None:
    """Puts a column among the numbers, with a mask, or among the words."""
    import numpy as np

    missing = None
    if hasattr(values, "combine_chunks"):  # Arrow's chunks
        values = values.combine_chunks()
    if hasattr(values, "null_count") and hasattr(values, "to_numpy") and hasattr(values, "is_null"):
        if callable(values.null_count) or values.null_count:  # polars has a method, Arrow a count
            missing = np.asarray(values.is_null())
        values = _numpy_of(values)
    elif hasattr(values, "isna") and hasattr(values, "to_numpy"):  # a column of pandas
        if not isinstance(values.dtype, np.dtype):
            missing = np.asarray(values.isna(), dtype=bool)
            values = values.to_numpy(dtype=object)
        else:
            values = values.to_numpy()
    if isinstance(values, np.ma.MaskedArray):
        missing, values = np.ma.getmaskarray(values), values.data
    array = values if isinstance(values, np.ndarray) else np.asarray(values, dtype=object)
    if array.ndim != 1:
        raise ValueError(f"the column {name} has {array.ndim} dimensions; a column has one")
    if array.dtype == object:
        array, missing = _objects(array, missing)
    if array is not None and array.dtype.kind in "fiu":
        column = np.require(array, dtype=np.float64, requirements=["C", "A"])
        if nan_is_missing and np.isnan(column).any():
            nan = np.isnan(column)
            missing = nan if missing is None else missing | nan
        mask = [] if missing is None or not missing.any() else missing.tolist()
        numbers.append((name, column, mask))
        return
    gone = [False] * len(array) if missing is None else missing.tolist()
    words.append((name, [None if no else str(cell) for no, cell in zip(gone, array.tolist())]))


def _numpy_of(values: Any) -> Any:
    try:
        return values.to_numpy(zero_copy_only=False)
    except TypeError:  # polars takes no such word
        return values.to_numpy()


def _objects(array: Any, missing: Any) -> tuple[Any, Any]:
    """Objects as numbers, if all that are not missing are; else as they are, and what is missing."""
    import numpy as np

    cells = array.tolist()
    gone = [
        cell is None or type(cell).__name__ in ("NAType", "NaTType") for cell in cells
    ]
    if missing is not None:
        gone = [a or b for a, b in zip(gone, missing.tolist())]
    mask = np.array(gone, dtype=bool)
    kept = [cell for cell, no in zip(cells, gone) if not no]
    number = (int, float, np.integer, np.floating)
    if all(isinstance(cell, number) and not isinstance(cell, bool) for cell in kept):
        try:
            filled = [0.0 if no else float(cell) for cell, no in zip(cells, gone)]
        except OverflowError:  # an integer beyond all floats: a word that is no number of the format
            return array, mask
        return np.array(filled, dtype=np.float64), mask
    return array, mask
