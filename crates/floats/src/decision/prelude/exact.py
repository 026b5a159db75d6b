from fractions import Fraction


def exact_sign(x):
    return (x > 0) - (x < 0)


def root_sign(a, b, norm):
    """The sign of a + b*sqrt(c), of those of a, b and a^2 - b^2*c."""
    if b == 0 or a == b:
        return a
    return a if norm > 0 else b if norm < 0 else 0


# half an ulp of 1; more than a few roundings of a bound lose; more than a few underflows
HALF = 1.1102230246251565e-16
MORE = 1.0000000000000036
TINY = 1e-310
