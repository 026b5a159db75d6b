"""Families with functions of the limit variable: premised limits, ranges, and chains of citing.

The structure comes first: constants with values and functions written out. The givens are true in it
in the sense of rule 5 of the language page, that is, at every point of their ranges; outside of its
ranges a function is what the generator likes. Claims are random. So whatever is proved has to be true
in the structure, and no contradiction can be.
"""

from fractions import Fraction

from chance import nonzero, positive, small
from document import Document, Limit, Structure
from expr import ONE, ZERO, add, cases, div, mul, num, power, sub, substitute, var
from limits import reachable, start
from point import Ambiguous, Undefined
from structure import given_true, lies_in_domain, limit_of, sides

CLAIMS = 14


class World:
    """The document under construction with its structures, and what each given is about."""

    def __init__(self, d, x, constants, rng):
        self.d, self.x, self.constants, self.rng = d, x, constants, rng
        self.laws = {}  # function -> [(label, expression, relations of its region)]
        self.about = {}  # label -> set of functions
        self.narrow = []  # (label, relations)
        self.limited = []  # (label, limit, function)
        self.constant = []
        self.claims = []  # labels of pointwise claims, for citing
        self.targets = []  # labels of limit claims


def formula(rng, x, constants):
    """Something simple in x, and now and then in a constant."""
    X = var(x)
    c = var(rng.choice(constants)) if constants and rng.random() < 0.3 else num(small(rng))
    b = num(small(rng))
    return rng.choice([
        X, X, add(X, b), sub(b, X), mul(c, X), add(mul(c, X), b), c, power(X, 2), sub(power(X, 2), b), sub(ONE, X),
        div(c, X), add(c, div(ONE, X)), div(X, add(power(X, 2), ONE)), div(add(X, b), sub(X, num(nonzero(rng)))),
        div(ONE, add(power(X, 2), ONE)), ("abs", X), ("min", X, b), ("max", X, c), mul(X, sub(X, b)),
    ])


def region(rng, x):
    """Relations on x alone."""
    X, a = var(x), small(rng)
    b = a + positive(rng)
    return rng.choice([
        [("<", num(a), X), ("<", X, num(b))], [("<", num(a), X), ("<", X, num(b))], [("<=", num(a), X), ("<=", X, num(b))],
        [(">", X, num(a))], [("<", X, num(a))], [(">=", X, num(a))], [("<=", X, num(a))], [("!=", X, num(a))], [("<", power(X, 2), num(positive(rng) ** 2))],
        [("<", ("abs", X), num(positive(rng)))], [(">", div(ONE, X), ZERO)], [("<", sub(power(X, 2), num(1)), ZERO)], [("=", X, num(a))],
    ])


def poles(e):
    """Conditions under which a formula of this file is undefined."""
    from expr import walk

    return [("=", node[2], ZERO) for node in walk(e) if node[0] == "/" and node[2][0] != "n"]


def made_total(e, rng):
    """The formula, with a value of its own where it has a pole."""
    holes = list(dict.fromkeys(poles(e)))
    return cases([([h], num(small(rng))) for h in holes], e) if holes else e


def world(family, rng):
    d, x, constants = start(family, rng, rng.choice([1, 1, 2]))
    w = World(d, x, constants, rng)
    functions = rng.sample(["f", "g", "h", "k"], rng.choice([1, 2, 2, 3]))
    written, pending = {}, []
    for i, f in enumerate(functions):
        lower = None
        r = rng.random()
        if i and r < 0.4:
            # tied to an earlier one
            other = rng.choice(functions[:i])
            tie, e, outside = tied(rng, x, f, other)
            written[f] = made_total(substitute(e, {other: written[other]}), rng) if not outside else cases([(outside, num(small(rng)))], substitute(e, {other: written[other]}))
            pending.append((f, other, [tie], ("total", outside)))
        elif r < 0.7:
            # one law everywhere where it can hold
            e = formula(rng, x, constants)
            written[f] = made_total(e, rng)
            pending.append((f, e, [], [("=", var(f), e)]))
            if rng.random() < 0.15 and not poles(e):
                # a bound of the declaration narrows the range of the law
                lower = (small(rng), rng.random() < 0.5)
                op = ">" if lower[1] else ">="
                written[f] = cases([([(op, written[f], num(lower[0]))], written[f])], num(lower[0] + positive(rng)))
        else:
            # one law in a region, something else outside
            where, e, other = region(rng, x), formula(rng, x, constants), made_total(formula(rng, x, constants), rng)
            links = list(where)
            if rng.random() < 0.3:
                # a region that is told by the function itself
                where = [(rng.choice(["<", "<=", ">", ">="]), e, num(small(rng)))]
                links = [(op, var(f), b) for op, _, b in where]
            guards = [([h], other) for h in dict.fromkeys(poles(e))]
            written[f] = cases(guards + [(region_guard(where, x), e)], other)
            links.insert(rng.choice([0, len(links)]), ("=", var(f), e))
            pending.append((f, e, where, links))
        d.declare(f, x, lower)
    make_structures(w, written)
    if not d.structures:
        return None
    for entry in pending:
        state_law(w, entry)
    return w


def region_guard(where, x):
    """`1/x > 0` is undefined at 0, where a guard may not be; so it is asked for x > 0 instead."""
    return [(">", var(x), ZERO) if a == div(ONE, var(x)) else (op, a, b) for op, a, b in where]


def tied(rng, x, f, other):
    """A relation between two functions, what it makes of the first, and where it cannot hold."""
    X, F, G = var(x), var(f), var(other)
    zero = [("=", X, ZERO)]
    return rng.choice([
        (("=", F, add(G, X)), add(G, X), []), (("=", F, mul(G, X)), mul(G, X), []), (("=", F, div(G, X)), div(G, X), zero),
        (("=", F, G), G, []), (("=", sub(G, F), ONE), sub(G, ONE), []), (("=", F, ("abs", G)), ("abs", G), []),
        (("=", F, ("min", G, X)), ("min", G, X), []), (("<=", F, G), sub(G, power(X, 2)), []), ((">", F, G), add(G, ONE), []),
        (("=", div(F, X), G), mul(X, G), zero),
    ])


def make_structures(w, written):
    """The same functions for several values of the constants."""
    from chance import small as value

    d = w.d
    by_name = {v.name: v for v in d.vars}
    for _ in range(4):
        constants = {}
        for c in w.constants:
            pool = [v for v in [value(w.rng) for _ in range(5)] + [Fraction(1)] if by_name[c].allows(v)]
            constants[c] = w.rng.choice(pool or [by_name[c].lower[0] + 1 if by_name[c].lower else Fraction(0)])
        s = Structure(w.x, constants, written)
        if lies_in_domain(d, s):
            d.structures.append(s)


def state_law(w, entry):
    rng, d = w.rng, w.d
    if len(entry) == 4 and entry[3][0] == "total":
        f, other, links, truth = entry
        label = d.given(links, truth=truth)
        w.about[label] = {f, other}
        w.laws.setdefault(f, []).append((label, links[0][2], []))
        return
    f, e, where, links = entry
    if where and rng.random() < 0.2:
        label = d.given([("=", var(f), e)], where, truth=("determined", {f: e}))
    else:
        label = d.given(links, truth=("determined", {f: e}))
    w.about[label] = {f}
    w.laws.setdefault(f, []).append((label, e, where))


def state_more(w):
    """Narrowings, constants, premised limits that are true in the first structure."""
    rng, d, x = w.rng, w.d, w.x
    for _ in range(rng.choice([1, 2, 3])):
        where = region(rng, x)
        links = list(where)
        truth = ("narrow",)
        if rng.random() < 0.15 and w.constants:
            c = rng.choice(w.constants)
            links.append(("=", var(c), num(d.structures[0].constants[c])))
        w.narrow.append((d.given(links, truth=truth), where))
    if w.constants and rng.random() < 0.5:
        c = rng.choice(w.constants)
        v = d.structures[0].constants[c]
        link = rng.choice([("=", var(c), num(v)), (">=", var(c), num(v)), ("<", var(c), num(v + positive(rng)))])
        w.constant.append(d.given([link], truth=("const",)))
    functions = [v.name for v in d.vars if v.argument]
    for _ in range(rng.choice([1, 2, 3])):
        f = rng.choice(functions)
        point, side = reachable(rng, d, x)
        e = rng.choice([var(f), var(f), div(var(f), var(x)), mul(var(x), var(f)), sub(var(f), var(x))])
        limit = Limit(e, ZERO, x, point, side)
        found = {limit_of(e, d, d.structures[0], s) for s in sides(d, x, limit)}
        if len(found) != 1:
            continue
        v = found.pop()
        if not isinstance(v, (Fraction, str)) or v == "unknown":
            continue
        if isinstance(v, str):
            limit.target = "oo" if v == "+oo" else "-oo"
        else:
            same = [c for c in w.constants if d.structures[0].constants[c] == v]
            if not same and w.constants and rng.random() < 0.7:
                same = [retuned(w, v)]
            limit.target = var(same[0]) if same and same[0] and rng.random() < 0.8 else num(v)
        label = d.given([limit], truth=("limit",))
        if given_true(d.find(label), d, d.structures[0]) is not True:
            withdraw(d, label)
            continue
        w.about[label] = {f}
        w.limited.append((label, limit, f))


def retuned(w, v):
    """A constant of which nothing depends is given the value of a limit."""
    from expr import walk

    d = w.d
    used = {n[1] for e in d.structures[0].functions.values() for n in walk(e) if n[0] == "v"}
    for s in d.statements:
        for r in s.links + s.when:
            parts = r[1:] if isinstance(r, tuple) else [r.f] + ([] if isinstance(r.target, str) else [r.target])
            used |= {n[1] for e in parts for n in walk(e) if n[0] == "v"}
    for c in w.constants:
        bound = next(u for u in d.vars if u.name == c)
        if c not in used and bound.allows(v):
            d.structures[0].constants[c] = v
            d.structures[0].__dict__.pop("truths", None)
            return c
    return None


def withdraw(d, label):
    statement = d.find(label)
    d.statements.remove(statement)
    d.order.remove(("statement", statement))


def related(w, f, many):
    """Labels that speak of a function, and some that narrow."""
    rng = w.rng
    own = [g for g, fs in w.about.items() if f in fs]
    rng.shuffle(own)
    chosen = own[: rng.choice([1, 1, 2, many])]
    if w.narrow and rng.random() < 0.45:
        chosen.append(rng.choice(w.narrow)[0])
    if w.constant and rng.random() < 0.25:
        chosen.append(rng.choice(w.constant))
    return list(dict.fromkeys(chosen))


def value_near(w, e, where):
    """The largest or smallest value that a formula seems to have in a region, or just a number."""
    from structure import places
    from point import all_at, evaluate

    d, s = w.d, w.d.structures[0]
    seen = []
    for v in places(d, s, extra=[Fraction(k, 4) for k in range(-16, 17)]):
        scope = d.scope({**s.constants, w.x: v})
        try:
            if all_at(where, scope) is True:
                seen.append(evaluate(e, scope))
        except (Undefined, KeyError):
            continue
    if not seen or any(not isinstance(v, Fraction) for v in seen):
        return None
    return min(seen), max(seen)


def pointwise(w):
    """A claim about a function at one point, often true only under what narrows."""
    rng, d = w.rng, w.d
    f = rng.choice(list(w.laws))
    label, e, where = rng.choice(w.laws[f])
    cites = [label] + ([g for g in related(w, f, 1) if g != label] if rng.random() < 0.4 else [])
    r = rng.random()
    if r < 0.35:
        link = (rng.choice(["=", "=", "<=", ">="]), var(f), e)
    elif r < 0.8:
        region_of = list(where)
        if w.narrow and rng.random() < 0.75:
            g, more = rng.choice(w.narrow)
            cites.append(g)
            region_of += more
        ends = value_near(w, e, region_of)
        if ends is None:
            link = (rng.choice(["<", ">", "!="]), var(f), num(small(rng)))
        elif rng.random() < 0.5:
            link = (rng.choice(["<=", "<"]), var(f), num(ends[1] + rng.choice([0, 0, 1, Fraction(1, 4)])))
        else:
            link = (rng.choice([">=", ">"]), var(f), num(ends[0] - rng.choice([0, 0, 1, Fraction(1, 4)])))
    else:
        link = (rng.choice(["=", "<", ">="]), sub(var(f), e), num(rng.choice([0, 0, 1, small(rng)])))
    when = [rng.choice(region(rng, w.x))] if rng.random() < 0.12 else []
    if w.claims and rng.random() < 0.3:
        cites.append(rng.choice(w.claims))
    keep(w, d.claim([link], when, list(dict.fromkeys(cites))), {f}, w.claims)


def keep(w, label, about, where):
    """A claim is cited later if it holds in the structure, and seldom if it does not: what rests on a
    claim that is not proved is only `unsupported`."""
    d, s = w.d, w.d.structures[0]
    if w.rng.random() < 0.1 or true_in(w, d.find(label), s):
        where.append(label)
        w.about[label] = about


def true_in(w, claim, s):
    """Whether a claim holds in a structure wherever its givens do."""
    from sampling import Place
    from structure import limit_holds, places

    d = w.d
    if claim.limit():
        return limit_holds(claim.limit(), d, s) is True
    givens = [g for g in d.rests_on(claim) if d.find(g).limit() is None]
    for v in places(d, s):
        place = Place(d, s.values(v))
        if all(place.truth(g) is True for g in givens) and place._truth(claim) is False:
            return False
    return True


def limiting(w):
    """A limit claim: true for the structure, or what one of the laws says when it is read too far."""
    rng, d, x = w.rng, w.d, w.x
    f = rng.choice(list(w.laws))
    point, side = reachable(rng, d, x)
    if w.limited and rng.random() < 0.35:
        _, known, f = rng.choice(w.limited)
        point, side = str(known.point), known.side
    e = rng.choice([
        var(f), var(f), var(f), div(var(f), var(x)), sub(var(f), var(x)), ("min", var(f), ZERO), ("max", var(f), ONE), mul(var(x), var(f)),
        div(ONE, var(f)), ("abs", var(f)), add(var(f), var(rng.choice(list(w.laws)))), power(var(f), 2), var(x),
    ])
    limit = Limit(e, ZERO, x, point, side)
    read = e
    if rng.random() < 0.5 and f in w.laws:
        read = substitute(e, {f: rng.choice(w.laws[f])[1]})
    goal = None
    for germ_at in sides(d, x, limit)[:1]:
        try:
            goal = limit_of(read, d, rng.choice(d.structures), germ_at)
        except (Undefined, Ambiguous, KeyError):
            goal = None
    if goal in ("+oo", "-oo"):
        limit.target = "oo" if goal == "+oo" else "-oo"
    elif isinstance(goal, Fraction):
        same = [c for c in w.constants if d.structures[0].constants[c] == goal]
        limit.target = var(rng.choice(same)) if same and rng.random() < 0.5 else num(goal)
    else:
        limit.target = num(small(rng))
    cites = related(w, f, 2)
    if rng.random() < 0.3:
        # only what is behind a claim, with the narrowing out of sight
        cites = [c for c in w.claims if f in w.about.get(c, ())][:2] or cites
    when = []
    if w.constants and rng.random() < 0.15:
        when = [(rng.choice([">", "!="]), var(rng.choice(w.constants)), ZERO)]
    keep(w, d.claim([limit], when, cites), {f}, w.targets)


def constant_claim(w):
    """What follows about a constant from a premised limit and bounds on a function."""
    rng, d = w.rng, w.d
    if not w.limited or not w.constants:
        return limiting(w)
    given, limit, f = rng.choice(w.limited)
    named = [c for c in w.constants if limit.target == var(c)]
    c = named[0] if named else rng.choice(w.constants)
    v = d.structures[0].constants[c]
    value = rng.choice([v, v, v + nonzero(rng), Fraction(0), small(rng)])
    if rng.random() < 0.3:
        # what a law would make of the limit
        laws = w.laws.get(f)
        if laws:
            try:
                read = limit_of(substitute(limit.f, {f: rng.choice(laws)[1]}), d, d.structures[0], sides(d, w.x, limit)[0])
                value = read if isinstance(read, Fraction) else value
            except (Undefined, Ambiguous, KeyError):
                pass
    link = (rng.choice(["=", "=", "<=", ">=", "<", ">", "!="]), var(c), num(value))
    cites = [given]
    claims = [k for k in w.claims if f in w.about.get(k, ())]
    if claims and rng.random() < 0.7:
        cites += rng.sample(claims, min(len(claims), rng.choice([1, 1, 2])))
    if rng.random() < 0.5:
        cites += related(w, f, 1)
    keep(w, d.claim([link], [], list(dict.fromkeys(cites))), set(), w.claims)


def crossing(w):
    """The pattern of a bound proved in a narrow range and carried to a limit outside of it."""
    rng, d, x = w.rng, w.d, w.x
    if not w.limited or not w.narrow:
        return pointwise(w)
    given, limit, f = rng.choice(w.limited)
    narrow, where = rng.choice(w.narrow)
    if f not in w.laws:
        return pointwise(w)
    law, e, region_of = rng.choice(w.laws[f])
    ends = value_near(w, e, list(where) + list(region_of))
    if ends is None:
        return limiting(w)
    upper = rng.random() < 0.5
    bound = ends[1] if upper else ends[0]
    low = d.claim([("<=" if upper else ">=", var(f), num(bound))], [], [narrow, law])
    keep(w, low, {f}, w.claims)
    to_zero = limit.f[0] == "/"
    named = [c for c in w.constants if limit.target == var(c)]
    limit_bound = Fraction(0) if to_zero else bound
    if named:
        carried = d.claim([("<=" if upper else ">=", var(named[0]), num(limit_bound))], [], [low, given])
    else:
        point, side = str(limit.point), limit.side
        carried = d.claim([Limit(("min" if upper else "max", var(f), num(bound)), num(bound) if rng.random() < 0.5 else limit.target, x, point, side)], [], [low, law])
    w.targets.append(carried)
    if rng.random() < 0.6:
        other = rng.choice([law, given, rng.choice(w.claims)])
        d.claim([], shape="contradiction", cites=list(dict.fromkeys([carried, given, other])))


def negative(w):
    """Contradictions and what is not implied."""
    rng, d = w.rng, w.d
    everything = [s.label for s in d.statements]
    links = [s.label for s in d.statements if s.kind == "given"] + w.claims[-3:] + w.targets[-2:]
    cites = rng.sample(links, min(len(links), rng.choice([2, 2, 3, 4])))
    if rng.random() < 0.7 or len(everything) < 3:
        d.claim([], shape="contradiction", cites=cites)
    else:
        about = rng.choice([s.label for s in d.statements if s.kind == "given"])
        d.claim([], shape="not implied", about=about, cites=[c for c in cites if c != about][:2] or cites[:1])


def build(family, rng, weights):
    while True:
        w = world(family, rng)
        if w is None:
            continue
        state_more(w)
        keep_true(w)
        if w.laws and w.d.structures:
            break
    for _ in range(CLAIMS):
        rng.choices([pointwise, limiting, constant_claim, crossing, negative], weights)[0](w)
    w.d.points += [p for p in (point_of(w, s) for s in w.d.structures) if p]
    return w.d


def keep_true(w):
    """Laws that are not true in the first structure are withdrawn; the generator was too careless there."""
    d = w.d
    for s in list(d.statements):
        if given_true(s, d, d.structures[0]) is not True:
            withdraw(d, s.label)
            w.about.pop(s.label, None)
            for laws in w.laws.values():
                laws[:] = [law for law in laws if law[0] != s.label]
            w.narrow[:] = [n for n in w.narrow if n[0] != s.label]
            w.limited[:] = [n for n in w.limited if n[0] != s.label]
            w.constant[:] = [n for n in w.constant if n != s.label]
    w.laws = {f: laws for f, laws in w.laws.items() if laws}


def point_of(w, s):
    try:
        return s.values(w.rng.choice([Fraction(0), Fraction(1), Fraction(1, 2), Fraction(-1), Fraction(2)]))
    except Undefined:
        return None


def chains(rng):
    return build("chains", rng, [30, 20, 15, 20, 15])


def premised(rng):
    return build("premised", rng, [10, 50, 20, 5, 15])


