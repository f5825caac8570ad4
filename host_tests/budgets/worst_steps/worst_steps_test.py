#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What worst_steps.py makes of what a machine printed, and what it complains about."""
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import worst_steps  # noqa: E402

SIGNATURE = "ingot::f32x1::StepReport counted_step(ingot::f32x1::World<S>&, ingot::f32x1::scalar) [with S = {anonymous}::%s; scalar = float]"
PRINTED = "\n".join(["input a", "scene " + SIGNATURE % "Hall", "10 0", "40 2", "input b", "input c",
                     "scene " + SIGNATURE % "YardWith<ingot::f32x1::Splitting<6> >", "30 1", "20 0", "40 0"]) + "\n"


class Figures(unittest.TestCase):
    def test_steps_are_counted_from_one_in_each_input(self):
        self.assertEqual(worst_steps.steps_of(PRINTED), [
            ("a", 1, "Hall", 10, 0), ("a", 2, "Hall", 40, 2),
            ("c", 1, "YardWith<Splitting<6>>", 30, 1), ("c", 2, "YardWith<Splitting<6>>", 20, 0), ("c", 3, "YardWith<Splitting<6>>", 40, 0)])

    def test_a_row_for_each_scene_and_one_for_all(self):
        rows = worst_steps.rows_of("friction", worst_steps.steps_of(PRINTED))
        self.assertEqual([row["scene"] for row in rows], ["Hall", "all"])
        of_all = rows[-1]
        self.assertEqual((of_all["inputs"], of_all["steps"], of_all["median"], of_all["p99"], of_all["worst"]), (2, 5, 30, 40, 40))
        self.assertEqual((of_all["worst_input"], of_all["worst_step"], of_all["worst_contacts"]), ("a", 2, 2))  # the first of two
        self.assertEqual((of_all["contact_steps"], of_all["contact_median"]), (2, 30))
        self.assertEqual((of_all["ratio"], of_all["contact_ratio"]), ("1.33", "1.33"))

    def test_ranks_are_of_values_that_there_are(self):
        self.assertEqual([worst_steps.rank(list(range(1, 101)), share) for share in (0.5, 0.99, 1)], [50, 99, 100])
        self.assertEqual(worst_steps.rank([7], 0.5), 7)
        self.assertEqual((worst_steps.rank([], 0.5), worst_steps.ratio([])), (0, "0"))


class Check(unittest.TestCase):
    TABLE = {("friction", "Hall"): {"worst": 1000}, ("light", "Shelf"): {"worst": 5}}

    def complaints(self, *rows):
        return worst_steps.compare([{"machine": "friction", "scene": scene, "worst": worst} for scene, worst in rows], self.TABLE, ["friction"])

    def test_tolerances_are_those_of_the_budgets(self):
        self.assertEqual(self.complaints(("Hall", 1050)), [])
        self.assertEqual(self.complaints(("Hall", 900)), [])
        self.assertIn("friction, Hall: worst grew from 1000 to 1051", self.complaints(("Hall", 1051))[0])
        self.assertIn("friction, Hall: worst shrank from 1000 to 899", self.complaints(("Hall", 899))[0])

    def test_scenes_that_come_or_go_are_named(self):
        self.assertEqual(self.complaints(("Hall", 1000), ("Yard", 3)), ["friction, Yard has no row in the table"])
        self.assertEqual(self.complaints(), ["friction, Hall is in the table, and took no step"])  # and nothing of machines that did not play


if __name__ == "__main__":
    unittest.main()
