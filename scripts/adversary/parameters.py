"""Limits of formulas with several symbols under roots, right and wrong ones, and verdicts judged by numbers.

usage: parameters.py KANE [COUNT [SEED]] [--certificates] [--show-open]

Limits that are known (`KNOWN`, each by a line of algebra on paper) are written with products, quotients, sums and roots
of positive symbols in the place of their letters, and with a multiple of the variable in its place; or with something
else on the right. Whether such a claim is true is not taken from that: values in 1,300 decimal digits tell it at several
choices of the symbols. A refutation is evaluated at the symbols that it names.
"""

import random
import re
import sys
from decimal import Context, Decimal, localcontext
from fractions import Fraction

import witness
from expr import ONE, ZERO, add, div, mul, num, show, sub, substitute, var
from radicals import approaches, behaviour, judged, true
from reader import Unreadable, read
from trial import Trial

CLAIMS = 8  # a document
#: what 400 digits of depth and their squares leave is enough for the 20 by which limits are told apart
EXACT = Context(prec=1300, Emax=10**9, Emin=-(10**9))
SYMBOLS = ["a", "b", "c", "m", "k"]
INFINITE = ("oo", "-oo")

# Where x goes, what tends there, and where to; p, q and r are positive.
KNOWN = [
    ("0", "sqrt(p^2 + q*x)", "p"),
    ("0", "sqrt(p + q*x)", "sqrt(p)"),
    ("0", "sqrt(p - x^2/q)", "sqrt(p)"),
    ("0", "(sqrt(p^2 + q*x) - p)/x", "q/(2*p)"),
    ("0", "(sqrt(p + q*x) - sqrt(p))/x", "q/(2*sqrt(p))"),
    ("0", "(sqrt(p + x) - sqrt(p - x))/x", "1/sqrt(p)"),
    ("0", "(p - sqrt(p^2 - x^2))/x^2", "1/(2*p)"),
    ("0", "r*x/(sqrt(p^2 + q*x) - p)", "2*p*r/q"),
    ("0", "sqrt((p + q*x)/(r + x))", "sqrt(p/r)"),
    ("0", "sqrt(p + x)*sqrt(q + x)", "sqrt(p*q)"),
    ("0", "sqrt(p + x)/sqrt(q + x)", "sqrt(p/q)"),
    ("0", "1/sqrt(1 - x^2/p^2)", "1"),
    ("0", "p*(1/sqrt(1 - x^2/p) - 1)/x^2", "1/2"),
    ("0+", "sqrt(x)*p/sqrt(q*x + x^2)", "p/sqrt(q)"),
    ("0+", "p/sqrt(q*x)", "oo"),
    ("0+", "sqrt(p*x)/(q + x)", "0"),
    ("0+", "(p + q*sqrt(x))/(r + sqrt(x))", "p/r"),
    ("oo", "sqrt(x^2 + p*x) - x", "p/2"),
    ("oo", "sqrt(x^2 + p*x) - sqrt(x^2 + q*x)", "(p - q)/2"),
    ("oo", "sqrt(p^2*x^2 + q*x) - p*x", "q/(2*p)"),
    ("oo", "sqrt(p*x + q)/sqrt(r*x + 1)", "sqrt(p/r)"),
    ("oo", "sqrt(p*x^2 + q)/(r*x + 1)", "sqrt(p)/r"),
    ("oo", "sqrt(x + p) - sqrt(x)", "0"),
    ("oo", "sqrt(x)*(sqrt(x + p) - sqrt(x))", "p/2"),
    ("oo", "x*(sqrt(x^2 + p) - x)", "p/2"),
    ("oo", "x/sqrt(x^2 + p^2)", "1"),
    ("oo", "sqrt(p*x) + q", "oo"),
    ("oo", "p/sqrt(x + q)", "0"),
    ("oo", "sqrt(p + q/x)", "sqrt(p)"),
    ("oo", "p - sqrt(q*x + r)", "-oo"),
]


def known(where, expression, target, letters):
    """A known limit with expressions in the place of its letters: what tends, the point, the side, and where to."""
    aim = target if target in INFINITE else substitute(read(target), letters)
    return substitute(read(expression), letters), where.rstrip("+-"), where[-1] if where[-1] in "+-" else "", aim


def formula(rng, symbols):
    """A positive expression in the symbols, most of the time one of them."""
    r = rng.random()
    two = {letter: var(rng.choice(symbols)) for letter in "st"}
    if r < 0.45:
        written = "s"
    elif r < 0.75:
        written = rng.choice(["s*t", "s/t", "2*s", "s/2", "s^2", "s*t^2"])
    elif r < 0.85:
        written = rng.choice(["s + t", "s^2 + t", "1 + s*t", "s + 1"])
    elif r < 0.92:
        written = rng.choice(["sqrt(s)", "sqrt(s*t)", "sqrt(s/t)"])
    else:
        written = rng.choice(["1", "2", "3", "1/2"])
    return substitute(read(written), two)


def otherwise(rng, target, symbols):
    """Something else on the right."""
    if target in INFINITE:
        return rng.choice(["-oo" if target == "oo" else "oo", ZERO, var(rng.choice(symbols))])
    t, s = target, var(rng.choice(symbols))
    wrong = [mul(num(2), t), div(t, num(2)), mul(t, s), div(t, s), add(t, num(Fraction(1, 100))), add(t, s)]
    wrong += [sub(t, div(s, num(1000))), mul(num(-1), t), ZERO]
    return rng.choice([*wrong, *INFINITE])


def written(expression, point, side, target):
    """A limit as documents write it."""
    return f"{show(expression)} -> {target if target in INFINITE else show(target)} as x -> {point}{side}"


def document(rng):
    """A document's text, and its claims as (label, expression, point, side, target, symbols, conditions)."""
    symbols = rng.sample(SYMBOLS, rng.randint(1, 4))
    lines = ["# Limits with symbols", "", "```kane", "var x" + "".join(f", {s} > 0" for s in symbols)]
    claims = []
    for i in range(CLAIMS):
        one = rng.choice(KNOWN)
        stretch = formula(rng, symbols)
        x = rng.choice([var("x"), var("x"), mul(var("x"), stretch), div(var("x"), stretch)])
        letters = {"x": x, **{letter: formula(rng, symbols) for letter in "pqr"}}
        expression, point, side, target = known(*one, letters)
        if rng.random() < 0.4:
            target = otherwise(rng, target, symbols)
        if point == "0" and not side and rng.random() < 0.4:
            side = rng.choice("+-")
        lines.append(f"claim c{i}: {written(expression, point, side, target)}")
        claims.append((f"c{i}", expression, point, side, target, symbols, ()))
    return "\n".join([*lines, "```", ""]), claims


def applies(claim, constants):
    """Whether the conditions of a claim hold at these symbols."""
    return all(true(condition, constants) for condition in claim[-1])


def holds(claim, constants):
    """Whether a claim is true at these symbols: True, False, or None if that is not clear."""
    _, e, point, side, target, *_ = claim
    if not applies(claim, constants):
        return True
    found = [judged(behaviour(e, x, constants), target, constants) for x in approaches(point, side)]
    return False if False in found else None if None in found else True


def draws(rng, symbols):
    """Choices of the symbols, of which some are large or small."""
    for _ in range(6):
        yield {s: Decimal(rng.choice([1, 2, 3, 4, 7, 10, 100])) / rng.choice([1, 1, 2, 3, 50]) for s in symbols}


def truth(choices, claim):
    """Whether a claim is "right" at all choices of its symbols, "wrong" at one of them, or "unclear"; or "empty"."""
    truths = [holds(claim, constants) for constants in choices if applies(claim, constants)]
    if not truths:
        return "empty"
    return "wrong" if False in truths else "unclear" if None in truths else "right"


def chosen(link, symbols):
    """The symbols at which a link is refuted, as decimals; 1 for what does not matter there. None if it names no such."""
    taken = witness.functions(link)
    if taken is None:
        return None
    values = {s: witness.number_of(taken.get(s, ONE)) for s in symbols}
    return {s: Decimal(v.numerator) / Decimal(v.denominator) for s, v in values.items()}


def complaint(claim, kind, statement):
    """Why a verdict is wrong on a claim of this kind, or nothing."""
    label, e, point, side, _, symbols, conditions = claim
    verdict = statement["verdict"]
    if (verdict == "vacuous" and kind != "empty") or (verdict == "proved" and kind == "wrong"):
        return f"{label} is {verdict}"
    if verdict not in ("refuted", "ill-defined"):
        return ""
    (link,) = statement["links"]
    reason, constants = link["reason"], chosen(link, symbols)
    if constants is None:
        return f"{label} is {verdict}, and names no symbols: {reason}"
    if not applies(claim, constants):
        return f"{label} is {verdict} where its condition fails: {reason}"
    if holds(claim, constants):
        return f"{label} is {verdict}, and true where it says: {reason}"
    limit = told_limit(reason)
    if limit and not any(holds((label, e, *way, limit, symbols, ()), constants) for way in ways(point, side)):
        return f"{label} has another limit where it is refuted: {reason}"
    return ""


def told_limit(reason):
    """What a reason says the limit is, as an expression or an infinity; None if it says none, or in other words."""
    told = re.search(r"the limit is ([^;,]+?)(?: \(|[;,]|\.?$)", reason)
    try:
        return told and (told[1] if told[1] in INFINITE else read(told[1]))
    except Unreadable:
        return None


def ways(point, side):
    """The sides from which a point is approached."""
    return [(point, side)] if side or point == "oo" else [(point, "+"), (point, "-")]


def selftest():
    """Each limit that is known is one, by its values, and wrong verdicts on two of them are seen."""
    rng = random.Random(0)
    letters = dict(zip("pqr", map(var, "abc")))
    for one in KNOWN:
        claim = ("", *known(*one, letters), ["a", "b", "c"], ())
        assert truth(draws(rng, claim[-2]), claim) == "right", one

    def said(verdict, taken, limit):
        steps = [{"depth": 0, "text": f"Take {taken}."}, {"depth": 0, "text": f"Then the limit is {limit}."}]
        reason = f"false under all that was assumed, for {taken}: the limit is {limit}"
        return {"verdict": verdict, "links": [{"verdict": verdict, "reason": reason, "steps": steps}]}

    right = ("c", *known("oo", "sqrt(x^2 + p*x) - x", "p/2", letters), ["a"], ())
    wrong = ("c", *known("oo", "sqrt(x^2 + p*x) - x", "p", letters), ["a"], ())
    assert not complaint(right, "right", said("proved", "", "")) and not complaint(wrong, "wrong", said("refuted", "a = 1/2", "0.25"))
    assert complaint(wrong, "wrong", said("proved", "", "")), "a wrong claim is proved"
    assert complaint(right, "right", said("refuted", "a = 2", "1")), "a right claim is refuted"
    assert complaint(wrong, "wrong", said("refuted", "a = 1/2", "0.26")), "the limit is another"


def judge(trial, document, choices):
    """Puts documents to the program, and its verdicts against the values at choices of the symbols."""
    rng = random.Random(trial.seed)
    for source, claims, statements in trial.documents(document, rng, 4_000_000):
        of_label = {s["label"]: s for s in statements}
        for claim in claims:
            statement = of_label[claim[0]]
            trial.judged += 1
            kind, verdict = truth(choices(rng, claim[-2]), claim), statement["verdict"]
            trial.count_one(f"{kind}, {verdict}")
            if verdict == "undecided" and kind in ("right", "wrong") and "--show-open" in sys.argv:
                print(f"open ({kind}): {statement['source']}", file=sys.stderr, flush=True)
            why = complaint(claim, kind, statement)
            if why:
                trial.wrong.append((source, why))
    return trial.told()


def main():
    trial = Trial("parameters")
    with localcontext(EXACT):
        selftest()
        return judge(trial, document, draws)


if __name__ == "__main__":
    sys.exit(main())
