"""Writes limit proofs and functions for the tests, from what is told by hand."""

from check_cert.evidence import polynomial
from check_cert.functions import Functions
from check_cert.germ import along, constant_conditions, inside_range, owes, out_of_range, read_germ
from check_cert.goal import Goal, State, sides
from check_cert.limits import differs, misses, wrong_sign
from check_cert.polynomial import negative as negated

from .prover import find_link, prove

ONE_P = [["1", {}]]
PLAIN = (None, None, 1, "=", None)  # values, radius, power, sense and upper bound that go without saying


def p(*terms):
    """A polynomial of the file: terms (coefficient, variable, exponent, …)."""
    found = []
    for value, *rest in terms:
        found.append([str(value), dict(zip(rest[::2], rest[1::2]))])
    return sorted(found, key=lambda term: sorted(term[1].items()))


def write_germ(goal, state, variable, at, above, values=None, radius=None, power=1):
    """A germ; `values` are those for each `given` that is owed a proof."""
    germ = {
        "variable": variable, "at": at, "above": above, "radius": radius or [ONE_P, ONE_P],
        "positive": None, "inside": [],
    }
    if power != 1:
        germ["power"] = power
    read, _, below, _ = read_germ(goal, germ)
    germ["positive"] = prove(goal, state.conditions, [*state.formulas, lambda: below])
    local = constant_conditions(goal, variable, state.conditions)
    for given in [s for s in goal.cited + goal.behind if owes(goal, s, read)]:
        chosen = (values or {}).get(given.label, {})
        inner = inside_range(goal, read, local, given, chosen)
        part = prove(goal, inner.conditions, inner.formulas)
        germ["inside"].append({"given": given.label, "values": chosen, "proof": part})
    return germ, read, local


def write_side(goal, statement, f, limit, above, told, known=()):
    """A side proof; `told` is (num, den, order, values, radius, power, sense, upper), `known` are conditions on constants."""
    num, den, order, *more = told
    values, radius, power, sense, upper = (*more, *PLAIN[len(more):])
    at = None if statement.at is None else str(statement.at)
    state = goal.constants(statement.variable)
    state = State([*state.conditions, *known], state.formulas)
    written, read, local = write_germ(
        goal, state, statement.variable, at, above, values, radius, power
    )
    a, b = polynomial(num, goal.ring), polynomial(den, goal.ring)
    inner = along(goal, read, local)
    end = misses if isinstance(limit, tuple) else wrong_sign
    failing = lambda: differs(goal, f, a, b, sense)
    side = {
        "germ": written, "num": num, "den": den, "order": order,
        "along": prove(goal, inner.conditions, [*inner.formulas, failing]),
        "at_zero": prove(
            goal, state.conditions, [*state.formulas, lambda: end(goal, limit, a, b, order)]
        ),
    }
    if sense != "=":
        side["sense"] = sense
    if upper:
        side["upper"] = write_side(goal, statement, f, limit, above, upper, known)
    return side


def limit_link(*sides, roots=()):
    """A link that is a limit, proved: what is told of each side."""
    def link(document, claim, item):
        goal = Goal(document, claim, item, "proved", "cited", list(roots))
        written = [
            write_side(goal, claim, *item[1:], above, told) for above, told in zip(claim.sides, sides)
        ]
        return {
            "finding": "proved", "premises": "cited", "roots": list(roots),
            "evidence": {"sides": written},
        }
    return link


def cases_link(poly, zero, positive, negative):
    """A link that is a limit, proved by the sign of a polynomial: in each case what is told of each side; None if it cannot be."""
    def link(document, claim, item):
        goal = Goal(document, claim, item, "proved", "cited", [])
        read, cases = polynomial(poly, goal.ring), []
        for opposite, sign, told in ((False, "=0", zero), (False, ">0", positive), (True, ">0", negative)):
            known = [goal.ring.condition(negated(read) if opposite else read, sign)]
            if told is None:
                state = goal.constants(claim.variable)
                then = {"proof": prove(goal, [*state.conditions, *known], state.formulas)}
            else:
                all_sides = zip(claim.sides, told)
                sides = [write_side(goal, claim, *item[1:], above, one, known) for above, one in all_sides]
                then = {"sides": sides}
            cases.append({"opposite": opposite, "is": sign, "then": then})
        return {"finding": "proved", "premises": "cited", "roots": [], "evidence": {"split": poly, "cases": cases}}
    return link


def functions_link(finding, variable, values, failure, premises=(), roots=()):
    """A witness by functions. `premises`: for each limit of a cited statement its sides.

    `failure` is a point, (k, above, to) and what is told of a side, or a list of sides that are
    reached.
    """
    def link(document, claim, item):
        goal = Goal(document, claim, item, finding, "cited", list(roots))
        written = {
            "variable": variable, "values": values, "ranges": [], "premises": [], "failure": {},
        }
        functions = Functions(goal, written)

        def nowhere(expressions, failing):
            domain = functions.domain.mentioning(expressions)
            state = domain.at_point()
            return prove(domain, state.conditions, [*state.formulas, failing])

        for name in functions.names:
            value, symbol = functions.values[name], document.symbols[name]
            written["ranges"].append(
                nowhere([value], lambda: out_of_range(functions.domain.pieces, value, symbol))
            )
        told = iter(premises)
        for statement in goal.cited:
            expressions = sides((*statement.relations, *statement.when))
            part = nowhere(
                expressions,
                lambda: goal.fails(statement, functions.domain.pieces, statement.kind),
            )
            limits = [
                [write_side(functions.domain, statement, f, limit, above, next(told))
                 for above in statement.sides]
                for _, f, limit in statement.limits
            ]
            written["premises"].append({"proof": part, "limits": limits})
        written["failure"] = write_failure(document, claim, item, functions, failure)
        return {
            "finding": finding, "premises": "cited", "roots": list(roots),
            "evidence": {"functions": written},
        }
    return link


def write_failure(document, claim, item, functions, failure):
    if isinstance(failure, dict):
        return {"at": failure}
    if isinstance(failure, list):
        reached = functions.on_domain(claim.when)
        nothing = ("num", 0, 1)
        return {"reaches": [
            write_side(reached, claim, nothing, nothing, above, ([], ONE_P, 0)) for above in failure
        ]}
    number, above, to, *told = failure
    statement = claim.other or claim
    limit = to if to in ("oo", "-oo") else document.expression(to)
    f = statement.limits[number][1] if claim.other else item[1]
    side = write_side(functions.domain, statement, f, limit, above, told)
    return {"limit": number, "to": to, "side": side}


def pass_link(finding, *steps):
    """A proof that passes to limits first, and then finds its way.

    Each step is (variable, at, above), a polynomial, its sign, and values for the range.
    """
    def link(document, claim, item):
        goal = Goal(document, claim, item, finding, "cited", [])
        proof = write_passes(goal, goal.state(finding), steps)
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
