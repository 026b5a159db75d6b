#!/usr/bin/env python3
"""Random logs of impacts as others print them, put to `kane check`: no clean one may raise an alarm.

    scripts/adversary/printed.py KANE [COUNT [SEED]] [--keep DIR] [--show N]

The impacts are those of `impact_log.py`, in fractions, by a solver in binary64 or binary32; each column is then printed in
its way: as many digits as the float has, `%.3f` to `%.17f`, `%.4g` to `%.12g`, or all of these mixed by column, with zeros
at the end or without. In every other log the arms, normals, masses and coefficients are printed so as well. Wrong is
an alarm on a clean log, a law that is not among those that give it, and a planted fault that stands out of what was
printed by a factor of twenty and is not found.
"""

import argparse
import json
import random
import subprocess
import sys
import tempfile
from collections import Counter
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from impact_log import FAULTS, ZERO, Plan, dot, half_unit, rounded  # noqa: E402
from impacts import LAWS  # noqa: E402

FORMS = ["f64", "f32", *(f"%.{n}f" for n in range(3, 10)), "%.12f", "%.15f", "%.17f", "%.4g", "%.5g", "%.6g", "%.9g", "%.12g", "mixed"]
FACTOR = 20


class Printed(Plan):
    """A log in which columns are printed in their own ways."""

    def __init__(self, rng, law, form, single, fault, whole):
        self.range = rng.random() < 0.5
        super().__init__(rng, law, single, fault)
        self.mass = self.length = self.speed = Fraction(1)
        self.dt = Fraction(1, 240) if self.stepped else ZERO
        self.gravity = [ZERO, Fraction(-981, 100)] if self.stepped else [ZERO, ZERO]
        self.rows, self.space, self.style, self.world = rng.randint(30, 60), None, "csv", 0
        self.form, self.whole, self.forms = form, whole, {}
        self.trimmed = rng.random() < 0.3

    def any(self, low, high):
        # some logs have speeds of several decades
        factor = 10 ** self.rng.uniform(-2, 1.5) if self.range else 1
        return super().any(low * factor, high * factor)

    def form_of(self, name):
        name = name.replace("_pre_", "_post_")
        if name not in self.forms:
            self.forms[name] = self.rng.choice(FORMS[:-1]) if self.form == "mixed" else self.form
        return self.forms[name]

    def prints(self, name):
        """Whether a column is one that was printed; a setting stands as it was stated."""
        return "v" == name[0] or name.startswith("omega") or self.whole and name not in ("dt_s", "time_s", "gravity_x_m_s2", "gravity_y_m_s2", "mu", "e")

    def show(self, name, cell):
        if not isinstance(cell, Fraction):
            return cell
        form = self.form_of(name) if self.prints(name) else "f64"
        if form in ("f64", "f32"):
            single = form == "f32" or self.single
            value = float(rounded(cell, single))
            if not single:
                return repr(value)
            tries = (f"{value:.{digits}g}" for digits in range(1, 10))
            return next(text for text in tries if rounded(Fraction(text), True) == Fraction(value))
        text = form % float(cell)
        if self.trimmed and "." in text and "e" not in text:
            text = text.rstrip("0").rstrip(".")
        return text

    def log(self):
        """Without bodies of which too few digits are left."""
        kept = [i for i in super().log() if all(self.is_told(n, c) for n, c in i.cells.items() if n.startswith(("mass", "inertia", "radius")))]
        return kept

    def is_told(self, name, cell):
        return not isinstance(cell, Fraction) or self.half(name, cell) <= cell / 50

    def half(self, name, cell):
        """By how much what is printed may be off."""
        return abs(Fraction(self.show(name, cell)) - cell)

    def text(self, impacts):
        rows = [{name: self.show(name, cell) for name, cell in impact.cells.items()} for impact in impacts]
        names = list(dict.fromkeys(name for row in rows for name in row))
        lines = [",".join(names)] + [",".join(row.get(name, "") for name in names) for row in rows]
        return "\n".join(lines) + "\n"


class Trial:
    def __init__(self, seed, index, clean=False):
        rng = random.Random(f"{seed}/{index}")
        cases = [(law, form, fault) for fault in ([None] if clean else [None, None, *FAULTS]) for form in FORMS for law in LAWS]
        law, form, fault = cases[index * 1009 % len(cases)]
        single = form == "f32" or form in FORMS[2:-1] and rng.random() < 0.5
        self.plan = Printed(rng, law, form, single, fault, rng.random() < 0.5 and form != "mixed")
        self.wrong, self.notes = [], Counter()
        if fault:
            self.plan.stepped, self.plan.dt, self.plan.gravity = False, ZERO, [ZERO, ZERO]
        self.impacts = self.plan.log()
        self.seen = False
        if fault and len(self.impacts) > 2:
            before = [dict(impact.cells) for impact in self.impacts]
            places = list(range(len(self.impacts)))
            rng.shuffle(places)
            self.plan.plant(self.impacts, places[:2] if "exchanged" in fault else places)
            self.seen = "rows exchanged" in fault or any(self.stands_out(*pair) for pair in zip(before, self.impacts))

    def stands_out(self, was, impact):
        """Whether a planted change is well above what was printed and computed."""
        for name, cell in impact.cells.items():
            if isinstance(cell, Fraction) and cell != was.get(name):
                noise = max(Fraction(10) ** -3 if self.plan.form in ("mixed", "%.4g") else ZERO,
                            *(self.plan.half(n, c) for n, c in impact.cells.items() if isinstance(c, Fraction)))
                noise += 64 * half_unit(self.plan.single or self.plan.form not in ("f64",)) * max(abs(c) for c in impact.cells.values() if isinstance(c, Fraction))
                change = abs(cell - was[name])
                if name == "e":
                    change *= abs(impact.contact.a)
                elif name.startswith(("arm", "radius")):
                    change *= abs(impact.impulse[0]) / max(abs(impact.bodies[0].inertia), 1)
                if change > FACTOR * noise * (1 + abs(impact.bodies[0].mass)):
                    return True
        return False

    def judge(self, kane, folder):
        path = Path(folder) / "log.csv"
        path.write_text(self.plan.text(self.impacts))
        run = subprocess.run([kane, "check", str(path), "--format", "json"], capture_output=True, text=True, check=False)
        if run.returncode not in (0, 1):
            self.wrong.append(f"ended with {run.returncode}: {run.stderr.strip()}")
            return
        report = json.loads(run.stdout)
        self.report = report
        failing = {c["check"] for c in report["checks"] if not c["as_expected"]}
        failed = {c["check"] for c in report["checks"] if c["failed"] and not c["as_expected"]}
        named = [fit["law"] for fit in report["laws"] if fit["gives_all"] and not fit["fitted"]]
        plan = self.plan
        told = report["format"] + "".join(f", {c['column']} {c['format']}" for c in report["column_formats"])
        if not plan.fault:
            gains = any(i.contact.gain(i.impulse) > 0 for i in self.impacts)
            if gains:
                failed -= {"energy"}
                failing -= {"energy"}
            if failed or report["rejected"] or report["suspected"]:
                rows = {c["check"]: (c["failed"], c["worst"]) for c in report["checks"] if c["check"] in failed}
                self.wrong.append(f"false alarm: {rows} {report['rejected']} {report['suspected']}; told {told}")
            elif failing:
                self.notes["clean logs left undecided"] += 1
            if plan.law not in named:
                own = [(f["consistent"], f["rows"], f["worst"]) for f in report["laws"] if f["law"] == plan.law]
                self.wrong.append(f"the law is not named: {own}; told {told}")
            true = {"kane-levinson": "coulomb", "smith-1991": "smith", "walton": "walton", "wang-su-li": "wang-su-li"}.get(plan.law)
            if true and report["friction"]:
                tied = [f["law"] for f in report["friction"] if f["tied"]]
                if true not in tied:
                    fits = [(f["law"], f["parameter"], f["consistent"], f["close"], f["rows"]) for f in report["friction"][:4]]
                    self.wrong.append(f"{true} is not in the sentence: {fits}; told {told}; {report['headline']}")
            return
        found = bool(failing or report["suspected"] or report["rejected"] or plan.law not in named)
        if self.seen and not found:
            self.wrong.append(f"missed: {plan.fault}; told {told}")
        self.notes[f"{plan.fault}: {'seen' if self.seen else 'hardly seen'}, {'found' if found else 'not found'}"] += 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kane")
    parser.add_argument("count", type=int, nargs="?", default=500)
    parser.add_argument("seed", nargs="?", default="printed")
    parser.add_argument("--keep", help="a folder for the logs about which something was wrong")
    parser.add_argument("--show", type=int, help="prints log N and ends")
    parser.add_argument("--clean", action="store_true", help="clean logs alone")
    options = parser.parse_args()
    if options.show is not None:
        trial = Trial(options.seed, options.show, options.clean)
        print(trial.plan.law, trial.plan.form, trial.plan.fault, trial.plan.forms, file=sys.stderr)
        print(trial.plan.text(trial.impacts), end="")
        return 0
    tally, wrong = Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        for index in range(options.count):
            trial = Trial(options.seed, index, options.clean)
            if len(trial.impacts) < 20:
                tally["passed over"] += 1
                continue
            trial.judge(options.kane, folder)
            plan = trial.plan
            tally.update(trial.notes)
            tally["clean logs" if not plan.fault else "logs with a fault"] += 1
            for message in trial.wrong:
                flags = "".join([" single" * plan.single, " whole" * plan.whole, " stepped" * plan.stepped, " two" * plan.two, " round" * plan.round])
                print(f"{options.seed}/{index} {plan.law} {plan.form}{flags} {plan.fault or 'clean'}: {message}", flush=True)
            wrong += bool(trial.wrong)
            if trial.wrong and options.keep:
                Path(options.keep).mkdir(parents=True, exist_ok=True)
                Path(options.keep, f"{index}.csv").write_text(plan.text(trial.impacts))
    for name, count in sorted(tally.items()):
        print(f"{name}: {count}")
    print(f"{wrong} logs wrong")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
