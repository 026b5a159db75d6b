"""Documents: symbols, definitions and statements, read from the text."""

import re
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache, cached_property

from .blocks import statements
from .bounds import allows, pi_bounds
from . import angles, arrays, bounds, exponentials, logic, motion, sequences, shift, sums, templates, terms
from .units import Units, read as read_unit
from .errors import Rejected, Unreadable, demand
from .evidence import text as written_text
from .expressions import GREEK, MATHEMATICAL, RESERVED, Reader, parts, symbols_in
from .ties import Ties

SMALL_GREEK = sorted({name for name in GREEK.values() if name.islower()}, key=len, reverse=True)
MAX_ORDER = 6
VERDICTS = ("proved", "refuted", "ill-defined", "vacuous", "unsupported", "undecided")


@dataclass
class Symbol:
    """What a name stands for: an unknown, or a definition."""

    name: str
    argument: str = None  # of which variable it is a function
    lower: tuple = None  # (rational, whether the bound is strict)
    upper: tuple = None
    floor: tuple = None  # (expression, whether the bound is strict)
    ceiling: tuple = None
    body: tuple = None  # of a definition
    parts: int = None  # of an angle: into how many equal parts it is cut
    unit: dict = None  # powers of base units


@dataclass(eq=False)
class Statement:
    """A `given`, a `claim`, or the label of a definition."""

    kind: str
    label: str
    items: list = field(default_factory=list)  # (relation, left, right) or ("->", f, L)
    form: str = "relations"  # or "contradiction", "not implied"
    other: "Statement" = None  # what is not implied
    variable: str = None  # of its limits
    moving: str = None  # what tends to a point that is no number, where the variable is its distance
    at: Fraction = None  # None is infinity
    sides: tuple = ()  # True is from above, and oo
    when: tuple = ()
    cited: list = field(default_factory=list)
    expect: str = None
    derived_from: "Statement" = None  # of which premise it is the derivative
    exists: bool = False  # a witness is put in, and only a proof decides
    sought: tuple = ()  # the names for which the certificate has a witness
    range: tuple = None  # (index, its first value)
    induction: tuple = None  # the same, of a claim that is to be shown so

    @cached_property
    def relations(self):
        return tuple(item for item in self.items if item[0] != "->")

    @cached_property
    def limits(self):
        return [item for item in self.items if item[0] == "->"]

    def put_in(self, witnesses):
        """Puts expressions in the place of what is bound."""
        self.items = [
            (sign, *(templates.replaced(side, witnesses) for side in sides)) for sign, *sides in self.items
        ]
        for known in ("relations", "limits"):
            self.__dict__.pop(known, None)

    def expressions(self):
        """All expressions that it consists of."""
        for _, left, right in (*self.items, *self.when):
            yield left
            if isinstance(right, tuple):
                yield right


class Document:
    """All that a document says."""

    def __init__(self, text):
        wanted = {}  # symbols that are angles, which is seen only where they are used
        orders = {}  # how often functions are differentiated
        self.exponents = {}  # what is exponentiated, in how many parts, and what has a logarithm
        self.limited = set()  # the variables of limits
        self.shifted = set()  # what tends to points that are no numbers
        self.alone = set()  # angles that stand by themselves, too
        self.sums, self.count = [], 0  # sums up to an index, and in which statement they are met
        self.powers = set()  # bases and indices of powers
        while True:
            self.symbols, self.statements, self.claims = {}, {}, []
            self.mentions, self.printed, self.circles, self.wanted = {}, {}, {}, wanted
            self.points, self.rate_of, self.orders, self.arcs = {}, {}, orders, {}
            self.exponentials, self.bounds_of = {}, {}  # by symbol: of what, and how many parts; what holds
            self.arrays, self.templates = {}, {}
            self.ranges = {}  # by symbol: what its bounds say that are expressions
            self.sequences = sequences.Sequences(self)
            try:
                self.late = None  # a fault, unless the symbol turns out to be an angle
                for self.count, statement in enumerate(statements(text)):
                    sums.declare(self)
                    self.read(Reader(statement, self))
                met = {s.variable for s in self.statements.values() if s.variable} - self.limited
                self.limited |= met
                if not any(exponentials.holding(name, self) or self.is_angle(name) for name in met):
                    break
            except angles.Met as met:
                wanted[met.name] = met.parts
            except angles.MetAlone as met:
                self.alone.add(met.name)
            except exponentials.Met as met:
                self.exponents[met.of, "exp" if met.parts else "log"] = met.parts
            except sequences.MetPower as met:
                if (met.base, met.index) in self.powers:
                    raise Unreadable("a power is used above its base or its index") from None
                self.powers.add((met.base, met.index))
            except sums.Met as met:
                if any(met.name == name for name, _ in self.sums):
                    raise Unreadable(f"`{met.name}` is used above what it speaks of") from None
                self.sums.append((met.name, self.count))
            except shift.Met as met:
                self.shifted.add(met.name)
            except motion.MetRate as met:
                name, order = met.name, 1
                while name in self.rate_of:
                    name, order = self.rate_of[name], order + 1
                if order > MAX_ORDER:
                    raise Unreadable(f"`{name}` is differentiated too often") from None
                orders[name] = order
        if self.late:
            raise Unreadable(self.late)

        Units(self).check()

    def use(self, name, reader):
        """The expression that a name stands for."""
        symbol = self.symbols.get(name) or reader.fail("unknown symbol")
        if reader.in_term and self.sequences.index_of(name):
            reader.fail("a term of a sum up to an index speaks of no index itself")
        if not reader.in_angle:
            self.measured(name)
        return ("def" if symbol.body else "sym", name)

    def is_angle(self, name):
        symbol = self.symbols.get(name)
        return symbol is not None and symbol.parts is not None

    def measured(self, name):
        """An angle that stands by itself is known as a number, too."""
        if self.is_angle(name) and name not in self.alone | self.limited:
            raise angles.MetAlone(name)

    def may_tend(self, name):
        """Is it the variable of a limit, a plain one or an angle that is no function?"""
        return self.is_plain(name) or self.is_angle(name) and not self.symbols[name].argument

    def is_plain(self, name):
        """Is it a variable that is neither a function nor defined?"""
        symbol = self.symbols.get(name)
        index = name in self.sequences.indices
        return symbol is not None and not (symbol.argument or symbol.body or symbol.parts or index)

    def expression(self, text):
        """Reads an expression from the certificate."""
        try:
            reader = Reader(text, self)
            expression = reader.sum()
            reader.done()
        except Unreadable as reason:
            raise Rejected(str(reason)) from None
        except (sequences.MetPower, sums.Met):
            raise Rejected("there is no such power or sum") from None
        return expression

    def mentioned(self, expression):
        """The unknowns in an expression, definitions followed."""
        known = self.mentions.get(id(expression))
        if known is None:
            names, found = set(), set()
            symbols_in(expression, names)
            for name in names:
                body = self.symbols[name].body
                found |= self.mentioned(body) if body else {name}
            known = self.mentions[id(expression)] = (frozenset(found), expression)
        return known[0]

    def roots(self, expression, found, seen):
        """Adds the radicands of all roots, definitions followed."""
        if expression[0] == "sqrt":
            found.add(expression[1])
        if expression[0] == "def" and expression[1] not in seen:
            seen.add(expression[1])
            self.roots(self.symbols[expression[1]].body, found, seen)
        for part in parts(expression):
            self.roots(part, found, seen)

    def varies(self, names, variable):
        """Does one of these unknowns vary with the variable?"""
        return any(name == variable or self.symbols[name].argument == variable for name in names)

    def depends(self, expression, variable):
        """Does an expression depend on the variable?"""
        return self.varies(self.mentioned(expression), variable)

    def declare_name(self, name, **what):
        self.declare(Symbol(name, **what))

    def declare(self, symbol):
        self.take_name(symbol.name)
        self.symbols[symbol.name] = symbol

    def take_name(self, name):
        """A name is declared once, and looks like no other."""
        known = (self.symbols, self.arrays, self.templates, self.sequences.terms)
        if any(name in names for names in known):
            raise Unreadable(f"`{name}` is already declared")
        alike = self.printed.setdefault(printed(name), name)
        if alike != name:
            raise Unreadable(f"`{name}` and `{alike}` look the same in print")

    def add(self, statement):
        if statement.label in self.statements:
            raise Unreadable(f"duplicate label `{statement.label}`")
        self.statements[statement.label] = statement

    def cite(self, reader):
        if reader.text.startswith("d(", reader.start):
            return self.cite_derivative(reader)
        label = reader.label()
        return self.statements.get(label) or reader.fail(f"undeclared label `{label}`")

    def cite_derivative(self, reader):
        """Reads `d(LABEL, t)`; the derivative is a premise of its own."""
        reader.expect("d")
        reader.at = reader.start + 1  # what follows is a label
        reader.advance()
        base = self.cite(reader)
        reader.expect(",")
        variable = reader.name()
        reader.expect(")")
        label = f"d({base.label}, {variable})"
        if label not in self.statements:
            relations = motion.derived(base, variable, self, reader.fail)
            self.add(Statement("given", label, relations, derived_from=base))
        return self.statements[label]

    def read(self, reader):
        """Reads one statement."""
        if reader.take("var"):
            self.read_symbol(reader)
            while reader.take(","):
                self.read_symbol(reader)
            terms.declare_powers(self)
            self.declare_exponentials(reader)
        elif reader.take("let"):
            self.read_definition(reader)
            terms.declare_powers(self)
        elif kind := reader.take("given", "claim"):
            self.read_statement(kind, reader)
        else:
            reader.fail("a statement begins with `var`, `let`, `given` or `claim`")
        reader.done()

    def read_symbol(self, reader):
        """Reads a name with its bounds on either side."""
        ends = []
        if pi_bounds(reader, None) or bounds.stands_first(reader):
            end = self.bound(reader)
            ends.append((end, reader.take("<", "<=", ">", ">=") or reader.fail("expected `<`"), True))
        symbol = Symbol(reader.name())
        if reader.take("("):
            symbol.argument = reader.name()
            reader.expect(")")
            if not self.is_plain(symbol.argument):
                reader.fail("a function is one of a plain variable")
        if sign := reader.take("<", "<=", ">", ">="):
            ends.append((self.bound(reader), sign, False))
        signs = [sign for _, sign, _ in ends]
        for bound, sign, before in ends:
            lower = before == (sign[0] == "<")
            written = isinstance(bound, tuple)
            if (symbol.lower or symbol.floor) if lower else (symbol.upper or symbol.ceiling):
                reader.fail("a bound is given twice")
            key = ("floor" if lower else "ceiling") if written else "lower" if lower else "upper"
            setattr(symbol, key, (bound, len(sign) == 1))
        within = reader.take("in")
        if within and reader.take("N"):
            self.read_unit(symbol, reader)
            terms.declare_index(self, symbol, signs, reader)
            return
        if within:
            matrix, size = arrays.space(reader)
            if signs:
                reader.fail("a vector or a matrix has no bounds")
            self.read_unit(symbol, reader)
            parts = arrays.names(symbol.name, matrix, size)
            for part in parts:
                self.enter_symbol(Symbol(part, symbol.argument, unit=symbol.unit), reader)
            self.take_name(symbol.name)
            self.arrays[symbol.name] = arrays.of_names([("sym", part) for part in parts], matrix, size)
            return
        self.read_unit(symbol, reader)
        self.enter_symbol(symbol, reader)

    def read_unit(self, symbol, reader):
        if reader.take("["):
            symbol.unit = read_unit(reader)

    def enter_symbol(self, symbol, reader):
        """Declares a symbol that has its bounds."""
        if symbol.name in self.wanted:
            self.declare_angle(symbol, reader)
            return
        for key in ("lower", "upper"):
            bound = getattr(symbol, key)
            if bound and isinstance(bound[0], dict):
                self.late = self.late or f"`{symbol.name}` is bounded by multiples of pi, but no angle"
                setattr(symbol, key, None)
        self.check_range(symbol, reader)
        self.declare(symbol)
        if said := bounds.relations(symbol):
            if any(bounds.unfit(side, self) for item in said for side in item[1:] if side != ("sym", symbol.name)):
                reader.fail("a bound is an expression in plain symbols")
            self.ranges[symbol.name] = Statement("given", f"bounds {symbol.name}", said)
            self.add(self.ranges[symbol.name])
        self.declare_rates(symbol)
        if symbol.name in self.shifted:
            self.declare(Symbol(shift.distance(symbol.name), unit=symbol.unit))

    def declare_exponentials(self, reader):
        """The exponentials and logarithms whose symbols are known by now, and the `given` of each."""
        by_name = sorted(self.exponents, key=lambda key: (key[1], sorted(key[0])))
        for of, function in by_name:
            parts = self.exponents[of, function]
            name = exponentials.symbol_name(of, parts)
            if name in self.symbols or not all(base in self.symbols for base, _ in of):
                continue
            lower, upper = exponentials.bounds(of, parts, self)
            self.declare(Symbol(name, exponentials.variable(of, self, reader.fail), lower, upper))
            self.exponentials[name] = (of, parts)
            given = Statement("given", name[:-1].replace("(", " ", 1), exponentials.relations(of, parts))
            self.add(given)
            self.bounds_of[name] = given

    def declare_rates(self, symbol):
        """The derivatives of a function that are spoken of."""
        for _ in range(self.orders.get(symbol.name, 0) if symbol.argument else 0):
            rate = Symbol(f"d({symbol.name}, {symbol.argument})", symbol.argument)
            self.declare(rate)
            self.rate_of[rate.name] = symbol.name
            symbol = rate

    def declare_angle(self, symbol, reader):
        """An angle, the point of its part, and the `given` that says where that lies."""
        if bounds.relations(symbol):
            reader.fail("the bounds of an angle are multiples of pi")
        ends = []
        for key, infinite in (("lower", "-oo"), ("upper", "oo")):
            bound, strict = getattr(symbol, key) or (infinite, True)
            if isinstance(bound, str):
                if (bound, strict) != (infinite, True):
                    reader.fail("the domain is empty")
                ends.append(None)
            elif isinstance(bound, dict):
                ends.append((bound["pi"], strict))
            elif bound:
                reader.fail("the bounds of an angle are multiples of pi")
            else:
                ends.append((bound, strict))
        symbol.lower = symbol.upper = None
        symbol.parts = self.wanted[symbol.name]
        alone = symbol.name in self.alone | self.limited
        if alone:
            symbol.lower, symbol.upper = (end if end and end[0] == 0 else None for end in ends)
        self.declare(symbol)
        argument = symbol.name if symbol.name in self.limited else symbol.argument
        for part in angles.point(symbol.name, symbol.parts):
            self.declare(Symbol(part[1], argument))
            self.points[part[1]] = symbol.name
        rates = self.orders.get(symbol.name, 0)
        self.declare_rates(symbol if rates else Symbol(symbol.name))
        given = Statement("given", f"angle {symbol.name}", angles.circle(symbol, ends, self))
        self.add(given)
        for part in angles.point(symbol.name, symbol.parts):
            self.circles[part[1]] = given
        if alone:
            given = Statement("given", f"arc {symbol.name}", angles.arc(symbol, ends))
            self.add(given)
            self.arcs[symbol.name] = given

    def spoken(self, statement):
        """The `given`s of the angles of which a claim or what it cites speaks."""
        names = set()
        others = [statement.other] if statement.other else []
        for said in (statement, *statement.cited, *others):
            for expression in said.expressions():
                names |= self.mentioned(expression)
            names |= {said.variable} - {None}
        found = {id(self.circles[name]): self.circles[name] for name in names if name in self.circles}
        for name, given in self.arcs.items():
            point = {part[1] for part in angles.point(name, self.symbols[name].parts)}
            if name in names and (names & point or len(given.items) > angles.TAYLOR):
                found[id(given)] = given
        for name, given in self.bounds_of.items():
            if name in names and names & dict(self.exponentials[name][0]).keys():
                found[id(given)] = given
        order = list(self.statements.values())
        return sorted(found.values(), key=order.index)

    def check_range(self, symbol, reader):
        """A range has points, and an infinite bound is none."""
        for key, infinite in (("lower", "-oo"), ("upper", "oo")):
            bound = getattr(symbol, key)
            if bound and isinstance(bound[0], str):
                if bound != (infinite, True):
                    reader.fail(f"the domain of `{symbol.name}` is empty")
                setattr(symbol, key, None)
        if symbol.lower and symbol.upper:
            (low, open_low), (high, open_high) = symbol.lower, symbol.upper
            if low > high or (low == high and (open_low or open_high)):
                reader.fail(f"the domain of `{symbol.name}` is empty")

    def bound(self, reader):
        """Reads a number, an infinite one, a multiple of pi, or another expression."""
        if infinite := self.infinite(reader):
            return infinite
        outer, reader.in_angle = reader.in_angle, True
        expression = reader.sum()
        reader.in_angle = outer
        value = bounds.number(expression)
        if value is not None:
            return value
        total = angles.summed(expression)
        if total is not None and bounds.of_pi(expression) and set(total) <= {"pi"}:
            return {"pi": total.get("pi", Fraction(0))}
        return expression

    def infinite(self, reader):
        """Reads `oo` or `-oo`, if one is there."""
        before = reader.at, reader.start, reader.kind, reader.word
        minus = reader.take("-")
        if reader.take("oo"):
            return "-oo" if minus else "oo"
        reader.at, reader.start, reader.kind, reader.word = before
        return None

    def read_definition(self, reader):
        start = reader.at, reader.start, reader.kind, reader.word
        label = reader.label()
        if reader.kind == "sign" and reader.word in (":=", "("):
            reader.at, reader.start, reader.kind, reader.word = start
            label = None
        name = reader.name()
        parameters = ()
        if reader.take("("):
            if reader.kind == "number":
                self.add(Statement("let", label or name))
                terms.read_recursion(self, name, reader)
                return
            if reader.word in self.sequences.indices:
                self.add(Statement("let", label or name))
                terms.read_term(self, name, reader)
                return
            parameters = self.bound_names(reader)
            reader.expect(")")
        reader.expect(":=")
        if name in MATHEMATICAL:
            reader.fail(f"`{name}` has a meaning of its own")
        self.add(Statement("let", label or name))
        reader.bound = parameters
        body = reader.value()
        if not parameters and self.sequences.spoken(templates.components(body)):
            reader.fail("a plain definition varies with no index")
        if parameters:
            self.all_used(parameters, templates.components(body), reader)
            self.take_name(name)
            self.templates[name] = templates.Template(name, len(parameters), body)
        elif isinstance(body, arrays.Array):
            names = arrays.names(name, *body.kind)
            for part, expression in zip(names, body.parts()):
                self.declare(Symbol(part, body=expression))
            self.take_name(name)
            self.arrays[name] = arrays.of_names([("def", part) for part in names], *body.kind)
        else:
            self.declare(Symbol(name, body=body))

    def bound_names(self, reader):
        """Reads names of arguments, which nothing has so far."""
        names = [reader.name()]
        while reader.take(","):
            names.append(reader.name())
        if len(set(names)) < len(names) or len(names) > templates.MAX_PARAMETERS:
            reader.fail("a name stands twice, or there are too many")
        if not all(map(reader.is_free, names)):
            reader.fail("an argument has a name of its own")
        return tuple(names)

    def all_used(self, names, expressions, reader):
        found = set().union(*map(templates.found_in, expressions))
        if len(found) < len(names):
            reader.fail("an argument is not used")

    def read_statement(self, kind, reader):
        label = reader.label()
        reader.expect(":")
        statement = Statement(kind, label)
        if kind == "claim" and reader.take("contradiction"):
            statement.form = "contradiction"
        elif kind == "claim" and reader.take("not"):
            reader.expect("implied")
            statement.form, statement.other = "not implied", self.cite(reader)
            other = statement.other
            if other.kind == "let" or other.form != "relations" or other.exists:
                reader.fail("this states nothing")
        elif kind == "claim" and reader.take("exists"):
            statement.exists = True
            reader.bound = bound = self.bound_names(reader)
            reader.expect(":")
            statement.items = list(reader.relations())
            reader.bound = ()
        else:
            self.read_items(statement, reader)
        if statement.limits:
            self.read_limit_point(statement, reader)
        if kind == "claim" and reader.word == "for" and statement.form == "relations" and not statement.limits:
            terms.read_range(self, statement, reader)
        if reader.take("when"):
            statement.when = (*statement.when, *reader.relations())
        if kind == "claim":
            self.read_support(statement, reader)
        if statement.exists:
            self.put_witnesses(statement, bound, reader)
            if reader.take("expect"):
                self.read_expectation(statement, reader)
        written = list(statement.cited)
        if kind == "claim" and self.ranges:
            others = [statement.other] if statement.other else []
            ranges = bounds.spoken(self, (statement, *statement.cited, *others))
            statement.cited += [s for s in ranges if s not in statement.cited]
        self.check(statement, reader)
        if kind == "claim" and (self.circles or self.bounds_of or self.ranges):
            order = list(self.statements.values())
            made = {id(s): s for s in (*statement.cited, *self.spoken(statement)) if s not in written}
            statement.cited = written + sorted(made.values(), key=order.index)
        self.add(statement)
        if kind == "claim":
            self.claims.append(statement)

    def put_witnesses(self, statement, names, reader):
        """Reads `by y := …` and puts the witnesses in; without it they are left to the certificate."""
        found = {}
        said = [side for item in statement.items for side in item[1:]]
        if not reader.take("by"):
            if any(bounds.has("d", e, self) for e in said):
                reader.fail("beside a derivative nothing is looked for")
            self.all_used(names, said, reader)
            statement.sought = names
            return
        while True:
            name = reader.name()
            if name not in names or name in found:
                reader.fail("no such name is bound, or it has its witness")
            reader.expect(":=")
            found[name] = reader.sum()
            if not reader.take(","):
                break
        if len(found) < len(names):
            reader.fail("a witness is missing")
        self.all_used(names, said, reader)
        statement.put_in([found[name] for name in names])

    def find(self, statement, witness):
        """Puts in what a certificate names for something that is looked for."""
        demand(isinstance(witness, dict) and set(witness) == set(statement.sought), "a witness for each name is expected")
        values = [self.expression(written_text(witness[name])) for name in statement.sought]
        spoken = set().union(*map(self.mentioned, statement.expressions()))
        demand(all(self.mentioned(value) <= spoken for value in values), "a witness speaks of something else")
        demand(not any(bounds.has("d", e, self) for e in values), "a witness is no derivative")
        statement.put_in(values)
        statement.sought = ()

    def read_items(self, statement, reader):
        while True:
            left = None if logic.encloses_relations(reader) else reader.value()
            if left is not None and reader.take("->"):
                limit = self.infinite(reader) or reader.sum()
                statement.items.append(("->", reader.number(left), limit))
            else:
                statement.items += logic.formula(reader, left)
            if not reader.take(","):
                return

    def read_limit_point(self, statement, reader):
        reader.expect("as")
        statement.variable = variable = reader.name()
        if not self.may_tend(variable):
            reader.fail("the variable of a limit is a plain variable")
        reader.expect("->")
        symbol = self.symbols[variable]
        infinite = self.infinite(reader)
        if infinite:
            meant = (infinite == "oo",)
        else:
            point = shift.point(reader)
            side = reader.take("+", "-")
            meant = (True, False) if side is None else (side == "+",)
            statement.at = bounds.number(point)
            if statement.at is None:
                shift.read(self, statement, point, reader)
                symbol = self.symbols[statement.variable]
        statement.sides = tuple(side for side in meant if allows(symbol, statement.at, side))
        if not statement.sides:
            reader.fail(f"the domain of `{variable}` does not reach this point")

    def read_support(self, statement, reader):
        if reader.take("from"):
            while True:
                cited = self.cite(reader)
                if cited.form != "relations":
                    reader.fail("this states nothing that could be used")
                chain = [cited]
                while chain[0].derived_from:
                    chain.insert(0, chain[0].derived_from)
                for said in chain:
                    if said.kind != "let" and said not in statement.cited:
                        statement.cited.append(said)
                if not reader.take(","):
                    break
        if statement.form != "not implied" and not statement.limits and reader.take("using"):
            # Hints to the search: what they led to is checked, and they say nothing.
            while True:
                reader.sum()
                if not reader.take(","):
                    break
        plain = statement.form == "relations" and not statement.limits and not statement.exists
        if plain and reader.take("by"):
            reader.expect("induction")
            statement.induction = statement.range or reader.fail("`by induction` needs `for n >= 0`")
        if statement.form == "not implied" and reader.take("by"):
            while True:
                reader.name()
                reader.expect(":=")
                reader.sum()
                if not reader.take(","):
                    break
        if reader.take("expect"):
            self.read_expectation(statement, reader)

    def read_expectation(self, statement, reader):
        statement.expect = reader.label()
        if statement.expect not in VERDICTS:
            reader.fail("there is no such verdict")

    def check(self, statement, reader):
        """What has no meaning is an error."""
        self.sequences.check(statement, reader)
        variable = statement.variable
        for _, _, limit in statement.limits:
            if isinstance(limit, tuple) and self.depends(limit, variable):
                reader.fail(f"the limit must be free of `{variable}`")
        moving = statement.moving or variable
        for _, left, right in statement.when if variable else ():
            if self.depends(left, moving) or self.depends(right, moving):
                reader.fail(f"the `when` of a limit must be free of `{moving}`")
        shift.check(self, statement, reader)
        relations = [*statement.when]
        for cited in statement.cited:
            relations += [*cited.relations, *cited.when]
        ties, seen = cache(lambda: Ties(self, relations)), set()
        others = [*statement.cited, *([statement.other] if statement.other else [])]
        if any(cited.sought for cited in statement.cited):
            if any(bounds.has("d", e, self) for spoken in [statement, *others] for e in spoken.expressions()):
                reader.fail("what is looked for is not cited beside a derivative")
        for spoken in [statement, *others]:
            for expression in spoken.expressions():
                self.check_derivatives(expression, (), ties, seen, reader)

    def varied(self, variable):
        """What varies with a variable of a derivative: cosine and sine vary together."""
        if self.symbols[variable].argument:
            return set()  # a function, beside which others may vary
        together = self.of_angle(variable) or {variable}
        return together | set(exponentials.holding(variable, self))

    def of_angle(self, name):
        """An angle, its cosine and its sine, if the name is one of these."""
        angle = self.points.get(name, name)
        points = {point for point, whose in self.points.items() if whose == angle}
        return points | {angle} if points else set()

    def inside(self, name):
        """A symbol, and those that stand in what it stands for: k and x in exp(k*x), an angle behind its sine."""
        names = {name, *dict(self.exponentials[name][0])} if name in self.exponentials else {name}
        return names.union(*map(self.of_angle, names))

    def check_derivatives(self, expression, variables, ties, seen, reader):
        """What is differentiated is explicit, and nothing in it is tied to the variable."""
        kind, name = expression[:2]
        if kind == "d" and expression[2] not in self.exponentials:
            # beside one by an exponential there is one by what is in it
            variables = (*variables, expression[2])
        elif kind == "sym":
            for variable in variables:
                if self.symbols[name].argument == variable:
                    reader.fail(f"a derivative by `{variable}` needs `{name}` explicit")
                together = self.varied(variable)
                held = self.inside(name) - together
                if together and any(held & ties().to(v) for v in together):
                    reader.fail(f"a premise ties `{name}` to `{variable}`")
        elif kind == "def" and (name, variables) not in seen:
            seen.add((name, variables))
            self.check_derivatives(self.symbols[name].body, variables, ties, seen, reader)
        for part in parts(expression):
            self.check_derivatives(part, variables, ties, seen, reader)


def printed(name):
    """What names that look the same have in common: where primes and one `_` stand is not seen."""
    bare = re.sub("_+", "_", name.replace("omicron", "o").replace("'", "")).rstrip("_")
    index = re.fullmatch(rf"({'|'.join(SMALL_GREEK)}|[A-Za-z])_?([A-Za-z]?[0-9]*(?:_.*)?)", bare)
    return index.groups() if index else bare, name.count("'")
