"""Holds what a report says of a claim against points and structures."""

from fractions import Fraction

import structure as st
import told
import witness
from algebraic import Costly
from point import Ambiguous, Undefined, all_at, decimal, evaluate
from reader import Unreadable
from sampling import Place, aimed, spread


class Finding:
    """What is wrong with a verdict, or what could not be judged."""

    def __init__(self, grave, label, kind, message):
        self.grave, self.label, self.kind, self.message = grave, label, kind, message


class Judge:
    """All that is known about one document; `judge` goes through the claims of its report."""

    def __init__(self, document, rng, effort=1):
        self.document, self.rng, self.effort = document, rng, effort
        self.found = []
        self.judged = 0
        self.lines = 0  # of witnesses, that were read and held against values
        self.pool = None

    def wrong(self, claim, kind, message):
        self.found.append(Finding(True, claim.label, kind, message))

    def unjudged(self, claim, kind, message=""):
        self.found.append(Finding(False, claim.label, kind, message))

    def judge(self, report):
        statements = {s["label"]: s for s in report["statements"]}
        for claim in self.document.claims():
            shown = statements[claim.label]
            try:
                self.claim(claim, shown)
            except Unreadable as e:
                self.unjudged(claim, "unreadable witness", str(e))
            except (Ambiguous, Costly) as e:
                self.unjudged(claim, "too costly or open", str(e))
        return self.found

    def claim(self, claim, shown):
        pointwise = not self.concerns_limits(claim)
        verdicts = {link["verdict"] for link in shown["links"]}
        if pointwise and verdicts & {"proved", "vacuous", "refuted"}:
            self.at_points(claim, shown)
        for i, link in enumerate(shown["links"]):
            shows = ("proved",) if claim.shape == "not implied" else ("refuted", "ill-defined")
            if link["verdict"] in shows:
                self.witness(claim, i, link, shown)
        if self.document.structures:
            before = len(self.found)
            for s in self.document.structures:
                self.in_structure(claim, shown, s)
                if len(self.found) > before:
                    break
        self.model(claim, shown)

    def concerns_limits(self, claim):
        if claim.limit():
            return True
        cited = [self.document.find(label) for label in claim.cites]
        if claim.about:
            cited.append(self.document.find(claim.about))
        return any(s.limit() is not None or s.shape != "links" for s in cited)

    # --- points

    def places(self, claim):
        if self.pool is None:
            points = spread(self.document, self.rng, 24 * self.effort)
            self.pool = [Place(self.document, p) for p in points]
            self.points = points
        yield from self.pool
        for p in aimed(self.document, claim, self.points, self.rng, 14 * self.effort):
            yield Place(self.document, p)

    def at_points(self, claim, shown):
        """No point may satisfy the premises of what is vacuous or contradictory, or fail what is proved."""
        for place in self.places(claim):
            if place.premises(claim) is not True:
                continue
            for i, link in enumerate(shown["links"]):
                v = link["verdict"]
                if v == "vacuous":
                    self.wrong(claim, "vacuous", f"the premises hold at {place.shown()}")
                    return
                if claim.shape == "contradiction":
                    bad = v == "proved"
                elif claim.shape == "not implied":
                    bad = v == "refuted" and self.fails(place, self.document.find(claim.about)) is True
                else:
                    bad = v == "proved" and place.link(claim.links[i]) in (False, None)
                if bad:
                    self.wrong(claim, f"{v} {claim.shape}", f"link {i + 1} at {place.shown()}")
                    return

    def fails(self, place, statement):
        """Whether a statement is not true at a point, its conditions being met."""
        values = [all_at(statement.when, place.scope)] + [place.link(r) for r in statement.links]
        if "maybe" in values:
            return "maybe"
        return values[0] is True and any(v is not True for v in values[1:])

    # --- witnesses

    def witness(self, claim, i, link, shown):
        taken = witness.functions(link)
        if taken is not None:
            self.functions_refute(claim, i, link, taken)
            return
        values = witness.point(link)
        if values is None:
            self.unjudged(claim, "no witness in words", " / ".join(s["text"] for s in link["steps"][:3]))
            return
        self.judged += 1
        place = Place(self.document, witness.complete(self.document, values))
        mistakes, read = told.mistakes(link, place)
        self.lines += read
        for line in mistakes:
            self.wrong(claim, "witness", f"it is said that {line}")
        if not self.document.in_domain(place.values):
            self.wrong(claim, "witness", f"outside the domain: {place.shown()}")
            return
        for label in claim.cites:
            if self.document.find(label).limit() is None and place.truth(label) is False:
                self.wrong(claim, "witness", f"{label} does not hold at {place.shown()}")
                return
        v = all_at(claim.when, place.scope)
        if v is not True:
            self.wrong(claim, "witness", f"a condition does not hold at {place.shown()}")
            return
        if claim.shape == "contradiction":
            return
        if claim.shape == "not implied":
            if self.fails(place, self.document.find(claim.about)) is False:
                self.wrong(claim, "witness", f"{claim.about} does hold at {place.shown()}")
            return
        expected = {"refuted": False, "ill-defined": None}[link["verdict"]]
        found = place.link(claim.links[i])
        if found != "maybe" and found is not expected:
            a, b = (self.value(place, e) for e in claim.links[i][1:])
            self.wrong(claim, f"witness of {link['verdict']}", f"the claim is {found} at {place.shown()}: {a}, {b}")

    def value(self, place, e):
        try:
            return decimal(evaluate(e, place.scope))
        except Undefined as u:
            return f"undefined ({u})"
        except (Ambiguous, Costly):
            return "?"

    def limit_variable(self, claim):
        for label in [claim.label] + claim.cites + self.document.rests_on(claim) + ([claim.about] if claim.about else []):
            limit = self.document.find(label).limit()
            if limit:
                return limit.x
        return next((v.argument for v in self.document.vars if v.argument), None)

    def functions_refute(self, claim, i, link, taken):
        """Functions have to satisfy what is cited wherever the conditions on the limit variable hold."""
        x = self.limit_variable(claim)
        if x is None:
            self.unjudged(claim, "functions without a variable")
            return
        s = witness.structure(self.document, x, taken)
        self.judged += 1
        if claim.when and claim.limit() and not st.conditions_hold(claim.when, self.document, s):
            if taken:
                self.wrong(claim, "functions", f"a condition does not hold for {shown_structure(s)}")
                return
        if not self.satisfies(claim, s, x, link):
            return
        if claim.shape == "not implied":
            about = self.document.find(claim.about)
            if about.limit() and st.limit_holds(about.limit(), self.document, s) is True:
                self.wrong(claim, "functions", f"{claim.about} does hold for {shown_structure(s)}")
            return
        if claim.limit():
            if not taken and st.limit_holds(claim.limit(), self.document, s) is True:
                # nothing was chosen, so it may be that another constant refutes it
                others = [t for t in self.document.structures if st.limit_holds(claim.limit(), self.document, t) is not True]
                if others:
                    return
            if st.limit_holds(claim.limit(), self.document, s) is True:
                self.wrong(claim, "functions", f"the limit is as claimed for {shown_structure(s)}")
            return
        place = witness.failing_place(link)
        if place is None:
            return
        at = Place(self.document, witness.complete(self.document, {**s.values(place.get(x, Fraction(1))), **place}))
        if claim.shape == "links" and at.link(claim.links[i]) is True:
            self.wrong(claim, "functions", f"the claim holds at {at.shown()}")

    def satisfies(self, claim, s, x, link):
        """Whether the functions satisfy all that is cited; says so if not."""
        narrowing = []
        for label in claim.cites:
            g = self.document.find(label)
            if g.kind == "given":
                narrowing += [r for r in g.links if isinstance(r, tuple) and self.speaks_of(r) == {x}]
        for label in claim.cites:
            g = self.document.find(label)
            if g.limit():
                if st.conditions_hold(g.when, self.document, s) and st.limit_holds(g.limit(), self.document, s) is False:
                    self.wrong(claim, "functions", f"{label} does not hold for {shown_structure(s)}")
                    return False
        for v in st.places(self.document, s):
            try:
                place = Place(self.document, s.values(v))
            except Undefined:
                place = None
                scope = self.document.scope({x: v})
            if all_at(narrowing, place.scope if place else scope) is not True:
                continue
            if place is None:
                self.wrong(claim, "functions", f"a function is undefined at {x} = {v}: {shown_structure(s)}")
                return False
            if not self.document.in_domain(place.values):
                self.wrong(claim, "functions", f"outside the bounds at {x} = {v}: {shown_structure(s)}")
                return False
            bad = [label for label in claim.cites if place.truth(label) is False]
            if bad:
                self.wrong(claim, "functions", f"{bad[0]} fails at {x} = {v}: {shown_structure(s)}")
                return False
        return True

    def speaks_of(self, r):
        scope = self.document.scope({})
        return scope.symbols(r[1]) | scope.symbols(r[2])

    def model(self, claim, shown):
        """The model that is shown with a verdict has to satisfy the premises."""
        found = witness.model(shown)
        if not found or not found[1]:
            return
        kind, named = found
        if kind == "point" and not self.concerns_limits(claim):
            place = Place(self.document, witness.complete(self.document, named))
            if place.premises(claim) is False:
                self.wrong(claim, "model", f"not a model of the premises: {place.shown()}")

    # --- structures

    def in_structure(self, claim, shown, s):
        """What is proved is true in every structure in which the givens hold that it rests on."""
        document = self.document
        resting = document.rests_on(claim)
        narrower = [label for label in shown["rests_on"] if label in resting]
        givens = [document.find(label) for label in (narrower if shown["verdict"] == "proved" else resting)]
        if not all(st.given_true(g, document, s) is True for g in givens):
            return
        self.judged += 1
        verdicts = [link["verdict"] for link in shown["links"]]
        if claim.limit():
            if claim.when and not st.conditions_hold(claim.when, document, s):
                return
            if shown["verdict"] == "proved":
                if st.limit_holds(claim.limit(), document, s) is False:
                    self.wrong(claim, "limit proved", f"false for {shown_structure(s)}")
            elif shown["verdict"] == "vacuous" and self.reached(claim, s):
                self.wrong(claim, "limit vacuous", f"the givens hold near the limit for {shown_structure(s)}")
            return
        if not set(verdicts) & {"proved", "vacuous"} or shown["verdict"] == "unsupported" or claim.shape == "not implied":
            return
        plain = [g for g in givens if g.limit() is None]
        for v in st.places(document, s):
            place = Place(document, s.values(v))
            if not all(place.truth(g.label) is True for g in plain):
                continue
            if claim.when and all_at(claim.when, place.scope) is not True:
                continue
            for i, verdict in enumerate(verdicts):
                if verdict == "vacuous" or (verdict == "proved" and claim.shape == "contradiction"):
                    # the cited claims follow from the givens, so they hold here too
                    self.wrong(claim, f"{verdict} in a structure", f"all hold at {s.x} = {v} for {shown_structure(s)}")
                    return
                if verdict == "proved" and place.link(claim.links[i]) in (False, None):
                    self.wrong(claim, "proved in a structure", f"fails at {s.x} = {v} for {shown_structure(s)}")
                    return

    def reached(self, claim, s):
        """Whether all that is cited holds along the limit, on all sides that are meant."""
        from germ import approach

        for germ_at in st.sides(self.document, s.x, claim.limit()):
            place = Place(self.document, s.values(approach(*germ_at)))
            for label in claim.cites:
                if self.document.find(label).limit() is None and place.truth(label) is not True:
                    return False
        return True


def shown_structure(s):
    from expr import show

    parts = [f"{n} = {v}" for n, v in s.constants.items()] + [f"{n} = {show(e)}" for n, e in s.functions.items()]
    return ", ".join(parts)
