"""A body with corners, followed by the independent simulator: a fine grid, and bisection where it sees a corner come
through a wall; impacts by Coulomb friction along the impulse with Stronge's restitution, phase by phase."""

from dataclasses import replace
from decimal import Decimal as D
from decimal import localcontext

from simulator import HALF, ZERO, Event, Run, Unfit, dot, fly, mobility, pushed, sign


def cos_sin(x):
    """By Taylor's series of x/2^k and doublings."""
    halvings = 0
    while abs(x) > D("0.05"):
        x, halvings = x / 2, halvings + 1
    c, s, term = ZERO, ZERO, D(1)
    for n in range(24):
        if n % 2:
            s += term if n % 4 == 1 else -term
        else:
            c += term if n % 4 == 0 else -term
        term = term * x / (n + 1)
    for _ in range(halvings):
        c, s = c * c - s * s, 2 * c * s
    return c, s


def turned(v, cs):
    return (v[0] * cs[0] - v[1] * cs[1], v[0] * cs[1] + v[1] * cs[0])


def along(w, x, y):
    return sum(x[i] * w[i][k] * y[k] for i in (0, 1) for k in (0, 1))


def energetic(vt, vn, tt, tn, nn, mu, e):
    """The impulses that end the restitution, by following the contact through it."""
    pt = pn = work = ZERO
    compressing, least = True, ZERO
    for _ in range(20):
        if vt != 0:
            rate = -sign(vt) * mu
        elif abs(tn) <= mu * tt:
            rate = -tn / tt
        else:
            rate = -sign(tn) * mu
        dt, dn = tn + tt * rate, nn + tn * rate
        ends = []
        if vt != 0 and sign(dt) == -sign(vt):
            ends.append((-vt / dt, "stop"))
        if compressing and dn > 0:
            ends.append((-vn / dn, "turn"))
        if not compressing:
            left = -e * e * least - work
            root = vn * vn + 2 * dn * left
            if root >= 0 and dn != 0:
                ends += [(q, "end") for q in ((-vn + root.sqrt()) / dn,) if q >= 0]
        step, what = min(ends)
        if len(ends) > 1 and abs(ends[0][0] - ends[1][0]) < D(10) ** -12:
            raise Unfit("a tie")
        work += vn * step + HALF * dn * step * step
        pt, pn, vt, vn = pt + rate * step, pn + step, vt + dt * step, vn + dn * step
        if what == "stop":
            vt = ZERO
        elif what == "turn":
            compressing, least, vn, work = False, work, ZERO, ZERO
            if e == 0:
                return pt, pn
        else:
            return pt, pn
    raise Unfit("no end of an impact")


def newton(vt, vn, tt, tn, nn, mu, e):
    """Without friction."""
    return ZERO, -(1 + e) * vn / nn


CONTACTS = {"reference": energetic, "stronge-1990": energetic, "normal-only": newton}


def follow_tumbling(scene, model, impacts, duration):
    with localcontext() as context:
        context.prec = 40
        return tumble(scene, CONTACTS[model], impacts, duration)


def tumble(scene, contact, impacts, duration):
    body, now, angle, events = scene.balls[0], ZERO, ZERO, []
    fallen, left = ZERO, None
    while impacts is None or len(events) < impacts:
        found = first(scene, body, now, angle, left, duration)
        if found is None:
            t = duration - now
            run = Run(duration, [fly(body, t, scene.g)], events)
            run.turned = angle + body.w * t
            return run
        t, corner, plane = found
        before, body = body, fly(body, t, scene.g)
        fallen += body.m * scene.g * (before.at[1] - body.at[1])
        now, angle = now + t, angle + body.w * t
        body, event = strike(scene, contact, body, now, angle, corner, plane)
        event.works["gravity_j"], fallen = fallen, ZERO
        event.corner = corner + 1
        event.turned = angle
        events.append(event)
        left = (corner, plane.name)
    run = Run(now, [body], events)
    run.turned = angle
    return run


def strike(scene, contact, body, now, angle, corner, plane):
    arm = turned(scene.corners[corner], cos_sin(angle))
    n = plane.n
    t = (n[1], -n[0])
    u = (body.v[0] - body.w * arm[1] - plane.v[0], body.v[1] + body.w * arm[0] - plane.v[1])
    w = mobility(body, arm)
    slip, vn = dot(u, t), dot(u, n)
    if vn > -D("1e-5") or abs(slip) < D("1e-7"):
        raise Unfit("hardly comes, or hardly slips")
    names = ("body-1", plane.name)
    mu, e = scene.mu(names), scene.e(names, -vn)
    pt, pn = contact(slip, vn, along(w, t, t), along(w, t, n), along(w, n, n), mu, e)
    p = [pt * t[k] + pn * n[k] for k in (0, 1)]
    after = pushed(body, arm, p)
    mean = [HALF * (body.v[k] + after.v[k]) for k in (0, 1)]
    works = {"normal_j": dot(mean, n) * pn, "tangential_j": dot(mean, t) * pt}
    works["rotational_j"] = HALF * body.j * (after.w**2 - body.w**2)
    slips = (slip, slip + along(w, t, t) * pt + along(w, t, n) * pn)
    speeds = (-vn, vn + along(w, t, n) * pt + along(w, n, n) * pn)
    if speeds[1] < D("1e-5"):
        raise Unfit("a corner that stays")
    return after, Event(now, names, [after], works, slips, speeds, (pt, pn))


def first(scene, body, now, angle, left, duration):
    def height(corner, plane, t, cs):
        arm = turned(scene.corners[corner], cs)
        v = (body.v[0] - plane.v[0], body.v[1] - plane.v[1])
        d = [body.at[k] - plane.through[k] - plane.v[k] * now + v[k] * t + arm[k] for k in (0, 1)]
        return dot(d, plane.n) - HALF * scene.g * t * t * plane.n[1]

    step = min(D("0.004"), D("0.02") / max(abs(body.w), D("0.1")))
    turn, cs, t = cos_sin(body.w * step), cos_sin(angle), ZERO
    pairs = [(corner, plane) for corner in range(len(scene.corners)) for plane in scene.planes]
    heights = {(c, p.name): (None, height(c, p, ZERO, cs)) for c, p in pairs}
    for _ in range(6000):
        t, cs = t + step, turned(cs, turn)
        soon = []
        for corner, plane in pairs:
            key = (corner, plane.name)
            older, old = heights[key]
            new = height(corner, plane, t, cs)
            begins = t == step and (key == left or old == 0)
            if new < 0:
                if begins:
                    raise Unfit("hardly leaves")
                low, high = t - step, t
                for _ in range(110):
                    middle = (low + high) * HALF
                    inside = height(corner, plane, middle, cos_sin(angle + body.w * middle)) > 0
                    low, high = (middle, high) if inside else (low, middle)
                soon.append((high, corner, plane))
            elif older is not None and older > old < new and old < D("2e-4"):
                raise Unfit("grazes")
            heights[key] = (None if begins else old, new)
        soon.sort(key=lambda s: s[0])
        if len(soon) > 1 and soon[1][0] - soon[0][0] < D("1e-6"):
            raise Unfit("two corners at once")
        if duration is not None and now + (soon[0][0] if soon else t) > duration:
            return None
        if soon:
            return soon[0]
    raise Unfit("nothing meets")
