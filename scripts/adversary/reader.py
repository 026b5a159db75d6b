"""Reads the values that a report prints: expressions, and algebraic numbers by polynomial and place."""

import re
from fractions import Fraction

from algebraic import root_of
from expr import RELATIONS

TOKEN = re.compile(r"\s*(?:(\d+(?:\.\d+)?)|([A-Za-z_][A-Za-z_0-9']*)|(!=|<=|>=|[-+*/^(),{};:=<>]))")


class Unreadable(Exception):
    """The text is not of a kind that is known here."""


class Reader:
    """Operator precedence as the language page gives it."""

    def __init__(self, text):
        self.tokens, at = [], 0
        text = text.rstrip()
        while at < len(text):
            m = TOKEN.match(text, at)
            if not m:
                raise Unreadable(text)
            number, name, other = m.groups()
            self.tokens.append(("n", number) if number else ("v", name) if name else ("o", other))
            at = m.end()
        self.i = 0

    def peek(self):
        return self.tokens[self.i][1] if self.i < len(self.tokens) else None

    def take(self, expected=None):
        if self.i >= len(self.tokens) or expected not in (None, self.tokens[self.i][1]):
            raise Unreadable(f"expected {expected} in {self.tokens}")
        self.i += 1
        return self.tokens[self.i - 1]

    def whole(self):
        e = self.sum()
        if self.peek() is not None:
            raise Unreadable(str(self.tokens))
        return e

    def sum(self):
        e = self.product()
        while self.peek() in ("+", "-"):
            e = (self.take()[1], e, self.product())
        return e

    def product(self):
        e = self.signed()
        while self.peek() in ("*", "/"):
            e = (self.take()[1], e, self.signed())
        return e

    def signed(self):
        if self.peek() == "-":
            self.take()
            return ("neg", self.signed())
        return self.power()

    def power(self):
        base = self.atom()
        if self.peek() != "^":
            return base
        self.take()
        return ("^", base, self.exponent())

    def exponent(self):
        minus = self.peek() == "-"
        if minus:
            self.take()
        n = int(self.take()[1])
        if self.peek() == "^":
            self.take()
            n = n ** self.exponent()
        return -n if minus else n

    def atom(self):
        kind, text = self.take()
        if kind == "n":
            return ("n", Fraction(text))
        if text == "(":
            e = self.sum()
            self.take(")")
            return e
        if kind != "v":
            raise Unreadable(text)
        if text in ("abs", "sqrt"):
            self.take("(")
            e = (text, self.sum())
            self.take(")")
            return e
        if text in ("min", "max", "d") and self.peek() == "(":
            self.take("(")
            a = self.sum()
            self.take(",")
            b = self.sum()
            self.take(")")
            return (text, a, b[1] if text == "d" else b)
        if text == "cases":
            return self.cases()
        return ("v", text)

    def cases(self):
        self.take("{")
        branches, otherwise = [], None
        while self.peek() != "}":
            if self.peek() == "else":
                self.take()
                self.take(":")
                otherwise = self.sum()
            else:
                guard = [self.relation()]
                while self.peek() == ",":
                    self.take()
                    guard.append(self.relation())
                self.take(":")
                branches.append((tuple(guard), self.sum()))
            if self.peek() == ";":
                self.take()
        self.take("}")
        return ("cases", tuple(branches), otherwise)

    def relation(self):
        a = self.sum()
        op = self.take()[1]
        if op not in RELATIONS:
            raise Unreadable(op)
        return (op, a, self.sum())


def read(text):
    return Reader(text).whole()


ROOT = re.compile(r"the root of (.*) near (-?\d+\.(\d+)(?:e(-?\d+))?)$")


def coefficients(e, name):
    """Coefficients of a polynomial in one name, from the lowest."""
    kind = e[0]
    if kind == "n":
        return [e[1]]
    if kind == "v":
        if e[1] != name:
            raise Unreadable(e[1])
        return [Fraction(0), Fraction(1)]
    if kind == "neg":
        return [-c for c in coefficients(e[1], name)]
    if kind == "^":
        out = [Fraction(1)]
        for _ in range(e[2]):
            out = convolve(out, coefficients(e[1], name))
        return out
    a, b = coefficients(e[1], name), coefficients(e[2], name)
    if kind == "*":
        return convolve(a, b)
    if kind == "/" and len(b) == 1:
        return [c / b[0] for c in a]
    if kind not in "+-":
        raise Unreadable(kind)
    n = max(len(a), len(b))
    a, b = a + [Fraction(0)] * (n - len(a)), b + [Fraction(0)] * (n - len(b))
    return [x + y if kind == "+" else x - y for x, y in zip(a, b)]


def convolve(a, b):
    out = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            out[i + j] += x * y
    return out


def algebraic(text):
    m = ROOT.match(text)
    if not m:
        raise Unreadable(text)
    e = read(m.group(1))
    names = {text for kind, text in Reader(m.group(1)).tokens if kind == "v"}
    if len(names) != 1:
        raise Unreadable(text)
    c = coefficients(e, names.pop())
    while c and c[-1] == 0:
        c.pop()
    scale = 1
    for v in c:
        scale = scale * v.denominator
    c = [int(v * scale) for v in c]
    near = Fraction(m.group(2))
    width = 2 * Fraction(10) ** (int(m.group(4) or 0) - len(m.group(3)))

    def at(x):
        out = Fraction(0)
        for v in reversed(c):
            out = out * x + v
        return out

    lo, hi = near - width, near + width
    if at(lo) * at(hi) >= 0:
        raise Unreadable(f"no sign change: {text}")
    return root_of(c, lo, hi)


PAIR = re.compile(r"(?:^|, )([A-Za-z_][A-Za-z_0-9']*) = ")


def pairs(text):
    """NAME = VALUE, NAME = VALUE, … as (name, text)."""
    parts = PAIR.split(text)
    if parts[0].strip():
        raise Unreadable(text)
    return list(zip(parts[1::2], parts[2::2]))


def number(text, roots):
    """A value as printed; `roots` keeps each algebraic number once."""
    text = text.strip()
    if text.startswith("the root of"):
        if text not in roots:
            roots[text] = algebraic(text)
        return roots[text]
    if " with r = " in text:
        form, root = text.split(" with r = ")
        from point import Scope, evaluate

        return evaluate(read(form), Scope({}, {"r": number(root, roots)}))
    from point import Scope, Undefined, evaluate

    try:
        return evaluate(read(text), Scope({}, {}))
    except (KeyError, Undefined):
        raise Unreadable(text)
