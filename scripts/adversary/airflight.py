"""Flights in air, by power series in time: of order 18 in 40 digits, so that their error is nothing beside that of
any method that takes steps in floats."""

from dataclasses import replace
from decimal import Decimal as D
from decimal import localcontext

from simulator import HALF, PI, ZERO, Run, Unfit, collide

ORDER = 18
SMALL = D(10) ** -26
LOOKS = 16  # places in a step at which gaps are looked at


def series(scene, ball):
    """Coefficients of x, y, v_x, v_y and the work of the air."""
    density, drag, lift = scene.air
    by_mass = density * PI * ball.r**2 / (2 * ball.m)
    c, k = by_mass * drag, by_mass * lift * ball.r * ball.w
    vx, vy, s, q, work = [ball.v[0]], [ball.v[1]], [], [], [ZERO]
    for n in range(ORDER):
        s.append(sum(vx[i] * vx[n - i] + vy[i] * vy[n - i] for i in range(n + 1)))
        if n == 0:
            if s[0] < D("1e-6"):
                raise Unfit("hardly moves")
            q.append(s[0].sqrt())
        else:
            q.append((s[n] - sum(q[i] * q[n - i] for i in range(1, n))) / (2 * q[0]))
        ax = -c * sum(q[i] * vx[n - i] for i in range(n + 1)) - k * vy[n]
        ay = -c * sum(q[i] * vy[n - i] for i in range(n + 1)) + k * vx[n] - (scene.g if n == 0 else 0)
        vx.append(ax / (n + 1))
        vy.append(ay / (n + 1))
        work.append(-ball.m * c * sum(q[i] * s[n - i] for i in range(n + 1)) / (n + 1))
    x = [ball.at[0]] + [a / (n + 1) for n, a in enumerate(vx)]
    y = [ball.at[1]] + [a / (n + 1) for n, a in enumerate(vy)]
    return x, y, vx, vy, work


def at(coefficients, t):
    out = ZERO
    for a in reversed(coefficients):
        out = out * t + a
    return out


def moved(ball, path, t):
    x, y, vx, vy, _ = path
    return replace(ball, at=(at(x, t), at(y, t)), v=(at(vx, t), at(vy, t)))


def length_of_step(paths):
    h = D("0.25")
    while any(abs(a[-1]) * h ** (len(a) - 1) > SMALL for path in paths for a in path[:4]):
        h *= HALF
    return h


def gap_of(scene, who, paths, now):
    i, other = who
    x, y = paths[i][0], paths[i][1]
    if isinstance(other, int):
        u, v = paths[other][0], paths[other][1]
        reach = scene.balls[i].r + scene.balls[other].r
        return lambda t: ((at(x, t) - at(u, t)) ** 2 + (at(y, t) - at(v, t)) ** 2).sqrt() - reach
    px, py = other.through
    return lambda t: (
        (at(x, t) - px - other.v[0] * (now + t)) * other.n[0]
        + (at(y, t) - py - other.v[1] * (now + t)) * other.n[1]
        - scene.balls[i].r
    )


def first_in(gap, h, touching):
    low = ZERO
    if touching:
        low = h / 4096
        if gap(low) <= 0:
            raise Unfit("rests")
    for part in range(1, LOOKS + 1):
        high = h * part / LOOKS
        if high <= low:
            continue
        value = gap(high)
        if value < 0:
            for _ in range(100):
                middle = (low + high) * HALF
                low, high = (middle, high) if gap(middle) > 0 else (low, middle)
            return high
        low = high
    return None


def follow_in_air(scene, law, impacts, duration):
    with localcontext() as context:
        context.prec = 40
        return steps(scene, law, impacts, duration)


def steps(scene, law, impacts, duration):
    balls, now, events = list(scene.balls), ZERO, []
    last = [None] * len(balls)
    fallen, taken = [ZERO] * len(balls), [ZERO] * len(balls)
    pairs = [(i, k) for i in range(len(balls)) for k in range(i + 1, len(balls))]
    pairs += [(i, plane) for i in range(len(balls)) for plane in scene.planes]
    key = lambda who: (who[0], who[1] if isinstance(who[1], int) else who[1].name)
    while impacts is None or len(events) < impacts:
        paths = [series(scene, ball) for ball in balls]
        h = length_of_step(paths)
        if h < D("1e-7") or now > 60:
            raise Unfit("takes too many steps")
        if duration is not None:
            h = min(h, duration - now)
        soon = []
        for who in pairs:
            touching = last[who[0]] == key(who) and (not isinstance(who[1], int) or last[who[1]] == key(who))
            t = first_in(gap_of(scene, who, paths, now), h, touching)
            soon += [(t, who)] if t is not None else []
        soon.sort(key=lambda s: s[0])
        if len(soon) > 1 and soon[1][0] - soon[0][0] < D(10) ** -7:
            raise Unfit("two impacts at once")
        t = soon[0][0] if soon else h
        for i, path in enumerate(paths):
            before, balls[i] = balls[i], moved(balls[i], path, t)
            fallen[i] += before.m * scene.g * (before.at[1] - balls[i].at[1])
            taken[i] += at(path[4], t)
        now += t
        if not soon:
            if duration is not None and now >= duration:
                return Run(duration, balls, events)
            continue
        if duration is not None and duration - now < D(10) ** -7:
            raise Unfit("an impact at the end")
        who = soon[0][1]
        event = collide(scene, law, who, now, balls)
        if event.speeds[0] < D("1e-4"):
            raise Unfit("grazes")
        event.works |= {"gravity_j": ZERO, "air_j": ZERO}
        for i in who:
            if isinstance(i, int):
                event.works["gravity_j"] += fallen[i]
                event.works["air_j"] += taken[i]
                fallen[i] = taken[i] = ZERO
                last[i] = key(who)
        events.append(event)
    return Run(now, balls, events)
