"""An independent simulator of scenes, written from `docs/scene-format.md` alone: 50 decimal digits, times of
impacts by bisection, and every wall, upright or not, as one kind of thing.
"""

from dataclasses import dataclass, field, replace
from decimal import Decimal as D
from decimal import getcontext

getcontext().prec = 50
ZERO, ONE, TWO, HALF = D(0), D(1), D(2), D("0.5")
TINY = D(10) ** -42
PI = D("3.14159265358979323846264338327950288419716939937510582")


class Unfit(Exception):
    """What happens is nothing that two programs need agree on: a tie, a graze, bodies that rest."""


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def sign(x):
    return (x > 0) - (x < 0)


@dataclass
class Ball:
    """A round body; SI units, spin from x to y."""

    m: D
    j: D
    r: D
    at: tuple
    v: tuple
    w: D

    def energy(self):
        return HALF * (self.m * dot(self.v, self.v) + self.j * self.w**2)


@dataclass
class Plane:
    """A wall: unit normal into the room, a point of it at time 0, and its velocity."""

    name: str
    n: tuple
    through: tuple
    v: tuple = (ZERO, ZERO)


@dataclass
class Scene:
    """What is followed. `mu(who)` and `e(who, speed)` are of a pair of names."""

    balls: list
    planes: list
    g: D
    mu: object
    e: object
    share: D = None  # of the slip that comes back
    rolling: D = ZERO
    air: tuple = None  # density, drag, lift
    corners: list = None  # of the only body, from its centre at the start


@dataclass
class Event:
    time: D
    who: tuple
    after: list
    works: dict
    slip: tuple
    speeds: tuple
    impulse: tuple


@dataclass
class Run:
    time: D
    balls: list
    events: list = field(default_factory=list)


# laws: the tangential impulse, from slip, mobility, μ·p_n and the share of the slip that comes back


def normal_only(u, w, most, share):
    return ZERO


def full(u, w, most, share):
    return -sign(u) * most


def wang_su_li(u, w, most, share):
    if u == 0:
        return ZERO
    alpha = w * most / (2 * abs(u))
    return ((1 - alpha) / (1 + alpha) - 1) * u / w


def coulomb(u, w, most, share):
    stop = -u / w
    return stop if abs(stop) <= most else -sign(u) * most


def grip(u, w, most, share):
    back = -(1 + share) * u / w
    return back if abs(back) <= most else -sign(u) * most


LAWS = {
    "normal-only": normal_only,
    "whittaker-uncapped": full,
    "wang-su-li": wang_su_li,
    "routh-newton": coulomb,
    "walton": grip,
}


def bisect(f, low, high):
    """Where f falls through 0."""
    for _ in range(190):
        middle = (low + high) * HALF
        if f(middle) > 0:
            low = middle
        else:
            high = middle
    return high


def first_fall(f, turns, falls_at_last):
    """The first t > 0 at which f, monotone between its turns, falls through 0. `falls_at_last`: beyond them."""
    ends = [ZERO] + sorted(t for t in turns if t > 0)
    for low, high in zip(ends, ends[1:]):
        if f(high) < 0 and f(low) >= 0:
            return bisect(f, low, high)
    low = ends[-1]
    if not falls_at_last or f(low) < 0:
        return None
    step = ONE
    while f(low + step) >= 0:
        step *= 2
        if step > D(10) ** 9:
            return None
    return bisect(f, low, low + step)


def meets_plane(ball, plane, now, g):
    d = [ball.at[k] - plane.through[k] - plane.v[k] * now for k in (0, 1)]
    gap = dot(d, plane.n) - ball.r
    speed = dot([ball.v[k] - plane.v[k] for k in (0, 1)], plane.n)
    pull = -g * plane.n[1]
    if abs(gap) < TINY:
        gap = ZERO
        if abs(speed) < D(10) ** -33 and pull < 0:
            raise Unfit("rests")
        if speed < 0:
            return ZERO
    f = lambda t: gap + t * (speed + HALF * pull * t)
    if pull:
        turn = -speed / pull
        if turn > 0 and pull > 0 and abs(f(turn)) < D(10) ** -9:
            raise Unfit("grazes")
        return first_fall(f, [turn], pull < 0)
    return first_fall(f, [], speed < 0)


def meets_ball(a, b):
    d = (a.at[0] - b.at[0], a.at[1] - b.at[1])
    w = (a.v[0] - b.v[0], a.v[1] - b.v[1])
    reach = a.r + b.r
    if dot(d, w) >= 0:
        return None
    closest = -dot(d, w) / dot(w, w)
    f = lambda t: (d[0] + w[0] * t) ** 2 + (d[1] + w[1] * t) ** 2 - reach**2
    if abs(f(closest)) < D(10) ** -9 * reach**2:
        raise Unfit("grazes")
    if f(ZERO) <= 0:
        return ZERO
    return first_fall(f, [closest], False)


def fly(ball, t, g):
    at = (ball.at[0] + ball.v[0] * t, ball.at[1] + t * (ball.v[1] - HALF * g * t))
    return replace(ball, at=at, v=(ball.v[0], ball.v[1] - g * t))


def mobility(ball, arm):
    """The matrix that takes an impulse at an arm from the centre to the velocity of the point there."""
    a = (-arm[1], arm[0])
    return [[(i == k) / D(ball.m) + a[i] * a[k] / ball.j for k in (0, 1)] for i in (0, 1)]


def pushed(ball, arm, p):
    v = (ball.v[0] + p[0] / ball.m, ball.v[1] + p[1] / ball.m)
    return replace(ball, v=v, w=ball.w + (arm[0] * p[1] - arm[1] * p[0]) / ball.j)


def collide(scene, law, who, now, balls):
    """Sends the balls of `who` through their impact; what is said of it."""
    first, second = who
    a = balls[first]
    if isinstance(second, int):
        b = balls[second]
        d = (a.at[0] - b.at[0], a.at[1] - b.at[1])
        length = dot(d, d).sqrt()
        n = (d[0] / length, d[1] / length)
        arms = [(first, (-a.r * n[0], -a.r * n[1]), 1), (second, (b.r * n[0], b.r * n[1]), -1)]
        wall = (ZERO, ZERO)
    else:
        n, wall = second.n, second.v
        arms = [(first, (-a.r * n[0], -a.r * n[1]), 1)]
    t = (n[1], -n[0])
    relative, w = [-wall[0], -wall[1]], [[ZERO, ZERO], [ZERO, ZERO]]
    for index, arm, way in arms:
        ball = balls[index]
        relative[0] += way * (ball.v[0] - ball.w * arm[1])
        relative[1] += way * (ball.v[1] + ball.w * arm[0])
        m = mobility(ball, arm)
        w = [[w[i][k] + m[i][k] for k in (0, 1)] for i in (0, 1)]
    of = lambda x, y: sum(x[i] * w[i][k] * y[k] for i in (0, 1) for k in (0, 1))
    slip, approach = dot(relative, t), -dot(relative, n)
    names = names_of(who)
    e = scene.e(names, approach)
    pn = (1 + e) * approach / of(n, n)
    pt = law(slip, of(t, t), scene.mu(names) * pn, scene.share)
    p = [pt * t[k] + pn * n[k] for k in (0, 1)]
    works = {"normal_j": ZERO, "tangential_j": ZERO, "rotational_j": ZERO}
    for index, arm, way in arms:
        before = balls[index]
        push = [way * p[0], way * p[1]]
        after = balls[index] = pushed(before, arm, push)
        mean = [HALF * (before.v[k] + after.v[k]) for k in (0, 1)]
        works["normal_j"] += dot(mean, n) * dot(push, n)
        works["tangential_j"] += dot(mean, t) * dot(push, t)
        works["rotational_j"] += HALF * before.j * (after.w**2 - before.w**2)
    after = [balls[index] for index, _, _ in arms]
    return Event(now, names, after, works, (slip, slip + of(t, t) * pt), (approach, e * approach), (pt, pn))


def names_of(who):
    first, second = who
    return (f"body-{first + 1}", f"body-{second + 1}" if isinstance(second, int) else second.name)


def follow(scene, law, impacts=None, duration=None, rest=False):
    """The motion, up to so many impacts, a time, or until a ball rests on the floor."""
    if scene.air:
        from airflight import follow_in_air

        return follow_in_air(scene, law, impacts, duration)
    balls, now, events = list(scene.balls), ZERO, []
    fallen = [ZERO] * len(balls)
    falls = single_ball_on_floor(scene)
    while impacts is None or len(events) < impacts:
        if len(events) > 3000:
            raise Unfit("too many impacts")
        if falls and abs(balls[0].v[1]) < D(10) ** -30 and lies(scene, balls[0]):
            # what is left of the bouncing is nothing: it lies
            balls[0] = replace(balls[0], v=(balls[0].v[0], ZERO))
            if rest:
                return Run(now, balls, events)
            if impacts is not None:
                raise Unfit("comes to rest")
            return Run(duration, [creep(scene, balls[0], duration - now)], events)
        soon = []
        for i, ball in enumerate(balls):
            for plane in scene.planes:
                t = meets_plane(ball, plane, now, scene.g)
                soon += [(t, (i, plane))] if t is not None else []
            for k in range(i + 1, len(balls)):
                t = meets_ball(ball, balls[k])
                soon += [(t, (i, k))] if t is not None else []
        soon.sort(key=lambda s: s[0])
        if len(soon) > 1 and soon[1][0] - soon[0][0] < D(10) ** -9:
            raise Unfit("two impacts at once")
        if duration is not None and (not soon or now + soon[0][0] > duration):
            if soon and now + soon[0][0] - duration < D(10) ** -9:
                raise Unfit("an impact at the end")
            return Run(duration, [fly(ball, duration - now, scene.g) for ball in balls], events)
        if not soon:
            if rest:
                raise Unfit("never rests")
            break
        t, who = soon[0]
        for i, ball in enumerate(balls):
            balls[i] = fly(ball, t, scene.g)
            fallen[i] += ball.m * scene.g * (ball.at[1] - balls[i].at[1])
        now += t
        event = collide(scene, law, who, now, balls)
        event.works["gravity_j"] = ZERO
        for i in who:
            if isinstance(i, int):
                event.works["gravity_j"] += fallen[i]
                fallen[i] = ZERO
        events.append(event)
    return Run(now, balls, events)


def single_ball_on_floor(scene):
    one = len(scene.balls) == len(scene.planes) == 1 and scene.g > 0
    return one and scene.planes[0].name == "floor"


def lies(scene, ball):
    return abs(ball.at[1] - ball.r - scene.planes[0].through[1]) < D(10) ** -20


def creep(scene, ball, left):
    """On the floor: friction until it rolls, then rolling resistance until it stops. The share of the slip that
    comes back is none on a ball that lies."""
    mu = scene.mu(("body-1", "floor"))
    g, q = scene.g, ball.m * ball.r**2 / ball.j
    x, v, w = ball.at[0], ball.v[0], ball.w
    slip = v + w * ball.r
    if abs(slip) < D(10) ** -30:
        slip = ZERO
    if slip:
        if mu == 0:
            return replace(ball, at=(x + v * left, ball.at[1]))
        s = sign(slip)
        t = min(left, abs(slip) / (mu * g * (1 + q)))
        x += t * (v - s * mu * g * t / 2)
        v -= s * mu * g * t
        w -= s * mu * g * t * q / ball.r
        left -= t
    if left > 0 and scene.rolling and v:
        s, slowing = sign(v), scene.rolling * g * q / (1 + q)
        t = min(left, abs(v) / slowing)
        x += t * (v - s * slowing * t / 2)
        v = v - s * slowing * t if t < abs(v) / slowing else ZERO
        w = -v / ball.r
        left -= t
    return replace(ball, at=(x + v * left, ball.at[1]), v=(v, ZERO), w=w)
