"""Inequalities whose sides agree at a point: with roots and quotients, with hints, right ones and wrong ones.

usage: touching.py KANE [COUNT [SEED]] [--certificates] [--show-open] [--keep DIR]

What is right is so by a proof on paper (`inequalities.py`), with positive expressions in the place of letters, moved,
scaled or made weaker (`contacts.py`). Wrong ones have a constant a little larger, another direction, another coefficient,
a strict sign at the point of contact, or lack a premise. Hints are right, wrong, negative or undefined, and must change
nothing that is false. Values in 320 digits tell whether a claim fails (`neighbourhoods.py`), and each witness is
evaluated, in digits and exactly.
"""

import random
import re
import sys
import time
from decimal import Decimal
from fractions import Fraction

import told
import witness
from algebraic import Alg, Costly
from contacts import Claim, Contradiction, Setting
from expr import relation
from inequalities import Known
from neighbourhoods import Unclear, digits, holds
from point import Ambiguous, Scope
from reader import Reader, Unreadable
from trial import Trial

BUDGET = 2_000_000
CLAIMS = 3  # a document
NEAR = re.compile(r"(?:at|,) ([a-z]) near (-?[\d.]+(?:e-?\d+)?)")
SIDES = re.compile(r": left side (.*?), right side (.*?)(?: \(|$)")


def document(rng):
    setting = Setting(rng)
    claims = [Claim(rng, setting, f"c{i}", right=i == 0) for i in range(CLAIMS)]
    if rng.random() < 0.3:
        claims.append(Contradiction(rng, setting, f"c{CLAIMS}", right=rng.random() < 0.5))
    lines = ["# Where both sides agree", "", "```kane", *setting.lines(), *(claim.text() for claim in claims), "```", ""]
    return "\n".join(lines), claims


class Place:
    """A point for those who ask exactly."""

    def __init__(self, values):
        self.values, self.scope = values, Scope({}, values)

    def beside(self, more):
        """The same place with these values."""
        return Place({**self.values, **more})


def in_digits(v):
    v = v.near(1600) if isinstance(v, Alg) else v
    return Decimal(v.numerator) / Decimal(v.denominator)


def complete(claim, values):
    """The values of all symbols: what is not named does not matter, so that it may be anything positive."""
    names = [*claim.setting.symbols, "w"]
    return [{n: in_digits(values[n]) if n in values else Decimal(other) for n in names} for other in (1, 3)]


def true_at(conditions, place):
    return all(holds(c, place) is True for c in conditions)


def witness_faults(claim, link):
    """What is wrong with the point at which a claim is said to fail."""
    values = witness.point(link)
    if values is None:
        yield f"names no point: {link['reason']}"
        return
    verdict, reason = link["verdict"], link["reason"]
    expected = False if verdict == "refuted" else None
    for place in complete(claim, values):
        for condition in claim.conditions():
            if holds(condition, place) is not True:
                yield f"is {verdict} where {relation(condition)} fails: {reason}"
        if holds(claim.relation, place) is not expected:
            yield f"is {verdict} where it is not so: {reason}"
    yield from standing_faults(claim, link, values)
    mistakes, _ = told.mistakes(link, Place(values))
    for line in mistakes:
        yield f"tells what is not so: {line}"
    for name, near in NEAR.findall(reason):
        if told.fits(f"about {near}", values[name]) is False:
            yield f"tells another value of {name}: {reason}"
    told_sides = SIDES.search(reason)
    for said, side in zip(told_sides.groups() if told_sides else (), claim.relation[1:]):
        if told.fits(said, told.value(side, Place(values))) is False:
            yield f"tells another value of a side: {reason}"


def standing_faults(claim, link, values):
    """What is said of the givens that are not cited: all hold there, or those that are named fail."""
    others = claim.uncited()
    if isinstance(claim, Contradiction):
        return
    named = all(s in values for s in claim.setting.symbols)
    if (link["standing"] == "false") != ("under all that was assumed" in link["reason"]):
        yield f"has words that do not fit {link['standing']}: {link['reason']}"
    if not named:
        return
    place = complete(claim, values)[0]
    fail = {label for label, relations in others.items() if not true_at(relations, place)}
    if link["standing"] == "false" and fail or not set(link["unmet"]) <= fail:
        yield f"says that {link['unmet']} fail there, and it is {sorted(fail)}: {link['reason']}"


def complaints(claim, statement, failing, some):
    """Why a verdict is wrong: `failing` is a point at which the claim fails, `some` says that its premises can hold."""
    verdict = statement["verdict"]
    (link,) = statement["links"]
    if verdict == "proved" and failing:
        yield f"is proved, and fails at {shown(failing)}"
    if verdict == "vacuous" and some:
        yield "is vacuous, and what is cited can hold"
    if verdict in ("refuted", "ill-defined"):
        if claim.right:
            yield f"is {verdict}, and right"
        yield from witness_faults(claim, link)
    if verdict not in ("proved", "vacuous", "refuted", "ill-defined", "undecided"):
        yield f"is {verdict}"
    if link["would_do"]:
        more = claim.uncited()[link["would_do"]]
        found, _ = claim.search(random.Random(0), more)
        if found:
            yield f"would follow with {link['would_do']} too, it says, and fails at {shown(found)}"
    model = witness.model(statement)
    if model and model[1]:
        place = complete(claim, model[1])[0]
        if not true_at(claim.conditions(), place):
            yield f"has a model that is none: {shown(place)}"
        if verdict == "proved" and claim.fails(holds(claim.relation, place)):
            yield f"is proved, and fails at its model {shown(place)}"


def shown(place):
    return ", ".join(f"{n} = {v:.12g}" for n, v in sorted(place.items()))


def judged(trial, source, claim, statement, rng):
    """Counts a claim, and notes what is wrong with its verdict."""
    failing, some = claim.search(rng)
    kind = "wrong" if failing else "right" if claim.right else "open to the points"
    if claim.right and failing:
        trial.note(source, f"{claim.label}: THE ORACLE calls it right, and it fails at {shown(failing)}")
    verdict = statement["verdict"]
    hinted = "with hints" if claim.hints else "without hints"
    shape = "contradictions" if isinstance(claim, Contradiction) else "claims"
    for name in ("all", hinted, shape, f"of {claim.setting.known.family}", f"changed: {claim.change}"):
        trial.count_one(f"{name}, {kind}, {verdict}")
    (link,) = statement["links"]
    if link["standing"] == "does not follow" and not link["unmet"]:
        trial.count_one("witnesses that name no given that fails there")
    if verdict == "undecided" and kind != "open to the points" and "--show-open" in sys.argv:
        where = f", at {shown(failing)}" if failing else ""
        print(f"open ({kind}{where}): {statement['source']}   # {'; '.join(claim.setting.lines())}", file=sys.stderr, flush=True)
    try:
        for why in complaints(claim, statement, failing, some):
            trial.note(source, f"{claim.label} {why}")
    except (Costly, Ambiguous, Unclear, Unreadable) as why:
        trial.count_one(f"witnesses that are not evaluated: {type(why).__name__}")


def selftest():
    """Wrong verdicts on a right and on a wrong claim are seen, and right ones pass."""
    source = random.Random(1)
    setting = Setting(source, Known("known", Reader("sqrt(a) + sqrt(b) <= sqrt(2*(a + b))").relation()))
    right, wrong = Claim(source, setting, "r", True), Claim(source, setting, "w", False)
    right.relation, right.right = setting.relation, True
    wrong.relation = Reader("sqrt(a) + sqrt(b) <= sqrt(199/100*(a + b))").relation()

    def said(verdict, at="", standing="false"):
        reason = f"false under all that was assumed, at {at}: left side 2, right side about 1.9950"
        steps = [{"depth": 0, "text": f"At the point {at}:"}] if at else []
        link = {"verdict": verdict, "reason": reason, "steps": steps, "standing": standing, "unmet": [], "would_do": None}
        return {"verdict": verdict, "links": [link], "model": None}

    def seen(claim, statement):
        return list(complaints(claim, statement, *claim.search(random.Random(2))))

    assert right.search(random.Random(3))[0] is None and wrong.search(random.Random(3))[0]
    assert not seen(right, said("proved")) and not seen(wrong, said("refuted", "a = 1, b = 1"))
    assert seen(wrong, said("proved")), "a wrong claim is proved"
    assert seen(right, said("refuted", "a = 1, b = 1")), "a right claim is refuted"
    assert seen(wrong, said("refuted", "a = 1, b = 4")), "it does not fail there"
    assert seen(wrong, said("refuted", "a = 1, b = -1")), "it is not defined there"
    assert seen(wrong, said("ill-defined", "a = 1, b = 1")), "it is defined there"
    assert seen(wrong, said("vacuous")), "the premises hold somewhere"
    beside = said("refuted", "a = 1, b = 4")["links"][0]
    for last, is_so in [("g, b > a: 4 > 1", True), ("g, w > b: 5 > 4", True), ("g, w > b: 4 > 4", False), ("g, w < b: 5 < 4 is false", False)]:
        head = "All else that is assumed above holds there too, with w = 5:"
        steps = [*beside["steps"], *({"depth": 1, "text": text} for text in (head, last))]
        place = Place({"a": Fraction(1), "b": Fraction(4)})
        assert bool(told.mistakes({"steps": steps}, place)[0]) is not is_so, last


def main():
    trial = Trial("touching")
    rng, points = random.Random(trial.seed), random.Random(f"{trial.seed}/points")
    times, began = [], time.monotonic()
    with digits():
        selftest()
        for source, claims, statements in trial.documents(document, rng, BUDGET):
            times = sorted([*times, (trial.seconds, source)], reverse=True)[:5]
            of_label = {s["label"]: s for s in statements}
            for claim in claims:
                trial.judged += 1
                judged(trial, source, claim, of_label[claim.label], points)
            if trial.audited % 100 == 0:
                print(f"{trial.judged} claims, {len(trial.wrong)} wrong", file=sys.stderr, flush=True)
    longest = max((seconds for seconds, _ in times), default=0)
    print(f"{time.monotonic() - began:.0f} s, the longest of {trial.audited} documents: {longest:.1f} s of processor time", file=sys.stderr)
    if "--show-open" in sys.argv:
        for seconds, source in times:
            print(f"{seconds:.1f} s:\n{source}", file=sys.stderr)
    return trial.told()


if __name__ == "__main__":
    sys.exit(main())
