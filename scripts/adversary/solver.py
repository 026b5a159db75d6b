"""Asks z3 whether the premises of a claim and its failure have a common point.

The question is written from the statement: a quotient or a root is a fresh number with a side
condition, and beside each term stands the condition under which it is defined. Derivatives and limits
are not asked about.
"""

import shutil
import subprocess

MILLISECONDS = 400


class NotAsked(Exception):
    """The statement is not of a kind that is put to the solver."""


class Encoder:
    """Terms and definedness of expressions; collects declarations and side conditions."""

    def __init__(self, document):
        self.document, self.lines, self.fresh, self.memo = document, [], 0, {}
        for i, v in enumerate(document.vars):
            self.lines.append(f"(declare-const v{i} Real)")
        self.names = {v.name: f"v{i}" for i, v in enumerate(document.vars)}
        for v in document.vars:
            for bound, weak, strict in ((v.lower, ">=", ">"), (v.upper, "<=", "<")):
                if bound:
                    self.lines.append(f"(assert ({strict if bound[1] else weak} {self.names[v.name]} {rational(bound[0])}))")

    def new(self):
        self.fresh += 1
        name = f"t{self.fresh}"
        self.lines.append(f"(declare-const {name} Real)")
        return name

    def term(self, e):
        """(term, condition of being defined); equal expressions share their fresh numbers."""
        if e not in self.memo:
            self.memo[e] = self._term(e)
        return self.memo[e]

    def _term(self, e):
        kind = e[0]
        if kind == "n":
            return rational(e[1]), "true"
        if kind == "v":
            if e[1] in self.document.lets:
                return self.term(self.document.lets[e[1]])
            return self.names[e[1]], "true"
        if kind == "d":
            raise NotAsked
        if kind == "cases":
            return self.cases(e)
        a, da = self.term(e[1])
        if kind == "neg":
            return f"(- {a})", da
        if kind == "^":
            n = e[2]
            p = "(* " + " ".join([a] * abs(n)) + ")" if abs(n) > 1 else a if n else "1.0"
            return (p, da) if n >= 0 else self.quotient("1.0", p, both(da, f"(not (= {p} 0.0))"))
        if kind == "abs":
            return f"(ite (>= {a} 0.0) {a} (- {a}))", da
        if kind == "sqrt":
            r = self.new()
            self.lines.append(f"(assert (=> (>= {a} 0.0) (and (>= {r} 0.0) (= (* {r} {r}) {a}))))")
            return r, both(da, f"(>= {a} 0.0)")
        b, db = self.term(e[2])
        d = both(da, db)
        if kind == "/":
            return self.quotient(a, b, both(d, f"(not (= {b} 0.0))"))
        if kind in "+-*":
            return f"({kind} {a} {b})", d
        return f"(ite ({'<=' if kind == 'min' else '>='} {a} {b}) {a} {b})", d

    def quotient(self, a, b, defined):
        q = self.new()
        self.lines.append(f"(assert (=> (not (= {b} 0.0)) (= (* {q} {b}) {a})))")
        return q, defined

    def cases(self, e):
        """Guards are read in turn; one that is read has to be defined."""
        value, defined = ("0.0", "false") if e[2] is None else self.term(e[2])
        for guard, branch in reversed(e[1]):
            v, d = self.term(branch)
            truth, sound = self.in_turn(guard)
            value = f"(ite {truth} {v} {value})"
            defined = f"(and {sound} (ite {truth} {d} {defined}))"
        return value, defined

    def in_turn(self, relations):
        """(all hold, all that are read are defined), from left to right."""
        truth, sound = "true", "true"
        for r in reversed(relations):
            holds, d = self.relation(r)
            truth = f"(and {d} {holds} {truth})"
            sound = f"(and {d} (=> {holds} {sound}))"
        return truth, sound

    def relation(self, r):
        op, x, y = r
        (a, da), (b, db) = self.term(x), self.term(y)
        return (f"(not (= {a} {b}))" if op == "!=" else f"({op} {a} {b})"), both(da, db)

    def true(self, r):
        holds, d = self.relation(r)
        return both(d, holds)

    def statement(self, s):
        """As it enters among premises: a given is true, a claim only where it is defined."""
        if s.shape != "links":
            return "true"
        if s.limit():
            raise NotAsked
        if s.kind == "given":
            body = conjunction([self.true(r) for r in s.links])
        else:
            parts = [self.relation(r) for r in s.links]
            body = f"(=> {conjunction([d for _, d in parts])} {conjunction([h for h, _ in parts])})"
            if len(parts) > 1:
                body = conjunction([f"(=> {d} {h})" for h, d in parts])
        return f"(=> {self.in_turn(s.when)[0]} {body})" if s.when else body

    def question(self, claim, i, verdict):
        """The claim's premises, and the failure of its link unless the premises alone are in question."""
        for label in claim.cites:
            self.lines.append(f"(assert {self.statement(self.document.find(label))})")
        if claim.when:
            self.lines.append(f"(assert {self.in_turn(claim.when)[0]})")
        if claim.shape == "links" and verdict != "vacuous":
            self.lines.append(f"(assert (not {self.true(claim.links[i])}))")
        return "\n".join(self.lines)


def both(a, b):
    return b if a == "true" else a if b == "true" else f"(and {a} {b})"


def conjunction(parts):
    parts = [p for p in parts if p != "true"]
    return "true" if not parts else parts[0] if len(parts) == 1 else "(and " + " ".join(parts) + ")"


def rational(v):
    n = f"{abs(v.numerator)}.0"
    out = n if v.denominator == 1 else f"(/ {n} {v.denominator}.0)"
    return f"(- {out})" if v < 0 else out


def available():
    return shutil.which("z3") is not None


def question(document, claim, i, verdict):
    """The text of a question, or None if it is not one for the solver."""
    if claim.shape == "not implied" or claim.limit() or verdict not in ("proved", "vacuous"):
        return None
    try:
        text = Encoder(document).question(claim, i, verdict)
    except NotAsked:
        return None
    return text if len(text) < 20000 else None


def ask(questions):
    """'sat', 'unsat' or 'unknown' for each, from one run of the solver."""
    parts = []
    for q in questions:
        parts += [f"(set-option :timeout {MILLISECONDS})", q, "(check-sat)", '(echo "next")', "(reset)"]
    try:
        out = subprocess.run(["z3", "-in"], input="\n".join(parts), capture_output=True, text=True, timeout=10 + len(questions) * (MILLISECONDS / 1000 + 1)).stdout
    except subprocess.TimeoutExpired:
        return ["unknown"] * len(questions)
    answers = [chunk.strip() for chunk in out.split("next")][: len(questions)]
    answers += ["unknown"] * (len(questions) - len(answers))
    return answers
