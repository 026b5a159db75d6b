"""Points that no functions pass through, forged as witnesses."""

import unittest

from .prover import certify
from .support import answer, document

CASES = (  # premises, the claim, and a point at which they hold and it fails
    (["given law: x = c"], "d(x, t) = 0", {"c": "0", "x": "0", "d(x, t)": "1"}),
    (["given law: x = t"], "d(x, t) = 1", {"t": "0", "x": "0", "d(x, t)": "0"}),
    (["given law: x^2 = 1"], "d(x, t) = 0", {"x": "1", "d(x, t)": "1"}),
    (["given law: x = y"], "d(y, s) = 0", {"x": "0", "y": "0", "d(y, s)": "1"}),
    (["given law: x >= 0"], "x != 0 when d(x, t) < 0", {"x": "0", "d(x, t)": "-1"}),
    (["given law: d(x, t) = x, d(x, t) = 1 - x"], "x != 1/2", {"x": "1/2", "d(x, t)": "1/2"}),
    (["given law: z = d(x, t)"], "d(z, t) = d(d(x, t), t)",
     {"d(x, t)": "0", "d(d(x, t), t)": "0", "z": "0", "d(z, t)": "1"}),
)
TRUE = (  # the same with premises that are solved for derivatives
    (["given law: d(x, t) = x"], "x = 0", {"x": "1", "d(x, t)": "1"}),
    (["given law: d(d(x, t), t) = -x"], "d(d(x, t), t) = x",
     {"x": "1", "d(d(x, t), t)": "-1"}),
)


class Witnesses(unittest.TestCase):
    def faults(self, premises, claim, values):
        text = document("var t, s, c, x(t), y(s), z(t)", *premises, f"claim a: {claim} from law expect refuted")
        values = {name: [value] if value != "0" else [] for name, value in values.items()}
        link = {
            "finding": "refuted", "premises": "cited", "roots": [],
            "evidence": {"point": {"theta": None, "values": values}},
        }
        return answer(text, certify(text, hints={("a", 0): lambda *_: link}))

    def test_a_point_that_no_functions_pass_through_is_no_witness(self):
        for case in CASES:
            with self.subTest(case[1]):
                faults, why = self.faults(*case)
                self.assertEqual(faults, 1, "a true statement is refuted")

    def test_a_point_of_functions_is_one(self):
        for case in TRUE:
            with self.subTest(case[1]):
                self.assertEqual(self.faults(*case)[0], 0)


if __name__ == "__main__":
    unittest.main()
