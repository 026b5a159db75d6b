#!/usr/bin/env python3
"""Random claims on what exponentials, logarithms, sines and cosines do as their arguments vary: derivatives, limits, bounds.

Functions are evaluated in decimals of 400 digits, with their derivatives beside them (dual numbers); nothing is written out in
symbols. A verdict is wrong if numbers speak against it:

- `proved`, and at some point at which the conditions hold the sides differ, or near a limit the expression is away from it;
- `refuted` or `ill-defined`, and the claim holds at all points that are tried, 0 among them (a witness has 0 in each of these).

    python3 scripts/adversary/growing.py KANE [COUNT [SEED]] [--certificates]
"""

import ast
import json
import random
import sys
from decimal import Decimal, getcontext
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from circular import circular  # noqa: E402
from trial import Trial  # noqa: E402

getcontext().prec = 400
getcontext().Emax, getcontext().Emin = 10**12, -(10**12)
NEAR = Decimal(10) ** -300
CLAIMS = 8


def dec(q):
    q = Fraction(q)
    return Decimal(q.numerator) / Decimal(q.denominator)


class Dual:
    """A value and its derivative by one variable."""

    def __init__(self, value, slope=Decimal(0)):
        self.value, self.slope = Decimal(value), Decimal(slope)

    def __add__(self, other):
        return Dual(self.value + other.value, self.slope + other.slope)

    def __sub__(self, other):
        return Dual(self.value - other.value, self.slope - other.slope)

    def __mul__(self, other):
        return Dual(self.value * other.value, self.slope * other.value + self.value * other.slope)

    def __truediv__(self, other):
        quotient = self.value / other.value
        return Dual(quotient, (self.slope - quotient * other.slope) / other.value)

    def exp(self):
        return Dual(self.value.exp(), self.value.exp() * self.slope)

    def log(self):
        return Dual(self.value.ln(), self.slope / self.value)

    def sin(self):
        sin, cos = circular(self.value)
        return Dual(sin, cos * self.slope)

    def cos(self):
        sin, cos = circular(self.value)
        return Dual(cos, -sin * self.slope)


class Node:
    """How an expression is written, and what it is at a point of duals."""

    def __init__(self, text, at):
        self.text, self.at = text, at

    def __add__(self, other):
        return Node(f"{self.text} + {other.text}", lambda p: self.at(p) + other.at(p))

    def __sub__(self, other):
        return Node(f"{self.text} - ({other.text})", lambda p: self.at(p) - other.at(p))

    def __mul__(self, other):
        return Node(f"({self.text})*({other.text})", lambda p: self.at(p) * other.at(p))


def number(q):
    return Node(f"({q})", lambda p: Dual(dec(q)))


def name(symbol):
    return Node(symbol, lambda p: p[symbol])


def exponent(rng):
    """A sum of products in x, k, m and the angle's neighbour."""
    pieces = rng.sample(["x", "k*x", "k*x/m", "x^2", "k", "x/m^2", "-x"], rng.choice([1, 1, 2]))
    factors = [Fraction(rng.choice(["1", "1", "-1", "2", "1/2", "-3/2"])) for _ in pieces]
    values = {
        "x": lambda p: p["x"], "k*x": lambda p: p["k"] * p["x"], "k*x/m": lambda p: p["k"] * p["x"] / p["m"],
        "x^2": lambda p: p["x"] * p["x"], "k": lambda p: p["k"], "x/m^2": lambda p: p["x"] / (p["m"] * p["m"]),
        "-x": lambda p: Dual(0) - p["x"],
    }

    def at(p):
        total = Dual(0)
        for q, piece in zip(factors, pieces):
            total = total + Dual(dec(q)) * values[piece](p)
        return total.exp()

    return Node("exp(" + " + ".join(f"({q})*({piece})" for q, piece in zip(factors, pieces)) + ")", at)


def atom(rng):
    pick = rng.random()
    if pick < 0.35:
        return exponent(rng)
    if pick < 0.5:
        return Node("log(y)", lambda p: p["y"].log())
    if pick < 0.65:
        part = rng.choice(["theta", "2*theta", "theta/2"])
        factor = Dual({"theta": 1, "2*theta": 2, "theta/2": dec("1/2")}[part])
        f = rng.choice(["sin", "cos"])
        return Node(f"{f}({part})", lambda p: getattr(factor * p["theta"], f)())
    return name(rng.choice(["x", "y", "k", "theta"])) if pick < 0.9 else number(rng.choice(["1", "2", "-1", "1/2"]))


def side(rng):
    a = atom(rng)
    return rng.choice([a, a + atom(rng), a * atom(rng), a - atom(rng), a * atom(rng) + atom(rng)])


SLOPES = [
    # f, the variable, the derivative
    ("exp(2*x)", "x", "2*exp(2*x)"), ("x*exp(-k*x)", "x", "(1 - k*x)*exp(-k*x)"),
    ("exp(-k*x/m)", "x", "-k/m*exp(-k*x/m)"), ("exp(-k*x/m)", "k", "-x/m*exp(-k*x/m)"),
    ("exp(-k*x/m)", "m", "k*x/m^2*exp(-k*x/m)"), ("exp(x^2)", "x", "2*x*exp(x^2)"),
    ("log(y)*y", "y", "log(y) + 1"), ("exp(x)*log(y)", "y", "exp(x)/y"), ("log(y)/y", "y", "(1 - log(y))/y^2"),
    ("theta*cos(theta)", "theta", "cos(theta) - theta*sin(theta)"), ("sin(theta/2)^2", "theta", "sin(theta)/2"),
    ("exp(x)*sin(theta)", "theta", "exp(x)*cos(theta)"), ("sin(2*theta)", "theta", "2*cos(2*theta)"),
    ("exp(x)/x", "x", "exp(x)*(x - 1)/x^2"), ("exp(k*x)*exp(-k*x)", "x", "0"), ("d(exp(k*x), x)", "x", "k^2*exp(k*x)"),
    ("exp(-x)*x^2", "x", "(2*x - x^2)*exp(-x)"), ("sqrt(exp(2*x))", "x", "exp(x)"), ("log(exp(k*x))", "x", "k"),
]

LIMITS = [
    # the form, the point, the value that it has, and how it is computed
    ("exp(-t)", "oo", "0", lambda t: (-t).exp()), ("exp(t)", "oo", "oo", lambda t: t.exp()),
    ("t*exp(-t/2)^2", "oo", "0", lambda t: t * (-t).exp()), ("(exp(t) - 1)/t", "0", "1", lambda t: (t.exp() - 1) / t),
    ("(1 - exp(-2*t))/t", "0", "2", lambda t: (1 - (-2 * t).exp()) / t), ("exp(1/2*t)", "-oo", "0", lambda t: (t / 2).exp()),
    ("t/exp(t)", "-oo", "-oo", lambda t: t * (-t).exp()), ("exp(t)/(1 + exp(t))", "oo", "1", lambda t: 1 / (1 + (-t).exp())),
    ("(exp(t) - exp(-t))/t", "0", "2", lambda t: (t.exp() - (-t).exp()) / t), ("exp(t)*t", "0", "0", lambda t: t * t.exp()),
    ("sin(u)/u", "0", "1", lambda u: circular(u)[0] / u), ("(1 - cos(u))/u^2", "0", "1/2", lambda u: (1 - circular(u)[1]) / u**2),
    ("sin(u)/u", "oo", "0", lambda u: circular(u)[0] / u), ("u*cos(u)", "0", "0", lambda u: u * circular(u)[1]),
    ("sin(u)/(u + u^2)", "0", "1", lambda u: circular(u)[0] / (u + u * u)), ("tan(u)/u", "0", "1", lambda u: circular(u)[0] / circular(u)[1] / u),
    ("u*sin(u)", "0", "0", lambda u: u * circular(u)[0]), ("cos(u) + sin(u)", "0", "1", lambda u: sum(circular(u))),
]
NEARBY = {"0": ["1e-20", "-1e-20", "1e-12"], "oo": ["3000", "40000"], "-oo": ["-3000", "-40000"]}


def value_of(text, p):
    """An expression of the tables, in duals."""

    def of(e):
        if isinstance(e, ast.BinOp):
            a = of(e.left)
            if isinstance(e.op, ast.Pow):
                total = Dual(1)
                for _ in range(e.right.value):
                    total = total * a
                return total
            b = of(e.right)
            return {ast.Add: a.__add__, ast.Sub: a.__sub__, ast.Mult: a.__mul__, ast.Div: a.__truediv__}[type(e.op)](b)
        if isinstance(e, ast.UnaryOp):
            return Dual(0) - of(e.operand)
        if isinstance(e, ast.Constant):
            return Dual(e.value)
        if isinstance(e, ast.Name):
            return p[e.id]
        inside = of(e.args[0])
        if e.func.id == "sqrt":
            root = inside.value.sqrt()
            return Dual(root, inside.slope / (2 * root))
        return getattr(inside, e.func.id)()

    return of(ast.parse(text.replace("^", "**"), mode="eval").body)


class Slope:
    """d(f, v) = g, perhaps with a slip."""

    def __init__(self, rng):
        f, self.by, g = rng.choice(SLOPES)
        slip = rng.choice(["", "", "", " + 1", " - x", "*2", " + exp(x)", " - log(y)"])
        g = f"({g}){slip}" if slip else g
        self.sides, self.text = (f, g), f"d({f}, {self.by}) = {g}"

    def holds(self, point):
        p = {v: Dual(value, 1 if v == self.by else 0) for v, value in point.items()}
        f, g = self.sides
        try:
            if f.startswith("d("):
                # by the quotient of two slopes
                inside, step = f[2:].split(", ")[0], Decimal(10) ** -30
                more = {**p, "x": Dual(p["x"].value + step, 1)}
                slope = (value_of(inside, more).slope - value_of(inside, p).slope) / step
                return abs(slope - value_of(g, p).value) < Decimal(10) ** -20 * (1 + abs(slope))
            a, b = value_of(f, p).slope, value_of(g, p).value
        except ArithmeticError:
            return None
        return abs(a - b) <= NEAR * (1 + abs(a))


class Comparison:
    """Two sides, as they are at points."""

    def __init__(self, rng):
        self.sides = side(rng), side(rng)
        self.relation = rng.choice(["=", "<", "<=", ">", ">=", "!="])
        self.text = f"{self.sides[0].text} {self.relation} {self.sides[1].text}"

    def holds(self, point):
        a, b = (s.at({v: Dual(value) for v, value in point.items()}).value for s in self.sides)
        d = a - b
        if abs(d) <= NEAR * (1 + abs(a) + abs(b)):
            d = Decimal(0)
        return {"=": d == 0, "!=": d != 0, "<": d < 0, "<=": d <= 0, ">": d > 0, ">=": d >= 0}[self.relation]


class Limit:
    """A form, its point, and a value that may be another one's."""

    def __init__(self, rng):
        form, at, value, self.compute = rng.choice(LIMITS)
        self.to = value if rng.random() < 0.6 else rng.choice(["0", "1", "2", "1/2", "oo", "-oo"])
        self.at = at
        self.text = f"{form} -> {self.to} as {'u' if 'u' in form else 't'} -> {at}"

    def holds(self, point):
        found = [self.compute(Decimal(t)) for t in NEARBY[self.at]]
        if self.to in ("oo", "-oo"):
            sign = 1 if self.to == "oo" else -1
            return all(sign * value > 100 for value in found)
        return all(abs(value - dec(self.to)) < Decimal("1e-3") for value in found)


def points(rng):
    simple = [Decimal(0), Decimal(0), dec("1/2"), Decimal(1), dec("-1/3"), Decimal(-2), dec("7/5"), Decimal(4)]
    positive = [Decimal(1), Decimal(1), Decimal(2), dec("1/2"), dec("1/3"), Decimal(3).exp(), Decimal(9)]
    yield {"x": Decimal(0), "k": Decimal(1), "m": Decimal(1), "y": Decimal(1), "theta": Decimal(0)}
    for _ in range(60):
        at = {v: rng.choice(simple) for v in ("x", "theta")}
        yield at | {v: rng.choice(positive) for v in ("k", "m", "y")}


def point_of(values):
    """The witness of a certificate, where what is not spoken of is 1; none if it is not told in decimals here."""
    at = {v: Decimal(1) for v in ("x", "k", "m", "y", "theta")}
    if any(len(coefficients) > 1 for coefficients in values.values()):
        return None
    known = {v: dec(c[0]) if c else Decimal(0) for v, c in values.items()}
    at |= {v: value for v, value in known.items() if v in at}
    for name, value in known.items():
        if name in at:
            continue
        if name == "log(y)":
            if "y" not in known:
                at["y"] = value.exp()
        elif name in ("exp(k)", "exp(x)", "exp(k/2)", "exp(x/2)"):
            if name[4] not in known:
                at[name[4]] = value.ln() * (2 if "/" in name else 1)
        elif name.startswith("exp("):
            if not set(name[4:-1]) & set(known):
                return None
        elif "theta" not in known and (name[:3], value) not in (("cos", 1), ("sin", 0)):
            return None
        elif "theta" not in known:
            at["theta"] = Decimal(0)
    return at


def document(rng):
    kinds = [Slope, Slope, Comparison, Comparison, Limit]
    claims = {f"c{n}": rng.choice(kinds)(rng) for n in range(CLAIMS)}
    lines = ["var x, k > 0, m > 0, y > 0, theta, t, u"]
    lines += [f"claim {label}: {claim.text}" for label, claim in claims.items()]
    return "# Growing\n\n```kane\n" + "\n".join(lines) + "\n```\n", claims


def main():
    trial = Trial("growing")
    rng = random.Random(trial.seed)
    for source, claims, statements in trial.documents(document, rng, 4_000_000):
        places = list(points(rng))
        certificate = json.loads(Path(trial.folder.name, "out", "d.cert.json").read_text())
        evidence = {c["label"]: c["links"][0].get("evidence", {}) for c in certificate["claims"]}
        values = {label: point_of(e.get("point", {}).get("values", {})) for label, e in evidence.items()}
        for statement in statements:
            claim = claims.get(statement["label"])
            if not claim:
                continue
            trial.judged += 1
            witness = values.get(statement["label"])
            there = [witness] if witness and statement["verdict"] == "refuted" else []
            found = [holds for holds in map(claim.holds, [*places, *there]) if holds is not None]
            false, kind, verdict = not all(found), type(claim).__name__, statement["verdict"]
            trial.count_one(f"{'false' if false else 'true'} {kind}, {verdict}")
            seen = witness is not None or verdict == "vacuous"
            wrong = (verdict == "proved" and false) or (verdict in ("refuted", "vacuous") and seen and not false)
            if wrong or (verdict == "ill-defined" and len(found) == len(places)):
                trial.wrong.append((source, f"{statement['label']}: {verdict}"))
    return trial.told()


if __name__ == "__main__":
    sys.exit(main())
