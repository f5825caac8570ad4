#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Where the tolerances of measure.py end, to the byte, and which instructions call_graph.py takes for what."""
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import call_graph  # noqa: E402
import measure  # noqa: E402


def row(**figures):
    return {"scene": "satellite", "core": "cortex-m0", **{figure: 1000 for figure in measure.FIGURES}, **figures}


def complaints(**figures):
    return measure.compare([row(**figures)], {("satellite", "cortex-m0"): row()})


class Tolerances(unittest.TestCase):
    def test_the_table_itself_passes(self):
        self.assertEqual(complaints(), [])

    def test_two_percent_of_growth_pass_and_no_more(self):
        self.assertEqual(complaints(flash=1020), [])
        self.assertIn("flash grew from 1000 to 1021", complaints(flash=1021)[0])

    def test_ten_percent_of_shrinkage_pass_and_no_more(self):
        self.assertEqual(complaints(instructions_mean=900), [])
        self.assertIn("instructions_mean shrank from 1000 to 899", complaints(instructions_mean=899)[0])

    def test_a_world_of_another_size_never_passes(self):
        self.assertEqual(len(complaints(world_ram=1001)), 1)
        self.assertEqual(len(complaints(world_ram=999)), 1)

    def test_every_figure_is_compared(self):
        for figure in measure.FIGURES:
            self.assertEqual(len(complaints(**{figure: 2000})), 1, figure)

    def test_a_scene_without_a_row_is_named(self):
        self.assertIn("has no row", measure.compare([row(scene="new")], {})[0])


class StackPointer(unittest.TestCase):
    def test_bytes_pushed(self):
        for mnemonic, operands, pushed in (
            ("push", "{r4, r5, lr}", 12),
            ("stmdb", "sp!, {r4-r8, lr}", 24),
            ("vpush", "{d8-d9}", 16),
            ("vpush", "{s16}", 4),
            ("sub", "sp, #20", 20),
            ("sub.w", "sp, sp, #516", 516),
            ("str.w", "lr, [sp, #-4]!", 4),
            ("pop", "{r4, pc}", 0),
            ("add", "sp, #20", 0),
            ("add", "r0, sp, #4", 0),
            ("mov", "r0, sp", 0),
            ("str", "r0, [sp, #4]", 0),
        ):
            self.assertEqual(call_graph.push_bytes(mnemonic, operands), pushed, mnemonic + " " + operands)

    def test_a_return_of_thumb_1_is_no_call(self):
        returns_by = None
        for mnemonic, operands in (("pop", "{r3}"), ("add", "sp, #16")):
            returns_by = call_graph.return_register(mnemonic, operands, returns_by)
        self.assertEqual(returns_by, "r3")
        self.assertIsNone(call_graph.return_register("ldr", "r3, [r0]", "r3"))
        self.assertIsNone(call_graph.return_register("pop", "{r3, r4}", None))

    def test_what_is_not_understood_is_not_guessed(self):
        for mnemonic, operands in (("mov", "sp, r3"), ("sub.w", "sp, sp, r3"), ("add", "sp, r4"), ("ldr", "sp, [r0]")):
            self.assertIsNone(call_graph.push_bytes(mnemonic, operands), mnemonic + " " + operands)


if __name__ == "__main__":
    unittest.main()
