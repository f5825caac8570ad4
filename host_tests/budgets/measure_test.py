#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Where the tolerances of measure.py end, to the byte, which instructions call_graph.py takes for what, what calls.py takes for public."""
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import call_graph  # noqa: E402
import calls  # noqa: E402
import measure  # noqa: E402


def row(**figures):
    return {"scene": "satellite", "core": "cortex-m0", **{figure: 1000 for figure in measure.FIGURES}, **figures}


def complaints(**figures):
    return measure.compare([row(**figures)], {("satellite", "cortex-m0"): row()})


class Tolerances(unittest.TestCase):
    def test_the_table_itself_passes(self):
        self.assertEqual(complaints(), [])

    def test_five_percent_of_growth_pass_and_no_more(self):
        self.assertEqual(complaints(flash=1050), [])
        self.assertIn("flash grew from 1000 to 1051", complaints(flash=1051)[0])

    def test_a_build_may_allow_less(self):
        measure.take_tolerance({"growth_percent": 2})
        self.assertEqual(complaints(flash=1020), [])
        self.assertIn("flash grew from 1000 to 1021: more than 2 %", complaints(flash=1021)[0])
        measure.take_tolerance({"growth_percent": 5})

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


WORLD = """\
template <class S>
class World {
    static_assert(check_scene<S>(), "");

public:
    static constexpr int max_bodies = S::max_bodies;
    /// Comments may name call(s).
    Result<BodyId> add(const BodyDef& def) {
        const Status status = check_add(def);
    }
    template <unsigned N>
    Result<BodyId> add(const BodyDef& def, const ShapeDef (&shapes)[N]) {
    }
    const typename S::force_field& force_field() const { return storage_.field; }

private:
    friend StepReport step(World<Any>& world, scalar h);
    Status check_add(const BodyDef& def) const {
};
"""
SOLIDS = """\
namespace ingot { inline namespace INGOT_ABI {
namespace solids {
constexpr MassDistribution no_solid() {
}  // namespace solids
inline __attribute__((always_inline)) Status check() {
template <class T>
INGOT_INLINE constexpr Vec3<T> spin_of(const Mat3<T>& A, const Vec3<T>& L) {
inline constexpr scalar pi = scalar(3);
    return indented(A);
static_assert(spin_of(1) == 2, "");
"""
ALL_CALLS = "world.add(def); world.add(def, shapes); world.force_field(); step(world, h); check(); spin_of(A, L);"


class PublicFunctions(unittest.TestCase):
    def missing(self, source):
        with tempfile.TemporaryDirectory() as folder:
            kernel = pathlib.Path(folder)
            for name, text in (("world/world.h", WORLD), ("body/solids.h", SOLIDS), ("calls.cpp", source),
                               ("ingot.h", '#include "body/solids.h"\n#include "world/world.h"\n')):
                (kernel / name).parent.mkdir(exist_ok=True)
                (kernel / name).write_text(text, encoding="utf-8")
            return calls.missing_calls(kernel, kernel / "calls.cpp")

    def test_members_friends_and_functions_of_public_headers_and_no_others(self):
        self.assertEqual(calls.members_of_world(WORLD), {"add": 2, "force_field": 1})
        self.assertEqual(calls.friends_of_world(WORLD), {"step": 1})
        self.assertEqual(calls.free_functions(SOLIDS), {"check": 1, "spin_of": 1})

    def test_each_that_is_not_called_is_named(self):
        self.assertEqual(self.missing(ALL_CALLS), [])
        for call, named in (("world.force_field();", "World::force_field "), ("step(world, h);", "step "), ("spin_of(A, L);", "spin_of ")):
            sentences = self.missing(ALL_CALLS.replace(call, ""))
            self.assertEqual(len(sentences), 1, call)
            self.assertTrue(sentences[0].startswith(named), sentences[0])

    def test_every_overload_wants_a_call(self):
        self.assertIn("World::add has 2 ", self.missing(ALL_CALLS.replace("world.add(def);", ""))[0])

    def test_a_member_is_no_call_of_a_free_function(self):
        self.assertEqual(len(self.missing(ALL_CALLS.replace("step(", "world.step("))), 1)


class StacksOfCalls(unittest.TestCase):
    TABLE = {("wake", "cortex-m0"): 100, ("wake", "cortex-m4f"): 50}

    def complaints(self, *rows):
        return calls.compare([{"call": call, "core": "cortex-m0", "stack": stack} for call, stack in rows], self.TABLE)

    def test_tolerances_are_those_of_the_budgets(self):
        self.assertEqual(self.complaints(("wake", 105)), [])
        self.assertEqual(self.complaints(("wake", 90)), [])
        self.assertIn("wake on cortex-m0: stack grew from 100 to 106", self.complaints(("wake", 106))[0])
        self.assertIn("wake on cortex-m0: stack shrank from 100 to 89", self.complaints(("wake", 89))[0])

    def test_rows_and_calls_are_the_same(self):
        self.assertEqual(self.complaints(("wake", 100), ("sleep", 8)), ["sleep on cortex-m0 has no row in the table"])
        self.assertEqual(self.complaints(), [])
        self.assertEqual(self.complaints(("sleep", 8))[1], "wake on cortex-m0 is in the table, and no call")


if __name__ == "__main__":
    unittest.main()
