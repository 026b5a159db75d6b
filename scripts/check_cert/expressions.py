"""Words and expressions of the language.

An expression is a tuple, so two that are written alike are equal:
("num", n, d), ("sym", name), ("def", name), ("neg", a), ("add"|"sub"|"mul"|
"div"|"min"|"max", a, b), ("pow", a, n), ("abs"|"sqrt", a), ("d", f, x) and
("cases", ((relations, body), ...), last or None).
"""

import re
from fractions import Fraction

from . import angles, arrays, exponentials, logic, motion, sequences, sums, templates
from .arrays import Array
from .errors import Unreadable

# what no definition is called
MATHEMATICAL = {"sin", "cos", "tan", "exp", "log", "pi"}
RESERVED = set(
    "oo d abs min max sqrt cases else from when as using by expect not implied contradiction"
    " and or implies iff exists".split()
)
GREEK = dict(zip(
    "αβγδεζηθικλμνξοπρσςτυφχψωΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩϵϕϑϱ",
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho"
    " sigma sigma tau upsilon phi chi psi omega Alpha Beta Gamma Delta Epsilon Zeta Eta Theta"
    " Iota Kappa Lambda Mu Nu Xi Omicron Pi Rho Sigma Tau Upsilon Phi Chi Psi Omega"
    " epsilon phi theta rho".split(),
))
GREEK["µ"] = "mu"  # the micro sign
CLAUSES = ("as", "when", "from", "by", "expect")
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
SPACE = re.compile(r"(?:[ \t\n]|#[^\n]*)*")
LETTER = "A-Za-z" + "".join(GREEK)
WORD = re.compile(
    rf"(?P<number>[0-9]+(?:\.[0-9]+)?(?:[eE][-+]?[0-9]+)?)|(?P<raised>⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)|(?P<name>[{LETTER}][{LETTER}0-9_']*)|(?P<infinity>∞)"
    r"|(?P<sign>:=|<=|>=|!=|->|\.\.|[≤≥≠→−·⋅×]|[-+*/^=<>(){}|,;:\[\]])"
)
BEHIND = re.compile(rf"[{LETTER}0-9_]|\.(?!\.)")  # what no number ends before
LABEL = re.compile(r"\(([^()\n]*)\)|([\w.'-]+)")
SIGNS = {"≤": "<=", "≥": ">=", "≠": "!=", "→": "->", "−": "-", "·": "*", "⋅": "*", "×": "*"}
RELATIONS = ("=", "!=", "<", "<=", ">", ">=")
MAX_POWER = 2**15 - 1
MAX_DIGITS = 10_001


def spelled(name):
    """A name with its Greek letters spelled out."""
    return "".join(GREEK.get(letter, letter) for letter in name)


class Reader:
    """Reads one statement, or one expression, from its text."""

    def __init__(self, text, document):
        self.text, self.document = text, document
        self.at = 0
        self.in_angle = False
        self.bound = ()  # names that stand for arguments
        self.locals = []  # names that sums run over, with their values, from the outside in
        self.fixed = 0  # how many of them may not be spoken of
        self.in_term = False  # a term of a sum up to an index speaks of no index itself
        self.recursion = None  # the index of the sequence that is being defined, the only name bound
        self.advance()

    def advance(self):
        """Reads the next word."""
        self.start = self.at = SPACE.match(self.text, self.at).end()
        if self.at == len(self.text):
            self.kind, self.word = "end", ""
            return
        match = WORD.match(self.text, self.at)
        if not match:
            self.kind, self.word = "other", self.text[self.at]
            self.at += 1
            return
        self.kind, self.word, self.at = match.lastgroup, match.group(), match.end()
        if self.kind == "sign":
            self.word = SIGNS.get(self.word, self.word)
        elif self.kind == "name":
            self.word = spelled(self.word)
        elif self.kind == "infinity":
            self.kind, self.word = "name", "oo"
        elif BEHIND.match(self.text, self.at):
            self.kind = "malformed"  # unless it is the beginning of a label

    def ahead(self):
        """The word behind the one that was read last."""
        match = WORD.match(self.text, SPACE.match(self.text, self.at).end())
        return match.group() if match else self.text[self.at:].strip()[:1]

    def fail(self, reason):
        """Gives up, with the place."""
        raise Unreadable(f"{reason}, at `{self.text[self.start:self.start + 20]}` of `{self.text.strip()}`")

    def take(self, *words):
        """Reads one of some words, if one is there."""
        if self.kind in ("sign", "name") and self.word in words:
            word = self.word
            self.advance()
            return word
        return None

    def expect(self, word):
        """Reads a word that has to be there."""
        if not self.take(word):
            self.fail(f"expected `{word}`")

    def name(self):
        """Reads a name that is not reserved."""
        if self.word.startswith("$"):
            self.fail("LaTeX is not read here; write the formula as the report shows it")
        if self.kind != "name" or self.word in RESERVED:
            self.fail("expected a name")
        word = self.word
        self.advance()
        return word

    def label(self):
        """Reads a label, which may contain what no word does."""
        match = LABEL.match(self.text, self.start)
        if not match:
            self.fail("expected a label")
        label = match[1].strip(" \t") if match[1] is not None else match[2]
        if not label or match[2] in CLAUSES:
            self.fail("expected a label")
        self.at = match.end()
        self.advance()
        return label

    def done(self):
        """Nothing may be left."""
        if self.kind != "end":
            self.fail("an operator or the end of the statement is missing")

    def sum(self):
        """Reads an expression that is a number."""
        return self.number(self.value())

    def number(self, value):
        if isinstance(value, Array):
            self.fail("a number is expected")
        return value

    def value(self):
        """Reads an expression. A minus in front of a product is one of the whole product."""
        left = self.negative(self.product()) if self.take("-") else self.product()
        while sign := self.take("+", "-"):
            left = arrays.combined("add" if sign == "+" else "sub", left, self.product(), self.fail)
        return left

    def negative(self, value):
        return value.each(lambda part: ("neg", part)) if isinstance(value, Array) else ("neg", value)

    def product(self):
        left = self.signed()
        while sign := self.take("*", "/"):
            left = arrays.combined("mul" if sign == "*" else "div", left, self.signed(), self.fail)
        return left

    def signed(self):
        if self.take("-"):
            return self.negative(self.signed())
        base = self.atom()
        if self.kind == "raised" or (self.kind == "sign" and self.word == "^"):
            self.number(base)
        if self.kind == "raised":
            power = int(self.word.translate(RAISED))
            if abs(power) > MAX_POWER:
                self.fail("the exponent is too large")
            self.advance()
            return ("pow", base, power)
        if not self.take("^"):
            return base
        exponent = self.exponent_with_index()
        if exponent:
            return self.document.sequences.power(base, exponent, self.fail)
        number = self.exponent_by_number()
        return ("pow", base, self.exponent() if number is None else number)

    def state(self):
        return self.at, self.start, self.kind, self.word

    def go_back(self, state):
        self.at, self.start, self.kind, self.word = state

    def exponent_by_number(self):
        """Reads an exponent in what a sum runs over, if one is there."""
        if not self.locals:
            return None
        before = self.state()
        try:
            found = self.document.sequences.linear(self.number(self.signed()))
            if found and not found[0] and abs(found[1]) <= MAX_POWER:
                return found[1]
        except Unreadable:
            pass
        self.go_back(before)
        return None

    def local(self, name):
        """The value of a name that a sum runs over."""
        for place, (known, value) in reversed(list(enumerate(self.locals))):
            if known == name:
                if place < self.fixed:
                    self.fail("a term of a sum up to an index speaks of no outer one")
                return value
        return None

    def exponent_with_index(self):
        """Reads an exponent that speaks of an index, if one is there."""
        if not self.document.sequences.indices:
            return None
        before = self.at, self.start, self.kind, self.word
        try:
            exponent = self.number(self.signed())
            if not templates.found_in(exponent) and self.document.sequences.spoken([exponent]):
                return exponent
        except Unreadable:
            pass
        self.at, self.start, self.kind, self.word = before
        return None

    def exponent(self):
        """An integer: powers of literals associate to the right."""
        if self.take("-"):
            return -self.exponent()
        if self.take("("):
            value = self.exponent()
            self.expect(")")
        elif self.kind == "number" and self.literal().denominator == 1:
            value = int(self.literal())
            self.advance()
        else:
            self.fail("only literal integers may be exponents")
        if self.take("^"):
            power = self.exponent()
            if power < 0 or power > MAX_POWER:
                self.fail("the exponent is not an integer, or too large")
            value = value**power if abs(value) < 2 or power < 64 else MAX_POWER + 1
        if abs(value) > MAX_POWER:
            self.fail("the exponent is too large")
        return value

    def literal(self):
        """The value of a number."""
        mantissa, _, exponent = self.word.lower().partition("e")
        if len(mantissa) + abs(int(exponent or 0)) > MAX_DIGITS:
            self.fail("the number has too many digits")
        return Fraction(self.word)

    def atom(self):
        if self.kind == "number":
            value = self.literal()
            self.advance()
            return ("num", value.numerator, value.denominator)
        if self.take("("):
            inner = self.value()
            self.expect(")")
            return inner
        if self.take("|"):
            inner = self.value()
            self.expect("|")
            return arrays.applied("norm", [inner], self.fail) if isinstance(inner, Array) else ("abs", inner)
        if self.take("["):
            items = [self.value()]
            while self.take(","):
                items.append(self.value())
            self.expect("]")
            return arrays.literal(items, self.fail)
        if function := self.take("abs", "sqrt", "min", "max", "d"):
            return self.call(function)
        if self.take("cases"):
            return self.cases()
        if self.kind == "name" and self.word in ("sin", "cos", "tan") and self.is_free(self.word):
            return self.direction(self.take("sin", "cos", "tan"))
        if self.kind == "name" and self.word in ("exp", "log") and self.is_free(self.word):
            return self.exponential(self.take("exp", "log"))
        if self.in_angle and self.kind == "name" and self.word == "pi":
            self.advance()
            return ("pi", 1)
        if self.kind == "name" and self.word in arrays.FUNCTIONS and self.is_free(self.word):
            return self.function(self.take(*arrays.FUNCTIONS))
        if self.kind == "name" and self.word == "pow" and self.is_free("pow"):
            return self.power()
        if self.kind == "name" and self.word in ("sum", "prod") and self.is_free(self.word):
            return sums.read(self)
        name = self.name()
        value = self.local(name)
        if value:
            return value
        if name in self.bound:
            if self.recursion:
                self.expect("(")
                if self.sum() != ("sym", self.recursion):
                    self.fail("a step leads from the term at the index")
                self.expect(")")
            return ("par", self.bound.index(name))
        if name in self.document.sequences.terms:
            self.expect("(")
            argument = self.sum()
            self.expect(")")
            return self.document.sequences.term(name, argument, self.fail)
        if name in self.document.templates:
            return self.application(self.document.templates[name])
        if name in self.document.arrays:
            return self.document.arrays[name]
        return self.document.use(name, self)

    def is_free(self, name):
        known = self.document
        taken = (known.symbols, known.arrays, known.templates, known.sequences.terms)
        return not any(name in names for names in taken)

    def power(self):
        """Reads `pow(b, n)`."""
        self.advance()
        self.expect("(")
        base = self.sum()
        self.expect(",")
        exponent = self.sum()
        self.expect(")")
        if not self.document.sequences.spoken([exponent]):
            self.fail("this is no exponent with an index")
        return self.document.sequences.power(base, exponent, self.fail)

    def function(self, function):
        """Reads the arguments of `dot` and the like."""
        self.expect("(")
        arguments = [self.value()]
        if arrays.FUNCTIONS[function] == 2:
            self.expect(",")
            arguments.append(self.value())
        self.expect(")")
        return arrays.applied(function, arguments, self.fail)

    def application(self, template):
        """Reads the arguments of a definition."""
        arguments = []
        if self.take("("):
            arguments.append(self.sum())
            while self.take(","):
                arguments.append(self.sum())
            self.expect(")")
        return template.of(arguments, self.fail)

    def no_parameters(self, expression):
        if templates.found_in(expression):
            self.fail("an argument cannot stand here")

    def angle(self):
        """Reads a sum in which angles and pi may stand."""
        outer, self.in_angle = self.in_angle, True
        expression = self.sum()
        self.in_angle = outer
        self.no_parameters(expression)
        return angles.summed(expression)

    def direction(self, function):
        self.expect("(")
        total = self.angle()
        if total is None:
            self.fail("this is no angle")
        self.expect(")")
        cos, sin = angles.direction(total, self.document, self.fail)
        return {"cos": cos, "sin": sin}.get(function) or ("div", sin, cos)

    def exponential(self, function):
        """Reads the argument of an exponential or a logarithm."""
        self.expect("(")
        argument = self.sum()
        self.no_parameters(argument)
        self.expect(")")
        if function == "exp":
            return exponentials.exponential(argument, self.document, self.fail)
        return exponentials.logarithm(argument, self.document, self.fail)

    def call(self, function):
        self.expect("(")
        outer, self.in_angle = self.in_angle, self.in_angle or function == "d"
        first = self.value() if function == "d" else self.sum()
        self.in_angle = outer
        if function in ("abs", "sqrt"):
            self.expect(")")
            return (function, first)
        self.expect(",")
        if function == "d":
            return self.derivative(first)
        second = self.sum()
        self.expect(")")
        return (function, first, second)

    def derivative(self, f):
        """Reads the variable of a derivative."""
        if self.word in ("cos", "sin", "d"):
            by = self.sum()
            if by[0] != "sym":
                self.fail("nothing can be differentiated by this")
            name = by[1]
        else:
            name = self.name()
        self.expect(")")
        return f.each(lambda part: self.slope(part, name)) if isinstance(f, Array) else self.slope(f, name)

    def slope(self, f, name):
        """The derivative of a number."""
        if has_pi(f):
            self.fail("`pi` stands in sines alone")
        self.no_parameters(f)
        symbol = self.document.symbols.get(name)
        if not symbol or symbol.body:
            self.fail(f"nothing can be differentiated by `{name}`")
        names = self.document.mentioned(f)
        functions = any(self.document.symbols[other].argument == name for other in names)
        if functions and not symbol.argument:
            return motion.rate(f, name, self.document, self.fail)
        for other in names:
            self.document.measured(other)
        if symbol.parts:
            return angles.slope(f, symbol, names)
        if exponentials.holding(name, self.document):
            return exponentials.by_factor(f, name, names, self.document)
        return ("d", f, name)

    def cases(self):
        self.expect("{")
        branches, last = [], None
        while not self.take("}"):
            if self.take("else"):
                self.expect(":")
                last = self.sum()
                self.take(";")
                self.expect("}")
                break
            guard = self.relations()
            self.expect(":")
            branches.append((guard, self.sum()))
            if not self.take(";"):
                self.expect("}")
                break
        if not branches and last is None:
            self.fail("`cases` without a case")
        return ("cases", tuple(branches), last)

    def chain(self, left=None):
        """Reads `a < b <= c` as a list of relations."""
        left = left or self.value()
        found = ()
        while relation := self.take(*RELATIONS):
            right = self.value()
            found += arrays.compared(relation, left, right, self.fail)
            left = right
        if not found:
            self.fail("expected a relation")
        return found

    def relations(self):
        """Reads relations and chains with commas between them."""
        found = logic.formula(self)
        while self.take(","):
            found += logic.formula(self)
        return found


def parts(expression):
    """The expressions directly inside one."""
    if expression[0] == "cases":
        for guard, body in expression[1]:
            for _, left, right in guard:
                yield left
                yield right
            yield body
        if expression[2] is not None:
            yield expression[2]
    else:
        for part in expression[1:]:
            if isinstance(part, tuple):
                yield part


def has_pi(expression):
    """Does `pi` stand in it by itself?"""
    return expression[0] == "pi" or any(map(has_pi, parts(expression)))


def symbols_in(expression, found):
    """Adds the names of the symbols and definitions in it, as it is written."""
    if expression[0] in ("sym", "def"):
        found.add(expression[1])
    elif expression[0] == "d":
        found.add(expression[2])
    for part in parts(expression):
        symbols_in(part, found)
