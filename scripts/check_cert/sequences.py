"""Indices, powers and sequences (the language, "Sequences").

An index is a natural number. The power b^n is the symbol `pow(b, n)`, the term s(n) of a sequence the symbol `s(n)`;
a document knows what they become one step further, and at a number.
"""

from dataclasses import replace
from fractions import Fraction

from .errors import Unreadable, demand
from . import expressions

MAX_INDEX = 64
MAX_EXPONENT = 10_000
MAX_PARTS = 200_000
ONE = ("num", 1, 1)


class MetPower(Exception):
    """A power without a symbol; the document is read again with one."""

    def __init__(self, base, index):
        super().__init__(base, index)
        self.base, self.index = base, index


class Sequences:
    """What a document says of its indices."""

    def __init__(self, document):
        self.document = document
        self.indices = set()
        self.powers = {}  # symbol -> (base, index)
        self.steps = {}  # symbol -> (first term, next term, index)
        self.sums = {}  # (whether it is a product, index, first value, term) -> symbol
        self.terms = {}  # name of a sequence -> (index, term at it)

    def index_of(self, name):
        """The index on which the value of a symbol depends."""
        if name in self.indices:
            return name
        return (self.powers.get(name) or self.steps.get(name) or (None,))[-1]

    def spoken(self, expressions):
        """The indices of which expressions speak."""
        names = set().union(*map(self.document.mentioned, expressions))
        return {self.index_of(name) for name in names} - {None}

    def linear(self, e):
        """A sum of multiples of indices, and a number; None if it is none."""
        kind = e[0]
        if kind == "num":
            return ({}, e[1]) if e[2] == 1 else None
        if kind == "sym":
            return ({e[1]: 1}, 0) if e[1] in self.indices else None
        if kind not in ("neg", "add", "sub", "mul"):
            return None
        sums = [self.linear(part) for part in e[1:]]
        if None in sums:
            return None
        if kind == "mul":
            a, b = sums if sums[1][0] else sums[::-1]
            return None if a[0] else scaled(b, a[1])
        if kind == "neg":
            return scaled(sums[0], -1)
        (a, m), (b, n) = sums[0], scaled(sums[1], -1 if kind == "sub" else 1)
        total = {name: a.get(name, 0) + b.get(name, 0) for name in {*a, *b}}
        return {name: times for name, times in total.items() if times}, m + n

    def power(self, base, exponent, fail):
        """b^(2n + 1) as b·pow(b, n)^2."""
        found = self.linear(exponent)
        if not found or not all(0 <= n <= MAX_EXPONENT for n in (found[1], *found[0].values())):
            fail("an exponent with an index is a sum of indices with natural factors")
        times, plus = found
        if base[0] == "num" and base[2] == 1 and base[1] >= 0:
            name = str(base[1])
        elif base[0] in ("sym", "def") and not self.index_of(base[1]) and self.is_total(base, None):
            name = base[1]
        else:
            fail("this is no base of a power with an index")
        factors = [raised(base, plus)] if plus or not times else []
        for index in sorted(times, key=list(self.document.symbols).index):
            symbol = f"pow({name}, {index})"
            if symbol not in self.powers:
                raise MetPower(name, index)
            factors.append(raised(("sym", symbol), times[index]))
        whole = factors[0]
        for factor in factors[1:]:
            whole = ("mul", whole, factor)
        return whole

    def term(self, name, argument, fail):
        """s(n + 1) or s(0)."""
        index, term = self.terms[name]
        found = self.linear(argument)
        if not found or found[0] not in ({}, {index: 1}) or not 0 <= found[1] <= MAX_INDEX:
            fail("a sequence is taken at a natural number or at its index")
        if not found[0]:
            return self.at(term, {index: found[1]})
        for _ in range(found[1]):
            term = self.further(term, index)
        return term

    def is_total(self, e, index, seen=None):
        """Has it a value everywhere, by how it is written?"""
        seen = set() if seen is None else seen
        kind = e[0]
        if kind in ("num", "par"):
            return True
        if kind == "sym":
            symbol, known = self.document.symbols[e[1]], self.document
            plain = not symbol.argument and not symbol.parts and e[1] not in known.points
            return plain and self.index_of(e[1]) in (None, index)
        if kind == "def":
            if e[1] in seen:
                return True
            seen.add(e[1])
            return self.is_total(self.document.symbols[e[1]].body, index, seen)
        if kind == "pow":
            return e[2] >= 0 and self.is_total(e[1], index, seen)
        if kind == "div" and not self.never_vanishes(e[2]):
            return False
        return kind in ("neg", "add", "sub", "mul", "div") and all(
            self.is_total(part, index, seen) for part in e[1:]
        )

    def never_vanishes(self, e):
        kind = e[0]
        if kind == "num":
            return e[1] != 0
        if kind == "sym":
            symbol = self.document.symbols[e[1]]
            low, high = symbol.lower, symbol.upper
            return bool(
                low and (low[0] > 0 or (low[0] == 0 and low[1]))
                or high and (high[0] < 0 or (high[0] == 0 and high[1]))
            )
        if kind in ("neg", "pow"):
            return self.never_vanishes(e[1])
        if kind in ("add", "sub"):
            return self.is_above(e, True)
        return kind == "mul" and self.never_vanishes(e[1]) and self.never_vanishes(e[2])

    def is_above(self, e, strictly):
        """Is it not negative, or positive, by what is declared?"""
        kind, total = e[0], self.linear(e)
        if total:
            return total[1] >= strictly and all(n >= 0 for n in total[0].values())
        if kind == "num":
            return e[1] > 0 or (e[1] == 0 and not strictly)
        if kind == "sym":
            low = self.document.symbols[e[1]].lower
            return bool(low) and (low[0] > 0 or (low[0] == 0 and (low[1] or not strictly)))
        if kind == "add":
            one, other = e[1:]
            return any(
                self.is_above(a, False) and self.is_above(b, strictly) for a, b in ((one, other), (other, one))
            )
        if kind in ("mul", "div"):
            return self.is_above(e[1], strictly) and self.is_above(e[2], strictly or kind == "div")
        return kind == "pow" and self.is_above(e[1], strictly or e[2] < 0)

    def bounds(self, base):
        """What the bounds of a base say of all its powers: (lower, upper)."""
        if base[0] == "num":
            low = high = (Fraction(base[1], base[2]), False)
        elif base[0] == "sym":
            symbol = self.document.symbols[base[1]]
            low, high = symbol.lower, symbol.upper
        else:
            low = high = None
        if not low or low[0] < 0:
            return None, None
        upper = (Fraction(1), False) if high and high[0] <= 1 else None
        if low[0] >= 1:
            return (Fraction(1), False), upper
        return (Fraction(0), low[0] > 0 or low[1]), upper

    def further(self, e, index):
        """The expression one step further."""

        def replaced(symbol):
            name = symbol[1]
            if name == index:
                return ("add", symbol, ONE)
            if self.index_of(name) != index:
                return symbol
            return ("mul", self.powers[name][0], symbol) if name in self.powers else self.steps[name][1]

        return rebuilt(e, replaced)

    def at(self, e, values, known=None):
        """The expression with numbers for indices."""
        known = {} if known is None else known

        def replaced(symbol):
            name = symbol[1]
            index = self.index_of(name)
            if index not in values:
                return symbol
            if name == index:
                return ("num", values[index], 1)
            if name in self.powers:
                return ("pow", self.powers[name][0], values[index])
            first, step, _ = self.steps[name]
            known.setdefault((name, 0), first)
            for k in range(values[index]):
                if (name, k + 1) not in known:
                    # what is put in is found from below
                    known[name, k + 1] = self.at(step, {index: k}, known)
            return known[name, values[index]]

        done = rebuilt(e, replaced)
        if size(done) > MAX_PARTS:
            raise Unreadable("a term comes to too much when written out")
        return done

    def changed(self, statement, change):
        """The statement with other expressions, and in it what it cites, as far as they speak of an index."""

        def relations(items):
            return [(sign, *(change(side) if isinstance(side, tuple) else side for side in sides)) for sign, *sides in items]

        def new(s):
            if not s or not self.spoken(s.expressions()):
                return s
            return replace(s, items=relations(s.items), when=tuple(relations(s.when)))

        own = replace(statement, items=relations(statement.items), when=tuple(relations(statement.when)))
        own.cited = [new(s) for s in statement.cited]
        own.other = new(statement.other)
        return own

    def step(self, claim):
        """What is to be shown at n + 1: cited is what the claim cites, that one step further, and the claim."""
        index, _ = claim.induction
        moved = self.changed(claim, lambda e: self.further(e, index))
        own = replace(claim, kind="given", cited=[], expect=None)
        further = [s for s, old in zip(moved.cited, claim.cited) if index in self.spoken(old.expressions())]
        cited = [*claim.cited, *further, own]
        return replace(claim, items=moved.items, cited=cited)

    def instance(self, claim, values):
        return self.changed(claim, lambda e: self.at(e, values))

    def all_spoken(self, claim):
        """The indices of which a claim and what it cites speak."""
        others = [claim.other] if claim.other else []
        return self.spoken([e for s in (claim, *claim.cited, *others) for e in s.expressions()])

    def named(self, content):
        """The numbers that a certificate puts in the place of indices."""
        demand(isinstance(content, dict) and content, "numbers for indices are expected")
        for name, text in content.items():
            plain = isinstance(text, str) and text.isascii() and text.isdigit() and str(int(text)) == text
            demand(name in self.indices and plain, "an index has a natural number")
        values = {name: int(text) for name, text in content.items()}
        demand(all(n <= MAX_INDEX for n in values.values()), "the number for an index is too large")
        return values

    def check(self, statement, reader):
        """What may not speak of an index."""
        if not self.indices:
            return
        if statement.kind == "given" and self.spoken(statement.expressions()):
            reader.fail("a given speaks of no index")
        if statement.induction:
            if self.spoken([side for _, *sides in statement.when[1:] for side in sides]):
                reader.fail("the `when` of an induction speaks of no index")
        others = [statement.other] if statement.other else []
        said = (statement, *statement.cited, *others)
        expressions = [e for s in said for e in s.expressions()]
        limits = {s.variable for s in said if s.limits}
        if not (self.spoken(expressions) or limits & self.indices):
            return
        names = set().union(*map(self.document.mentioned, expressions))
        functions = any(self.document.symbols[name].argument for name in names)
        if limits or functions or any(self.differentiates(e, set()) for e in expressions):
            reader.fail("an index does not go with functions, derivatives and limits")

    def differentiates(self, e, seen):
        if e[0] == "d":
            return True
        if e[0] == "def":
            if e[1] in seen:
                return False
            seen.add(e[1])
            return self.differentiates(self.document.symbols[e[1]].body, seen)
        return any(self.differentiates(part, seen) for part in expressions.parts(e))


def scaled(total, by):
    times, plus = total
    return {name: n * by for name, n in times.items() if n * by}, plus * by


def raised(base, n):
    return base if n == 1 else ("pow", base, n)


def size(e):
    return 1 + sum(map(size, e)) if isinstance(e, tuple) else 0


def rebuilt(e, replaced):
    """The expression with other ones for its symbols."""
    if not isinstance(e, tuple) or not e or e[0] == "num":
        return e
    if e[0] == "sym":
        return replaced(e)
    return tuple(rebuilt(part, replaced) for part in e)
