"""A derivation document as data, with what its generator knows about it, and how it is written."""

from expr import relation, show, tame
from point import Scope, evaluate


class Var:
    """A declared name: its argument if it is a function, and its bounds (value, strict) or None."""

    def __init__(self, name, argument=None, lower=None, upper=None):
        self.name, self.argument, self.lower, self.upper = name, argument, lower, upper

    def allows(self, v):
        from algebraic import sign

        for bound, way in ((self.lower, 1), (self.upper, -1)):
            if bound is not None:
                s = way * sign(v - bound[0])
                if s < 0 or (s == 0 and bound[1]):
                    return False
        return True

    def text(self):
        name = self.name if self.argument is None else f"{self.name}({self.argument})"
        if self.lower and self.upper:
            return f"{self.lower[0]} {'<' if self.lower[1] else '<='} {name} {'<' if self.upper[1] else '<='} {self.upper[0]}"
        if self.lower:
            return f"{name} {'>' if self.lower[1] else '>='} {self.lower[0]}"
        if self.upper:
            return f"{name} {'<' if self.upper[1] else '<='} {self.upper[0]}"
        return name


class Limit:
    """f -> target as x -> point: target is an expression, 'oo' or '-oo'; side is '', '+' or '-'."""

    def __init__(self, f, target, x, point, side=""):
        self.f, self.target = tame(f), target if isinstance(target, str) else tame(target)
        self.x, self.point, self.side = x, point, side

    def text(self, rng):
        target = self.target if isinstance(self.target, str) else show(self.target, 0, rng)
        return f"{show(self.f, 0, rng)} -> {target} as {self.x} -> {self.point}{self.side}"


class Statement:
    """A given or a claim. `links` are relations or one Limit.

    `shape` is 'links', 'contradiction' or 'not implied' (then `about` is the label of another one).
    `truth` says of a given how it is known to be true in a structure (see `structure.py`).
    """

    def __init__(self, kind, label, links=(), when=(), cites=(), shape="links", about=None, truth=None, by=()):
        self.kind, self.label = kind, label
        self.links = [(r[0], tame(r[1]), tame(r[2])) if isinstance(r, tuple) else r for r in links]
        self.when = [(op, tame(a), tame(b)) for op, a, b in when]
        self.cites, self.shape, self.about, self.truth, self.by = list(cites), shape, about, truth, list(by)

    def limit(self):
        return self.links[0] if self.links and isinstance(self.links[0], Limit) else None

    def text(self, rng):
        if self.shape == "contradiction":
            out = f"{self.kind} {self.label}: contradiction"
        elif self.shape == "not implied":
            out = f"{self.kind} {self.label}: not implied {self.about}"
        elif self.limit():
            out = f"{self.kind} {self.label}: {self.limit().text(rng)}"
        else:
            out = f"{self.kind} {self.label}: " + ", ".join(relation(r, rng) for r in self.links)
        if self.when:
            out += " when " + ", ".join(relation(r, rng) for r in self.when)
        if self.cites:
            out += " from " + ", ".join(self.cites)
        if self.by:
            out += " by " + ", ".join(f"{n} := {show(e, 0, rng)}" for n, e in self.by)
        return out


class Document:
    """What is written, and beside it points and structures at which it is judged."""

    def __init__(self, family, rng):
        self.family, self.rng = family, rng
        self.vars, self.lets, self.statements, self.index = [], {}, [], {}
        self.points = []  # dicts of all names: places that the generator knows to be telling
        self.structures = []
        self.order = []  # names of lets and statements as they are written
        self.shared, self.count = {}, 0

    def declare(self, name, argument=None, lower=None, upper=None):
        self.vars.append(Var(name, argument, lower, upper))
        return ("v", name)

    def define(self, name, e):
        self.lets[name] = tame(e)
        self.order.append(("let", name))
        return ("v", name)

    def given(self, links, when=(), truth=None):
        return self._state(Statement("given", self.fresh("g"), links, when, truth=truth))

    def claim(self, links, when=(), cites=(), **more):
        return self._state(Statement("claim", self.fresh("c"), links, when, cites, **more))

    def fresh(self, letter):
        self.count += 1
        return f"{letter}{self.count}"

    def _state(self, statement):
        self.statements.append(statement)
        self.index[statement.label] = statement
        self.order.append(("statement", statement))
        return statement.label

    def find(self, label):
        return self.index[label]

    def claims(self):
        return [s for s in self.statements if s.kind == "claim"]

    def scope(self, values):
        return Scope(self.lets, values, self.shared)

    def in_domain(self, values):
        return all(v.allows(values[v.name]) for v in self.vars if v.name in values)

    def rests_on(self, statement):
        """The givens behind a claim, through all claims in between."""
        out, todo, seen = [], list(statement.cites), set()
        while todo:
            label = todo.pop()
            if label in seen:
                continue
            seen.add(label)
            s = self.find(label)
            if s.kind == "given":
                out.append(label)
            else:
                todo += s.cites
        return out

    def text(self, title):
        lines = [f"# {title}", "", "```kane"]
        lines += [f"var {v.text()}" for v in self.vars]
        for what, item in self.order:
            if what == "let":
                lines.append(f"let {item} := {show(self.lets[item], 0, self.rng)}")
            else:
                lines.append(item.text(self.rng))
        return "\n".join(lines + ["```", ""])


class Structure:
    """Constants with values, and each function of the limit variable written out."""

    def __init__(self, x, constants, functions):
        self.x, self.constants, self.functions = x, constants, functions

    def values(self, x):
        """All names at the point or along the germ x."""
        base = {**self.constants, self.x: x}
        scope = Scope({}, base)
        return {**base, **{name: evaluate(e, scope) for name, e in self.functions.items()}}
