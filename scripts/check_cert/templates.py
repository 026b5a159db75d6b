"""Definitions with arguments (the language, "Logic, and definitions with arguments").

While the body is read, ("par", i) stands for the parameter at place i.
"""

from .arrays import Array

MAX_PARAMETERS = 32
MAX_WRITTEN = 5_000_000


def replaced(expression, arguments):
    """The expression with arguments for its parameters."""
    if not isinstance(expression, tuple) or not expression:
        return expression
    if expression[0] == "par":
        return arguments[expression[1]]
    if expression[0] == "num":
        return expression
    return tuple(replaced(part, arguments) for part in expression)


def size(expression, arguments=()):
    """How many parts an expression has, with parameters of these sizes."""
    if not isinstance(expression, tuple):
        return 0
    if expression and expression[0] == "par" and arguments:
        return arguments[expression[1]]
    return 1 + sum(size(part, arguments) for part in expression)


def found_in(expression):
    """The parameters in an expression."""
    if not isinstance(expression, tuple) or not expression:
        return set()
    if expression[0] == "par":
        return {expression[1]}
    return set().union(*(found_in(part) for part in expression))


def surely_read(expression):
    """The parameters that are read wherever the expression is."""
    if not isinstance(expression, tuple):
        return set()
    if expression[0] == "par":
        return {expression[1]}
    if expression[0] == "cases":
        if not expression[1]:
            return surely_read(expression[2])
        _, left, right = expression[1][0][0][0]
        return surely_read(left) | surely_read(right)
    return set().union(*(surely_read(part) for part in expression[1:]))


def components(value):
    return value.parts() if isinstance(value, Array) else [value]


class Template:
    """What `f(a, b)` stands for."""

    def __init__(self, name, count, body):
        self.name, self.count, self.body = name, count, body
        read = set().union(*map(surely_read, components(body)))
        self.loose = [place for place in range(count) if place not in read]

    def of(self, arguments, fail):
        if len(arguments) != self.count:
            fail(f"`{self.name}` takes {self.count} arguments")
        sizes = [size(argument) for argument in arguments]
        if sum(size(part, sizes) for part in components(self.body)) > MAX_WRITTEN:
            fail("this comes to too much when written out")
        unread = [arguments[place] for place in self.loose]
        guard = tuple(("=", a, a) for a in unread if a[0] not in ("num", "sym", "par"))

        def put_in(part):
            part = replaced(part, arguments)
            return ("cases", ((guard, part),), None) if guard else part

        return self.body.each(put_in) if isinstance(self.body, Array) else put_in(self.body)
