"""Forged certificates: each rule and each invariant broken, one at a time."""

import copy
import unittest

from check_cert.errors import Unreadable

from .limits_prover import p
from .prover import certify
from .support import answer, document, verdicts

ONE = p((1,))


def proof_link(proof, finding="proved", roots=()):
    return lambda *_: {
        "finding": finding, "premises": "cited", "roots": list(roots), "evidence": {"proof": proof},
    }


def total(summands, cofactors=()):
    return {"positive": summands, "cofactors": list(cofactors)}


def split_case(opposite, sign, then):
    return {"opposite": opposite, "is": sign, "then": then}


class Rules(unittest.TestCase):
    """Conditions are numbered from 0: first the ranges, then what was assumed."""

    def rejected(self, proof, *lines, finding="proved", reason=""):
        text = document(*lines)
        label = text.split("claim ")[1].split(":")[0]
        faults, why = answer(text, certify(text, hints={(label, 0): proof_link(proof, finding)}))
        self.assertEqual(faults, 1, "a falsehood was accepted")
        self.assertIn(reason, why[0])

    def test_sums(self):
        lines = "var x >= 0", "claim a: x > 0"  # conditions: 0 is x >= 0, then -x >= 0
        for summands, cofactors, reason in (
            ([["1", ONE, [[0, 1]]], ["1", ONE, [[1, 1]]]], [], "no summand is visibly positive"),
            ([["1", ONE, []]], [], "does not vanish"),
            ([["0", ONE, []]], [], "a weight is not positive"),
            ([["-1", ONE, []], ["1", ONE, []]], [], "a weight is not positive"),
            ([["1", [], []]], [], "no summand is visibly positive"),
            ([["1", ONE, [[0, 0]]], ["1", ONE, [[1, 1]]]], [], "its power is 0"),
            ([["1", ONE, [[0, 1], [0, 1]]]], [], "stands twice"),
            ([["1", ONE, [[2, 1]]]], [], "out of range"),
            ([["1", ONE, [[-1, 1]]]], [], "out of range"),
            ([["1", ONE, [[0, -1]]]], [], "out of range"),
            ([["1", ONE, []]], [[0, p((-1,))]], "does not belong to an equation"),
            ([["1", ONE, [[True, 1]]]], [], "out of range"),
            ([["1/1", ONE, []]], [], "not well formed"),
            ([["1.0", ONE, []]], [], "not well formed"),
            ([[1, ONE, []]], [], "not well formed"),
            ([["1", [["1", {"y": 1}]], []]], [], "not known here"),
            ([["1", [["1", {"lim:0": 1}]], []]], [], "not known here"),
            ([["1", [["1", {"x": 0}]], []]], [], "out of range"),
            ([["1", [["1", {"x": 1}], ["1", {}]], []]], [], "not in order"),
            ([["1", [["1", {}], ["1", {}]], []]], [], "not in order"),
            ([["1", [["0", {}]], []]], [], "not well formed"),
            ([["1", [["-0", {}]], []]], [], "not well formed"),
            ([["1", [["01", {}]], []]], [], "not well formed"),
            ([["1", [["1", {"x": 1 << 14}], ["1", {"x": 1 << 15}]], []]], [], "out of range"),
            ([["1", p((1, "x", 1 << 14)), []]], [], "too large"),
            ([["1", ONE]], [], "wrong length"),
        ):
            with self.subTest(reason=reason, summands=summands):
                proof = {"assume": 1, "cases": [total(summands, cofactors)]}
                self.rejected(proof, *lines, reason=reason)

    def test_signs_of_factors(self):
        equal = "var x", "given g: x = 0", "claim a: contradiction from g"
        step = {"assume": 0, "cases": [total([["1", ONE, [[0, 1]]]], [[0, p((-1,))]])]}
        self.rejected(step, *equal, reason="an equation stands among the factors")
        other = "var x", "given g: x != 0, x < 0", "claim a: contradiction from g"
        step = {"assume": 0, "cases": [total([["1", ONE, [[0, 1]]], ["1", ONE, [[1, 1]]]])]}
        self.rejected(step, *other, reason="the sign of a factor is not known")
        odd = {"assume": 0, "cases": [total([["1", ONE, [[0, 3]]], ["1", p((1, "x", 1)), [[1, 1]]]])]}
        self.rejected(odd, *other, reason="the sign of a factor is not known")

    def test_cases_and_splits(self):
        lines = "var x", "claim a: abs(x) = x"
        trivial = total([["1", ONE, []]], [])
        for proof, reason in (
            ({"assume": 0, "cases": [trivial]}, "does not vanish"),
            ({"assume": 1, "cases": []}, "wrong length"),
            ({"assume": 1, "cases": [trivial, trivial]}, "wrong length"),
            ({"assume": 2, "cases": []}, "out of range"),
            ({"assume": -1, "cases": []}, "out of range"),
            ({"split": p((1, "x", 1)), "zero": trivial, "positive": trivial}, "keys"),
            ({"split": p((1, "y", 1)), "cases": []}, "known"),
            ({}, "no such step"), ([], "a proof is expected"), (None, "a proof is expected"),
            ({"assume": 0, "cases": [], "more": 1}, "keys"),
        ):
            with self.subTest(reason=reason):
                self.rejected(proof, *lines, reason=reason)

    def test_a_negative_part_is_that_of_the_opposite_polynomial(self):
        lines = "var x", "claim a: x >= 0"
        part = total([["1", ONE, [[0, 1]]], ["1", ONE, [[1, 1]]]])
        cases = [split_case(o, s, part) for o, s in ((False, "=0"), (False, ">0"), (True, ">0"))]
        self.rejected({"assume": 1, "cases": [{"split": p((1, "x", 1)), "cases": cases}]}, *lines)

    def test_the_cases_of_a_split_admit_every_sign(self):
        """The sum needs a condition that is `> 0`; of x = 0, x > 0, x < 0 and x != 0 one is given."""
        lines = "var x", "given g: x^2 = 1", "claim a: contradiction from g"
        square = total([["1", ONE, [[1, 2]]], ["1", ONE, []]], [])  # never shows what it should
        equal = total([["1", ONE, []]], [[0, ONE], [1, p((-1, "x", 1))]])  # shows it where x = 0
        mirrored = total([["1", ONE, []]], [[0, ONE], [1, p((1, "x", 1))]])
        for cases, reason in (
            ([split_case(False, "=0", equal)], "leave out a sign"),
            ([split_case(True, "=0", mirrored)], "leave out a sign"),
            ([], "leave out a sign"),
            ([split_case(False, "=0", equal), split_case(False, "=0", equal)], "leave out a sign"),
            ([split_case(False, "=0", equal), split_case(False, "!=0", square)], "does not vanish"),
            ([split_case(False, "=0", equal), split_case(False, ">=0", square)], "does not vanish"),
            ([split_case(0, "=0", equal)], "opposite"),
            ([split_case(False, "<0", equal)], "no such sign"),
        ):
            with self.subTest(reason=reason, cases=cases):
                proof = {"assume": 0, "cases": [{"split": p((1, "x", 1)), "cases": cases}]}
                self.rejected(proof, *lines, finding="proved", reason=reason)

    def test_overlapping_cases_will_do(self):
        text = document("var x", "claim a: x^2 >= 0")
        where = lambda n: total([["1", p((1, "x", 1)), []], ["1", ONE, [[0, 1]]]])  # -x^2 > 0
        for kinds in (((False, ">=0"), (True, ">=0")), ((False, "=0"), (False, "!=0")),
                      ((True, ">0"), (False, ">=0"), (False, "=0"))):
            cases = [split_case(o, s, where(o)) for o, s in kinds]
            proof = {"assume": 1, "cases": [{"split": p((1, "x", 1)), "cases": cases}]}
            self.assertEqual(answer(text, certify(text, hints={("a", 0): proof_link(proof)})), (0, []))


class Files(unittest.TestCase):
    def test_the_frame_of_the_file(self):
        text = document("var x", "claim a: x = x", "claim b: x >= x from a")
        good = certify(text)
        self.assertEqual(answer(text, good), (0, []))
        for change in (
            {"format": 2}, {"format": True}, {"program": 1}, {"sha256": "0"}, {"claims": []},
            {"claims": good["claims"][::-1]}, {"claims": good["claims"][:1]}, {"more": 1},
        ):
            with self.subTest(change=list(change)):
                try:
                    self.assertGreater(answer(text, {**good, **change})[0], 0)
                except Unreadable:
                    pass

    def test_verdicts_are_worked_out_again(self):
        text = document("var x", "claim a: x = x + 1", "claim b: x = x from a", "claim c: x = 1, x/x = 1")
        good = certify(text)
        self.assertEqual(answer(text, good), (0, []))
        self.assertEqual(verdicts(good), {"a": "refuted", "b": "unsupported", "c": "ill-defined"})
        for number in range(3):
            for verdict in ("proved", "refuted", "ill-defined", "vacuous", "undecided", "unsupported", 1):
                forged = copy.deepcopy(good)
                forged["claims"][number]["verdict"] = verdict
                self.assertEqual(answer(text, forged)[0], verdict != good["claims"][number]["verdict"])

    def test_a_proof_has_no_more_premises(self):
        text = document(
            "var x, y", "given a: x = 1", "given b: y = 1",
            "claim c: x + y = 2 from a, b", "claim f: x = 1 from c", "claim e: y = 7 when x = 2 from c",
        )
        good = certify(text)
        self.assertEqual(verdicts(good), {"c": "proved", "f": "refuted", "e": "refuted"})
        link = good["claims"][1]["links"][0]
        link["premises"] = "all"
        self.assertEqual(answer(text, good)[0], 1)
        link["finding"], link["evidence"] = "proved", {"proof": total([["1", ONE, []]])}
        self.assertIn("no more premises", answer(text, good)[1][0])


if __name__ == "__main__":
    unittest.main()
