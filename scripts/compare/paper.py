#!/usr/bin/env python3
"""The equalities and the limits of an audited document, checked by SymPy alone.

    kane audit --format json > paper.json
    scripts/compare/paper.py paper.json

The claims are those of the report, so that the two cannot drift apart. For each link that is an
equality or a limit: solve the cited equations one after the other for a symbol that they hold
linearly, substitute, and ask SymPy whether the difference simplifies to 0, or what the limit is.
That is less than an audit: inequalities, definedness, division by what may be 0, and whether the
premises can hold are not looked at, and nothing is checked twice. Where it settles a link it must
agree with the verdict of the report; the exit code is 1 where it does not.
"""

import json
import re
import sys

import sympy
from sympy.parsing.sympy_parser import parse_expr, rationalize, standard_transformations

READ = {"abs": sympy.Abs, "sqrt": sympy.sqrt, "min": sympy.Min, "max": sympy.Max, "oo": sympy.oo, "d": sympy.diff}
RELATION = re.compile(r"(<=|>=|!=|(?<!:)=|<|>)")


def split(text, at):
    """Parts at a separator outside of every bracket."""
    parts, depth, start = [], 0, 0
    for i, letter in enumerate(text):
        depth += (letter in "([{") - (letter in ")]}")
        if letter == at and depth == 0:
            parts.append(text[start:i])
            start = i + 1
    return [part.strip() for part in [*parts, text[start:]] if part.strip()]


class Document:
    def __init__(self, document):
        self.names, self.lets, self.bodies = {}, {}, {}
        for statement in document["statements"]:
            body = statement["source"].split("#")[0]
            kind, rest = body.split(None, 1)
            if kind == "let":
                name, value = rest.split(":=")
                self.lets[self.name(name.strip())] = self.expression(value)
            else:
                self.bodies[statement["label"]] = " ".join(rest.split(":", 1)[1].split())

    def name(self, text):
        """A symbol of SymPy's; primes and the names of its own functions are no names there."""
        text = text.replace("'", "_prime")
        return self.names.setdefault(text, sympy.Symbol(text))

    def expression(self, text):
        text = text.strip()
        if text.startswith("cases"):
            branches = split(text[text.index("{") + 1 : text.rindex("}")], ";")
            pairs = []
            for branch in branches:
                guard, value = branch.split(":", 1)
                guards = [] if guard.strip() == "else" else split(guard, ",")
                pairs.append((self.expression(value), sympy.And(*map(self.relation, guards))))
            return sympy.Piecewise(*pairs)
        text = text.replace("^", "**").replace("'", "_prime")
        local = {word: self.name(word) for word in re.findall(r"[A-Za-z_]\w*", text) if word not in READ}
        return parse_expr(text, {**local, **READ}, (*standard_transformations, rationalize))

    def relation(self, text):
        lhs, how, rhs = RELATION.split(text)
        lhs, rhs = self.expression(lhs), self.expression(rhs)
        return {"<": sympy.Lt, "<=": sympy.Le, ">": sympy.Gt, ">=": sympy.Ge, "=": sympy.Eq, "!=": sympy.Ne}[how](lhs, rhs)

    def content(self, label):
        """What a statement says: its links, its `when`, and what it cites."""
        body = re.split(r"\s(?:by|expect)\s", " " + self.bodies[label] + " ")[0]
        body, *cited = re.split(r"\sfrom\s", body)
        body, *when = re.split(r"\swhen\s", body)
        return body.strip(), when[0] if when else "", split(cited[0], ",") if cited else []

    def equations(self, text):
        """The equations of a chain of relations."""
        found = []
        for part in split(text, ","):
            pieces = RELATION.split(part)
            if "->" in part or "cases" in part or len(pieces) < 3:
                continue
            for lhs, how, rhs in zip(pieces[::2], pieces[1::2], pieces[2::2]):
                if how == "=":
                    found.append(self.expand(self.expression(lhs) - self.expression(rhs)))
        return found

    def expand(self, expression):
        for _ in self.lets:
            expression = expression.subs(self.lets)
        return expression.doit()

    def solved(self, equations, kept):
        """Substitutions out of equations, each solved for a symbol that it holds linearly.

        Factors that are a symbol alone are taken to be no zero, as sizes are in the paper.
        """
        values = {}
        for equation in equations:
            factors = sympy.factor_list(sympy.numer(sympy.together(equation.subs(values))))[1]
            numerator = sympy.Mul(*(factor for factor, _ in factors if not factor.is_Symbol or len(factors) == 1))
            # a symbol that the equation is solved for as printed comes first
            symbols = sorted(numerator.free_symbols - kept, key=lambda s: (s not in equation.args, str(s)))
            for symbol in symbols:
                if sympy.degree(numerator, symbol) == 1:
                    slope = sympy.diff(numerator, symbol)
                    value = sympy.cancel(symbol - numerator / slope)
                    values = {s: sympy.cancel(v.subs(symbol, value)) for s, v in values.items()}
                    values[symbol] = value
                    break
        return values

    def premises(self, label):
        _, when, cited = self.content(label)
        equations = self.equations(when)
        for premise in cited:
            if premise in self.bodies:
                body, condition, _ = self.content(premise)
                equations += [] if self.equations(condition) else self.equations(body)
        return equations

    def equality(self, label, text):
        lhs, rhs = map(self.expression, re.split(r"(?<![:<>!])=", text))
        difference = self.expand(lhs - rhs)
        values = self.solved(self.premises(label), set())
        return sympy.simplify(difference.subs(values)) == 0

    def limit(self, label, text):
        expression, rest = text.split("->", 1)
        to, rest = rest.split(" as ")
        variable, at = rest.split("->")
        at = at.strip()
        side = {"+": "+", "-": "-"}.get(at[-1], "+")
        at = self.expression(at.rstrip("+-") or at)
        variable, to = self.expression(variable), self.expression(to)
        values = self.solved(self.premises(label), {variable})
        expression = self.expand(self.expression(expression)).subs(values)
        # sizes in the paper are positive
        positive = {s: sympy.Symbol(s.name, positive=True) for s in expression.free_symbols - {variable}}
        found = sympy.limit(expression.subs(positive), variable, at, side)
        if found.free_symbols & {positive.get(self.name(name)) for name in ("k", "i_x")}:
            return None
        return sympy.simplify(found - to.subs(positive)) == 0 if to.is_finite is not False else found == to


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        (audited,) = json.load(file)["documents"]
    document = Document(audited)
    counts = {"equal": 0, "different": 0, "not settled": 0, "disagrees": 0}
    for statement in audited["statements"]:
        for link in statement["links"]:
            text, verdict = link["text"], link["verdict"]
            relations = RELATION.split(re.sub(r"cases\s*\{.*?\}", "0", text.replace("->", "")))
            if "->" in text and "not implied" not in text:
                settle = document.limit
            elif relations[1::2] == ["="]:
                settle = document.equality
            else:
                continue
            try:
                holds = settle(statement["label"], text)
            except (NotImplementedError, ValueError, TypeError, SyntaxError, AttributeError, sympy.PolynomialError) as error:
                holds = None
                if "-v" in sys.argv:
                    print("  ", statement["label"], type(error).__name__, error)
            if holds is None:
                counts["not settled"] += 1
            elif holds == (verdict == "proved"):
                counts["equal" if holds else "different"] += 1
            elif holds:
                counts["disagrees"] += 1
                print(f"disagrees: {statement['label']}: {text}: {verdict}, but equal for SymPy")
            else:
                counts["not settled"] += 1  # a difference that substitution does not close says nothing
            if "-v" in sys.argv:
                print(statement["label"], "|", text, "|", verdict, "|", holds)
    print(", ".join(f"{count} {name}" for name, count in counts.items()))
    sys.exit(1 if counts["disagrees"] else 0)


if __name__ == "__main__":
    main()
