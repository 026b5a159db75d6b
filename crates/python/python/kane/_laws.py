"""What the laws are."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from . import _kane


@dataclass(frozen=True)
class Parameter:
    """A law's own parameter, beyond μ and e."""

    name: str
    #: exact
    default: Fraction
    meaning: str
    #: in words, as "from 0 to 1"
    domain: str


@dataclass(frozen=True)
class Law:
    """A law of impact."""

    #: its name in every table and report
    id: str
    #: what it adds to momentum and restitution, in the derivation language
    statement: str
    #: who published it, and what was consulted
    source: str
    #: the hypothesis of restitution
    restitution: str
    parameters: tuple[Parameter, ...]


def laws() -> dict[str, Law]:
    """Every law by its id, in the order of the tables."""
    return {
        id: Law(
            id,
            statement,
            source,
            restitution,
            tuple(Parameter(n, Fraction(d), meaning, domain) for n, d, meaning, domain in own),
        )
        for id, statement, source, restitution, own in _kane.laws()
    }
