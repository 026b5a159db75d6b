"""Witnesses by functions of the limit variable (section 7)."""

from functools import cache

from .errors import demand
from .evidence import count, keys, listed, text
from .germ import explicit, out_of_range, read_germ, read_values
from .goal import HERE, State, regions
from .limits import check_side
from .pieces import Pieces
from .point import check_point


class Functions:
    """Checks a witness by functions for a goal."""

    def __init__(self, proof, evidence):
        self.proof, self.goal, self.document = proof, proof.goal, proof.goal.document
        self.variable, values, self.range_proofs, self.premises, self.failure = keys(
            evidence, "variable", "values", "ranges", "premises", "failure"
        )
        demand(self.document.is_plain(text(self.variable)), "the variable is no plain variable")
        self.values = read_values(self.document, values)
        self.pieces = Pieces(self.document, self.goal.ring, self.goal.roots, self.values)
        names = [name for name in self.goal.mentioned if name != self.variable]
        demand(set(names) == set(self.values), "not each symbol has a value")
        self.names = names
        for name, value in self.values.items():
            is_function = self.document.symbols[name].argument == self.variable
            allowed = {self.variable} if is_function else set()
            demand(self.document.mentioned(value) <= allowed, "a value is not one of x and numbers")
        self.domain = [cache(lambda s=s: self.narrow(s)) for s in self.goal.cited]

    def check(self, finding):
        """The premises hold, and the conclusion fails."""
        goal, claim = self.goal, self.goal.claim
        aims = [claim.other] if claim.other else []
        for statement in [*goal.cited, *aims, *([claim] if goal.is_limit else [])]:
            demand(statement.variable in (None, self.variable), "a limit in another variable")
        for name, part in zip(self.names, listed(self.range_proofs, len(self.names))):
            symbol = self.document.symbols[name]
            cases = out_of_range(self.pieces, self.values[name], symbol)
            self.on_domain(part, lambda: cases)
        for statement, entry in zip(goal.cited, listed(self.premises, len(goal.cited))):
            self.check_premise(statement, entry)
        self.check_failure(finding)

    def mentions_function(self, relation):
        names = self.document.mentioned(relation[1]) | self.document.mentioned(relation[2])
        return any(self.document.symbols[name].argument == self.variable for name in names)

    def narrowing(self, statement):
        """The relations of a `given` on the variable alone."""
        if statement.kind != "given" or any(map(self.mentions_function, statement.when)):
            return []
        return [
            r for r in statement.relations
            if not self.mentions_function(r)
            and self.variable in self.document.mentioned(r[1]) | self.document.mentioned(r[2])
        ]

    def narrow(self, statement, *truths):
        """The cases in which narrowing relations hold (or have another truth)."""
        relations = self.narrowing(statement)
        if not relations:
            return HERE
        return regions(self.pieces.statement(relations, statement.when), *(truths or (True,)))

    def on_domain(self, part, failing):
        conditions = self.goal.range_of(self.variable)
        self.proof.check(part, conditions, [*self.domain, failing])

    def check_premise(self, statement, entry):
        part, limits = keys(entry, "proof", "limits")
        rest = len(self.narrowing(statement)) < len(statement.relations)
        demand((part is not None) == rest, "a premise without its proof, or a proof without need")
        if rest:
            cases = self.goal.fails(statement, self.pieces, statement.kind)
            self.on_domain(part, lambda: cases)
        for (_, f, limit), sides in zip(statement.limits, listed(limits, len(statement.limits))):
            for side, above in zip(listed(sides, len(statement.sides)), statement.sides):
                germ = self.check_side(side, f, limit, False)
                demand(germ.is_premised(statement) and germ.above == above, "a proof of another side")

    def open(self, value, on_domain):
        """A germ, which may owe a proof that it is on the domain."""
        germ, positive, below, inside = read_germ(self.goal, value)
        self.proof.check(positive, [], [lambda: below])
        owed = [s for s in self.goal.cited if on_domain and self.narrowing(s)]
        conditions = self.along(self.goal, germ, []).conditions
        for given, entry in zip(owed, listed(inside, len(owed))):
            label, values, part = keys(entry, "given", "values", "proof")
            demand(label == given.label and values == {}, "an obligation is not in its place")
            cases = self.narrow(given, False, None)
            self.proof.check(part, conditions, [lambda: cases])
        return germ, []

    def along(self, goal, germ, _):
        demand(germ.variable == self.variable, "a germ of another variable")
        return State([*goal.range_of(self.variable), *germ.conditions], [])

    def check_side(self, side, f, limit, on_domain):
        germ, _ = check_side(
            self.proof, side, f, limit, lambda germ: self.open(germ, on_domain),
            State([], []), self.along, self.pieces, None,
        )
        return germ

    def check_failure(self, finding):
        """The conclusion fails at a point, or has another limit."""
        goal, failure = self.goal, self.failure
        demand(isinstance(failure, dict), "a failure is expected")
        if "at" in failure:
            (point,) = keys(failure, "at")
            self.fails_at(point, finding)
        elif "limit" in failure:
            self.other_limit(finding)
        else:
            (germ,) = keys(failure, "reaches")
            demand(finding == "consistent" and goal.is_limit, "reaching a limit shows consistency")
            germ, _ = self.open(germ, True)
            demand(germ.is_premised(goal.claim), "another limit is reached")

    def fails_at(self, point, finding):
        goal, claim = self.goal, self.goal.claim
        demand(not goal.is_limit, "a limit does not fail at a point")
        cases = HERE
        if finding != "consistent" and claim.form == "not implied":
            cases = goal.fails(claim.other, self.pieces)
        elif finding != "consistent" and claim.form == "relations":
            truth = {"refuted": False, "ill-defined": None}[finding]
            cases = regions(self.pieces.truth([goal.link]), truth)
        when = regions(self.pieces.truth(claim.when), True)
        formulas = [*self.domain, lambda: when, lambda: cases]
        check_point(goal, point, [self.variable], goal.range_of(self.variable), formulas)

    def other_limit(self, finding):
        goal, claim = self.goal, self.goal.claim
        number, other, side = keys(self.failure, "limit", "to", "side")
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
        demand(other != limit and self.differ(other, limit), "the limit is as claimed")
        germ = self.check_side(side, f, other, True)
        demand(germ.is_premised(statement), "a proof of another side")

    def demand_true(self, relations):
        """Conditions on constants are true at the values."""
        pieces = self.pieces.truth(relations)
        demand(pieces == [((), True)], "a condition is not met, or not evident")

    def differ(self, other, limit):
        """Is a number not what the limit is, or is that undefined?"""
        if isinstance(limit, str) or isinstance(other, str):
            return True
        return self.pieces.truth([("=", other, limit)]) in ([((), False)], [((), None)])
