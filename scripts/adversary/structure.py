"""Structures: constants with values and functions written out, in which the givens of a document hold.

A given is true in a structure if it holds at every point of its range (rule 5 of the language page).
How that is known is for the generator to say, in `truth`:

    ('narrow',)               speaks of the limit variable alone
    ('const',)                speaks of constants alone
    ('limit',)                is a limit, and is worked out exactly
    ('determined', {f: e})    can hold at x just where it holds with f := e(x)
    ('total', relations)      can hold at each x of the domain except where one of the relations holds
"""

from fractions import Fraction

from algebraic import Costly
from germ import Germ, approach
from point import Ambiguous, Scope, Undefined, all_at, evaluate

WIDE = [Fraction(n, d) for n, d in [(0, 1), (1, 1), (-1, 1), (2, 1), (-2, 1), (1, 2), (-1, 2), (3, 1), (-3, 1), (1, 1000), (-1, 1000), (1000, 1), (-1000, 1), (7, 3), (-7, 3), (5, 1), (-5, 1), (13, 2), (99, 100), (101, 100), (1, 3)]]
UNKNOWN = "unknown"


def places(document, structure, extra=()):
    """Values of the limit variable at which a structure is looked at."""
    v = next(v for v in document.vars if v.name == structure.x)
    pool = list(WIDE) + list(extra)
    for p in document.points:
        if isinstance(p.get(structure.x), Fraction):
            pool.append(p[structure.x])
    for bound in (v.lower, v.upper):
        if bound:
            pool += [bound[0], bound[0] + Fraction(1, 5), bound[0] - Fraction(1, 5)]
    return [p for p in dict.fromkeys(pool) if v.allows(p)]


def sides(document, x, limit):
    """The germs along which a limit is taken: (point, side) as `approach` wants them."""
    v = next(v for v in document.vars if v.name == x)
    if limit.point in ("oo", "-oo"):
        far = "+oo" if limit.point == "oo" else "-oo"
        bound = v.upper if far == "+oo" else v.lower
        return [] if bound else [(far, 1)]
    a = Fraction(limit.point)
    out = []
    for way in ((1,) if limit.side == "+" else (-1,) if limit.side == "-" else (1, -1)):
        above = v.upper is None or a < v.upper[0]
        below = v.lower is None or a > v.lower[0]
        beyond = (v.lower is not None and a < v.lower[0]) or (v.upper is not None and a > v.upper[0])
        if not beyond and (above if way > 0 else below):
            out.append((a, way))
    return out


def along(e, document, structure, germ_at):
    """The value of e along a germ; raises Undefined, Ambiguous or Costly."""
    values = structure.values(approach(*germ_at))
    return evaluate(e, document.scope(values))


def limit_of(e, document, structure, germ_at):
    """A Fraction, '+oo', '-oo', None if undefined near the limit, or UNKNOWN."""
    try:
        v = along(e, document, structure, germ_at)
        return v.limit() if isinstance(v, Germ) else v
    except Undefined:
        return None
    except (Ambiguous, Costly):
        return UNKNOWN


def trend(e, document, structure, germ_at, target):
    """For what has roots: False if values at 2^-k clearly stay away from the target, else UNKNOWN."""
    distances = []
    for k in (20, 40, 60):
        point, side = germ_at
        t = Fraction(1, 2**k)
        x = 1 / t if point == "+oo" else -1 / t if point == "-oo" else point + side * t
        try:
            v = evaluate(e, document.scope(structure.values(x)))
        except Undefined:
            return False
        except (Ambiguous, Costly, KeyError):
            return UNKNOWN
        v = v if isinstance(v, Fraction) else v.near(200)
        if target in ("+oo", "-oo"):
            distances.append(1 / v if v and (v > 0) == (target == "+oo") else Fraction(1))
        else:
            distances.append(abs(v - target))
    away = distances[2] > Fraction(1, 1000) and distances[2] > distances[1] * Fraction(99, 100)
    return False if away else UNKNOWN


def target_value(limit, document, structure):
    """A Fraction, '+oo', '-oo', or None if it is undefined."""
    if limit.target in ("oo", "-oo"):
        return "+oo" if limit.target == "oo" else "-oo"
    try:
        return evaluate(limit.target, document.scope(dict(structure.constants)))
    except Undefined:
        return None


def limit_holds(limit, document, structure):
    """True, False or UNKNOWN."""
    target = target_value(limit, document, structure)
    if target is None:
        return False
    verdict = True
    for germ_at in sides(document, structure.x, limit):
        found = limit_of(limit.f, document, structure, germ_at)
        if found == UNKNOWN:
            if trend(limit.f, document, structure, germ_at, target) is False:
                return False
            verdict = UNKNOWN
        elif found is None or isinstance(found, str) != isinstance(target, str) or found != target:
            return False
    return verdict


def conditions_hold(relations, document, structure):
    """Conditions on constants."""
    return all_at(relations, document.scope(dict(structure.constants))) is True


def given_true(statement, document, structure):
    """Whether a given is true in a structure; UNKNOWN counts as no."""
    memo = structure.__dict__.setdefault("truths", {})
    if statement.label not in memo:
        try:
            memo[statement.label] = _given_true(statement, document, structure)
        except (Ambiguous, Costly):
            memo[statement.label] = UNKNOWN
    return memo[statement.label]


def _given_true(statement, document, structure):
    limit = statement.limit()
    if limit:
        if statement.when and not conditions_hold(statement.when, document, structure):
            return True
        return limit_holds(limit, document, structure)
    truth = statement.truth or (UNKNOWN,)
    scope = document.scope(dict(structure.constants))
    for r in statement.links:
        # what speaks of constants alone is asserted outright, also as an item of a list
        if not statement.when and scope.symbols(r[1]) | scope.symbols(r[2]) <= set(structure.constants):
            if all_at([r], scope) is not True:
                return False
    if truth[0] == "narrow":
        return True
    if truth[0] == "const":
        scope = document.scope(dict(structure.constants))
        if statement.when and all_at(statement.when, scope) is not True:
            return True
        return all_at(statement.links, scope) is True
    if truth[0] not in ("determined", "total"):
        return UNKNOWN
    bounds = {v.name: v for v in document.vars}
    for x in places(document, structure):
        values = structure.values(x)
        here = holds_at(statement, document, values)
        if truth[0] == "total":
            outside = any(all_at([r], document.scope(values)) is True for r in truth[1])
            if not here and not outside:
                return False
            continue
        possible = dict(values)
        try:
            for f, e in truth[1].items():
                possible[f] = evaluate(e, Scope({}, values))
        except Undefined:
            continue
        if all(bounds[f].allows(possible[f]) for f in truth[1]) and holds_at(statement, document, possible) and not here:
            return False
    return True


def holds_at(statement, document, values):
    """Whether a given holds at one point."""
    scope = document.scope(values)
    if statement.when and all_at(statement.when, scope) is not True:
        return True
    return all_at(statement.links, scope) is True


def lies_in_domain(document, structure):
    """Whether constants and functions keep to their bounds."""
    for x in places(document, structure):
        try:
            if not document.in_domain(structure.values(x)):
                return False
        except Undefined:
            return False
    return True
