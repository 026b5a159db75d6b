#!/usr/bin/env python3
"""Random logs of impacts, put to `kane check`, which has to say what is known of them.

    scripts/adversary/records.py KANE [COUNT [SEED]] [--keep DIR] [--show N]

A log is made by one of the published laws, or has one planted fault (`impact_log.py`, `impacts.py`). Wrong is: an alarm on
a clean log; a clean log whose law is not among those that give it; a planted fault that is large enough to be seen and is
not; a sentence, a law, an interval or a sum that the rows contradict (`impact_view.py`). Ends with 0 if nothing was.
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

from impact_log import FAULTS, Plan, half_unit  # noqa: E402
from impact_view import View  # noqa: E402
from impacts import LAWS, NOT_NEWTON  # noqa: E402

CASES = [(law, single, fault) for fault in [None, None, *FAULTS] for single in (False, True) for law in LAWS]
CLOSE = Fraction(1, 100)


class Trial:
    """One log, what was planted in it, and what the program says."""

    def __init__(self, seed, index):
        rng = random.Random(f"{seed}/{index}")
        # every law with every format and fault comes in turn
        law, single, fault = CASES[index * 113 % len(CASES)]
        self.plan, self.wrong, self.notes = Plan(rng, law, single, fault), [], Counter()
        if fault:
            self.plan.stepped, self.plan.rows = False, max(self.plan.rows, 3)
            self.plan.dt, self.plan.gravity = Fraction(0), [Fraction(0)] * 2
        self.impacts = self.plan.log()
        self.clean = [View(impact.cells, single) for impact in self.impacts]
        self.planted = []
        if fault and len(self.impacts) > 2:
            places = list(range(len(self.impacts)))
            rng.shuffle(places)
            self.planted = sorted(places[: 2 if "exchanged" in fault else rng.choice([1, len(places)])])
            before = [dict(impact.cells) for impact in self.impacts]
            self.plan.plant(self.impacts, self.planted)
            self.seen = self.visible(before)
        # a binary32 that is written shortly is read as another number
        self.views = [View(self.plan.read(impact.cells), single) for impact in self.impacts]

    def visible(self, before):
        """Whether some planted row differs by more than rounding can."""
        for place in self.planted:
            was, cells = self.clean[place], self.impacts[place].cells
            now = View(cells, self.plan.single)
            fault = self.plan.fault
            if fault == "two rows exchanged":
                return True
            if fault == "arm off by 1 %":
                if was.lever / 100 > 4 * was.twist:
                    return True
            elif fault == "e off by 0.01":
                if was.a / 100 > 4 * (1 + was.stretch) * was.noise:
                    return True
            else:
                moved = abs(now.slip - was.slip) + abs(now.apart - was.apart)
                if before[place] != cells and moved > 8 * (1 + was.stretch) * (was.noise + now.noise):
                    return True
        return False

    def judge(self, kane, folder):
        text, ending = self.plan.text(self.impacts)
        path = Path(folder) / f"log.{ending}"
        path.write_text(text)
        if not self.ask(kane, path):
            return None
        if self.report["format_in_doubt"]:
            self.notes["logs that do not tell their format"] += 1
            self.openly()
            if not self.ask(kane, path, "--float", "f32" if self.plan.single else "f64"):
                return None
        self.true_words()
        self.true_laws()
        self.true_sums()
        if not self.planted:
            self.no_false_alarm()
        elif self.seen:
            self.found()
        else:
            self.notes["faults too small to be seen"] += 1
        return None

    def ask(self, kane, path, *flags):
        run = subprocess.run([kane, "check", str(path), *flags, "--format", "json"], capture_output=True, text=True, check=False)
        if run.returncode not in (0, 1):
            self.wrong.append(f"ended with {run.returncode}: {run.stderr.strip()}")
            return False
        self.report = json.loads(run.stdout)
        return True

    def openly(self):
        """Where too few numbers tell the format, no clean row is called a failure, and no fault that is seen is passed over."""
        checks = self.report["checks"]
        failing = {check["check"] for check in checks if check["failed"] and not check["as_expected"]}
        if self.planted:
            named = [fit["law"] for fit in self.report["laws"] if fit["gives_all"] and not fit["fitted"]]
            told = any(not check["as_expected"] for check in checks) or self.report["suspected"] or self.report["rejected"]
            if self.seen and not told and self.plan.law in named:
                self.wrong.append(f"missed: {self.plan.fault} where the format is in doubt")
        elif failing - {"energy"}:
            self.wrong.append(f"false alarm where the format is in doubt: {sorted(failing)}")

    def failing(self):
        return {check["check"] for check in self.report["checks"] if not check["as_expected"]}

    def no_false_alarm(self):
        report, law = self.report, self.plan.law
        if report["rejected"] or report["suspected"]:
            self.wrong.append(f"false alarm: {report['rejected']} {report['suspected']}")
        gains = [view.gain > 4 * view.heat for view in self.views]
        doubtful = any(0 < 4 * view.gain and view.gain <= 4 * view.heat for view in self.views)
        failing = self.failing()
        if any(gains) and "energy" not in failing:
            self.wrong.append("missed: energy is created")
        if failing - ({"energy"} if any(gains) or doubtful else set()):
            self.wrong.append(f"false alarm: {sorted(failing)}")
        named = [fit["law"] for fit in report["laws"] if fit["gives_all"] and not fit["fitted"]]
        if law not in named:
            own = [fit for fit in report["laws"] if fit["law"] == law]
            self.wrong.append(f"the law is not named: {own}")
        self.notes["clean logs named"] += law in named
        self.intervals()

    def intervals(self):
        """The fitted coefficients hold the true ones."""
        for fit in self.report["coefficients"]:
            e, mu = fit["e"], fit["mu"]
            if self.plan.law not in NOT_NEWTON and e and not (e["one_value"] and e["low"] <= fit["stated_e"] <= e["high"]):
                self.wrong.append(f"e = {fit['stated_e']} is not in {e}")
            if self.plan.law in ("kane-levinson", "whittaker-uncapped") and mu:
                high = float("inf") if mu["high"] is None else mu["high"]
                known = mu["low"] <= fit["stated_mu"] <= high
                if not known or (self.plan.law == "kane-levinson" and not mu["one_value"]):
                    self.wrong.append(f"mu = {fit['stated_mu']} is not in {mu}")

    def found(self):
        report, failing = self.report, self.failing()
        alarm = bool(failing or report["suspected"] or report["rejected"])
        named = [fit["law"] for fit in report["laws"] if fit["gives_all"] and not fit["fitted"]]
        kind = "by an alarm" if alarm else "by another law" if self.plan.law not in named else "not at all"
        self.notes[f"{self.plan.fault}: found {kind}"] += 1
        if kind == "not at all":
            self.wrong.append(f"missed: {self.plan.fault} in {len(self.planted)} rows")
        if self.plan.fault in ("arm off by 1 %", "two rows exchanged") and not alarm:
            self.wrong.append(f"missed: no check fails by {self.plan.fault}")

    def true_words(self):
        """Counts of restitution and friction are not beyond what the rows have."""
        report, views = self.report, self.views
        if report["rows"] != len(views):
            return
        words = report["headline"]
        off = [abs(view.apart - view.e * view.a) > 4 * view.noise for view in views]
        if words.startswith("Restitution as stated;") or words == "Restitution as stated.":
            if any(off):
                self.wrong.append("false: restitution as stated")
        hypothesis = words.partition("'s hypothesis (")[2].partition(")")[0]
        if hypothesis:
            self.gives(hypothesis)
        for fit in report["friction"]:
            parameter = None if fit["parameter"] is None else Fraction(fit["parameter"])
            misses = [view.missed(fit["law"], parameter) for view in views]
            far = sum(miss > CLOSE + 8 * noise for miss, noise in misses)
            if far > fit["rows"] - fit["close"]:
                self.wrong.append(f"false: {fit['law']} is close in {fit['close']} rows, but {far} are far")
            near = sum(miss + noise < CLOSE for miss, noise in misses)
            if near > fit["close"]:
                self.wrong.append(f"false: {fit['law']} is close in {fit['close']} rows, but {near} are near")

    def gives(self, law):
        """Says so if a law that is said to give every row does not."""
        for view in self.views:
            contact = view.contact()
            p = LAWS[law](contact) if contact.a else None
            if p is None:
                self.notes["laws without an answer of ours"] += 1
                continue
            slip, apart = contact.after(p)
            miss = max(abs(slip - view.slip), abs(apart - view.apart))
            if miss > Fraction(3, 1000) * (abs(view.u) + view.a) + 16 * view.stretch * view.noise:
                self.wrong.append(f"false: {law} gives every row, but misses one by {float(miss):.2g} m/s")
                return

    def true_laws(self):
        for fit in self.report["laws"]:
            if fit["gives_all"] and not fit["fitted"]:
                self.gives(fit["law"])

    def true_sums(self):
        energy, views = self.report["energy"], self.views
        if self.report["rows"] != len(views):
            return
        told = sum(Fraction(energy[name]) for name in ("change_normal", "change_tangential", "change_rotational"))
        size = sum(view.heat for view in views)
        if not self.plan.space:
            # in space the normal is rounded as the rest, and energy along it with it
            size *= half_unit(False) / (64 * half_unit(self.plan.single))
        if abs(told - sum(view.gain for view in views)) > 64 * size:
            self.wrong.append("false: the sums of energy")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kane")
    parser.add_argument("count", type=int, nargs="?", default=1000)
    parser.add_argument("seed", nargs="?", default="records")
    parser.add_argument("--keep", help="a folder for the logs about which something was wrong")
    parser.add_argument("--show", type=int, help="prints log N and ends")
    options = parser.parse_args()
    if options.show is not None:
        trial = Trial(options.seed, options.show)
        print(trial.plan.law, trial.plan.fault, trial.planted, file=sys.stderr)
        print(trial.plan.text(trial.impacts)[0], end="")
        return 0
    tally, judged, wrong = Counter(), 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for index in range(options.count):
            trial = Trial(options.seed, index)
            if not trial.impacts:
                tally["laws without an answer to any row"] += 1
                continue
            trial.judge(options.kane, folder)
            judged += 1
            tally.update(trial.notes)
            tally["clean logs" if not trial.planted else f"{trial.plan.fault}: logs"] += 1
            plan = trial.plan
            for message in trial.wrong:
                form = f"{'f32' if plan.single else 'f64'}{', space' * bool(plan.space)}, {len(trial.impacts)} rows"
                print(f"{options.seed}/{index} {plan.law}, {form}, {plan.fault or 'clean'}: {message}")
            wrong += len(trial.wrong)
            if trial.wrong and options.keep:
                kept, ending = plan.text(trial.impacts)
                Path(options.keep).mkdir(parents=True, exist_ok=True)
                Path(options.keep, f"{index}.{ending}").write_text(kept)
    for name, count in sorted(tally.items()):
        print(f"{name}: {count}")
    print(f"{judged} logs, {wrong} wrong")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
