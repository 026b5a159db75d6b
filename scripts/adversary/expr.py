"""Expressions and relations as plain tuples, and how they are written in a document.

    ('n', Fraction)  ('v', name)  ('neg', a)  ('+', a, b)  ('-', a, b)  ('*', a, b)  ('/', a, b)
    ('^', a, int)  ('abs', a)  ('min', a, b)  ('max', a, b)  ('sqrt', a)  ('d', a, name)
    ('cases', ((relations, expression), ...), expression or None)

A relation is (operator, left, right). Printing goes from the tuple to text; nothing is read back,
so the text of a document can mean nothing else than what the tuples mean by the language page.
"""

from fractions import Fraction

RELATIONS = ("=", "!=", "<", "<=", ">", ">=")
NEGATED = {"=": "!=", "!=": "=", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
ADD, MUL, UNARY, POW, ATOM = range(1, 6)


def num(value):
    return ("n", Fraction(value))


def var(name):
    return ("v", name)


def add(a, b):
    return ("+", a, b)


def sub(a, b):
    return ("-", a, b)


def mul(a, b):
    return ("*", a, b)


def div(a, b):
    return ("/", a, b)


def power(a, n):
    return ("^", a, n)


def cases(branches, otherwise=None):
    """Each branch is (list of relations, expression)."""
    return ("cases", tuple((tuple(g), e) for g, e in branches), otherwise)


ZERO, ONE = num(0), num(1)


def total(parts):
    parts = list(parts)
    out = parts[0] if parts else ZERO
    for p in parts[1:]:
        out = add(out, p)
    return out


def children(e):
    """The expressions right under e, guards included."""
    kind = e[0]
    if kind in ("n", "v"):
        return []
    if kind in ("^", "d"):
        return [e[1]]
    if kind == "cases":
        out = []
        for guard, value in e[1]:
            for _, a, b in guard:
                out += [a, b]
            out.append(value)
        if e[2] is not None:
            out.append(e[2])
        return out
    return list(e[1:])


def walk(e):
    yield e
    for c in children(e):
        yield from walk(c)


def symbols(e, lets, memo={}):
    """All names that occur, definitions expanded."""
    out = set()
    for node in walk(e):
        if node[0] == "v":
            out |= symbols(lets[node[1]], lets) if node[1] in lets else {node[1]}
        elif node[0] == "d":
            out.add(node[2])
    return out


def substitute(e, table):
    """Names replaced by expressions. Not for what stands under a derivative."""
    kind = e[0]
    if kind == "n":
        return e
    if kind == "v":
        return table.get(e[1], e)
    if kind == "^":
        return ("^", substitute(e[1], table), e[2])
    if kind == "d":
        return ("d", substitute(e[1], table), e[2])
    if kind == "cases":
        branches = tuple(
            (tuple((op, substitute(a, table), substitute(b, table)) for op, a, b in guard), substitute(v, table))
            for guard, v in e[1]
        )
        return ("cases", branches, None if e[2] is None else substitute(e[2], table))
    return (kind,) + tuple(substitute(c, table) for c in e[1:])


def literal_zero(e):
    return e == ZERO or (e[0] == "neg" and literal_zero(e[1]))


def tame(e):
    """Division by a literal zero is an error of a document, not a question; so it is disguised."""
    kind = e[0]
    if kind in ("n", "v"):
        return e
    if kind == "cases":
        branches = tuple((tuple((op, tame(a), tame(b)) for op, a, b in g), tame(v)) for g, v in e[1])
        return ("cases", branches, None if e[2] is None else tame(e[2]))
    if kind in ("^", "d"):
        a = tame(e[1])
        if kind == "^" and e[2] < 0 and literal_zero(a):
            a = sub(ONE, ONE)
        return (kind, a, e[2])
    parts = tuple(tame(c) for c in e[1:])
    if kind == "/" and literal_zero(parts[1]):
        parts = (parts[0], sub(ONE, ONE))
    return (kind,) + parts


def _number(value, rng):
    if value.denominator == 1:
        return str(value), (UNARY if value < 0 else ATOM)
    if rng and 10 % value.denominator == 0 and rng.random() < 0.2:
        whole, rest = divmod(abs(value.numerator) * (10 // value.denominator), 10)
        return ("-" if value < 0 else "") + f"{whole}.{rest}", (UNARY if value < 0 else ATOM)
    return f"{value.numerator}/{value.denominator}", MUL


def _text(e, rng):
    """Text and the precedence of its outermost operator."""
    kind = e[0]
    if kind == "n":
        return _number(e[1], rng)
    if kind == "v":
        return e[1], ATOM
    if kind == "neg":
        return "-" + show(e[1], UNARY + 1, rng), UNARY
    if kind == "+":
        return show(e[1], ADD, rng) + " + " + show(e[2], MUL, rng, right=True), ADD
    if kind == "-":
        return show(e[1], ADD, rng) + " - " + show(e[2], MUL, rng, right=True), ADD
    if kind in "*/":
        return show(e[1], MUL, rng) + kind + show(e[2], UNARY, rng, right=kind == "/"), MUL
    if kind == "^":
        return show(e[1], ATOM, rng) + "^" + str(e[2]), POW
    if kind in ("abs", "sqrt"):
        return f"{kind}({show(e[1], 0, rng)})", ATOM
    if kind in ("min", "max"):
        return f"{kind}({show(e[1], 0, rng)}, {show(e[2], 0, rng)})", ATOM
    if kind == "d":
        return f"d({show(e[1], 0, rng)}, {e[2]})", ATOM
    parts = [", ".join(relation(r, rng) for r in guard) + ": " + show(v, 0, rng) for guard, v in e[1]]
    if e[2] is not None:
        parts.append("else: " + show(e[2], 0, rng))
    return "cases { " + "; ".join(parts) + " }", ATOM


def show(e, level=0, rng=None, right=False):
    """Text that stands where at least the given precedence is asked for.

    With a source of chance there are now and then more parentheses than it takes.
    """
    text, own = _text(e, rng)
    minus = text.startswith("-") and right
    spare = rng is not None and own != ATOM and rng.random() < 0.05
    return f"({text})" if own < level or minus or spare else text


def relation(r, rng=None):
    return f"{show(r[1], 0, rng)} {r[0]} {show(r[2], 0, rng)}"
