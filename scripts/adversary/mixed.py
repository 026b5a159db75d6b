#!/usr/bin/env python3
"""Random documents in which exponentials, angles, sums, bounds, definitions, logic, derivatives and limits stand together.

All is evaluated in decimals of 110 digits at points of the declared domain, derivatives by differences; nothing is written
out by rules of the language. Givens are assumptions that hold at some of the points, claims cite them and each other.

- `proved`, and at some point at which all that is cited holds the claim is false or undefined, or a limit is another one;
- `vacuous`, and there is such a point at all; `refuted` or `ill-defined`, and at the point of the certificate, its exponentials and
  sines continued to values of what is in them, something that is cited fails or the claim holds (is defined);
- a line of the text that says another verdict than the report for programs.

What differs by less than the digits carry judges nothing.

    python3 scripts/adversary/mixed.py KANE [COUNT [SEED]] [--certificates] [--keep DIR] [--show N]
"""

import json
import math
import random
import re
import subprocess
import sys
from decimal import Decimal, getcontext
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from circular import circular  # noqa: E402
from mixed_claims import BOOK, CLAIMS, DECLARED, FAR, LIMITS, SLOPES  # noqa: E402
from trial import Trial  # noqa: E402

getcontext().prec = 110
STEP, NEAR, NEAR_SLOPE = Decimal(10) ** -30, Decimal(10) ** -90, Decimal(10) ** -40
BUDGET = 400_000
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534211706798214808651")


class Undefined(Exception):
    """An expression has no value."""


def dec(q):
    q = Fraction(q)
    return Decimal(q.numerator) / Decimal(q.denominator)


def divided(a, b):
    if b == 0:
        raise Undefined
    return a / b


def whole_power(a, n):
    if n < 0:
        return divided(Decimal(1), a ** -n)
    return a**n if n else Decimal(1)


def root(a):
    if a < 0:
        raise Undefined
    return a.sqrt()


def tangent(x):
    sin, cos = circular(x)
    return divided(sin, cos)


FUNCTIONS = {
    "exp": lambda x: x.exp(), "log": lambda x: x.ln(), "sin": lambda x: circular(x)[0], "cos": lambda x: circular(x)[1],
    "tan": tangent, "sqrt": root, "abs": abs, "min": min, "max": max,
}
TOKEN = re.compile(r"\s*(\d+(?:\.\d+)?(?!\.\d)|\.\.|[A-Za-z_]\w*'?|<=|>=|!=|:=|.)")


class Reader:
    """A reader of expressions and relations that makes functions of a point of them; it knows what the generator writes."""

    def __init__(self, text, lets):
        self.tokens = [t for t in TOKEN.findall(text) if t.strip()]
        self.at, self.lets = 0, lets

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def next(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def takes(self, *words):
        if self.peek() in words:
            return self.next()
        return ""

    def expect(self, word):
        found = self.next()
        assert found == word, (word, found, self.tokens)

    def listed(self):
        """Relations with commas between."""
        out = [self.iff()]
        while self.takes(","):
            out.append(self.iff())
        return lambda p: all(r(p) for r in out)

    def iff(self):
        a = self.implies()
        if self.takes("iff"):
            b = self.implies()
            return lambda p: a(p) == b(p)
        return a

    def implies(self):
        a = self.either()
        if self.takes("implies"):
            b = self.either()
            return lambda p: not a(p) or b(p)
        return a

    def either(self):
        parts = [self.both()]
        while self.takes("or"):
            parts.append(self.both())
        return parts[0] if len(parts) == 1 else lambda p: any(r(p) for r in parts)

    def both(self):
        parts = [self.relation()]
        while self.takes("and"):
            parts.append(self.relation())
        return parts[0] if len(parts) == 1 else lambda p: all(r(p) for r in parts)

    def relation(self):
        start = self.at
        if self.takes("("):
            try:
                inside = self.iff()
                self.expect(")")
                if self.peek() not in ("=", "!=", "<", "<=", ">", ">=", "+", "-", "*", "/", "^"):
                    return inside
            except (AssertionError, IndexError):
                pass
            self.at = start
        a, links = self.sum(), []
        while self.peek() in ("=", "!=", "<", "<=", ">", ">="):
            links.append((self.next(), self.sum()))
        assert links, self.tokens
        slopes = "d" in self.tokens

        def holds(p):
            left = a(p)
            for sign, side in links:
                right = side(p)
                if not compared(sign, left, right, slopes):
                    return False
                left = right
            return True

        return holds

    def sum(self):
        out = self.product()
        while sign := self.takes("+", "-"):
            out = joined(sign, out, self.product())
        return out

    def product(self):
        out = self.factor()
        while sign := self.takes("*", "/"):
            out = joined(sign, out, self.factor())
        return out

    def factor(self):
        if self.takes("-"):
            inside = self.factor()
            return lambda p: -inside(p)
        base = self.base()
        if not self.takes("^"):
            return base
        exponent = self.factor()
        return lambda p: whole_power(base(p), int(exponent(p)))

    def base(self):
        word = self.next()
        if word == "(":
            inside = self.sum()
            self.expect(")")
            return inside
        if word[0].isdigit():
            value = Decimal(word)
            return lambda p: value
        if self.peek() == "(":
            self.next()
            return self.call(word)
        if word == "cases":
            return self.cases()
        if word == "pi":
            return lambda p: PI
        if word in self.lets:
            _, body = self.lets[word]
            return lambda p: body(p)
        return lambda p: p[word]

    def cases(self):
        self.expect("{")
        branches, other = [], None
        while not self.takes("}"):
            if self.takes("else"):
                self.expect(":")
                other = self.sum()
            else:
                guard = self.listed()
                self.expect(":")
                branches.append((guard, self.sum()))
            self.takes(";")

        def value(p):
            for guard, body in branches:
                if guard(p):
                    return body(p)
            if other is None:
                raise Undefined
            return other(p)

        return value

    def call(self, word):
        if word in ("sum", "prod"):
            body = self.sum()
            self.expect("for")
            over = self.next()
            self.expect("in")
            low = self.sum()
            self.expect("..")
            high = self.sum()
            self.expect(")")

            def total(p):
                out = Decimal(int(word == "prod"))
                for k in range(int(low(p)), int(high(p)) + 1):
                    one = body({**p, over: Decimal(k)})
                    out = out * one if word == "prod" else out + one
                return out

            return total
        arguments = [self.sum()]
        while self.takes(","):
            arguments.append(self.sum())
        self.expect(")")
        if word == "d":
            f, by = arguments[0], self.tokens[self.at - 2]

            def slope(p):
                ahead, behind = (f({**p, by: p[by] + h}) for h in (STEP, -STEP))
                return (ahead - behind) / (2 * STEP)

            return slope
        if word in FUNCTIONS:
            function = FUNCTIONS[word]
            return lambda p: function(*(a(p) for a in arguments))
        names, body = self.lets[word]
        return lambda p: body({**p, **{name: a(p) for name, a in zip(names, arguments)}})


def joined(sign, a, b):
    return {
        "+": lambda p: a(p) + b(p), "-": lambda p: a(p) - b(p), "*": lambda p: a(p) * b(p), "/": lambda p: divided(a(p), b(p)),
    }[sign]


class Close(Exception):
    """Two values are too close to be told apart."""


def compared(sign, a, b, slopes):
    gap = a - b
    if gap != 0 and abs(gap) <= (NEAR_SLOPE if slopes else NEAR) * (1 + abs(a) + abs(b)):
        if sign in ("<", ">", "!="):
            raise Close
        gap = Decimal(0)
    return {"=": gap == 0, "!=": gap != 0, "<": gap < 0, "<=": gap <= 0, ">": gap > 0, ">=": gap >= 0}[sign]


def told(statement, p):
    """True, False, "undefined", or None where the digits do not tell."""
    try:
        return statement(p)
    except Undefined:
        return "undefined"
    except (Close, OverflowError):
        return None


class Claim:
    """What a claim says, under which conditions, and what it cites."""

    def __init__(self, text, lets, when="", cites=(), first=None, induction=False, witness=None):
        self.said, self.condition, self.cites, self.first = text, when, list(cites), first
        self.induction, self.witness, self.limit = induction, witness, None
        put_in = text
        if witness:
            put_in = re.sub(rf"\b{witness[0]}\b", f"({witness[1]})", text)
        self.says = Reader(put_in, lets).listed()
        self.when = Reader(when, lets).listed() if when else lambda p: True
        self.of_index = bool(re.search(r"\bn\b", text + when))

    def text(self, label):
        out = f"claim {label}: " + (f"exists {self.witness[0]}: " if self.witness else "") + self.said
        out += f" for n >= {self.first}" if self.first is not None else ""
        out += f" when {self.condition}" if self.condition else ""
        out += f" from {', '.join(self.cites)}" if self.cites else ""
        if self.witness:
            out += f" by {self.witness[0]} := {self.witness[1]}"
        return out + (" by induction" if self.induction else "")

    def meant(self, p, document):
        """Whether all that it cites holds there, and its conditions."""
        if self.first is not None and p["n"] < self.first:
            return False
        cited = [document.holds_as_cited(label, p) for label in self.cites]
        own = told(self.when, p)
        if False in cited or own in (False, "undefined"):
            return False
        return None if None in cited or own is None else True


class Given:
    def __init__(self, text, lets, defines=None):
        self.said, self.says, self.defines = text, Reader(text, lets).listed(), defines


class LimitClaim:
    """A limit of a table, perhaps with another value, behind a given that may keep t away."""

    def __init__(self, rng, far):
        form, at, value, self.compute = rng.choice(LIMITS)
        self.to = value if rng.random() < 0.6 else rng.choice(["0", "1", "2", "1/2", "oo", "-oo"])
        self.at, self.induction = at, False
        self.cites = ["law"] if form == "f" else []
        if rng.random() < 0.4:
            self.cites.append(rng.choice([label for label in far if label != "law"]))
        self.said = f"{form} -> {self.to} as t -> {at}"

    def text(self, label):
        return f"claim {label}: {self.said}" + (f" from {', '.join(self.cites)}" if self.cites else "")

    def near(self):
        return [Decimal(t) for t in {"0": ["1e-20", "-1e-20"], "0+": ["1e-20", "1e-12"], "oo": ["3000", "90000"], "-oo": ["-3000", "-90000"]}[self.at]]

    def is_kept_away(self, document):
        """Whether something that it cites fails near the limit, from one side."""
        givens = [document.far[label] for label in self.cites if label != "law"]
        return any(told(given.says, {"t": t}) in (False, "undefined") for t in self.near() for given in givens)

    def holds(self):
        found = [self.compute(FUNCTIONS, t) for t in self.near()]
        if self.to in ("oo", "-oo"):
            sign = 1 if self.to == "oo" else -1
            return all(sign * value > 100 for value in found)
        return all(abs(value - dec(self.to)) < Decimal("1e-3") for value in found)


class Document:
    """Statements in their order, and points at which some of them hold."""

    def __init__(self, rng):
        self.rng, self.lets, self.statements = rng, {}, {}
        self.lines = [f"var {DECLARED}"]
        for line in ("q := exp(-k*x)", "h(u) := u^2/(1 + u^2)", "w(u, v) := cases { u > v: u - v; else: v - u }", "r := sin(phi)*exp(x)"):
            head, body = line.split(" := ")
            name, _, names = head.partition("(")
            self.lets[name] = ([n.strip() for n in names.rstrip(")").split(",")] if names else [], Reader(body, self.lets).sum())
            self.lines.append(f"let {line}")
        self.far = {label: Given(text, self.lets) for label, text in FAR.items()}
        self.lines += [f"given {label}: {given.said}" for label, given in self.far.items()]
        for i in range(rng.choice([1, 2, 3])):
            given = self.given()
            self.statements[f"g{i}"] = given
            self.lines.append(f"given g{i}: {given.said}")
        for i in range(CLAIMS):
            claim = self.claim()
            self.statements[f"c{i}"] = claim
            self.lines.append(claim.text(f"c{i}"))
        self.source = "# Mixed\n\n```kane\n" + "\n".join(self.lines) + "\n```\n"

    def atom(self):
        rng = self.rng
        return rng.choice([
            "x", "y", "k", "m", "s", "e", "i", "phi", "theta", "exp(x)", "exp(-k*x)", "exp(x*y)", "exp(x/2)", "exp(-x^2)", "exp(k/m)",
            "log(k)", "log(k*m)", "log(k^2/m)", "sin(phi)", "cos(theta)", "sin(2*theta)", "cos(phi/2)", "tan(phi)", "q", "r", "h(x)", "h(exp(x))",
            "h(1/x)", "w(x, y)", "w(exp(x), 1)", "w(1/y, x)", "sum(x^j for j in 0..3)", "sum(exp(x)^j for j in 1..2)", "prod(1 + j*x for j in 1..2)",
            "sum(j for j in 3..2)", "abs(x)", "max(x, y)", "min(exp(x), 1)", "sqrt(x^2)", "1/x", "s/L", "k/(exp(x) - 1)", "0", "1", "2", "1/2",
        ])

    def side(self):
        a, b = self.atom(), self.atom()
        return self.rng.choice([a, a, f"{a} + {b}", f"({a})*({b})", f"{a} - ({b})"])

    def comparison(self):
        return f"{self.side()} {self.rng.choice(['=', '!=', '<', '<=', '>', '>='])} {self.side()}"

    def given(self):
        rng = self.rng
        if rng.random() < 0.5:
            name = rng.choice(["y", "z", "b"])
            return Given(f"{name} = {rng.choice(['x', 'k*x', 'exp(x)', 'x^2', '-x', 'h(x)', 'sin(phi)', '1 + x', 's/L', 'log(k)'])}", self.lets, name)
        return Given(rng.choice(["x > 0", "x >= 0", "x <= 1", "k*x <= 1", "exp(x) <= 2", "x = 0", "abs(x) <= 1/2", "s <= 1", "L < 1", "log(k) >= 0", "x*y > 0"]), self.lets)

    def said(self):
        """A claim of the book, at times with a slip, or a random one, or some of them with logic between."""
        rng, pick = self.rng, self.rng.random()
        if pick < 0.5:
            text = rng.choice(BOOK)
            slip = rng.choice(["", "", "", " + 1/100", " - 1/100", " - x", " + y^2"])
            return text + slip if " or " not in text and " implies " not in text and " iff " not in text else text
        if pick < 0.65:
            f, by, slope = rng.choice(SLOPES)
            return f"d({f}, {by}) = {slope}{rng.choice(['', '', ' + x', ' - 1'])}"
        if pick < 0.85:
            return self.comparison()
        a, b = self.comparison(), rng.choice(BOOK[:20])
        return f"{a} {rng.choice(['or', 'and', 'implies', 'iff'])} {b}"

    def claim(self):
        rng, pick = self.rng, self.rng.random()
        names = list(self.statements)
        cites = rng.sample(names, min(len(names), rng.choice([0, 0, 1, 1, 2])))
        if pick < 0.12:
            return LimitClaim(rng, self.far)
        cites = [c for c in cites if not isinstance(self.statements[c], LimitClaim)]
        if pick < 0.22:
            text, first = rng.choice([
                ("sum(j for j in 1..n) = n*(n + 1)/2", 0), ("sum(j*k for j in 1..n) <= k*n^2", 1), ("sum(x^(2*j) for j in 0..n) >= 1", 0),
                ("prod(1 + j*k for j in 1..n) >= 1", 0), ("sum(exp(x)*j for j in 1..n) > 0", rng.choice([0, 1])), ("sum(k^j for j in 1..n) >= n*k", 0),
                ("2^n >= n + 1", 0), ("2^n > n^2", rng.choice([0, 1, 5])), ("sum(j for j in 2..n + 1) = n*(n + 3)/2", 0), ("x^(2*n) >= 0", 0), ("k^n > 0", 0),
            ])
            return Claim(text, self.lets, "", [], first, True)
        if pick < 0.3:
            text, value = rng.choice([
                ("v > x", "x + 1/2"), ("v^2 = k", "sqrt(k)"), ("v*exp(x) = 1", "exp(-x)"), ("v > x, v < x + 1", "x + 1"), ("1/v = x", "1/x"),
                ("v >= exp(x)", "1 + x"), ("v >= exp(x)", "exp(x) + s"), ("0 < v, v < L", "s"), ("v < s", "s/2"), ("v <= sin(phi)", "0"),
            ])
            return Claim(text, self.lets, "", [c for c in cites if "d(" not in self.statements[c].said], None, False, ("v", value))
        said = self.said()
        if any("d(" in text for text in [said, *(self.statements[c].said for c in cites)]):
            # an index does not go with derivatives
            cites = [c for c in cites if not getattr(self.statements[c], "of_index", False)]
        when = rng.choice(["", "", "", "x >= 0", "x > 0", "x = 0", "x < 0, y > 0", "exp(x) > 1", "x != 0", "k = m", "s > L/2", "1/x > 0"])
        return Claim(said, self.lets, when, cites)

    def holds_as_cited(self, label, p):
        """A given holds if it is true; a claim says something where its conditions hold and it is defined."""
        statement = self.statements[label]
        found = told(statement.says, p)
        if isinstance(statement, Given):
            return False if found == "undefined" else found
        if statement.first is not None and p["n"] < statement.first:
            return True
        own = told(statement.when, p)
        if own in (False, "undefined") or found == "undefined":
            return True
        return None if own is None or found is None else found

    def points(self, count):
        simple = ["0", "0", "1", "1/2", "-1/3", "-2", "7/5", "3", "-1", "1/10"]
        positive = ["1", "1", "2", "1/2", "1/7", "3", "13/12"]
        rng = self.rng
        for _ in range(count):
            p = {v: dec(rng.choice(simple)) for v in ("x", "y", "z", "b", "e", "i", "theta")}
            p |= {v: dec(rng.choice(positive)) for v in ("k", "m", "L")}
            p["s"] = p["L"] * dec(rng.choice(["1/2", "1/100", "99/100"]))
            p["phi"] = PI / 2 * dec(rng.choice(["1/2", "1/3", "1/50", "49/50"]))
            p["n"] = Decimal(rng.choice([0, 1, 2, 3, 5, 8]))
            yield self.completed(p, rng.random() < 0.7)

    def completed(self, p, defined=True):
        """The point with what givens define as they define it."""
        for given in self.statements.values():
            if defined and isinstance(given, Given) and given.defines:
                p = {**p, given.defines: Reader(given.said.split(" = ")[1], self.lets).sum()(p)}
        return p


def inside(p):
    return p["k"] > 0 and p["m"] > 0 and p["L"] > 0 and 0 < p["s"] < p["L"] and 0 < p["phi"] < PI / 2


def angle_of(cos, sin):
    """The angle of a point on the circle."""
    angle = Decimal(math.atan2(float(sin), float(cos)))
    for _ in range(5):
        s, c = circular(angle)
        angle += sin * c - cos * s
    return angle


def continued(values, at):
    """The point of a certificate, with values for what stands in its exponentials and sines; None if it is not rational."""
    if any(len(c) > 1 for c in values.values()):
        return None
    p = {name: dec(c[0]) if c else Decimal(0) for name, c in values.items() if not name.startswith("sqrt:")}
    known = {name: value for name, value in p.items() if "(" not in name}
    known |= {name: Decimal(number) for name, number in at.items()}
    for angle, parts in {(m[1], int(m[2] or 1)) for m in (re.fullmatch(r"(?:cos|sin)\((\w+)(?:/(\d+))?\)", name) for name in p) if m}:
        part = angle if parts == 1 else f"{angle}/{parts}"
        cos, sin = p.get(f"cos({part})"), p.get(f"sin({part})")
        if cos is None:
            cos = (1 - sin * sin).sqrt()
        if sin is None:
            sin = (1 - cos * cos).sqrt()
        found = angle_of(cos, sin) * parts
        if angle not in known:
            known[angle] = found
    for name, value in p.items():
        found = re.fullmatch(r"(exp|log)\((.*)\)", name)
        if not found:
            continue
        pieces = found[2].split("/")
        parts = int(pieces.pop()) if len(pieces) > 1 and pieces[-1].isdigit() else 1
        powers = [(f, 1) for f in pieces[0].split("*")] + [(f, -1) for f in pieces[1:]]
        powers = [(f.partition("^")[0], n * int(f.partition("^")[2] or 1)) for f, n in powers if f != "1"]
        unknown = [f for f, _ in powers if f not in known]
        if not unknown:
            continue
        for f in unknown[1:]:
            known[f] = Decimal(1)
        u = value.ln() * parts if found[1] == "exp" else value.exp()
        rest = Decimal(1)
        for f, n in powers:
            rest = rest * known[f] ** n if f != unknown[0] else rest
        target, n = u / rest, dict(powers)[unknown[0]]
        known[unknown[0]] = target if n == 1 else 1 / target if n == -1 else abs(target).sqrt()
    if "L" not in known and "s" in known:
        known["L"] = known["s"] + 1
    known.setdefault("L", Decimal(1))
    known.setdefault("s", known["L"] / 2)
    known.setdefault("phi", Decimal("0.7"))
    for name in ("k", "m"):
        known.setdefault(name, Decimal(1))
    for name in ("x", "y", "z", "b", "e", "i", "theta", "n"):
        known.setdefault(name, Decimal(0))
    return known


def judged_wrong(document, label, statement, entry, places):
    """Why a verdict is wrong, if it is."""
    claim, verdict = document.statements[label], statement["verdict"]
    if isinstance(claim, LimitClaim):
        away = claim.is_kept_away(document)
        if verdict == "proved" and (away or not claim.holds()):
            return "proved, and what is cited keeps t away" if away else "proved, and it is another limit"
        return "vacuous, and what is cited holds near the limit" if verdict == "vacuous" and not away else None
    meant = [p for p in places if claim.meant(p, document)]
    if verdict == "vacuous" and meant:
        return f"vacuous, and meant at {meant[0]}"
    if verdict == "proved":
        failing = next((p for p in meant if told(claim.says, p) in (False, "undefined")), None)
        return failing and f"proved, and {told(claim.says, failing)} at {failing}"
    if verdict in ("refuted", "ill-defined"):
        if claim.witness:
            return f"an existence is {verdict}"
        for link in entry["links"]:
            if link["finding"] != verdict:
                continue
            p = continued(link["evidence"]["point"]["values"], link.get("at", {}))
            if p is None:
                continue
            if not inside(p) or claim.meant(p, document) is False:
                return f"{verdict}, and nothing is meant at {p}"
            found = told(claim.says, p)
            if found is True or (verdict == "ill-defined" and found is False):
                return f"{verdict}, and {found} at {p}"
    return None


def true_or_false(document, label, places):
    """What the points say of a claim, where it is meant at one of them."""
    claim = document.statements[label]
    if isinstance(claim, LimitClaim):
        return "limit out of reach" if claim.is_kept_away(document) else f"{str(claim.holds()).lower()} limit"
    meant = [p for p in places if claim.meant(p, document)]
    false = any(told(claim.says, p) in (False, "undefined") for p in meant)
    return ("false" if false else "true" if meant else "silent") + (" induction" if claim.induction else "")


def text_says_the_same(trial, statements):
    """Whether the report for people has the verdict of each claim in its line."""
    command = [trial.kane, "audit", str(Path(trial.folder.name) / "d.md"), "--budget", str(BUDGET)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    lines = run.stdout.split("\n")
    return all(
        any(line.lstrip("! ").startswith(s["verdict"]) and re.match(rf"[! ]*{s['verdict']} +{s['label']} ", line) for line in lines)
        for s in statements if s["label"].startswith("c")
    )


def main():
    options = {}
    for option in ("--keep", "--show"):
        if option in sys.argv:
            at = sys.argv.index(option)
            options[option] = sys.argv[at + 1]
            del sys.argv[at:at + 2]
    trial = Trial("mixed")
    made = iter(range(10**9))
    if "--show" in options:
        print(Document(random.Random(f"{trial.seed}/{options['--show']}")).source)
        return 0

    def document(_):
        own = Document(random.Random(f"{trial.seed}/{next(made)}"))
        return own.source, own

    unread = 0
    while trial.judged < trial.count:
        source, own = document(None)
        statements, messages = trial.statements(source, BUDGET)
        if statements is None:
            # a derivative with a symbol that what is cited ties to its variable
            unread += 1
            tied = all(" ties " in line or " tie " in line for line in messages.split("\n") if line.startswith("error"))
            if not tied or unread > 40 + trial.judged:
                trial.wrong.append((source, messages))
                break
            continue
        certificate = json.loads(Path(trial.folder.name, "out", "d.cert.json").read_text())
        entries = {c["label"]: c for c in certificate["claims"]}
        places = list(own.points(70))
        if trial.judged == 0 and not text_says_the_same(trial, statements):
            trial.wrong.append((source, "the text says another verdict"))
        for statement in statements:
            label = statement["label"]
            if label not in own.statements or not label.startswith("c"):
                continue
            trial.judged += 1
            trial.count_one(f"{true_or_false(own, label, places)}, {statement['verdict']}")
            why = judged_wrong(own, label, statement, entries[label], places)
            if why:
                trial.wrong.append((source, f"{label}: {why}"))
                if "--keep" in options:
                    Path(options["--keep"]).mkdir(exist_ok=True)
                    (Path(options["--keep"]) / f"{len(trial.wrong)}.md").write_text(source)
    return trial.told(f", {unread} documents not read")


if __name__ == "__main__":
    sys.exit(main())
