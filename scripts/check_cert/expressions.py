"""Words and expressions of the language.

An expression is a tuple, so two that are written alike are equal:
("num", n, d), ("sym", name), ("def", name), ("neg", a), ("add"|"sub"|"mul"|
"div"|"min"|"max", a, b), ("pow", a, n), ("abs"|"sqrt", a), ("d", f, x) and
("cases", ((relations, body), ...), last or None).
"""

import re
from fractions import Fraction

from .errors import Unreadable

RESERVED = set(
    "oo d abs min max sqrt cases else from when as using by expect not implied contradiction".split()
)
GREEK = dict(zip(
    "αβγδεζηθικλμνξοπρσςτυφχψωΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩϵϕϑϱ",
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho"
    " sigma sigma tau upsilon phi chi psi omega Alpha Beta Gamma Delta Epsilon Zeta Eta Theta"
    " Iota Kappa Lambda Mu Nu Xi Omicron Pi Rho Sigma Tau Upsilon Phi Chi Psi Omega"
    " epsilon phi theta rho".split(),
))
GREEK["µ"] = "mu"  # the micro sign
PLAIN = str.maketrans({"−": "-", "·": "*", "∞": "oo"})
SPACE = re.compile(r"(?:[ \t\n]|#[^\n]*)*")
LETTER = "A-Za-z" + "".join(GREEK)
WORD = re.compile(
    rf"(?P<number>[0-9]+(?:\.[0-9]+)?)|(?P<name>[{LETTER}][{LETTER}0-9_']*)|(?P<infinity>∞)"
    r"|(?P<sign>:=|<=|>=|!=|->|[≤≥≠→−·]|[-+*/^=<>(){},;:])"
)
LABEL = re.compile(r"\(([^()\n]*)\)|([\w.'-]+)")
SIGNS = {"≤": "<=", "≥": ">=", "≠": "!=", "→": "->", "−": "-", "·": "*"}
RELATIONS = ("=", "!=", "<", "<=", ">", ">=")
MAX_POWER = 2**15 - 1


def spelled(name):
    """A name with its Greek letters spelled out."""
    return "".join(GREEK.get(letter, letter) for letter in name)


class Reader:
    """Reads one statement, or one expression, from its text."""

    def __init__(self, text, document):
        self.text, self.document = text, document
        self.at = 0
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
        elif re.match(rf"[{LETTER}0-9_.]", self.text[self.at:self.at + 1] or " "):
            self.kind = "malformed"  # unless it is the beginning of a label

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
        if not label or match[2] in RESERVED:
            self.fail("expected a label")
        self.at = match.end()
        self.advance()
        return label

    def done(self):
        """Nothing may be left."""
        if self.kind != "end":
            self.fail("an operator or the end of the statement is missing")

    def sum(self):
        """Reads an expression. A minus in front of a product is one of the whole product."""
        left = ("neg", self.product()) if self.take("-") else self.product()
        while sign := self.take("+", "-"):
            left = ("add" if sign == "+" else "sub", left, self.product())
        return left

    def product(self):
        left = self.signed()
        while sign := self.take("*", "/"):
            left = ("mul" if sign == "*" else "div", left, self.signed())
        return left

    def signed(self):
        if self.take("-"):
            return ("neg", self.signed())
        base = self.atom()
        return ("pow", base, self.exponent()) if self.take("^") else base

    def exponent(self):
        """An integer: powers of literals associate to the right."""
        if self.take("-"):
            return -self.exponent()
        if self.take("("):
            value = self.exponent()
            self.expect(")")
        elif self.kind == "number" and "." not in self.word:
            value = int(self.word)
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

    def atom(self):
        if self.kind == "number":
            value = Fraction(self.word)
            self.advance()
            return ("num", value.numerator, value.denominator)
        if self.take("("):
            inner = self.sum()
            self.expect(")")
            return inner
        if function := self.take("abs", "sqrt", "min", "max", "d"):
            return self.call(function)
        if self.take("cases"):
            return self.cases()
        return self.document.use(self.name(), self)

    def call(self, function):
        self.expect("(")
        first = self.sum()
        if function in ("abs", "sqrt"):
            self.expect(")")
            return (function, first)
        self.expect(",")
        if function == "d":
            name = self.name()
            if not self.document.is_plain(name):
                self.fail(f"nothing can be differentiated by `{name}`")
            second = name
        else:
            second = self.sum()
        self.expect(")")
        return (function, first, second)

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
        left = left or self.sum()
        found = []
        while relation := self.take(*RELATIONS):
            right = self.sum()
            found.append((relation, left, right))
            left = right
        if not found:
            self.fail("expected a relation")
        return tuple(found)

    def relations(self):
        """Reads relations and chains with commas between them."""
        found = self.chain()
        while self.take(","):
            found += self.chain()
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


def symbols_in(expression, found):
    """Adds the names of the symbols and definitions in it, as it is written."""
    if expression[0] in ("sym", "def"):
        found.add(expression[1])
    elif expression[0] == "d":
        found.add(expression[2])
    for part in parts(expression):
        symbols_in(part, found)
