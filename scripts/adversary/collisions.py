#!/usr/bin/env python3
"""Random collisions of one or two planar bodies, put to `kane collide`: all laws in a table, or one in depth.

    scripts/adversary/collisions.py KANE [COUNT [SEED]]

The laws are those of `impacts.py`, in fractions; the bodies' motion and energy are worked out here. Half of the
collisions lie on a border between two regimes, or 10^-17 or 10^-40 beside it. Wrong is: another impulse, an answer where
there is none, and none where there is one; any quantity, as a fraction, as digits or as the nearest float; what becomes of
the energy; an enclosure that does not enclose; a check that fails; a headline that counts otherwise; another exit code.
"""

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
sys.set_int_max_str_digits(0)

import impacts  # noqa: E402
from impacts import LAWS, ONE, ZERO, Contact, by_slip  # noqa: E402

impacts.TINY = 1000  # bits of a root: contacts are ill-conditioned on purpose
NEAR = Fraction(1, 10**50)
OPEN = "open"  # what the formulas of impacts.py do not tell
PLAIN = ["1", "2", "1/2", "1/3", "0.1", "3/7", "9.81", "0.01"]
NASTY = ["0.99999999999999999999", "1e-30", "1e30", "1000000007", "12345678901234567890/98765432109876543211", "1e-40"]
# where these slide and where they stop at v_t = 0 is not in their formulas
NO_SLIP = {"whittaker-stop", "garwin-capped", "walton", "smith-1991", "wang-su-li", "tilted-2002", "tilted-2004", "saitoh"}
# what gives no impulse without approach, which is not in the formulas either
IDLE = {"wang-su-li", "routh-newton", "keller-1986", "stronge-1990", "djerassi-newton", "djerassi-poisson", "djerassi-stronge"}
AXES = ["v_x", "v_y", "omega"]


class Body:
    """One body: its table in a file, and what an impulse at its contact does to it."""

    def __init__(self, rng, wild, side):
        def number(positive=False):
            text = rng.choice(NASTY) if rng.random() < wild else rng.choice(PLAIN)
            return text if positive or rng.random() < 0.5 else "0" if rng.random() < 0.2 else f"-{text}"

        mass, inertia = number(True), number(True)
        arm, velocity, spin = [number(), number()], [number(), number()], number()
        self.table = {"mass_kg": mass, "inertia_kg_m2": inertia, "arm_m": arm, "velocity_m_s": velocity, "spin_rad_s": spin}
        self.m, self.j, self.side = Fraction(mass), Fraction(inertia), side
        self.x, self.y = map(Fraction, arm)
        self.before = [*map(Fraction, velocity), Fraction(spin)]

    def mobility(self):
        return 1 / self.m + self.y**2 / self.j, -self.x * self.y / self.j, 1 / self.m + self.x**2 / self.j

    def at_contact(self):
        vx, vy, w = self.before
        return self.side * (vx - w * self.y), self.side * (vy + w * self.x)

    def after(self, p):
        t, n = self.side * p[0], self.side * p[1]
        changes = t / self.m, n / self.m, (self.x * n - self.y * t) / self.j
        return [v + change for v, change in zip(self.before, changes)]

    def energies(self, motion):
        """Of motion along y, along x, and of rotation."""
        return self.m * motion[1] ** 2 / 2, self.m * motion[0] ** 2 / 2, self.j * motion[2] ** 2 / 2


class Trial:
    """One collision, and what the program says."""

    def __init__(self, seed, index):
        rng = random.Random(f"{seed}/{index}")
        self.law = rng.choice(list(LAWS)) if rng.random() < 0.5 else None
        self.wrong, self.notes = [], Counter()
        while True:
            wild = rng.choice([0, 0.1, 0.3])
            self.bodies = [Body(rng, wild, side) for side in [1, -1][: rng.choice([1, 2])]]
            u, separation = (sum(values) for values in zip(*(body.at_contact() for body in self.bodies)))
            if separation <= 0:
                break
        w = tuple(sum(values) for values in zip(*(body.mobility() for body in self.bodies)))
        self.e = rng.choice(["0", "1", "1/2", "0.9", "0.99999999999999999999", "1e-20"])
        contact = Contact(u, -separation, w, ZERO, Fraction(self.e))
        self.c = contact._replace(mu=Fraction(rng.choice(["0", "1/10", "0.3", "1", "10"])))
        borders = [mu for mu in self.borders(contact) if 10**-30 < mu < 10**30]
        if borders and rng.random() < 0.5:
            self.c = self.c._replace(mu=rng.choice(borders) * (1 + Fraction(rng.choice([-1, 0, 0, 1]), 10 ** rng.choice([17, 40]))))

    @staticmethod
    def borders(c):
        """Coefficients of friction at which a contact that slides stops, sticks, jams, or leaves the cone."""
        tt, tn, nn = c.w
        stuck = by_slip(c, ZERO)
        return [
            *([abs(c.u) * nn / (tt * (1 + c.e) * c.a) * k for k in (1, 2)] if c.u and c.a else []),
            *([abs(tn) / tt, nn / abs(tn)] if tn else []),
            *([abs(stuck[0] / stuck[1])] if stuck and stuck[1] else []),
        ]

    def text(self):
        lines = [f'friction = "{self.c.mu}"', f'restitution = "{self.e}"']
        for name, body in zip(("body", "other"), self.bodies):
            lines += [f"[planar.{name}]", *(f"{key} = {json.dumps(v)}" for key, v in body.table.items())]
        return "\n".join(lines) + "\n"

    def expected(self, law):
        c = self.c
        if not c.a and law in IDLE:
            return ZERO, ZERO
        if c.w[1] and (not c.u and law in NO_SLIP or law == "smith-1991" and c.mu * abs(c.w[1]) >= c.w[2]):
            return OPEN
        try:
            return LAWS[law](c)
        except ZeroDivisionError:
            return OPEN

    def quantities(self, p):
        """What the report should say, by symbol; None for what has no meaning."""
        c = self.c
        t, n = c.after(p)
        cone, slip = c.mu * p[1], abs(c.u)
        motions = [body.after(p) for body in self.bodies]
        before = [body.energies(body.before) for body in self.bodies]
        after = [body.energies(motion) for body, motion in zip(self.bodies, motions)]
        ledger = [sum(parts) for parts in zip(*([b - a for a, b in zip(x, y)] for x, y in zip(before, after)))]
        start, friction = sum(map(sum, before)), p[0] * (c.u + t) / 2
        ends = [""] if len(self.bodies) == 1 else ["1", "2"]
        return {
            "p_t": p[0], "p_n": p[1], "v_t+": t, "v_n+": n,
            "k": t / c.u if c.u else None,
            "i_x": -p[0] * c.sign / cone if cone and c.u else None,
            "de": friction / (cone * slip) if cone and c.u else None,
            "dE_t": friction, "dE_n": p[1] * (n - c.a) / 2, "dE": sum(ledger),
            "T+/T-": sum(map(sum, after)) / start if start else None,
            **dict(zip(("dT_y", "dT_x", "dT_rot"), ledger)),
            **{axis + end: v for end, motion in zip(ends, motions) for axis, v in zip(AXES, motion)},
        }  # fmt: skip

    def given(self):
        c = self.c
        s = c.mu * (1 + c.e) * c.a / c.w[2]
        alpha = c.w[0] * s / (2 * c.u) if c.u else None
        return {"v_t": c.u, "a": c.a, "W_tt": c.w[0], "W_tn": c.w[1], "W_nn": c.w[2], "S": s, "alpha": alpha}

    def compare(self, law, said, value, scale):
        """One quantity; `scale` is by what an irrational one may be off, since the oracle rounds roots, or None."""
        name, exact, digits = said["symbol"], said["exact"], said["digits"]
        if value is None or exact is None and digits is None:
            if value is not None or exact is not None or digits is not None:
                self.wrong.append(f"{law}: {name} is {exact or digits}, not {value}")
            return
        slack = ZERO if scale is None else NEAR * max(abs(value), scale)
        if exact is not None and abs(Fraction(exact) - value) > slack:
            self.wrong.append(f"{law}: {name} is {exact}, not {value}")
        if "sqrt" not in digits:
            shown, cut = Fraction(digits.replace("…", "")), "…" in digits
            off = slack + abs(shown) * Fraction(1, 10**19) * cut
            if abs(shown - value) > off or (not cut and scale is None and shown != value):
                self.wrong.append(f"{law}: {name} is shown as {digits}, not {float(value)}")
        if "lanes" in said:
            low, high = (None if end is None else Fraction(end) for end in said["lanes"]["enclosure"] or (None, None))
            if low is not None and value < low - slack or high is not None and value > high + slack:
                self.wrong.append(f"{law}: {name} is not in {said['lanes']['enclosure']}")
            return
        try:
            nearest = value.numerator / value.denominator
        except OverflowError:
            nearest = None
        if said["float"] != nearest and (scale is None or nearest is None or abs(Fraction(said["float"]) - value) > abs(value) / 2**52):
            self.wrong.append(f"{law}: {name} is {said['float']} in floats, not {nearest}")

    def law_says(self, answer):
        law, outcome, expected = answer["id"], answer["outcome"], self.expected(answer["id"])
        if outcome is None:
            if "take too long" in answer["reason"]:
                self.notes["too long in exact numbers"] += 1
            elif expected not in (None, OPEN):
                self.wrong.append(f"{law}: no outcome, and there is {[float(x) for x in expected]}")
            return
        said = {q["symbol"]: q for q in outcome["quantities"]}
        told = [said[symbol]["exact"] for symbol in ("p_t", "p_n")]
        irrational = None in told
        p = expected if irrational else tuple(map(Fraction, told))
        if expected is None:
            self.wrong.append(f"{law}: {outcome['regime']}, and there is no outcome")
            return
        if p == OPEN:
            return
        size = max(map(abs, p))
        if expected != OPEN and max(abs(x - y) for x, y in zip(p, expected)) > size * NEAR:
            self.wrong.append(f"{law}: {outcome['regime']}, p = {told}, not {[float(x) for x in expected]}")
            return
        self.notes["irrational outcomes" if irrational else "rational outcomes"] += 1
        scale = size * max(1, *self.c.w, abs(self.c.u), self.c.a) if irrational else None
        values = {**self.given(), **self.quantities(p)}
        for symbol, quantity in said.items():
            if symbol != "root":
                self.compare(law, quantity, values[symbol], scale)
        gain = self.c.gain(p)
        energy = "created" if gain > 0 else "lost" if gain < 0 else "kept"
        if outcome["energy"] != energy and (scale is None or abs(gain) > scale * NEAR):
            self.wrong.append(f"{law}: energy is {outcome['energy']}, not {energy}")
        self.wrong += [f"{law}: {check['claim']} fails" for check in outcome.get("checks", []) if not check["holds"]]

    def judge(self, kane, folder):
        path = Path(folder, "c.toml")
        path.write_text(self.text())
        command = [kane, "collide", str(path), *(["--law", self.law] if self.law else []), "--format", "json"]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        if run.returncode not in (0, 1, 3):
            self.wrong.append(f"exit {run.returncode}: {run.stderr}")
            return
        report = json.loads(run.stdout)
        for answer in report["laws"]:
            self.law_says(answer)
        outcomes = [answer["outcome"] for answer in report["laws"] if answer["outcome"]]
        if (run.returncode == 3) != (not outcomes) or run.returncode == 1:
            self.wrong.append(f"exit {run.returncode}, and {len(outcomes)} outcomes")
        if not self.law:
            created = sum(outcome["energy"] == "created" for outcome in outcomes)
            energy = f"{created} create{'s' * (created == 1)} energy" if created else "none creates energy"
            if not report["headline"].endswith(f"; {energy}"):
                self.wrong.append(f"headline: {report['headline']}")
            self.notes["contacts on which energy is created"] += created > 0


def main():
    kane, count, seed = [*sys.argv[1:], *["1000", "long"][len(sys.argv) - 2 :]][:3]
    tally, wrong = Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        for index in range(int(count)):
            trial = Trial(seed, index)
            trial.judge(kane, folder)
            tally.update(trial.notes)
            wrong += len(trial.wrong)
            if trial.wrong:
                print(f"{seed}/{index} {trial.law or 'all laws'}\n{trial.text()}", *trial.wrong, sep="\n  ")
    for name, n in sorted(tally.items()):
        print(f"{name}: {n}")
    print(f"{count} collisions, {wrong} wrong")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
