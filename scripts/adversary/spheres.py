"""Spheres in space, for the independent simulator: mobilities as full matrices, and friction checked to stay in
the plane of the normal and the slip. Written from `docs/scene-format.md` alone.
"""

from dataclasses import dataclass, replace
from decimal import Decimal as D

from simulator import HALF, ONE, TINY, ZERO, Event, Run, Unfit, first_fall, names_of

PLANE_KEPT = D(10) ** -40  # of an impulse, by 50 digits


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def plus(a, b, factor=ONE):
    return tuple(x + factor * y for x, y in zip(a, b))


def cross(a, b):
    return tuple(a[i] * b[k] - a[k] * b[i] for i, k in ((1, 2), (2, 0), (0, 1)))


@dataclass
class Sphere:
    """SI units; at, v and w have three components."""

    m: D
    j: D
    r: D
    at: tuple
    v: tuple
    w: tuple

    def energy(self):
        return HALF * (self.m * dot(self.v, self.v) + self.j * dot(self.w, self.w))


def flown(ball, t, g):
    fall = (ZERO, -HALF * g * t * t, ZERO)
    return replace(ball, at=plus(plus(ball.at, ball.v, t), fall), v=plus(ball.v, (ZERO, -g * t, ZERO)))


def meets_face(ball, face, now, g):
    gap = dot(plus(plus(ball.at, face.through, -ONE), face.v, -now), face.n) - ball.r
    speed, pull = dot(plus(ball.v, face.v, -ONE), face.n), -g * face.n[1]
    if abs(gap) < TINY:
        gap = ZERO
        if abs(speed) < D(10) ** -33 and pull < 0:
            raise Unfit("rests")
        if speed < 0:
            return ZERO
    f = lambda t: gap + t * (speed + HALF * pull * t)
    if not pull:
        return first_fall(f, [], speed < 0)
    turn = -speed / pull
    if turn > 0 and pull > 0 and abs(f(turn)) < D(10) ** -9:
        raise Unfit("grazes")
    return first_fall(f, [turn], pull < 0)


def meets_sphere(a, b):
    d, w, reach = plus(a.at, b.at, -ONE), plus(a.v, b.v, -ONE), a.r + b.r
    if dot(d, w) >= 0:
        return None
    far = lambda t: dot(plus(d, w, t), plus(d, w, t)) - reach**2
    closest = -dot(d, w) / dot(w, w)
    if abs(far(closest)) < D(10) ** -9 * reach**2:
        raise Unfit("grazes")
    return ZERO if far(ZERO) <= 0 else first_fall(far, [closest], False)


def push(ball, arm, p):
    """The velocity and the spin that an impulse at an arm gives."""
    moment = cross(arm, p)
    return tuple(x / ball.m for x in p), tuple(x / ball.j for x in moment)


def at_arm(v, w, arm):
    return plus(v, cross(w, arm))


def collide(scene, law, who, now, balls):
    """Sends the spheres of `who` through their impact; what is said of it."""
    first, second = who
    a = balls[first]
    if isinstance(second, int):
        b = balls[second]
        d = plus(a.at, b.at, -ONE)
        n = tuple(x / dot(d, d).sqrt() for x in d)
        sides, wall = [(first, -a.r, 1), (second, b.r, -1)], (ZERO, ZERO, ZERO)
    else:
        n, wall, sides = second.n, second.v, [(first, -a.r, 1)]
    arms = [(index, tuple(r * x for x in n), way) for index, r, way in sides]

    def change(p):
        """What an impulse does to the relative velocity of the contact points."""
        total = (ZERO, ZERO, ZERO)
        for index, arm, way in arms:
            v, w = push(balls[index], arm, tuple(way * x for x in p))
            total = plus(total, at_arm(v, w, arm), D(way))
        return total

    relative = tuple(-x for x in wall)
    for index, arm, way in arms:
        relative = plus(relative, at_arm(balls[index].v, balls[index].w, arm), D(way))
    approach = -dot(relative, n)
    slip = plus(relative, n, approach)
    speed = dot(slip, slip).sqrt()
    if speed < D(10) ** -30:
        # what a contact without slip leaves of 50 digits
        speed = ZERO
    t = tuple(x / speed for x in slip) if speed else (ZERO, ZERO, ZERO)
    names = names_of(who)
    e = scene.e(names, approach)
    pn = (1 + e) * approach / dot(n, change(n))
    pt = law(speed, dot(t, change(t)), scene.mu(names) * pn, scene.share) if speed else ZERO
    p = plus(tuple(pn * x for x in n), t, pt)
    # friction must not turn the slip: all that the impulse changes is along n and t
    beside = cross(n, t)
    if abs(dot(beside, change(p))) > PLANE_KEPT * (1 + dot(p, p)):
        raise AssertionError("friction leaves the plane of slip")
    works = {"normal_j": ZERO, "tangential_j": ZERO, "rotational_j": ZERO}
    for index, arm, way in arms:
        before, own = balls[index], tuple(way * x for x in p)
        v, w = push(before, arm, own)
        after = balls[index] = replace(before, v=plus(before.v, v), w=plus(before.w, w))
        mean = plus(before.v, v, HALF)
        works["normal_j"] += dot(mean, n) * dot(own, n)
        works["tangential_j"] += dot(mean, t) * dot(own, t)
        works["rotational_j"] += HALF * before.j * (dot(after.w, after.w) - dot(before.w, before.w))
    after = [balls[index] for index, _, _ in arms]
    slips = (speed, dot(t, plus(slip, change(p))) if speed else ZERO)
    event = Event(now, names, after, works, slips, (approach, e * approach), (pt, pn))
    # where there is no slip, rounding gives it some direction
    axes = [("normal", n)] + ([("tangent", t)] if speed else [])
    event.axes = {f"{name}_{axis}": x for name, vector in axes for axis, x in zip("xyz", vector)}
    return event


def follow_in_space(scene, law, impacts=None, duration=None):
    balls, now, events = list(scene.balls), ZERO, []
    fallen = [ZERO] * len(balls)
    while impacts is None or len(events) < impacts:
        if len(events) > 300:
            raise Unfit("too many impacts")
        soon = []
        for i, ball in enumerate(balls):
            found = [(meets_face(ball, face, now, scene.g), (i, face)) for face in scene.planes]
            found += [(meets_sphere(ball, balls[k]), (i, k)) for k in range(i + 1, len(balls))]
            soon += [pair for pair in found if pair[0] is not None]
        soon.sort(key=lambda pair: pair[0])
        if len(soon) > 1 and soon[1][0] - soon[0][0] < D(10) ** -9:
            raise Unfit("two impacts at once")
        if duration is not None and (not soon or now + soon[0][0] > duration):
            if soon and now + soon[0][0] - duration < D(10) ** -9:
                raise Unfit("an impact at the end")
            return Run(duration, [flown(ball, duration - now, scene.g) for ball in balls], events)
        if not soon:
            break
        t, who = soon[0]
        for i, ball in enumerate(balls):
            balls[i] = flown(ball, t, scene.g)
            fallen[i] += ball.m * scene.g * (ball.at[1] - balls[i].at[1])
        now += t
        event = collide(scene, law, who, now, balls)
        struck = [i for i in who if isinstance(i, int)]
        event.works["gravity_j"] = sum(fallen[i] for i in struck)
        for i in struck:
            fallen[i] = ZERO
        events.append(event)
    return Run(now, balls, events)
