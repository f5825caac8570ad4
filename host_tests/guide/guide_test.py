#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""guide.py refuses what it should: a figure that somebody changed, a link that leads nowhere, a name that nobody has, code that goes on from nothing."""
import pathlib
import re
import sys
import unittest

sys.dont_write_bytecode = True
import guide  # noqa: E402
import reference  # noqa: E402

PAGE = guide.GUIDE / "a_page.md"  # it is nowhere, and would be beside the others
KNOWN = {"a.size": "72", "a.list": "| one | 1 |", "sentences_of_compiler": "stones do not fly: set stones = false"}
WORDS = {"World", "add", "tilde"}
ARTICLE = "| 9 | tilde | `{}` | `kernel/math/rotation.h` |\n"


class Refusals(unittest.TestCase):
    def complaints(self, text):
        return " ".join(guide.complaints_about(PAGE, text, KNOWN, WORDS))

    def test_what_is_right_is_not_refused(self):
        self.assertEqual(self.complaints("It takes <!--=a.size-->72<!--/--> bytes, see [the README](../../README.md#use-it), `World::add`, `kernel/world/step.h`.\n"
                                         "<!-- table: a.list -->\n| one | 1 |\n<!-- end of table -->\n" + ARTICLE.format("tilde")), "")

    def test_figures(self):
        self.assertIn("stale", self.complaints("It takes <!--=a.size-->73<!--/--> bytes.\n"))
        self.assertIn("stale", self.complaints("<!-- table: a.list -->\n| one | 2 |\n<!-- end of table -->\n"))
        self.assertIn("nobody knows", self.complaints("It takes <!--=b.size-->72<!--/--> bytes.\n"))
        for typed in ("72 bytes", "1.5 KB", "0.02 mm", "3 %", "2,000 instructions"):
            self.assertIn("who wrote this figure", self.complaints(f"It takes {typed}.\n"))

    def test_figures_of_all_pages(self):
        """Each figure that stands on a page, changed by a digit, and one that a person typed there."""
        known = {**guide.figures_of_tables(), **guide.tables_of_source()}
        changed = 0
        for page in guide.pages():
            text = page.read_text(encoding="utf-8")
            self.assertEqual(guide.with_figures(page, text, known, [], partly=True), text, page.name)
            for match in [*guide.FIGURE.finditer(text), *guide.TABLE.finditer(text)]:
                if match[1] in known:
                    other = re.sub(r"\d(?=\D*$)", lambda digit: str((int(digit[0]) + 1) % 10), match[2]) if re.search(r"\d", match[2]) else match[2] + "1"
                    altered = text[:match.start(2)] + other + text[match.end(2):]
                    self.assertNotEqual(guide.with_figures(page, altered, known, [], partly=True), altered, f"{page.name}: {match[1]}")
                    changed += 1
            complaints = []
            guide.check_measured(page, text, complaints)
            self.assertEqual(complaints, [])
            guide.check_measured(page, text + "It takes 72 bytes.\n", complaints)
            self.assertEqual(len(complaints), 1, page.name)
        self.assertGreater(changed, 40)

    def test_links(self):
        self.assertIn("no file", self.complaints("[a page](nowhere.md)\n"))
        self.assertIn("no heading", self.complaints("[the README](../../README.md#nowhere)\n"))

    def test_sentences(self):
        self.assertEqual(self.complaints("Stones stay where they are<!--while: stones do not fly-->.\n"), "")
        self.assertIn("does not say any more", self.complaints("Stones stay where they are<!--while: stones do not swim-->.\n"))

    def test_headers(self):
        code = "```cpp\ningot::platform::FixedStep pace(1, {60, 1}, 5);\n```\n"
        self.assertIn("which header has FixedStep", self.complaints("Link `ingot::platform`.\n" + code))
        self.assertIn("has to be linked", self.complaints("See `platform/fixed_step.h`.\n" + code))

    def test_other_pages(self):
        complaints = []
        guide.check_other_page(guide.ROOT / "kernel" / "a_page.md", "[x](nowhere.md), `motion/integrate_v.cpp`, `motion/integrate_w.cpp`\n", complaints)
        self.assertEqual(complaints, ["a_page.md: no file nowhere.md", "kernel/a_page.md: no path motion/integrate_w.cpp"])

    def test_names(self):
        self.assertIn("nothing is called sing", self.complaints("Call `World::sing`.\n"))
        self.assertIn("no path", self.complaints("See `kernel/world/stop.h`.\n"))
        self.assertIn("is not in", self.complaints(ARTICLE.format("axis_angel")))

    def test_code_that_goes_on_from_nothing(self):
        chunk = guide.CHUNK.search("<!-- continues -->\n```cpp\nint i;\n```\n")
        self.assertTrue(chunk["goes_on"])
        chain = guide.Chain(PAGE, 1)
        chain.add(1, "struct S : ingot::Scene {};\nstatic ingot::World<S> w;\n...\nw.add(def);   // a comment\nint i = 1;\n")
        source = chain.source(0, guide.SharedScenes([chain]))
        self.assertIn("MUST(w.add(def));", source)
        self.assertLess(source.index("static ingot::World<S> w;"), source.index("static void statements()"))
        self.assertGreater(source.index("int i = 1;"), source.index("static void statements()"))

    def test_what_the_reference_hides_is_there(self):
        for name, hidden in reference.INTERNAL.items():
            text = (reference.KERNEL / name).read_text(encoding="utf-8")
            for internal in hidden.split():
                self.assertIsNotNone(reference.declared(internal).search(text) or f"namespace {internal} {{" in text or None, f"{name}: {internal}")


if __name__ == "__main__":
    unittest.main()
