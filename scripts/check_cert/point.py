"""Points: rational ones, and those of one real algebraic number (section 7)."""

from fractions import Fraction

from .errors import demand
from .evidence import coefficients, integer, keys, rational
from .polynomial import holds


def check_point(goal, value, names, optional, conditions, formulas):
    """The point satisfies all conditions and one case of each formula."""
    theta, values = keys(value, "theta", "values")
    number = Rational() if theta is None else Algebraic(theta)
    demand(isinstance(values, dict) and set(names) <= set(values), "not each variable has a value")
    demand(set(values) <= {*names, *optional}, "what is not mentioned has a value")
    point = {name: number.reduce(coefficients(values[name], rational)) for name in values}
    known = {}

    def true(condition):
        if condition not in known:
            poly = evaluate(goal.ring, condition.poly, point, number)
            known[condition] = holds(number.sign(poly), condition.sign)
        return known[condition]

    demand(all(map(true, conditions)), "the point is outside the domain")
    for number_of, formula in enumerate(formulas):
        demand(
            any(all(map(true, region)) for region in formula()),
            f"formula {number_of} does not hold at the point",
        )


def evaluate(ring, poly, point, number):
    """The value of a polynomial: coefficients of powers of theta."""
    total, powers = [], {}
    for monomial, coefficient in poly.items():
        product = [Fraction(coefficient)]
        for name, n in ring.exponents(monomial):
            demand(name in point, f"`{name}` has no value")
            if (name, n) not in powers:
                powers[name, n] = power(point[name], n, number)
            product = number.reduce(multiply(product, powers[name, n]))
        total = add(total, product)
    return total


def trimmed(p):
    while p and not p[-1]:
        p.pop()
    return p


def add(p, q):
    if len(p) < len(q):
        p, q = q, p
    return trimmed([a + (q[i] if i < len(q) else 0) for i, a in enumerate(p)])


def multiply(p, q):
    found = [Fraction(0)] * max(len(p) + len(q) - 1, 0)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            found[i + j] += a * b
    return trimmed(found)


def power(p, n, number):
    result = [Fraction(1)]
    for bit in bin(n)[2:]:
        result = number.reduce(multiply(result, result))
        if bit == "1":
            result = number.reduce(multiply(result, p))
    return result


def remainder(p, q):
    """The remainder of p by q, and the quotient."""
    p, quotient = list(p), [Fraction(0)] * max(len(p) - len(q) + 1, 0)
    while len(p) >= len(q):
        factor, shift = p[-1] / q[-1], len(p) - len(q)
        quotient[shift] = factor
        for i, a in enumerate(q):
            p[i + shift] -= factor * a
        p = trimmed(p[:-1])
    return p, quotient


def common(p, q):
    """The greatest common divisor, with leading coefficient 1."""
    while q:
        p, q = q, remainder(p, q)[0]
    return [a / p[-1] for a in p]


def at(p, x):
    value = Fraction(0)
    for a in reversed(p):
        value = value * x + a
    return value


def slope(p):
    return [a * i for i, a in enumerate(p)][1:]


def sign_changes(chain, x):
    signs = [value > 0 for value in (at(p, x) for p in chain) if value]
    return sum(a != b for a, b in zip(signs, signs[1:]))


def roots_between(p, low, high):
    """How many different roots are between two numbers that are none (Sturm)."""
    chain = [p, slope(p)]
    while chain[-1]:
        chain.append([-a for a in remainder(chain[-2], chain[-1])[0]])
    chain.pop()
    return sign_changes(chain, low) - sign_changes(chain, high)


class Rational:
    """No algebraic number: values are constants."""

    def reduce(self, p):
        demand(len(p) <= 1, "a power of theta, and there is no theta")
        return p

    def sign(self, p):
        return p[0] if p else 0


class Algebraic:
    """The only root of a polynomial in an interval."""

    def __init__(self, theta):
        poly, low, high = keys(theta, "poly", "from", "to")
        poly = [Fraction(a) for a in coefficients(poly, integer)]
        self.low, self.high = rational(low), rational(high)
        demand(len(poly) > 1 and self.low < self.high, "theta is not well formed")
        square_free = remainder(poly, common(poly, slope(poly)))[1]
        self.poly = trimmed(square_free)
        demand(at(poly, self.low) and at(poly, self.high), "theta's polynomial vanishes at an end")
        demand(roots_between(self.poly, self.low, self.high) == 1, "theta is not the only root")
        self.rises = at(self.poly, self.high) > 0

    def reduce(self, p):
        return remainder(p, self.poly)[0] if len(p) >= len(self.poly) else p

    def sign(self, p):
        """The sign at theta: zero, or known from a narrow interval."""
        if len(p) <= 1:
            return p[0] if p else 0
        divisor = common(self.poly, p)
        if len(divisor) > 1 and roots_between(divisor, self.low, self.high):
            return 0
        while True:
            low, high = self.enclosed(p)
            if low > 0 or high < 0:
                return low if low > 0 else high
            self.halve()

    def enclosed(self, p):
        """Bounds of p on the interval."""
        low = high = Fraction(0)
        for a in reversed(p):
            ends = [low * self.low, low * self.high, high * self.low, high * self.high]
            low, high = min(ends) + a, max(ends) + a
        return low, high

    def halve(self):
        middle = (self.low + self.high) / 2
        value = at(self.poly, middle)
        if not value:  # theta is rational: keep it inside
            quarter = (self.high - self.low) / 4
            self.low, self.high = middle - quarter, middle + quarter
        elif (value > 0) == self.rises:
            self.high = middle
        else:
            self.low = middle
