"""HTML tables for notebooks."""

from __future__ import annotations

from html import escape
from typing import Iterable, Sequence

_COLOURS = {
    "proved": "#1a7f37",
    "holds": "#1a7f37",
    "refuted": "#b42318",
    "fails": "#b42318",
    "ill-defined": "#b42318",
    "undecided": "#9a6700",
    "unsupported": "#9a6700",
    "vacuous": "#9a6700",
}


def coloured(word: str) -> str:
    """A verdict in its colour."""
    colour = _COLOURS.get(word)
    text = escape(word)
    return f'<b style="color:{colour}">{text}</b>' if colour else text


def code(text: str) -> str:
    """Text as code."""
    return f"<code>{escape(text)}</code>"


def table(caption: str, head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table; the cells are HTML already."""
    heads = "".join(f"<th style='text-align:left'>{escape(name)}</th>" for name in head)
    cells = "".join(
        "<tr>" + "".join(f"<td style='text-align:left'>{cell}</td>" for cell in row) + "</tr>"
        for row in rows
    )
    caption = f"<caption style='text-align:left'>{escape(caption)}</caption>"
    return f"<table>{caption}<thead><tr>{heads}</tr></thead><tbody>{cells}</tbody></table>"
