#!/usr/bin/env python3
"""Random claims on logic, definitions with arguments, vectors and matrices, judged by plain evaluation.

What is written is evaluated as the page says it is meant: vectors as lists, determinants as sums over permutations,
inverses by elimination, arguments before the body, formulas with three values of truth. Nothing is put in for
anything, and nothing is written out in components but the results. A verdict is wrong if a point speaks against it:

- `proved`, and at a point all premises hold and a link is false or undefined;
- `vacuous`, or a contradiction proved, and at a point all premises hold;
- `refuted` or `ill-defined`, and at the point that the report names a premise fails, or the link is no such thing;
- `refuted` or `ill-defined` of what `exists` says.

    python3 scripts/adversary/lowered.py KANE [COUNT [SEED]] [--certificates]
"""

import random
import sys
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import witness  # noqa: E402
from algebraic import Alg, Costly  # noqa: E402
from meaning import Scene, all_of, formula, links, number, text  # noqa: E402
from reader import Unreadable  # noqa: E402
from trial import Trial  # noqa: E402

GRID = [Fraction(n) for n in (0, 1, -1, 2, -2, 3)] + [Fraction(1, 2), Fraction(-1, 2)]
CLAIMS, POINTS = 8, 150


class Maker:
    def __init__(self, rng, scene):
        self.rng, self.s = rng, scene
        self.parameters = []

    def constant(self):
        return ("n", self.rng.choice([0, 1, 1, 2, -1, 3, Fraction(1, 2)]) + Fraction(0))

    def number(self, depth):
        rng, s = self.rng, self.s
        if depth <= 0 or rng.random() < 0.2:
            names = self.parameters * 3 or s.scalars
            known = [("s", rng.choice(names)), self.constant(), ("s", rng.choice(names))]
            if s.lets and not self.parameters:
                known.append(("s", rng.choice(list(s.lets))))
            if s.size:
                known.append(("part", ("vec", rng.choice(s.vectors + list(s.vlets))), rng.randrange(s.size)))
            return rng.choice(known)
        kinds = ["+", "-", "*", "*", "/", "^", "neg", "abs", "cases"] + ["call"] * 3 * bool(s.functions)
        kinds += (["dot", "norm2", "norm", "det"] + ["cross2"] * (s.size == 2)) * bool(s.size)
        kind = rng.choice(kinds)
        if kind in "+-*/":
            return (kind, self.number(depth - 1), self.number(depth - 1))
        if kind == "^":
            return (kind, self.number(depth - 1), rng.choice([2, 2, 3, 0, -1]))
        if kind in ("neg", "abs"):
            return (kind, self.number(depth - 1))
        if kind == "cases":
            guards = [self.formula(depth - 2) for _ in range(rng.choice([1, 1, 2]))]
            last = self.number(depth - 1) if rng.random() < 0.8 else None
            return (kind, [(guards, self.number(depth - 1))], last)
        if kind == "call":
            name = rng.choice(list(s.functions))
            return (kind, name, [self.number(depth - 1) for _ in s.functions[name][0]])
        if kind == "det":
            return (kind, self.matrix(depth - 2))
        if kind in ("norm", "norm2"):
            return (kind, self.vector(depth - 2))
        return (kind, self.vector(depth - 2), self.vector(depth - 2))

    def vector(self, depth):
        rng, s = self.rng, self.s
        if depth <= 0 or rng.random() < 0.2:
            if rng.random() < 0.7:
                return ("vec", rng.choice(s.vectors + list(s.vlets)))
            return ("lit", [self.number(0) for _ in range(s.size)])
        kind = rng.choice(["v+", "v-", "vneg", "scale", "over", "mv", "lit", "turn" if s.size == 2 else "cross3"])
        if kind == "lit":
            return (kind, [self.number(depth - 1) for _ in range(s.size)])
        if kind == "vneg":
            return (kind, self.vector(depth - 1))
        if kind == "mv":
            return (kind, self.matrix(depth - 1), self.vector(depth - 1))
        if kind in ("scale", "over", "turn"):
            return (kind, self.number(depth - 2), self.vector(depth - 1))
        return (kind, self.vector(depth - 1), self.vector(depth - 1))

    def matrix(self, depth):
        rng, s = self.rng, self.s
        if depth <= 0:
            return ("mat", rng.choice(s.matrices))
        kind = rng.choice(["mat", "mat", "rows", "ms", "tr", "inv", "mm", "m+"])
        if kind == "mat":
            return (kind, rng.choice(s.matrices))
        if kind == "rows":
            return (kind, [[self.number(0) for _ in range(s.size)] for _ in range(s.size)])
        if kind == "ms":
            return (kind, self.number(depth - 2), self.matrix(depth - 1))
        if kind in ("tr", "inv"):
            return (kind, self.matrix(depth - 1 if s.size == 2 else 0))
        return (kind, self.matrix(depth - 1), self.matrix(depth - 1))

    def atom(self, depth):
        rng, s = self.rng, self.s
        if s.size and rng.random() < 0.3:
            return ("v=", rng.choice(["=", "!="]), self.vector(depth), self.vector(depth), s.size)
        count = 3 if rng.random() < 0.15 else 2
        sides = [self.number(depth) for _ in range(count)]
        return ("chain", sides, [rng.choice(["=", "!=", "<", "<=", ">", ">="]) for _ in sides[1:]])

    def formula(self, depth):
        rng = self.rng
        if depth <= 0 or rng.random() < 0.3:
            return self.atom(max(depth, 0))
        kind = rng.choice(["and", "or", "or", "implies", "implies", "iff"])
        if kind in ("and", "or"):
            return (kind, [self.formula(depth - 1) for _ in range(rng.choice([2, 2, 3]))])
        return (kind, self.formula(depth - 1), self.formula(depth - 1))

    def known(self):
        """What is true where it is defined, in formulas and vectors that are made up."""
        rng, s = self.rng, self.s
        a, b, c = (self.formula(rng.choice([0, 0, 1])) for _ in range(3))
        p, q = self.number(1), self.number(1)
        safe = ("chain", [q, ("n", Fraction(0))], ["!="])
        found = [
            ("implies", a, ("or", [b, a])),
            ("implies", ("and", [a, b]), a),
            ("iff", ("and", [a, b]), ("and", [b, a])),
            ("iff", ("implies", a, ("implies", b, c)), ("implies", ("and", [a, b]), c)),
            ("or", [("implies", a, b), ("implies", b, a)]),
            ("implies", ("and", [("implies", a, b), ("implies", b, c)]), ("implies", a, c)),
            ("implies", safe, ("chain", [("*", q, ("/", p, q)), p], ["="])),
            ("iff", ("chain", [("*", p, q), ("n", Fraction(0))], ["="]),
             ("or", [("chain", [p, ("n", Fraction(0))], ["="]), ("chain", [q, ("n", Fraction(0))], ["="])])),
            ("chain", [("^", p, 2), ("n", Fraction(0))], [">="]),
        ]
        if s.size:
            u, v = self.vector(1), self.vector(1)
            m, n = self.matrix(0), self.matrix(1 if s.size == 2 else 0)
            zero = ("n", Fraction(0))
            found += [
                ("chain", [("dot", u, v), ("dot", v, u)], ["="]),
                ("chain", [("^", ("dot", u, v), 2), ("*", ("norm2", u), ("norm2", v))], ["<="]),
                *self.lengths(u, v, p),
                ("iff", ("v=", "=", u, v), ("chain", [("norm2", ("v-", u, v)), zero], ["="])),
                ("iff", ("v=", "!=", u, v), ("chain", [("norm2", ("v-", u, v)), zero], [">"])),
                ("v=", "=", ("mv", ("mm", m, n), u), ("mv", m, ("mv", n, u)), s.size),
                ("m=", "=", ("tr", ("mm", m, n)), ("mm", ("tr", n), ("tr", m)), s.size**2),
                ("v=", "=", ("mv", ("inv", m), ("mv", m, u)), u, s.size),
                ("chain", [("det", ("mm", m, n)), ("*", ("det", m), ("det", n))], ["="]),
                ("chain", [("dot", ("mv", m, u), v), ("dot", u, ("mv", ("tr", m), v))], ["="]),
                ("implies", ("chain", [("det", m), zero], ["!="]), ("v=", "=", ("mv", m, ("mv", ("inv", m), u)), u)),
            ]
            if s.size == 2:
                found.append(("chain", [("cross2", u, v), ("neg", ("cross2", v, u))], ["="]))
                found.append(("chain", [("dot", ("turn", p, u), u), zero], ["="]))
            else:
                found.append(("v=", "=", ("cross3", u, v), ("vneg", ("cross3", v, u)), 3))
                found.append(("chain", [("dot", ("cross3", u, v), v), zero], ["="]))
        f = rng.choice(found)
        return self.changed(f) if rng.random() < 0.25 else f

    def lengths(self, u, v, p):
        """What is true of lengths."""
        a, b, size = ("norm", u), ("norm", v), self.s.size
        sum_, difference, both = ("norm", ("v+", u, v)), ("norm", ("v-", u, v)), ("*", a, b)
        zero, one = ("n", Fraction(0)), ("n", Fraction(1))
        some = ("chain", [a, zero], ["!="])
        unit = ("chain", [("norm", ("over", a, u)), one], ["="])
        cross = ("abs", ("cross2", u, v)) if size == 2 else ("norm", ("cross3", u, v))
        right = ("chain", [("dot", u, v), zero], ["="])
        w = ("vec", self.rng.choice(self.s.vectors))
        return [
            ("chain", [a, zero], [">="]),
            ("chain", [sum_, ("+", a, b)], ["<="]),
            ("chain", [difference, ("abs", ("-", a, b))], [">="]),
            ("chain", [("abs", ("dot", u, v)), both], ["<="]),
            ("chain", [("dot", u, v), both], ["<="]),
            ("chain", [cross, both], ["<="]),
            ("chain", [("norm", ("scale", p, u)), ("*", ("abs", p), a)], ["="]),
            ("chain", [("abs", ("part", w, 0)), ("norm", w)], ["<="]),
            ("chain", [("^", a, 2), ("dot", u, u)], ["="]),
            ("implies", some, unit),
            ("iff", ("chain", [a, zero], ["="]), ("chain", [("norm2", u), zero], ["="])),
            ("implies", right, ("chain", [sum_, difference], ["="])),
            ("implies", right, ("chain", [sum_, a], [">="])),
        ]

    def changed(self, f):
        """One small fault somewhere."""
        spots = []

        def look(e, path):
            if isinstance(e, (tuple, list)):
                for i, part in enumerate(e):
                    look(part, [*path, i])
            elif e in ("+", "-", "*", "=", "<", "<=", ">", ">=", "!=", "and", "or", "tr", "v+", "v-"):
                spots.append(path)

        look(f, [])
        if not spots:
            return f
        other = {"+": "-", "-": "+", "*": "+", "=": "<=", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "!=": "=",
                 "and": "or", "or": "and", "tr": "inv", "v+": "v-", "v-": "v+"}
        path = self.rng.choice(spots)

        def put(e, path):
            if not path:
                # a comparison of vectors has no order
                return {"<=": "!="}.get(other[e], other[e]) if in_arrays else other[e]
            parts = list(e)
            parts[path[0]] = put(parts[path[0]], path[1:])
            return type(e)(parts)

        holder = f
        for i in path[:-1]:
            holder = holder[i]
        in_arrays = holder[0] in ("v=", "m=") and path[-1] == 1
        changed = put(f, path)
        # what has become an inequality between arrays is judged as a whole
        return changed


def document(rng):
    scene = Scene(rng.choice([0, 0, 2, 2, 3]))
    make = Maker(rng, scene)
    lines = ["var " + ", ".join(scene.scalars)]
    if scene.size:
        lines.append("var " + ", ".join(f"{v} in R^{scene.size}" for v in scene.vectors))
        lines.append("var " + ", ".join(f"{m} in R^{scene.size}x{scene.size}" for m in scene.matrices))
    for i in range(rng.choice([0, 1, 2, 2])):
        make.parameters = ["p", "q"][: rng.choice([1, 2])]
        for _ in range(50):
            body = make.number(2)
            if all(f"'{p}'" in repr(body) for p in make.parameters):
                break
        else:
            body = ("s", make.parameters[0])
            make.parameters = make.parameters[:1]
        lines.append(f"let f{i}({', '.join(make.parameters)}) := {text(body)}")
        scene.functions[f"f{i}"] = (make.parameters, body)
        make.parameters = []
    if rng.random() < 0.5:
        body = make.number(2)
        lines.append(f"let k := {text(body)}")
        scene.lets["k"] = body
    if scene.size and rng.random() < 0.5:
        body = make.vector(2)
        lines.append(f"let L := {text(body)}")
        scene.vlets["L"] = body
    givens, claims = {}, {}
    for i in range(rng.choice([0, 1, 2])):
        f, when = make.formula(1), []
        if rng.random() < 0.2:
            when = [make.formula(0)]
        givens[f"g{i}"] = ([f], when)
        lines.append(f"given g{i}: {formula(f)}" + (f" when {formula(when[0])}" if when else ""))
    for i in range(CLAIMS):
        cited = [g for g in givens if rng.random() < 0.5]
        kind = rng.random()
        when = [make.formula(0)] if rng.random() < 0.2 else []
        by = None
        if kind < 0.06:
            content, said = None, "contradiction"
        elif kind < 0.2:
            make.parameters = ["e", *scene.scalars]
            content = [make.formula(2)]
            make.parameters = []
            by = make.number(1)
            if "'e'" not in repr(content):
                content = [("chain", [("s", "e"), ("s", "e")], ["="])]
            said = f"exists e: {formula(content[0])}"
        else:
            content = [make.known() if rng.random() < 0.7 else make.formula(2) for _ in range(rng.choice([1, 1, 2]))]
            said = ", ".join(map(formula, content))
        claims[f"c{i}"] = (content, when, cited, by)
        line = f"claim c{i}: {said}"
        line += f" when {formula(when[0])}" if when else ""
        line += f" from {', '.join(cited)}" if cited else ""
        line += f" by e := {text(by)}" if by else ""
        lines.append(line)
    return scene, givens, claims, "# Lowered\n\n```kane\n" + "\n".join(lines) + "\n```\n"


# --- judging


def premises_hold(claim, givens, env, s):
    """Whether they do; `Costly` where roots take too long to tell apart."""
    _, when, cited, _ = claim
    try:
        if all_of(when, env, s) is not True:
            return False
        for label in cited:
            formulas, condition = givens[label]
            if all_of(condition, env, s) is True and all_of(formulas, env, s) is not True:
                return False
    except Costly:
        return Costly
    return True


def point_of(link, scene):
    named = None
    try:
        named = witness.point(link)
    except Unreadable:
        pass
    if named is None or not all(isinstance(value, (Fraction, Alg)) for value in named.values()):
        return None
    return {name: Fraction(1) for name in scene.names()} | named


def truths_of(claim, env, s):
    """The truth of each link at a point; of one with roots that take too long to tell apart, `Costly` itself."""
    content, _, _, by = claim

    def truth(link):
        try:
            return link(env if by is None else {**env, "e": number(by, env, s)}, s)
        except Costly:
            return Costly

    return [truth(link) for f in content for link in links(f)]


def judge(scene, givens, claims, shown, points):
    """What is wrong, and how many verdicts of which kind there are."""
    wrong, tally = [], []
    for statement in shown:
        label, verdict = statement["label"], statement["verdict"]
        if label not in claims:
            continue
        claim = claims[label]
        content, _, _, by = claim
        tally.append(("exists " if by else "contradiction " if content is None else "") + verdict)
        if by and verdict in ("refuted", "ill-defined"):
            wrong.append(f"{label}: an existence is {verdict}")
        inside = [env for env in points if premises_hold(claim, givens, env, scene) is True]
        if (verdict == "vacuous" or (content is None and verdict == "proved")) and inside:
            wrong.append(f"{label}: {verdict}, but all premises hold at {shown_point(inside[0])}")
        for i, link in enumerate(statement["links"]):
            if content is not None and link["verdict"] == "proved":
                for env in inside:
                    truths = truths_of(claim, env, scene)
                    if len(truths) != len(statement["links"]):
                        wrong.append(f"{label}: {len(truths)} links are meant")
                        break
                    if truths[i] not in (True, Costly):
                        wrong.append(f"{label}, link {i + 1}: proved, but {truths[i]} at {shown_point(env)}")
                        break
            if link["verdict"] in ("refuted", "ill-defined"):
                env = point_of(link, scene)
                if env is None:
                    tally.append("witness not read")
                    continue
                if premises_hold(claim, givens, env, scene) is False:
                    wrong.append(f"{label}, link {i + 1}: a premise fails at {shown_point(env)}")
                elif content is not None:
                    truth = truths_of(claim, env, scene)[i]
                    if truth not in ({"refuted": False, "ill-defined": None}[link["verdict"]], Costly):
                        wrong.append(f"{label}, link {i + 1}: {link['verdict']}, but {truth} at {shown_point(env)}")
    return wrong, tally


def shown_point(env):
    return ", ".join(f"{name} = {value}" for name, value in env.items())


def main():
    trial = Trial("lowered")
    rng = random.Random(trial.seed)
    documents = 0
    while trial.judged < trial.count:
        scene, givens, claims, source = document(rng)
        shown, messages = trial.statements(source, 200_000)
        documents += 1
        if shown is None:
            if "division by literal zero" in messages:
                continue
            trial.wrong.append((source, messages))
            break
        values = [{n: rng.choice(GRID) for n in scene.names()} for _ in range(POINTS)]
        # points at which vectors are equal, or matrices singular, are met more often by few values
        values += [{n: rng.choice(GRID[:2]) for n in scene.names()} for _ in range(POINTS // 2)]
        found, verdicts = judge(scene, givens, claims, shown, values)
        trial.judged += len(claims)
        for verdict in verdicts:
            trial.count_one(verdict)
        trial.wrong += [(source, why) for why in found]
    seen = trial.tally.get("refuted", 0) + trial.tally.get("ill-defined", 0)
    if 10 * trial.tally.get("witness not read", 0) > seen + 10:
        print("the oracle is blind: more than one witness in ten was not read")
        return 1
    return trial.told(f", {documents} documents")


if __name__ == "__main__":
    sys.exit(main())
