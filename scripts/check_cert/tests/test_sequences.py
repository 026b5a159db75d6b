"""Points where nothing is a power, and steps that lead nowhere, forged as evidence on indices."""

import hashlib
import unittest
from fractions import Fraction

from check_cert.document import Document
from check_cert.errors import Unreadable

from .support import answer, document

ONE = [["1", {}]]
NOTHING = {"assume": 1, "cases": []}  # the claim has no way to fail
STEP = {  # n + 1 < 0 beside n >= 0
    "assume": 2,
    "cases": [{"positive": [["1", ONE, [[0, 1]]], ["1", ONE, [[1, 1]]], ["1", ONE, []]], "cofactors": []}],
}
HEAD = ("var n in N, m in N", "var 0 < q < 1, x", "let s(0) := 1, s(n + 1) := 2*s(n) - n")


def proof(found, finding="proved"):
    return {"finding": finding, "premises": "cited", "roots": [], "evidence": {"proof": found}}


def point(values, at=None, finding="refuted"):
    values = {name: [value] if value != "0" else [] for name, value in values.items()}
    evidence = {"point": {"theta": None, "values": values}}
    link = {"finding": finding, "premises": "cited", "roots": [], "evidence": evidence}
    return link if at is None else {**link, "at": at}


def faults(claim, verdict, *links):
    text = document(*HEAD, f"claim a: {claim}")
    certificate = {
        "format": 1, "program": "x", "document": "x", "sha256": hashlib.sha256(text.encode()).hexdigest(),
        "claims": [{"label": "a", "verdict": verdict, "links": list(links)}],
    }
    return answer(text, certificate)[0]


class Points(unittest.TestCase):
    def test_a_point_counts_at_a_natural_number_alone(self):
        self.assertEqual(faults("n != 3", "refuted", point({}, {"n": "3"})), 0)
        for link in (
            point({"n": "3"}), point({}, {"n": "2"}), point({}, {"n": "03"}), point({}, {"n": 3}),
            point({}, {"n": "-3"}), point({}, {"n": "7/2"}), point({}, {}), point({}, {"m": "3"}),
            point({}, {"x": "3"}), point({"n": "3"}, {"n": "3"}), point({}, {"n": "100"}),
        ):
            self.assertEqual(faults("n != 3", "refuted", link), 1, link)

    def test_a_power_is_a_power(self):
        claim = "q^n < 1/2 for n >= 1"
        self.assertEqual(faults(claim, "refuted", point({"q": "1/2"}, {"n": "1"})), 0)
        for link in (
            point({"q": "1/2"}, {"n": "0"}), point({"q": "1/2"}, {"n": "2"}),
            point({"n": "1", "q": "1/2", "pow(q, n)": "1"}),
            point({"q": "1/2", "pow(q, n)": "1"}, {"n": "1"}),
        ):
            self.assertEqual(faults(claim, "refuted", link), 1, link)

    def test_a_term_is_a_term(self):
        self.assertEqual(faults("s(n) != 3", "refuted", point({}, {"n": "2"})), 0)
        self.assertEqual(faults("s(n) != 3", "refuted", point({}, {"n": "1"})), 1)
        self.assertEqual(faults("s(n) != 3", "refuted", point({"s(n)": "3"})), 1)

    def test_every_index_has_its_number(self):
        self.assertEqual(faults("n + m != 3", "refuted", point({}, {"n": "2", "m": "1"})), 0)
        self.assertEqual(faults("n + m != 3", "refuted", point({"m": "1"}, {"n": "2"})), 1)


class Inductions(unittest.TestCase):
    def test_both_parts_are_owed(self):
        claim = "n >= 0 for n >= 0 by induction"
        self.assertEqual(faults(claim, "proved", proof(NOTHING), proof(STEP)), 0)
        for links in (
            [proof(NOTHING)], [proof(STEP)], [proof(STEP), proof(NOTHING)], [proof(NOTHING), proof(NOTHING)],
            [proof(NOTHING), {"finding": None}], [{"finding": None}, proof(STEP)],
            [proof(NOTHING), proof(STEP), proof(STEP)],
            [proof(NOTHING), {**proof(STEP), "at": {"n": "1"}}],
        ):
            self.assertEqual(faults(claim, "proved", *links), 1, links)

    def test_the_first_value_is_the_one_that_is_claimed(self):
        self.assertEqual(faults("n >= 0 for n >= 2 by induction", "proved", proof(NOTHING), proof(STEP)), 0)
        self.assertEqual(faults("n != 1 for n >= 1 by induction", "proved", proof(NOTHING), proof(STEP)), 1)

    def test_a_step_that_fails_refutes_nothing(self):
        first = proof(NOTHING)
        for link in (point({"n": "0"}), point({}, {"n": "0"}), point({"n": "1"}, {"n": "1"})):
            self.assertEqual(faults("n <= 1 for n >= 0 by induction", "refuted", first, link), 1, link)
        self.assertEqual(faults("n <= 1 for n >= 0 by induction", "refuted", first, point({}, {"n": "2"})), 0)

    def test_a_step_from_what_never_holds_makes_nothing_vacuous(self):
        # from n < 0 and n >= 0 anything follows
        step = {"assume": 0, "cases": [{"positive": [["1", ONE, [[0, 1]]], ["1", ONE, [[1, 1]]]], "cofactors": []}]}
        claim = "n < 0 for n >= 0 by induction"
        self.assertEqual(faults(claim, "vacuous", {"finding": None}, proof(step, "vacuous")), 1)
        self.assertEqual(faults(claim, "undecided", {"finding": None}, proof(step)), 0)


class Refused(unittest.TestCase):
    def test_what_would_prove_too_much_is_not_read(self):
        for line in (
            "given g: q^n < x", "let y := n + 1", "claim c: d(q^n, q) = 0", "claim c: q^n -> 1 as q -> 1",
            "claim c: n = 3 for n >= 0 when n = 3 by induction", "claim c: x^2 >= 0 by induction",
            "claim c: q^(n - 1) = q", "let t(0) := 1, t(n + 1) := 1/x", "let t(0) := 1, t(n + 1) := t(n + 1)",
            "let t(0) := 1, t(n + 1) := t(n) + m", "let t(0) := n, t(n + 1) := 1", "claim c: s(n - 1) = 0",
            "claim c: s(2*n) = 0", "claim c: s(65) = 0", "claim c: n^n = 0", "claim c: (1 + q)^n = 0",
            "var k(n)", "claim c: 1 -> 1 as n -> oo", "claim c: d(x^2, n) = 0",
            "let t(1) := 1, t(n + 1) := t(n)", "let t(0) := sqrt(x), t(n + 1) := t(n)",
        ):
            with self.subTest(line), self.assertRaises(Unreadable):
                Document(document(*HEAD, line))

    def test_bounds_of_powers_are_those_of_their_bases(self):
        lines = ["var n in N, a > 0, b >= 0, c >= 1, -1 < e < 1, 0 <= f <= 1"]
        lines.append("claim k: a^n + b^n + c^n + e^n + f^n + 0^n + 1^n + 2^n >= 0")
        symbols = Document(document(*lines)).symbols
        one, zero = (Fraction(1), False), (Fraction(0), False)
        for base, lower, upper in (
            ("a", (Fraction(0), True), None), ("b", zero, None), ("c", one, None), ("e", None, None),
            ("f", zero, one), ("0", zero, one), ("1", one, one), ("2", one, None),
        ):
            symbol = symbols[f"pow({base}, n)"]
            self.assertEqual((symbol.lower, symbol.upper), (lower, upper), base)


if __name__ == "__main__":
    unittest.main()
