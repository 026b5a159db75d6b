"""Collisions and scenes: exact numbers in, exact numbers out."""

from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import kane
import numpy as np
import pytest

ROOT = Path(__file__).parents[3]
BALL = dict(shape="sphere", velocity=(3, -2), friction="0.1", restitution="1/2")


def test_a_float_is_the_decimal_that_was_written():
    written = kane.collide(shape="sphere", velocity=(3, -2), friction=0.1, restitution=0.5)
    exact = kane.collide(
        shape="sphere", velocity=(3, -2), friction=Fraction(1, 10), restitution=Fraction(1, 2)
    )
    assert written["wang-su-li"]["k"].exact == exact["wang-su-li"]["k"].exact
    for mu in (np.float64(0.1), np.float32(0.1), Decimal("0.1"), "1e-1", "1/10"):
        ball = kane.collide(shape="sphere", velocity=(np.int64(3), -2), friction=mu, restitution=0.5)
        assert ball["wang-su-li"]["k"].exact == exact["wang-su-li"]["k"].exact, repr(mu)


def test_the_paper_s_law_by_hand():
    # alpha = 7/2 * mu*(1 + e)*|v_y| / (2*v_x), k = (1 - alpha)/(1 + alpha)
    ball = kane.collide(**BALL)
    alpha = Fraction(7, 2) * Fraction(1, 10) * Fraction(3, 2) * 2 / (2 * 3)
    assert ball.before["alpha"].exact == alpha
    assert ball["wang-su-li"]["k"].exact == (1 - alpha) / (1 + alpha)
    assert ball["wang-su-li"]["v_y"].exact == 1
    assert ball["wang-su-li"].energy == "lost"


def test_one_law_has_its_checks_and_a_parameter_reaches_it():
    ball = kane.collide(**BALL, law="walton", parameters={"walton.beta0": "1/8"})
    assert list(ball.laws) == ["walton"] and ball["walton"].checks
    assert all(ball["walton"].checks.values()) and ball.as_expected
    assert len(kane.collide(**BALL).laws) > 10


def test_a_file_says_the_same_as_the_program():
    text = (ROOT / "docs/collisions/double-pendulum.toml").read_text(encoding="utf-8")
    pendulum = kane.collide(text)
    assert {a.energy for a in pendulum.laws.values()} >= {"created", "lost"}
    irrational = [
        q for a in pendulum.laws.values() for q in a.quantities.values() if q.exact is None
    ]
    assert all(q.digits is None or q.nearest is not None for q in irrational)


def test_a_notebook_shows_a_table():
    html = kane.collide(**BALL)._repr_html_()
    assert "<table>" in html and "smith-1991" in html
    assert "smith-1991" in kane.collide(**BALL).html()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"friction": -1}, "friction"),
        ({"restitution": 2}, "restitution"),
        ({"restitution": float("nan")}, "restitution"),
        ({"friction": float("inf")}, "friction"),
        ({"friction": None}, "missing: friction"),
        ({"velocity": (1, 1)}, "moves away from the plane"),
        ({"velocity": (1, 2, 3)}, "velocity"),
        ({"velocity": "12"}, "velocity"),
        ({"velocity": 3}, "velocity"),
        ({"velocity": (None, -1)}, "velocity is no number"),
        ({"mass": 0}, "mass"),
        ({"mass": True}, "mass is no number"),
        ({"radius": [1]}, "radius is no number"),
        ({"shape": "cube"}, "cube"),
        ({"shape": 'sphere"\n[rod-tip]'}, "sphere"),
        ({"law": "smith"}, "no law is called"),
        ({"parameters": {"walton.beta": 1}}, "walton.beta"),
        ({"parameters": {"walton.beta0": 2}}, "from 0 to 1"),
    ],
)
def test_bad_input_is_an_error_that_names_it(change, message):
    with pytest.raises(ValueError, match=message):
        kane.collide(**{**BALL, **change})


def test_a_text_and_a_body_are_two_collisions():
    with pytest.raises(ValueError, match="two collisions"):
        kane.collide("friction = 1", shape="sphere")
    with pytest.raises(ValueError):
        kane.collide("this is not TOML =")


def test_laws_have_their_parameters():
    laws = kane.laws()
    walton = laws["walton"].parameters[0]
    assert (walton.name, walton.default) == ("beta0", Fraction(11, 25))
    assert set(kane.batched()) <= set(laws)


def test_a_scene_is_answered():
    text = (ROOT / "docs/scenes/backspin.toml").read_text(encoding="utf-8")
    answer = kane.scene(text)
    assert answer.good_enough and "<iframe" in answer._repr_html_()
    with pytest.raises(ValueError):
        kane.scene("friction = 1")
    with pytest.raises(ValueError, match="did you mean"):
        kane.scene(text, model="routh-newto")
