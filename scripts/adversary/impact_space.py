"""Planar impacts turned into space, and back: a rotation in fractions, so that nothing is lost but by rounding."""

from fractions import Fraction

ZERO = Fraction(0)


def names():
    """The vectors of a row: what they are called along x and y, and along z."""
    for number in (1, 2):
        for when in ("pre", "post"):
            yield [f"v{axis}{number}_{when}_m_s" for axis in "xyz"]
        yield [f"arm{number}_{axis}_m" for axis in "xyz"]
    yield [f"gravity_{axis}_m_s2" for axis in "xyz"]
    yield [f"impulse_{axis}_n_s" for axis in "xyz"]
    yield [f"normal_{axis}" for axis in "xyz"]


def spins(number, when):
    return [f"omega_x{number}_{when}_rad_s", f"omega_y{number}_{when}_rad_s", f"omega{number}_{when}_rad_s"]


class Space:
    """A rotation; a drift of all bodies across the plane, and spins of round ones about the normal, that no impact changes."""

    def __init__(self, rng, drift, twist):
        a, b, c, d = ((1, 0, 0, 0) if rng.random() < 0.2 else [rng.randint(-9, 9) for _ in range(3)] + [rng.randint(1, 9)])
        n = Fraction(a * a + b * b + c * c + d * d)
        self.turn = [
            [(a * a + b * b - c * c - d * d) / n, 2 * (b * c - a * d) / n, 2 * (b * d + a * c) / n],
            [2 * (b * c + a * d) / n, (a * a - b * b + c * c - d * d) / n, 2 * (c * d - a * b) / n],
            [2 * (b * d - a * c) / n, 2 * (c * d + a * b) / n, (a * a - b * b - c * c + d * d) / n],
        ]
        self.drift, self.twist = drift, twist

    def lifted(self, vector):
        return [sum(row[k] * vector[k] for k in range(3)) for row in self.turn]

    def lowered(self, vector):
        return [sum(self.turn[k][axis] * vector[k] for k in range(3)) for axis in range(3)]

    def lift(self, cells, normal, rounded):
        """The cells of a row in space."""
        out = {name: cell for name, cell in cells.items() if not name.startswith("omega")}
        out |= {f"normal_{axis}": x for axis, x in zip("xy", normal)}
        drift = self.drift if "mass2_kg" in cells else ZERO
        for x, y, z in names():
            if x in out:
                across = drift if x.startswith("v") else ZERO
                out |= zip((x, y, z), map(rounded, self.lifted([out[x], out[y], across])))
        for number in (1, 2):
            for when in ("pre", "post"):
                if f"omega{number}_{when}_rad_s" in cells:
                    spin = cells[f"omega{number}_{when}_rad_s"]
                    about = self.twist * (-1) ** number
                    vector = self.lifted([about * normal[0], about * normal[1], spin])
                    out |= zip(spins(number, when), map(rounded, vector))
        return out

    def lower(self, cells):
        """The cells in the plane, exactly."""
        out = dict(cells)
        for x, y, z in names():
            if x in cells:
                out[x], out[y], _ = self.lowered([out.pop(name) for name in (x, y, z)])
        for number in (1, 2):
            for when in ("pre", "post"):
                three = spins(number, when)
                if three[0] in cells:
                    out[three[2]] = self.lowered([out.pop(name) for name in three])[2]
        return out
