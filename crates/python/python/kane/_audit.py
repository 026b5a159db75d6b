"""Audits of derivation documents."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Iterator, Union

from . import _kane
from ._report import Report
from ._table import code, coloured, table


@dataclass(frozen=True)
class Irrational:
    """An algebraic number: a polynomial, with rational coefficients, in one root of another.

    `coefficients` count from θ⁰ up. θ is the root of the integer polynomial `root_of`, from x⁰ up, that lies
    between the two fractions `between`. `float(x)` is within a few units in the last place of the number.
    """

    coefficients: tuple[Fraction, ...]
    root_of: tuple[int, ...]
    between: tuple[Fraction, Fraction]

    def __float__(self) -> float:
        def value(x: Fraction) -> Fraction:
            return sum((c * x**n for n, c in enumerate(self.root_of)), Fraction(0))

        low, high = self.between
        at_low = value(low)
        for _ in range(200):
            middle = (low + high) / 2
            at_middle = value(middle)
            if at_middle == 0:
                low = high = middle
                break
            if (at_middle > 0) == (at_low > 0):
                low = middle
            else:
                high = middle
        root = (low + high) / 2
        return float(sum((c * root**n for n, c in enumerate(self.coefficients)), Fraction(0)))


#: The exact value of a symbol at a witness.
Value = Union[Fraction, Irrational]


@dataclass(frozen=True)
class Link:
    """One link of a claim: of `a = b <= c` there are two."""

    #: the link in plain notation
    text: str
    #: "proved", "refuted", "ill-defined", "vacuous" or "undecided", with the cited claims taken as proved
    verdict: str
    #: in a sentence: how it was proved, the witness, or why it is undecided
    reason: str
    #: digest of the certificate that the kernel accepted; None where it is undecided
    certificate: Union[str, None]
    #: the proof or the witness written out, one line an item
    steps: tuple[str, ...]
    #: the exact point that speaks against the link, if a point does
    witness: Union[dict[str, Value], None] = field(default=None)


@dataclass(frozen=True)
class Statement:
    """A definition, a premise or a claim, and how it fares."""

    #: as written, "(9)" or "k-range"
    label: str
    #: "let", "given" or "claim"
    kind: str
    #: line of its first character, from 1
    line: int
    #: as written
    source: str
    #: "proved", "refuted", "undecided", …: see docs/derivation-language.md
    verdict: str
    #: what its author expects, if written; for a claim, None means "proved"
    expect: Union[str, None]
    #: whether the verdict is what is expected
    as_expected: bool
    #: labels of the premises on which it finally rests
    rests_on: tuple[str, ...]
    #: one per link of a claim
    links: tuple[Link, ...]

    @property
    def witness(self) -> Union[dict[str, Value], None]:
        """The exact point that speaks against the first link that has one."""
        return next((link.witness for link in self.links if link.witness is not None), None)


class Audit(Report):
    """A judged document. Iterates over its statements; `audit["(9)"]` and `audit["9"]` are that statement."""

    def __init__(self, text: str, name: str, effort: int, judged: tuple[str, str, str, str, list[Any]]) -> None:
        report, html, markdown, shown, points = judged
        document = json.loads(report)["documents"][0]
        self._source, self._effort, self._json, self._html = text, effort, report, html
        self._markdown, self._text = markdown, shown
        #: what the document was called
        self.name: str = name
        #: its first heading, if it has one
        self.title: Union[str, None] = document["title"]
        #: the counts as a sentence
        self.headline: str = document["summary"]["headline"]
        #: whether every statement ends as its author expects
        self.as_expected: bool = document["as_expected"]
        witnesses = {(at, link): _point(values, root) for at, link, values, root in points}
        self.statements: tuple[Statement, ...] = tuple(
            _statement(data, at, witnesses) for at, data in enumerate(document["statements"])
        )

    @property
    def claims(self) -> tuple[Statement, ...]:
        """The claims alone."""
        return tuple(s for s in self.statements if s.kind == "claim")

    @property
    def unexpected(self) -> tuple[Statement, ...]:
        """The statements that do not end as their author expects."""
        return tuple(s for s in self.statements if not s.as_expected)

    def __iter__(self) -> Iterator[Statement]:
        return iter(self.statements)

    def __len__(self) -> int:
        return len(self.statements)

    def __getitem__(self, label: str) -> Statement:
        return self.statements[self._place(label)]

    def _place(self, label: str) -> int:
        for wanted in (label, f"({label})"):
            for at, statement in enumerate(self.statements):
                if statement.label == wanted:
                    return at
        raise KeyError(f"no statement is labelled {label!r}")

    def explain(self, label: str) -> str:
        """The proof or the witness of one statement, step by step, for a person with paper."""
        return _kane.explain(self._source, self.name, self._effort, self._place(label))

    def markdown(self) -> str:
        """The report in Markdown."""
        return self._markdown

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<kane.Audit of {self.name}: {self.headline}>"

    def _repr_html_(self) -> str:
        rows = (
            [
                coloured(s.verdict),
                code(s.label),
                code(s.source),
                "" if s.as_expected else "<b>not as expected</b>",
            ]
            for s in self.statements
            if s.kind == "claim"
        )
        title = f"{self.title or self.name}: {self.headline}"
        return table(title, ["verdict", "claim", "as written", ""], rows)


def _fraction(pair: tuple[str, str]) -> Fraction:
    return Fraction(int(pair[0]), int(pair[1]))


def _point(values: list[Any], root: Any) -> dict[str, Value]:
    point: dict[str, Value] = {}
    for name, exact, parts in values:
        if exact is not None:
            point[name] = _fraction(exact)
        elif root is not None:
            poly, low, high = root
            point[name] = Irrational(
                tuple(map(_fraction, parts)),
                tuple(map(int, poly)),
                (_fraction(low), _fraction(high)),
            )
    return point


def _statement(data: dict[str, Any], at: int, witnesses: dict[Any, Any]) -> Statement:
    links = tuple(
        Link(
            text=link["text"],
            verdict=link["verdict"],
            reason=link["reason"],
            certificate=link["certificate"],
            steps=tuple("  " * step["depth"] + step["text"] for step in link["steps"]),
            witness=witnesses.get((at, place)),
        )
        for place, link in enumerate(data["links"])
    )
    return Statement(
        label=data["label"],
        kind=data["kind"],
        line=data["line"],
        source=data["source"],
        verdict=data["verdict"],
        expect=data["expect"],
        as_expected=data["as_expected"],
        rests_on=tuple(data["rests_on"]),
        links=links,
    )


def audit(text: str, *, name: str = "document.md", effort: int = 1) -> Audit:
    """Judges every statement of a derivation document.

    `text` is Markdown with blocks tagged ``kane``; docs/derivation-language.md describes them. `name` heads the
    report and the messages. `effort` multiplies the budget of every search, from 1 to 1,000,000.

    Proved means that the kernel accepted a certificate, refuted that it accepted a point that speaks against the
    claim: `witness` has it, in fractions. Raises `ValueError` with every fault, its line and its column, if the
    text is no document.
    """
    if not 1 <= effort <= 1_000_000:
        raise ValueError("effort is from 1 to 1000000")
    return Audit(text, name, effort, _kane.audit(text, name, effort))
