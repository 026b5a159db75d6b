"""Real numbers made from rationals by + - * / and roots, with an exact sign.

The sign is read from interval arithmetic that is refined until either zero is excluded or the
interval is smaller than a separation bound (Burnikel, Funke, Mehlhorn, Schirra and Schmitt 2001):
E = U/L with algebraic integers U and L in a field of degree D, whose conjugates are at most u and l,
is zero or at least 1/(u^(D-1) l).
"""

from fractions import Fraction
from math import isqrt

TOO_MANY_BITS = 2000


class Costly(Exception):
    """The separation bound is too small to be reached in reasonable time."""


class Alg:
    """A node of the expression; bounds u and l are kept as numbers of bits."""

    __slots__ = ("op", "a", "b", "u", "l", "roots", "memo")

    def __init__(self, op, a, b, u, l, roots):
        self.op, self.a, self.b, self.u, self.l, self.roots = op, a, b, u, l, roots
        self.memo = {}

    # --- arithmetic

    def __add__(self, other):
        o = lift(other)
        return Alg("+", self, o, max(self.u + o.l, o.u + self.l) + 1, self.l + o.l, self.roots | o.roots)

    __radd__ = __add__

    def __neg__(self):
        return Alg("*", self, lift(Fraction(-1)), self.u, self.l, self.roots)

    def __sub__(self, other):
        return self + (-other)

    def __rsub__(self, other):
        return (-self) + other

    def __mul__(self, other):
        o = lift(other)
        return Alg("*", self, o, self.u + o.u, self.l + o.l, self.roots | o.roots)

    __rmul__ = __mul__

    def __truediv__(self, other):
        """The caller has seen to it that the divisor is not zero."""
        o = lift(other)
        return Alg("/", self, o, self.u + o.l, self.l + o.u, self.roots | o.roots)

    def __rtruediv__(self, other):
        return lift(other) / self

    # --- intervals: integers lo, hi with lo <= 2^p value <= hi

    def interval(self, p):
        if p not in self.memo:
            self.memo[p] = self._interval(p)
        return self.memo[p]

    def _interval(self, p):
        if self.op == "q":
            n, d = self.a.numerator << p, self.a.denominator
            return n // d, -((-n) // d)
        if self.op == "root":
            return self.a.interval(p)
        x = self.a.interval(p)
        if x is None:
            return None
        if self.op == "sqrt":
            return isqrt(max(x[0], 0) << p), isqrt(max(x[1], 0) << p) + 1
        y = self.b.interval(p)
        if y is None:
            return None
        if self.op == "+":
            return x[0] + y[0], x[1] + y[1]
        if self.op == "*":
            c = [i * j for i in x for j in y]
            return min(c) >> p, -((-max(c)) >> p)
        if y[0] <= 0 <= y[1]:
            return None
        c = [(i << p, j) for i in x for j in y]
        return min(n // d for n, d in c), max(-((-n) // d) for n, d in c)

    def sign(self):
        degree = 1
        for _, k in self.roots:
            degree *= k
        bits = (degree - 1) * self.u + self.l
        if bits > TOO_MANY_BITS:
            bits = None
        p = 64
        while True:
            i = self.interval(p)
            if i is not None:
                if i[0] > 0:
                    return 1
                if i[1] < 0:
                    return -1
                if bits is not None and p > bits and max(-i[0], i[1]) < (1 << (p - bits)):
                    return 0
            p *= 2
            if p > 4 * TOO_MANY_BITS or (bits is None and p > 4096):
                raise Costly

    def near(self, p=80):
        """A rational close by, for messages and trends."""
        while self.interval(p) is None:
            p *= 2
        lo, hi = self.interval(p)
        return Fraction(lo + hi, 2 << p)


class RootOf:
    """The root of a polynomial (coefficients from the lowest) between lo and hi, where its sign changes."""

    def __init__(self, coefficients, lo, hi):
        self.c, self.lo, self.hi = [Fraction(c) for c in coefficients], lo, hi
        self.low = self.at(lo)

    def at(self, x):
        out = Fraction(0)
        for c in reversed(self.c):
            out = out * x + c
        return out

    def interval(self, p):
        while (self.hi - self.lo) * (1 << p) > 1:
            middle = (self.lo + self.hi) / 2
            v = self.at(middle)
            if v == 0:
                self.lo = self.hi = middle
            elif (v > 0) == (self.low > 0):
                self.lo = middle
            else:
                self.hi = middle
        n, d = self.lo.numerator << p, self.lo.denominator
        m, e = self.hi.numerator << p, self.hi.denominator
        return n // d, -((-m) // e)


def lift(v):
    if isinstance(v, Alg):
        return v
    v = Fraction(v)
    return Alg("q", v, None, max(abs(v.numerator).bit_length(), 1), v.denominator.bit_length(), frozenset())


def root_of(coefficients, lo, hi):
    """A root of an integer polynomial of which it is known that exactly one lies between lo and hi."""
    shape = RootOf(coefficients, lo, hi)
    lead = abs(int(coefficients[-1]))
    # lead*root is an algebraic integer; conjugates of the root are at most 1 + max|c_i/lead|
    bound = lead + max(abs(int(c)) for c in coefficients)
    key = ("of", tuple(coefficients), lo, hi)
    degree = len(coefficients) - 1
    return Alg("root", shape, None, bound.bit_length(), lead.bit_length(), frozenset([(key, degree)]))


def sign(v):
    if isinstance(v, (Fraction, int)):
        return (v > 0) - (v < 0)
    return v.sign()


def square_root(v):
    """The root of a value that is not negative."""
    if not isinstance(v, (Fraction, Alg)):
        return v.square_root()
    if isinstance(v, Fraction):
        n, d = isqrt(v.numerator), isqrt(v.denominator)
        if n * n == v.numerator and d * d == v.denominator:
            return Fraction(n, d)
    elif v.sign() == 0:
        return Fraction(0)
    a = lift(v)
    key = ("sqrt", v if isinstance(v, Fraction) else id(v))
    return Alg("sqrt", a, None, (a.u + a.l + 1) // 2, a.l, a.roots | {(key, 2)})
