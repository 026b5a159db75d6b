"""Limits by bounds, and along powers of t."""

import copy
import unittest

from .limits_prover import functions_link, limit_link, p
from .prover import certify
from .support import answer, document, expected, verdicts

T, ONE = p((1, "t:", 1)), p((1,))


def between(lower, upper, power=1):
    """A lower and an upper bound: (num, den)."""
    return (*lower, 0, None, None, power, ">=", (*upper, 0, None, None, power, "<="))


ROOT = between((T, ONE), (T, ONE), 2)  # sqrt(x) = t with x = t^2


class Bounds(unittest.TestCase):
    def judged(self, text, **hints):
        certificate = certify(text, hints={(k.replace("_", "-"), 0): h for k, h in hints.items()})
        return certificate, answer(text, certificate)

    def check(self, text, **hints):
        certificate, (faults, lines) = self.judged(text, **hints)
        self.assertEqual((faults, lines), (0, []))
        self.assertEqual(verdicts(certificate), expected(text))
        return certificate

    def rejected(self, text, certificate, number, change, reason):
        changed = copy.deepcopy(certificate)
        change(changed["claims"][number]["links"][0]["evidence"]["sides"][0])
        faults, lines = answer(text, changed)
        self.assertEqual(faults, 1, reason)
        self.assertIn(reason, lines[0])

    def test_roots_are_powers_of_t(self):
        text = document(
            "var x >= 0, y", "claim root: sqrt(x) -> 0 as x -> 0",
            "claim down: sqrt(3 - y) -> 0 as y -> 3-",
            "claim wrong: sqrt(x) -> 1 as x -> 0 expect refuted",
            "claim square: y -> 0 as y -> 0+",
        )
        root, down, wrong = (f"sqrt({inside})" for inside in ("x", "3 - y", "x"))
        squared = p((1, "t:", 2))
        certificate = self.check(
            text, root=limit_link(ROOT, roots=[root]), down=limit_link(ROOT, roots=[down]),
            wrong=functions_link("refuted", "x", {}, (0, True, "0", *ROOT), roots=[wrong]), square=limit_link((squared, ONE, 0, None, None, 2)),
        )
        for power, reason in (
            (0, "along no power of t"), (1, "goes without saying"), (3, "does not vanish"),
            (-2, "out of range"), ("2", "out of range"), (2.0, "out of range"), (True, ""),
            (None, "out of range"), (1 << 15, "out of range"), ((1 << 15) - 1, "does not vanish"),
        ):
            for number in (0, 1):
                with self.subTest(power=power, number=number):
                    change = lambda side: side["germ"].update(power=power)
                    self.rejected(text, certificate, number, change, reason)

    def test_between_two_bounds(self):
        text = document("var x, a, -1 <= f(x) <= 1", "claim middle: x*f -> 0 as x -> 0+")
        for lower, upper in (
            ((p((-1, "t:", 1)), ONE), (T, ONE)),
            ((T, p((-1,))), (p((-1, "t:", 1)), p((-1,)))),
        ):
            certificate = self.check(text, middle=limit_link(between(lower, upper)))
            side = certificate["claims"][0]["links"][0]["evidence"]["sides"][0]
            upper, low = side["upper"], {k: v for k, v in side.items() if k != "upper"}
            for change, reason in (
                (lambda s: s.pop("upper"), "shows no limit"),
                (lambda s: s.update(upper=None), "goes without saying"),
                (lambda s: s.pop("sense"), ""),
                (lambda s: s.update(sense="="), "goes without saying"),
                (lambda s: s.update(sense=">"), "a comparison is expected"),
                (lambda s: s.update(sense="<="), ""),
                (lambda s: s["upper"].pop("sense"), ""),
                (lambda s: s.update(upper=low), "a lower and an upper bound"),
                (lambda s: s["upper"].update(upper=upper), "the keys"),
                (lambda s: (s.clear(), s.update({**upper, "upper": low})), "a lower and an upper"),
                (lambda s: (s.clear(), s.update(upper)), "shows no limit"),
                (lambda s: s["upper"].update(order=1), "the order of a finite limit is 0"),
                (lambda s: s["upper"].update(num=p((2,))), ""),
                (lambda s: s["upper"].update(den=[]), ""),
                (lambda s: s["upper"]["germ"].update(above=False), ""),
                (lambda s: s["upper"]["germ"].update(at="1"), ""),
                (lambda s: s["upper"]["germ"].update(variable="a"), ""),
                (lambda s: s["upper"]["germ"].update(positive=s["along"]), ""),
                (lambda s: s["upper"].update(along=s["at_zero"]), ""),
            ):
                with self.subTest(reason=reason):
                    self.rejected(text, certificate, 0, change, reason)

    def test_bounds_on_another_side_show_nothing(self):
        # f is at least 0 from above and at most 0 from below, and has no limit from either side.
        text = document(
            "var x, f(x)", "given sign: f*x >= 0",
            "claim above: f -> 0 as x -> 0+ from sign",
        )
        values = {"sign": {"f": "x"}}
        lower, upper = ([], ONE, 0, values, None, 1, ">="), ([], ONE, 0, values, None, 1, "<=")
        certificate, (faults, lines) = self.judged(text, above=limit_link((*lower, None)))
        self.assertEqual(faults, 1)
        self.assertIn("a bound on this side shows no limit", lines[0])
        mirror = document(
            "var x, f(x)", "given sign: f*x >= 0",
            "claim above: f -> 0 as x -> 0- from sign",
        )
        below, _ = self.judged(mirror, above=limit_link((*upper, None)))
        sides = [c["claims"][0]["links"][0]["evidence"]["sides"] for c in (certificate, below)]
        sides[0][0]["upper"] = sides[1][0]
        faults, lines = answer(text, certificate)
        self.assertEqual(faults, 1)
        self.assertIn("bounds on one side are expected", lines[0])

    def test_infinite_limits_need_the_bound_on_their_side(self):
        text = document(
            "var x, f(x) >= 0",
            "claim far: x + f -> oo as x -> oo", "claim deep: -x - f -> -oo as x -> oo",
        )

        def told(sign, sense):
            def link(*parts):
                made = limit_link((p((sign,)), T, 1, None, None, 1, sense))(*parts)
                # the opposite, t*t*f and t times the binding vanish together
                summands = [["1", ONE, [[4, 1]]], ["1", T, [[0, 1]]]]
                sum_ = {"positive": summands, "cofactors": [[3, T]]}
                made["evidence"]["sides"][0]["along"] = {"assume": 1, "cases": [sum_]}
                return made
            return link

        certificate = self.check(text, far=told(1, ">="), deep=told(-1, "<="))
        for number, (right, wrong) in enumerate(((">=", "<="), ("<=", ">="))):
            side = certificate["claims"][number]["links"][0]["evidence"]["sides"][0]
            other = copy.deepcopy(side)
            for change, reason in (
                (lambda s: s.pop("sense"), ""),
                (lambda s: s.update(sense=wrong), ""),
                (lambda s: s.update(upper=other), "between two bounds is finite"),
            ):
                self.assertEqual(side["sense"], right)
                self.rejected(text, certificate, number, change, reason)
        # x is at least -x, which tends to -oo, and -x at most x.
        text = document(
            "var x", "claim up: -x -> oo as x -> oo", "claim down: x -> -oo as x -> oo",
        )
        certificate, (faults, lines) = self.judged(
            text, up=limit_link((ONE, T, 1, None, None, 1, "<=")),
            down=limit_link((p((-1,)), T, 1, None, None, 1, ">=")),
        )
        for side in (c["links"][0]["evidence"]["sides"][0] for c in certificate["claims"]):
            self.assertIsNotNone(side["along"], "the bounds are true")
        self.assertEqual(faults, 2)
        self.assertEqual(sum("shows no limit" in line for line in lines), 2)
