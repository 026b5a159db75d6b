"""One impact of a tip: a rod, and Kane's double pendulum, whose contact couples."""

from decimal import Decimal as D

from simulator import HALF, ZERO, Ball, Unfit, dot, mobility, pushed
from staging import PI, Draft, between, exact, sine_and_cosine
from tumbler import CONTACTS, along


def tips(rng):
    draft = Draft("tips", {"friction": between(rng, 0, 1.5), "restitution": rng.choice(["1", "0", between(rng, 0, 1)])}, [])
    if rng.random() < 0.5:
        draft.tip = {
            "mass_kg": between(rng, 0.1, 3),
            "length_m": between(rng, 0.1, 2),
            "angle_deg": between(rng, 5, 175, 2),
            "velocity_m_s": [between(rng, -3, 3), between(rng, -4, -1)],
            "spin_rad_s": between(rng, -3, 3),
        }
    else:
        draft.tip = {
            "mass_kg": between(rng, 0.1, 3),
            "length_m": between(rng, 0.1, 2),
            "angles_deg": [between(rng, 5, 80, 2), between(rng, 5, 80, 2)],
            "angular_velocities_rad_s": [between(rng, -2, 0), between(rng, -2, 0)],
        }
    tolerance = rng.choice(["0", "1e-9", "1e-6", "1e-3", "0.05"])
    draft.ask = dict.fromkeys(["k", "v_t_m_s", "v_n_m_s", "p_t_n_s", "p_n_n_s", "energy_ratio"], tolerance)
    return draft


def toml(draft):
    from staging import shown

    lines = [f"{key} = {v}" for key, v in draft.top.items()]
    lines += ["", "[rod-tip]" if "angle_deg" in draft.tip else "[double-pendulum]"]
    lines += [f"{key} = {shown(v)}" for key, v in draft.tip.items()] + ["", "[ask]"]
    return "\n".join(lines + [f"{key} = {tolerance}" for key, tolerance in draft.ask.items()]) + "\n"


def of_degrees(text):
    s, c = sine_and_cosine(exact(text) * PI / 180)
    return D(float(s)), D(float(c))


def answers(draft, model):
    tip, mu, e = draft.tip, exact(draft.top["friction"]), exact(draft.top["restitution"])
    m, length = exact(tip["mass_kg"]), exact(tip["length_m"])
    t, n = (D(1), ZERO), (ZERO, D(1))
    if "angle_deg" in tip:
        s, c = of_degrees(tip["angle_deg"])
        arm = (-length / 2 * c, -length / 2 * s)
        before = Ball(m, m * length**2 / 12, ZERO, (ZERO, ZERO), tuple(map(exact, tip["velocity_m_s"])), exact(tip["spin_rad_s"]))
        w = mobility(before, arm)
        entries = along(w, t, t), along(w, t, n), along(w, n, n)
        slip, out = before.v[0] - before.w * arm[1], before.v[1] + before.w * arm[0]
        energy, after = before.energy(), lambda p: pushed(before, arm, p).energy()
    else:
        (s1, c1), (s2, c2) = map(of_degrees, tip["angles_deg"])
        u = tuple(map(exact, tip["angular_velocities_rad_s"]))
        inner = m * length**2
        a, b, d = inner * 4 / 3, inner * (c1 * c2 + s1 * s2) / 2, inner / 3
        det = a * d - b * b
        rows = {"t": (length * c1, length * c2), "n": (length * s1, length * s2)}
        solve = lambda q: ((d * q[0] - b * q[1]) / det, (a * q[1] - b * q[0]) / det)
        entry = lambda x, y: dot(rows[x], solve(rows[y]))
        entries = entry("t", "t"), entry("t", "n"), entry("n", "n")
        slip, out = dot(rows["t"], u), dot(rows["n"], u)
        kinetic = lambda u: HALF * (a * u[0] ** 2 + 2 * b * u[0] * u[1] + d * u[1] ** 2)

        def after(p):
            change = solve([rows["t"][k] * p[0] + rows["n"][k] * p[1] for k in (0, 1)])
            return kinetic((u[0] + change[0], u[1] + change[1]))

        energy = kinetic(u)
    if out > D("-1e-3") or abs(slip) < D("1e-3"):
        raise Unfit("hardly comes, or hardly slips")
    tt, tn, nn = entries
    pt, pn = CONTACTS[model](slip, out, tt, tn, nn, mu, e)
    slips = slip + tt * pt + tn * pn
    return {
        "k": slips / slip,
        "v_t_m_s": slips,
        "v_n_m_s": out + tn * pt + nn * pn,
        "p_t_n_s": pt,
        "p_n_n_s": pn,
        "energy_ratio": after((pt, pn)) / energy,
    }
