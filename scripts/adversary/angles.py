"""Random claims on sines, cosines and tangents, judged in floats at many angles.

A claim with a point at which it fails by more than rounding is false; an equation that holds at all of them to 1e-9 is
true, and so is an inequality with room to spare at all of them. Nothing is said about what lies between. A tangent
whose cosine changes its sign within the ranges is undefined somewhere, so that a claim with it must not be proved.

    python3 scripts/adversary/angles.py KANE [COUNT [SEED]] [--certificates]
"""

import math
import random
import sys
from fractions import Fraction

sys.dont_write_bytecode = True

from trial import Trial  # noqa: E402

CLAIMS = 8
ANGLES = ("theta", "phi")


def turns(rng):
    """An end of a range in half turns."""
    return Fraction(rng.randint(-12, 12), rng.choice([12, 6, 4, 3, 2]))


def ranges(rng):
    """For each angle its declaration and its ends in half turns."""
    out = {}
    for angle in ANGLES:
        kind = rng.random()
        if kind < 0.4:
            out[angle] = (angle, Fraction(-1), Fraction(1))
            continue
        low = rng.choice([Fraction(0), turns(rng)])
        high = low + Fraction(rng.choice([1, 2, 3, 4, 6, 8, 12]), 12)
        relation = rng.choice(["<", "<="])
        out[angle] = (f"{half_turns(low)} {relation} {angle} {rng.choice(['<', '<='])} {half_turns(high)}", low, high)
    return out


def half_turns(q):
    if q == 0:
        return "0"
    sign, q = ("-" if q < 0 else ""), abs(q)
    return f"{sign}{'' if q.numerator == 1 else f'{q.numerator}*'}pi{'' if q.denominator == 1 else f'/{q.denominator}'}"


class Node:
    """An expression: how it is written, its value at angles, and the cosines of its tangents."""

    def __init__(self, text, value, cosines=()):
        self.text, self.value, self.cosines = text, value, tuple(cosines)


def trig(rng, parts, tangents=True):
    names = rng.sample(ANGLES, rng.choice([1, 1, 2]))
    factors = {a: Fraction(rng.choice([1, 1, 2, 3, -1]), rng.choice(parts)) for a in names}
    shift = rng.choice([Fraction(0)] * 4 + [Fraction(1, 2), Fraction(1), Fraction(1, 3), Fraction(-1, 4), Fraction(1, 6)])
    terms = [("" if q > 0 else "-") + ("" if abs(q) == 1 else f"{abs(q)}*") + a for a, q in factors.items()]
    if shift:
        terms.append(half_turns(shift))
    text = " + ".join(terms).replace("+ -", "- ")

    def argument(at):
        return sum(float(q) * at[a] for a, q in factors.items()) + math.pi * float(shift)

    kind = rng.choice(["sin", "cos", "sin", "cos", "tan"] if tangents else ["sin", "cos"])
    function = {"sin": math.sin, "cos": math.cos, "tan": math.tan}[kind]
    cosines = [lambda at: math.cos(argument(at))] if kind == "tan" else []
    return Node(f"{kind}({text})", lambda at: function(argument(at)), cosines)


def expression(rng, parts, tangents=True, depth=2):
    if depth == 0 or rng.random() < 0.35:
        if rng.random() < 0.25:
            q = Fraction(rng.choice([1, 2, 3, -1, -2]), rng.choice([1, 1, 2, 3]))
            return Node(f"({q})", lambda at: float(q))
        return trig(rng, parts, tangents)
    a, b = (expression(rng, parts, tangents, depth - 1) for _ in range(2))
    sign = rng.choice("++-**")
    value = {"+": lambda at: a.value(at) + b.value(at), "-": lambda at: a.value(at) - b.value(at),
             "*": lambda at: a.value(at) * b.value(at)}[sign]
    return Node(f"({a.text} {sign} {b.text})", value, a.cosines + b.cosines)


def slope(node, angle):
    """The derivative, by differences of high order: good to 1e-9 for expressions of this size."""
    h = 1e-2

    def value(at):
        def f(k):
            return node.value({**at, angle: at[angle] + k * h})
        coefficients = [(1, 4 / 5), (2, -1 / 5), (3, 4 / 105), (4, -1 / 280)]
        return sum(c * (f(k) - f(-k)) for k, c in coefficients) / h

    return value


IDENTITIES = (
    ("sin({a})^2 + cos({a})^2", "1"),
    ("sin({a} + {b})", "sin({a})*cos({b}) + cos({a})*sin({b})"),
    ("cos({a} - {b})", "cos({a})*cos({b}) + sin({a})*sin({b})"),
    ("2*sin({a})*sin({b})", "cos({a} - {b}) - cos({a} + {b})"),
    ("sin(3*{a})", "3*sin({a}) - 4*sin({a})^3"),
    ("1 - cos({a})", "2*sin({a}/2)^2"),
    ("sin({a} + pi/3)", "sin({a})/2 + sqrt(3)/2*cos({a})"),
    ("cos({a} + pi)", "-cos({a})"),
    ("tan({a})*cos({a})", "sin({a})"),
    ("1 + tan({a})^2", "1/cos({a})^2"),
    ("sin({a} + pi/2)", "cos({a})"),
)
WORLD = {"sin": math.sin, "cos": math.cos, "tan": math.tan, "sqrt": math.sqrt, "pi": math.pi}


def known(rng):
    """An identity of the books, at times with a slip, as two nodes; its poles are those of its tangents."""
    left, right = rng.choice(IDENTITIES)
    a, b = rng.sample(ANGLES, 2)
    cosines = [lambda at: math.cos(at[a])] if "tan" in left else []
    left, right = left.format(a=a, b=b), right.format(a=a, b=b)
    if rng.random() < 0.4:
        right = rng.choice([lambda r: r.replace("sin", "cos", 1), lambda r: f"-({r})", lambda r: f"{r} + 1/7"])(right)

    def value(text):
        code = compile(text.replace("^", "**"), "identity", "eval")
        return lambda at: eval(code, {**WORLD, **at})  # noqa: S307  its text is ours

    return Node(left, value(left), cosines), Node(right, value(right))


def samples(rng, domain):
    """Angles inside the ranges, and some at multiples of a twelfth of a half turn."""
    out = []
    for n in range(1500):
        at = {}
        for angle, (_, low, high) in domain.items():
            if n % 3 == 0:
                k = rng.randint(math.ceil(low * 24) + 1, math.floor(high * 24) - 1)
                at[angle] = math.pi * k / 24
            else:
                at[angle] = math.pi * (float(low) + (0.001 + 0.998 * rng.random()) * float(high - low))
        out.append(at)
    return out


def truth(left, relation, right, points):
    """True, False, or None where floats at these points do not tell."""
    gaps = []
    for cosine in left.cosines + right.cosines:
        values = [cosine(at) for at in points]
        if min(values) < -1e-6 and max(values) > 1e-6:
            return False
        # an end of a range may be a pole and belong to it
        if min(abs(v) for v in values) < 0.1:
            return None
    for at in points:
        gaps.append(left.value(at) - right.value(at))
    low, high = min(gaps), max(gaps)
    most = max(abs(low), abs(high))
    if relation == "=":
        return True if most < 1e-9 else False if most > 1e-6 else None
    if relation == "!=":
        return False if low < -1e-6 and high > 1e-6 or most < 1e-9 else True if low > 0.05 or high < -0.05 else None
    if relation in (">=", ">"):
        return False if low < -1e-7 else True if low > 0.05 else None
    return False if high > 1e-7 else True if high < -0.05 else None


def document(rng):
    domain = ranges(rng)
    points = samples(rng, domain)
    parts = rng.choice([[1], [1], [1, 2], [1, 3]])
    lines = ["var " + ", ".join(declaration for declaration, *_ in domain.values())]
    truths = {}
    for n in range(CLAIMS):
        kind = rng.random()
        if kind < 0.45:
            left, right = known(rng)
            relation = rng.choice(["=", "=", "=", "<=", "!="])
        elif kind < 0.6:
            inner = expression(rng, parts, tangents=False)
            angle = rng.choice(ANGLES)
            left = Node(f"d({inner.text}, {angle})", slope(inner, angle))
            right = Node("(" + inner.text + ")", inner.value) if rng.random() < 0.3 else expression(rng, parts, False, 1)
            if not any(f in inner.text for f in ("sin", "cos")) or angle not in inner.text:
                continue
            relation = rng.choice(["=", "<=", "!="])
        else:
            left = expression(rng, parts)
            q = Fraction(rng.randint(-8, 8), rng.choice([1, 2, 3]))
            right = Node(f"({q})", lambda at, q=q: float(q))
            relation = rng.choice(["<=", ">=", "<", ">", "!="])
        lines.append(f"claim c{n}: {left.text} {relation} {right.text}")
        truths[f"c{n}"] = truth(left, relation, right, points)
    return "# Angles\n\n```kane\n" + "\n".join(lines) + "\n```\n", truths


def main():
    trial = Trial("angles")
    rng = random.Random(trial.seed)
    unread = 0
    while trial.judged < trial.count:
        source, truths = document(rng)
        statements, messages = trial.statements(source, 2_000_000)
        if statements is None:
            # a range that does not fit the finest part, or parts finer than the language has
            unread += 1
            if "error" not in messages or unread > 50 + trial.judged:
                trial.wrong.append((source, messages))
                break
            continue
        for statement in statements:
            label = statement["label"]
            if label not in truths:
                continue
            trial.judged += 1
            verdict, true = statement["verdict"], truths[label]
            trial.count_one(f"{true} {verdict}")
            says_false = verdict in ("refuted", "ill-defined")
            if (true is True and says_false) or (true is False and verdict == "proved") or verdict == "vacuous":
                trial.wrong.append((source, f"{label} is {verdict}, and it is {true}"))
    return trial.told(f", {unread} documents not read")


if __name__ == "__main__":
    sys.exit(main())
