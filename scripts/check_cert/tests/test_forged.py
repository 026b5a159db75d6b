"""Forged certificates: each rule and each invariant broken, one at a time."""

import copy
import json
import random
import unittest

from check_cert.errors import Rejected, Unreadable

from .limits_prover import functions_link, limit_link, p, pass_link
from .prover import certify
from .support import answer, document, verdicts

ONE, T = p((1,)), p((1, "t:", 1))


def proof_link(proof, finding="proved", roots=()):
    return lambda *_: {
        "finding": finding, "premises": "cited", "roots": list(roots), "evidence": {"proof": proof},
    }


def total(summands, cofactors=()):
    return {"positive": summands, "cofactors": list(cofactors)}


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
            ({"split": p((1, "y", 1)), "zero": trivial, "positive": trivial, "negative": trivial}, "known"),
            ({}, "no such step"), ([], "a proof is expected"), (None, "a proof is expected"),
            ({"assume": 0, "cases": [], "more": 1}, "keys"),
        ):
            with self.subTest(reason=reason):
                self.rejected(proof, *lines, reason=reason)

    def test_a_negative_part_is_that_of_the_opposite_polynomial(self):
        lines = "var x", "claim a: x >= 0"
        part = total([["1", ONE, [[0, 1]]], ["1", ONE, [[1, 1]]]])
        proof = {"assume": 1, "cases": [
            {"split": p((1, "x", 1)), "zero": part, "positive": part, "negative": part},
        ]}
        self.rejected(proof, *lines)


class Mutations(unittest.TestCase):
    """A certificate changed anywhere never supports another verdict."""

    def certificates(self):
        far = ("x", None, True)
        documents = [
            (document(
                "var x > 0", "var y, f(x) >= 0, a", "given tie: f*x = 1", "given pin: x = a",
                "given far: f -> 0 as x -> oo",
                "claim tied: f -> 0 as x -> oo from tie",
                "claim pole: 1/y -> oo as y -> 0+",
                "claim two: 1/y -> oo as y -> 0 expect refuted",
                "claim pinned: 1/x -> 0 as x -> oo from pin expect vacuous",
                "claim some: contradiction from tie, far expect refuted",
                "claim positive: f > 0 from tie",
                "claim weak: sqrt(f^2) = f",
                "claim odd: abs(y) + max(y, 1) > y",
                "claim wrong: y^2 > 0 expect refuted",
                "claim open: y/y = 1 expect ill-defined",
            ), {
                ("tied", 0): limit_link((T, ONE, 0, {"tie": {"f": "1/x"}})),
                ("pole", 0): limit_link((ONE, T, 1)),
                ("two", 0): functions_link("refuted", "y", {}, (0, False, "-oo", p((-1,)), T, 1)),
                ("pinned", 0): pass_link("vacuous", (far, p((-1,), (1, "a", 1, "t:", 1)), "=0", None)),
                ("some", 0): functions_link(
                    "refuted", "x", {"f": "1/x"}, {"theta": None, "values": {"x": ["1"]}},
                    premises=[(T, ONE, 0)],
                ),
            }),
        ]
        for text, hints in documents:
            yield text, certify(text, hints=hints)

    def places(self, value, path=()):
        yield path
        if isinstance(value, dict):
            for key in value:
                yield from self.places(value[key], (*path, key))
        elif isinstance(value, list):
            for key in range(len(value)):
                yield from self.places(value[key], (*path, key))

    def mutants(self, value):
        """What may stand instead of a value."""
        yield from (None, [], {}, "", "0", "1", "-1", 0, 1, -1, 1.0, True, "oo", "=0", ">0", ">=0", "!=0")
        if isinstance(value, str):
            yield from ("-" + value, value + "/1", value + "0", "2/4", "1/0", "1/-2", "0" + value, "x", "proved",
                        "refuted", "vacuous", "all")
        elif isinstance(value, bool):
            yield not value
        elif isinstance(value, int):
            yield from (value + 1, value - 1, value + 2, 40000, 1 << 70)
        elif isinstance(value, list) and value:
            yield from (value[1:], value[:-1], value[::-1], value + value[-1:])
        elif isinstance(value, dict) and value:
            key = next(iter(value))
            yield {k: v for k, v in value.items() if k != key}
            yield {**value, "more": 1}
            yield {("y" if k == "x" else k): v for k, v in value.items()}

    def test_no_change_supports_another_verdict(self):
        rng = random.Random(5)
        for text, certificate in self.certificates():
            self.assertEqual(answer(text, certificate), (0, []))
            right = verdicts(certificate)
            places = [path for path in self.places(certificate["claims"]) if path]
            tried = accepted = 0
            for path in places:
                value = certificate["claims"]
                for key in path:
                    value = value[key]
                for mutant in self.mutants(value):
                    if rng.random() > 0.06 or mutant == value and type(mutant) is type(value):
                        continue
                    tried += 1
                    accepted += self.harmless(text, certificate, path, mutant, right)
            self.assertGreater(tried, 1000)
            self.assertLess(accepted, tried / 20)

    def harmless(self, text, certificate, path, mutant, right):
        """A mutant is rejected, or supports what was right before; is it accepted?"""
        number = path[0]
        changed = {**certificate, "claims": list(certificate["claims"])}
        changed["claims"][number] = copy.deepcopy(certificate["claims"][number])
        place = changed["claims"]
        for key in path[:-1]:
            place = place[key]
        place[path[-1]] = mutant
        try:
            source = json.loads(json.dumps(changed))
            faults, _ = answer(text, source)
        except Unreadable:
            return False
        except (Rejected, TypeError, KeyError, AttributeError, ValueError) as error:
            self.fail(f"{path} changed to {mutant!r} ends in {error!r}")
        if faults:
            return False
        self.assertEqual(verdicts(changed), right, f"{path} changed to {mutant!r}")
        return True


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
