"""Givens near a limit that speak of exponentials, cosines and sines, whose values nobody may choose (the language, rule 5)."""

from .errors import demand
from .expressions import parts


def check(goal, finding):
    """Do the `given`s on which a limit rests hold near it, for what exponentials and sines are there?"""
    if not goal.has_limits or finding not in ("proved", "vacuous"):
        return
    cited = {s.variable for s in goal.cited if s.limits}
    if finding == "vacuous" and not cited:
        return  # that hypotheses contradict each other near a limit that is claimed needs no range
    document, claimed = goal.document, {goal.claim.variable} if goal.is_limit else set()
    for given in (*goal.cited, *goal.behind):
        if given.kind == "given" and not made(document, given):
            along = {document.symbols[name].argument for name in determined(document, given)}
            demand(not along & (cited | claimed) or by_choice(document, given),
                   f"`{given.label}` may hold nowhere near the limit")


def made(document, given):
    """Does it come with the declaration of an angle or an exponential?"""
    own = (*document.circles.values(), *document.arcs.values(), *document.bounds_of.values())
    return any(given is other for other in own)


def is_determined(document, name):
    return bool(document.symbols[name].argument) and (name in document.exponentials or name in document.points)


def spoken(document, expressions):
    return {name for e in expressions for name in document.mentioned(e)}


def determined(document, statement):
    """The exponentials, logarithms, cosines and sines in it that are functions."""
    said = [side for _, *both in (*statement.relations, *statement.when) for side in both]
    return {name for name in spoken(document, said) if is_determined(document, name)}


def has_value(document, e, seen=()):
    """Has it a value whatever its symbols are within their bounds, by how it is written?"""
    kind, known = e[0], document.sequences
    if kind in ("num", "sym"):
        return True
    if kind == "def":
        return e[1] in seen or has_value(document, document.symbols[e[1]].body, (*seen, e[1]))
    if kind == "div" and not known.never_vanishes(e[2]) or kind == "pow" and e[2] < 0 and not known.never_vanishes(e[1]):
        return False
    plain = kind in ("neg", "add", "sub", "mul", "div", "pow", "abs", "min", "max")
    return plain and all(has_value(document, part, seen) for part in parts(e))


def free(document, sign, one, value):
    """Is one side a function that may be the other side, or close to it?"""
    if one[0] != "sym" or is_determined(document, one[1]):
        return False
    symbol = document.symbols[one[1]]
    low = symbol.lower
    bounded = low and not (sign == "=" and low[0] == 0 and document.sequences.is_above(value, low[1]))
    apart = symbol.argument and not symbol.upper and not bounded and one[1] not in document.ranges
    return bool(apart) and has_value(document, value)


def by_choice(document, given):
    """Has each relation that speaks of these on one side a function of which nothing else is said?"""
    fixed = determined(document, given)
    chosen, read, others = set(), set(), []
    inside = lambda es: set().union(*map(document.inside, spoken(document, es)))  # noqa: E731
    for sign, left, right in given.relations:
        if not spoken(document, (left, right)) & fixed:
            others += [left, right]
            continue
        found = [(one[1], value) for one, value in ((left, right), (right, left)) if free(document, sign, one, value)]
        if not found:
            return False
        name, value = found[0]
        read |= inside([value])
        if name in read or name in chosen:
            return False
        chosen.add(name)
    conditions = [side for _, *both in given.when for side in both]
    return not inside(others) & chosen and all(
        has_value(document, e) or not spoken(document, [e]) & fixed and not inside([e]) & chosen for e in conditions
    )
