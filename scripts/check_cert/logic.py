"""`and`, `or`, `implies` and `iff` (the language, "Logic, and definitions with arguments").

A part is a tuple of relations, all of which are meant.
"""

ZERO, ONE = ("num", 0, 1), ("num", 1, 1)
WORDS = ("and", "or", "implies", "iff")


def truth(part):
    """1 where a part holds, 0 where it does not."""
    return ("cases", ((part, ONE),), ZERO)


def either(parts):
    return (("=", ("cases", tuple((part, ONE) for part in parts), ZERO), ONE),)


def formula(reader, left=None):
    """Reads a formula, of which the first side may have been read; gives its relations."""
    first = implication(reader, left)
    if not reader.take("iff"):
        return first
    second = implication(reader)
    if reader.word == "iff":
        reader.fail("a second `iff` needs parentheses")
    return (("=", truth(first), truth(second)),)


def implication(reader, left=None):
    first = choice(reader, left)
    if not reader.take("implies"):
        return first
    second = choice(reader)
    if reader.word == "implies":
        reader.fail("a second `implies` needs parentheses")
    return (("=", ("cases", ((first, truth(second)),), ONE), ONE),)


def choice(reader, left=None):
    parts = [conjunction(reader, left)]
    while reader.take("or"):
        parts.append(conjunction(reader))
    return either(parts) if len(parts) > 1 else parts[0]


def conjunction(reader, left=None):
    found = part(reader, left)
    while reader.take("and"):
        found += part(reader)
    return found


def part(reader, left=None):
    if left is None and encloses_relations(reader):
        reader.expect("(")
        inner = formula(reader)
        reader.expect(")")
        return inner
    return reader.chain(left)


def encloses_relations(reader):
    """Is a formula in parentheses ahead? Between braces relations are guards of an expression."""
    if reader.kind != "sign" or reader.word != "(":
        return False
    depth = braces = 0
    text = reader.text
    at = reader.start
    while at < len(text):
        letter = text[at]
        if letter == "#":
            at = text.find("\n", at)
            if at < 0:
                return False
        elif letter == "(":
            depth += 1
        elif letter == ")":
            depth -= 1
            if not depth:
                return False
        elif letter in "{}":
            braces += 1 if letter == "{" else -1
        elif letter in "<>=≤≥≠" and not braces and text[at - 1:at + 1] != "->":
            return True
        at += 1
    return False
