"""Documents read, proved by the small prover, and checked."""

import hashlib
import unittest

from check_cert.document import Document
from check_cert.errors import Unreadable
from check_cert.main import check_text

from .prover import certify
from .support import ROOT, answer, document, expected, verdicts

SEMANTICS = ROOT / "tests" / "conformance" / "semantics"
DECIDED = """absolute-value bad-link cases-branch-taken cases-gap cases-overlap
cited-claim-undefined cited-definedness cited-when contradictory-premises derivative-at-guard
guards-on-unknown let-ill-defined notation strict-touching unsupported when-left-to-right
when-outside-domain zero-power""".split()


class Documents(unittest.TestCase):
    def check(self, text, splits=(), hints=None):
        certificate = certify(text, splits, hints)
        self.assertEqual(answer(text, certificate), (0, []))
        return verdicts(certificate)

    def test_the_semantics_suite_ends_as_it_says(self):
        for name in DECIDED:
            with self.subTest(name):
                text = (SEMANTICS / f"{name}.md").read_text()
                self.assertEqual(self.check(text), expected(text))

    def test_faulty_documents_are_unreadable(self):
        read = 0
        for path in sorted(SEMANTICS.glob("*.md")):
            text = path.read_text()
            with self.subTest(path.name):
                if "<!-- error" in text:
                    self.assertRaises(Unreadable, Document, text)
                else:
                    read += bool(Document(text).claims)
        self.assertGreater(read, 20)
        for lines in (
            ["var x, x"], ["var x", "let x := 1"], ["var x", "claim a: y = x"], ["claim a: 1"],
            ["var x", "claim a: x = 1 from b"], ["var x", "claim a: x = 1 expect true"],
            ["var x", "claim a: x = 1", "claim (a): x = 2"], ["var x", "claim a: 2x = x"],
            ["var x", "claim a: x -> x as x -> 0"], ["var x", "claim a: x -> 1"],
            ["var x", "claim a: x = 1 as x -> 0"], ["var x", "claim a: d(x, 2*x) = 1"],
            ["var t, x(t)", "claim a: d(pi*x, t) = 0"], ["var x", "claim a: d(pi*x, x) = 0"],
            ["var x", "claim a: x -> 0 as x -> 0 when x > 0"], ["var k(y)"], ["var x != 0"],
            ["var x", "claim a: x^x = 1"], ["var x", "claim a: $x = 1$"], ["var x", "claim a: x = 1 from a"], [" var x"],
            ["var x", "claim a: contradiction", "claim b: x = 1 from a"],
            ["var x, y, z", "claim a: d(y, x) = 0 when z = x^2, y = z"],
            ["var x, y", "claim a: d(y, x) = 0 when y <= x^2, x^2 <= y"],
        ):
            with self.subTest(lines[-1]):
                self.assertRaises(Unreadable, Document, document(*lines))

    def test_lines_end_at_cr_lf_and_crlf(self):
        text = document("var x", "given a: x = 1 # note", "claim b: x = 2", "  from a # no", "claim c: x = x")
        for end in ("\n", "\r", "\r\n"):
            with self.subTest(repr(end)):
                claims = Document(text.replace("\n", end)).claims
                self.assertEqual([c.label for c in claims], ["b", "c"])
                self.assertEqual([s.label for s in claims[0].cited], ["a"])

    def test_blocks_are_found_as_a_reader_of_markdown_does(self):
        text = (
            "~~~kane\nvar x\nclaim a: x = x\n~~~\n``` kane more\nclaim b: x = x\n```\n"
            "> ```kane\n> claim c: x = x\n> ```\n- ```kane\n  claim e: x = x\n  ```\n"
            "<!--\n```kane\nclaim h: x = x\n```\n-->\n```Kane\nclaim i: x = x\n```\n"
            "````text\n```kane\nclaim j: x = x\n```\n````\n"
        )
        self.assertEqual([c.label for c in Document(text).claims], ["a", "b", "c", "e"])
        self.assertRaises(Unreadable, Document, "```kane\nvar x\n")

    def test_derivatives_are_defined_where_the_page_says(self):
        text = document(
            "var x, y",
            "claim second: d(d(abs(x), x), x) = 0 when x > 0",
            "claim kink: d(d(abs(x), x), x) = 0 expect ill-defined",
            "claim zeroth: d(sqrt(-x^2)^0, x) = 0 when x = 0 expect ill-defined",
            "claim side: d(min(abs(x), -1), x) = 0 when x = 0",
            "claim steps: d(cases { x > 5: x^2; else: 0 }, x) = 0 when x < 4",
            "claim apart: d(max(abs(x), -1), x) = 1 when x > 0",
            "claim flat: d(sqrt(y), x) = 0 when y >= 0",
            "claim rising: d(sqrt(x), x) = 1 when x = 0 expect ill-defined",
            "claim meeting: d(cases { y >= max(y, x): 1; else: 2 }, x) = 0 expect ill-defined",
            "claim edge: d(cases { sqrt(min(0, x)) > -1: x; else: 5 }, x) = 1 when x = 0",
            "    expect ill-defined",
            "claim hole: d(cases { 0 >= max(0, x): 1; else: 2 }, x) = 0 when x = 0",
            "    expect ill-defined",
        )
        self.assertEqual(self.check(text), expected(text))

    def test_a_certificate_belongs_to_one_text(self):
        text = document("var x", "claim a: x = x")
        certificate = certify(text)
        other = text.replace("x = x", "x = x + 1")
        self.assertRaises(Unreadable, answer, other, certificate)
        certificate["sha256"] = hashlib.sha256(other.encode()).hexdigest()
        self.assertEqual(answer(other, certificate)[0], 1)
        self.assertRaises(Unreadable, check_text, b"\xff", certificate, print)

    def test_an_irrational_point(self):
        text = document("var x > 0", "claim a: x^2 != 2 expect refuted")
        theta = {"poly": ["-2", "0", "1"], "from": "1", "to": "2"}

        def link(theta, value):
            return lambda *_: {
                "finding": "refuted", "premises": "cited", "roots": [],
                "evidence": {"point": {"theta": theta, "values": {"x": value}}},
            }

        good = certify(text, hints={("a", 0): link(theta, ["0", "1"])})
        self.assertEqual(answer(text, good), (0, []))
        double = {"poly": ["4", "0", "-4", "0", "1"], "from": "1", "to": "2"}
        self.assertEqual(answer(text, certify(text, hints={("a", 0): link(double, ["0", "1"])}))[0], 0)
        for poly, low, high in (
            (["-2", "0", "1"], "-2", "2"), (["-2", "0", "1"], "3/2", "2"), (["-4", "0", "1"], "1", "2"),
            (["-2", "0", "1"], "2", "1"), (["2", "0", "1"], "1", "2"), (["-2", "0", "1", "0"], "1", "2"),
            (["-2"], "1", "2"), ([], "1", "2"), (["-2", "0", "1"], "2/2", "2"),
        ):
            forged = link({"poly": poly, "from": low, "to": high}, ["0", "1"])
            with self.subTest(poly=poly, low=low):
                self.assertEqual(answer(text, certify(text, hints={("a", 0): forged}))[0], 1)
        for value in (["0", "-1"], ["1"], ["0", "1", "0"], ["0", "2/2"], [], ["7/5"]):
            with self.subTest(value=value):
                forged = certify(text, hints={("a", 0): link(theta, value)})
                self.assertEqual(answer(text, forged)[0], 1)


if __name__ == "__main__":
    unittest.main()
