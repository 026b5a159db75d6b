"""Random claims on derivatives of functions, judged against jets.

y and w are polynomials of free functions x and z, and in some documents of cos and sin of a free angle. All jets
(values of functions and derivatives at one point) of the free functions occur, so a polynomial claim is true
exactly if it becomes 0 = 0 when the jets of those functions whose laws are cited are written in those of the others.
That takes polynomial arithmetic alone, and none of the program's. Claims cite the laws, differentiated often enough
or too seldom.

    python3 scripts/adversary/motion.py KANE [COUNT [SEED]] [--certificates]
"""

import random
import sys
from fractions import Fraction

sys.dont_write_bytecode = True

from trial import Trial  # noqa: E402

FREE = ("x", "z")
CLAIMS = 8


def add(p, q, factor=1):
    total = dict(p)
    for monomial, c in q.items():
        total[monomial] = total.get(monomial, 0) + factor * c
    return {m: c for m, c in total.items() if c}


def times(p, q):
    total = {}
    for a, c in p.items():
        for b, d in q.items():
            m = dict(a)
            for v, n in b:
                m[v] = m.get(v, 0) + n
            key = tuple(sorted(m.items()))
            total[key] = total.get(key, 0) + c * d
    return {m: c for m, c in total.items() if c}


def var(v):
    return {((v, 1),): Fraction(1)}


def circle(p):
    """sin^2 is 1 - cos^2."""
    total, again = {}, False
    for m, c in p.items():
        powers = dict(m)
        if powers.get("S", 0) > 1:
            again = True
            powers["S"] -= 2
            rest = {tuple(sorted((v, n) for v, n in powers.items() if n)): c}
            total = add(total, add(rest, times(rest, {(("C", 2),): 1}), -1))
        else:
            total = add(total, {m: c})
    return circle(total) if again else total


def slope(p):
    """The total derivative; x becomes x1, x1 becomes x2."""
    total = {}
    for m, c in p.items():
        for i, (v, n) in enumerate(m):
            rest = [*m[:i], *m[i + 1:], *([(v, n - 1)] if n > 1 else [])]
            if v == "C":
                inner = times(var("S"), {(("q1", 1),): Fraction(-1)})
            elif v == "S":
                inner = times(var("C"), var("q1"))
            else:
                base, order = (v[0], int(v[1:] or 0))
                inner = var(f"{base}{order + 1}")
            total = add(total, times({tuple(sorted(rest)): c * n}, inner))
    return total


def name(v):
    if v in "CS":
        return {"C": "cos(q)", "S": "sin(q)"}[v]
    base, order = v[0], int(v[1:] or 0)
    text = base
    for _ in range(order):
        text = f"d({text}, t)"
    return text


def text(p):
    terms = []
    for m, c in p.items():
        factors = [str(c) if c.denominator == 1 else f"({c})"] + [f"{name(v)}^{n}" if n > 1 else name(v) for v, n in m]
        terms.append("*".join(factors).replace("--", ""))
    return " + ".join(f"({term})" for term in terms) or "0"


def polynomial(rng, names, size=3, degree=2):
    p = {}
    for _ in range(rng.randint(1, size)):
        m = {}
        for _ in range(rng.randint(0, degree)):
            v = rng.choice(names)
            m[v] = m.get(v, 0) + 1
        p = add(p, {tuple(sorted(m.items())): Fraction(rng.choice([-2, -1, 1, 2, 3]), rng.choice([1, 1, 2]))})
    return p


def document(rng):
    """A document, and for each claim whether it is true."""
    names = [*FREE, *(["C", "S"] if rng.random() < 0.4 else [])]
    laws = {"y": polynomial(rng, names), "w": polynomial(rng, [*names, "y"])}
    lines = ["var t, x(t), z(t), q(t), y(t), w(t)"]
    lines += [f"given {v}-law: {v} = {text(p)}" for v, p in laws.items()]

    def written(p, cited):
        """In jets of functions of which no law is cited."""
        jets = {}
        for v in sorted(cited, reverse=True):  # y before w
            jet = substitute(laws[v], jets)
            jets.update({v: jet, f"{v}1": slope(jet), f"{v}2": slope(slope(jet))})
        return circle(substitute(p, jets))

    truths = {}
    for n in range(CLAIMS):
        order = rng.choice([0, 1, 1, 2])
        v = rng.choice(["y", "w"])
        side = laws[v]
        for _ in range(order):
            side = slope(side)
        left = var(f"{v}{order or ''}")
        kind = rng.random()
        if kind < 0.4:
            right = side if rng.random() < 0.5 else written(side, "wy")
        elif kind < 0.8:
            right = add(side, polynomial(rng, [*FREE, "x1", "z1"], 1))
        else:
            left = polynomial(rng, ["x", "x1", "z1", "y1", "y", "w1"])
            right = polynomial(rng, ["x", "x1", "z1", "y1", "y"])
        cited = []
        for law in ("y-law", "w-law"):
            times_cited = rng.choice([0, 1, 2, 2, 3])
            for depth in range(times_cited):
                label = law
                for _ in range(depth):
                    label = f"d({label}, t)"
                cited.append(label)
        as_derivative = rng.random() < 0.3 and order == 1 and kind < 0.8
        shown = f"d({v}*1, t)" if as_derivative else text(left)
        relation = rng.choice(["=", "=", "=", "!=", ">="])
        gap = written(add(left, right, -1), {law[0] for law in ("y-law", "w-law") if law in cited})
        support = f" from {', '.join(cited)}" if cited else ""
        lines.append(f"claim c{n}: {shown} {relation} {text(right)}{support}")
        if relation == "=":
            truths[f"c{n}"] = not gap
        elif relation == ">=" and not gap:
            truths[f"c{n}"] = True
        elif relation == "!=" and not gap:
            truths[f"c{n}"] = False
    return "# Motion\n\n```kane\n" + "\n".join(lines) + "\n```\n", truths


def substitute(p, jets):
    total = {}
    for m, c in p.items():
        product = {(): c}
        for v, n in m:
            for _ in range(n):
                product = times(product, jets.get(v, var(v)))
        total = add(total, product)
    return total


def main():
    trial = Trial("motion")
    rng = random.Random(trial.seed)
    for source, truths, statements in trial.documents(document, rng, 2_000_000):
        for statement in statements:
            label = statement["label"]
            if not label.startswith("c") or label not in truths:
                continue
            trial.judged += 1
            verdict, truth = statement["verdict"], truths[label]
            trial.count_one(f"{'true' if truth else 'false'} {verdict}")
            if (truth and verdict in ("refuted", "ill-defined")) or (not truth and verdict == "proved") or verdict == "vacuous":
                trial.wrong.append((source, f"{label} is {verdict}, and it is {truth}"))
    return trial.told()


if __name__ == "__main__":
    sys.exit(main())
