"""What a row of a log says, in fractions, from its cells alone; and how much of it may be rounding."""

from fractions import Fraction

from impact_log import SHAPES, half_unit
from impacts import Contact, halved

ZERO = Fraction(0)


class Mover:
    """A body as its cells have it, along tangent and normal."""

    def __init__(self, cells, number, tangent, normal):
        def planar(x, y):
            return [x * tangent[0] + y * tangent[1], x * normal[0] + y * normal[1]]

        self.mass = cells[f"mass{number}_kg"]
        radius = cells.get(f"radius{number}_m")
        shape = cells.get(f"shape{number}")
        self.inertia = SHAPES[shape] * self.mass * radius**2 if shape else cells[f"inertia{number}_kg_m2"]
        if f"arm{number}_x_m" in cells:
            self.arm = planar(cells[f"arm{number}_x_m"], cells[f"arm{number}_y_m"])
        else:
            self.arm = [ZERO, radius if number == 2 else -radius]
        self.before, self.after = (
            [*planar(cells[f"vx{number}_{when}_m_s"], cells[f"vy{number}_{when}_m_s"]), cells[f"omega{number}_{when}_rad_s"]]
            for when in ("pre", "post")
        )

    def point(self, motion):
        return [motion[0] - motion[2] * self.arm[1], motion[1] + motion[2] * self.arm[0]]

    @property
    def span(self):
        return abs(self.arm[0]) + abs(self.arm[1])

    @property
    def spins(self):
        return abs(self.before[2]) + abs(self.after[2])

    def energy(self, motion):
        return (self.mass * (motion[0] ** 2 + motion[1] ** 2) + self.inertia * motion[2] ** 2) / 2


class View:
    """An impact as its row has it."""

    def __init__(self, cells, single):
        self.cells = cells
        normal = cells.get("normal_x", ZERO), cells.get("normal_y", Fraction(1))
        tangent = normal[1], -normal[0]
        bodies = [Mover(cells, n, tangent, normal) for n in (1, 2) if f"mass{n}_kg" in cells]
        dt = cells.get("dt_s", ZERO)
        g = [cells.get(f"gravity_{axis}_m_s2", ZERO) * dt for axis in "xy"]
        kick = [g[0] * tangent[0] + g[1] * tangent[1], g[0] * normal[0] + g[1] * normal[1]]
        self.mu, self.e = cells["mu"], cells["e"]
        for body in bodies:
            body.kicked = [body.before[0] + kick[0], body.before[1] + kick[1], body.before[2]]
        first = bodies[0]
        self.p = [first.mass * (first.after[k] - first.kicked[k]) for k in (0, 1)]
        before, after = first.point(first.kicked), first.point(first.after)
        w = [ZERO, ZERO, ZERO]
        for body in bodies:
            x, y = body.arm
            more = 1 / body.mass + y * y / body.inertia, -x * y / body.inertia, 1 / body.mass + x * x / body.inertia
            w = [a + b for a, b in zip(w, more)]
        if len(bodies) == 2:
            before = [a - b for a, b in zip(before, bodies[1].point(bodies[1].kicked))]
            after = [a - b for a, b in zip(after, bodies[1].point(bodies[1].after))]
        (self.u, u_n), (self.slip, self.apart) = before, after
        self.a, self.w = -u_n, tuple(w)
        self.gain = sum(body.energy(body.after) - body.energy(body.kicked) for body in bodies)
        eta, tau = 64 * half_unit(single), 3000 * half_unit(single)
        ways = [sum(abs(x) for x in body.before[:2] + body.after[:2] + kick) + body.span * body.spins for body in bodies]
        late = dt * (abs(self.u) + abs(self.a))
        self.noise = (eta + 2 * tau) * sum(ways) + late * sum(b.spins for b in bodies) + abs(kick[0]) + abs(kick[1])
        self.heat = sum(2 * eta * body.mass * way**2 for body, way in zip(bodies, ways))
        self.heat += eta * sum(body.inertia * body.spins**2 for body in bodies)
        self.heat += abs(kick[0] * self.p[0]) + abs(kick[1] * self.p[1])
        self.lever = abs(first.arm[0] * self.p[1] - first.arm[1] * self.p[0])
        # what the check of moments may leave
        self.twist = eta * first.inertia * first.spins + first.span * first.mass * eta * ways[0]
        self.twist += (late + 2 * tau * first.span) * (abs(self.p[0]) + abs(self.p[1]))
        # where the impulse acted beside the stated arm, a slip is excused by up to 2 % of the arm
        turned = first.inertia * (first.after[2] - first.before[2]) - first.arm[0] * self.p[1] + first.arm[1] * self.p[0]
        if self.p[0]:
            self.noise += min(abs(turned / self.p[0]), abs(first.arm[1]) / 50) * first.spins
        det = w[0] * w[2] - w[1] ** 2
        self.stretch = w[0] * w[2] / det

    @property
    def unforced(self):
        """The slip that there would be without friction."""
        return self.u + self.w[1] * self.p[1]

    def contact(self):
        return Contact(self.u, max(self.a, ZERO), self.w, self.mu, self.e)

    def friction(self, law, parameter):
        """p_t of a law of friction, given the normal impulse of the row."""
        bound, w, s = self.mu * max(self.p[1], ZERO), self.w[0], self.unforced
        sign = (self.u > 0) - (self.u < 0)

        def held(x, most):
            return max(-most, min(most, x))

        if law == "smith":
            return self.smith(bound)
        if law == "wang-su-li":
            return -s / w if not self.u else -sign * bound / 2 * (abs(self.u) + sign * s) / (abs(self.u) + bound * w / 2)
        return {
            "none": lambda: ZERO,
            "coulomb": lambda: held(-s / w, bound),
            "compression": lambda: held(-s / w, bound / (1 + self.e)),
            "share": lambda: held(-s / w, parameter * bound),
            "walton": lambda: held(-(s + parameter * self.u) / w, bound),
            "uncapped": lambda: -sign * bound,
        }[law]()

    def smith(self, bound):
        """By halving in whole numbers: the slip afterwards, u, s and w*bound are multiples of one unit."""
        terms = self.u, self.unforced, self.w[0] * bound
        unit = max(abs(x) for x in terms) / (1 << 120)
        if not unit:
            return ZERO
        u, s, most = (round(x / unit) for x in terms)

        def is_below(v):
            # s + w*pull(v) > v
            return (s - v) * (u * u + v * v) > most * (u * abs(u) + v * abs(v))

        low = halved(s - most, s + most, is_below)
        squares = u * u + low * low
        return -bound * (u * abs(u) + low * abs(low)) / squares if squares else ZERO

    def missed(self, law, parameter):
        """By how much of k a law of friction misses this row, and how much of that may be rounding."""
        scale = max(abs(self.u), abs(self.unforced))
        miss = self.w[0] * abs(self.p[0] - self.friction(law, parameter))
        noise = self.noise * (1 + self.w[0] * (1 + self.mu) * self.cells["mass1_kg"])
        return (miss / scale, noise / scale) if scale else (ZERO, ZERO)
