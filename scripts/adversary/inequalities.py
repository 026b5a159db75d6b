"""Inequalities between positive letters whose sides agree somewhere, each with its proof on paper in a word.

Most are by convexity (Jensen), by tangents, by Cauchy, Minkowski, or have a square over something positive as their gap.
What is made here is true by how it is made; `neighbourhoods.py` looks for points that say otherwise, so that a slip of this file
shows itself.
"""

from fractions import Fraction

from algebraic import square_root
from expr import add, div, mul, num, substitute, sub, total, var, walk
from reader import Reader, read
from slopes import by_rules, simple

LETTERS = "abcf"

#: premises by their names: what they say, and the last letter by the others
PREMISES = {
    "": None,
    "sum3": ("a + b + c = 3", "c", "3 - a - b"),
    "sum1": ("a + b + c = 1", "c", "1 - a - b"),
    "squares": ("a^2 + b^2 + c^2 = 3", "c", "sqrt(3 - a^2 - b^2)"),
    "product": ("a*b*c = 1", "c", "1/(a*b)"),
    "two": ("a + b = 2", "b", "2 - a"),
    "inverse": ("a*b = 1", "b", "1/a"),
    "line": ("a + 2*b = 5", "b", "(5 - a)/2"),
}

#: (premise, inequality, what may be used)
TEXTBOOK = [
    ("", "a/(b + c) + b/(c + a) + c/(a + b) >= 3/2", "(a - b)^2, (b - c)^2*(b + c)"),
    (
        "",
        "sqrt(a^2 + b^2) + sqrt(b^2 + c^2) + sqrt(c^2 + a^2) >= sqrt(2)*(a + b + c)",
        "sqrt(a^2 + b^2) - (a + b)/sqrt(2), sqrt(b^2 + c^2) - (b + c)/sqrt(2), sqrt(c^2 + a^2) - (c + a)/sqrt(2)",
    ),
    ("", "sqrt(a^2 + a*b + b^2) + sqrt(b^2 + b*c + c^2) + sqrt(c^2 + c*a + a^2) >= sqrt(3)*(a + b + c)", ""),
    ("", "sqrt(a^2 - a*b + b^2) >= (a + b)/2", "(a - b)^2"),
    ("", "a^2/(b + c) + b^2/(c + a) + c^2/(a + b) >= (a + b + c)/2", "(a - b)^2, a^2/(b + c) - a + (b + c)/4"),
    ("", "a^2/b + b^2/c + c^2/a >= a + b + c", "(a - b)^2/b, (b - c)^2/c, (c - a)^2/a"),
    ("", "a/b + b/c + c/a >= 3", ""),
    ("", "(a + b + c)*(1/a + 1/b + 1/c) >= 9", "(a - b)^2/(a*b), (b - c)^2/(b*c), (c - a)^2/(c*a)"),
    ("", "1/a + 1/b >= 4/(a + b)", "(a - b)^2"),
    ("", "(a + b)*(b + c)*(c + a) >= 8*a*b*c", "a*(b - c)^2, b*(c - a)^2, c*(a - b)^2"),
    ("", "sqrt(a*b) + sqrt(b*c) + sqrt(c*a) <= a + b + c", "(sqrt(a) - sqrt(b))^2"),
    ("", "2*a*b/(a + b) <= sqrt(a*b)", "(a - b)^2"),
    ("", "sqrt((a^2 + b^2)/2) >= (a + b)/2", "(a - b)^2"),
    ("", "sqrt((a^2 + b^2 + c^2)/3) >= (a + b + c)/3", "(a - b)^2, (b - c)^2, (c - a)^2"),
    ("", "a*b/(a + b) + b*c/(b + c) + c*a/(c + a) <= (a + b + c)/2", "(a + b)/4 - a*b/(a + b)"),
    ("", "sqrt(a) + sqrt(b) <= sqrt(2*(a + b))", "(sqrt(a) - sqrt(b))^2"),
    ("", "sqrt(a) + sqrt(b) + sqrt(c) <= sqrt(3*(a + b + c))", "(a - b)^2"),
    ("", "sqrt(a*b) + sqrt(c*f) <= sqrt((a + c)*(b + f))", "(a*f - b*c)^2"),
    ("", "sqrt((a + c)^2 + (b + f)^2) <= sqrt(a^2 + b^2) + sqrt(c^2 + f^2)", "(a*f - b*c)^2"),
    ("", "a^3 + b^3 >= a*b*(a + b)", "(a + b)*(a - b)^2"),
    ("", "a^2 + b^2 + c^2 >= a*b + b*c + c*a", "(a - b)^2, (b - c)^2, (c - a)^2"),
    ("", "a^3 + b^3 + c^3 >= 3*a*b*c", "(a - b)^2, (b - c)^2, (c - a)^2"),
    ("", "a*(a - b)*(a - c) + b*(b - a)*(b - c) + c*(c - a)*(c - b) >= 0", "a - b, b - c, c - a"),
    ("", "a/sqrt(b) + b/sqrt(a) >= sqrt(a) + sqrt(b)", "sqrt(a) - sqrt(b)"),
    ("", "sqrt(a/b) + sqrt(b/a) >= 2", "(a - b)^2"),
    ("", "a + 1/a >= 2", "(a - 1)^2"),
    ("", "(a^2 + 2)/sqrt(a^2 + 1) >= 2", "(sqrt(a^2 + 1) - 1)^2"),
    ("", "(a^2 + b^2)/(a + b) + (b^2 + c^2)/(b + c) + (c^2 + a^2)/(c + a) >= a + b + c", "(a - b)^2/(a + b)"),
    ("", "sqrt(a + b) <= sqrt(a) + sqrt(b)", "sqrt(a)*sqrt(b)"),
    ("", "a/(a + 2*b) + b/(b + 2*c) + c/(c + 2*a) >= 1", ""),
    ("", "a/(b + 2*c) + b/(c + 2*a) + c/(a + 2*b) >= 1", ""),
    ("", "a^3/(a^2 + b^2) + b^3/(b^2 + c^2) + c^3/(c^2 + a^2) >= (a + b + c)/2", "a^3/(a^2 + b^2) - a + b/2"),
    (
        "",
        "a^3/(a^2 + a*b + b^2) + b^3/(b^2 + b*c + c^2) + c^3/(c^2 + c*a + a^2) >= (a + b + c)/3",
        "a^3/(a^2 + a*b + b^2) - (2*a - b)/3",
    ),
    ("sum3", "1/(a^2 + b + c) + 1/(b^2 + c + a) + 1/(c^2 + a + b) <= 1", "(4 - a)/9 - 1/(a^2 + b + c)"),
    ("sum3", "1/(2*a^2 + 1) + 1/(2*b^2 + 1) + 1/(2*c^2 + 1) >= 1", "1/(2*a^2 + 1) - (7 - 4*a)/9"),
    ("sum3", "a/(1 + b^2) + b/(1 + c^2) + c/(1 + a^2) >= 3/2", "a/(1 + b^2) - a + a*b/2"),
    ("sum3", "sqrt(a) + sqrt(b) + sqrt(c) >= a*b + b*c + c*a", "2*sqrt(a) + a^2 - 3*a"),
    ("sum3", "a^2 + b^2 + c^2 >= 3", "(a - 1)^2, (b - 1)^2, (c - 1)^2"),
    ("sum3", "1/a + 1/b + 1/c >= 3", "1/a - 2 + a"),
    ("sum3", "a*b*c <= 1", ""),
    ("sum3", "a*b + b*c + c*a <= 3", "(a - b)^2"),
    ("sum3", "sqrt(a + 3) + sqrt(b + 3) + sqrt(c + 3) <= 6", "(a + 7)/4 - sqrt(a + 3)"),
    ("sum3", "a/(b + 2) + b/(c + 2) + c/(a + 2) >= 1", ""),
    ("sum3", "a^2/(a + b) + b^2/(b + c) + c^2/(c + a) >= 3/2", "a^2/(a + b) - a + (a + b)/4"),
    ("sum3", "1/(a + b) + 1/(b + c) + 1/(c + a) >= 3/2", ""),
    ("sum3", "sqrt(a^2 + 3) + sqrt(b^2 + 3) + sqrt(c^2 + 3) >= 6", "sqrt(a^2 + 3) - (a + 3)/2"),
    ("sum1", "sqrt(a + b*c) + sqrt(b + c*a) + sqrt(c + a*b) <= 2", "a + (b + c)/2 - sqrt(a + b*c)"),
    ("sum1", "a/sqrt(1 - a) + b/sqrt(1 - b) + c/sqrt(1 - c) >= sqrt(3/2)", ""),
    ("sum1", "6*(a^3 + b^3 + c^3) >= a^2 + b^2 + c^2 + 1/3", "6*a^3 - a^2 - (4*a - 1)/3 + 2/9"),
    ("sum1", "a/(1 - a) + b/(1 - b) + c/(1 - c) >= 3/2", "a/(1 - a) - (9*a - 1)/4"),
    ("sum1", "sqrt(4*a + 1) + sqrt(4*b + 1) + sqrt(4*c + 1) <= sqrt(21)", "4*a + 1"),
    ("sum1", "(1 + 1/a)*(1 + 1/b)*(1 + 1/c) >= 64", ""),
    ("sum1", "7*(a*b + b*c + c*a) <= 2 + 9*a*b*c", "a*(a - b)*(a - c), a - b, b - c"),
    ("squares", "1/(2 - a) + 1/(2 - b) + 1/(2 - c) >= 3", "1/(2 - a) - (a^2 + 1)/2"),
    ("squares", "a + b + c <= 3", "(a - 1)^2, (b - 1)^2, (c - 1)^2"),
    ("product", "a + b + c >= 3", ""),
    ("product", "1/(1 + a + b) + 1/(1 + b + c) + 1/(1 + c + a) <= 1", ""),
    ("two", "sqrt(a) + sqrt(b) <= 2", "(a + 1)/2 - sqrt(a)"),
    ("two", "a*b <= 1", "(a - 1)^2"),
    ("inverse", "a + b >= 2", "(a - b)^2"),
    ("inverse", "sqrt(a^2 + 1) + sqrt(b^2 + 1) >= 2*sqrt(2)", "sqrt(a^2 + 1) - (a + 1)/sqrt(2)"),
    ("line", "sqrt(a^2 + 4) + sqrt(4*b^2 + 9) >= sqrt(50)", "(3*a - 4*b)^2"),
]

#: convex and concave where x is positive
CONVEX = [
    "sqrt(x^2 + 1)", "sqrt(x^2 + 3)", "sqrt(x^2 + x + 1)", "1/x", "1/(x + 1)", "1/(x + 2)", "x^2", "x^3", "1/sqrt(x)",
    "x^2/(x + 1)", "1/x^2", "1/sqrt(x + 1)", "x*sqrt(x)", "x + 1/x", "(x + 1/x)^2", "abs(x - 1)", "x^4",
]  # fmt: skip
CONCAVE = [
    "sqrt(x)", "sqrt(x + 1)", "x/(x + 1)", "x/(x + 2)", "sqrt(x + sqrt(x))", "sqrt(x) - 1/x", "sqrt(x^2 + x)", "x*(3 - x)",
]  # fmt: skip

#: gaps that are squares, or squares over something positive; p and q are whatever is positive
GAPS = [
    ("p/q + q/p >= 2", "(p - q)^2"),
    ("p + q >= 2*sqrt(p*q)", "(sqrt(p) - sqrt(q))^2"),
    ("p^2/q >= 2*p - q", "(p - q)^2/q"),
    ("p^2 + 4*q^2 >= 4*p*q", "(p - 2*q)^2"),
    ("sqrt(p/q) + sqrt(q/p) >= 2", "(sqrt(p) - sqrt(q))^2"),
    ("p*q <= ((p + q)/2)^2", "(p - q)^2"),
    ("sqrt(p^2 + q^2) >= (3*p + 4*q)/5", "(4*p - 3*q)^2"),
    ("1/p + 1/q >= 2/sqrt(p*q)", "(sqrt(p) - sqrt(q))^2/(p*q)"),
    ("p/(1 + p^2) <= 1/2", "(p - 1)^2"),
    ("sqrt(p)*(p + 3*q) <= p^2/2 + p/2 + 3*q*(p + 1)/2", "(sqrt(p) - 1)^2"),
    ("p^3 + 2*q^3 >= 3*p*q^2", "(p - q)^2*(p + 2*q)"),
]

#: where the sides of each of them agree
AGREE = ["p = q", "p = q", "p = q", "p = 2*q", "p = q", "p = q", "4*p = 3*q", "p = q", "p = 1", None, "p = q"]

#: growing where x is positive
GROWING = [
    "sqrt(x)", "sqrt(x + 1)", "x/(x + 1)", "sqrt(x^2 + 1)", "x/sqrt(x^2 + 1)", "x - 1/x", "sqrt(x + 1) - 1/(x + 1)",
    "sqrt(x)/(1 + sqrt(x))", "sqrt(x^2 + x) - x", "sqrt(x) - sqrt(x + 1)", "x*sqrt(x)", "sqrt(x^2 + 1) + x - 1/x",
]  # fmt: skip


class Known:
    """An inequality of letters, what it is from, and what may be used; `order` is a condition on the letters."""

    def __init__(self, family, relation, premise="", hints=(), order=None):
        self.family, self.relation, self.hints, self.order = family, relation, list(hints), order
        self.certain, self.closes = True, True  # whether it is known to hold, and to hold at 0 too where it has a value
        self.premise, self.last, self.solution = None, None, None
        if premise:
            said, self.last, solution = premise
            self.premise, self.solution = Reader(said).relation() if isinstance(said, str) else said, solution
            if isinstance(solution, str):
                self.solution = read(solution)
        relations = [r for r in (relation, self.premise, order) if r]
        self.letters = sorted({e[1] for r in relations for side in r[1:] for e in walk(side) if e[0] == "v"})


#: where tangents touch
PLACES = [Fraction(n, d) for n, d in ((1, 1), (2, 1), (3, 1), (4, 1), (8, 1), (9, 1), (1, 2), (1, 3), (1, 4), (3, 4), (1, 8), (4, 3))]


def fold(e):
    """The same expression with the arithmetic on numbers done."""
    kind = e[0]
    if kind in "nv":
        return e
    if kind == "d":
        return kind, fold(e[1]), e[2]
    if kind == "^":
        a = fold(e[1])
        return num(a[1] ** e[2]) if a[0] == "n" and (a[1] or e[2] > 0) else ("^", a, e[2])
    parts = [fold(part) for part in e[1:]]
    if any(part[0] != "n" for part in parts):
        return (kind, *parts)
    values = [part[1] for part in parts]
    if kind == "sqrt":
        exact = square_root(values[0]) if values[0] >= 0 else None
        return num(exact) if isinstance(exact, Fraction) else (kind, *parts)
    if kind in ("neg", "abs"):
        return num(-values[0] if kind == "neg" else abs(values[0]))
    a, b = values
    if kind == "/":
        return num(a / b) if b else (kind, *parts)
    return num({"+": a + b, "-": a - b, "*": a * b}[kind])


def slope(f, name, place):
    """The derivative of f by a name at a place of numbers."""
    return fold(simple(fold(substitute(simple(by_rules(f, name)), place))))


def at(f, e):
    return substitute(f, {"x": e})


def simple_place(rng, f):
    """A number, often one at which f has no root of a number that is none."""
    chosen = num(rng.choice(PLACES))
    fair = [num(q) for q in PLACES if fold(at(f, num(q)))[0] == "n"]
    return rng.choice(fair) if fair and rng.random() < 0.7 else chosen


def line(f, middle, x):
    """The tangent of f at a number."""
    return add(fold(at(f, middle)), mul(slope(f, "x", {"x": middle}), sub(x, middle)))


def weighted(weights, parts):
    return total(part if w == 1 else mul(num(w), part) for w, part in zip(weights, parts))


def textbook(rng):
    premise, said, hints = rng.choice(TEXTBOOK)
    return Known("textbook", Reader(said).relation(), PREMISES[premise], [read(h) for h in hints.split(", ") if h])


def shaped(rng):
    """A convex or concave function, and which of the two."""
    convex = rng.random() < 0.6
    return read(rng.choice(CONVEX if convex else CONCAVE)), ">=" if convex else "<="


def jensen(rng):
    """Σ w·f(x) against Σ w times f of the mean, which a premise may give."""
    f, sign = shaped(rng)
    n = rng.choice([2, 2, 3, 3, 4])
    weights = [rng.choice([1, 1, 1, 2, 3]) for _ in range(n)] if rng.random() < 0.4 else [1] * n
    letters = [var(name) for name in LETTERS[:n]]
    left = weighted(weights, [at(f, x) for x in letters])
    whole = num(sum(weights))
    if rng.random() < 0.5:
        mean = div(weighted(weights, letters), whole)
        return Known("jensen", (sign, left, mul(whole, at(f, mean))))
    middle = simple_place(rng, f)
    right = fold(mul(whole, at(f, middle)))
    last = div(sub(fold(mul(whole, middle)), weighted(weights, letters[:-1])), num(weights[-1]))
    premise = (("=", weighted(weights, letters), fold(mul(whole, middle))), letters[-1][1], last)
    smooth = "abs" not in {e[0] for e in walk(f)}
    hints = [beside(sign, at(f, x), line(f, middle, x)) for x in letters] if smooth else []
    return Known("jensen", (sign, left, right), premise, hints)


def beside(sign, left, right):
    """What is not negative where left and right are so related."""
    return sub(left, right) if sign == ">=" else sub(right, left)


def tangent(rng):
    """A sum of functions against their tangents at points of their own."""
    parts, hints = [], []
    sign = rng.choice([">=", "<="])
    for name in LETTERS[: rng.choice([1, 2, 2, 3])]:
        f = read(rng.choice([f for f in CONVEX if "abs" not in f] if sign == ">=" else CONCAVE))
        middle, x = simple_place(rng, f), var(name)
        parts.append((at(f, x), line(f, middle, x)))
        hints.append(beside(sign, *parts[-1]))
    left, right = (total(side) for side in zip(*parts))
    return Known("tangent", (sign, left, right), hints=hints)


def gap(rng):
    """A gap that is a square over something positive, once or twice, or times something positive."""
    chosen = [rng.choice(GAPS) for _ in range(rng.choice([1, 1, 2]))]
    sides, hints = [], []
    for (said, hint), letters in zip(chosen, ("ab", "bc")):
        table = {"p": var(letters[0]), "q": var(letters[1])}
        sign, left, right = Reader(said).relation()
        sides.append(tuple(substitute(side, table) for side in ((left, right) if sign == ">=" else (right, left))))
        hints.append(substitute(read(hint), table))
    left, right = (total(side) for side in zip(*sides))
    if rng.random() < 0.3:
        factor = var(rng.choice("abc"))
        left, right = (mul(factor, side) for side in (left, right))
    return Known("gap", (">=", left, right), hints=hints)


def equality(rng):
    """When the sides agree, and that one is larger where they do not."""
    if rng.random() < 0.6:
        (said, _), where = rng.choice([pair for pair in zip(GAPS, AGREE) if pair[1]])
        table = {"p": var("a"), "q": var("b")}
        (sign, left, right), (_, p, q) = (
            (r[0], *(substitute(side, table) for side in r[1:])) for r in (Reader(said).relation(), Reader(where).relation())
        )
    else:
        f, sign = shaped(rng)
        while "abs" in {e[0] for e in walk(f)}:
            f, sign = shaped(rng)
        p, q = var("a"), var("b")
        left, right = add(at(f, p), at(f, q)), mul(num(2), at(f, div(add(p, q), num(2))))
    if rng.random() < 0.5:
        known = Known("equality", ("=", p, q), order=("=", left, right))
    else:
        known = Known("equality", (sign[0], left, right), order=("!=", p, q))
    known.closes = False
    return known


def norms(rng):
    """Minkowski: lengths of vectors against the length of their sum, and the length against a component."""
    n, plane = rng.choice([(2, 2), (2, 2), (3, 2), (2, 3)])
    vectors = [[mul(num(k), var(name)) if k != 1 else var(name) for k in [rng.randint(1, 3) for _ in range(plane - 1)]]
               + [num(rng.choice([1, 2, 3, 4]))] for name in LETTERS[:n]]  # fmt: skip
    length = lambda v: ("sqrt", fold(total(("^", part, 2) for part in v)))  # noqa: E731
    whole = [total(parts) for parts in zip(*vectors)]
    return Known("norms", (">=", total(length(v) for v in vectors), length([fold(part) for part in whole])))


def growing(rng):
    """A function that grows, at two points; or its derivative."""
    f = read(rng.choice(GROWING))
    if rng.random() < 0.4:
        return Known("growing", (">=", ("d", at(f, var("a")), "a"), num(0)))
    return Known("growing", ("<=", at(f, var("a")), at(f, var("b"))), order=("<=", var("a"), var("b")))


#: under roots, and beside them
INSIDE = ["x + {}", "x^2 + {}", "x^2 + y^2", "x*y + {}", "2*x^2 - x*y + y^2", "x/(y + {})", "{}*x + y", "x", "x + {}*sqrt(y)"]


def chance(rng):
    """A sum of roots and quotients against a plane through a point of its own, which may lie on one side of it or not."""
    few = LETTERS[: rng.choice([1, 2, 2, 3])]
    left = None
    for _ in range(rng.choice([2, 2, 3])):
        inside = read(rng.choice(INSIDE).format(rng.randint(1, 4)))
        inside = substitute(inside, {"x": var(rng.choice(few)), "y": var(rng.choice(few))})
        part = ("sqrt", inside) if rng.random() < 0.8 else div(inside, add(var(rng.choice(few)), num(rng.randint(1, 3))))
        left = part if left is None else (rng.choice("++-"), left, part)
    for _ in range(12):
        middle = {name: num(rng.choice([1, 1, *PLACES])) for name in few}
        right = fold(substitute(left, middle))
        if right[0] == "n":
            break
    for name in few:
        steep = slope(left, name, middle) if rng.random() < 0.5 else num(Fraction(rng.randint(-4, 4), 4))
        right = add(right, mul(steep, sub(var(name), middle[name])))
    known = Known("chance", (rng.choice([">=", "<="]), left, right))
    known.certain = False
    return known


FAMILIES = (textbook, textbook, jensen, jensen, tangent, gap, norms, growing, equality)
