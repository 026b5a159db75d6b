"""How indices, powers and sequences are declared, and the ranges of claims on them."""

from fractions import Fraction

from . import templates
from .sequences import MAX_INDEX


def declare_index(document, symbol, signs, reader):
    if signs or symbol.argument or symbol.name in document.wanted:
        reader.fail("an index has no bounds, and is no function and no angle")
    symbol.lower = (Fraction(0), False)
    document.declare(symbol)
    document.sequences.indices.add(symbol.name)


def declare_powers(document):
    """The symbols of the powers that are spoken of, and of which base and index are known by now."""
    known = document.sequences
    for base, index in sorted(document.powers):
        name = f"pow({base}, {index})"
        if index not in known.indices or name in known.powers:
            continue
        if base.isdigit():
            expression = ("num", int(base), 1)
        elif base in document.symbols:
            expression = ("def" if document.symbols[base].body else "sym", base)
        else:
            continue
        lower, upper = known.bounds(expression)
        document.declare_name(name, lower=lower, upper=upper)
        known.powers[name] = (expression, index)


def read_term(document, name, reader):
    """Reads `n) := EXPR` behind `let h(`."""
    index = reader.name()
    reader.expect(")")
    reader.expect(":=")
    term = reader.sum()
    document.take_name(name)
    document.sequences.terms[name] = (index, term)


def read_recursion(document, name, reader):
    """Reads `0) := FIRST, s(n + 1) := NEXT`."""
    if reader.word != "0":
        reader.fail("a sequence begins at 0")
    reader.advance()
    reader.expect(")")
    reader.expect(":=")
    first = reader.sum()
    reader.expect(",")
    reader.expect(name)
    reader.expect("(")
    index = reader.name()
    if index not in document.sequences.indices:
        reader.fail("this is no index")
    reader.expect("+")
    if reader.word != "1":
        reader.fail("a step leads from n to n + 1")
    reader.advance()
    reader.expect(")")
    reader.expect(":=")
    reader.bound, reader.recursion = (name,), index
    step = reader.sum()
    known = document.sequences
    if not (known.is_total(first, None) and known.is_total(step, index)):
        reader.fail("this may have no value somewhere")
    term = ("sym", f"{name}({index})")
    document.declare_name(term[1])
    known.steps[term[1]] = (first, templates.replaced(step, [term]), index)
    document.take_name(name)
    known.terms[name] = (index, term)


def read_range(document, statement, reader):
    """Reads `for n >= 1`, which is a condition."""
    reader.expect("for")
    index = reader.name()
    if index not in document.sequences.indices:
        reader.fail("this is no index")
    reader.expect(">=")
    if reader.kind != "number" or not reader.word.isdigit() or int(reader.word) > MAX_INDEX:
        reader.fail("expected a natural number up to 64")
    statement.range = (index, int(reader.word))
    reader.advance()
    statement.when = ((">=", ("sym", index), ("num", statement.range[1], 1)),)
