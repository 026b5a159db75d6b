"""What a report says of a point, line by line, against values of our own: definitions, and both sides of each relation.

    At the point x = 1, y = 2, where F = about 1.4142, G is undefined (division by zero):
    g, x = 1: 1 = 1
    the claim, F = y: left side about 1.4142, right side 2
    All else that is assumed above holds there too, with z = 3:
    h, z > x: 3 > 1
"""

import re
from fractions import Fraction

from algebraic import sign
from point import Ambiguous, Undefined, evaluate, holds
from reader import Reader, Unreadable, number, pairs

HEAD = re.compile(r"^At (?:the point (.*?)|every point)(?:, where (.*))?:$")
BESIDE = re.compile(r"^(All else that is assumed above holds|What is assumed above and not cited fails) there(?: too)?(?:, with (.*))?:$")
DEFINED = re.compile(r"(?:^|, )([A-Za-z_][A-Za-z_0-9']*) (?:=|is) ")
LINE = re.compile(r"^(.*?), (.*?): (undefined \(.*\)|left side .*, right side .*|[^:]*)$")
ABOUT = re.compile(r"^about (-?)(\d+)\.(\d+)(?:e(-?\d+))?$")


BROKEN = ("At ", "All else ", "What is assumed ", "Take ")


def point(text):
    """The values of 'At the point …:' as a text, and those of definitions by their names; None if it is another line."""
    m = HEAD.match(text)
    if not m:
        return None
    parts = DEFINED.split(m.group(2) or "")
    return m.group(1) or "", dict(zip(parts[1::2], parts[2::2]))


def value(e, place):
    """The value at a place; None if there is none."""
    try:
        return evaluate(e, place.scope)
    except Undefined:
        return None


def fits(text, v):
    """Whether a value is what is told of it; None if nothing is told."""
    if text.startswith("not computed"):
        return None
    if text.startswith("undefined"):
        return v is None
    if v is None:
        return False
    m = ABOUT.match(text)
    if not m:
        return sign(v - number(text, {})) == 0
    minus, whole, rest, ten = m.groups()
    unit = Fraction(10) ** (int(ten or 0) - len(rest))
    shown = int(whole + rest) * unit * (-1 if minus else 1)
    # half a unit, and what the program may not know of the value
    within = unit * Fraction(501, 1000)
    return sign(v - (shown - within)) >= 0 >= sign(v - (shown + within))


def lines(link):
    """The lines of a witness; those that name values may be broken where they are long."""
    out = []
    for step in link["steps"]:
        if out and out[-1].startswith(BROKEN) and not out[-1].endswith((":", ".")):
            out[-1] += " " + step["text"]
        else:
            out.append(step["text"])
    return out


def relation(text):
    reader = Reader(text)
    out = reader.relation()
    if reader.peek() is not None:
        raise Unreadable(text)
    return out


def mistakes(link, place):
    """Lines of a witness that are not so at the place; and how many lines were read."""
    wrong, read, all_hold = [], 0, False
    for text in lines(link):
        head, beside = point(text), BESIDE.match(text)
        try:
            if beside is not None:
                all_hold = beside.group(1).endswith("holds")
                place = place.beside({n: number(v, {}) for n, v in pairs(beside.group(2) or "")})
                continue
            if head is not None:
                for name, said in head[1].items():
                    read += 1
                    if fits(said, value(("v", name), place)) is False:
                        wrong.append(f"{name} {said}")
                continue
            m = LINE.match(text)
            if not m:
                continue
            written, said = m.group(2), m.group(3)
            if ";" in said or said in ("true", "false"):
                continue
            read += 1
            fails = said.endswith(" is false") or said.startswith("undefined")
            if not so(relation(written), said, place) or all_hold and fails:
                wrong.append(text)
        except (Unreadable, Ambiguous, KeyError):
            continue
    return wrong, read


def so(r, said, place):
    """Whether what is said of a relation is so."""
    op, a, b = r
    a, b = value(a, place), value(b, place)
    if said.startswith("undefined"):
        return a is None or b is None
    if said.startswith("left side "):
        left, right = said[len("left side "):].split(", right side ")
        return fits(left, a) is not False and fits(right, b) is not False
    fails = said.endswith(" is false")
    told, left, right = relation(said[: -len(" is false")] if fails else said)
    left, right = (number_of(side) for side in (left, right))
    if a is None or b is None or told != op:
        return False
    return sign(a - left) == 0 == sign(b - right) and holds(op, a, b) is not fails


def number_of(e):
    from point import Scope

    try:
        return evaluate(e, Scope({}, {}))
    except (KeyError, Undefined):
        raise Unreadable(str(e)) from None
