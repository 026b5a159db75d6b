"""Limits, side by side (section 7)."""

from functools import cache

from .errors import demand
from .evidence import count, keys, listed, optional, polynomial
from .germ import along, constant_names, open_germ
from .polynomial import add, multiply, negative
from .proof import allowed_at_end


def prove_by_cases(proof, evidence, statement, f, limit, passes, known=()):
    """Checks the evidence for a limit of a statement: in each case of constants one proof a side, or that it cannot be."""
    goal, variable = proof.goal, statement.variable
    demand(isinstance(evidence, dict), "a proof of each side is expected")
    if "split" in evidence:
        poly = polynomial(evidence["split"], goal.ring)
        demand(goal.ring.variables(poly) <= constant_names(goal, variable), "the cases are not those of constants")
        for part, then in proof.cases(evidence):
            prove_by_cases(proof, then, statement, f, limit, passes, (*known, part))
    elif known and "proof" in evidence:
        (part,) = keys(evidence, "proof")
        constants = goal.constants(variable)
        proof.check(part, [*constants.conditions, *known], constants.formulas, passes)
    else:
        (sides,) = keys(evidence, "sides")
        prove_limit(proof, sides, statement, f, limit, passes, known)


def prove_limit(proof, evidence, statement, f, limit, passes=None, known=()):
    """Checks the proof of a limit of a statement: one for each side that is meant."""
    for side, above in zip(listed(evidence, len(statement.sides)), statement.sides):
        germ = check_side(proof, side, f, limit, statement.variable, passes, known)
        demand(germ.is_premised(statement) and germ.above == above, "a proof of another side")


def check_side(proof, side, f, limit, variable, passes=None, known=()):
    """Checks one side: what f is along a germ, or what bounds it there, and what that is at its end."""
    side, upper = optional(side, "upper", None)
    germ, sense = check_bound(proof, side, f, limit, variable, passes, known)
    if upper is None:
        bound = {"oo": ">=", "-oo": "<="}.get(limit) if isinstance(limit, str) else None
        demand(sense in ("=", bound), "a bound on this side shows no limit")
        return germ
    demand(isinstance(limit, tuple), "a limit between two bounds is finite")
    other, opposite = check_bound(proof, upper, f, limit, variable, passes, known)
    demand((sense, opposite) == (">=", "<="), "a lower and an upper bound are expected")
    demand((germ.at, germ.above) == (other.at, other.above), "bounds on one side are expected")
    return germ


def check_bound(proof, side, f, limit, variable, passes, known):
    """Checks how f compares with a quotient along a germ, and what that is at its end; `known` are conditions on constants."""
    goal, ring = proof.goal, proof.ring
    side, sense = optional(side, "sense", "=")
    demand(sense in ("=", ">=", "<="), "a comparison is expected")
    germ, num, den, order, part_along, at_zero = keys(
        side, "germ", "num", "den", "order", "along", "at_zero"
    )
    constants = goal.constants(variable)
    conditions = [*constants.conditions, *known]
    germ, local = open_germ(proof, germ, conditions, constants.formulas, passes)
    demand(germ.variable == variable, "a germ of another variable")
    num, den, order = polynomial(num, ring), polynomial(den, ring), count(order)
    allowed_at_end(goal, germ, num)
    allowed_at_end(goal, germ, den)

    if isinstance(limit, tuple) and not roots(goal.document, limit) <= roots(goal.document, f):
        f = ("add", f, ("mul", ("num", 0, 1), limit))
    state = along(goal, germ, local)
    formula = cache(lambda: differs(goal, f, num, den, sense))
    proof.check(part_along, state.conditions, [*state.formulas, formula])
    if isinstance(limit, tuple):
        demand(order == 0, "the order of a finite limit is 0")
    else:
        demand(0 < order < 1 << 12, "the order of an infinite limit is 0, or too large")
        for n in range(order):
            demand(not ring.coefficient(den, "t:", n), "the denominator does not vanish to its order")
    end = misses if isinstance(limit, tuple) else wrong_sign
    formula = cache(lambda: end(goal, limit, num, den, order))
    proof.check(at_zero, conditions, [*constants.formulas, formula], passes)
    return germ, sense


def roots(document, expression):
    """The radicands of an expression: those of a limit are known only where it is part of what is compared."""
    found = set()
    document.roots(expression, found, set())
    return found


def differs(goal, f, num, den, sense="="):
    """The cases in which f is undefined, or does not compare so with num/den."""

    def unlike(value):
        gap = add(multiply(den, value[0]), negative(multiply(num, value[1])))
        if sense == "=":
            return [((goal.ring.condition(gap, "!=0"),), True)]
        # f > num/den has the sign of the gap times both denominators
        above = multiply(multiply(den, value[1]), gap)
        return [((goal.ring.condition(above if sense == "<=" else negative(above), ">0"),), True)]

    return [region for region, _ in goal.pieces.go_on(goal.pieces.pieces(f), unlike)]


def misses(goal, limit, num, den, _):
    """The cases in which num/den does not end at a finite limit."""
    num, den = (goal.ring.coefficient(p, "t:", 0) for p in (num, den))
    return [*differs(goal, limit, num, den), (goal.ring.condition(den, "=0"),)]


def wrong_sign(goal, limit, num, den, order):
    """The case in which num/den does not grow to an infinite limit."""
    ring = goal.ring
    product = multiply(ring.coefficient(num, "t:", 0), ring.coefficient(den, "t:", order))
    return [(ring.condition(negative(product) if limit == "oo" else product, ">=0"),)]
