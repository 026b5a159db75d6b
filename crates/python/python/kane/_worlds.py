"""Collisions and scenes."""

from __future__ import annotations

import json
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from numbers import Real
from typing import Any, Mapping, Sequence, Union

from . import _kane
from ._report import Report
from ._table import code, table

#: An exact number: 0.092 and "0.092" are 23/250, as they are written; "1/3" and Fraction(1, 3) are a third.
Number = Union[int, float, str, Fraction, Decimal]


@dataclass(frozen=True)
class Quantity:
    """A quantity of a collision; docs/collide-format.md lists the symbols."""

    symbol: str
    #: SI; empty for a pure number
    unit: str
    #: the exact value; None where it is irrational, or where the quantity has no meaning
    exact: Union[Fraction, None]
    #: the same for people: a fraction, a surd, or the first 20 digits
    digits: Union[str, None]
    #: the float nearest to the exact value; None beyond the range, or without a meaning
    nearest: Union[float, None]


@dataclass(frozen=True)
class LawAnswer:
    """What one law says of a collision. `answer["k"]` is that quantity."""

    #: the law's id
    law: str
    #: what happens at the contact, or None
    regime: Union[str, None]
    #: "lost", "kept" or "created", decided exactly; None without an outcome
    energy: Union[str, None]
    #: why there is no outcome, or None
    reason: Union[str, None]
    quantities: dict[str, Quantity]
    #: with one law alone: each check, and whether it holds exactly
    checks: dict[str, bool]

    def __getitem__(self, symbol: str) -> Quantity:
        return self.quantities[symbol]


class Collision(Report):
    """A collision, put to laws. `collision["smith-1991"]["k"].exact` is a fraction."""

    def __init__(self, report: str, html: str) -> None:
        data = json.loads(report)
        self._json, self._html = report, html
        self.title: str = data["title"]
        #: the news in a sentence
        self.headline: str = data["headline"]
        #: whether every check holds
        self.as_expected: bool = data["as_expected"]
        #: the contact and the energy before
        self.before: dict[str, Quantity] = _quantities(data["before"])
        self.laws: dict[str, LawAnswer] = {law["id"]: _answer(law) for law in data["laws"]}

    def __getitem__(self, law: str) -> LawAnswer:
        return self.laws[law]

    def __repr__(self) -> str:
        return f"<kane.Collision: {self.title}; {self.headline}>"

    def _repr_html_(self) -> str:
        shown = ["k", "i_x", "dE", "v_x", "v_y", "omega"]
        known = [s for s in shown if any(s in law.quantities for law in self.laws.values())]

        def cell(law: LawAnswer, symbol: str) -> str:
            quantity = law.quantities.get(symbol)
            if quantity is None or quantity.nearest is None:
                return ""
            return f'<span title="{quantity.digits or ""}">{quantity.nearest:.6g}</span>'

        rows = (
            [code(law.law), *(cell(law, s) for s in known), law.regime or law.reason or ""]
            for law in self.laws.values()
        )
        return table(f"{self.title}: {self.headline}", ["law", *known, "regime"], rows)


class Scene(Report):
    """The answer to a scene by the least model that is good enough."""

    def __init__(self, report: str, html: str, meets: bool) -> None:
        #: the whole report; see docs/scene-format.md
        self.data: dict[str, Any] = json.loads(report)
        self._json, self._html = report, html
        #: whether the model shown is good enough: by a bound, as documented, or by an estimate
        self.good_enough: bool = meets

    def __repr__(self) -> str:
        return f"<kane.Scene: {self.data.get('headline', self.data.get('title'))}>"

    def _repr_html_(self) -> str:
        return f"<iframe srcdoc='{_attribute(self._html)}' width='100%' height='480'></iframe>"


def _attribute(page: str) -> str:
    return page.replace("&", "&amp;").replace("'", "&#39;")


def _quantities(data: list[dict[str, Any]]) -> dict[str, Quantity]:
    def exact(text: Union[str, None]) -> Union[Fraction, None]:
        return None if text is None else Fraction(text)

    return {
        q["symbol"]: Quantity(q["symbol"], q["unit"], exact(q["exact"]), q["digits"], q["float"])
        for q in data
    }


def _answer(law: dict[str, Any]) -> LawAnswer:
    outcome = law["outcome"] or {}
    return LawAnswer(
        law=law["id"],
        regime=outcome.get("regime"),
        energy=outcome.get("energy"),
        reason=law["reason"],
        quantities=_quantities(outcome.get("quantities", [])),
        checks={c["claim"]: c["holds"] for c in outcome.get("checks", [])},
    )


def _exact(value: Number, name: str) -> str:
    """The number as TOML takes it: a string, exactly as it is written."""
    if isinstance(value, bool) or not isinstance(value, (Real, Decimal, str)):
        raise ValueError(f"{name} is no number: {value!r}")
    # the shortest digits that name a float are what was written; NumPy's floats have another repr
    return json.dumps(float.__repr__(value) if isinstance(value, float) else str(value))


def collide(
    toml: Union[str, None] = None,
    *,
    shape: Union[str, None] = None,
    mobility_ratio: Union[Number, None] = None,
    mass: Number = 1,
    radius: Number = 1,
    velocity: Union[Sequence[Number], None] = None,
    spin: Number = 0,
    friction: Union[Number, None] = None,
    restitution: Union[Number, None] = None,
    law: Union[str, None] = None,
    parameters: Union[Mapping[str, Number], None] = None,
) -> Collision:
    """Puts one collision to every law, or to the `law` of an id, exactly and in floats.

    Either `toml` is the text of a file as docs/collide-format.md describes it, or the other arguments describe a
    round body that meets a fixed plane: `shape` is "sphere", "hollow-sphere", "disc" or "hoop", or instead
    `mobility_ratio` is 1 + m·r²/J, above 1; `mass` in kg; `radius` in m; `velocity` is (v_x, v_y) of the centre in
    m/s, and y points away from the plane, so that v_y < 0; `spin` in rad/s, from x to y; `friction` is μ, at least
    0; `restitution` is e, from 0 to 1. `parameters` has values by names as "walton.beta0".

    Numbers are exact as they are written: 0.1 is 1/10. Raises `ValueError` for anything that is no collision.
    """
    if toml is None:
        missing = [
            name
            for name, value in (
                ("velocity", velocity),
                ("friction", friction),
                ("restitution", restitution),
            )
            if value is None
        ]
        if missing:
            raise ValueError(f"missing: {', '.join(missing)}; or give the text of a file")
        toml = _round_body(
            shape, mobility_ratio, mass, radius, velocity, spin, friction, restitution
        )
        name = "collision.toml"
    else:
        flags = (shape, mobility_ratio, velocity, friction, restitution)
        if any(value is not None for value in flags) or (mass, radius, spin) != (1, 1, 0):
            raise ValueError("a text and a round body describe two collisions; give one of them")
        name = "text"
    own = [(path, json.loads(_exact(value, path))) for path, value in (parameters or {}).items()]
    return Collision(*_kane.collide(toml, name, law, own))


def _round_body(
    shape: Any, ratio: Any, mass: Any, radius: Any, velocity: Any, spin: Any, mu: Any, e: Any
) -> str:
    try:
        velocity = () if isinstance(velocity, str) else tuple(velocity)
    except TypeError:
        velocity = ()
    if len(velocity) != 2:
        raise ValueError("velocity is (v_x, v_y)")
    lines = [
        f"friction = {_exact(mu, 'friction')}",
        f"restitution = {_exact(e, 'restitution')}",
        "[sphere]",
        f"mass_kg = {_exact(mass, 'mass')}",
        f"radius_m = {_exact(radius, 'radius')}",
        "velocity_m_s = [" + ", ".join(_exact(v, "velocity") for v in velocity) + "]",
        f"spin_rad_s = {_exact(spin, 'spin')}",
    ]
    if shape is not None:
        lines.append(f"shape = {json.dumps(str(shape))}")
    if ratio is not None:
        lines.append(f"mobility_ratio = {_exact(ratio, 'mobility_ratio')}")
    return "\n".join(lines) + "\n"


def scene(toml: str, *, name: str = "scene.toml", model: Union[str, None] = None) -> Scene:
    """Answers a scene, the text of a file as docs/scene-format.md describes it, by the least model that is good
    enough, or by the `model` of a name, as "routh-newton/f64".

    Raises `ValueError` for what is no scene, and where no model has an answer.
    """
    return Scene(*_kane.scene(toml, name, model))
