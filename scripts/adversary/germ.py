"""The ordered field of rational functions of t, read for all small t > 0.

A statement that holds over this field at x = a + t holds at all points near a on the right, and the
other way round. So guards, definedness and signs along a limit are decided exactly, and the limit is
read from the leading terms.
"""

from fractions import Fraction
from math import isqrt

from algebraic import Costly

INFINITE = "oo"


def _trim(p):
    while p and p[-1] == 0:
        p.pop()
    return p


def _plus(p, q):
    if len(p) < len(q):
        p, q = q, p
    out = list(p)
    for i, c in enumerate(q):
        out[i] += c
    return _trim(out)


def _times(p, q):
    if not p or not q:
        return []
    out = [Fraction(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        if a:
            for j, b in enumerate(q):
                out[i + j] += a * b
    return _trim(out)


def _rest(p, q):
    p = list(p)
    while len(p) >= len(q):
        f = p[-1] / q[-1]
        shift = len(p) - len(q)
        for i, c in enumerate(q):
            p[shift + i] -= f * c
        p.pop()
        _trim(p)
    return p


def _quotient(p, q):
    p, out = list(p), [Fraction(0)] * (len(p) - len(q) + 1)
    for k in range(len(p) - len(q), -1, -1):
        f = p[k + len(q) - 1] / q[-1]
        out[k] = f
        for i, c in enumerate(q):
            p[k + i] -= f * c
    return _trim(out)


def _gcd(p, q):
    while q:
        p, q = q, _rest(p, q)
    return [c / p[-1] for c in p]


def _first(p):
    """The order of the lowest term."""
    return next(i for i, c in enumerate(p) if c)


class Germ:
    """num/den, polynomials in t from the lowest coefficient; den is not zero."""

    __slots__ = ("n", "d")

    def __init__(self, n, d=None):
        d = [Fraction(1)] if d is None else d
        if not n:
            d = [Fraction(1)]
        elif len(n) > 8 and len(d) > 8:
            g = _gcd(n, d)
            n, d = _quotient(n, g), _quotient(d, g)
        elif n and d[0] == 0 and n[0] == 0:
            k = min(_first(n), _first(d))
            n, d = n[k:], d[k:]
        self.n, self.d = n, d

    def __add__(self, other):
        o = germ(other)
        if self.d == o.d:
            return Germ(_plus(self.n, o.n), self.d)
        return Germ(_plus(_times(self.n, o.d), _times(o.n, self.d)), _times(self.d, o.d))

    __radd__ = __add__

    def __neg__(self):
        return Germ([-c for c in self.n], self.d)

    def __sub__(self, other):
        return self + (-germ(other))

    def __rsub__(self, other):
        return (-self) + other

    def __mul__(self, other):
        o = germ(other)
        return Germ(_times(self.n, o.n), _times(self.d, o.d))

    __rmul__ = __mul__

    def __truediv__(self, other):
        o = germ(other)
        return Germ(_times(self.n, o.d), _times(self.d, o.n))

    def __rtruediv__(self, other):
        return germ(other) / self

    def sign(self):
        if not self.n:
            return 0
        return 1 if (self.n[_first(self.n)] > 0) == (self.d[_first(self.d)] > 0) else -1

    def limit(self):
        """A rational, or '+oo' or '-oo'."""
        if not self.n:
            return Fraction(0)
        a, b = _first(self.n), _first(self.d)
        if a > b:
            return Fraction(0)
        if a == b:
            return self.n[a] / self.d[b]
        return "+oo" if self.sign() > 0 else "-oo"

    def square_root(self):
        """Only of a square, or of a constant square; other roots are followed by numbers."""
        if not self.n:
            return self
        g = _gcd(self.n, self.d)
        n, d = _quotient(self.n, g), _quotient(self.d, g)
        product = _times(n, d)
        r = _poly_root(product)
        if r is None:
            raise Costly
        out = Germ(r, d)
        return out if out.sign() >= 0 else -out


def _poly_root(p):
    """The square root of a polynomial, if it is one with rational coefficients."""
    if len(p) % 2 == 0:
        return None
    lead = p[-1]
    if lead <= 0:
        return None
    a, b = isqrt(lead.numerator), isqrt(lead.denominator)
    if a * a != lead.numerator or b * b != lead.denominator:
        return None
    k = len(p) // 2
    r = [Fraction(0)] * (k + 1)
    r[k] = Fraction(a, b)
    for i in range(k - 1, -1, -1):
        known = sum((r[j] * r[k + i - j] for j in range(i + 1, k)), Fraction(0))
        r[i] = (p[k + i] - known) / (2 * r[k])
    return r if _times(r, r) == _trim(list(p)) else None


def germ(v):
    if isinstance(v, Germ):
        return v
    if not isinstance(v, (Fraction, int)):
        raise Costly
    v = Fraction(v)
    return Germ([v] if v else [])


def approach(point, side):
    """x along the germ: point is a Fraction, '+oo' or '-oo'; side is +1 or -1 for a Fraction."""
    if point == "+oo":
        return Germ([Fraction(1)], [Fraction(0), Fraction(1)])
    if point == "-oo":
        return Germ([Fraction(-1)], [Fraction(0), Fraction(1)])
    return Germ(_trim([Fraction(point), Fraction(side)]))
