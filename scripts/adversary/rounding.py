"""Bounds on round-off, held against random floats: rounding.py KANE [FORMULAS [SEED]]

Random formulas over random ranges go to `kane stability` as FPCore, and what it prints is tried at floats that are
drawn everywhere, next to the ends of the ranges, around the inputs that it names, around zeros of the value and
around the ends of the ranges in which it says that digits may be lost. Values are exact fractions; roots are between
two integers over 2^300. Nothing is shared with the program: formulas are read back by a reader of our own, and
machine arithmetic is Python's for binary64 and rounded from fractions for binary32.

Wrong is:
- an error above the bound that is printed, absolute or in ulps, of the formula or of a repair;
- a bound, and an input at which the machine overflows or there is no value;
- an input that loses more than half of its bits outside of the ranges printed;
- an error that is printed as found, and is not there;
- a repair that is not equal.
"""

import math
import struct
import sys
from fractions import Fraction

from trial import Trial

BATCH = 10
POINTS = 160
ROOT = 300  # binary places of a root
FORMATS = {"f32": (24, -149, 127), "f64": (53, -1074, 1023)}  # bits, least exponent, greatest binade


# --- reading

def read(text):
    """The s-expressions of a text as nested lists."""
    tokens = text.replace("(", " ( ").replace(")", " ) ").replace("[", " ( ").replace("]", " ) ").split()
    stack = [[]]
    for token in tokens:
        if token == "(":
            stack.append([])
        elif token == ")":
            done = stack.pop()
            stack[-1].append(done)
        else:
            stack[-1].append(token)
    return stack[0]


def number(text):
    """The fraction that a literal is."""
    try:
        return Fraction(text)
    except ValueError:
        return Fraction(*float.fromhex(text).as_integer_ratio())


# --- machine arithmetic

def rounded(x, form):
    """A fraction to the nearest float, ties to even, as a fraction; None beyond the greatest."""
    bits, least, greatest = FORMATS[form]
    if x == 0:
        return x
    n, d = abs(x.numerator), x.denominator
    e = n.bit_length() - d.bit_length()
    while Fraction(n, d) < Fraction(2) ** e:
        e -= 1
    while Fraction(n, d) >= Fraction(2) ** (e + 1):
        e += 1
    unit = max(e - bits + 1, least)
    scaled = Fraction(n, d) / Fraction(2) ** unit
    value = round(scaled) * Fraction(2) ** unit  # Python rounds halves to even
    if value >= Fraction(2) ** (greatest + 1):
        return None
    return -value if x < 0 else value


def single(x):
    """A Python float to binary32, None beyond. Sums, products, quotients and roots of binary32 lose nothing on the
    way through binary64, which has more than twice as many bits."""
    try:
        return struct.unpack("<f", struct.pack("<f", x))[0]
    except OverflowError:
        return None


class Undefined(Exception):
    """There is no value."""


class Unknown(Exception):
    """The oracle cannot tell."""


class Machine:
    """Evaluates an expression as a machine does: on Python floats, those of binary32 among them."""

    def __init__(self, form):
        self.form = form
        self.constants = {}

    def fit(self, x):
        if self.form == "f32":
            x = single(x)
        if x is None or math.isinf(x) or math.isnan(x):
            raise Undefined
        return x

    def constant(self, text):
        if text not in self.constants:
            value = rounded(number(text), self.form)
            self.constants[text] = None if value is None else float(value)
        if self.constants[text] is None:
            raise Undefined
        return self.constants[text]

    def op(self, name, values):
        try:
            if name == "-" and len(values) == 1:
                return -values[0]
            if name == "fabs":
                return abs(values[0])
            if name == "sqrt":
                return self.fit(math.sqrt(values[0]))
            if name == "fma":
                a, b, c = map(Fraction, values)
                x = rounded(a * b + c, self.form)
                if x is None:
                    raise Undefined
                return float(x)
            a, b = values
            if name == "fmin":
                return min(a, b)
            if name == "fmax":
                return max(a, b)
            return self.fit({"+": a.__add__, "-": a.__sub__, "*": a.__mul__, "/": a.__truediv__}[name](b))
        except (ZeroDivisionError, ValueError, OverflowError):
            raise Undefined from None

    @staticmethod
    def less(name, a, b):
        return {"<": a < b, "<=": a <= b, ">": a > b, ">=": a >= b, "==": a == b, "!=": a != b}[name]


class Onward(Machine):
    """A machine that does not stop at an infinity or at what is no number, as IEEE 754 has it by default."""

    def fit(self, x):
        if self.form != "f32" or math.isinf(x) or math.isnan(x):
            return x
        x, beyond = single(x), math.copysign(math.inf, x)
        return beyond if x is None else x

    def op(self, name, values):
        numbers = [x for x in values if not math.isnan(x)]
        if name in ("fmin", "fmax") and len(numbers) == 1:
            return numbers[0]
        try:
            return super().op(name, values)
        except Undefined:
            if name == "/" and values[1] == 0 and values[0] != 0 and not math.isnan(values[0]):
                return math.copysign(math.inf, values[0]) * math.copysign(1, values[1])
            if name == "fma":
                raise  # Python has none that overflows
            return math.nan


class Exact:
    """Evaluates an expression on intervals of fractions, of no width but for roots."""

    form = "exact"

    @staticmethod
    def constant(text):
        value = number(text)
        return value, value

    @staticmethod
    def root(x, up):
        n, d = math.isqrt(x.numerator), math.isqrt(x.denominator)
        if n * n == x.numerator and d * d == x.denominator:
            return Fraction(n, d)
        shift = 2 * ROOT + max(0, x.denominator.bit_length() - x.numerator.bit_length())
        shift += shift % 2
        scaled = (x.numerator << shift) // x.denominator
        return Fraction(math.isqrt(scaled) + up, 1 << (shift // 2))

    def product(self, a, b):
        if a[0] == a[1] and b[0] == b[1]:
            return (a[0] * b[0],) * 2
        corners = [x * y for x in a for y in b]
        return min(corners), max(corners)

    def op(self, name, values):
        if name == "-" and len(values) == 1:
            return -values[0][1], -values[0][0]
        if name == "fabs":
            (l, u), = values
            return (l, u) if l >= 0 else (-u, -l) if u <= 0 else (Fraction(0), max(-l, u))
        if name == "sqrt":
            (l, u), = values
            if u < 0:
                raise Undefined
            if l < 0:
                raise Unknown
            return self.root(l, 0), self.root(u, 1)
        if name == "fma":
            return self.op("+", [self.product(*values[:2]), values[2]])
        a, b = values
        if name == "+":
            return a[0] + b[0], a[1] + b[1]
        if name == "-":
            return a[0] - b[1], a[1] - b[0]
        if name == "*":
            return self.product(a, b)
        if name == "/":
            if b[0] == b[1] == 0:
                raise Undefined
            if b[0] <= 0 <= b[1]:
                raise Unknown
            return self.product(a, (1 / b[1], 1 / b[0]))
        pick = min if name == "fmin" else max
        return pick(a[0], b[0]), pick(a[1], b[1])

    @staticmethod
    def less(name, a, b):
        if name in (">", ">="):
            return Exact.less("<" if name == ">" else "<=", b, a)
        if name in ("==", "!="):
            if a[0] == a[1] == b[0] == b[1]:
                return name == "=="
            if a[1] < b[0] or b[1] < a[0]:
                return name == "!="
            raise Unknown
        strict = name == "<"
        if a[1] < b[0] or (not strict and a[1] <= b[0]):
            return True
        if a[0] > b[1] or (strict and a[0] >= b[1]):
            return False
        raise Unknown


def evaluate(e, at, system):
    """The value of an expression; names are looked up in `at`."""
    if isinstance(e, str):
        value = at[e] if e in at else system.constant(e)
        if isinstance(value, Exception):
            raise value
        return value
    head = e[0]
    if head in ("let", "let*"):
        inner = dict(at)
        for name, value in e[1]:
            # what has no value is a fault where it is read: a NaN that nothing reads is no part of a result
            try:
                inner[name] = evaluate(value, inner if head == "let*" else at, system)
            except (Undefined, Unknown) as why:
                inner[name] = why
        return evaluate(e[2], inner, system)
    if head == "if":
        return evaluate(e[2] if holds(e[1], at, system) else e[3], at, system)
    return system.op(head, [evaluate(part, at, system) for part in e[1:]])


def holds(e, at, system):
    if e in ("TRUE", "FALSE"):
        return e == "TRUE"
    if e[0] == "not":
        return not holds(e[1], at, system)
    if e[0] in ("and", "or"):
        telling, open_part = e[0] == "or", None
        for part in e[1:]:
            try:
                if holds(part, at, system) == telling:
                    return telling  # whatever the others are, and whether or not they have a value
            except (Undefined, Unknown) as why:
                open_part = open_part or why
        if open_part:
            raise open_part
        return not telling
    values = [evaluate(part, at, system) for part in e[1:]]
    return all(system.less(e[0], a, b) for a, b in zip(values, values[1:]))


# --- formulas

NUMBERS = ["1", "2", "3", "0.1", "1/3", "-1", "0.5", "100", "-2.7", "1e-3", "1e10", "0x1.8p-3", "4"]
ENDS = ["-1e6", "-1000", "-10", "-1", "-0.1", "-1e-9", "0", "1e-12", "1e-3", "0.3", "1", "1.5", "2", "7", "100", "1e6"]


def formula(rng, names, depth):
    sub = lambda: formula(rng, names, depth - 1)
    if depth == 0:
        return rng.choice(NUMBERS) if rng.random() < 0.35 else rng.choice(names)
    pick = rng.random()
    if pick < 0.42:
        return f"({rng.choice('+-')} {sub()} {sub()})"
    if pick < 0.60:
        return f"(* {sub()} {sub()})"
    if pick < 0.68:
        return f"(/ {sub()} {sub()})"
    if pick < 0.77:
        return f"(sqrt {sub()})"
    if pick < 0.80:
        return f"(fma {sub()} {sub()} {sub()})"
    if pick < 0.83:
        return f"({rng.choice(['-', 'fabs'])} {sub()})"
    if pick < 0.86:
        return f"({rng.choice(['fmin', 'fmax'])} {sub()} {sub()})"
    if pick < 0.90:
        test = f"({rng.choice(['<', '<=', '>', '>='])} {sub()} {sub()})"
        if rng.random() < 0.3:
            test = f"({rng.choice(['and', 'or'])} {test} (not (< {sub()} {sub()})))"
        return f"(if {test} {sub()} {sub()})"
    if pick < 0.94:
        inner = formula(rng, names + ["t"], depth - 1)
        return f"(let ([t {sub()}]) {inner})"
    if pick < 0.97:
        # what cancels
        x = rng.choice(names)
        return rng.choice([f"(- (sqrt (+ {x} {sub()})) (sqrt {x}))", f"(- (/ 1 {x}) (/ 1 (+ {x} 1)))",
                           f"(- {sub()} (* {x} {x}))"])
    return rng.choice(names)


def setting(rng, names):
    """Ranges of arguments, a format, and the properties of a core that say both."""
    ranges = {}
    for name in names:
        a, b = sorted(rng.sample(range(len(ENDS)), 2))
        ranges[name] = (ENDS[a], ENDS[b])
    form = rng.choice(["f32", "f64"])
    pre = " ".join(f"(<= {low} {name} {high})" for name, (low, high) in ranges.items())
    precision = {"f32": "binary32", "f64": "binary64"}[form]
    return ranges, form, f":precision {precision} :pre (and {pre})"


def core(rng, index):
    """The text of one core, its arguments with their ends, its format and its body."""
    names = ["x", "y"][: 1 if rng.random() < 0.7 else 2]
    body = formula(rng, names, rng.randint(2, 4))
    ranges, form, properties = setting(rng, names)
    text = f'(FPCore ({" ".join(names)}) :name "f{index}" {properties} {body})'
    return text, ranges, form, read(body)[0]


# --- floats in order

def place(x, form):
    code = struct.unpack("i" if form == "f32" else "q", struct.pack("f" if form == "f32" else "d", x))[0]
    return code if code >= 0 else -(code & (0x7FFFFFFF if form == "f32" else 0x7FFFFFFFFFFFFFFF))


def at_place(p, form):
    pack, unpack = ("i", "f") if form == "f32" else ("q", "d")
    x = struct.unpack(unpack, struct.pack(pack, abs(p)))[0]
    return -x if p < 0 else x


def ends_of(low, high, form):
    """Places of the first and the last float of a range."""
    low, high = number(low), number(high)
    first, last = place(float(rounded(low, form)), form), place(float(rounded(high, form)), form)
    return first + (Fraction(at_place(first, form)) < low), last - (Fraction(at_place(last, form)) > high)


def zeros(body, names, ends, form, rng):
    """Floats around which the value changes its sign, along the first argument."""
    exact, found = Exact(), []
    first, last = ends[0]
    for _ in range(3):
        rest = {n: (Fraction(at_place(rng.randint(*e), form)),) * 2 for n, e in zip(names[1:], ends[1:])}

        def sign(p):
            value = evaluate(body, {names[0]: (Fraction(at_place(p, form)),) * 2, **rest}, exact)
            return 1 if value[0] > 0 else -1 if value[1] < 0 else 0

        places = sorted(rng.randint(first, last) for _ in range(10))
        for a, b in zip(places, places[1:]):
            try:
                sa, sb = sign(a), sign(b)
                if sa * sb >= 0:
                    continue
                while b - a > 1:
                    middle = (a + b) // 2
                    if sign(middle) == sa:
                        a = middle
                    else:
                        b = middle
                found.append((a, [place(float(v[0]), form) for v in rest.values()]))
                break
            except (Undefined, Unknown):
                continue
    return found


def points(body, names, ends, form, report, rng):
    """Places that are tried: everywhere, and where the program said that something happens."""
    centres = [[end] for end in ends[0]] if len(ends) == 1 else [[a, b] for a in ends[0] for b in ends[1]]
    for key in ("error_found", "ulps_found"):
        if report[key]:
            centres.append([place(float(x), form) for x in report[key]["at"]])
    for cell in report["half_lost"]:
        for end in ("from", "to"):
            centres.append([place(float(r[end]), form) for r in cell])
    for p, rest in zeros(body, names, ends, form, rng):
        centres.append([p, *rest])
    out = []
    for turn in range(POINTS):
        way = turn % 4
        if way == 0:
            at = [rng.randint(a, b) for a, b in ends]
        elif way == 1:
            at = []
            for a, b in ends:
                low, high = at_place(a, form), at_place(b, form)
                at.append(place(single(rng.uniform(low, high)) if form == "f32" else rng.uniform(low, high), form))
        else:
            at = [p + rng.choice([0, 1, -1]) * rng.randrange(1 << rng.randint(0, 30)) for p in rng.choice(centres)]
        out.append(tuple(min(max(p, a), b) for p, (a, b) in zip(at, ends)))
    return list(dict.fromkeys(out))


# --- judging

def ulp(value, form):
    """2^e for the ulp of the binade of a fraction."""
    bits, least, _ = FORMATS[form]
    if value == 0:
        return Fraction(2) ** least
    n, d = abs(value.numerator), value.denominator
    e = n.bit_length() - d.bit_length()
    if Fraction(n, d) < Fraction(2) ** e:
        e -= 1
    return Fraction(2) ** max(e - bits + 1, least)


def error_at(body, names, at, form, machine):
    """(error, error in ulps) at least, exactly; (None, None) where the machine fails; raises where there is no
    value, or the oracle cannot tell."""
    exact = evaluate(body, {n: (Fraction(x),) * 2 for n, x in zip(names, at)}, Exact())
    try:
        computed = Fraction(evaluate(body, dict(zip(names, at)), machine))
    except (Undefined, OverflowError, ValueError):
        return None, None
    error = max(exact[0] - computed, computed - exact[1], Fraction(0))
    unit = max(ulp(exact[0], form), ulp(exact[1], form))
    return error, error / unit


def named(text, form):
    """The float that a decimal names."""
    return at_place(place(float(text), form), form)


def inside(cells, names, at, form):
    for cell in cells:
        ranges = {r["argument"]: r for r in cell}
        if all(named(ranges[n]["from"], form) <= x <= named(ranges[n]["to"], form) for n, x in zip(names, at)):
            return True
    return False


def judge(trial, made, formula_report, rng):
    text, ranges, form, body = made
    names = list(ranges)
    ends = [ends_of(*ranges[name], form) for name in names]
    report, = formula_report["formats"]
    wrong = lambda why: trial.wrong.append((text, why))
    machine = Machine(form)
    all_bits = 1 << FORMATS[form][0]
    forms = [(body, report["error_at_most"], report["ulps_at_most"], "")]
    for repair in report["repairs"]:
        forms.append((read(repair["fpcore"])[0][-1], repair["error_at_most"], repair["ulps_at_most"], "a repair: "))
        trial.count_one("repairs")
    trial.count_one(f"{form} {'with a bound' if report['error_at_most'] is not None else 'with a pole'}")
    if report["half_lost"] == []:
        trial.count_one("formulas that keep half of the bits everywhere")
    for key, which in (("error_found", 0), ("ulps_found", 1)):
        found = report[key]
        if not found or found["error"] is None:
            continue
        at = [named(x, form) for x in found["at"]]
        try:
            # what is found is what comes out, also where the machine went through an infinity on the way
            here = error_at(body, names, at, form, Onward(form))[which]
        except (Undefined, Unknown):
            continue
        # what is printed is a lower bound, and the oracle's is one too, of up to 2^-60 less
        if here is None or Fraction(found["error"]) > here * (1 + Fraction(1, 2**40)):
            wrong(f"{key} {found['error']} at {at}, and it is {here if here is None else float(here)}")
    for at in points(body, names, ends, form, report, rng):
        at = [at_place(p, form) for p in at]
        values = []
        for which, (expression, absolute, ulps, name) in enumerate(forms):
            try:
                error, lost = error_at(expression, names, at, form, machine)
            except Unknown:
                trial.count_one("points of which the oracle cannot tell")
                continue
            except Undefined:
                if absolute is not None or (which == 0 and not inside(report["half_lost"], names, at, form)):
                    wrong(f"{name}no value at {at}, and a bound")
                continue
            trial.judged += 1
            if error is None:
                if absolute is not None or ulps is not None:
                    wrong(f"{name}the machine fails at {at}, and a bound")
                if which == 0 and not inside(report["half_lost"], names, at, form):
                    wrong(f"the machine fails at {at}, outside of the ranges")
                continue
            if absolute is not None and error > Fraction(absolute):
                wrong(f"{name}error {float(error)} at {at}, above {absolute}")
            if ulps is not None and lost > Fraction(ulps):
                wrong(f"{name}{float(lost)} ulps at {at}, above {ulps}")
            if which == 0 and lost * lost > all_bits:
                trial.count_one("points that lose more than half of the bits")
                if not inside(report["half_lost"], names, at, form):
                    wrong(f"{float(lost)} ulps at {at}, outside of the ranges")
        if len(forms) > 1:
            for expression, *_ in forms:
                try:
                    values.append(evaluate(expression, {n: (Fraction(x),) * 2 for n, x in zip(names, at)}, Exact()))
                except (Undefined, Unknown):
                    values.append(None)
            for value in values[1:]:
                if values[0] and (value is None or value[0] > values[0][1] or value[1] < values[0][0]):
                    wrong(f"a repair is {value} at {at}, and the formula is {values[0]}")


def main():
    trial = Trial("rounding")
    for asked in trial.formulas(core, BATCH):
        for one, report, rng in asked:
            if not report["formats"]:
                trial.count_one("no float in the range")
                continue
            judge(trial, one, report, rng)
    return trial.told(f", {trial.count} formulas", "points")


if __name__ == "__main__":
    sys.exit(main())
