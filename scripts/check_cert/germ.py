"""Germs: one side of a point, and the states along it (section 6)."""

from dataclasses import dataclass
from functools import cache

from .bounds import allows
from .errors import demand
from .evidence import count, keys, listed, optional, polynomial, rational, text
from .expressions import parts
from .goal import HERE, State, regions
from .pieces import Pieces
from .polynomial import add, constant, multiply, negative
from .polynomial import power as raised


@dataclass
class Germ:
    """x = a + t, a - t, or t = 1/x, -1/x, for 0 < t < num/den."""

    variable: str
    at: object  # a rational number, or None for infinity
    above: bool
    conditions: list  # t, the radius and the binding

    def is_premised(self, statement):
        """Is a limit of a statement one from this side?"""
        place = (statement.variable, statement.at)
        return place == (self.variable, self.at) and self.above in statement.sides


def constant_names(goal, variable):
    """The symbols that do not vary with a variable."""
    document = goal.document
    return {
        s.name for s in document.symbols.values() if not s.body and not document.varies((s.name,), variable)
    }


def read_germ(goal, value):
    """A germ, and what is left of it: the proofs that it owes."""
    value, power = optional(value, "power", 1)
    variable, at, above, radius, positive, inside = keys(
        value, "variable", "at", "above", "radius", "positive", "inside"
    )
    demand(count(power) > 0, "a germ along no power of t")
    ring, names = goal.ring, constant_names(goal, text(variable))
    demand(goal.document.may_tend(variable), "a germ is one of a plain variable")
    demand(isinstance(above, bool), "a side is expected")
    at = None if at is None else rational(at)
    demand(allows(goal.document.symbols[variable], at, above), "the domain does not reach this side")
    num, den = (polynomial(p, ring) for p in listed(radius, 2))
    demand(ring.variables(num) | ring.variables(den) <= names, "the radius is not one of constants")
    x, t = ring.variable(variable), ring.variable("t:")
    step = raised(t, power)
    if at is None:
        binding = add(multiply(x if above else negative(x), step), constant(-1))
    else:
        n, d = at.numerator, at.denominator
        binding = add(multiply(add(x, negative(step) if above else step), constant(d)), constant(-n))
    conditions = [
        ring.condition(t, ">0"),
        ring.condition(add(num, negative(multiply(den, t))), ">0"),
        ring.condition(binding, "=0"),
    ]
    below = [(ring.condition(negative(p), ">=0"),) for p in (num, den)]
    return Germ(variable, at, above, conditions), positive, below, listed(inside)


def open_germ(proof, value, conditions, formulas, passes):
    """Checks all that a germ of a goal owes; returns it and the conditions on constants."""
    goal = proof.goal
    germ, positive, below, inside = read_germ(goal, value)
    proof.check(positive, conditions, [*formulas, lambda: below], passes)
    local = constant_conditions(goal, germ.variable, conditions)
    owed = [s for s in goal.cited + goal.behind if owes(goal, s, germ)]
    for given, entry in zip(owed, listed(inside, len(owed))):
        label, values, part = keys(entry, "given", "values", "proof")
        demand(label == given.label, "an obligation is missing, or not in its place")
        state = inside_range(goal, germ, local, given, values)
        proof.check(part, state.conditions, state.formulas)
    return germ, local


def constant_conditions(goal, variable, conditions):
    """The conditions that speak of constants alone."""
    names = constant_names(goal, variable)
    return [c for c in conditions if goal.ring.variables(c.poly) <= names]


def owes(goal, statement, germ):
    """Has it to be shown that a statement can hold along the germ?"""
    if statement.kind != "given":
        return False
    if goal.vacuous and statement in goal.cited and goal.is_limit and germ.is_premised(goal.claim):
        return False
    return any(goal.depends(r, germ.variable) for r in (*statement.relations, *statement.when))


def with_variable(names, variable):
    """Names, and the variable after them if it is not among them."""
    return names if variable in names else [*names, variable]


def along(goal, germ, local):
    """The state along a germ of a goal."""
    conditions = [*goal.ranges(with_variable(goal.mentioned, germ.variable)), *local, *germ.conditions]
    formulas = [cache(lambda s=s: goal.holds(s)) for s in goal.cited]
    for name, statement, item in goal.limits:
        if germ.is_premised(statement) and goal.counts(statement, item, germ.variable):
            formulas.append(cache(lambda n=name, s=statement, i=item: goal.bound_to(n, i[1], s)))
        else:
            formulas.append(lambda: HERE)
    formulas.append(cache(lambda: goal.when_of_constants(germ.variable)))
    return State(conditions, formulas)


def inside_range(goal, germ, local, given, values):
    """The state in which some values of functions do not meet a `given` along the germ."""
    document, goal = goal.document, goal.bare
    values = read_values(document, values)
    for name, expression in values.items():
        demand(document.symbols[name].argument == germ.variable, "a value of what is no function of x")
        demand(
            not any(document.symbols[s].argument == germ.variable for s in document.mentioned(expression)),
            "a value mentions a function of x",
        )
    pieces = Pieces(document, goal.ring, goal.roots, values)

    def failing():
        found = goal.fails(given, pieces)
        for name, value in values.items():
            found += out_of_range(pieces, value, document.symbols[name])
        return found

    told = goal.told_of_constants(germ.variable)
    mentioned = goal.mentions([*given.expressions(), *values.values(), *told])
    names = [name for name in mentioned if name not in values]
    conditions = [*goal.ranges(with_variable(names, germ.variable)), *local, *germ.conditions]
    formulas = goal.cited_constants(germ.variable)
    formulas.append(cache(lambda: goal.when_of_constants(germ.variable)))
    return State(conditions, [*formulas, cache(failing)])


def read_values(document, values):
    """Values of symbols, in the order of declaration: expressions without definitions."""
    demand(isinstance(values, dict), "values are expected")
    found = {}
    for name, value in values.items():
        symbol = document.symbols.get(name)
        demand(symbol is not None and not symbol.body, f"`{name}` is no symbol")
        found[name] = document.expression(text(value))
        demand(explicit(found[name]), "a value mentions a definition")
    # names of an object have no order
    return {name: found[name] for name in document.symbols if name in found}


def explicit(expression):
    """Is an expression without definitions?"""
    return expression[0] != "def" and all(explicit(part) for part in parts(expression))


def out_of_range(pieces, value, symbol):
    """The cases in which a value is undefined, or outside the range of its symbol."""
    relations = [("=", value, value)]
    for bound, sign in ((symbol.lower, ">"), (symbol.upper, "<")):
        if bound:
            number = ("num", bound[0].numerator, bound[0].denominator)
            relations.append((sign if bound[1] else sign + "=", value, number))
    return regions(pieces.truth(relations), False, None)
