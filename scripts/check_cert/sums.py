"""Sums and products over a range (the language, "Sums and products").

Between numbers they are written out. Up to an index they are a sequence by its first value and its step.
"""

from . import templates
from .sequences import MAX_INDEX


class Met(Exception):
    """A sum up to an index without a symbol; the document is read again with one."""

    def __init__(self, name):
        super().__init__(name)
        self.name = name


def joined(product, value, term):
    return ("mul" if product else "add", value, term)


def total(product, terms):
    whole = None
    for term in terms:
        whole = term if whole is None else joined(product, whole, term)
    return whole or ("num", int(product), 1)


def number(n):
    return ("num", n, 1)


class Sum:
    """`sum(f for k in a..b)` where it stands; the reader is behind it."""

    def __init__(self, reader):
        self.reader, self.known = reader, reader.document.sequences
        self.product = reader.word == "prod"
        reader.advance()
        reader.expect("(")
        self.start = reader.state()
        self.text, self.behind = self.pass_term()
        reader.advance()
        self.over = reader.name()
        taken = [*reader.bound, *(name for name, _ in reader.locals)]
        if self.over in taken or not reader.is_free(self.over):
            reader.fail("what a sum runs over has a name of its own")
        reader.expect("in")
        low, self.high = self.end_of_range(), None
        reader.expect("..")
        self.high = self.end_of_range()
        reader.expect(")")
        times = self.high[0]
        if low[0] or len(times) > 1 or any(n != 1 for n in times.values()):
            reader.fail("a range goes from a whole number to one, or to an index")
        self.low = low[1]
        self.end = reader.state()

    def pass_term(self):
        """The text of the term with single blanks, and where its `for` stands."""
        reader, depth, text, last = self.reader, 0, "", None
        while not (depth == 0 and reader.kind == "name" and reader.word == "for"):
            if reader.kind == "end" or (depth == 0 and reader.word in (")", "]", "}")):
                reader.fail("a sum runs over a range")
            depth += (reader.word in ("(", "[", "{")) - (reader.word in (")", "]", "}"))
            text += " " if last is not None and reader.start > last else ""
            text, last = text + reader.word, reader.at
            reader.advance()
        return text, reader.start

    def end_of_range(self):
        return self.known.linear(self.reader.sum()) or self.reader.fail("this is no end of a range")

    def term(self, value):
        """The term with a value for what the sum runs over."""
        reader = self.reader
        reader.go_back(self.start)
        reader.locals.append((self.over, value))
        term = reader.sum()
        reader.locals.pop()
        if reader.start != self.behind:
            reader.fail("an operator is missing before `for`")
        reader.go_back(self.end)
        return term

    def terms(self, high):
        return [self.term(number(k)) for k in range(self.low, high + 1)]

    def value(self):
        times, plus = self.high
        if times:
            return self.up_to_index()
        if plus - self.low >= MAX_INDEX:
            self.reader.fail("the sum is too long to be written out")
        if plus < self.low:
            self.term(number(self.low))
        return total(self.product, self.terms(plus))

    def sequence(self):
        """What it is as a sequence, the name of its symbol, and how many steps beyond the index are meant."""
        reader, known = self.reader, self.known
        (index,), plus = self.high[0], self.high[1]
        end = max(self.low - 1, 0)
        if plus < end or abs(self.low) > MAX_INDEX:
            reader.fail("the range begins too high")
        outer = reader.fixed, reader.in_term
        reader.fixed, reader.in_term = len(reader.locals), True
        term = self.term(("add", ("sym", index), number(end + 1)))
        alone, first = self.term(number(self.low)), total(self.product, self.terms(end))
        reader.fixed, reader.in_term = outer
        if any(map(templates.found_in, (term, alone))):
            reader.fail("an argument cannot stand here")
        if not (known.is_total(term, index) and known.is_total(alone, None) and known.is_total(first, None)):
            reader.fail("a term may have no value somewhere")
        upper = f"{index} + {end}" if end else index
        name = f"{'prod' if self.product else 'sum'}({self.text} for {self.over} in {self.low}..{upper})"
        return (self.product, index, first, term), name, plus - end

    def up_to_index(self):
        key, name, further = self.sequence()
        if key not in self.known.sums:
            raise Met(name)
        e = ("sym", self.known.sums[key])
        if further > MAX_INDEX:
            self.reader.fail("this comes to too much")
        for _ in range(further):
            e = self.known.further(e, key[1])
        return e


def read(reader):
    return Sum(reader).value()


def declare(document):
    """The symbols of the sums up to an index that stand in the next statement for the first time."""
    from .expressions import Reader  # which reads sums itself

    known = document.sequences
    for name, count in document.sums:
        if count != document.count:
            continue
        reader = Reader(name, document)
        key, _, _ = Sum(reader).sequence()
        if key in known.sums:
            continue
        product, index, first, term = key
        document.declare_name(name)
        known.steps[name] = (first, joined(product, ("sym", name), term), index)
        known.sums[key] = name
