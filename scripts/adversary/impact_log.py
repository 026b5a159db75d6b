"""Random logs of impacts, in fractions: bodies, normals, units, float formats, time step and gravity; clean, or with one
planted fault. What was planted is known, because it is written first.
"""

import json
import struct
from dataclasses import dataclass, field
from fractions import Fraction

from impact_space import Space
from impacts import LAWS, Contact

ZERO, ONE = Fraction(0), Fraction(1)
SHAPES = {"sphere": Fraction(2, 5), "hollow-sphere": Fraction(2, 3), "disc": Fraction(1, 2), "hoop": ONE}
FAULTS = ["sign of friction", "arm off by 1 %", "e off by 0.01", "friction capped at half the cone",
          "two answers exchanged", "two rows exchanged"]  # fmt: skip


def half_unit(single):
    return Fraction(1, 1 << 24) if single else Fraction(1, 1 << 53)


def rounded(x, single):
    value = float(x)
    return Fraction(struct.unpack("f", struct.pack("f", value))[0] if single else value)


@dataclass
class Body:
    mass: Fraction
    inertia: Fraction
    arm: list  # as written
    v: list
    spin: Fraction
    kind: str  # how it is written: "arm", "radius" or a shape
    radius: Fraction = None
    reach: list = None  # the arm on which the impulse acts
    after: list = None  # vx, vy, spin


@dataclass
class Impact:
    normal: tuple
    bodies: list
    mu: Fraction
    e: Fraction
    dt: Fraction
    gravity: list
    impulse: tuple = None  # p_t, p_n
    contact: Contact = None  # what the law was asked
    cells: dict = field(default_factory=dict)

    @property
    def tangent(self):
        return self.normal[1], -self.normal[0]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def at_point(body, v, spin):
    x, y = body.reach
    return [v[0] - spin * y, v[1] + spin * x]


class Plan:
    """What all rows of a log have in common."""

    def __init__(self, rng, law, single, fault):
        self.rng, self.law, self.single, self.fault = rng, law, single, fault
        pick = rng.choice
        self.exact_text = rng.random() < 0.3  # a binary32 is printed with all its digits
        self.mass, self.length, self.speed = (Fraction(10) ** pick(k) for k in ((-6, -3, 0, 0, 3), (-4, -2, 0, 0, 1), (-2, 0, 0, 0, 2)))
        self.upright = rng.random() < 0.4
        self.two = rng.random() < 0.4
        self.round = law == "keller-printed" or rng.random() < 0.5
        self.kind = pick(["arm", "radius", "shape"]) if self.round else "arm"
        self.stepped = rng.random() < 0.35
        self.dt = self.round_(self.length / self.speed * Fraction(pick([1, 3, 10]), 10000)) if self.stepped else ZERO
        g = self.speed / self.dt / pick([300, 3000]) if self.stepped else ZERO
        self.gravity = [self.round_(ZERO), self.round_(-g)] if rng.random() < 0.7 else [ZERO, ZERO]
        self.noisy = rng.random() < 0.4
        self.kick_first = rng.random() < 0.5
        self.world = pick([0, 0, 30])
        self.coefficients = [
            [self.round_(Fraction(rng.randint(*span), 1000)) for _ in range(pick([1, 2, 3]))] for span in ((20, 900), (0, 980))
        ]
        self.rows = pick([1, 2, 3, 5, 8, 13, 30, 60])
        self.style = pick(["csv", "csv", "semicolons", "tabs", "json lines"])
        self.impulse = not self.two and rng.random() < 0.3
        # some impacts of bodies are with a wall, which has no columns
        self.walls = self.two and rng.random() < 0.4
        self.space = None
        if rng.random() < 0.3:
            twist = self.any(-5, 5) * self.speed / self.length if self.round else ZERO
            self.space = Space(rng, pick([0, 1]) * self.any(-2, 2) * self.speed, pick([0, 1]) * twist)

    def round_(self, x):
        return rounded(x, self.single)

    def any(self, low, high):
        """A number between, as the format has it."""
        return self.round_(Fraction(self.rng.uniform(low, high)))

    def in_world(self, arm):
        """The difference of two positions that were rounded."""
        if not self.world:
            return arm
        size = max(abs(x) for x in arm)
        out = []
        for x in arm:
            centre = self.round_(Fraction(self.rng.uniform(-1, 1)) * size * self.world)
            out.append(self.round_(self.round_(centre + x) - centre))
        return out

    def body(self, side, normal):
        length = float(self.length)
        mass = self.round_(self.mass * Fraction(self.rng.uniform(0.3, 3)))
        radius = self.round_(self.length * Fraction(self.rng.uniform(0.3, 3)))
        speed = float(self.speed)
        v = [self.any(-speed, speed) for _ in range(2)]
        spin = self.round_(self.any(-speed, speed) / self.length) if self.rng.random() < 0.7 else ZERO
        if self.round:
            kind = self.rng.choice(list(SHAPES)) if self.kind == "shape" else self.kind
            reach = [(-1) ** (side == 0) * radius * x for x in normal]
            written = reach if kind != "arm" else self.in_world([self.round_(x) for x in reach])
            inertia = SHAPES[kind] * mass * radius**2 if kind in SHAPES else self.inertia(mass, radius)
            return Body(mass, inertia, written, v, spin, kind, radius, reach)
        arm = [self.any(-length, length) for _ in range(2)]
        size = sum(abs(x) for x in arm)
        return Body(mass, self.inertia(mass, size), self.in_world(arm), v, spin, "arm", None, arm)

    def inertia(self, mass, length):
        return self.round_(mass * length**2 * Fraction(self.rng.uniform(0.2, 1.2)))

    def impact(self):
        """An impact, or None where the law has no answer."""
        normal = (ZERO, ONE)
        if not self.upright:
            q = Fraction(self.rng.randint(-400, 400), 97)
            normal = (2 * q / (1 + q * q), (1 - q * q) / (1 + q * q))
        wall = not self.two or self.walls and self.rng.random() < 0.5
        bodies = [self.body(side, normal) for side in range(1 if wall else 2)]
        mu, e = (self.rng.choice(values) for values in self.coefficients)
        impact = Impact(normal, bodies, mu, e, self.dt, self.gravity)
        kick = [g * self.dt for g in self.gravity]
        early = kick if self.kick_first else [ZERO, ZERO]
        moving = [[v + k for v, k in zip(body.v, early)] for body in bodies]
        if self.stepped and self.round:
            self.overlap(bodies, moving, normal)
        u = [at_point(body, v, body.spin) for body, v in zip(bodies, moving)]
        u = u[0] if wall else [a - b for a, b in zip(u[0], u[1])]
        t, n = impact.tangent, normal
        u_t, a = dot(u, t), -dot(u, n)
        # the velocity after has to be larger than what its rounding leaves of it
        if a <= self.speed / 50:
            return None
        w = [ZERO, ZERO, ZERO]
        for body in bodies:
            x, y = dot(body.reach, t), dot(body.reach, n)
            more = 1 / body.mass + y * y / body.inertia, -x * y / body.inertia, 1 / body.mass + x * x / body.inertia
            w = [one + two for one, two in zip(w, more)]
        impact.contact = Contact(u_t, a, tuple(w), mu, e)
        impact.impulse = LAWS[self.law](impact.contact)
        if impact.impulse is None:
            return None
        self.moved(impact, moving, [ZERO, ZERO] if self.kick_first else kick)
        return impact

    def overlap(self, bodies, moving, normal):
        """The engine looks late: bodies overlap by a part of a step's way."""
        away = [dot(v, normal) for v in moving]
        way = max(ZERO, sum(away[1:]) - away[0]) * self.dt * Fraction(self.rng.randint(0, 9), 10)
        body = bodies[0]
        body.reach = [x * (1 - way / body.radius) for x in body.reach]

    def moved(self, impact, moving, late):
        p = [impact.impulse[0] * t + impact.impulse[1] * n for t, n in zip(impact.tangent, impact.normal)]
        for body, v, sign in zip(impact.bodies, moving, (1, -1)):
            x, y = body.reach
            after = [v[k] + sign * p[k] / body.mass + late[k] for k in (0, 1)]
            after.append(body.spin + sign * (x * p[1] - y * p[0]) / body.inertia)
            before = [*body.v, body.spin]
            body.after = [self.round_(self.solved(a, b)) for a, b in zip(after, before)]

    def solved(self, after, before):
        """What a solver makes of it: some roundings of what goes through it."""
        if not self.noisy:
            return after
        return after + Fraction(self.rng.uniform(-10, 10)) * half_unit(self.single) * (abs(after) + abs(before))

    def cells(self, impact, place):
        """The numbers of a row, by the names of the schema."""
        cells = {"time_s": Fraction(place)}
        for number, body in enumerate(impact.bodies, 1):
            cells[f"mass{number}_kg"] = body.mass
            if body.kind in SHAPES:
                cells |= {f"shape{number}": body.kind, f"radius{number}_m": body.radius}
            else:
                cells[f"inertia{number}_kg_m2"] = body.inertia
            if body.kind == "radius":
                cells[f"radius{number}_m"] = body.radius
            if body.kind == "arm":
                cells |= {f"arm{number}_{axis}_m": x for axis, x in zip("xy", body.arm)}
            for when, (x, y, spin) in (("pre", [*body.v, body.spin]), ("post", body.after)):
                cells |= {f"vx{number}_{when}_m_s": x, f"vy{number}_{when}_m_s": y, f"omega{number}_{when}_rad_s": spin}
        if not self.upright:
            cells |= {f"normal_{axis}": self.round_(x) for axis, x in zip("xy", impact.normal)}
        cells |= {"mu": impact.mu, "e": impact.e}
        if self.stepped:
            cells |= {"dt_s": self.dt, "gravity_x_m_s2": self.gravity[0], "gravity_y_m_s2": self.gravity[1]}
        if self.impulse:
            p = [impact.impulse[0] * t + impact.impulse[1] * n for t, n in zip(impact.tangent, impact.normal)]
            cells |= {f"impulse_{axis}_n_s": self.round_(x) for axis, x in zip("xy", p)}
        return cells

    def log(self):
        """Impacts with their cells; fewer than planned where the law has no answers."""
        found = [impact for impact in (self.impact() for _ in range(6 * self.rows)) if impact][: self.rows]
        for place, impact in enumerate(found):
            impact.cells = self.cells(impact, place)
        return found

    def plant(self, impacts, places):
        """Plants the fault in these rows."""
        if self.fault == "two answers exchanged":
            first, second = (impacts[place].cells for place in places[:2])
            for name in [name for name in first if "_post_" in name and name in second]:
                first[name], second[name] = second[name], first[name]
        elif self.fault == "two rows exchanged":
            a, b = places[:2]
            impacts[a], impacts[b] = impacts[b], impacts[a]
        else:
            for place in places:
                self.plant_in(impacts[place])

    def plant_in(self, impact):
        cells, (p_t, p_n) = impact.cells, impact.impulse
        if self.fault == "e off by 0.01":
            by = Fraction(1, 100)
            cells["e"] = self.round_(impact.e + (by if impact.e + by <= 1 else -by))
        elif self.fault == "arm off by 1 %":
            for name in cells:
                if name.startswith(("arm1", "radius1")):
                    cells[name] = self.round_(cells[name] * Fraction(101, 100))
        else:
            bound = impact.mu * p_n / 2
            wanted = -p_t if self.fault == "sign of friction" else min(bound, max(-bound, p_t))
            more = [(wanted - p_t) * t for t in impact.tangent]
            for number, (body, sign) in enumerate(zip(impact.bodies, (1, -1)), 1):
                x, y = body.reach
                turn = sign * (x * more[1] - y * more[0]) / body.inertia
                change = [sign * more[0] / body.mass, sign * more[1] / body.mass, turn]
                for name, by in zip((f"vx{number}_post_m_s", f"vy{number}_post_m_s", f"omega{number}_post_rad_s"), change):
                    cells[name] = self.round_(cells[name] + by)
            cells |= {name: self.round_(cells[name] + x) for name, x in zip(("impulse_x_n_s", "impulse_y_n_s"), more) if name in cells}
            impact.impulse = wanted, p_n

    def written(self, cell):
        if not isinstance(cell, Fraction):
            return cell
        value = float(cell)
        if not self.single or self.exact_text:
            return repr(value)
        tries = (f"{value:.{digits}g}" for digits in range(1, 10))
        return next(text for text in tries if rounded(Fraction(text), True) == cell)

    def placed(self, cells):
        """The cells where the log has them: in the plane, or in space."""
        if not self.space:
            return cells
        normal = cells.get("normal_x", ZERO), cells.get("normal_y", ONE)
        return self.space.lift(cells, normal, self.round_)

    def read(self, cells):
        """The cells as a reader has them, in the plane."""
        placed = self.placed(cells)
        read = {n: Fraction(float(self.written(c))) if isinstance(c, Fraction) else c for n, c in placed.items()}
        return self.space.lower(read) if self.space else read

    def text(self, impacts):
        """The file, and the end of its name."""
        rows = [{name: self.written(cell) for name, cell in self.placed(impact.cells).items()} for impact in impacts]
        names = list(dict.fromkeys(name for row in rows for name in row))
        if self.style == "json lines":
            def value(text):
                return text if text is None or text in SHAPES else float(text)

            return "".join(json.dumps({n: value(row.get(n)) for n in names}) + "\n" for row in rows), "jsonl"
        comma = {"csv": ",", "semicolons": ";", "tabs": "\t"}[self.style]
        lines = [comma.join(names)] + [comma.join(row.get(name, "") for name in names) for row in rows]
        return "\n".join(lines) + "\n", "csv"
