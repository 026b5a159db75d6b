"""The published laws of impact, written once more from their formulas, in fractions: (p_t, p_n) of a planar contact.

Nothing is taken from the program. A square root is a fraction that is off by less than 10^-60 of it. A law that has no
answer gives None.
"""

from fractions import Fraction
from math import isqrt, lcm
from typing import NamedTuple

ZERO, ONE = Fraction(0), Fraction(1)
TINY = 200  # bits that a root and a bisection have


class Contact(NamedTuple):
    """u_t before, the speed of approach, the Delassus operator (W_tt, W_tn, W_nn), mu, e."""

    u: Fraction
    a: Fraction
    w: tuple
    mu: Fraction
    e: Fraction

    def after(self, p):
        """(u_t, u_n) after the impulse."""
        tt, tn, nn = self.w
        return self.u + tt * p[0] + tn * p[1], -self.a + tn * p[0] + nn * p[1]

    def gain(self, p):
        """The change of kinetic energy, p.(v + v')/2."""
        t, n = self.after(p)
        return (p[0] * (self.u + t) + p[1] * (n - self.a)) / 2

    @property
    def sign(self):
        return (self.u > 0) - (self.u < 0)


def root(x):
    """The square root, rounded down after TINY bits."""
    scale = max(0, 2 * TINY - x.numerator.bit_length() + x.denominator.bit_length()) + 2
    scale += scale % 2
    return Fraction(isqrt((x.numerator << scale) // x.denominator), 1 << (scale // 2))


def halved(low, high, is_below):
    """The whole number before the change, between one that is below what is looked for and one that is not."""
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if is_below(middle) else (low, middle)
    return low


def by_ratio(c, ratio):
    """Newton's restitution with p_t = ratio*p_n; None where no push does it."""
    _, tn, nn = c.w
    if nn + ratio * tn <= 0:
        return None
    normal = (1 + c.e) * c.a / (nn + ratio * tn)
    return ratio * normal, normal


def by_slip(c, slip):
    """Newton's restitution with this slip afterwards; None where it would pull."""
    tt, tn, nn = c.w
    right = slip - c.u, (1 + c.e) * c.a
    det = tt * nn - tn * tn
    p = (right[0] * nn - right[1] * tn) / det, (right[1] * tt - right[0] * tn) / det
    return p if p[1] >= 0 else None


def kane_levinson(c):
    p = by_slip(c, ZERO)
    if p and abs(p[0]) <= c.mu * p[1]:
        return p
    for side in (1, -1):
        p = by_ratio(c, -side * c.mu)
        if p and c.after(p)[0] * side > 0:
            return p
    return None


def whittaker_uncapped(c):
    return by_ratio(c, -c.sign * c.mu)


def slides_or_ends(c, share):
    """Sliding forwards all the time, unless that would end below -share of the slip: then with just that."""
    p = by_ratio(c, -c.sign * c.mu)
    if p and c.after(p)[0] * c.sign >= -share * abs(c.u):
        return p
    return by_slip(c, -share * c.u)


def brach(c):
    p = by_ratio(c, -c.sign * c.mu)
    return p if p and c.gain(p) <= 0 else None


def smith_printed(c):
    return by_ratio(c, -c.sign * c.mu * Fraction(2, 5))


def given_k(c, k):
    return (k - 1) * c.u / c.w[0], (1 + c.e) * c.a / c.w[2]


def keller_printed(c):
    if c.w[1]:
        return None
    if not c.u:
        return given_k(c, ONE)
    alpha = c.w[0] * c.mu * (1 + c.e) * c.a / c.w[2] / (2 * abs(c.u))
    return given_k(c, 1 - 4 * alpha / 3 if alpha <= Fraction(3, 4) else Fraction(1, 2) - 2 * alpha / 3)


def wang_su_li(c):
    """p_t = -mu*p_n*(1 + k)/2, a quadratic equation in k."""
    tt, tn, nn = c.w
    if not c.u:
        return by_ratio(c, ZERO) if not tn else None
    m, a = c.mu * c.sign, (1 + c.e) * c.a
    square, line = -c.u * m * tn / 2, c.u * nn + tt * m * a / 2
    rest = -c.u * nn + c.u * m * tn / 2 - tn * a + tt * m * a / 2
    if not square:
        ks = [-rest / line]
    else:
        under = line * line - 4 * square * rest
        if under < 0:
            return None
        ks = [(-line + side * root(under)) / (2 * square) for side in (1, -1)]
    found = [p for p in (by_ratio(c, -m * (1 + k) / 2) for k in ks) if p]
    return found[0] if len(found) == 1 else None


def smith_1991(c):
    """p_t = -mu*p_n*(v|v| + v'|v'|)/(v^2 + v'^2): k by bisection, where every such ratio pushes."""
    tt, tn, nn = c.w
    if not c.u:
        return by_ratio(c, ZERO) if not tn else None
    if c.mu * abs(tn) >= nn:
        return None

    # k of what k makes of the slip: whole numbers of the sign of k - v'(k)/v, for multiples of one unit
    m, gain = c.sign * c.mu, (1 + c.e) * c.a / c.u
    terms = nn, m * tn, gain * m * tt, gain * tn
    scale = lcm(*(x.denominator for x in terms))
    normal, across, along, lift = (int(x * scale) for x in terms)
    one = 1 << TINY

    def misses(k):
        ratio, squares = one * one + k * abs(k), one * one + k * k
        return (k - one) * (normal * squares - across * ratio) - one * (lift * squares - along * ratio)

    low, high = -one, one
    while misses(low) > 0:
        low *= 2
    while misses(high) < 0:
        high *= 2
    k = Fraction(halved(low, high, lambda k: misses(k) < 0), one)
    return by_ratio(c, -m * (1 + k * abs(k)) / (1 + k * k))


def process(c, hypothesis):
    """Coulomb's friction at every moment of the impulse, which grows from 0: at most two phases (length, slope of p_t)."""
    tt, tn, nn = c.w
    side = c.sign or ((tn > 0) - (tn < 0)) or 1
    first = -c.mu * side
    speeding = side * (tt * first + tn)
    stuck = abs(tn) <= c.mu * tt
    second = -tn / tt if stuck else (-c.mu if tn > 0 else c.mu)
    phases = [(None, first)] if speeding >= 0 else [(abs(c.u) / -speeding, first), (None, second)]
    # compression ends where v_n = 0; its work, and how far the phase was gone through
    speed, tangential, normal, work = -c.a, ZERO, ZERO, ZERO
    ended = None
    for length, slope in phases:
        rate = nn + tn * slope
        gone = ZERO
        while True:
            if ended is None:
                wanted = -speed / rate if rate > 0 else None
            else:
                wanted = hypothesis(ended, normal, speed, rate, work) if rate > 0 else None
            left = None if length is None else length - gone
            if wanted is None and left is None:
                return None
            last = wanted is None or (left is not None and left < wanted)
            step = left if last else wanted
            work += step * (2 * speed + rate * step) / 2
            speed, tangential, normal = speed + rate * step, tangential + slope * step, normal + step
            gone += step
            if last:
                break
            if ended is not None:
                return tangential, normal
            ended, work = (c, normal, work), ZERO
    return None


def poisson(ended, normal, *_):
    c, compression, _ = ended
    return max(ZERO, (1 + c.e) * compression - normal)


def newton(ended, normal, speed, rate, work):
    c = ended[0]
    return max(ZERO, (c.e * c.a - speed) / rate)


def energetic(ended, normal, speed, rate, work):
    """work + speed*x + rate*x^2/2 = e^2 of what compression took."""
    c, _, taken = ended
    missing = -c.e * c.e * taken - work
    return max(ZERO, (root(speed * speed + 2 * rate * missing) - speed) / rate) if missing > 0 else ZERO


def routh_newton(c):
    return process(c, newton)


def djerassi_newton(c):
    p = process(c, newton)
    return p if p and c.gain(p) <= 0 else None


def keller_1986(c):
    return process(c, poisson)


def stronge_1990(c):
    return process(c, energetic)


def chatterjee_ruina(c, e_t=ZERO):
    tt, tn, nn = c.w
    det = tt * nn - tn * tn
    smooth = ZERO, c.a / nn
    stick = (-c.u * nn - c.a * tn) / det, (c.a * tt + c.u * tn) / det
    e, t = 1 + c.e, 1 + e_t
    p = [e * smooth[k] + t * (stick[k] - smooth[k]) for k in (0, 1)]
    if abs(p[0]) <= c.mu * p[1]:
        return tuple(p)
    kappa = c.mu * e * smooth[1] / (abs(stick[0]) - c.mu * (stick[1] - smooth[1]))
    return kappa * stick[0], e * smooth[1] + kappa * (stick[1] - smooth[1])


BETA = Fraction(11, 25)


def about_a_turned_normal(c, half, towards, of_approach):
    """Chatterjee and Ruina's formula with e_t = beta0 about a normal that is turned by 2*atan(half) along the slip, or
    against it; `of_approach` says that e is by the approach along the old normal."""
    if not c.u:
        return by_ratio(c, ZERO) if not c.w[1] else None
    cos, sin = (1 - half * half) / (1 + half * half), 2 * half / (1 + half * half)
    if c.mu * sin > cos:
        return None
    sin *= c.sign * towards  # n' = cos*n + sin*t, t' = cos*t - sin*n
    tt, tn, nn = c.w
    turned = (
        cos * cos * tt - 2 * cos * sin * tn + sin * sin * nn,
        cos * sin * (tt - nn) + (cos * cos - sin * sin) * tn,
        sin * sin * tt + 2 * cos * sin * tn + cos * cos * nn,
    )
    u, a = cos * c.u + sin * c.a, cos * c.a - sin * c.u
    if a <= 0:
        return None
    t, n = chatterjee_ruina(Contact(u, a, turned, c.mu, c.e * c.a / a if of_approach else c.e), BETA)
    p = cos * t + sin * n, cos * n - sin * t
    return p if of_approach or c.after(p)[1] >= 0 else None


def tilted(c):
    return about_a_turned_normal(c, Fraction(1, 10), -1, False)


def saitoh(c):
    return about_a_turned_normal(c, Fraction(1, 5), 1, True)


LAWS = {
    "wang-su-li": wang_su_li,
    "whittaker-uncapped": whittaker_uncapped,
    "whittaker-stop": lambda c: slides_or_ends(c, ZERO),
    "routh-newton": routh_newton,
    "garwin": lambda c: by_slip(c, -c.u),
    "garwin-capped": lambda c: slides_or_ends(c, ONE),
    "kane-levinson": kane_levinson,
    "brach": brach,
    "keller-1986": keller_1986,
    "keller-printed": keller_printed,
    "stronge-1990": stronge_1990,
    "smith-1991": smith_1991,
    "smith-printed": smith_printed,
    "walton": lambda c: slides_or_ends(c, BETA),
    "chatterjee-ruina": chatterjee_ruina,
    "tilted-2002": tilted,
    "tilted-2004": tilted,
    "djerassi-newton": djerassi_newton,
    "djerassi-poisson": keller_1986,
    "djerassi-stronge": stronge_1990,
    "saitoh": saitoh,
}
# Restitution of these is not Newton's along the normal of the log.
NOT_NEWTON = {
    "keller-1986", "djerassi-poisson", "stronge-1990", "djerassi-stronge", "tilted-2002", "tilted-2004", "saitoh",
}  # fmt: skip
