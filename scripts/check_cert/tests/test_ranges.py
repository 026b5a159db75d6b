"""Bounds that are expressions: which statements they are cited by, and what is no bound."""

import unittest

from check_cert.document import Document
from check_cert.errors import Unreadable

from .support import document


def cited(*lines):
    """The labels that the last claim cites."""
    claims = Document(document(*lines)).claims
    return [s.label for s in claims[-1].cited]


class Cited(unittest.TestCase):
    def test_whoever_speaks_of_a_symbol_rests_on_its_bounds(self):
        head = "var L > 0, 0 < x < L, y, n in N"
        self.assertEqual(cited(head, "claim c: x > 0"), ["bounds x"])
        self.assertEqual(cited(head, "claim c: L > 0"), [])
        self.assertEqual(cited(head, "claim c: x^n > 0"), ["bounds x"])
        self.assertEqual(cited(head, "claim c: exp(x) > 0"), ["bounds x", "exp x"])
        self.assertEqual(cited(head, "claim c: log(L) > y"), [])
        self.assertEqual(cited(head, "let s(0) := x, s(n + 1) := 2*s(n)", "claim c: s(n) > 0"), ["bounds x"])
        self.assertEqual(cited(head, "given g: y = x", "claim c: y > 0 from g"), ["g", "bounds x"])
        self.assertEqual(cited(head, "given g: y = x", "claim c: not implied g"), ["bounds x"])
        self.assertEqual(cited(head, "claim c: 1/y -> 0 as y -> oo when x > 0"), ["bounds x"])

    def test_bounds_of_bounds_are_cited_in_their_order(self):
        head = "var a, 0 < b < a, 2*b < c <= a + 1, t, f(t) < c"
        self.assertEqual(cited(head, "claim k: f > 0"), ["bounds b", "bounds c", "bounds f"])
        self.assertEqual(cited(head, "claim k: d(f, t) > 0"), [])

    def test_the_variable_of_a_limit_is_spoken_of(self):
        self.assertEqual(cited("var L, 0 < x < L, f(x)", "claim c: f -> 0 as x -> 0"), ["bounds x"])

    def test_a_number_is_no_such_bound(self):
        head = "var 0 < x < 2^3 - 1, y < abs(-2), z < sqrt(4), w < max(1, 2)/3"
        self.assertEqual(cited(head, "claim c: x + y + z + w < 3"), [])
        self.assertEqual(cited("var x < sqrt(2)", "claim c: x < 2"), ["bounds x"])


class Refused(unittest.TestCase):
    def test_a_bound_speaks_of_constants(self):
        for line in (
            "var theta, x < theta", "var n in N, x < n", "var t, v(t), x < v", "var x < L, L", "var a, x < exp(a)",
            "var a, x < d(a^2, a)", "var a, x < pi + a", "var a, a < x", "var a, 0 < x > a", "var a, 0 < theta < a",
            "var a, n in N, m < a in N", "var a, v < a in R^2", "var x < x + 1", "var a, x < a < 1", "var q, n in N, x < q^n",
        ):
            said = ["claim c: sin(theta) <= 1"] if "theta" in line else []
            said += ["claim e: exp(a) > 0"] if "exp" in line else []
            with self.subTest(line), self.assertRaises(Unreadable):
                Document(document(line, *said))


if __name__ == "__main__":
    unittest.main()
