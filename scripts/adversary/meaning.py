"""What formulas, vectors and definitions with arguments mean, and how they are written: for `lowered.py`.

None is what is undefined. A number is a fraction, or a real made by the roots of lengths, with an exact sign. A vector is a list of components, each of which may be.
"""

from fractions import Fraction
from itertools import permutations

from algebraic import sign, square_root

AXES = "xyz"


class Scene:
    """Symbols and definitions of one document."""

    def __init__(self, size):
        self.size = size  # of vectors; 0 for none
        self.scalars = ["x", "y", "z"]
        self.vectors = ["u", "v", "w"] if size else []
        self.matrices = ["A", "B"] if size == 2 else (["A"] if size else [])
        self.functions = {}  # name -> (parameters, body)
        self.lets = {}  # name -> expression, a number
        self.vlets = {}  # name -> expression, a vector

    def names(self):
        axes = AXES[: self.size]
        out = list(self.scalars)
        out += [f"{v}_{a}" for v in self.vectors for a in axes]
        return out + [f"{m}_{a}{b}" for m in self.matrices for a in axes for b in axes]


# --- meaning; None is undefined


def number(e, env, s):
    kind = e[0]
    if kind == "n":
        return e[1]
    if kind == "s":
        return env[e[1]] if e[1] in env else number(s.lets[e[1]], env, s)
    if kind == "part":
        return array(e[1], env, s)[e[2]]
    if kind == "cases":
        for guard, body in e[1]:
            truth = all_of(guard, env, s)
            if truth is None:
                return None
            if truth:
                return number(body, env, s)
        return None if e[2] is None else number(e[2], env, s)
    if kind == "call":
        parameters, body = s.functions[e[1]]
        values = [number(a, env, s) for a in e[2]]
        if None in values:
            return None
        return number(body, {**env, **dict(zip(parameters, values))}, s)
    if kind in ("dot", "cross2", "norm2"):
        a = array(e[1], env, s)
        b = array(e[2] if kind != "norm2" else e[1], env, s)
        if None in a or None in b:
            return None
        return a[0] * b[1] - a[1] * b[0] if kind == "cross2" else sum(p * q for p, q in zip(a, b))
    if kind == "norm":
        a = array(e[1], env, s)
        return None if None in a else square_root(total(p * p for p in a))
    if kind == "det":
        return determinant(matrix(e[1], env, s))
    parts = [number(p, env, s) for p in e[1:] if isinstance(p, tuple)]
    if None in parts:
        return None
    a, b = parts[0], parts[-1]
    if kind == "+":
        return a + b
    if kind == "-":
        return a - b
    if kind == "*":
        return a * b
    if kind == "/":
        return a / b if sign(b) else None
    if kind == "neg":
        return -a
    if kind == "abs":
        return a if sign(a) >= 0 else -a
    if kind == "^":
        return power(a, e[2])
    raise AssertionError(kind)


def power(a, n):
    if n < 0:
        return 1 / power(a, -n) if sign(a) else None
    out = Fraction(1)
    for _ in range(n):
        out = a * out
    return out


def determinant(m):
    if any(p is None for row in m for p in row):
        return None
    total = Fraction(0)
    for order in permutations(range(len(m))):
        turns = sum(order[i] > order[j] for i in range(len(m)) for j in range(i + 1, len(m)))
        term = Fraction(-1) ** turns
        for i, j in enumerate(order):
            term *= m[i][j]
        total += term
    return total


def inverse(m):
    """By elimination; all components are undefined where there is none."""
    size = len(m)
    if determinant(m) is None or not sign(determinant(m)):
        return [[None] * size for _ in m]
    rows = [list(row) + [Fraction(i == j) for j in range(size)] for i, row in enumerate(m)]
    for i in range(size):
        pivot = next(k for k in range(i, size) if sign(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [p / rows[i][i] for p in rows[i]]
        for k in range(size):
            if k != i:
                rows[k] = [p - rows[k][i] * q for p, q in zip(rows[k], rows[i])]
    return [row[size:] for row in rows]


def add(a, b):
    return None if a is None or b is None else a + b


def times(a, b):
    return None if a is None or b is None else a * b


def array(e, env, s):
    """A vector, component by component."""
    kind, axes = e[0], AXES[: s.size]
    if kind == "vec":
        if e[1] in s.vlets:
            return array(s.vlets[e[1]], env, s)
        return [env[f"{e[1]}_{a}"] for a in axes]
    if kind == "lit":
        return [number(p, env, s) for p in e[1]]
    if kind == "mv":
        m, v = matrix(e[1], env, s), array(e[2], env, s)
        return [total(times(p, q) for p, q in zip(row, v)) for row in m]
    if kind in ("scale", "over", "turn"):
        c, v = number(e[1], env, s), array(e[2], env, s)
        if kind == "over":
            c = 1 / c if c is not None and sign(c) else None
        return [times(c, p) for p in v] if kind != "turn" else [times(times(c, v[1]), -1), times(c, v[0])]
    a = array(e[1], env, s)
    if kind == "vneg":
        return [times(p, -1) for p in a]
    b = array(e[2], env, s)
    if kind == "v+":
        return [add(p, q) for p, q in zip(a, b)]
    if kind == "v-":
        return [add(p, times(q, -1)) for p, q in zip(a, b)]
    if kind == "cross3":
        return [add(times(a[i], b[j]), times(times(a[j], b[i]), -1)) for i, j in ((1, 2), (2, 0), (0, 1))]
    raise AssertionError(kind)


def total(terms):
    out = Fraction(0)
    for term in terms:
        out = add(out, term)
    return out


def matrix(e, env, s):
    kind, axes = e[0], AXES[: s.size]
    if kind == "mat":
        return [[env[f"{e[1]}_{a}{b}"] for b in axes] for a in axes]
    if kind == "rows":
        return [[number(p, env, s) for p in row] for row in e[1]]
    if kind == "ms":
        c = number(e[1], env, s)
        return [[times(c, p) for p in row] for row in matrix(e[2], env, s)]
    a = matrix(e[1], env, s)
    if kind == "tr":
        return [list(row) for row in zip(*a)]
    if kind == "inv":
        return inverse(a)
    b = matrix(e[2], env, s)
    if kind == "mm":
        return [[total(times(p, q) for p, q in zip(row, column)) for column in zip(*b)] for row in a]
    if kind == "m+":
        return [[add(p, q) for p, q in zip(*rows)] for rows in zip(a, b)]
    raise AssertionError(kind)


def compare(op, a, b):
    if a is None or b is None:
        return None
    way = sign(a - b)
    return {"=": way == 0, "!=": way != 0, "<": way < 0, "<=": way <= 0, ">": way > 0, ">=": way >= 0}[op]


def all_of(formulas, env, s):
    """Of a list, read from left to right, the first truth that is not true."""
    return all_of_truths(true(f, env, s) for f in formulas)


def links(f):
    """What is judged by itself in a claim: functions from a point to a truth."""
    kind = f[0]
    if kind == "and":
        return [link for part in f[1] for link in links(part)]
    if kind == "chain":
        return [
            lambda env, s, i=i, op=op: compare(op, number(f[1][i], env, s), number(f[1][i + 1], env, s))
            for i, op in enumerate(f[2])
        ]
    if kind in ("v=", "m=") and f[1] == "=":
        def each(env, s):
            sides = [flat(side, env, s, kind) for side in f[2:4]]
            return [compare("=", p, q) for p, q in zip(*sides)]

        return [lambda env, s, i=i: each(env, s)[i] for i in range(f[4])] if len(f) > 4 else [each]
    return [lambda env, s: true(f, env, s)]


def flat(e, env, s, kind):
    if kind == "v=":
        return array(e, env, s)
    return [p for row in matrix(e, env, s) for p in row]


def true(f, env, s):
    """Whether a formula is true; None where a part that is read is undefined."""
    kind = f[0]
    if kind == "chain":
        return all_of_truths(link(env, s) for link in links(f))
    if kind in ("v=", "m="):
        truths = [compare(f[1], p, q) for p, q in zip(*(flat(side, env, s, kind) for side in f[2:4]))]
        return all_of_truths(truths) if f[1] == "=" else one_of(truths)
    if kind == "and":
        return all_of(f[1], env, s)
    if kind == "or":
        return one_of(true(part, env, s) for part in f[1])
    first = true(f[1], env, s)
    if kind == "implies":
        return None if first is None else (true(f[2], env, s) if first else True)
    second = true(f[2], env, s)
    return None if None in (first, second) else first == second


def all_of_truths(truths):
    for truth in truths:
        if truth is not True:
            return truth
    return True


def one_of(truths):
    for truth in truths:
        if truth is not False:
            return truth
    return False


# --- writing


def text(e):
    kind = e[0]
    if kind == "n":
        n, d = e[1].numerator, e[1].denominator
        return str(n) if d == 1 and n >= 0 else f"({n})" if d == 1 else f"({n}/{d})"
    if kind in ("s", "vec", "mat"):
        return e[1]
    if kind == "part":
        return f"{e[1][1]}_{AXES[e[2]]}"
    if kind in ("+", "-", "*", "/"):
        return f"({text(e[1])} {kind} {text(e[2])})"
    if kind == "^":
        return f"({text(e[1])})^{e[2]}"
    if kind in ("neg", "vneg"):
        return f"(-{text(e[1])})"
    if kind == "abs":
        return f"|{text(e[1])}|" if e[1][0] != "abs" else f"abs({text(e[1])})"
    if kind == "call":
        return f"{e[1]}({', '.join(map(text, e[2]))})"
    if kind == "lit":
        return f"[{', '.join(map(text, e[1]))}]"
    if kind == "rows":
        return "[" + ", ".join(f"[{', '.join(map(text, row))}]" for row in e[1]) + "]"
    if kind == "norm2":
        return f"norm({text(e[1])})^2"
    if kind in ("v+", "v-", "m+"):
        return f"({text(e[1])} {kind[1]} {text(e[2])})"
    if kind in ("scale", "ms", "mm", "mv"):
        return f"({text(e[1])}*{text(e[2])})"
    if kind == "over":
        return f"({text(e[2])}/{text(e[1])})"
    if kind == "cases":
        branches = [f"{', '.join(map(formula, guard))}: {text(body)}" for guard, body in e[1]]
        return "cases { " + "; ".join(branches + ([f"else: {text(e[2])}"] if e[2] else [])) + " }"
    name = {"cross2": "cross", "cross3": "cross", "turn": "cross", "tr": "transpose", "inv": "inverse"}.get(kind, kind)
    return f"{name}({', '.join(text(p) for p in e[1:] if isinstance(p, tuple))})"


def formula(f, inner=False):
    kind = f[0]
    if kind == "chain":
        out = text(f[1][0])
        for op, side in zip(f[2], f[1][1:]):
            out += f" {op} {text(side)}"
        return out
    if kind in ("v=", "m="):
        return f"{text(f[2])} {f[1]} {text(f[3])}"
    if kind in ("and", "or"):
        out = f" {kind} ".join(formula(part, True) for part in f[1])
    else:
        out = f"{formula(f[1], True)} {kind} {formula(f[2], True)}"
    return f"({out})" if inner else out
