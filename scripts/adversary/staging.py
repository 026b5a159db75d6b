"""Random scenes: as files for the program, and as what the independent simulator follows."""

import math
from dataclasses import dataclass, field
from decimal import Decimal as D
from fractions import Fraction

from simulator import PI, ZERO, Ball, Plane, Scene
from spheres import Sphere

SHAPES = {"sphere": D(2) / 5, "hollow-sphere": D(2) / 3, "disc": D(1) / 2, "hoop": D(1)}


def sine_and_cosine(x):
    s, c, term = ZERO, ZERO, D(1)
    for n in range(1, 90):
        way = 1 if (n - 1) % 4 < 2 else -1
        if n % 2:
            c += way * term
        else:
            s += way * term
        term = term * x / n
    return s, c


def exact(text):
    """The number that a file means by a decimal or a fraction."""
    value = Fraction(text)
    return D(value.numerator) / D(value.denominator)


@dataclass
class Draft:
    """A scene: texts of numbers by key; a pair of texts is a number and how uncertain it is."""

    family: str
    top: dict
    bodies: list
    walls: list = field(default_factory=list)
    contacts: list = field(default_factory=list)
    air: dict = field(default_factory=dict)
    tumbler: dict = field(default_factory=dict)
    tip: dict = field(default_factory=dict)
    in_space: bool = False
    until: tuple = ("impacts", 1)
    ask: dict = field(default_factory=dict)

    def toml(self):
        lines = [f'title = "{self.family}"'] + [f"{key} = {shown(v)}" for key, v in self.top.items()]
        for name, tables in (("[[wall]]", self.walls), ("[[contact]]", self.contacts), ("[[body]]", self.bodies)):
            for table in tables:
                lines += ["", name] + [f"{key} = {shown(v)}" for key, v in table.items()]
        if self.tumbler:
            lines += ["", "[polygon]" if "corners_m" in self.tumbler else "[rod]"]
            lines += [f"{key} = {shown(v)}" for key, v in self.tumbler.items()]
        if self.air:
            lines += ["", "[air]"] + [f"{key} = {shown(v)}" for key, v in self.air.items()]
        lines += ["", "[until]", f"{self.until[0]} = {shown(self.until[1])}", "", "[ask]"]
        return "\n".join(lines + [f"{key} = {tolerance}" for key, tolerance in self.ask.items()]) + "\n"

    def uncertain(self):
        count = []
        self.scene(lambda value, within: count.append(1) or value)
        return len(count)

    def scene(self, pick=lambda value, within: value):
        """What is followed; `pick` chooses each uncertain number."""

        def number(text, default="0"):
            if text is None:
                text = default
            if isinstance(text, tuple):
                return pick(exact(text[0]), exact(text[1]))
            return exact(text)

        mu, e = number(self.top["friction"]), number(self.top["restitution"])
        planes = []
        for key, n in (("floor", (0, 1)), ("ceiling", (0, -1)), ("left", (1, 0)), ("right", (-1, 0))):
            if key + "_m" in self.top:
                at = number(self.top[key + "_m"])
                through = (ZERO, at) if n[1] else (at, ZERO)
                planes.append(Plane(key, (D(n[0]), D(n[1])), through))
        for count, wall in enumerate(self.walls, 1):
            if "half_tangent" in wall:
                h = exact(wall["half_tangent"])
                s, c = 2 * h / (1 + h * h), (1 - h * h) / (1 + h * h)
            else:
                s, c = sine_and_cosine(exact(wall["angle_deg"]) * PI / 180)
                # the file means the nearest floats
                s, c = D(float(s)), D(float(c))
            along, out = number(wall.get("sliding_m_s")), number(wall.get("advancing_m_s"))
            v = (along * c - out * s, along * s + out * c)
            through = tuple(number(x) for x in wall["through_m"])
            planes.append(Plane(f"wall-{count}", (-s, c), through, v))
        balls = []
        for body in self.bodies:
            m, r = number(body["mass_kg"]), number(body["radius_m"])
            if "mobility_ratio" in body:
                j = m * r * r / (number(body["mobility_ratio"]) - 1)
            else:
                j = SHAPES[body.get("shape", "sphere")] * m * r * r
            at, v = tuple(map(number, body["position_m"])), tuple(map(number, body["velocity_m_s"]))
            if self.in_space:
                at, v = (at + (ZERO,))[:3], (v + (ZERO,))[:3]
                spins = body.get("spins_rad_s", ["0", "0", body.get("spin_rad_s", "0")])
                balls.append(Sphere(m, j, r, at, v, tuple(map(number, spins))))
            else:
                balls.append(Ball(m, j, r, at, v, number(body.get("spin_rad_s"))))
        if self.in_space:
            planes = [Plane(p.name, (*p.n, ZERO), (*p.through, ZERO), (*p.v, ZERO)) for p in planes]
            for key, n in (("back", 1), ("front", -1)):
                if key + "_m" in self.top:
                    planes.append(Plane(key, (ZERO, ZERO, D(n)), (ZERO, ZERO, number(self.top[key + "_m"])), (ZERO,) * 3))
        corners = None
        if self.tumbler:
            body, corners = self.cornered(number)
            balls.append(body)
        terms = [self.term(contact, number) for contact in self.contacts]
        # of several that fit the first that states it counts
        own = lambda who, which: next(
            (t[which] for t in terms if t[which] is not None and (t[0] is None or t[0] == set(who))), None
        )
        air = [number(self.air.get(key)) for key in ("density_kg_m3", "drag_coefficient", "lift_coefficient")]

        def restitution(who, speed):
            found = own(who, 2)
            return e if found is None else found(speed)

        return Scene(
            balls,
            planes,
            number(self.top.get("gravity_m_s2")),
            lambda who: mu if own(who, 1) is None else own(who, 1),
            restitution,
            share=number(self.top["tangential_restitution"]) if "tangential_restitution" in self.top else None,
            rolling=number(self.top.get("rolling_resistance")),
            air=tuple(air) if self.air else None,
            corners=corners,
        )

    def cornered(self, number):
        """The body with corners: its centre of mass by triangles, its inertia by theirs."""
        table = self.tumbler
        m = number(table["mass_kg"])
        if "length_m" in table:
            half = number(table["length_m"]) / 2
            corners, j = [(-half, ZERO), (half, ZERO)], m * half * half / 3
        else:
            given = [tuple(exact(x) for x in pair) for pair in table["corners_m"]]
            triangles = [(given[0], given[k], given[k + 1]) for k in range(1, len(given) - 1)]
            area = lambda a, b, c: ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
            areas = [area(*t) for t in triangles]
            middles = [tuple(sum(p[k] for p in t) / 3 for k in (0, 1)) for t in triangles]
            centre = [sum(s * p[k] for s, p in zip(areas, middles)) / sum(areas) for k in (0, 1)]
            corners = [(x - centre[0], y - centre[1]) for x, y in given]
            j = ZERO
            for s, p, t in zip(areas, middles, triangles):
                # a triangle about its middle: the sum of the squares of its sides over 36
                sides = sum((t[a][k] - t[b][k]) ** 2 for a, b in ((0, 1), (1, 2), (2, 0)) for k in (0, 1))
                away = sum((p[k] - centre[k]) ** 2 for k in (0, 1))
                j += m * s / sum(areas) * (sides / 36 + away)
        s, c = ZERO, D(1)
        if "half_tangent" in table:
            h = exact(table["half_tangent"])
            s, c = 2 * h / (1 + h * h), (1 - h * h) / (1 + h * h)
        elif "angle_deg" in table:
            s, c = sine_and_cosine(exact(table["angle_deg"]) * PI / 180)
            s, c = D(float(s)), D(float(c))
        corners = [(x * c - y * s, x * s + y * c) for x, y in corners]
        at, v = tuple(map(number, table["position_m"])), tuple(map(number, table["velocity_m_s"]))
        return Ball(m, j, ZERO, at, v, number(table.get("spin_rad_s"))), corners

    @staticmethod
    def term(contact, number):
        between = set(contact["between"]) if "between" in contact else None
        mu = number(contact["friction"]) if "friction" in contact else None
        e = None
        if "speeds_m_s" in contact:
            speeds = [exact(v) for v in contact["speeds_m_s"]]
            values = [number(v) for v in contact["restitutions"]]

            def e(a):
                if a <= speeds[0]:
                    return values[0]
                for k in range(1, len(speeds)):
                    if a <= speeds[k]:
                        part = (a - speeds[k - 1]) / (speeds[k] - speeds[k - 1])
                        return values[k - 1] + part * (values[k] - values[k - 1])
                return values[-1]

        elif "restitution_at_m_s" in contact:
            value, at = number(contact["restitution"]), number(contact["restitution_at_m_s"])
            e = lambda a: min(D(1), value * (at / a).sqrt().sqrt()) if a > 0 else D(1)
        elif "restitution" in contact:
            value = number(contact["restitution"])
            e = lambda a: value
        return between, mu, e


def shown(value):
    if isinstance(value, tuple) and len(value) == 2 and not isinstance(value[0], tuple):
        return f"{{ value = {shown(value[0])}, within = {value[1]} }}"
    if isinstance(value, list):
        return "[" + ", ".join(shown(v) for v in value) + "]"
    if isinstance(value, str) and ("/" in value or value[:1].isalpha()) and value != "true":
        return f'"{value}"'
    return str(value)


def between(rng, low, high, digits=3):
    return f"{rng.uniform(low, high):.{digits}f}"


def a_body(rng, x, y, speed=3):
    body = {
        "mass_kg": rng.choice(["1", "0.5", "0.17", between(rng, 0.05, 2)]),
        "radius_m": between(rng, 0.05, 0.2),
        "position_m": [x, y],
        "velocity_m_s": [between(rng, -speed, speed), between(rng, -speed, speed)],
        "spin_rad_s": rng.choice(["0", between(rng, -30, 30, 2)]),
    }
    if rng.random() < 0.5:
        body["shape"] = rng.choice(list(SHAPES))
    else:
        body["mobility_ratio"] = rng.choice(["7/2", "3", "2", "31/11", between(rng, 1.1, 5, 2)])
    return body


def rows(rng, count):
    """Bodies on places that are far enough from each other, in a box of 3 m by 3 m."""
    places = [(x, y) for x in (0.5, 1.2, 1.9, 2.5) for y in (0.5, 1.2, 1.9, 2.5)]
    return [a_body(rng, f"{x + rng.uniform(-0.1, 0.1):.3f}", f"{y + rng.uniform(-0.1, 0.1):.3f}")
            for x, y in rng.sample(places, count)]


def contacts_of(rng):
    top = {"friction": between(rng, 0, 0.9), "restitution": rng.choice(["1", "1/2", between(rng, 0.3, 1)])}
    if rng.random() < 0.2:
        top["friction"] = "0"
    if rng.random() < 0.35:
        top["tangential_restitution"] = rng.choice(["1", "0", between(rng, 0, 1)])
    return top


def asked(rng, bodies, tolerance):
    keys = ["x_m", "y_m", "v_x_m_s", "v_y_m_s", "omega_rad_s", "kinetic_energy_j", "time_s"]
    keys += [f"{key}_of_{k}" for k in range(2, bodies + 1) for key in keys[:5]]
    return {key: tolerance for key in rng.sample(keys, min(len(keys), 5))} | {"kinetic_energy_j": tolerance}


def tolerance_of(rng):
    return rng.choice(["0", "1e-9", "1e-9", "1e-6", "1e-3", "0.05", "0.5"])


def box(rng):
    count = rng.randint(1, 4)
    top = contacts_of(rng)
    if rng.random() < 0.6:
        top["gravity_m_s2"] = rng.choice(["9.81", "1", between(rng, 0.5, 12)])
    top |= {"floor_m": "0", "ceiling_m": "3", "left_m": "0", "right_m": "3"}
    draft = Draft("box", top, rows(rng, count))
    if rng.random() < 0.3:
        draft.until = ("duration_s", between(rng, 0.1, 2))
    else:
        draft.until = ("impacts", str(rng.randint(1, 12)))
    draft.ask = asked(rng, count, tolerance_of(rng))
    return draft


def slopes(rng):
    """Walls at angles and in motion."""
    draft = box(rng)
    draft.family = "slopes"
    draft.bodies = draft.bodies[:2]
    for key in ("ceiling_m", "left_m", "right_m", "floor_m"):
        if rng.random() < 0.5:
            draft.top.pop(key)
    for _ in range(rng.randint(1, 3)):
        x, y, angle = rng.choice([("1.5", "-0.5", (-40, 40)), ("-0.5", "1.5", (-120, -60)), ("3.5", "1.5", (60, 120))])
        wall = {"through_m": [x, y]}
        if rng.random() < 0.5:
            wall["angle_deg"] = between(rng, *angle, 2)
        else:
            half = {-40: (-0.35, 0.35), -120: (-1.7, -0.6), 60: (0.6, 1.7)}[angle[0]]
            wall["half_tangent"] = between(rng, *half, 2)
        if rng.random() < 0.6:
            wall["sliding_m_s"] = between(rng, -2, 2)
        if rng.random() < 0.5:
            wall["advancing_m_s"] = between(rng, -0.3, 0.3)
        draft.walls.append(wall)
    draft.ask = asked(rng, len(draft.bodies), tolerance_of(rng))
    if draft.until[0] == "impacts":
        draft.until = ("impacts", str(rng.randint(1, 6)))
    return draft


def own_terms(rng):
    """Friction and restitution of single contacts, and by speed."""
    draft = box(rng)
    draft.family = "terms"
    ids = [f"body-{k + 1}" for k in range(len(draft.bodies))]
    for _ in range(rng.randint(1, 3)):
        contact = {}
        if rng.random() < 0.7:
            pair = [rng.choice(ids), rng.choice(["floor", "ceiling", "left", "right"])]
            if len(ids) > 1 and rng.random() < 0.5:
                pair = rng.sample(ids, 2)
            contact["between"] = pair
        if rng.random() < 0.6:
            contact["friction"] = between(rng, 0, 1)
        kind = rng.randrange(4)
        if kind == 1:
            contact["restitution"] = between(rng, 0.2, 1)
        elif kind == 2:
            contact |= {"restitution": between(rng, 0.3, 0.9), "restitution_at_m_s": between(rng, 0.5, 5)}
        elif kind == 3:
            speeds = sorted({between(rng, 0, 8, 2) for _ in range(rng.randint(1, 4))}, key=float)
            contact |= {"speeds_m_s": speeds, "restitutions": [between(rng, 0.2, 1) for _ in speeds]}
        if "friction" in contact or kind:
            draft.contacts.append(contact)
    return draft


def rests(rng):
    """One ball that comes to rest, and creeps on."""
    top = contacts_of(rng)
    top["restitution"] = rng.choice(["1/2", between(rng, 0.1, 0.9)])
    top |= {"gravity_m_s2": rng.choice(["9.81", "10"]), "floor_m": "0"}
    body = a_body(rng, "0", between(rng, 0.2, 1.5))
    draft = Draft("rests", top, [body])
    if rng.random() < 0.5:
        draft.until = ("rest", "true")
    else:
        draft.until = ("duration_s", between(rng, 1, 9))
        if rng.random() < 0.6:
            top["rolling_resistance"] = between(rng, 0, 0.1)
    if rng.random() < 0.25:
        body["position_m"][1], body["velocity_m_s"][1] = body["radius_m"], "0"
    draft.ask = asked(rng, 1, tolerance_of(rng))
    return draft


def in_air(rng):
    """Drag and Magnus' force."""
    draft = (box if rng.random() < 0.7 else slopes)(rng)
    draft.family = "air"
    draft.bodies = draft.bodies[: rng.randint(1, 2)]
    draft.air = {"density_kg_m3": rng.choice(["1.2", between(rng, 0.5, 5)])}
    draft.air["drag_coefficient"] = between(rng, 0, 1)
    if rng.random() < 0.8:
        draft.air["lift_coefficient"] = between(rng, -1, 1)
    draft.ask = asked(rng, len(draft.bodies), rng.choice(["1e-6", "1e-3", "0.05"]))
    draft.until = ("impacts", str(rng.randint(1, 3)))
    if rng.random() < 0.4:
        draft.until = ("duration_s", between(rng, 0.1, 0.8))
    return draft


def tumbling(rng):
    """A polygon or a rod that strikes with its corners."""
    top = {"friction": between(rng, 0.02, 1.2), "restitution": rng.choice(["1", between(rng, 0.2, 1)])}
    if rng.random() < 0.8:
        top["gravity_m_s2"] = rng.choice(["9.81", between(rng, 1, 12)])
    top |= {"floor_m": "0"}
    for key, at in (("left_m", "-2"), ("right_m", "2"), ("ceiling_m", "3")):
        if rng.random() < 0.5 or "gravity_m_s2" not in top:
            top[key] = at
    draft = Draft("tumbling", top, [])
    if rng.random() < 0.3:
        draft.walls.append({"through_m": ["-1.6", "0"], "half_tangent": between(rng, -0.6, -0.1, 2)})
        if rng.random() < 0.5:
            draft.walls[0] |= {"sliding_m_s": between(rng, -1, 1), "advancing_m_s": between(rng, -0.2, 0.2)}
    body = {"mass_kg": between(rng, 0.1, 3)}
    if rng.random() < 0.3:
        body["length_m"] = between(rng, 0.2, 1)
    else:
        turns = sorted(rng.uniform(0, 6.28) for _ in range(rng.randint(3, 6)))
        a, b = rng.uniform(0.1, 0.5), rng.uniform(0.1, 0.5)
        body["corners_m"] = [[f"{a * math.cos(t):.3f}", f"{b * math.sin(t):.3f}"] for t in turns]
    if rng.random() < 0.7:
        body["angle_deg"] = between(rng, -180, 180, 1)
    body |= {"position_m": [between(rng, -0.6, 0.6), between(rng, 0.9, 1.8)]}
    body |= {"velocity_m_s": [between(rng, -3, 3), between(rng, -3, 3)], "spin_rad_s": between(rng, -12, 12, 2)}
    if rng.random() < 0.25:
        body["spin_rad_s"] = (body["spin_rad_s"], between(rng, 0.0001, 0.02, 5))
    draft.tumbler = body
    draft.until = ("impacts", str(rng.randint(1, 5)))
    if rng.random() < 0.3:
        draft.until = ("duration_s", between(rng, 0.1, 1.5))
    if draft.uncertain():
        draft.until = ("impacts", str(rng.randint(1, 2)))
    keys = ["x_m", "y_m", "v_x_m_s", "v_y_m_s", "omega_rad_s", "turned_rad", "time_s", "kinetic_energy_j"]
    tolerance = rng.choice(["1e-9", "1e-6", "1e-3", "0.05"])
    draft.ask = {key: tolerance for key in rng.sample(keys, 5)}
    return draft


def spheres(rng):
    """Spheres in space, in rooms of which any wall may be missing, among walls at angles and in motion."""
    draft = (own_terms if rng.random() < 0.3 else slopes if rng.random() < 0.3 else box)(rng)
    draft.family, draft.in_space = "spheres", True
    draft.top |= {"back_m": "0", "front_m": "3"}
    for key in ("ceiling_m", "left_m", "right_m", "floor_m", "back_m", "front_m"):
        if not draft.contacts and rng.random() < 0.25:
            draft.top.pop(key, None)
    levels = rng.sample(("0.5", "1.1", "1.7", "2.3"), len(draft.bodies))
    at_one_level = rng.random() < 0.5
    for body, level in zip(draft.bodies, levels):
        body["position_m"].append(levels[0] if at_one_level else level)
        body["velocity_m_s"].append(between(rng, -3, 3) if rng.random() < 0.8 else "0")
        if body.get("shape") in ("disc", "hoop"):
            body["shape"] = "hollow-sphere"
        if "mobility_ratio" in body:
            body["mobility_ratio"] = rng.choice(["5/2", "7/2", "3", between(rng, 2.5, 6, 2)])
        if rng.random() < 0.8:
            spins = [between(rng, -30, 30, 2) if rng.random() < 0.8 else "0" for _ in range(3)]
            body["spins_rad_s"] = spins
            body.pop("spin_rad_s")
    if rng.random() < 0.2:
        # towards each other, a little off centre
        pair = draft.bodies[:2]
        if len(pair) == 2:
            a, b = (list(map(float, body["position_m"])) for body in pair)
            pair[0]["velocity_m_s"] = [f"{(y - x) + rng.uniform(-0.05, 0.05):.3f}" for x, y in zip(a, b)]
            pair[1]["velocity_m_s"] = ["0", "0", "0"]
    tolerance = tolerance_of(rng)
    keys = ["z_m", "v_z_m_s", "omega_x_rad_s", "omega_y_rad_s", "x_m", "y_m", "v_x_m_s", "v_y_m_s", "omega_rad_s"]
    keys += [f"{key}_of_{k}" for k in range(2, len(draft.bodies) + 1) for key in keys[:9]]
    draft.ask = dict.fromkeys(rng.sample(keys, 5) + ["kinetic_energy_j", "time_s"], tolerance)
    if rng.random() < 0.15:
        draft.ask = dict.fromkeys(draft.ask, "1e-3")
        body, key = draft.bodies[0], rng.choice(["position_m", "velocity_m_s"])
        body[key][2] = (body[key][2], between(rng, 0.0001, 0.01, 5))
        draft.until = ("impacts", str(rng.randint(1, 3)))
    return draft


def uncertain(rng):
    """The first three families with up to three uncertain numbers."""
    draft = rng.choice([box, slopes, own_terms])(rng)
    draft.family = "uncertain"
    draft.bodies = draft.bodies[:2]
    draft.contacts = [c for c in draft.contacts if all(b in ("body-1", "body-2") or "body" not in b for b in c.get("between", []))]
    if len(draft.bodies) < 2:
        draft.contacts = [c for c in draft.contacts if "body-2" not in c.get("between", [])]
    spots = [(draft.top, "friction", 0.02), (draft.top, "restitution", 0.02)]
    for body in draft.bodies:
        spots += [(body["velocity_m_s"], 0, 0.02), (body["velocity_m_s"], 1, 0.02), (body["position_m"], 0, 0.005)]
        spots += [(body, "spin_rad_s", 0.3)]
    for table, key, most in rng.sample(spots, rng.randint(1, 3)):
        value, within = table[key], between(rng, most / 100, most, 5)
        if key == "friction" and float(Fraction(value)) < 0.05:
            continue
        if key == "restitution" and not 0.1 < float(Fraction(value)) < 0.95:
            continue
        table[key] = (value, within)
    if draft.until[0] == "impacts":
        draft.until = ("impacts", str(rng.randint(1, 4)))
    else:
        draft.until = ("duration_s", between(rng, 0.1, 0.6))
    draft.ask = asked(rng, len(draft.bodies), rng.choice(["1e-3", "0.05", "0.5", "2"]))
    return draft


FAMILIES = {
    "box": box,
    "slopes": slopes,
    "terms": own_terms,
    "rests": rests,
    "air": in_air,
    "tumbling": tumbling,
    "spheres": spheres,
    "uncertain": uncertain,
}
