"""Vectors and matrices, written out in components (the language, "Vectors and matrices")."""

import re
from dataclasses import dataclass

from .logic import either

AXES = "xyz"
FUNCTIONS = {"dot": 2, "cross": 2, "norm": 1, "det": 1, "transpose": 1, "inverse": 1}
SPACE = re.compile(r"R\s*\^?\s*([23²³])(?:\s*[x*·⋅×]\s*([23]))?(?![\w.])")


@dataclass(frozen=True)
class Array:
    """Rows of one component (a vector), or of as many as there are rows."""

    rows: tuple
    matrix: bool

    @property
    def kind(self):
        return (self.matrix, len(self.rows))

    def parts(self):
        return [part for row in self.rows for part in row]

    def each(self, change):
        return Array(tuple(tuple(change(part) for part in row) for row in self.rows), self.matrix)


def vector(parts):
    return Array(tuple((part,) for part in parts), False)


def names(name, matrix, size):
    """What the components of a symbol are called."""
    bare = name.rstrip("'")
    axes = [a + b for a in AXES[:size] for b in AXES[:size]] if matrix else AXES[:size]
    return [f"{bare}_{axis}{name[len(bare):]}" for axis in axes]


def of_names(expressions, matrix, size):
    """The array of components in their order."""
    if not matrix:
        return vector(expressions)
    return Array(tuple(tuple(expressions[i * size:(i + 1) * size]) for i in range(size)), True)


def space(reader):
    """Reads `R^2` and the like: whether it is of matrices, and the size."""
    match = SPACE.match(reader.text, reader.start)
    size = {"2": 2, "3": 3, "²": 2, "³": 3}.get(match[1]) if match else reader.fail("expected `R^2` or `R^3`")
    if match[2] and int(match[2]) != size:
        reader.fail("a matrix is square")
    reader.at = match.end()
    reader.advance()
    return bool(match[2]), size


def literal(items, fail):
    """`[a, b]`, or rows of a matrix."""
    size = len(items)
    if size not in (2, 3):
        fail("two or three components are expected")
    if not any(isinstance(item, Array) for item in items):
        return vector(items)
    if any(not isinstance(item, Array) or item.kind != (False, size) for item in items):
        fail("these are no rows of a matrix")
    return Array(tuple(tuple(item.parts()) for item in items), True)


def total(terms):
    result = terms[0]
    for term in terms[1:]:
        result = ("add", result, term)
    return result


def combined(kind, left, right, fail):
    """A sum, a difference, a product or a quotient."""
    if not isinstance(left, Array) and not isinstance(right, Array):
        return (kind, left, right)
    if kind in ("add", "sub"):
        if isinstance(left, Array) and isinstance(right, Array) and left.kind == right.kind:
            return Array(
                tuple(tuple((kind, a, b) for a, b in zip(*rows)) for rows in zip(left.rows, right.rows)),
                left.matrix,
            )
    elif not isinstance(right, Array):
        return left.each(lambda part: (kind, part, right))
    elif kind == "mul":
        if not isinstance(left, Array):
            return right.each(lambda part: (kind, left, part))
        if left.matrix and len(left.rows) == len(right.rows):
            columns = list(zip(*right.rows))
            return Array(
                tuple(
                    tuple(total([("mul", a, b) for a, b in zip(row, column)]) for column in columns)
                    for row in left.rows
                ),
                right.matrix,
            )
    return fail("this operation is not one of vectors and matrices")


def area(a, b, i, j):
    """The component of a vector product."""
    (p, q), (r, s) = ((a.rows[k][0], b.rows[k][0]) for k in (i, j))
    return ("sub", ("mul", p, s), ("mul", r, q))


def dot(a, b):
    return total([("mul", p, q) for p, q in zip(a.parts(), b.parts())])


def cofactor(rows, i, j):
    size = len(rows)
    if size == 2:
        other = rows[1 - i][1 - j]
        return other if i == j else ("neg", other)
    a, b = (i + 1) % 3, (i + 2) % 3
    c, d = (j + 1) % 3, (j + 2) % 3
    return ("sub", ("mul", rows[a][c], rows[b][d]), ("mul", rows[a][d], rows[b][c]))


def det(rows):
    if len(rows) == 2:
        return ("sub", ("mul", rows[0][0], rows[1][1]), ("mul", rows[0][1], rows[1][0]))
    return total([("mul", rows[0][j], cofactor(rows, 0, j)) for j in range(3)])


def applied(function, arguments, fail):
    """`dot(a, b)` and the like."""
    first, last = arguments[0], arguments[-1]
    plane, spatial = (False, 2), (False, 3)
    kinds = [argument.kind if isinstance(argument, Array) else None for argument in arguments]
    if function == "dot" and kinds in ([plane] * 2, [spatial] * 2):
        return dot(first, last)
    if function == "cross" and kinds == [plane] * 2:
        return area(first, last, 0, 1)
    if function == "cross" and kinds == [spatial] * 2:
        return vector([area(first, last, i, j) for i, j in ((1, 2), (2, 0), (0, 1))])
    if function == "cross" and kinds == [None, plane]:
        (x,), (y,) = last.rows
        return vector([("neg", ("mul", first, y)), ("mul", first, x)])
    if function == "norm" and kinds[0] in (plane, spatial):
        return ("sqrt", dot(first, first))
    if kinds[0] and kinds[0][0]:
        rows = first.rows
        if function == "det":
            return det(rows)
        if function == "transpose":
            return Array(tuple(zip(*rows)), True)
        if function == "inverse":
            size, by = range(len(rows)), det(rows)
            return Array(tuple(tuple(("div", cofactor(rows, j, i), by) for j in size) for i in size), True)
    return fail(f"`{function}` is not one of these")


def compared(sign, left, right, fail):
    """The relations that a comparison says."""
    arrays = isinstance(left, Array), isinstance(right, Array)
    if arrays == (False, False):
        return ((sign, left, right),)
    if arrays != (True, True) or left.kind != right.kind or sign not in ("=", "!="):
        fail("these are not compared")
    each = tuple((sign, a, b) for a, b in zip(left.parts(), right.parts()))
    return each if sign == "=" else either([(relation,) for relation in each])
