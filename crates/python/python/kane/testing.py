"""Derivations, scenes and logs as tests: each function raises `AssertionError` with all that is not as it should be.

>>> from kane.testing import document, log, scene
>>> def test_the_derivation():
...     document("docs/derivation.md")
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Union

from . import audit, check
from . import scene as _scene
from ._audit import Audit
from ._check import Check
from ._worlds import Scene

__all__ = ["document", "log", "scene"]

_Path = Union[str, "os.PathLike[str]"]


def document(path: _Path, *, effort: int = 1) -> Audit:
    """Every statement of the derivation document ends as its author expects, and it has a claim."""
    name = os.fspath(path)
    audited = audit(Path(path).read_text(encoding="utf-8"), name=name, effort=effort)
    if not audited.claims:
        raise AssertionError(f"{name}: there is no claim, so that nothing is checked")
    if not audited.as_expected:
        told = [_statement(name, statement) for statement in audited.unexpected]
        raise AssertionError(f"{audited.headline}\n" + "\n".join(told))
    return audited


def _statement(name: str, statement: Any) -> str:
    reasons = [link.reason for link in statement.links if link.verdict != "proved"]
    reason = f": {reasons[0]}" if reasons else ""
    expected = f", expected {statement.expect}" if statement.expect else ""
    line = f"{name}:{statement.line}: {statement.label} is {statement.verdict}{expected}{reason}"
    return f"{line}\n    {statement.source}"


def scene(path: _Path, *, model: Union[str, None] = None) -> Scene:
    """The scene has an answer by a model that is known to be good enough."""
    name = os.fspath(path)
    answer = _scene(Path(path).read_text(encoding="utf-8"), name=name, model=model)
    if not answer.good_enough:
        raise AssertionError(f"{name}: no model is known to be good enough")
    return answer


def log(table: Any, **options: Any) -> Check:
    """Every row of the log, a path or a table as of `kane.check`, is checked and keeps every check."""
    checked = check(table, **options)
    if not checked.as_expected:
        raise AssertionError(str(checked))
    return checked
