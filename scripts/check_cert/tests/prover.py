"""A small prover, so that the checker has certificates to check.

It finds proofs that need products of two conditions at most, by linear
programming in exact arithmetic, and witnesses with small rational values.
"""

import hashlib
from fractions import Fraction
from itertools import combinations_with_replacement, product
from math import isqrt, lcm

from check_cert.document import Document
from check_cert.errors import Rejected
from check_cert.expressions import parts
from check_cert.goal import Goal, rests_on
from check_cert.polynomial import ONE, holds, multiply
from check_cert.proof import Proof

VALUES = [Fraction(n, d) for n, d in
          ((0, 1), (1, 1), (-1, 1), (2, 1), (-2, 1), (3, 1), (1, 2), (-3, 1), (7, 1), (4, 1))]


def write(goal, p):
    """A polynomial as it stands in a file."""
    terms = [(sorted(goal.ring.exponents(m)), value) for m, value in p.items()]
    return [[str(value), dict(order)] for order, value in sorted(terms)]


def feasible(columns, free, strict):
    """Weights with Σ weight·column = 0, Σ of strict ones = 1; those of `free` have no sign."""
    rows = sorted({m for column in columns for m in column})
    place = {m: i for i, m in enumerate(rows)}
    table = [[Fraction(0)] * 0 for _ in range(len(rows) + 1)]
    owners = []
    for number, column in enumerate(columns):
        for sign in (1, -1) if number in free else (1,):
            entries = [Fraction(0)] * (len(rows) + 1)
            for m, value in column.items():
                entries[place[m]] = Fraction(sign * value)
            entries[-1] = Fraction(number in strict)
            for row, entry in zip(table, entries):
                row.append(entry)
            owners.append((number, sign))
    height, width = len(table), len(owners)
    right = [Fraction(0)] * (height - 1) + [Fraction(1)]
    basis = [None] * height
    cost = [sum(row[j] for row in table) for j in range(width)]
    missing = Fraction(1)
    for _ in range(4000):
        enter = next((j for j in range(width) if cost[j] > 0), None)
        if enter is None:
            break
        rows_in = [i for i in range(height) if table[i][enter] > 0]
        leave = min(rows_in, key=lambda i: (right[i] / table[i][enter], -1 if basis[i] is None else basis[i]))
        pivot = table[leave][enter]
        table[leave] = [a / pivot for a in table[leave]]
        right[leave] /= pivot
        for i in range(height):
            factor = table[i][enter]
            if i != leave and factor:
                table[i] = [a - factor * b for a, b in zip(table[i], table[leave])]
                right[i] -= factor * right[leave]
        factor = cost[enter]
        cost = [a - factor * b for a, b in zip(cost, table[leave])]
        missing -= factor * right[leave]
        basis[leave] = enter
    if missing:
        return None
    weights = [Fraction(0)] * len(columns)
    for i, j in enumerate(basis):
        if j is not None:
            number, sign = owners[j]
            weights[number] += sign * right[i]
    return weights


def leaf(goal, conditions, degree=2):
    """A sum that vanishes although it is positive."""
    signs = [(i, c) for i, c in enumerate(conditions) if c.sign in (">0", ">=0")]
    columns, meaning, strict, free = [dict(ONE)], [(ONE, [])], {0}, set()
    variables = sorted({n for c in conditions for n in goal.ring.variables(c.poly)})
    monomials = [goal.ring.variable(n) for n in variables]

    def add(p, square, factors, sure):
        if sure:
            strict.add(len(columns))
        columns.append(p)
        meaning.append((square, factors))

    for i, c in signs:
        add(c.poly, ONE, [[i, 1]], c.sign == ">0")
    for (i, c), (j, e) in combinations_with_replacement(signs, 2) if degree > 1 else ():
        factors = [[i, 2]] if i == j else [[i, 1], [j, 1]]
        add(multiply(c.poly, e.poly), ONE, factors, c.sign == e.sign == ">0")
    for i, c in enumerate(conditions):
        if c.sign == "!=0":
            add(multiply(c.poly, c.poly), ONE, [[i, 2]], True)
    for square in monomials + [c.poly for c in conditions]:
        add(multiply(square, square), square, [], False)
    for i, c in enumerate(conditions):
        if c.sign == "=0":
            others = [multiply(a, b) for a, b in combinations_with_replacement(monomials, 2)]
            extra = [e.poly for e in conditions if e is not c]
            more = [multiply(q, m) for q in extra for m in monomials]
            for factor in [ONE] + (monomials + others + extra + more if degree > 1 else []):
                free.add(len(columns))
                columns.append(multiply(factor, c.poly))
                meaning.append((i, factor))
    weights = feasible(columns, free, strict)
    if weights is None:
        return None
    common = lcm(*(w.denominator for w in weights))
    summands, cofactors = [], {}
    for number, weight in enumerate(weights):
        value = int(weight * common)
        if value and number in free:
            i, factor = meaning[number]
            total = cofactors.setdefault(i, {})
            for m, a in factor.items():
                total[m] = total.get(m, 0) + a * value
        elif value:
            square, factors = meaning[number]
            summands.append([str(value), write(goal, square), factors])
    written = [[i, write(goal, {m: a for m, a in p.items() if a})] for i, p in sorted(cofactors.items())]
    return {"positive": summands, "cofactors": written}


def prove(goal, conditions, formulas, splits=(), start=0):
    """A proof by assuming formulas in order, then splitting."""
    found = leaf(goal, conditions, 1 if start < len(formulas) else 2)
    if found:
        return found
    if start < len(formulas):
        cases = []
        for region in formulas[start]():
            part = prove(goal, [*conditions, *region], formulas, splits, start + 1)
            if part is None:
                return None
            cases.append(part)
        return {"assume": start, "cases": cases}
    for number, p in enumerate(splits):
        cases = []
        negated = {m: -a for m, a in p.items()}
        for opposite, sign in ((False, "=0"), (False, ">0"), (True, ">0")):
            part = goal.ring.condition(negated if opposite else p, sign)
            then = prove(goal, [*conditions, part], formulas, splits[number + 1:], start)
            if then is None:
                return None
            cases.append({"opposite": opposite, "is": sign, "then": then})
        return {"split": write(goal, p), "cases": cases}
    return None


def find_point(goal, state):
    """A point with small values that satisfies the state."""
    names = goal.mentioned
    for values in product(VALUES, repeat=len(names)):
        point = dict(zip(names, values))
        if settle_roots(goal, point) and satisfied(goal, state, point):
            return {"theta": None, "values": {n: [str(v)] if v else [] for n, v in point.items()}}
    return None


def settle_roots(goal, point):
    """Gives each root its value, where that is rational."""
    for radicand, name in sorted(goal.roots.items(), key=lambda item: len(write_text(item[0]))):
        point[name] = Fraction(0)
        for region, value in goal.pieces.pieces(radicand):
            if value and all(true(goal, c, point) for c in region):
                inside = evaluate(goal, value[0], point) / evaluate(goal, value[1], point)
                if inside >= 0:
                    top, bottom = isqrt(inside.numerator), isqrt(inside.denominator)
                    if top * top != inside.numerator or bottom * bottom != inside.denominator:
                        return False
                    point[name] = Fraction(top, bottom)
    return True


def write_text(e):
    """An expression as text, with all its parentheses."""
    kind = e[0]
    if kind == "num":
        return str(e[1]) if e[2] == 1 else f"({e[1]}/{e[2]})"
    if kind == "sym":
        return e[1]
    if kind == "cases":
        branches = "".join(
            ", ".join(f"{write_text(a)} {s} {write_text(b)}" for s, a, b in guard) + f": {write_text(body)}; "
            for guard, body in e[1]
        )
        return "cases { " + branches + (f"else: {write_text(e[2])} " if e[2] else "") + "}"
    if kind == "pow":
        return f"({write_text(e[1])})^{e[2]}"
    if kind == "d":
        return f"d({write_text(e[1])}, {e[2]})"
    if kind == "neg":
        return f"(-{write_text(e[1])})"
    inner = [write_text(part) for part in parts(e)]
    sign = {"add": "+", "sub": "-", "mul": "*", "div": "/"}.get(kind)
    return f"({inner[0]} {sign} {inner[1]})" if sign else f"{kind}({', '.join(inner)})"


def roots_of(document, claim, item):
    """The roots that a link of a claim mentions, as text."""
    found, seen = set(), set()
    statements = [*claim.cited, *([claim.other] if claim.other else [])]
    statements += rests_on(document, claim.cited)
    expressions = [e for s in statements for e in s.expressions()]
    for _, left, right in (*claim.when, *([item] if item else [])):
        expressions += [e for e in (left, right) if isinstance(e, tuple)]
    for e in expressions:
        document.roots(e, found, seen)
    return sorted((f"sqrt({write_text(r)})" for r in found), key=lambda text: (len(text), text))


def evaluate(goal, p, point):
    total = Fraction(0)
    for m, value in p.items():
        for name, n in goal.ring.exponents(m):
            value *= point[name] ** n
        total += value
    return total


def true(goal, condition, point):
    return holds(evaluate(goal, condition.poly, point), condition.sign)


def satisfied(goal, state, point):
    return all(true(goal, c, point) for c in state.conditions) and all(
        any(all(true(goal, c, point) for c in region) for region in formula())
        for formula in state.formulas
    )


def certify(text, splits=(), hints=None):
    """A certificate for a document, with what the small prover finds.

    `hints` maps (label, number of link) to a function from (document, claim,
    item) to a link of the file.
    """
    source = text.encode()
    document = Document(text)
    claims, verdicts = [], {}
    for claim in document.claims:
        links = []
        for number, item in enumerate(claim.items or [None]):
            if hints and (claim.label, number) in hints:
                links.append(hints[claim.label, number](document, claim, item))
            else:
                links.append(find_link(document, claim, item, splits))
        order = ("vacuous", "ill-defined", "refuted", None, "proved")
        found = [None if link["finding"] == "consistent" else link["finding"] for link in links]
        worst = min(found, key=order.index) or "undecided"
        if any(verdicts[s.label] != "proved" for s in claim.cited if s.kind == "claim"):
            worst = "unsupported"
        verdicts[claim.label] = worst
        claims.append({"label": claim.label, "verdict": worst, "links": links})
    return {
        "format": 1, "program": "tests", "document": "test.md",
        "sha256": hashlib.sha256(source).hexdigest(), "claims": claims,
    }


def find_link(document, claim, item, splits=()):
    """The evidence of one link, if the small prover finds it."""
    if item and item[0] == "->":
        return {"finding": None}
    search = ["vacuous", "ill-defined", "refuted", "proved"]
    if item is None:
        search = ["proved", "refuted"]
        if claim.form == "not implied" and claim.other.limits:
            search = ["proved"]
    roots = roots_of(document, claim, item)
    for finding in search:
        goal = Goal(document, claim, item, finding, "cited", roots)
        state = goal.state(finding)
        cuts = [goal.pieces.pieces(document.expression(s))[0][1][0] for s in splits]
        witness = (finding in ("ill-defined", "refuted")) != (claim.form == "not implied")
        if witness:
            point = None if goal.has_limits else find_point(goal, state)
            evidence = point and {"point": point}
        else:
            proof = prove(goal, state.conditions, state.formulas, cuts)
            evidence = proof and {"proof": proof}
        if evidence:
            return {"finding": finding, "premises": "cited", "roots": roots, "evidence": evidence}
    return {"finding": None}
