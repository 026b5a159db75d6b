"""Sums over ranges: what they are written out to, and what would make them something else."""

import unittest

from check_cert.document import Document
from check_cert.errors import Unreadable
from check_cert.expressions import Reader

from .support import document

HEAD = ("var n in N, m in N, x > 0, y, f(x), theta", "let s(0) := 1, s(n + 1) := 2*s(n) - n", "let g(z) := z*n")


def read(text):
    return Document(document(*HEAD, f"claim c: {text} = 0"))


def left(text):
    return read(text).claims[0].items[0][1]


class Written(unittest.TestCase):
    def test_between_numbers_terms_are_written_out(self):
        for text, same in (
            ("sum(k*x for k in 1..3)", "1*x + 2*x + 3*x"), ("prod(x - k for k in 2..3)", "(x - 2)*(x - 3)"),
            ("sum(k for k in 1..0)", "0"), ("prod(k for k in 1..0)", "1"), ("sum(x^k for k in 0..2)", "x^0 + x^1 + x^2"),
            ("sum(s(k) for k in 0..1)", "s(0) + s(1)"), ("sum(sum(j*k for j in 1..k) for k in 1..2)", "1*1 + (1*2 + 2*2)"),
            ("sum(x^(2*k) for k in 1..2)", "x^2 + x^4"),
        ):
            self.assertEqual(left(text), left(same), text)

    def test_up_to_an_index_a_sum_is_a_sequence(self):
        known = read("sum(k^2 for k in 1..n) + prod(1 + 1/k for k in 2..n + 1) + sum(x^k for k in 0..n + 2)").sequences
        for name, value in (
            ("sum(k^2 for k in 1..n)", [0, 1, 5, 14]), ("prod(1 + 1/k for k in 2..n + 1)", None),
            ("sum(x^k for k in 0..n)", None),
        ):
            self.assertIn(name, known.steps)
            if value:
                for n, expected in enumerate(value):
                    self.assertEqual(number(known.at(("sym", name), {"n": n})), expected)

    def test_equal_sums_are_one(self):
        steps = read("sum(k for k in 1..n) + sum(j for j in 1..n + 1)").sequences.steps
        self.assertEqual([name for name in steps if name != "s(n)"], ["sum(k for k in 1..n)"])

    def test_an_expression_of_a_certificate_may_name_one(self):
        known = read("sum(k for k in 1..n)")
        self.assertEqual(Reader("sum(k for k in 1..n)", known).sum(), ("sym", "sum(k for k in 1..n)"))


def number(e):
    """The value of an expression of numbers."""
    if e[0] == "num":
        return e[1] / e[2]
    parts = [number(part) if isinstance(part, tuple) else part for part in e[1:]]
    return {"add": lambda a, b: a + b, "mul": lambda a, b: a * b, "pow": lambda a, b: a**b}[e[0]](*parts)


class Refused(unittest.TestCase):
    def test_what_would_be_another_sum_is_not_read(self):
        for text in (
            "sum(n*k for k in 1..n)", "sum(m*k for k in 1..n)", "sum(x^(n*k) for k in 0..n)", "sum(g(k) for k in 1..n)",
            "sum(sum(j*k for j in 1..k) for k in 1..n)", "sum(sum(j for j in 1..n) for k in 1..n)", "sum(1/y for k in 1..n)",
            "sum(1/k for k in 0..n)", "sum(k for k in 2..n)", "sum(k for k in 1..n - 1)", "sum(k for k in n..5)",
            "sum(k for k in 1..2*n)", "sum(k for k in 1..n + m)", "sum(k for k in 1..100)", "sum(x for x in 1..3)",
            "sum(k for k in 1..3.5)", "sum(f for k in 1..n)", "sum(s(n) for k in 1..n)", "sum(k)", "sum(k for k of 1..2)",
            "sum(sum(k for k in 1..2) for k in 1..3)", "sum(cos(theta) for k in 1..n)", "sum(1/(y + k) for k in 1..n)",
        ):
            with self.subTest(text), self.assertRaises(Unreadable):
                read(text)
        for line in (
            "given a: sum(k for k in 1..n) = 1", "let t(0) := 1, t(n + 1) := t(n) + sum(t(n)*k for k in 1..n)",
            "claim d: exists z: sum(z*k for k in 1..n) = 0 by z := 0", "let h(z) := sum(z*k for k in 1..n)",
        ):
            with self.subTest(line), self.assertRaises(Unreadable):
                Document(document(*HEAD[:2], line))


if __name__ == "__main__":
    unittest.main()
