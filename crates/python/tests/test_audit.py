"""Audits: verdicts, and witnesses that can be checked by hand."""

import subprocess
import sys
import threading
from fractions import Fraction
from pathlib import Path

import kane
import pytest

ROOT = Path(__file__).parents[3]

WALL = """# A ball meets a wall

```kane
var m > 0, u > 0, v, 0 <= e <= 1
given rebound: v = -e*u
let loss := 1/2*m*u^2 - 1/2*m*v^2
claim energy: loss = 1/2*m*u^2*(1 - e^2)   from rebound
claim strict: loss > 0                     from energy
```
"""


def test_verdicts_are_those_of_the_program():
    audit = kane.audit(WALL, name="wall.md")
    verdicts = [s.verdict for s in audit]
    assert verdicts == ["assumed", "defined", "proved", "refuted"]
    assert not audit.as_expected and [s.label for s in audit.unexpected] == ["strict"]
    assert audit.title == "A ball meets a wall" and len(audit) == 4
    assert "2 claims: 1 proved, 1 refuted" in audit.headline
    assert audit["energy"].rests_on == ("rebound",)


def test_a_witness_is_exact_and_speaks_against_the_claim():
    strict = kane.audit(WALL)["strict"]
    point = strict.witness
    assert point is not None and all(isinstance(v, Fraction) for v in point.values())
    assert point["e"] == 1 and point["m"] > 0 and point["u"] > 0
    v = point.get("v", -point["e"] * point["u"])
    loss = point["m"] * point["u"] ** 2 / 2 - point["m"] * v**2 / 2
    assert not loss > 0


def test_what_is_proved_has_a_certificate_and_no_witness():
    energy = kane.audit(WALL)["energy"]
    assert energy.witness is None and len(energy.links) == 1
    certificate = energy.links[0].certificate
    assert certificate is not None and len(certificate) == 32
    assert energy.links[0].steps


def test_an_irrational_witness_keeps_its_polynomial():
    text = "```kane\nvar x > 0\ngiven square: x^2 = 2\nclaim small: x < 1 from square\n```\n"
    point = kane.audit(text)["small"].witness
    assert point is not None
    x = point["x"]
    assert isinstance(x, kane.Irrational)
    low, high = x.between
    value = lambda t: sum(c * t**n for n, c in enumerate(x.root_of))  # noqa: E731
    assert value(low) * value(high) <= 0, "the root is between the ends"
    assert abs(float(x) - 2**0.5) < 1e-15


def test_the_paper_is_judged_as_on_the_command_line():
    path = ROOT / "docs/derivations/bouncing-ball.md"
    audit = kane.audit(path.read_text(encoding="utf-8"), name=path.name)
    assert audit.as_expected
    assert {s.verdict for s in audit.claims} <= {"proved", "refuted", "undecided"}
    assert audit["height"].verdict == "proved"


def test_labels_and_explanations():
    audit = kane.audit("```kane\nvar x > 0\nclaim (9): x + 1 > 1\n```\n")
    assert audit["9"] is audit["(9)"]
    assert "(9)" in audit.explain("9")
    with pytest.raises(KeyError, match="no statement is labelled 'ten'"):
        audit["ten"]


def test_every_form_shows_the_verdict():
    audit = kane.audit(WALL)
    for form in (audit.json(), audit.html(), audit.markdown(), str(audit), audit._repr_html_()):
        assert "refuted" in form
    assert "refuted" in repr(audit)


def test_a_notebook_is_sent_no_markup_of_the_document():
    hostile = "# <script>alert(1)</script>\n\n```kane\nvar x > 0\nclaim a: x < 1 when x > 0\n```\n"
    html = kane.audit(hostile)._repr_html_()
    assert "<script" not in html and "x &lt; 1" in html


@pytest.mark.parametrize(
    "text",
    [
        "```kane\nvar x\nclaim a: y = 1\n```\n",
        "```kane\nvar x\nclaim a: (x = 1\n```\n",
        "```kane\nvar x\nclaim a: x = 1 from b\n```\n",
        "```kane\n\x00\n```\n",
        "```kane\nvar x\nclaim a: " + "(" * 5000 + "x\n```\n",
    ],
)
def test_bad_documents_are_errors_with_a_place(text):
    with pytest.raises(ValueError, match="document.md:"):
        kane.audit(text)


def test_a_written_zero_below_is_judged_as_any_other():
    for below in ("0", "(3 - 3)"):
        (claim,) = kane.audit(f"```kane\nclaim a: 1/{below} = 1\n```\n").claims
        assert claim.verdict == "ill-defined"


def test_bad_arguments_are_errors():
    with pytest.raises(ValueError, match="effort"):
        kane.audit(WALL, effort=0)
    with pytest.raises(TypeError):
        kane.audit(b"bytes")
    with pytest.raises((ValueError, UnicodeError)):
        kane.audit("\ud800")
    assert kane.audit("").claims == ()

LONG = """```kane
var a, b, c, g, f
claim a: a^4*b^2 + a^2*b^4 + 2*c^6 - 3*a^2*b^2*c^2 + g^4*f^2 + g^2*f^4 - 3*g^2*f^2*c^2 + 1/1000000 > 0
```
"""

INTERRUPTED = f"""
import os, signal, threading, time
import kane
# a shell that runs the tests in the background has its children ignore it
signal.signal(signal.SIGINT, signal.default_int_handler)
began = []
def interrupt():
    time.sleep(0.3)
    began.append(time.perf_counter())
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=interrupt).start()
try:
    kane.audit({LONG!r}, effort=1_000_000)
except KeyboardInterrupt:
    print(time.perf_counter() - began[0])
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent as on Unix")
def test_an_interrupt_is_heard_in_the_middle_of_a_claim():
    program = [sys.executable, "-c", INTERRUPTED]
    run = subprocess.run(program, capture_output=True, text=True, check=True, timeout=60)
    assert float(run.stdout) < 5


def test_a_thread_with_a_small_stack_judges_what_is_deep():
    deep = "```kane\nvar x\nclaim a: " + "(" * 250 + "x" + ")" * 250 + " = x\n```\n"
    found = []
    threading.stack_size(64 << 10)
    try:
        thread = threading.Thread(target=lambda: found.append(kane.audit(deep)["a"].verdict))
        thread.start()
        thread.join()
    finally:
        threading.stack_size(0)
    assert found == ["proved"]
