"""Writes limit proofs and functions for the tests, from what is told by hand."""

from check_cert.evidence import polynomial
from check_cert.functions import Functions
from check_cert.germ import along, constant_conditions, inside_range, owes, out_of_range, read_germ
from check_cert.goal import Goal, State
from check_cert.limits import differs, misses, wrong_sign
from check_cert.proof import Proof

from .prover import find_link, prove

ONE_P = [["1", {}]]


def p(*terms):
    """A polynomial of the file: terms (coefficient, variable, exponent, …)."""
    found = []
    for value, *rest in terms:
        found.append([str(value), dict(zip(rest[::2], rest[1::2]))])
    return sorted(found, key=lambda term: sorted(term[1].items()))


def write_germ(goal, state, variable, at, above, values=None, radius=None, functions=None, domain=False):
    """A germ; `values` are those for each `given` that is owed a proof."""
    germ = {
        "variable": variable, "at": at, "above": above, "radius": radius or [ONE_P, ONE_P],
        "positive": None, "inside": [],
    }
    read, _, below, _ = read_germ(goal, germ)
    germ["positive"] = prove(goal, state.conditions, [*state.formulas, lambda: below])
    local = constant_conditions(goal, variable, state.conditions)
    if functions is None:
        for given in [s for s in goal.cited + goal.behind if owes(goal, s, read)]:
            chosen = (values or {}).get(given.label, {})
            inner = inside_range(goal, read, local, given, chosen)
            part = prove(goal, inner.conditions, inner.formulas)
            germ["inside"].append({"given": given.label, "values": chosen, "proof": part})
    elif domain:
        conditions = functions.along(goal, read, []).conditions
        for given in filter(functions.narrowing, goal.cited):
            cases = functions.narrow(given, False, None)
            part = prove(goal, conditions, [lambda: cases])
            germ["inside"].append({"given": given.label, "values": {}, "proof": part})
    return germ, read, local


def write_side(goal, f, limit, num, den, order, germ, state, state_along, pieces):
    """A side proof along a germ that has been written."""
    written, read, local = germ
    a, b = polynomial(num, goal.ring), polynomial(den, goal.ring)
    inner = state_along(goal, read, local)
    end = misses if isinstance(limit, tuple) else wrong_sign
    return {
        "germ": written, "num": num, "den": den, "order": order,
        "along": prove(goal, inner.conditions, [*inner.formulas, lambda: differs(goal, pieces, f, a, b)]),
        "at_zero": prove(
            goal, state.conditions, [*state.formulas, lambda: end(goal, pieces, limit, a, b, order)]
        ),
    }


def limit_link(*sides, roots=()):
    """A link that is a limit, proved: (num, den, order, values, radius) for each side."""
    def link(document, claim, item):
        goal = Goal(document, claim, item, "proved", "cited", list(roots))
        state = goal.constants(claim.variable)
        written = []
        for above, (num, den, order, *more) in zip(claim.sides, sides):
            at = None if claim.at is None else str(claim.at)
            germ = write_germ(goal, state, claim.variable, at, above, *more)
            written.append(
                write_side(goal, item[1], item[2], num, den, order, germ, state, along, goal.pieces)
            )
        return {
            "finding": "proved", "premises": "cited", "roots": list(roots),
            "evidence": {"sides": written},
        }
    return link


def functions_link(finding, variable, values, failure, premises=()):
    """A witness by functions. `premises`: for each limit of a cited statement its sides.

    `failure` is a point, or (k, above, to, num, den, order).
    """
    def link(document, claim, item):
        goal = Goal(document, claim, item, finding, "cited", [])
        written = {
            "variable": variable, "values": values, "ranges": [], "premises": [], "failure": {},
        }
        functions = Functions(Proof(goal), written)
        conditions = goal.range_of(variable)
        for name in functions.names:
            cases = out_of_range(functions.pieces, functions.values[name], document.symbols[name])
            written["ranges"].append(prove(goal, conditions, [*functions.domain, lambda: cases]))
        told, empty = iter(premises), State([], [])

        def one_side(at, above, f, limit, num, den, order, domain):
            germ = write_germ(goal, empty, variable, at, above, functions=functions, domain=domain)
            return write_side(
                goal, f, limit, num, den, order, germ, empty, functions.along, functions.pieces
            )

        for statement in goal.cited:
            part, limits = None, []
            if len(functions.narrowing(statement)) < len(statement.relations):
                cases = goal.fails(statement, functions.pieces, statement.kind)
                part = prove(goal, conditions, [*functions.domain, lambda: cases])
            at = None if statement.at is None else str(statement.at)
            for _, f, limit in statement.limits:
                limits.append(
                    [one_side(at, above, f, limit, *next(told), False) for above in statement.sides]
                )
            written["premises"].append({"proof": part, "limits": limits})
        if isinstance(failure, dict):
            written["failure"] = {"at": failure}
        else:
            number, above, to, num, den, order = failure
            statement = claim.other or claim
            at = None if statement.at is None else str(statement.at)
            limit = to if to in ("oo", "-oo") else document.expression(to)
            f = statement.limits[number][1] if claim.other else item[1]
            side = one_side(at, above, f, limit, num, den, order, True)
            written["failure"] = {"limit": number, "to": to, "side": side}
        return {
            "finding": finding, "premises": "cited", "roots": [],
            "evidence": {"functions": written},
        }
    return link


def pass_link(finding, *steps):
    """A proof that passes to limits first, and then finds its way.

    Each step is (variable, at, above), a polynomial, its sign, and values for the range.
    """
    def link(document, claim, item):
        goal = Goal(document, claim, item, finding, "cited", [])
        proof = write_passes(goal, goal.at_point(finding), steps)
        return {
            "finding": finding, "premises": "cited", "roots": [], "evidence": {"proof": proof},
        }
    return link


def write_passes(goal, state, steps):
    if not steps:
        return prove(goal, state.conditions, state.formulas)
    (place, poly, sign, values), *steps = steps
    written, read, local = write_germ(goal, state, *place, values)
    inner = along(goal, read, local)
    part = goal.ring.condition(polynomial(poly, goal.ring), sign)
    end = goal.ring.condition(goal.ring.coefficient(part.poly, "t:", 0), sign)
    return {
        "pass": written, "condition": {"poly": poly, "is": sign},
        "along": prove(goal, [*inner.conditions, goal.ring.opposite(part)], inner.formulas),
        "then": write_passes(goal, State([*state.conditions, end], state.formulas), steps),
    }


__all__ = ["find_link", "functions_link", "limit_link", "p", "pass_link"]
