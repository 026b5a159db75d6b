"""Points at which a claim is tried: aimed at boundaries, at zeros, and at solutions of the premises."""

from fractions import Fraction

from algebraic import Costly, sign, square_root
from expr import walk
from point import Ambiguous, Undefined, all_at, evaluate

SMALL = [Fraction(n, d) for n, d in [(0, 1), (1, 1), (-1, 1), (2, 1), (-2, 1), (1, 2), (-1, 2), (3, 1), (-3, 1), (3, 2), (1, 3), (5, 1), (-7, 2), (4, 1), (9, 4), (1, 4), (10, 1)]]


class Place:
    """A point with the truth of every statement at it, worked out once."""

    def __init__(self, document, values):
        self.document, self.values = document, values
        self.scope = document.scope(values)
        self.memo = {}

    def beside(self, more):
        """The same place with these values."""
        return Place(self.document, {**self.values, **more})

    def truth(self, label):
        """Of a given: whether it holds. Of a claim: whether it holds as an implication; 'maybe' if the
        page leaves open how a list with an undefined item is read."""
        if label not in self.memo:
            self.memo[label] = self.judge(self.document.find(label))
        return self.memo[label]

    def judge(self, s):
        """The truth of a statement, not kept."""
        try:
            if s.shape != "links" or s.limit():
                return True if s.kind == "claim" else "maybe"
            if s.when and all_at(s.when, self.scope) is not True:
                return True  # a condition that is not met asks for nothing
            values = [all_at([r], self.scope) for r in s.links]
        except (Ambiguous, Costly):
            return "maybe"
        if s.kind == "given":
            return all(v is True for v in values)
        if False not in values:
            return True
        return False if None not in values else "maybe"

    def premises(self, claim):
        """True, False or 'maybe' for all that is cited and the conditions."""
        worst = True
        for label in claim.cites:
            v = self.truth(label)
            if v is False:
                return False
            worst = v if v != True else worst  # noqa: E712 ('maybe' is no truth value)
        try:
            if claim.when and all_at(claim.when, self.scope) is not True:
                return False
        except (Ambiguous, Costly):
            return "maybe"
        return worst

    def link(self, r):
        """True, False, None where undefined, or 'maybe'."""
        try:
            return all_at([r], self.scope)
        except (Ambiguous, Costly):
            return "maybe"

    def shown(self):
        from point import decimal

        return ", ".join(f"{n} = {decimal(v)}" for n, v in self.values.items())


def allowed(v, value):
    return v.allows(value)


def candidates(v, rng):
    """Small numbers and the bounds, as far as the bounds allow."""
    pool = list(SMALL)
    for bound in (v.lower, v.upper):
        if bound:
            pool += [bound[0], bound[0] + Fraction(1, 7), bound[0] - Fraction(1, 7), bound[0] + 1, bound[0] - 1]
    if v.lower and v.upper:
        pool += [(v.lower[0] * k + v.upper[0] * (8 - k)) / 8 for k in range(1, 8)]
    out = [c for c in pool if v.allows(c)]
    return out or [Fraction(0)]


def spread(document, rng, count):
    """The points that the generator knows, and random ones."""
    tables = {v.name: candidates(v, rng) for v in document.vars}
    points = [p for p in document.points if document.in_domain(p)]
    for _ in range(count):
        if points and rng.random() < 0.3:
            p = dict(rng.choice(points))
            name = rng.choice(list(tables))
            p[name] = rng.choice(tables[name])
        else:
            p = {n: rng.choice(t) for n, t in tables.items()}
        points.append(p)
    return points


def troubles(e):
    """Expressions whose zeros are telling: denominators, radicands, sides of guards."""
    for node in walk(e):
        kind = node[0]
        if kind == "/":
            yield node[2]
        elif kind in ("abs", "sqrt"):
            yield node[1]
        elif kind == "^" and node[2] <= 0:
            yield node[1]
        elif kind in ("min", "max"):
            yield ("-", node[1], node[2])
        elif kind == "cases":
            for guard, _ in node[1]:
                for _, a, b in guard:
                    yield ("-", a, b)


def value_at(e, document, values):
    try:
        return evaluate(e, document.scope(values))
    except (Undefined, Ambiguous, Costly):
        return None


def solve(e, name, document, values, rng, irrational=False):
    """Values of a name at which e seems to vanish: e is probed, and fitted by a parabola."""
    base = rng.choice([Fraction(1), Fraction(-2), Fraction(1, 2), Fraction(3)])
    probes = []
    for k in range(4):
        v = value_at(e, document, {**values, name: base + k})
        if not isinstance(v, Fraction):
            return []
        probes.append(v)
    p, q, r, s = probes
    second = r - 2 * q + p
    if s - 3 * r + 3 * q - p != 0:
        return []
    slope = q - p - second / 2
    if second == 0:
        return [] if slope == 0 else [base - p / slope]
    # p + slope*k + second/2*k^2 = 0
    disc = slope * slope - 2 * second * p
    if disc < 0:
        return []
    root = square_root(disc)
    if not isinstance(root, Fraction) and not irrational:
        return []
    return [base + (root - slope) / second, base - (root + slope) / second]


def equations(document, claim, into):
    """Relations with `=` that the premises of a claim ask for."""
    for label in claim.cites:
        s = document.find(label)
        if s.shape == "links" and not s.limit():
            into += [r for r in s.links if r[0] == "="]
    into += [r for r in claim.when if r[0] == "="]
    return into


def aimed(document, claim, points, rng, tries):
    """Points that satisfy the equations among the premises, and lie on or beside a place of trouble."""
    wanted = equations(document, claim, [])
    relations = [r for r in claim.links if isinstance(r, tuple)] + list(claim.when)
    for label in claim.cites:
        s = document.find(label)
        relations += [r for r in s.links if isinstance(r, tuple)] + list(s.when)
    edges = [("-", a, b) for _, a, b in relations]
    for _, a, b in relations:
        edges += list(troubles(a)) + list(troubles(b))
    edges += [t for e in document.lets.values() for t in troubles(e)]
    names = [v.name for v in document.vars]
    by_name = {v.name: v for v in document.vars}
    out = []
    for _ in range(tries):
        values = dict(rng.choice(points))
        if any(not isinstance(v, Fraction) for v in values.values()):
            continue
        free = names[:]
        rng.shuffle(free)
        goals = [("-", a, b) for _, a, b in wanted]
        if edges and rng.random() < 0.8:
            goals.append(rng.choice(edges))
        if rng.random() < 0.3:
            rng.shuffle(goals)
        for e in goals:
            occurring = document.scope(values).symbols(e)
            for name in [n for n in free if n in occurring]:
                found = [v for v in solve(e, name, document, values, rng, rng.random() < 0.2) if by_name[name].allows(v)]
                if found:
                    values[name] = rng.choice(found)
                    free.remove(name)
                    break
        if free and rng.random() < 0.3:
            name = rng.choice(free)
            moved = values[name] + rng.choice([Fraction(1, 8), Fraction(-1, 8)])
            if by_name[name].allows(moved):
                values[name] = moved
        if any(sign(values[n] - p) for n, p in rng.choice(points).items()):
            out.append(values)
    return out
