"""Certified comparisons, held against exact fractions: decisions.py KANE [FORMULAS [SEED]]

Random comparisons go to `kane stability --out`, and the functions that it writes in C and in Python are called at
floats drawn everywhere, at the inputs that the program names, and next to ties, which are looked for by halving. The
oracle is that of rounding.py. C is compiled with cc; without it, Python alone is tried.

Wrong is an answer that is not the exact one, from either language, and a share of wrong decisions of plain floats
whose example is none.
"""

import ctypes
import random
import shutil
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

from rounding import Exact, Machine, Undefined, Unknown, at_place, ends_of, evaluate, formula, place, read, setting
from trial import Trial

BATCH = 20
POINTS = 60


def comparison(rng, index):
    """The text of a core that chooses, its ranges and format."""
    names = ["x", "y"]
    sides = [formula(rng, names, rng.randint(1, 3)) for _ in range(2)]
    relation = rng.choice(["<", "<=", ">", ">=", "==", "!="])
    ranges, form, properties = setting(rng, names)
    text = (f'(FPCore (x y) :name "f{index}" {properties} '
            f"(if ({relation} {sides[0]} {sides[1]}) 1 0))")
    return text, ranges, form


def exactly(relation, left, right, at):
    exact = {name: (Fraction(x),) * 2 for name, x in at.items()}
    system = Exact()
    return system.less(relation, evaluate(left, exact, system), evaluate(right, exact, system))


def tie(relation, left, right, ends, form, rng):
    """A point next to which the comparison turns, along an argument."""
    index = rng.randrange(2)
    start = [rng.randint(*e) for e in ends]

    def truth(p):
        at = list(start)
        at[index] = p
        # an equality turns where the order does
        order = "<" if relation in ("==", "!=") else relation
        return exactly(order, left, right, dict(zip("xy", (at_place(q, form) for q in at))))

    places = sorted(rng.randint(*ends[index]) for _ in range(8))
    for a, b in zip(places, places[1:]):
        try:
            below = truth(a)
            if truth(b) == below:
                continue
            while b - a > 1:
                middle = (a + b) // 2
                if truth(middle) == below:
                    a = middle
                else:
                    b = middle
        except (Undefined, Unknown):
            continue
        start[index] = a
        return start
    return None


def compiled(source, folder):
    """The functions of a file in C, or None without a compiler."""
    compiler = shutil.which("cc")
    if not compiler:
        return None
    library = folder / f"{source.stem}-{random.random()}.so"
    subprocess.run([compiler, "-std=c99", "-O1", "-ffp-contract=off", "-shared", "-fPIC", "-w", "-o", library, source, "-lm"],
                   check=True)
    return ctypes.CDLL(str(library))


def judge(trial, made, index, report, in_c, in_python, rng):
    text, ranges, form = made
    ends = [ends_of(*ranges[name], form) for name in "xy"]
    if not report["formats"]:
        trial.count_one("no float in the range")
        return
    decisions = report["formats"][0]["decisions"]
    trial.count_one("formulas with comparisons" if decisions else "formulas that compare inputs alone")
    for decision in decisions:
        if not decision["function"]:
            trial.count_one("comparisons that are too large")
            continue
        left, right = (read(decision[side])[0][-1] for side in ("left", "right"))
        relation = decision["relation"]
        functions = [in_python[decision["function"]]]
        if in_c:
            function = getattr(in_c, decision["function"])
            function.argtypes, function.restype = [ctypes.c_double] * 2, ctypes.c_int
            functions.append(function)
        points = [[rng.randint(*e) for e in ends] for _ in range(POINTS // 3)]
        for _ in range(4):
            near = tie(relation, left, right, ends, form, rng)
            for _ in range(POINTS // 6 if near else 0):
                points.append([p + rng.choice([0, 1, -1]) * rng.randrange(1 << rng.randint(0, 10)) for p in near])
        example = decision["example"]
        if example:
            points.insert(0, [place(float(x), form) for x in example["at"]])
        machine = Machine(form)
        for turn, at in enumerate(points):
            at = [at_place(min(max(p, a), b), form) for p, (a, b) in zip(at, ends)]
            try:
                truth = exactly(relation, left, right, dict(zip("xy", at)))
            except Undefined:
                continue
            except Unknown:
                trial.count_one("points of which the oracle cannot tell")
                continue
            trial.judged += 1
            for function in functions:
                if bool(function(*at)) != truth:
                    trial.wrong.append((text, f"{decision['text']} at {at} is {truth}, not {function(*at)}"))
            try:
                values = dict(zip("xy", at))
                plain = machine.less(relation, evaluate(left, values, machine), evaluate(right, values, machine))
            except Undefined:
                continue
            trial.tally["that plain floats decide wrongly"] = trial.tally.get("that plain floats decide wrongly", 0) + (plain != truth)
            if example and turn == 0 and (plain == truth or truth != example["holds"]):
                trial.wrong.append((text, f"{at} is no example"))


def main():
    trial = Trial("decisions")
    folder = Path(trial.folder.name)
    for asked in trial.formulas(comparison, BATCH, "--out", str(folder / "out")):
        in_c = compiled(folder / "out" / "f-floats.c", folder)
        in_python = {}
        source = (folder / "out" / "f-floats.py").read_text()
        # float32 is asked for by plain functions alone, which are not called
        exec(compile(source.replace("from numpy import float32", "float32 = float"), "f", "exec"), in_python)
        for i, (one, report, rng) in enumerate(asked):
            judge(trial, one, i, report, in_c, in_python, rng)
    return trial.told(f", {trial.count} formulas", "answers")


if __name__ == "__main__":
    sys.exit(main())
