"""The Rust half of kane: text, numbers and columns in, JSON and filled columns out."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "audit",
    "batch",
    "batch_contacts",
    "batched",
    "check_columns",
    "check_text",
    "collide",
    "explain",
    "laws",
    "scene",
    "survey",
    "version",
]

_Fraction = tuple[str, str]
_Value = tuple[str, _Fraction | None, list[_Fraction]]
_Root = tuple[list[str], _Fraction, _Fraction]
_Column = NDArray[np.float64]
_Asked = tuple[list[tuple[str, str]], str | None, float | None]

def version() -> str: ...
def audit(
    document: str, name: str, effort: int
) -> tuple[str, str, str, str, list[tuple[int, int, list[_Value], _Root | None]]]: ...
def explain(document: str, name: str, effort: int, place: int) -> str: ...
def batched() -> list[str]: ...
def batch(
    law: str, alpha: _Column, k: _Column, impulse: _Column, energy: _Column
) -> None: ...
def batch_contacts(
    law: str, inputs: list[_Column], k: _Column, impulse: _Column, energy: _Column
) -> None: ...
def survey(law: str, alpha: _Column) -> tuple[int, int, int, int, float, float]: ...
def laws() -> list[tuple[str, str, str, str, list[tuple[str, str, str, str]]]]: ...
def collide(
    text: str, name: str, law: str | None, parameters: list[tuple[str, str]]
) -> tuple[str, str]: ...
def scene(text: str, name: str, model: str | None) -> tuple[str, str, bool]: ...
def check_text(
    text: str, name: str, json_lines: bool, asked: _Asked
) -> tuple[str, str, str, bool]: ...
def check_columns(
    numbers: list[tuple[str, _Column, list[bool]]],
    words: list[tuple[str, list[str | None]]],
    name: str,
    asked: _Asked,
) -> tuple[str, str, str, bool]: ...
