#!/usr/bin/env python3
"""Everyday claims in two to four symbols, each put to z3 as well: what it decides within a second should be decided.

    python3 scripts/adversary/everyday.py KANE [COUNT [SEED]] [--certificates] [--show-open]

Sums of squares of linear sums, polynomials, quotients by such sums, roots of them, products and magnitudes, under ranges,
linear and quadratic conditions. Ends with 1 if z3 says otherwise, or the second checker refuses a certificate; what stays
undecided is counted, and no error.
"""

import random
import sys
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import solver  # noqa: E402
from document import Document  # noqa: E402
from expr import add, div, mul, num, power, sub, total, var  # noqa: E402
from trial import Trial  # noqa: E402

OPERATIONS = 40_000_000  # as without the option
DECIDED = {"proved": "unsat", "vacuous": "unsat", "refuted": "sat", "ill-defined": "sat"}


def linear(rng, names):
    chosen = rng.sample(names, rng.randint(1, len(names)))
    return add(total(mul(num(rng.randint(-3, 3) or 1), var(v)) for v in chosen), num(rng.randint(-4, 4)))


def monomial(rng, names, degree):
    out = num(rng.randint(-4, 4) or 1)
    for _ in range(rng.randint(0, degree)):
        out = mul(out, var(rng.choice(names)))
    return out


def polynomial(rng, names, degree, terms):
    return total(monomial(rng, names, degree) for _ in range(terms))


def squares(rng, names):
    return total(power(linear(rng, names), 2) for _ in range(rng.randint(1, 3)))


def bound(rng, most=8):
    return num(Fraction(rng.randint(1, most), rng.randint(1, 4)))


def quotient(rng, names):
    return div(linear(rng, names), add(num(rng.randint(1, 2)), squares(rng, names)))


def conclusion(rng, names):
    above, below = rng.choice([">=", ">"]), rng.choice(["<=", "<"])
    family = rng.choice(
        ["squares", "polynomial", "parabola", "quotient", "quotients", "root", "roots", "product", "sextic", "magnitudes"]
    )
    if family == "squares":
        return family, (above, squares(rng, names), rng.choice([num(0), num(-1), num(1), linear(rng, names)]))
    if family == "polynomial":
        degree = rng.choice([2, 3, 4])
        return family, (rng.choice([above, below]), polynomial(rng, names, degree, 4), num(rng.randint(-20, 20)))
    if family == "parabola":
        return family, (above, squares(rng, names), polynomial(rng, names, 2, 2))
    if family == "quotient":
        return family, (below, quotient(rng, names), bound(rng))
    if family == "quotients":
        return family, (below, add(quotient(rng, names), quotient(rng, names)), bound(rng))
    if family == "root":
        return family, (above, ("sqrt", squares(rng, names)), linear(rng, names))
    if family == "roots":
        return family, (above, add(("sqrt", squares(rng, names)), ("sqrt", squares(rng, names))), linear(rng, names))
    if family == "product":
        right = sub(power(linear(rng, names), 2), num(rng.randint(0, 20)))
        return family, (above, mul(squares(rng, names), squares(rng, names)), right)
    if family == "sextic":
        left = add(polynomial(rng, names, 6, 4), mul(num(rng.randint(1, 9)), power(squares(rng, names), 3)))
        return family, (above, left, num(rng.randint(-30, 3)))
    left = add(("abs", linear(rng, names)), ("abs", linear(rng, names)))
    return family, (above, left, ("abs", linear(rng, names)))


def condition(rng, names):
    kind = rng.randrange(5)
    if kind == 0:
        return (">=", linear(rng, names), num(0))
    if kind == 1:
        return ("<=", squares(rng, names), num(rng.randint(1, 9)))
    if kind == 2:
        return ("=", linear(rng, names), num(0))
    if kind == 3:
        return ("=", polynomial(rng, names, 2, 2), num(rng.randint(0, 3)))
    return (">=", polynomial(rng, names, 2, 2), num(rng.randint(-3, 3)))


def made(rng):
    """A document of one claim, so that it has all of the budget, the name of its family, and the question for z3."""
    names = ["x", "y", "z", "w"][: rng.randint(2, 4)]
    document = Document("everyday", rng)
    for name in names:
        lower = rng.choice([None, None, (Fraction(0), True), (Fraction(0), False), (Fraction(1), True)])
        document.declare(name, lower=lower)
    cites = [document.given([condition(rng, names)]) for _ in range(rng.choice([0, 0, 1, 2]))]
    family, relation = conclusion(rng, names)
    document.claim([relation], cites=cites)
    claim = document.claims()[0]
    return document.text("Everyday"), family, solver.Encoder(document).question(claim, 0, "proved")


def main():
    trial = Trial("everyday")
    if not solver.available():
        print("z3 is not installed, and nothing else tells what is true")
        return 2
    solver.MILLISECONDS = 1_000
    rng = random.Random(trial.seed)
    while trial.judged < trial.count:
        source, family, question = made(rng)
        statements, messages = trial.statements(source, OPERATIONS)
        if statements is None:
            trial.note(source, messages)
            break
        trial.judged += 1
        verdict = next(s["verdict"] for s in statements if s["kind"] == "claim")
        answer = solver.ask([question])[0]
        if answer in ("sat", "unsat") and DECIDED.get(verdict, answer) != answer:
            trial.note(source, f"{verdict}, and z3 says {answer}")
        is_open = verdict == "undecided" and answer in ("sat", "unsat")
        trial.count_one(f"undecided, z3 says {answer}" if is_open else "both undecided" if verdict == "undecided" else verdict)
        if is_open and "--show-open" in sys.argv:
            print(f"{family}, z3 says {answer}\n{source}", flush=True)
    return trial.told()


if __name__ == "__main__":
    sys.exit(main())
