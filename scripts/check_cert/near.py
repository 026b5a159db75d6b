"""What an expression is near a point, and derivatives (section 4)."""

from .errors import Rejected
from .polynomial import ONE, ZERO, constant, is_constant, multiply, negative
from .ratio import minus, plus, sign_of, times

KINK = "kink"


class Near:
    """The part of cutting expressions that looks at a neighbourhood.

    A value near a point is a fraction with the radicands of the roots in it.
    """

    def derivative_pieces(self, expression):
        """The pieces of a derivative at a point."""
        _, inner, variable = expression
        return [
            (region, value and self.derivative(value, variable)[0])
            for region, value in self.near(inner, frozenset((variable,)), True)
        ]

    def near(self, expression, variables, smooth):
        """The pieces of an expression near a point, some variables being varied."""
        key = (id(expression), variables, smooth)
        if key not in self.near_known:
            self.near_known[key] = (self.cut_near(expression, variables, smooth), expression)
        return self.near_known[key][0]

    def free(self, value, variables):
        """Does a fraction not change with the variables?"""
        fraction, radicands = value
        return KINK not in radicands and all(self.free_polynomial(p, radicands, variables) for p in fraction)

    def free_polynomial(self, p, radicands, variables):
        for name in self.ring.variables(p):
            if name in variables:
                return False
            if name in radicands and not self.free((radicands[name], radicands), variables):
                return False
        return True

    def with_radicands(self, pieces, radicands):
        """Pieces of an operation, whose roots are those of its parts."""
        return [(region, value and (value, radicands)) for region, value in pieces]

    def near_both(self, left, right, variables, smooth, operation):
        right = self.near(right, variables, smooth)

        def inside(a):
            return self.go_on(right, lambda b: operation(a[0], b[0], {**b[1], **a[1]}))

        return self.go_on(self.near(left, variables, smooth), inside)

    def cut_near(self, expression, variables, smooth):
        kind = expression[0]
        if kind == "sym":
            return self.symbol_near(expression[1], variables, smooth)
        if kind == "num":
            return self.with_radicands(self.pieces(expression), {})
        if kind == "def":
            return self.near(self.document.symbols[expression[1]].body, variables, smooth)
        if kind == "d":
            _, inner, variable = expression
            return [
                (region, value and self.derivative(value, variable))
                for region, value in self.near(inner, variables | {variable}, True)
            ]
        if kind == "cases":
            return self.branches_near(expression[1], expression[2], variables, smooth)
        if smooth and kind in ("abs", "min", "max"):
            return self.near(self.as_cases(expression), variables, True)
        if kind == "sqrt":
            return self.go_on(
                self.near(expression[1], variables, smooth),
                lambda a: self.root_near(expression[1], a, variables),
            )
        if kind in ("abs", "min", "max"):
            return self.kinked(expression, variables)
        if kind in ("neg", "pow"):
            operation = {
                "neg": lambda a: self.one(minus(a)),
                "pow": lambda a: self.raised(a, expression[2]),
            }[kind]
            return self.go_on(
                self.near(expression[1], variables, smooth),
                lambda a: self.with_radicands(operation(a[0]), a[1]),
            )
        operation = self.operation(kind)
        return self.near_both(
            expression[1], expression[2], variables, smooth,
            lambda a, b, radicands: self.with_radicands(operation(a, b), radicands),
        )

    def kinked(self, expression, variables):
        """abs, min and max, which are continuous where their parts are.

        The piece that holds at a kink is not all that there is near it. So
        what is made from it counts as changing, even if no variable is left.
        """
        kind, left, right = (*expression, ("num", 0, 1))[:3]

        def operation(a, b, radicands):
            gap = a if kind == "abs" else plus(a, minus(b))
            if not self.free((gap, radicands), variables):
                radicands = {**radicands, KINK: True}
            pieces = self.absolute(a) if kind == "abs" else self.operation(kind)(a, b)
            return self.with_radicands(pieces, radicands)

        return self.near_both(left, right, variables, False, operation)

    def symbol_near(self, name, variables, smooth):
        if name in variables:
            if name in self.values:
                raise Rejected(f"`{name}` has a value, and something is differentiated by it")
        elif name in self.values:
            return self.near(self.values[name], variables, smooth)
        elif self.document.symbols[name].argument in variables:
            raise Rejected(f"`{name}` is not explicit in a derivative")
        return [((), ((self.ring.variable(name), ONE), {}))]

    def as_cases(self, expression):
        """abs, min and max as the cases that they stand for."""
        kind, a, *rest = expression
        b, last = (("num", 0, 1), ("neg", a)) if kind == "abs" else (rest[0], rest[0])
        guard = ("<=" if kind == "min" else ">=", a, b)
        return ("cases", (((guard,), a),), last)

    def root_near(self, radicand, a, variables):
        name = self.root_name(radicand)
        radicands = {name: a[0], **a[1]}
        pieces = self.root(name, a[0], strict=not self.free(a, variables))
        return self.with_radicands(pieces, radicands)

    def branches_near(self, branches, last, variables, smooth):
        if not branches:
            return self.one(None) if last is None else self.near(last, variables, smooth)
        guard, body = branches[0]

        def taken(truth):
            if truth:
                return self.near(body, variables, smooth)
            return self.branches_near(branches[1:], last, variables, smooth)

        return self.go_on(self.truth_near(guard, variables), taken)

    def truth_near(self, relations, variables):
        """The truth of a guard that does not change near the point."""
        pieces = self.one(True)
        for sign, left, right in relations:
            if sign in ("<", "<="):
                left, right, sign = right, left, sign.replace("<", ">")

            def compare(a, b, radicands):
                return self.compare_near(sign, a, b, radicands, variables)

            def further(so_far):
                if not so_far:
                    return self.one(False)
                return self.near_both(left, right, variables, False, compare)

            pieces = self.go_on(pieces, further)
        return pieces

    def compare_near(self, sign, a, b, radicands, variables):
        gap = plus(a, minus(b))
        if self.free((gap, radicands), variables):
            return self.compare(sign, gap)
        size = sign_of(gap)
        condition = self.ring.condition
        return [
            ((condition(size, ">0"),), sign != "="),
            ((condition(negative(size), ">0"),), sign == "!="),
            ((condition(gap[0], "=0"),), None),
        ]

    def derivative(self, value, variable):
        """The derivative of a fraction, with the radicands as they were."""
        (numerator, denominator), radicands = value
        if is_constant(denominator):
            slope = times(self.slope(numerator, radicands, variable), (ONE, denominator))
            return slope, radicands
        left = times(self.slope(numerator, radicands, variable), (denominator, ONE))
        right = times((numerator, ONE), self.slope(denominator, radicands, variable))
        square = multiply(denominator, denominator)
        return times(plus(left, minus(right)), (ONE, square)), radicands

    def slope(self, p, radicands, variable):
        """The derivative of a polynomial, as a fraction."""
        present, total = self.ring.variables(p), None
        if variable in present:
            total = (self.ring.derivative(p, variable), ONE)
        for name in self.roots.values():  # in their order
            if name not in present:
                continue
            if self.free((radicands[name], radicands), (variable,)):
                continue
            inner, _ = self.derivative((radicands[name], radicands), variable)
            root = self.ring.variable(name)
            chain = times(inner, (ONE, multiply(constant(2), root)))
            part = times((self.ring.derivative(p, name), ONE), chain)
            total = part if total is None else plus(total, part)
        return total or (ZERO, ONE)
