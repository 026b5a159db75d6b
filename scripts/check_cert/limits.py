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

    def differs():
        found = []
        for region, value in pieces.pieces(f):
            if value is not None:
                gap = add(multiply(den, value[0]), negative(multiply(num, value[1])))
                region = (*region, ring.condition(gap, "!=0"))
            found.append(region)
        return found

    state = state_along(goal, germ, local)
    proof.check(part_along, state.conditions, [*state.formulas, cache(differs)])
    num_end = ring.coefficient(num, "t:", 0)

    def misses():
        den_end = ring.coefficient(den, "t:", 0)
        found = [(ring.condition(den_end, "=0"),)]
        for region, value in pieces.pieces(limit):
            if value is not None:
                gap = add(multiply(num_end, value[1]), negative(multiply(value[0], den_end)))
                region = (*region, ring.condition(gap, "!=0"))
            found.append(region)
        return found

    def wrong_sign():
        product = multiply(num_end, ring.coefficient(den, "t:", order))
        return [(ring.condition(negative(product) if limit == "oo" else product, ">=0"),)]

    if isinstance(limit, tuple):
        demand(order == 0, "the order of a finite limit is 0")
    else:
        demand(order > 0, "the order of an infinite limit is not 0")
        for n in range(min(order, 1 << 12)):
            demand(not ring.coefficient(den, "t:", n), "the denominator does not vanish to its order")
        demand(order < 1 << 12, "the order is too large")
    formula = misses if isinstance(limit, tuple) else wrong_sign
    proof.check(at_zero, constants.conditions, [*constants.formulas, cache(formula)], passes)
    return germ, local
