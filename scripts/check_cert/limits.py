"""Limits, side by side (section 7)."""

from functools import cache

from .errors import demand
from .evidence import count, keys, listed, polynomial
from .germ import along, open_germ
from .polynomial import add, multiply, negative
from .proof import allowed_at_end


def prove_link(proof, sides):
    """Checks the proof of a limit that is claimed."""
    goal = proof.goal
    claim, (_, f, limit) = goal.claim, goal.link
    state = goal.constants(claim.variable)
    for side, above in zip(listed(sides, len(claim.sides)), claim.sides):

        def opened(germ):
            return open_germ(proof, germ, state.conditions, state.formulas, claim.variable)

        germ, local = check_side(proof, side, f, limit, opened, state, along, goal.pieces, claim.variable)
        demand(germ.is_premised(claim) and germ.above == above, "a proof of another side")


def check_side(proof, side, f, limit, opened, constants, state_along, pieces, passes):
    """Checks one side: what f is along a germ, and what that is at its end."""
    goal, ring = proof.goal, proof.ring
    germ, num, den, order, part_along, at_zero = keys(
        side, "germ", "num", "den", "order", "along", "at_zero"
    )
    germ, local = opened(germ)
    num, den, order = polynomial(num, ring), polynomial(den, ring), count(order)
    allowed_at_end(goal, germ, num)
    allowed_at_end(goal, germ, den)

    state = state_along(goal, germ, local)
    formula = cache(lambda: differs(goal, pieces, f, num, den))
    proof.check(part_along, state.conditions, [*state.formulas, formula])
    if isinstance(limit, tuple):
        demand(order == 0, "the order of a finite limit is 0")
    else:
        demand(0 < order < 1 << 12, "the order of an infinite limit is 0, or too large")
        for n in range(order):
            demand(not ring.coefficient(den, "t:", n), "the denominator does not vanish to its order")
    end = misses if isinstance(limit, tuple) else wrong_sign
    formula = cache(lambda: end(goal, pieces, limit, num, den, order))
    proof.check(at_zero, constants.conditions, [*constants.formulas, formula], passes)
    return germ, local


def differs(goal, pieces, f, num, den):
    """The cases in which f is undefined, or not num/den."""
    found = []
    for region, value in pieces.pieces(f):
        if value is not None:
            gap = add(multiply(den, value[0]), negative(multiply(num, value[1])))
            region = (*region, goal.ring.condition(gap, "!=0"))
        found.append(region)
    return found


def misses(goal, pieces, limit, num, den, _):
    """The cases in which num/den does not end at a finite limit."""
    num, den = (goal.ring.coefficient(p, "t:", 0) for p in (num, den))
    found = [(goal.ring.condition(den, "=0"),)]
    for region, value in pieces.pieces(limit):
        if value is not None:
            gap = add(multiply(num, value[1]), negative(multiply(value[0], den)))
            region = (*region, goal.ring.condition(gap, "!=0"))
        found.append(region)
    return found


def wrong_sign(goal, _, limit, num, den, order):
    """The case in which num/den does not grow to an infinite limit."""
    ring = goal.ring
    product = multiply(ring.coefficient(num, "t:", 0), ring.coefficient(den, "t:", order))
    return [(ring.condition(negative(product) if limit == "oo" else product, ">=0"),)]
