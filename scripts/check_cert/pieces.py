"""What an expression is: pieces, each with a fraction or undefined (sections 2 and 3)."""

from .near import Near
from .polynomial import ONE, add, constant, multiply, negative, power
from .ratio import minus, plus, sign_of, times

UNDEFINED = None


class Pieces(Near):
    """Cuts the expressions of a goal into pieces.

    `values` are put in for symbols; `roots` names the variable of each radicand.
    """

    def __init__(self, document, ring, roots, values=None):
        self.document, self.ring, self.roots = document, ring, roots
        self.values = values or {}
        self.known, self.near_known = {}, {}

    def join(self, region, other):
        """Both regions, or None if that is empty as anyone can see."""
        if not other:
            return region
        joined = list(region)
        for condition in other:
            truth = condition.constant_truth()
            if truth is False or (truth is None and self.ring.opposite(condition) in joined):
                return None
            if truth is None and condition not in joined:
                joined.append(condition)
        return tuple(joined)

    def go_on(self, pieces, operation):
        """Goes on from pieces with an operation on their values."""
        found = []
        for region, value in pieces:
            if value is UNDEFINED:
                found.append((region, value))
                continue
            for other, result in operation(value):
                joined = self.join(region, other)
                if joined is not None:
                    found.append((joined, result))
        return found

    def where(self, poly, sign, yes, no):
        """One result where a condition holds, another where it does not."""
        condition = self.ring.condition(poly, sign)
        return [((condition,), yes), ((self.ring.opposite(condition),), no)]

    def one(self, value):
        return [((), value)]

    def both(self, left, right, operation):
        """Goes on from one expression, inside it from another."""
        right = self.pieces(right)
        return self.go_on(
            self.pieces(left), lambda a: self.go_on(right, lambda b: operation(a, b))
        )

    def pieces(self, expression):
        """The pieces of an expression, in order."""
        key = id(expression)
        if key not in self.known:
            self.known[key] = (self.cut(expression), expression)
        return self.known[key][0]

    def cut(self, expression):
        kind = expression[0]
        if kind == "num":
            return self.one((constant(expression[1]), constant(expression[2])))
        if kind == "sym":
            name = expression[1]
            if name in self.values:
                return self.pieces(self.values[name])
            return self.one((self.ring.variable(name), ONE))
        if kind == "def":
            return self.pieces(self.document.symbols[expression[1]].body)
        if kind == "d":
            return self.derivative_pieces(expression)
        if kind == "cases":
            return self.branches(expression[1], expression[2])
        if kind == "neg":
            return self.go_on(self.pieces(expression[1]), lambda a: self.one(minus(a)))
        if kind == "abs":
            return self.go_on(self.pieces(expression[1]), self.absolute)
        if kind == "sqrt":
            return self.go_on(
                self.pieces(expression[1]), lambda a: self.root(self.root_name(expression[1]), a)
            )
        if kind == "pow":
            return self.go_on(self.pieces(expression[1]), lambda a: self.raised(a, expression[2]))
        return self.both(expression[1], expression[2], self.operation(kind))

    def operation(self, kind):
        """What an operation makes of two fractions."""
        return {
            "add": lambda a, b: self.one(plus(a, b)),
            "sub": lambda a, b: self.one(plus(a, minus(b))),
            "mul": lambda a, b: self.one(times(a, b)),
            "div": self.quotient,
            "min": lambda a, b: self.where(sign_of(plus(b, minus(a))), ">=0", a, b),
            "max": lambda a, b: self.where(sign_of(plus(a, minus(b))), ">=0", a, b),
        }[kind]

    def quotient(self, a, b):
        value = multiply(a[0], b[1]), multiply(a[1], b[0])
        return self.where(b[0], "!=0", value, UNDEFINED)

    def raised(self, a, n):
        up = power(a[0], abs(n)), power(a[1], abs(n))
        return self.one(up) if n >= 0 else self.quotient((ONE, ONE), up)

    def absolute(self, a):
        return self.where(sign_of(a), ">=0", a, minus(a))

    def root_name(self, radicand):
        """The variable of a root; evidence cannot name one that is not in the list."""
        if radicand not in self.roots:
            self.roots[radicand] = self.ring.unnamed()
        return self.roots[radicand]

    def root_region(self, name, a, strict=False):
        """Where a root is defined, and what it then is."""
        variable = self.ring.variable(name)
        square = add(multiply(multiply(variable, variable), a[1]), negative(a[0]))
        return (
            self.ring.condition(sign_of(a), ">0" if strict else ">=0"),
            self.ring.condition(variable, ">=0"),
            self.ring.condition(square, "=0"),
        )

    def root(self, name, a, strict=False):
        region = self.root_region(name, a, strict)
        return [
            (region, (self.ring.variable(name), ONE)),
            ((self.ring.opposite(region[0]),), UNDEFINED),
        ]

    def branches(self, branches, last):
        """The first branch whose guard holds."""
        if not branches:
            return self.one(UNDEFINED) if last is None else self.pieces(last)
        guard, body = branches[0]

        def taken(truth):
            return self.pieces(body) if truth else self.branches(branches[1:], last)

        return self.go_on(self.truth(guard), taken)

    def relation(self, sign, left, right):
        """Where a relation is true, false and undefined."""
        if sign in ("<", "<="):
            left, right, sign = right, left, sign.replace("<", ">")
        return self.both(left, right, lambda a, b: self.compare(sign, plus(a, minus(b))))

    def compare(self, sign, gap):
        if sign in ("=", "!="):
            return self.where(gap[0], sign + "0", True, False)
        return self.where(sign_of(gap), sign + "0", True, False)

    def truth(self, relations):
        """The truth of several relations, read from left to right."""
        pieces = self.one(True)
        for sign, left, right in relations:
            found = None

            def further(so_far):
                nonlocal found
                if not so_far:
                    return self.one(False)
                if found is None:
                    found = self.relation(sign, left, right)
                return found

            pieces = self.go_on(pieces, further)
        return pieces

    def statement(self, relations, when):
        """The truth of relations, where conditions hold."""
        conditions = [(region, value is True) for region, value in self.truth(when)]
        return self.go_on(
            conditions, lambda truth: self.truth(relations) if truth else self.one(True)
        )
