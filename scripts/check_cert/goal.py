"""Goals and their states: which obligations follow from a statement (section 5)."""

from copy import copy
from dataclasses import dataclass
from functools import cache

from .errors import demand
from .pieces import Pieces
from .polynomial import ONE, Ring, add, constant, multiply, negative

HERE = [()]  # one empty region


@dataclass
class State:
    """Conditions and formulas; a formula is called for its cases."""

    conditions: list
    formulas: list


def regions(pieces, *truths):
    """The regions of pieces with one of some values."""
    return [region for region, value in pieces if value in truths]


def sides(relations):
    """The expressions on both sides of relations and limits."""
    return [e for _, *both in relations for e in both if isinstance(e, tuple)]


def times_number(p, number):
    return multiply(p, constant(number))


class Goal:
    """What a link of a claim asks for."""

    def __init__(self, document, claim, link, finding, premises, roots):
        self.document, self.claim, self.when = document, claim, claim.when
        self.vacuous = finding == "vacuous"
        self.link = link
        self.cited = [s for s in claim.cited if not s.sought]
        self.behind = [
            given for given in rests_on(document, claim.cited) if given not in self.cited
        ]
        if premises == "all":
            self.cited, self.behind = self.cited + self.behind, []
        aims = [claim.other] if claim.other else []
        self.has_limits = any(s.limits for s in self.cited + aims) or self.is_limit
        if not self.has_limits:
            self.behind = []
        self.limits = [
            (f"lim:{n}", statement, item)
            for n, (statement, item) in enumerate(
                (statement, item) for statement in self.cited for item in statement.limits
            )
        ]
        expressions = [e for s in (*self.cited, *aims) for e in s.expressions()]
        expressions += sides((*self.when, *([link] if link else [])))
        self.mentioned = self.mentions(expressions)
        self.roots = self.read_roots(roots, expressions)
        self.listed_roots = list(self.roots.values())
        self.ring = Ring([
            *(s.name for s in document.symbols.values() if not s.body),
            *self.listed_roots, "t:", *(name for name, _, _ in self.limits),
        ])
        self.values, self.pieces = {}, Pieces(document, self.ring, self.roots)
        self.bare = self  # without values for symbols

    def mentions(self, expressions, names=()):
        """The unknowns in expressions, and some more, in the order of declaration."""
        found = set(names).union(*map(self.document.mentioned, expressions))
        return [name for name in self.document.symbols if name in found]

    def with_values(self, cited, when, variable, values):
        """The goal in which values stand for symbols, with other premises and conditions.

        It mentions the variable, or nothing: values are made of it and numbers.
        """
        goal = copy(self)
        goal.cited, goal.behind, goal.limits, goal.when = cited, [], [], when
        expressions = [e for s in cited for e in s.expressions()] + sides(when)
        goal.mentioned = self.mentions(expressions)
        goal.bare = copy(goal)
        goal.pieces = Pieces(self.document, self.ring, self.roots, values)
        goal.values, goal.mentioned = values, []
        return goal.mentioning(expressions)

    def mentioning(self, expressions):
        """The goal of functions when it speaks of these expressions, too."""
        goal, names = copy(self), set(self.mentioned)
        for name in self.mentions(expressions):
            names |= self.document.mentioned(self.values[name]) if name in self.values else {name}
        goal.mentioned = self.mentions([], names)
        return goal

    @property
    def is_limit(self):
        return self.link is not None and self.link[0] == "->"

    def read_roots(self, texts, expressions):
        """The variable of each root, by its radicand."""
        found, needed = {}, set()
        for number, text in enumerate(texts):
            root = self.document.expression(text)
            demand(root[0] == "sqrt" and root[1] not in found, "the list of roots is not well formed")
            found[root[1]] = f"sqrt:{number}"
        seen = set()
        for expression in expressions:
            self.document.roots(expression, needed, seen)
        demand(needed <= set(found), "a root is not in the list")
        return found

    def range_of(self, name):
        """The conditions of the bounds of a symbol."""
        symbol, variable = self.document.symbols[name], self.ring.variable(name)
        found = []
        if symbol.lower:
            bound, strict = symbol.lower
            p = add(times_number(variable, bound.denominator), constant(-bound.numerator))
            found.append(self.ring.condition(p, ">0" if strict else ">=0"))
        if symbol.upper:
            bound, strict = symbol.upper
            p = add(times_number(variable, -bound.denominator), constant(bound.numerator))
            found.append(self.ring.condition(p, ">0" if strict else ">=0"))
        return found

    def ranges(self, names):
        return [condition for name in names for condition in self.range_of(name)]

    def holds(self, statement, relations=None):
        """The cases in which a cited statement holds."""
        relations = statement.relations if relations is None else relations
        truths = (True,) if statement.kind == "given" else (True, None)
        return regions(self.pieces.statement(relations, statement.when), *truths)

    def fails(self, statement, pieces=None, kind="given"):
        """The cases in which a statement fails."""
        found = (pieces or self.pieces).statement(statement.relations, statement.when)
        return regions(found, *((False, None) if kind == "given" else (False,)))

    def counts(self, statement, item, variable):
        """Is the value of a premised limit one of constants (of either limit)?"""
        limit, variables = item[2], {statement.variable, variable or statement.variable}
        return isinstance(limit, tuple) and not any(
            self.document.depends(expression, x)
            for expression in (limit, *(side for _, *sides in statement.when for side in sides))
            for x in variables
        )

    def limit_values(self, variable=None):
        """Formulas: for each premised limit, that its variable is its value (5.2)."""
        return [
            cache(lambda n=name, s=statement, i=item: self.bound_to(n, i[2], s))
            if self.counts(statement, item, variable)
            else lambda: HERE
            for name, statement, item in self.limits
        ]

    def bound_to(self, name, expression, statement):
        """Where `when` holds, an expression is defined and a variable is its value."""
        found, variable = [], self.ring.variable(name)
        values = self.pieces.pieces(expression)
        for region, truth in self.pieces.truth(statement.when):
            if truth is not True:
                found.append(region)
                continue
            for region, value in self.pieces.go_on([(region, True)], lambda _: values):
                if value is not None:
                    gap = add(value[0], negative(multiply(variable, value[1])))
                    found.append((*region, self.ring.condition(gap, "=0")))
        return found

    def failure(self, finding):
        """Formulas: how the conclusion fails, if there is one."""
        if self.claim.form == "contradiction" or finding in ("vacuous", "consistent"):
            return []
        if self.claim.form == "not implied":
            return [cache(lambda: self.fails(self.claim.other))]
        truths = {"proved": (False, None), "refuted": (False,), "ill-defined": (None,)}[finding]
        return [cache(lambda: regions(self.pieces.truth([self.link]), *truths))]

    def state(self, finding):
        """The state that a proof starts from."""
        limit = self.vacuous and self.is_limit
        return self.constants(self.claim.variable) if limit else self.at_point(finding)

    def at_point(self, finding=None):
        """The state at a point; without a finding nothing is said of the conclusion."""
        formulas = [cache(lambda s=s: self.holds(s)) for s in self.cited]
        formulas += self.limit_values()
        formulas.append(cache(lambda: regions(self.pieces.truth(self.when), True)))
        return State(self.ranges(self.mentioned), formulas + (self.failure(finding) if finding else []))

    def depends(self, relation, variable):
        """Does a relation or a limit depend on a variable?"""
        return any(self.document.depends(e, variable) for e in relation[1:] if isinstance(e, tuple))

    def free_items(self, statement, variable):
        """The relations of a cited statement that it says of constants; None if it says nothing."""
        whole = statement.when if statement.kind == "given" else [*statement.items, *statement.when]
        if any(self.depends(relation, variable) for relation in whole):
            return None
        return [r for r in statement.relations if not self.depends(r, variable)]

    def of_constants(self, statement, variable):
        """What a cited statement says of constants."""
        items = self.free_items(statement, variable)
        return HERE if items is None else self.holds(statement, items)

    def told_of_constants(self, variable):
        """The expressions in conditions on constants and in what cited statements say of them."""
        told = [r for r in self.when if not self.depends(r, variable)]
        for statement in self.cited:
            items = self.free_items(statement, variable)
            told += [] if items is None else [*statement.when, *items]
        return sides(told)

    def when_of_constants(self, variable):
        conditions = [r for r in self.when if not self.depends(r, variable)]
        return regions(self.pieces.truth(conditions), True)

    def cited_constants(self, variable):
        """Formulas: what each cited statement says of constants."""
        return [cache(lambda s=s: self.of_constants(s, variable)) for s in self.cited]

    def constants(self, variable):
        """The state of constants of a limit in a variable."""
        names = [n for n in self.mentioned if not self.document.varies((n,), variable)]
        formulas = self.cited_constants(variable) + self.limit_values(variable)
        formulas.append(cache(lambda: self.when_of_constants(variable)))
        return State(self.ranges(names), formulas)


def rests_on(document, cited):
    """The `given`s on which cited claims rest, in the order of the document."""
    found, todo, seen = set(), [s for s in cited if s.kind == "claim"], set()
    while todo:
        claim = todo.pop()
        if claim.label in seen:
            continue
        seen.add(claim.label)
        for statement in claim.cited:
            if statement.kind == "given":
                found.add(statement.label)
            else:
                todo.append(statement)
    return [s for s in document.statements.values() if s.label in found]
