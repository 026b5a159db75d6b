"""What `mixed.py` says: symbols, claims of the books, derivatives and limits."""

CLAIMS = 9
DECLARED = "x, y, z, b, e, i, k > 0, m > 0, L > 0, 0 < s < L, n in N, theta, 0 < phi < pi/2, t, f(t)"

BOOK = [
    "exp(x) >= 1 + x", "exp(x) > 0", "exp(-k*x)*exp(k*x) = 1", "exp(x/2)^2 = exp(x)", "log(k) <= k - 1", "log(k*m) = log(k) + log(m)",
    "exp(x) + exp(-x) >= 2", "q > 0", "q*exp(k*x) = 1", "exp(log(k)) = k", "log(exp(x)) = x", "exp(x^2) >= 1", "exp(-x^2) <= 1",
    "sin(phi) <= phi", "sin(phi) < phi", "sin(phi) > 0", "cos(phi) > 0", "phi < 1571/1000", "phi > 0", "sin(theta)^2 + cos(theta)^2 = 1",
    "abs(sin(theta)) <= abs(theta)", "cos(theta) >= 1 - theta^2/2", "sin(2*theta) = 2*sin(theta)*cos(theta)", "tan(phi) > phi",
    "s < L", "s*k < L*k", "s/L < 1", "s^2 < L^2", "h(x) >= 0", "h(x) < 1", "h(exp(x)) < 1", "w(x, y) >= 0", "w(x, y) = abs(x - y)",
    "w(1/x, 0) > 0", "r > 0", "r <= exp(x)", "r <= phi*exp(x)", "sum(x^j for j in 0..3) = (1 + x)*(1 + x^2)", "sum(j for j in 1..4) = 10",
    "sum(j for j in 3..2) = 0", "prod(j for j in 3..2) = 1", "sum(j*x for j in -2..2) = 0", "sum(sum(j*l for l in 1..2) for j in 1..2) = 9",
    "sum(exp(x)^j for j in 1..2) > 0", "sum(e^j for j in 0..0) = 1", "e^2 >= 0", "i^2 + e^2 >= 2*i*e", "1/x > 0 implies x > 0", "x = 0 or 1/x^2 > 0",
    "x > y or x <= y", "x > 0 and y > 0 implies x*y > 0", "exp(x) = 1 iff exp(-x) = 1", "max(x, y) >= x", "min(x, y) <= (x + y)/2",
    "exp(s) > 1", "exp(-s*k) < 1", "exp(s/L) > 1", "exp(s/L) >= 1 + s/L", "log(1*k^2) = 2*log(k)", "x*exp(x) >= x", "k*log(k) >= k - 1",
    "2^-1^2 = 1/2", "-2^2 = -4", "x/2*2 = x", "exp(x) >= (1 + x/2)^2 or x < -2", "sqrt(x^2) = abs(x)", "sqrt(exp(2*x)) = exp(x)",
]

SLOPES = [
    ("exp(k*x)", "x", "k*exp(k*x)"), ("exp(-k*x)", "k", "-x*exp(-k*x)"), ("x*exp(x)", "x", "(1 + x)*exp(x)"), ("q", "x", "-k*q"),
    ("exp(x)*sin(theta)", "theta", "exp(x)*cos(theta)"), ("theta*sin(theta)", "theta", "sin(theta) + theta*cos(theta)"),
    ("log(k)*k", "k", "log(k) + 1"), ("h(x)", "x", "2*x/(1 + x^2)^2"), ("sum(x^j for j in 0..3)", "x", "1 + 2*x + 3*x^2"),
    ("exp(x*y)", "y", "x*exp(x*y)"), ("r", "x", "r"), ("r", "phi", "cos(phi)*exp(x)"), ("exp(k/m)", "m", "-k/m^2*exp(k/m)"),
    ("d(exp(k*x), x)", "x", "k^2*exp(k*x)"), ("d(x*y, x)", "y", "1"), ("exp(x)/k", "k", "-exp(x)/k^2"), ("log(k*m)", "m", "1/m"),
]

FAR = {  # givens for limits in t
    "law": "f = 1/(1 + exp(t))", "curved": "exp(t) >= 1 + t + t^2", "touching": "exp(t) = 1 + t", "great": "exp(t) > 5", "small": "t < 2",
    "low": "exp(-t) <= 1 - t + t^2", "right": "t >= 0",
}

LIMITS = [  # the form, the point, the value, and how it is computed
    ("exp(-t)", "oo", "0", lambda f, t: f["exp"](-t)), ("(exp(t) - 1)/t", "0", "1", lambda f, t: (f["exp"](t) - 1) / t),
    ("(1 - exp(-2*t))/t", "0", "2", lambda f, t: (1 - f["exp"](-2 * t)) / t), ("exp(t)", "-oo", "0", lambda f, t: f["exp"](t)),
    ("exp(t)/(1 + exp(t))", "oo", "1", lambda f, t: 1 / (1 + f["exp"](-t))), ("h(t)", "oo", "1", lambda f, t: 1 - 1 / (1 + t * t)),
    ("sum(t^j for j in 0..2)/t^2", "oo", "1", lambda f, t: 1 + 1 / t + 1 / t**2), ("w(t, 0)/t", "0+", "1", lambda f, t: 1),
    ("t*exp(-t/2)^2", "oo", "0", lambda f, t: t * f["exp"](-t)), ("exp(t)", "0", "1", lambda f, t: f["exp"](t)),
    ("1/t", "0+", "oo", lambda f, t: 1 / t), ("(exp(t) - exp(-t))/t", "0", "2", lambda f, t: (f["exp"](t) - f["exp"](-t)) / t),
    ("f", "oo", "0", lambda f, t: 1 / (1 + f["exp"](t))), ("f", "-oo", "1", lambda f, t: 1 / (1 + f["exp"](t))),
    ("f", "0", "1/2", lambda f, t: 1 / (1 + f["exp"](t))), ("f", "0", "1/2", lambda f, t: 1 / (1 + f["exp"](t))),
    ("exp(t) - 1 - t", "0+", "0", lambda f, t: f["exp"](t) - 1 - t), ("(exp(t) - 1 - t)/t^2", "0+", "1/2", lambda f, t: (f["exp"](t) - 1 - t) / t**2),
]
