"""Certificates changed in one place, all the others as they were: none supports another verdict."""

import copy
import json
import os
import random
import subprocess
import tempfile
import unittest
from collections import defaultdict
from pathlib import Path

from check_cert.document import Document
from check_cert.errors import Rejected, Unreadable
from check_cert.verdict import check_claim

from .limits_prover import functions_link, limit_link, p, pass_link
from .prover import certify
from .support import ROOT, answer, document, verdicts

ONE, T = p((1,)), p((1, "t:", 1))
DOCUMENTS = "answers-to-the-conditions", "coupled-collision"  # together they have all kinds of evidence


def bounds(lower, upper, power=1):
    """A side on which polynomials in t are bounds."""
    return (lower, ONE, 0, None, None, power, ">=", (upper, ONE, 0, None, None, power, "<="))


def places(value, path=()):
    """The paths to all parts of a value."""
    yield path
    if isinstance(value, dict):
        for key in value:
            yield from places(value[key], (*path, key))
    elif isinstance(value, list):
        for key in range(len(value)):
            yield from places(value[key], (*path, key))


def mutants(value):
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
                    "refuted", "x", {"f": "1/x"}, {"theta": None, "values": {}},
                    premises=[(T, ONE, 0)],
                ),
            }),
            (document(
                "var x >= 0, y, -1 <= f(y) <= 1",
                "claim root: sqrt(x) -> 0 as x -> 0",
                "claim middle: y*f -> 0 as y -> 0",
            ), {
                ("root", 0): limit_link(bounds(T, T, 2), roots=["sqrt(x)"]),
                ("middle", 0): limit_link(bounds(p((-1, "t:", 1)), T), bounds(p((-1, "t:", 1)), T)),
            }),
        ]
        for text, hints in documents:
            yield text, certify(text, hints=hints)

    def test_no_change_supports_another_verdict(self):
        rng = random.Random(5)
        for text, certificate in self.certificates():
            self.assertEqual(answer(text, certificate), (0, []))
            right = verdicts(certificate)
            tried = accepted = 0
            for path in filter(None, places(certificate["claims"])):
                value = certificate["claims"]
                for key in path:
                    value = value[key]
                for mutant in mutants(value):
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


def kind(path):
    """What sort of field a path leads to: the last two names, and how deep it is in a list there."""
    names = [key for key in path if isinstance(key, str)]
    depth = len(path) - 1 - max((n for n, key in enumerate(path) if isinstance(key, str)), default=-1)
    if len(names) > 1 and names[-2] == "values" or names and names[-1].startswith(("sqrt:", "lim:", "t:")):
        names[-1] = "*"
    return (*names[-2:], depth)


def program():
    """kane: where the environment says, or the newest that was built here."""
    if "KANE" in os.environ:
        return Path(os.environ["KANE"])
    built = [ROOT / "target" / profile / "kane" for profile in ("release", "debug")]
    return max((path for path in built if path.exists()), key=lambda path: path.stat().st_mtime, default=None)


class Shipped(unittest.TestCase):
    """The same for certificates that kane writes: a few changes to every kind of field."""

    @classmethod
    def setUpClass(cls):
        if not program():
            raise unittest.SkipTest("there is no kane: build it, or say where it is by KANE=path")
        cls.shipped = []
        for name in DOCUMENTS:
            source = ROOT / "docs" / "derivations" / f"{name}.md"
            with tempfile.TemporaryDirectory() as folder:
                command = [program(), "audit", source, "--out", folder]
                subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
                certificate = json.loads((Path(folder) / f"{name}.cert.json").read_bytes())
            cls.shipped.append((source.read_bytes(), certificate))

    def test_no_change_to_a_shipped_certificate_supports_another_verdict(self):
        rng, kinds = random.Random(7), defaultdict(list)
        known = [Document(source.decode()) for source, _ in self.shipped]
        for number, (_, certificate) in enumerate(self.shipped):
            for n, claim in enumerate(certificate["claims"]):
                cost = len(json.dumps(claim))
                for path in filter(None, places(claim)):
                    kinds[kind(path)].append((cost, number, n, path))
        self.assertGreater(len(kinds), 100)
        for name in ("theta", "sides", "functions", "pass", "split", "assume", "positive", "point"):
            self.assertTrue(any(name in key for key in kinds), f"no {name} is there to be changed")
        tried = accepted = 0
        for _, found in sorted(kinds.items(), key=lambda item: repr(item[0])):
            quick = [place for place in found if place[0] < 9000] or found
            for _, number, n, path in rng.sample(quick, min(5, len(quick))):
                value = self.shipped[number][1]["claims"][n]
                for step in path:
                    value = value[step]
                changes = [m for m in mutants(value) if m != value or type(m) is not type(value)]
                for mutant in rng.sample(changes, min(4, len(changes))):
                    tried += 1
                    accepted += self.harmless(known[number], self.shipped[number][1], n, path, mutant)
        self.assertGreater(tried, 1500)
        self.assertLess(accepted, tried / 10)

    def harmless(self, known, certificate, n, path, mutant):
        """A changed claim is rejected, or supports what it did; is it accepted?"""
        changed = copy.deepcopy(certificate["claims"][n])
        place = changed
        for step in path[:-1]:
            place = place[step]
        place[path[-1]] = mutant
        before = verdicts(certificate)
        try:
            found, good = check_claim(known, known.claims[n], changed, before, lambda line: None)
        except Rejected:
            return False
        if good:
            right = certificate["claims"][n]["verdict"]
            self.assertEqual((found, changed["verdict"]), (right, right), f"{path} changed to {mutant!r}")
        return good

    def test_a_certificate_is_one_of_its_text_and_its_claims(self):
        (source, good), (_, other) = self.shipped
        text = source.decode()
        self.assertEqual(answer(text, good), (0, []))
        self.assertRaises(Unreadable, answer, text, other)
        self.assertRaises(Unreadable, answer, text + " ", good)
        self.assertRaises(Unreadable, answer, text, {**good, "claims": good["claims"][1:]})
        claims = good["claims"]
        turned = {**good, "claims": [*claims[1:], claims[0]]}
        self.assertGreater(answer(text, turned)[0], len(claims) / 2)


if __name__ == "__main__":
    unittest.main()
