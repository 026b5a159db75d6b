"""Derivatives of functions: the chain rule, derivatives of premises, and witnesses (the language, "Motion")."""

from fractions import Fraction

from . import angles, exponentials
from .errors import Rejected, demand
from .ties import Ties

RATIONAL = ("num", "sym", "def", "neg", "add", "sub", "mul", "div", "pow", "d")


class MetRate(Exception):
    """The derivative of a function has to be read as a symbol."""

    def __init__(self, name):
        super().__init__(name)
        self.name = name


def rate_name(document, function):
    """The symbol of the derivative of a function."""
    symbol = document.symbols[function]
    name = f"d({function}, {symbol.argument})"
    if name not in document.symbols:
        raise MetRate(function)
    return name


def rate(f, t, document, fail):
    """d f / d t by the chain rule."""
    if f[0] == "sym" and f[1] != t and f[1] not in document.points and f[1] not in document.exponentials:
        if document.symbols[f[1]].argument != t:
            return angles.ZERO
        return ("sym", rate_name(document, f[1]))
    names = document.mentioned(f)
    fixed = any(not document.symbols[e].argument for e in exponentials.holding(t, document) if e in names)
    for name in names:
        document.measured(name)
    if t in names or fixed:
        fail(f"`{t}` stands by itself in what is differentiated")
    total = angles.ZERO
    for name in document.symbols:  # in order of declaration
        if name not in names or document.symbols[name].argument != t:
            continue
        if name in document.points:
            angle = document.symbols[document.points[name]]
            cos, sin = angles.point(angle.name, angle.parts)
            slope = angles.negative(sin) if name == cos[1] else cos
            if angle.name != t:
                slope = angles.product(slope, ("sym", rate_name(document, angle.name)))
            if angle.parts > 1:
                slope = ("div", slope, ("num", angle.parts, 1))
        elif name in document.exponentials:
            slope = exponentials.slope(name, rate_inside(name, t, document), document)
        else:
            slope = ("sym", rate_name(document, name))
        total = angles.plus(total, angles.product(("d", f, name), slope))
    return total


def rate_inside(exponential, t, document):
    """The derivative of what is in an exponential."""
    of, total = document.exponentials[exponential][0], angles.ZERO
    for name, _ in of:
        if name != t and document.symbols[name].argument != t:
            continue
        slope = exponentials.product(of, without=name)
        if name != t:
            slope = angles.product(slope, ("sym", rate_name(document, name)))
        total = angles.plus(total, slope)
    return total


def derived(statement, t, document, fail):
    """The relations of the derivative of a premise."""
    if statement.kind != "given" or statement.when or statement.limits or not document.is_plain(t):
        fail("this cannot be differentiated")
    found = []
    for sign, *both in statement.relations:
        if sign != "=":
            fail("only equations are differentiated")
        for side in both:
            spoken = document.mentioned(side)
            if {t, *exponentials.holding(t, document)} & spoken or not rational(side, document):
                fail("this may not hold for all points, or have no derivative")
        found.append(("=", *(rate(side, t, document, fail) for side in both)))
    return found


def rational(expression, document):
    """Is it a quotient of polynomials?"""
    todo, seen = [expression], set()
    while todo:
        part = todo.pop()
        if part[0] not in RATIONAL:
            return False
        if part[0] == "def" and part[1] not in seen:
            seen.add(part[1])
            todo.append(document.symbols[part[1]].body)
        todo.extend(p for p in part[1:] if isinstance(p, tuple))
    return True


def check_witness(goal, claim, kind, content, rests):
    """Where derivatives are spoken of, functions pass through the point for which the premises hold."""
    document = goal.document
    if not any(name in document.rate_of for name in goal.mentioned):
        return
    demand(kind == "point", "functions do not show what derivatives are")
    demand(all(given in goal.cited for given in rests), "the witness is not one of all premises")
    Motion(goal, content).check()


class Motion:
    """The premises as equations for functions."""

    def __init__(self, goal, content):
        self.goal, self.document = goal, goal.document
        self.ties = Ties(self.document, [])
        self.content = content
        jets = filter(None, map(self.jet, goal.mentioned))
        self.top = {}
        for base, order in jets:
            self.top[base] = max(order, self.top.get(base, 0))

    def value(self, name):
        """The value of a symbol, if it is rational."""
        found = self.content["values"].get(name)
        if found is None or len(found) > 1:
            raise Rejected(f"`{name}` has no rational value")
        return Fraction(found[0]) if found else Fraction(0)

    def at(self, p):
        total = Fraction(0)
        for monomial, coefficient in p.items():
            for name, n in self.ties.ring.exponents(monomial):
                coefficient = coefficient * self.value(name) ** n
            total += coefficient
        return total

    def is_zero(self, p):
        """Does it vanish there, or is that not known?"""
        try:
            return self.at(p) == 0
        except Rejected:
            return True

    def jet(self, name):
        """Of which function a symbol is a derivative, and of which order."""
        if not self.document.symbols[name].argument:
            return None
        name, order = self.document.points.get(name, name), 0
        while name in self.document.rate_of:
            name, order = self.document.rate_of[name], order + 1
        return name, order

    def check(self):
        for name in self.goal.mentioned:
            symbol = self.document.symbols[name]
            for bound in (symbol.lower, symbol.upper) if self.jet(name) else ():
                if bound and not bound[1]:
                    demand(self.value(name) != bound[0], "a function is at the end of its range")
        units = {}
        for statement in self.goal.cited:
            if statement.kind == "given":
                self.sort(statement, units)
        found = []
        for orders in units.values():
            counts = {len(equations) for equations in orders.values()}
            whole = sorted(orders) == list(range(len(orders))) and len(counts) == 1
            demand(whole, "a derivative of a premise is left out")
            found += [list(unit) for unit in zip(*(orders[k] for k in sorted(orders)))]
        self.solve(found)

    def sort(self, statement, units):
        """Sorts the relations of a premise into equations and what holds nearby."""
        demand(not statement.limits, "a limit is no equation of motion")
        variables = {s.argument for s in self.document.symbols.values() if s.argument}
        circle = statement.relations[:1] if statement in self.document.circles.values() else ()
        base, order = statement, 0
        while base.derived_from:
            base, order = base.derived_from, order + 1
        for relation in statement.relations:
            names = self.document.mentioned(relation[1]) | self.document.mentioned(relation[2])
            functions = any(map(self.jet, names))
            if relation in circle or not (functions or names & variables):
                continue
            demand(not statement.when, "a premise has conditions")
            of = {self.document.symbols[name].argument or name for name in names}
            demand(len(of & variables) <= 1, "a premise speaks of two variables")
            gap = self.ties.gap(relation)
            demand(gap, "a premise is no quotient of polynomials")
            if relation[0] == "=":
                demand(functions, "a premise pins the variable")
                units.setdefault(id(base), {}).setdefault(order, []).append(gap[0])
            elif relation[0] in ("<=", ">="):
                demand(self.at(gap[0]) != 0, "a premise holds only just")

    def solve(self, units):
        """Takes units away one after the other, each solved for what no other one has."""
        while units:
            for unit in units:
                others = [p for other in units if other is not unit for p in other]
                if any(self.solves(name, unit, others) for name in self.ties.ring.variables(unit[0])):
                    units = [other for other in units if other is not unit]
                    break
            else:
                demand(self.together(units), "the premises are not solved for derivatives of functions")
                return

    def together(self, units):
        """Can single equations be solved together for as many highest derivatives?"""
        if any(len(unit) > 1 for unit in units):
            return False
        names = set().union(*(self.ties.ring.variables(unit[0]) for unit in units))
        highest = []
        for name in sorted(names - set(self.document.points)):
            jet = self.jet(name)
            if jet and jet[1] == self.top[jet[0]]:
                highest.append(name)
        rows = [[self.at(self.slope(unit[0], name)) for name in highest] for unit in units]
        return independent(rows)

    def solves(self, name, unit, others):
        jet = self.jet(name)
        if not jet or name in self.document.points:
            return False
        base, order = jet
        if self.top.get(base) != order + len(unit) - 1:
            return False
        for p in others:
            jets = filter(None, map(self.jet, self.ties.ring.variables(p)))
            if any(other == base and n >= order for other, n in jets):
                return False
        return not self.is_zero(self.slope(unit[0], name))

    def slope(self, p, name):
        """The derivative of a polynomial by a symbol."""
        slope = {}
        one = next(iter(self.ties.ring.variable(name)))
        for monomial, coefficient in p.items():
            n = dict(self.ties.ring.exponents(monomial)).get(name, 0)
            if n:
                slope[monomial - one] = coefficient * n
        return slope


def independent(rows):
    """Are the rows of a matrix linearly independent?"""
    rows = list(rows)
    while rows:
        first = rows.pop()
        pivot = next((i for i, value in enumerate(first) if value), None)
        if pivot is None:
            return False
        rows = [[a - b * row[pivot] / first[pivot] for a, b in zip(row, first)] for row in rows]
    return True
