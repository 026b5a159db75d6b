"""Limits, germs, passages and functions."""

import copy
import unittest

from .limits_prover import cases_link, functions_link, limit_link, p, pass_link
from .prover import certify
from .support import answer, document, expected, verdicts

T = p((1, "t:", 1))
ONE = p((1,))


class Limits(unittest.TestCase):
    def check(self, text, **hints):
        certificate = certify(text, hints={(k.replace("_", "-"), 0): h for k, h in hints.items()})
        faults, lines = answer(text, certificate)
        self.assertEqual((faults, lines), (0, []))
        self.assertEqual(verdicts(certificate), expected(text))
        return certificate

    def test_limits_are_taken_inside_the_domain(self):
        text = document(
            "var x > 0", "var y",
            "claim one-sided: 1/x -> oo as x -> 0",
            "claim two-sided: 1/y -> oo as y -> 0 expect refuted",
            "claim right: 1/y -> oo as y -> 0+",
            "claim left: 1/y -> -oo as y -> 0-",
            "claim even: 1/y^2 -> oo as y -> 0",
        )
        pole, square = (ONE, T, 1), (ONE, p((1, "t:", 2)), 2)
        self.check(
            text, one_sided=limit_link(pole), right=limit_link(pole),
            left=limit_link((p((-1,)), T, 1)), even=limit_link(square, square),
            two_sided=functions_link("refuted", "y", {}, (0, False, "-oo", p((-1,)), T, 1)),
        )

    def test_parameters_of_a_limit(self):
        text = document(
            "var a >= 0, b, x",
            "claim loose: a*x -> oo as x -> oo expect refuted",
            "claim firm: a*x -> oo as x -> oo when a > 0",
            "claim ratio: (b*x + 1)/(x + 1) -> b as x -> oo",
            "claim inverse: (x + 1)/(b*x + 1) -> 1/b as x -> oo when b > 0",
        )
        ratio = p((1, "b", 1), (1, "t:", 1)), p((1,), (1, "t:", 1))
        self.check(
            text, firm=limit_link((p((1, "a", 1)), T, 1)), ratio=limit_link((*ratio, 0)),
            loose=functions_link("refuted", "x", {"a": "0"}, (0, True, "0", p(), ONE, 0)),
            inverse=limit_link((ratio[1], ratio[0], 0)),
        )

    def test_a_limit_by_the_sign_of_a_constant(self):
        text = document(
            "var a, b > 0, x",
            "claim kink: |a + x| -> |a| as x -> 0+",
            "claim steep: |b + x| -> |b| as x -> 0+",
        )
        a, minus = p((1, "a", 1)), p((-1, "a", 1))
        above, below = p((1, "a", 1), (1, "t:", 1)), p((-1, "a", 1), (-1, "t:", 1))
        kink = cases_link(a, [(T, ONE, 0)], [(above, ONE, 0)], [(below, ONE, 0, None, [minus, ONE])])
        steep = cases_link(p((1, "b", 1)), None, [(p((1, "b", 1), (1, "t:", 1)), ONE, 0)], None)
        certificate = self.check(text, kink=kink, steep=steep)

        def rejected(change, reason, number=0):
            changed = copy.deepcopy(certificate)
            change(changed["claims"][number]["links"][0]["evidence"])
            faults, lines = answer(text, changed)
            self.assertEqual(faults, 1, reason)
            self.assertIn(reason, lines[0])

        cannot = certificate["claims"][1]["links"][0]["evidence"]["cases"][0]["then"]
        for change, reason in (
            (lambda e: e["cases"].pop(), "the cases leave out a sign"),
            (lambda e: e.update(split=T), "not those of constants"),
            (lambda e: e.update(split=p((1, "x", 1))), "not those of constants"),
            (lambda e: e["cases"][2].update(opposite=False), ""),
            (lambda e: e["cases"][1].update(then=e["cases"][2]["then"]), ""),
            (lambda e: e["cases"][1].update(then=cannot), ""),
            (lambda e: e["cases"][1].update(then={"point": {"theta": None, "values": {}}}), ""),
            (lambda e: e["cases"][1].update(then={**e["cases"][1]["then"], **cannot}), ""),
            (lambda e: e.update(more=[]), ""),
        ):
            with self.subTest(reason=reason):
                rejected(change, reason)

    def test_premised_limits_and_ranges(self):
        text = document(
            "var x > 0", "var a, f(x)",
            "given pin: x = a", "given tie: f*x = 1",
            "claim pinned: 1/x -> 0 as x -> oo from pin expect vacuous",
            "claim free: 1/x -> 0 as x -> oo",
            "claim tied: f -> 0 as x -> oo from tie",
            "claim wrong: f -> 1 as x -> oo from tie expect refuted",
        )
        certificate = self.check(
            text, free=limit_link((T, ONE, 0)),
            tied=limit_link((T, ONE, 0, {"tie": {"f": "1/x"}})),
            pinned=pass_link(
                "vacuous", (("x", None, True), p((-1,), (1, "a", 1, "t:", 1)), "=0", None)
            ),
            wrong=functions_link("refuted", "x", {"f": "1/x"}, (0, True, "0", T, ONE, 0)),
        )
        side = certificate["claims"][2]["links"][0]["evidence"]["sides"][0]
        side["germ"]["inside"] = []
        self.assertEqual(answer(text, certificate)[0], 1)

    def test_a_constant_is_no_function(self):
        text = document(
            "var x > 0", "var a, f(x), g(x)",
            "given far: f -> 0 as x -> oo", "given near: f -> 1 as x -> 0",
            "given constant: f = a", "given varying: f = g",
            "claim none: contradiction from far, near, constant",
            "claim some: contradiction from far, near, varying expect refuted",
        )
        value = {"constant": {"f": "a"}}
        both = pass_link(
            "proved",
            (("x", None, True), p((-1, "a", 1), (1, "lim:0", 1)), "=0", value),
            (("x", "0", True), p((-1, "a", 1), (1, "lim:1", 1)), "=0", value),
        )
        values = {"f": "1/(1 + x)", "g": "1/(1 + x)"}
        far = (T, p((1,), (1, "t:", 1)), 0)
        near = (ONE, p((1,), (1, "t:", 1)), 0)
        point = {"theta": None, "values": {}}  # nothing is said of x
        self.check(
            text, none=both,
            some=functions_link("refuted", "x", values, point, premises=[far, near]),
        )

    def test_what_does_not_follow(self):
        text = document(
            "var x > 0", "var k(x), i(x)",
            "given balance: x*i = 1 - k", "given far: k -> -1 as x -> oo",
            "given near: k -> 1 as x -> 0", "given far-i: i -> 0 as x -> oo",
            "claim other: not implied near from balance, far",
            "claim found: not implied far from balance, far-i",
        )
        self.check(
            text,
            other=functions_link(
                "proved", "x", {"k": "-1", "i": "2/x"}, (0, True, "-1", p((-1,)), ONE, 0),
                premises=[(p((-1,)), ONE, 0)],
            ),
            found=functions_link(
                "proved", "x", {"k": "1", "i": "0"}, (0, True, "1", ONE, ONE, 0),
                premises=[(p(), ONE, 0)],
            ),
        )

    def test_an_empty_domain_shows_nothing(self):
        text = document(
            "var x", "var k(x)", "given low: x < 0", "given high: x > 1",
            "given far: k = 1, k -> 1 as x -> oo", "given near: x > 3",
            "claim none: not implied far from low, high",
            "claim some: not implied far from low",
        )
        for x in ("0", "-1", "2"):
            point = {"theta": None, "values": {"x": [x] if x != "0" else []}}
            hint = functions_link("proved", "x", {"k": "2"}, point)
            faults, lines = answer(text, certify(text, hints={("none", 0): hint, ("some", 0): hint}))
            self.assertIn("none link 1: formula", lines[0])
            self.assertIn("does not hold at the point", lines[0])
            self.assertEqual(faults, 1 if x == "-1" else 2)

    def test_functions_hold_where_premises_narrow_the_line(self):
        text = document(
            "var x", "var c, k(x)", "given right: x > 2, k = 1/(x - 1) when c = 1", "given one: k <= 1",
            "claim end: k -> 1 as x -> oo from right, one expect refuted",
            "claim near: k -> 1/2 as x -> 2 from right, one expect vacuous",
            "claim edge: k -> 0 as x -> 2+ from right, one expect refuted",
        )
        end = (T, p((1,), (-1, "t:", 1)), 0, {}, [ONE, p((2,))])
        values = {"c": "1", "k": "1/(x - 1)"}
        good = functions_link("refuted", "x", values, (0, True, "0", *end))
        certificate = certify(text, hints={("end", 0): good})
        self.assertEqual(answer(text, certificate), (0, []))
        self.assertEqual(verdicts(certificate), {"end": "refuted", "near": "undecided", "edge": "undecided"})
        functions = certificate["claims"][0]["links"][0]["evidence"]["functions"]
        inside = functions["failure"]["side"]["germ"]["inside"]
        self.assertEqual([entry["given"] for entry in inside], ["right"])
        inside.clear()
        self.assertEqual(answer(text, certificate)[0], 1)
        wide = functions_link("refuted", "x", values, (0, True, "0", *end[:3]))  # for t < 1, not 1/2
        self.assertEqual(answer(text, certify(text, hints={("end", 0): wide}))[0], 1)
        other = functions_link("refuted", "x", {**values, "c": "2"}, (0, True, "0", *end))
        self.assertEqual(answer(text, certify(text, hints={("end", 0): other}))[0], 1)  # x = 1 is met

    def test_each_side_that_is_meant_is_reached(self):
        text = document(
            "var x", "var k(x)", "given law: k = x", "given right: x > 0",
            "claim both: k -> 1 as x -> 0 from law expect undecided",
            "claim half: k -> 1 as x -> 0 from law, right expect undecided",
        )
        sides = functions_link("consistent", "x", {"k": "x"}, [True, False])
        self.check(text, both=sides)
        faults, _ = answer(text, certify(text, hints={("half", 0): sides}))
        self.assertEqual(faults, 1)
        one = functions_link("consistent", "x", {"k": "x"}, [True])
        self.assertEqual(answer(text, certify(text, hints={("both", 0): one}))[0], 1)

    def test_no_limit_is_passed_to_without_one(self):
        text = document("var x", "var c, k(x)", "given law: k = c*x", "claim none: c = 0 from law")
        step = ("x", None, True), p((1, "c", 1)), "=0", {"law": {"k": "c*x"}}
        certificate = certify(text, hints={("none", 0): pass_link("proved", step)})
        faults, lines = answer(text, certificate)
        self.assertIn("no limit is passed to here", lines[0])

    def test_a_claim_is_used_in_its_range_alone(self):
        """`low` holds where -1 < x < 1, and says nothing far away."""
        text = document(
            "var x, c", "var k(x)", "given near: -1 < x, x < 1", "given law: k = x",
            "given slope: k/x -> c as x -> oo",
            "claim low: k < 1 from near, law",
            "claim zero: c <= 0 from low, slope",
        )
        step = ("x", None, True), p((-1, "lim:0", 1), (1, "t:", 1)), ">=0", {"law": {"k": "x"}}
        certificate = certify(text, hints={("zero", 0): pass_link("proved", step)})
        proof = certificate["claims"][1]["links"][0]["evidence"]["proof"]
        self.assertIsNotNone(proof["along"])
        self.assertIsNone(proof["pass"]["inside"][0]["proof"])  # x < 1 is not met
        faults, lines = answer(text, certificate)
        self.assertEqual(faults, 1)
        proof["pass"]["inside"] = []
        self.assertEqual(answer(text, certificate)[0], 1)


if __name__ == "__main__":
    unittest.main()
