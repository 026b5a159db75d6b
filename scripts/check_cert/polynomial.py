"""Integer polynomials, and conditions on them.

A polynomial is a dictionary from monomials to integers other than 0. A
monomial is one integer: 16 bits for its degree, then 16 for the exponent of
each variable, so that monomials are multiplied by adding them. Degrees stay
below 2^15, hence no exponent ever reaches its neighbour.
"""

from .errors import demand

BITS = 16
FIELD = (1 << BITS) - 1
LIMIT = 1 << (BITS - 1)
ZERO, ONE = {}, {0: 1}
OPPOSITE = {"=0": "!=0", "!=0": "=0", ">=0": ">0", ">0": ">=0"}


def constant(value):
    """The polynomial of an integer."""
    return {0: value} if value else {}


def degree(p):
    """The degree; 0 for a constant."""
    return max((m & FIELD for m in p), default=0)


def is_constant(p):
    return not p or (len(p) == 1 and 0 in p)


def add(p, q):
    if len(p) < len(q):
        p, q = q, p
    found = dict(p)
    for monomial, value in q.items():
        value += found.get(monomial, 0)
        if value:
            found[monomial] = value
        else:
            del found[monomial]
    return found


def negative(p):
    return {monomial: -value for monomial, value in p.items()}


def add_product(total, p, q):
    """Adds p·q to a dictionary in place; zeros may remain in it."""
    if len(p) > len(q):
        p, q = q, p
    demand(degree(p) + degree(q) < LIMIT, "a degree is too large")
    get, terms = total.get, q.items()
    for monomial, value in p.items():
        for other, factor in terms:
            key = monomial + other
            total[key] = get(key, 0) + value * factor


def multiply(p, q):
    if p == ONE:
        return q
    if q == ONE:
        return p
    total = {}
    add_product(total, p, q)
    return {monomial: value for monomial, value in total.items() if value}


def power(p, n):
    """p to the power of n >= 0."""
    demand(degree(p) * n < LIMIT and n < LIMIT, "a power is too large")
    result = ONE
    for bit in bin(n)[2:]:
        result = multiply(result, result)
        if bit == "1":
            result = multiply(result, p)
    return result


class Condition:
    """A polynomial with the sign that it has to have."""

    __slots__ = ("poly", "sign", "opposite", "powers")

    def __init__(self, poly, sign):
        self.poly, self.sign, self.opposite, self.powers = poly, sign, None, [ONE, poly]

    def power(self, n):
        """A power of its polynomial, kept for the next time."""
        demand(n < LIMIT, "a power is too large")
        while len(self.powers) <= n:
            self.powers.append(multiply(self.powers[-1], self.poly))
        return self.powers[n]

    def constant_truth(self):
        """Whether it holds, if its polynomial is a constant; else None."""
        return holds(self.poly.get(0, 0), self.sign) if is_constant(self.poly) else None


def holds(value, sign):
    """Does a number have this sign?"""
    if sign == "=0":
        return value == 0
    if sign == "!=0":
        return value != 0
    return value >= 0 if sign == ">=0" else value > 0


class Ring:
    """The variables that may occur, and the conditions that have occurred."""

    def __init__(self, names):
        self.allowed = frozenset(names)
        self.names, self.shifts, self.conditions = [], {}, {}

    def shift(self, name):
        """Where the exponent of a variable stands in a monomial."""
        if name not in self.shifts:
            demand(name in self.allowed, f"`{name}` is not known here")
            self.names.append(name)
            self.shifts[name] = BITS * len(self.names)
        return self.shifts[name]

    def unnamed(self):
        """A new variable, which no evidence can name."""
        name = f"unnamed {len(self.names)}"
        self.names.append(name)
        self.shifts[name] = BITS * len(self.names)
        return name

    def variable(self, name):
        """The polynomial of a variable."""
        return {(1 << self.shift(name)) + 1: 1}

    def exponents(self, monomial):
        """Pairs of a variable's name and its exponent."""
        number, monomial = 0, monomial >> BITS
        while monomial:
            if monomial & FIELD:
                yield self.names[number], monomial & FIELD
            number, monomial = number + 1, monomial >> BITS

    def variables(self, p):
        """The names of the variables in a polynomial."""
        union = 0
        for monomial in p:
            union |= monomial
        return {name for name, _ in self.exponents(union)}

    def derivative(self, p, name):
        """The derivative by a variable, the others being constants."""
        shift = self.shift(name)
        step, found = (1 << shift) + 1, {}
        for monomial, value in p.items():
            n = monomial >> shift & FIELD
            if n:
                found[monomial - step] = n * value
        return found

    def coefficient(self, p, name, n):
        """The coefficient of a power of a variable."""
        shift = self.shift(name)
        return {
            monomial - (n << shift) - n: value
            for monomial, value in p.items()
            if monomial >> shift & FIELD == n
        }

    def condition(self, poly, sign):
        """The condition, one object for all that are equal."""
        key = (sign, frozenset(poly.items()))
        found = self.conditions.get(key)
        if found is None:
            found = self.conditions[key] = Condition(poly, sign)
        return found

    def opposite(self, condition):
        """What holds where a condition does not."""
        if condition.opposite is None:
            flip = condition.sign in (">=0", ">0")
            poly = negative(condition.poly) if flip else condition.poly
            condition.opposite = self.condition(poly, OPPOSITE[condition.sign])
            condition.opposite.opposite = condition
        return condition.opposite
