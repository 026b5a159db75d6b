"""Witnesses by functions of the limit variable (section 7)."""

from dataclasses import replace
from functools import cache

from .errors import demand
from .evidence import count, keys, listed, text
from .germ import explicit, out_of_range, read_values
from .goal import HERE, regions, sides
from .limits import check_side, prove_limit
from .point import check_point
from .proof import Proof


class Functions:
    """Checks a witness by functions for a goal."""

    def __init__(self, goal, evidence):
        self.goal, self.document, self.claim = goal, goal.document, goal.claim
        self.variable, values, self.range_proofs, self.premises, self.failure = keys(
            evidence, "variable", "values", "ranges", "premises", "failure"
        )
        demand(self.document.may_tend(text(self.variable)), "the variable is no plain variable")
        self.values = read_values(self.document, values)
        self.names = [name for name in goal.mentioned if name != self.variable]
        demand(set(self.names) == set(self.values), "not each symbol has a value")
        for name, value in self.values.items():
            is_function = self.document.symbols[name].argument == self.variable
            allowed = {self.variable} if is_function else set()
            demand(self.document.mentioned(value) <= allowed, "a value is not one of x and numbers")
        self.domain = self.on_domain(())

    def on_domain(self, when):
        """The goal on the domain: what `given`s say of the variable alone, and conditions."""
        narrowing = [(s, self.narrowing(s)) for s in self.goal.cited]
        cited = [replace(s, items=relations) for s, relations in narrowing if relations]
        return self.goal.with_values(cited, when, self.variable, self.values)

    def check(self, finding):
        """The premises hold, and the conclusion fails."""
        goal, claim = self.goal, self.claim
        aims = [claim.other] if claim.other else []
        for statement in [*goal.cited, *aims, *([claim] if goal.is_limit else [])]:
            demand(statement.variable in (None, self.variable), "a limit in another variable")
        for name, part in zip(self.names, listed(self.range_proofs, len(self.names))):
            value, symbol = self.values[name], self.document.symbols[name]
            self.show(part, [value], lambda v=value, s=symbol: out_of_range(self.domain.pieces, v, s))
        for statement, entry in zip(goal.cited, listed(self.premises, len(goal.cited))):
            self.check_premise(statement, entry)
        self.check_failure(finding)

    def mentions_function(self, relation):
        return any(
            self.document.symbols[name].argument == self.variable
            for side in sides([relation]) for name in self.document.mentioned(side)
        )

    def mentions_variable(self, relation):
        return any(self.variable in self.document.mentioned(side) for side in sides([relation]))

    def narrowing(self, statement):
        """The relations of a `given` that say where on the line it can hold."""
        if statement.kind != "given" or any(map(self.mentions_function, statement.when)):
            return []
        everywhere = not any(map(self.mentions_variable, statement.when))
        return [
            r for r in statement.relations
            if not self.mentions_function(r) and not (everywhere and not self.mentions_variable(r))
        ]

    def show(self, part, expressions, failing):
        """Checks a proof that something fails nowhere on the domain."""
        goal = self.domain.mentioning(expressions)
        state = goal.at_point()
        Proof(goal).check(part, state.conditions, [*state.formulas, cache(failing)])

    def check_premise(self, statement, entry):
        """A cited statement holds for the values, and its limits are what it says."""
        part, limits = keys(entry, "proof", "limits")
        expressions = sides((*statement.relations, *statement.when))
        self.show(
            part, expressions,
            lambda: self.domain.fails(statement, self.domain.pieces, statement.kind),
        )
        for (_, f, limit), evidence in zip(statement.limits, listed(limits, len(statement.limits))):
            prove_limit(Proof(self.domain), evidence, statement, f, limit)

    def check_failure(self, finding):
        """The conclusion fails at a point, or has another limit."""
        goal, claim, failure = self.goal, self.claim, self.failure
        demand(isinstance(failure, dict), "a failure is expected")
        if "at" in failure:
            (point,) = keys(failure, "at")
            self.fails_at(point, finding)
        elif "limit" in failure:
            self.other_limit(finding)
        else:
            (evidence,) = keys(failure, "reaches")
            demand(finding == "consistent" and goal.is_limit, "reaching a limit shows consistency")
            self.demand_true(claim.when)
            nothing = ("num", 0, 1)
            prove_limit(Proof(self.on_domain(claim.when)), evidence, claim, nothing, nothing)

    def fails_at(self, point, finding):
        """A point of the domain, at which conditions are true and the link is not."""
        claim, pieces = self.claim, self.domain.pieces
        demand(not self.goal.is_limit, "a limit does not fail at a point")
        expressions, cases = [], lambda: HERE
        if finding != "consistent" and claim.form == "not implied":
            expressions = sides((*claim.other.relations, *claim.other.when))
            cases = lambda: self.domain.fails(claim.other, pieces)
        elif finding != "consistent" and claim.form == "relations":
            expressions = sides([self.goal.link])
            truth = {"refuted": False, "ill-defined": None}[finding]
            cases = lambda: regions(pieces.truth([self.goal.link]), truth)
        goal = self.on_domain(claim.when).mentioning(expressions)
        state = goal.at_point()
        check_point(
            goal, point, goal.mentioned, goal.listed_roots, state.conditions, [*state.formulas, cases]
        )

    def other_limit(self, finding):
        """A limit that the conclusion speaks of is another one."""
        goal, claim = self.goal, self.claim
        told = dict(self.failure)
        apart = told.pop("apart", None)
        number, other, side = keys(told, "limit", "to", "side")
        if claim.form == "not implied" and finding == "proved":
            statement = claim.other
            _, f, limit = statement.limits[count(number, len(statement.limits))]
        else:
            demand(goal.is_limit and finding == "refuted" and count(number) == 0, "no limit is claimed")
            statement, (_, f, limit) = claim, goal.link
        if other not in ("oo", "-oo"):
            other = self.document.expression(text(other))
            demand(explicit(other) and not self.document.mentioned(other), "a limit is no number")
        for truth in (claim.when, statement.when):
            self.demand_true(truth)
        if apart is None:
            demand(other != limit and self.differ(other, limit), "the limit is as claimed")
        else:
            self.show_apart(apart, limit, other)
        germ = check_side(Proof(self.domain), side, f, other, self.variable)
        demand(germ.is_premised(statement), "a proof of another side")

    def demand_true(self, relations):
        """Conditions on constants are true at the values."""
        pieces = self.domain.pieces.truth(relations)
        demand(all(truth is True for _, truth in pieces), "a condition is not met, or not evident")

    def show_apart(self, part, limit, other):
        """Checks a proof that two numbers are defined and differ."""
        demand(not isinstance(limit, str) and not isinstance(other, str), "a limit is no number")
        unequal = ("!=", limit, other)
        pieces = self.domain.pieces
        self.show(part, sides([unequal]), lambda: regions(pieces.truth([unequal]), False, None))

    def differ(self, other, limit):
        """Is a number not what the limit is, or is that undefined?"""
        if isinstance(limit, str) or isinstance(other, str):
            return True
        return all(truth is not True for _, truth in self.domain.pieces.truth([("=", other, limit)]))
