"""Which unknowns equations tie to the variable of a derivative (the language, "Derivatives")."""

from . import interior
from .divisor import reduced
from .errors import Rejected
from .pieces import Pieces
from .polynomial import Ring, add, constant, multiply
from .ratio import minus, plus, sign_of


class Ties:
    """The equations of some relations, taken together."""

    def __init__(self, document, relations):
        self.document, self.groups = document, {}
        self.ring = Ring(s.name for s in document.symbols.values() if not s.body)
        self.pieces = Pieces(document, self.ring, {})
        self.equations = [self.symbols(r) for r in relations if r[0] == "="]
        self.equations += [self.symbols(r) for r in self.circular(relations)]
        unequal = [r for r in relations if r[0] != "="]
        self.equations += [self.spoken_of(r) for r in unequal if not interior.has_room(r, document)]
        # an angle, its cosine and its sine vary together, whatever is said of them
        self.equations += {frozenset(document.of_angle(name)) for name in document.points}

    def gap(self, relation):
        """The difference of the sides, if it is one fraction wherever it is defined."""
        _, left, right = relation
        try:
            pieces = self.pieces.both(left, right, lambda a, b: self.pieces.one(plus(a, minus(b))))
        except Rejected:
            return None
        values = [value for _, value in pieces if value is not None]
        names = self.ring.variables(values[0][0]) if len(values) == 1 else ()
        if len(values) != 1 or names & set(self.pieces.roots.values()):
            return None
        return reduced(*values[0])

    def symbols(self, relation):
        """The unknowns that an equation speaks of; none of an identity."""
        gap = self.gap(relation)
        return self.with_factors(self.ring.variables(gap[0])) if gap else self.spoken_of(relation)

    def spoken_of(self, relation):
        """The unknowns that stand in a relation, guards included."""
        return self.with_factors(self.document.mentioned(relation[1]) | self.document.mentioned(relation[2]))

    def with_factors(self, names):
        """What is said of an exponential is said of what is in it."""
        inside = [dict(self.document.exponentials[name][0]) for name in names if name in self.document.exponentials]
        return frozenset(names).union(*inside)

    def circular(self, relations):
        """Inequalities that make equations: in a circle, or one against another."""
        edges, loose = {}, []
        for relation in relations:
            sign, left, right = relation
            if sign in ("<=", ">="):
                loose.append(relation if sign == "<=" else ("<=", right, left))
            if sign in ("<=", "="):
                edges.setdefault(left, set()).add(right)
            if sign in (">=", "="):
                edges.setdefault(right, set()).add(left)
        sizes = {}
        for relation in loose:
            gap = self.gap(relation)
            if gap:
                sizes[relation] = sign_of(gap)
        for relation in loose:
            against = any(
                opposite(sizes[relation], size) for size in sizes.values()
            ) if relation in sizes else False
            if against or leads(edges, relation[2], relation[1]):
                yield relation

    def to(self, variable):
        """The unknowns that are tied to a variable; what is pinned to a value carries nothing on.

        The variable itself varies, so nothing pins it.
        """
        if variable not in self.groups:
            pinned, more = set(), True
            while more:
                left = [names - pinned for names in self.equations]
                more = {next(iter(names)) for names in left if len(names) == 1} - {variable}
                pinned |= more
            tied, before = {variable}, 0
            while len(tied) > before:
                before = len(tied)
                for names in self.equations:
                    if names & (tied - pinned):
                        tied |= names
            self.groups[variable] = tied - {variable}
        return self.groups[variable]


def opposite(p, q):
    """Is one polynomial the other times a negative number?"""
    if not p or p.keys() != q.keys():
        return False
    monomial = next(iter(p))
    a, b = abs(p[monomial]), abs(q[monomial])
    return not add(multiply(p, constant(b)), multiply(q, constant(a)))


def leads(edges, start, end):
    """Is there a way along the edges?"""
    seen, todo = set(), [start]
    while todo:
        here = todo.pop()
        if here == end:
            return True
        if here not in seen:
            seen.add(here)
            todo.extend(edges.get(here, ()))
    return False
