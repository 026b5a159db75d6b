"""Derivatives by jets: values at x + h for an infinitesimal h, as power series cut off.

The conditions are those of rule 6 of the language page, checked at the point: what is differentiated
is one smooth piece nearby, no guard that is read changes, a root is of something positive.
Where the page leaves open what `free of x` means (by the letters or by the value) the point is
`Ambiguous`, and judges nothing.
"""

from fractions import Fraction
from itertools import product

from algebraic import sign, square_root
from point import Ambiguous, Scope, Undefined, evaluate, holds


class Jet:
    """Coefficients by exponents, one exponent for each variable that is moved."""

    __slots__ = ("c", "orders")

    def __init__(self, c, orders):
        self.c, self.orders = c, orders

    def value(self):
        return self.c.get((0,) * len(self.orders), Fraction(0))

    def __add__(self, o):
        c = dict(self.c)
        for k, v in o.c.items():
            c[k] = c[k] + v if k in c else v
        return Jet(c, self.orders)

    def __neg__(self):
        return Jet({k: -v for k, v in self.c.items()}, self.orders)

    def __sub__(self, o):
        return self + (-o)

    def __mul__(self, o):
        c = {}
        for k, v in self.c.items():
            for m, w in o.c.items():
                key = tuple(i + j for i, j in zip(k, m))
                if all(i <= n for i, n in zip(key, self.orders)):
                    p = v * w
                    c[key] = c[key] + p if key in c else p
        return Jet(c, self.orders)

    def __truediv__(self, o):
        """Coefficient by coefficient from o*q = self."""
        lead = o.value()
        if sign(lead) == 0:
            raise Undefined("division by zero")
        q = {}
        for key in product(*(range(n + 1) for n in self.orders)):
            rest = self.c.get(key, Fraction(0))
            for m, w in o.c.items():
                if any(m) and all(i <= k for i, k in zip(m, key)):
                    earlier = q.get(tuple(k - i for i, k in zip(m, key)))
                    if earlier is not None:
                        rest = rest - w * earlier
            q[key] = rest / lead
        return Jet(q, self.orders)

    def root(self):
        """Coefficient by coefficient from r*r = self; the leading value is positive."""
        lead = square_root(self.value())
        zero = (0,) * len(self.orders)
        r = {zero: lead}
        for key in product(*(range(n + 1) for n in self.orders)):
            if key == zero:
                continue
            rest = self.c.get(key, Fraction(0))
            for m in product(*(range(k + 1) for k in key)):
                other = tuple(k - i for i, k in zip(m, key))
                if m != zero and other != zero:
                    rest = rest - r[m] * r[other]
            r[key] = rest / (lead + lead)
        return Jet(r, self.orders)


class Moved:
    """A point together with the names that are moved, and how far the series goes for each."""

    def __init__(self, scope, names, orders):
        self.scope, self.names, self.orders = scope, names, orders
        self.active = set(names)
        self.nested = len(names) > 1

    def constant(self, v):
        return Jet({(0,) * len(self.names): v}, self.orders)

    def free(self, *expressions):
        return not any(self.scope.symbols(e) & self.active for e in expressions)

    def undefined(self, why):
        """With two variables moved the page does not say in whose neighbourhood; see rule 6."""
        raise Ambiguous(why) if self.nested else Undefined(why)

    def constant_by_value(self, difference):
        """Whether an expression seems to be the same far from the point too."""
        same = 0
        for step in (Fraction(7, 3), Fraction(-11, 5), Fraction(1, 7), Fraction(-1, 9)):
            values = dict(self.scope.values)
            for n in self.names:
                values[n] = values[n] + step
            try:
                here = Scope(self.scope.lets, values, self.scope.shared)
                same += sign(evaluate(difference, here)) == 0
            except Undefined:
                pass
        return same >= 3


def derivative(e, scope):
    """The value of ('d', f, x) at the point."""
    moved = Moved(scope, (e[2],), (1,))
    return series(e[1], moved).c.get((1,), Fraction(0))


def guard_stays(r, moved):
    """Whether a relation holds, and does so in a neighbourhood."""
    op, a, b = r
    x, y = evaluate(a, moved.scope), evaluate(b, moved.scope)
    if moved.free(a, b):
        return holds(op, x, y)
    continuous(a, moved)
    continuous(b, moved)
    if sign(x - y) == 0:
        if moved.constant_by_value(("-", a, b)):
            raise Ambiguous("free of the variable by value only")
        moved.undefined("a guard changes here")
    return holds(op, x, y)


def branch(e, moved):
    """The expression that `cases`, `abs`, `min` or `max` is near the point."""
    kind = e[0]
    if kind == "abs":
        return e[1] if guard_stays((">=", e[1], ("n", Fraction(0))), moved) else ("neg", e[1])
    if kind in ("min", "max"):
        first = guard_stays(("<=" if kind == "min" else ">=", e[1], e[2]), moved)
        return e[1] if first else e[2]
    for guard, value in e[1]:
        if all(guard_stays(r, moved) for r in guard):
            return value
    if e[2] is None:
        raise Undefined("no branch")
    return e[2]


def continuous(e, moved):
    """Passes if e is continuous at the point in the sense of rule 6."""
    kind = e[0]
    if kind == "n" or moved.free(e):
        return
    if kind == "v":
        if e[1] in moved.scope.lets:
            continuous(moved.scope.lets[e[1]], moved)
        return
    if kind == "d":
        evaluate(e, moved.scope)
        if e[2] not in moved.active or moved.nested:
            raise Ambiguous("a derivative by another variable under a guard")
        return
    if kind == "cases":
        continuous(branch(e, moved), moved)
        return
    for c in e[1:]:
        if isinstance(c, tuple):
            continuous(c, moved)
    if kind == "sqrt" and sign(evaluate(e[1], moved.scope)) == 0:
        if moved.constant_by_value(e[1]):
            raise Ambiguous("free of the variable by value only")
        moved.undefined("the radicand vanishes")


def series(e, moved):
    """The jet of e, if it is differentiable in all names that are moved."""
    kind = e[0]
    if kind == "n":
        return moved.constant(e[1])
    if kind == "v":
        name = e[1]
        if name in moved.scope.lets:
            return series(moved.scope.lets[name], moved)
        jet = moved.constant(moved.scope.values[name])
        if name in moved.active:
            jet.c[tuple(int(name == n) for n in moved.names)] = Fraction(1)
        return jet
    if moved.free(e):
        return moved.constant(evaluate(e, moved.scope))
    if kind in ("abs", "min", "max", "cases"):
        if kind in ("min", "max"):
            # both sides have to be defined, although only one is differentiated
            evaluate(e, moved.scope)
        return series(branch(e, moved), moved)
    if kind == "d":
        return nested(e, moved)
    a = series(e[1], moved)
    if kind == "neg":
        return -a
    if kind == "^":
        n, out = e[2], moved.constant(Fraction(1))
        for _ in range(abs(n)):
            out = out * a
        return moved.constant(Fraction(1)) / out if n < 0 else out
    if kind == "sqrt":
        s = sign(a.value())
        if s < 0:
            raise Undefined("root of a negative number")
        if s == 0:
            if moved.constant_by_value(e[1]):
                raise Ambiguous("free of the variable by value only")
            moved.undefined("the radicand vanishes")
        return a.root()
    b = series(e[2], moved)
    return {"+": Jet.__add__, "-": Jet.__sub__, "*": Jet.__mul__, "/": Jet.__truediv__}[kind](a, b)


def nested(e, moved):
    """A derivative under a derivative: one order more is carried, and its conditions are the same."""
    name = e[2]
    if name in moved.names:
        i = moved.names.index(name)
        names, orders = moved.names, tuple(n + (j == i) for j, n in enumerate(moved.orders))
    else:
        i = len(moved.names)
        names, orders = moved.names + (name,), moved.orders + (1,)
    inner = series(e[1], Moved(moved.scope, names, orders))
    c = {}
    for key, v in inner.c.items():
        if key[i] == 0:
            continue
        lower = tuple(k - (j == i) for j, k in enumerate(key))
        if len(lower) > len(moved.names):
            if lower[-1]:
                continue
            lower = lower[:-1]
        w = v * key[i]
        c[lower] = c[lower] + w if lower in c else w
    return Jet(c, moved.orders)


