"""Proofs: that no point satisfies all conditions and one case of each formula (section 6)."""

from .errors import Rejected, demand
from .evidence import condition, count, integer, keys, listed, polynomial, text
from .germ import along, constant_names, open_germ
from .polynomial import OPPOSITE, add_product, holds, is_constant, multiply, negative


ANY = object()  # variable


class Proof:
    """Checks proofs for a goal.

    `passes` says along which variables a proof may pass to a limit: any, one,
    or none.
    """

    def __init__(self, goal):
        self.goal, self.ring = goal, goal.ring

    def check(self, proof, conditions, formulas, passes=None):
        """Checks a proof from a list of conditions, and formulas."""
        demand(isinstance(proof, dict), "a proof is expected")
        if "assume" in proof:
            number, cases = keys(proof, "assume", "cases")
            regions = formulas[count(number, len(formulas))]()
            for case, region in zip(listed(cases, len(regions)), regions):
                self.check(case, [*conditions, *region], formulas, passes)
        elif "split" in proof:
            self.check_split(proof, conditions, formulas, passes)
        elif "positive" in proof:
            self.check_sum(proof, conditions)
        elif "pass" in proof:
            self.check_pass(proof, conditions, formulas, passes)
        else:
            raise Rejected("there is no such step")

    def check_split(self, proof, conditions, formulas, passes):
        """The cases admit each sign that the polynomial can have."""
        for part, then in self.cases(proof):
            self.check(then, [*conditions, part], formulas, passes)

    def cases(self, proof):
        """The condition of each case of a split, with what there is for it; at the end, that they leave out no sign."""
        poly, cases = keys(proof, "split", "cases")
        poly, admitted = polynomial(poly, self.ring), set()
        for case in listed(cases):
            opposite, sign, then = keys(case, "opposite", "is", "then")
            demand(isinstance(opposite, bool), "it is to be said whether the opposite is meant")
            demand(text(sign) in OPPOSITE, "there is no such sign")
            admitted |= {(-s if opposite else s) for s in (-1, 0, 1) if holds(s, sign)}
            yield self.ring.condition(negative(poly) if opposite else poly, sign), then
        demand(len(admitted) == 3, "the cases leave out a sign")

    def check_sum(self, proof, conditions):
        """The sum vanishes identically, although one summand is positive."""
        summands, cofactors = keys(proof, "positive", "cofactors")
        total, strict = {}, False
        for summand in listed(summands):
            weight, square, factors = listed(summand, 3)
            weight, square = integer(weight), polynomial(square, self.ring)
            demand(weight > 0, "a weight is not positive")
            product, visibly, used = {0: weight}, bool(square) and is_constant(square), set()
            for factor in listed(factors):
                number, n = listed(factor, 2)
                number = count(number, len(conditions))
                part, n = conditions[number], count(n)
                demand(n > 0 and number not in used, "a factor stands twice, or its power is 0")
                demand(part.sign != "=0", "an equation stands among the factors")
                demand(part.sign != "!=0" or n % 2 == 0, "the sign of a factor is not known")
                visibly = visibly and part.sign != ">=0"
                used.add(number)
                product = multiply(product, part.power(n))
            strict = strict or visibly
            add_product(total, product, multiply(square, square))
        used = set()
        for cofactor in listed(cofactors):
            number, poly = listed(cofactor, 2)
            part = conditions[count(number, len(conditions))]
            demand(number not in used and part.sign == "=0", "a cofactor does not belong to an equation")
            used.add(number)
            add_product(total, polynomial(poly, self.ring), part.poly)
        demand(strict, "no summand is visibly positive")
        demand(not any(total.values()), "the sum does not vanish")

    def check_pass(self, proof, conditions, formulas, passes):
        """A condition holds along a germ, hence at its end."""
        germ, part, proof_along, then = keys(proof, "pass", "condition", "along", "then")
        demand(passes is not None and self.goal.has_limits, "no limit is passed to here")
        germ, local = open_germ(self, germ, conditions, formulas, passes)
        demand(passes in (ANY, germ.variable), "a pass in another variable than that of the limit")
        part = condition(part, self.ring)
        demand(part.sign in ("=0", ">=0"), "this sign is not kept in a limit")
        allowed_at_end(self.goal, germ, part.poly)
        state = along(self.goal, germ, local)
        self.check(proof_along, [*state.conditions, self.ring.opposite(part)], state.formulas)
        end = self.ring.condition(self.ring.coefficient(part.poly, "t:", 0), part.sign)
        self.check(then, [*conditions, end], formulas, passes)


def allowed_at_end(goal, germ, poly):
    """A polynomial of which it is known what it tends to along a germ."""
    limits = {
        name
        for name, statement, item in goal.limits
        if germ.is_premised(statement) and goal.counts(statement, item, germ.variable)
    }
    roots = {
        name for radicand, name in goal.roots.items() if not goal.document.depends(radicand, germ.variable)
    }
    unknown = goal.ring.variables(poly) - constant_names(goal, germ.variable) - roots - limits - {"t:"}
    demand(not unknown, f"{', '.join(sorted(unknown))} may not stand in what passes to the limit")
