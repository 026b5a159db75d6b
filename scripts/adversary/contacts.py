"""Claims whose sides agree at a point, made of known inequalities: their symbols, premises, hints, and what is changed."""

from decimal import Decimal
from fractions import Fraction

from expr import NEGATED, add, mul, num, power, relation, show, sub, substitute, symbols, var, walk
from inequalities import FAMILIES, chance, fold
from neighbourhoods import Unclear, holds, places, value
from reader import read

NAMES = ["a", "b", "c", "k", "m", "u", "v", "x", "y", "z"]
TURNED = {">=": "<=", "<=": ">=", ">": "<", "<": ">", "=": "=", "!=": "!="}
STRICT = {">=": ">", "<=": "<", ">": ">", "<": "<", "=": "!="}
EPSILON = [Fraction(1, 10), Fraction(1, 100), Fraction(1, 1000), Fraction(1, 10**6)]
#: what may stand in the place of a letter that a premise speaks of, and the symbol by the letter
TURNS = [("s", "s"), ("s", "s"), ("2*s", "s/2"), ("s/3", "3*s"), ("s^2", "sqrt(s)"), ("1/s", "1/s"), ("sqrt(s)", "s^2")]
FORMULAS = [
    "s*t", "s/t", "2*s", "s^2", "s + t", "s + 1", "sqrt(s)", "s + 1/s", "s*t^2", "sqrt(s*t)", "s/2", "sqrt(2)*s",
    "1000000*s",
]  # fmt: skip
#: hints of no use: s and t are symbols, w is one of which nothing is known, l and r are the sides of the claim
HINTS = [
    "l - r", "r - l", "w*(l - r)", "-1 - s^2", "1/(s - t)", "sqrt(s - t)", "sqrt(-1 - s^2)", "1/(s - s)", "w", "1/w",
    "sqrt(w)", "s - t", "w - s", "l", "-l", "s*t - 1", "abs(s - t)", "(l - r)^2", "sqrt(l - r)", "1/(l - r)", "w^2 - s^2",
    "min(s, -t)", "s - 1", "-(s - t)^2", "sqrt(r - l) - w",
]  # fmt: skip


#: what is 0 and has a value everywhere
DISGUISES = [
    "sqrt(0)", "0*s", "sqrt(s - s)", "sqrt(4) - 2", "sqrt(1/4) - 1/2", "s^0 - 1", "sqrt(2)*sqrt(2) - 2", "sqrt(8) - 2*sqrt(2)",
    "0/(1 + s^2)", "abs(s - s)", "sqrt((s - t)^2) - abs(s - t)", "min(s, t) + max(s, t) - s - t", "1/sqrt(2) - sqrt(1/2)",
    "sqrt(3 + 2*sqrt(2)) - 1 - sqrt(2)", "0*sqrt(2)", "1000000000000*s - 1000000000000*s",
]  # fmt: skip

#: hints that bring other things into a document; what is an angle is in no exponent, so it has one list or the other
STRANGE = [
    ["exp(w)", "exp({s}) - 1 - {s}", "exp(-w^2)", "exp(w) - 1 - w", "d({s}^2, {s})", "d(w^3, w)", "norm([{s}, w])"],
    ["sin(w)", "cos(w) - 1", "w*sin(w)", "cases {{ {s} > 1: {s}; else: -w }}", "d(sqrt(w), w)", "abs(w) - {s}"],
]  # fmt: skip


def put(text, table):
    return substitute(read(text), table)


class Setting:
    """A known inequality in symbols of its own, and how it is assumed that they are positive."""

    def __init__(self, rng, known=None):
        self.known = known or (chance(rng) if rng.random() < 0.2 else rng.choice(FAMILIES)(rng))
        self.table, self.back = {}, {}
        if known:
            self.table = {letter: var(letter) for letter in known.letters}
        elif self.known.premise:
            self.turn(rng)
        else:
            self.replace(rng)
        self.relation, self.premise, self.order = (self.dressed(r) for r in (self.known.relation, self.known.premise, self.known.order))
        self.hints = [substitute(h, self.table) for h in self.known.hints]
        sides = [side for r in (self.relation, self.premise, self.order) if r for side in r[1:]]
        self.symbols = sorted(set().union(*(symbols(side, {}) for side in sides)))
        self.closed = self.known.closes and not any(e[0] == "d" or (e[0] == "/" and fold(e[2])[0] != "n") for side in sides for e in walk(side))
        self.sign = rng.choice([">", ">", ">", ">="])
        self.declared, self.strange = rng.random() < 0.5, rng.choice(STRANGE)
        self.positive = [(self.sign, var(s), num(0)) for s in self.symbols]

    def turn(self, rng):
        """Symbols in the place of letters of which a premise speaks: each letter is made of one, and the other way round."""
        turn = rng.choice(TURNS) if rng.random() < 0.4 else TURNS[0]
        one = rng.choice([None, None, *self.known.letters])
        for letter, name in zip(self.known.letters, rng.sample(NAMES, len(NAMES))):
            there, again = turn if one in (None, letter) else TURNS[0]
            self.table[letter] = put(there, {"s": var(name)})
            self.back[name] = put(again, {"s": var(letter)}), there == "s^2"

    def replace(self, rng):
        """Positive expressions in the place of letters; what is differentiated gets other names alone."""
        letters, names = self.known.letters, rng.sample(NAMES, len(NAMES))
        slope = any(e[0] == "d" for e in walk(self.known.relation[1]))
        few = names[: len(letters) if slope else rng.choice([len(letters), len(letters), max(1, len(letters) - 1)])]
        plain = slope or rng.random() < 0.5
        for i, letter in enumerate(letters):
            two = {"s": var(few[i % len(few)]), "t": var(rng.choice(few))}
            self.table[letter] = two["s"] if plain or rng.random() < 0.5 else put(rng.choice(FORMULAS), two)

    def dressed(self, r):
        if not r:
            return None
        op, left, right = r
        if left[0] == "d":
            inside = substitute(left[1], self.table)
            return op, ("d", inside, self.table[left[2]][1]), right
        return op, substitute(left, self.table), substitute(right, self.table)

    def symbols_of(self, letters, domain):
        """The symbols of which these are the letters; two choices where a letter is a square of one."""
        place = {name: value(e, letters) for name, (e, _) in self.back.items()}
        yield place
        squared = [name for name, (_, square) in self.back.items() if square]
        if squared and domain == "":
            yield place | {name: -place[name] for name in squared}
            yield place | {squared[0]: -place[squared[0]]}

    def lines(self):
        """Declarations and givens."""
        bounds = f" {self.sign} 0" if self.declared else ""
        yield "var " + ", ".join(f"{s}{bounds}" for s in self.symbols) + ", w"
        if not self.declared:
            yield "given signs: " + ", ".join(map(relation, self.positive))
        if self.premise:
            yield f"given premise: {relation(self.premise)}"


class Claim:
    """A relation, what it rests on, and whether it is right by how it is made."""

    def __init__(self, rng, setting, label, right):
        self.setting, self.label, self.hints = setting, label, []
        self.signs, self.premise, self.order = True, bool(setting.premise), bool(setting.order)
        self.relation, self.right = setting.relation, False
        if right:
            changes = ["as it is", "as it is", "moved", "scaled", "apart", "disguised"]
            self.change = rng.choice(changes + ["weaker", "strictly weaker"] * (self.relation[0] != "="))
            self.right = setting.known.certain and (setting.sign == ">" or setting.closed)
        else:
            changes = ["constant", "constant", "factor", "strict", "turned", "coefficient", "equation", "unequal", "letters"]
            changes += ["no signs"] * (3 * (not setting.declared)) + ["no premise"] * (2 * self.premise) + ["no order"] * (3 * self.order)
            self.change = rng.choice(changes)
        self.relation = getattr(self, self.change.replace(" ", "_"), lambda _: self.relation)(rng)
        if self.change.startswith("no "):
            setattr(self, self.change[3:], False)
        if rng.random() < 0.1:
            self.relation = self.disguised(rng)
        if rng.random() < 0.3:
            self.relation = (TURNED[self.relation[0]], self.relation[2], self.relation[1])
        if rng.random() < 0.45:
            self.hints = [self.hint(rng) for _ in range(rng.choice([1, 1, 2, 3, 4]))]

    def by(self, rng, amount):
        """The relation with an amount more to show, or less."""
        op, left, right = self.relation
        return op, left, (add if (op[0] == ">") == (amount > 0) else sub)(right, num(abs(amount)))

    def weaker(self, rng):
        return self.by(rng, -rng.choice(EPSILON))

    def strictly_weaker(self, rng):
        op, left, right = self.by(rng, -rng.choice(EPSILON))
        return STRICT[op], left, right

    def moved(self, rng):
        extra = put(rng.choice(["s*t", "s - 3", "-s^2", "w", "w*s"]), self.names(rng))
        op, left, right = self.relation
        return op, add(left, extra), add(right, extra)

    def scaled(self, rng):
        factor = put(rng.choice(["3", "1/7", "s", "s + t", "1 + w^2", "sqrt(2)", "1/sqrt(3)"]), self.names(rng))
        op, left, right = self.relation
        return op, mul(factor, left), mul(factor, right)

    def apart(self, rng):
        op, left, right = self.relation
        return op, sub(left, right), num(0)

    def disguised(self, rng):
        """The same with something beside it that is 0 or 1, or with numbers written as roots."""
        op, left, right = self.relation
        nothing = put(rng.choice(DISGUISES), self.names(rng))
        if rng.random() < 0.3:
            numbers = [e for e in walk(left) if e[0] == "n" and e[1] > 0]
            if numbers:
                old = rng.choice(numbers)
                return op, replaced(left, old, ("sqrt", power(old, 2))), right
        if rng.random() < 0.5:
            return op, add(left, nothing), right
        return op, mul(left, add(num(1), nothing)), right

    def constant(self, rng):
        return self.by(rng, rng.choice(EPSILON))

    def factor(self, rng):
        op, left, right = self.relation
        return op, left, mul(num(1 + rng.choice(EPSILON) * (1 if op[0] == ">" else -1)), right)

    def strict(self, rng):
        return STRICT[self.relation[0]], *self.relation[1:]

    def turned(self, rng):
        return TURNED[self.relation[0]], *self.relation[1:]

    def equation(self, rng):
        return "=", *self.relation[1:]

    def unequal(self, rng):
        return "!=", *self.relation[1:]

    def coefficient(self, rng):
        """One of the numbers in it, or a factor 1, is another one."""
        side = rng.choice([1, 2])
        numbers = [e for e in walk(self.relation[side]) if e[0] == "n" and e[1]]
        if not numbers:
            return self.relation[:side] + (mul(num(rng.choice([2, Fraction(1, 2)])), self.relation[side]),) + self.relation[side + 1 :]
        old = rng.choice(numbers)
        new = num(old[1] + rng.choice([1, -1, Fraction(1, 10), Fraction(-1, 10)]) or 2)
        return self.relation[:side] + (replaced(self.relation[side], old, new),) + self.relation[side + 1 :]

    def letters(self, rng):
        """A symbol is another one somewhere."""
        side = rng.choice([1, 2])
        found = [e for e in walk(self.relation[side]) if e[0] == "v"]
        if not found or any(e[0] == "d" for e in walk(self.relation[1])):
            return self.turned(rng)
        new = replaced(self.relation[side], rng.choice(found), var(rng.choice(self.setting.symbols)))
        return self.relation[:side] + (new,) + self.relation[side + 1 :]

    def names(self, rng):
        return {"s": var(rng.choice(self.setting.symbols)), "t": var(rng.choice(self.setting.symbols))}

    def hint(self, rng):
        """What stands behind `using`, as it is written."""
        if rng.random() < 0.1:
            return rng.choice(self.setting.strange).format(s=rng.choice(self.setting.symbols))
        return show(self.plain_hint(rng))

    def plain_hint(self, rng):
        if self.setting.hints and rng.random() < 0.4:
            return rng.choice(self.setting.hints)
        _, left, right = self.relation
        return put(rng.choice(HINTS), self.names(rng) | {"l": left, "r": right})

    def conditions(self):
        """What has to hold at a witness: bounds, what is cited, and what stands behind `when`."""
        setting = self.setting
        out = list(setting.positive) if self.signs or setting.declared else []
        return out + [setting.premise] * self.premise + [setting.order] * self.order

    def text(self):
        setting = self.setting
        cited = ["signs"] * (self.signs and not setting.declared) + ["premise"] * self.premise
        out = f"claim {self.label}: {relation(self.relation)}"
        out += f" when {relation(setting.order)}" if self.order else ""
        out += f" from {', '.join(cited)}" if cited else ""
        return out + (f" using {', '.join(self.hints)}" if self.hints else "")

    def uncited(self):
        """Givens of the document that it does not cite."""
        setting = self.setting
        out = {} if self.signs or setting.declared else {"signs": setting.positive}
        return out | ({"premise": [setting.premise]} if setting.premise and not self.premise else {})

    @staticmethod
    def fails(held):
        """Whether it is not so where the relation holds, does not, or has no sense (None)."""
        return held is not True

    def search(self, rng, more=()):
        """A point at which it fails, or None; and whether any point satisfies what it rests on."""
        setting, conditions = self.setting, [*self.conditions(), *more]
        kept = setting.premise in conditions
        domain = setting.sign if set(setting.positive) <= set(conditions) else ""
        some = False
        for place in places(rng, setting, domain, kept, self.relation):
            place["w"] = Decimal(rng.choice([0, 1, -1, 2, -7]))
            try:
                if all(holds(c, place) for c in conditions):
                    some = True
                    if self.fails(holds(self.relation, place)):
                        return place, True
            except Unclear:
                continue
        return None, some


class Contradiction(Claim):
    """That the opposite of a relation contradicts what it rests on, as it does if the relation is right."""

    def text(self):
        cited = ["opposite", *["signs"] * (self.signs and not self.setting.declared), *["premise"] * self.premise]
        opposite = (NEGATED[self.relation[0]], *self.relation[1:])
        out = f"given opposite: {relation(opposite)}" + (f", {relation(self.setting.order)}" if self.order else "")
        out += f"\nclaim {self.label}: contradiction from {', '.join(cited)}"
        return out + (f" using {', '.join(self.hints)}" if self.hints else "")

    @staticmethod
    def fails(held):
        return held is False


def replaced(e, old, new):
    """The expression with new in one place where old stands, the first of this very object."""
    done = []

    def go(part):
        if part is old and not done:
            done.append(part)
            return new
        if part[0] in "nv":
            return part
        if part[0] in ("^", "d"):
            return part[0], go(part[1]), part[2]
        return part[0], *(go(p) for p in part[1:])

    return go(e)
