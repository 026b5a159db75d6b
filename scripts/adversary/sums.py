#!/usr/bin/env python3
"""Random claims on sums and products over ranges, of symbols with bounds that speak of each other, added up plainly.

A sum is a loop in fractions, whatever its ends are. A verdict is wrong if numbers within the declared bounds speak against it:

- `proved`, and at some n of its range and some values of the symbols the claim is false;
- `refuted`, and at the n and the values that the report names it is true, or they are outside of the bounds;
- `vacuous` or `ill-defined`: nothing is assumed here but the bounds, and all is defined.

    python3 scripts/adversary/sums.py KANE [COUNT [SEED]] [--certificates]
"""

import random
import re
import sys
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from sequences import BOUND, FURTHEST, RELATIONS, Claim, Node, number  # noqa: E402
from trial import Trial  # noqa: E402

CLAIMS = 7
DECLARED = "var n in N, x > 0, 0 < q < x, 2*x <= p, y, y - 1 < z <= y + 2"
FOR, VALUE = re.compile(r"for n = (\d+)"), re.compile(r"\b([xqpyz]) = (-?\d+(?:/\d+)?)")


def symbol(name):
    return Node(name, lambda n, at: at[name])


def inside(at):
    return at["x"] > 0 and 0 < at["q"] < at["x"] and 2 * at["x"] <= at["p"] and at["y"] - 1 < at["z"] <= at["y"] + 2


def completed(told, rng=None):
    """A point within the bounds that has these values; None if there is none."""
    pick = rng.choice if rng else lambda values: values[0]
    at = {name: Fraction(value) for name, value in told.items()}
    if "x" not in at:
        low, high = at.get("q"), at["p"] / 2 if "p" in at else None
        if low is not None:
            x = low + 1 if high is None else (low + high) / 2 if low < high else low + 1
        else:
            x = high if high is not None else Fraction(pick(["1", "1/7", "1/2", "3/2", "5", "2"]))
        at["x"] = x
    at.setdefault("q", at["x"] * Fraction(pick(["1/2", "1/100", "99/100", "1/3"])))
    at.setdefault("p", at["x"] * Fraction(pick(["2", "3", "5/2", "40"])))
    if "y" not in at:
        at["y"] = at["z"] if "z" in at else Fraction(pick(["0", "-3", "-1/2", "1", "2", "7"]))
    at.setdefault("z", at["y"] + Fraction(pick(["0", "2", "1", "-1/2", "-99/100"])))
    return at if inside(at) else None


def raised(base, over, exponent):
    text = f"{base.text}^{exponent if exponent == over else f'({exponent})'}"
    factor, plus = (2, 0) if exponent.startswith("2*") else (1, int((exponent + " + 0").split(" + ")[1]))
    return Node(text, lambda n, at: base.value(n, at) ** int(factor * at[over] + plus))


def term(rng, over, first):
    """A term that speaks of what the sum runs over; it has a value at all that is at least `first`."""
    k = symbol(over)
    base = symbol(rng.choice("xqpyz"))
    choices = [k, k, k * k, number(1), base, base * k, k - number(1), number(2) * k + number(1)]
    if first >= 0:
        choices += [raised(base, over, rng.choice([over, f"{over} + 1", f"2*{over}"])) for _ in range(3)]
    divisors = [(f"{over} + 2", lambda n, at: at[over] + 2), ("x", lambda n, at: at["x"]), ("x + 1", lambda n, at: at["x"] + 1)]
    if first >= 1:
        divisors += [(over, lambda n, at: at[over]), (f"{over}^2", lambda n, at: at[over] ** 2)]
    a = rng.choice(choices)
    if rng.random() < 0.35:
        text, value = rng.choice(divisors)
        top = a
        a = Node(f"({top.text})/({text})", lambda n, at: top.value(n, at) / value(n, at))
    return rng.choice([a, a, a + rng.choice(choices), a - rng.choice(choices), a * rng.choice(choices)])


def ranged(rng, product, over, body, low, high):
    """The loop that a sum is; `high` gives the last number."""

    def value(n, at):
        total = Fraction(int(product))
        for k in range(low, high.value(n, at) + 1):
            one = body.value(n, {**at, over: Fraction(k)})
            total = total * one if product else total + one
        return total

    word = "prod" if product else "sum"
    return Node(f"{word}({body.text} for {over} in {low}..{high.text})", value)


def summed(rng):
    """A sum or a product: between numbers, up to n, or of sums."""
    product, over = rng.random() < 0.3, rng.choice("kij")
    kind = rng.random()
    if kind < 0.2:
        low = rng.choice([-1, 0, 1, 1, 2])
        high = rng.choice([low - 1, low, low + 2, 4])
        return ranged(rng, product, over, term(rng, over, low), low, Node(str(high), lambda n, at: high))
    low = rng.choice([0, 1, 1, 1, 2])
    plus = rng.choice([0, 0, 1, 2]) + max(low - 1, 0)
    high = Node("n" + (f" + {plus}" if plus else ""), lambda n, at: n + plus)
    if kind < 0.35:
        inner = "l"
        body = ranged(rng, rng.random() < 0.2, inner, term(rng, inner, 1), 1, Node(over, lambda n, at: int(at[over])))
        return ranged(rng, False, over, rng.choice([body, body * symbol(over)]), low, high)
    return ranged(rng, product, over, term(rng, over, low), low, high)


def book(rng):
    """Claims of the books, at times with a slip: (left, relation, right)."""
    slip = number(rng.choice([0, 0, 0, 1, "1/100"]))
    b = symbol(rng.choice("xqpyz"))
    n = Node("n", lambda m, at: Fraction(m))
    k = symbol("k")
    upto = Node("n", lambda m, at: m)
    one = number(1)
    add = lambda body, low=1: ranged(rng, False, "k", body, low, upto)  # noqa: E731
    over = lambda a, f, text: Node(f"{a.text}/({text})", lambda m, at: a.value(m, at) / f(m, at))  # noqa: E731
    return rng.choice([
        (number(2) * add(k), "=", n * (n + one) + slip),
        (number(6) * add(k * k), "=", n * (n + one) * (number(2) * n + one) + slip),
        (number(4) * add(k * k * k), "=", n * n * (n + one) * (n + one) + slip),
        ((one - b) * add(raised(b, "k", "k"), 0), "=", one - Node(f"{b.text}^(n + 1)", lambda m, at: b.value(m, at) ** (m + 1)) + slip),
        (add(number(2) * k - one + slip), "=", n * n),
        (add(over(one, lambda m, at: at["k"] * (at["k"] + 1), "k*(k + 1)")), "=", over(n, lambda m, at: m + 1, "n + 1") + slip),
        (ranged(rng, True, "k", one + over(one, lambda m, at: at["k"], "k"), 1, upto), "=", n + one + slip),
        (add(symbol("q")), rng.choice(["<=", "<"]), n * symbol("x") + slip),
        (add(raised(symbol("x"), "k", "k")), rng.choice([">=", ">"]), slip),
        (number(2) * add(symbol("x")), "<=", n * symbol("p") + slip),
        (add(symbol("z") - symbol("y")), "<=", n * number(2) + slip),
        (symbol("q"), "<", symbol("p") - symbol("x") + slip),
    ])


def random_claim(rng):
    choices = [summed(rng), summed(rng), Node("n", lambda m, at: Fraction(m)), number(rng.choice([0, 1, 2, "1/2"])), symbol(rng.choice("xqpyz"))]

    def side():
        a = rng.choice(choices)
        return rng.choice([a, a, a + rng.choice(choices), a * rng.choice(choices)])

    return rng.choice(choices[:2]), rng.choice(list(RELATIONS)), side()


def document(rng):
    lines, claims = [DECLARED], {}
    for i in range(CLAIMS):
        left, relation, right = book(rng) if rng.random() < 0.45 else random_claim(rng)
        cites = rng.sample(list(claims), 1) if claims and rng.random() < 0.4 else []
        way = rng.choice(["induction", "induction", "range", "plain"])
        claims[f"c{i}"] = claim = Claim(left, relation, right, rng.choice([0, 0, 1, 2]), way, cites)
        lines.append(claim.text(f"c{i}"))
    return "# Sums\n\n```kane\n" + "\n".join(lines) + "\n```\n", claims


def judged_wrong(claim, statement, places):
    """Why a verdict is wrong, if it is."""
    verdict = statement["verdict"]
    if verdict in ("vacuous", "ill-defined"):
        return f"it is {verdict}, where nothing is assumed and all is defined"
    if verdict == "proved":
        failure = claim.failure(places)
        return failure and f"proved, and false at {failure}"
    for link in statement["links"] if verdict == "refuted" else []:
        if link["verdict"] != "refuted" or " = the root of " in link["reason"]:
            continue  # the second checker evaluates what is irrational
        reason = link["reason"].partition("left side")[0]
        n = (FOR.search(reason) or BOUND.search(link["text"]) or [None, None])[1]
        told = dict(VALUE.findall(reason))
        at = completed(told)
        if at is None:
            return f"refuted outside of the bounds: {link['reason']}"
        if n is None and claim.way == "plain" and "n" not in re.findall(r"\w+", claim.text("c")):
            n = 0
        if n is None:
            return f"a witness without an index: {link['reason']}"
        if claim.holds(int(n), at) or (claim.way != "plain" and int(n) < claim.first):
            return f"refuted, and true at n = {n}, {at}: {link['reason']}"
    return None


def main():
    trial = Trial("sums")
    rng = random.Random(trial.seed)
    for source, claims, statements in trial.documents(document, rng, 300_000):
        places = [at for at in (completed({}, rng) for _ in range(40)) if at]
        for statement in statements:
            claim = claims.get(statement["label"])
            if not claim:
                continue
            trial.judged += 1
            true = "false" if claim.failure(places) else "true"
            trial.count_one(f"{claim.way}, {true}, {statement['verdict']}")
            why = judged_wrong(claim, statement, places)
            if why:
                trial.wrong.append((source, f"{statement['label']}: {why}"))
    return trial.told()


if __name__ == "__main__":
    sys.exit(main())
