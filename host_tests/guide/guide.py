#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The pages of the guide, held to what is so.

    guide.py --extract FILE              writes all C++ of the pages and of the README as one program: what is shown compiles and runs
    guide.py --check PROGRAM...          fails where a figure is stale, a link leads nowhere, or a name is none of ingot's; with --partly figures
                                         that these programs do not print are left alone
    guide.py --update PROGRAM...         writes the figures
    guide.py --check-pictures PROGRAM    fails where a picture is not what pictures.cpp draws
    guide.py --update-pictures PROGRAM   writes them
    guide.py --try PAGE FOLDER           does what a reader of the page does, in a new folder: writes its files, and runs its commands

Code. A block of C++ is a program, or declarations and statements; a line of three dots between them stands for what is left out. Statements go into
a function. A block goes on where the one before it ended if `<!-- continues -->` stands above it. What a reader does not need is in a comment:

    <!-- cpp
    struct Pen { ... };
    -->

which begins anew, or goes on, `<!-- cpp continues`. CHECK(condition) in it is a test; a call of a world in a line of its own has to be answered with
ok. Scenes of the same text on several pages are compiled once.

Figures stand between `<!--=name-->` and `<!--/-->`, tables between `<!-- table: name -->` and `<!-- end of table -->`. PROGRAM prints them, a line each:
name, a tab, what stands there; \\n in a table is a line of it. Others come from ../tables and from the presets.

Files of a project stand below `<!-- file: name -->`. Commands of a reader are those of blocks of sh, but for what installs packages.

What a page says of scenes that are refused ends with it: `<!--while: sentence-->`, as the compiler says it.

A figure with a unit that is measured, as KB, mm or instructions, is refused where it stands by itself.
"""
import collections
import csv
import itertools
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "host_tests/pairs_of_traits"))
import pairs_of_traits  # noqa: E402

GUIDE = ROOT / "host_tests" / "guide"
TABLES = ROOT / "host_tests" / "tables"
PICTURES = GUIDE / "pictures"
FIGURE = re.compile(r"<!--=([\w.+-]+)-->(.*?)<!--/-->")
TABLE = re.compile(r"<!-- table: ([\w.-]+) -->\n(.*?)<!-- end of table -->\n", re.S)
CHUNK = re.compile(r"^(?:<!-- cpp(?P<hidden_goes_on> continues)?\n(?P<hidden>.*?)^-->|(?P<goes_on><!-- continues -->\n\n?)?```cpp\n(?P<shown>.*?)^```)$", re.M | re.S)
CODE = re.compile(r"^```.*?^```$|^<!-- cpp.*?^-->$", re.M | re.S)
IN_TICKS = re.compile(r"`([^`\n]+)`")
DECLARATION = re.compile(r"(struct|class|enum|using|namespace|template|static|inline|constexpr|int main)\b|#|void \w+\(")
SCENE = re.compile(r"^struct (\w+) : ingot::Scene \{(?:[^\n]*\};|.*?^\};)[^\n]*$", re.M | re.S)
CALL = re.compile(r"^( *)((?:\w+\.)(?:set_|add|remove|apply_|move|wake|sleep|collide)\w*\(.*\));( *//.*)?$")
MEASURED = re.compile(r"(?<![\w.`])\d[\d ,.]*(?:e-?\d+)? ?(?:bytes?|B|KB|MB|mm|ms|instructions|cycles|%|per cent|flops)(?![\w`])")


def pages():
    return [ROOT / "README.md"] + sorted(GUIDE.glob("*.md"))


# Code.

class Chain:
    """Blocks that follow each other: what is declared, and what is done, by line of the page."""

    def __init__(self, page, line):
        self.page, self.line, self.declared, self.done = page, line, [], []

    def add(self, line, text):
        """A piece ends where brackets are closed and a line ends in ; or }."""
        piece, begin, depth = [], line, 0
        for row in text.split("\n"):
            line += 1
            if row.strip() == "..." or not (piece or row.strip()):
                begin = line
                continue
            row = row.replace("{ ... }", "{}")
            bare = re.sub(r"//.*|\"[^\"]*\"", "", row).rstrip()
            depth += sum(map(bare.count, "({[")) - sum(map(bare.count, ")}]"))
            piece.append(row)
            if depth == 0 and bare.endswith((";", "}")) or bare.startswith("#"):
                self.add_piece(begin, piece)
                piece, begin = [], line
        self.add_piece(begin, piece)

    def add_piece(self, line, rows):
        first = next((row for row in rows if not row.lstrip().startswith("//")), None)
        if first is not None:
            (self.declared if DECLARATION.match(first) else self.done).append((line, rows))

    def is_program(self):
        return any("int main(" in row for _, rows in self.declared for row in rows)

    def source(self, number, shared):
        out, marks = [], f'"{self.page.name}"'
        for line, rows in self.declared:
            text = "\n".join("" if row.startswith("#include") else row for row in rows)
            text = SCENE.sub(lambda scene: shared.used(scene, self.page, line + text[:scene.start()].count("\n")), text)
            out.append(f"#line {line} {marks}\n{text}")
        if self.done:
            out.append("static void statements() {")
            for line, rows in self.done:
                out.append(f"#line {line} {marks}\n" + "\n".join(CALL.sub(r"\1MUST(\2);\3", row) for row in rows))
            out.append("}")
        body = "\n".join(out)
        return f"namespace chain_{number} {{\n{body}\n}}\n"


class SharedScenes:
    """Scenes of one text are one type: each takes a quarter of a second to compile."""

    def __init__(self, all_chains):
        self.sources = {}
        self.counts = collections.Counter(scene[0] for chain in all_chains for _, rows in chain.declared for scene in SCENE.finditer("\n".join(rows)))

    def used(self, scene, page, line):
        name, text = scene[1], scene[0]
        if self.counts[text] == 1:
            return text
        if text not in self.sources:
            self.sources[text] = (f"scenes_{len(self.sources)}", f'#line {line} "{page.name}"\n{text}')
        return f"using {name} = {self.sources[text][0]}::{name};" + "\n" * text.count("\n")

    def source(self):
        return "".join(f"namespace {space} {{\n{text}\n}}\n" for space, text in self.sources.values())


def chains():
    found = []
    for page in pages():
        text = page.read_text(encoding="utf-8")
        of_page = len(found)

        for chunk in CHUNK.finditer(text):
            hidden = chunk["hidden"] is not None
            group = "hidden" if hidden else "shown"
            line = text[:chunk.start(group)].count("\n") + 1
            if not (chunk["hidden_goes_on"] if hidden else chunk["goes_on"]):
                found.append(Chain(page, line))
            elif len(found) == of_page:
                sys.exit(f"{page.name}: a block goes on, and there is none before it")
            found[-1].add(line, chunk[group])
    return found


def extracted():
    found = chains()
    shared, parts, runs = SharedScenes(found), [], []
    for number, chain in enumerate(found):
        parts.append(chain.source(number, shared))
        where = f'"{chain.page.name}", {chain.line}'
        if chain.is_program():
            runs.append(f"    {{{where}, [] {{ CHECK(chain_{number}::main() == 0); }}}},")
        if chain.done:
            runs.append(f"    {{{where}, chain_{number}::statements}},")
    listed = "static constexpr Page pages[] = {\n" + "\n".join(runs) + "\n};\n"
    return '#include "pages.h"\n' + shared.source() + "".join(parts) + '#line 1 "all pages"\n' + listed + "int main() { return run(pages); }\n"


# Figures.

def rows_of(name):
    with open(TABLES / name, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def examples():
    return [file for file in sorted((ROOT / "host_tests/examples").glob("*.cpp")) if file.stem != "all_examples"]


def as_table(rows):
    """A column of words stands to the left."""
    heads = list(rows[0])
    lines = ["| " + " | ".join(heads) + " |", "| " + " | ".join("---" if head.startswith(("scene", "what")) else "---:" for head in heads) + " |"]
    return "\n".join(lines + ["| " + " | ".join(row.values()) + " |" for row in rows])


def figures_of_tables():
    """From what is measured elsewhere."""
    figures = {}
    for row in rows_of("budgets.csv"):
        core = row["core"].removeprefix("cortex-")
        for column in ("flash", "world_ram", "stack_computed", "instructions_last", "instructions_worst"):
            figures[f"{row['scene']}.{core}.{column.replace('stack_computed', 'stack').replace('world_ram', 'ram')}"] = row[column]
    for row in rows_of("footprint.csv"):
        figures[f"footprint.{row['scene']}.flash"] = row["flash"]
        figures[f"footprint.{row['scene']}.ram"] = row["world_ram"]
    pairs = rows_of("pairs.csv")
    figures["pairs"] = str(len(pairs))
    figures["pairs.refused"] = str(sum(1 for row in pairs if row["sentence"]))
    version = (ROOT / "kernel/base/version.h").read_text()
    number = dict(re.findall(r"INGOT_(\w+) (\d+)", version))
    figures["version"] = ".".join(number[part] for part in ("VERSION_MAJOR", "VERSION_MINOR", "VERSION_PATCH"))
    figures["determinism"] = number["DETERMINISM_VERSION"]
    figures["pairs_refused"] = pairs_of_traits.refused_table(pairs_of_traits.read_table())
    for name in ("errors_of_scenes", "peers", "effort", "plain_costs"):
        figures[name] = as_table(rows_of(f"{name}.csv"))
    for file in examples():
        lines = file.read_text(encoding="utf-8").splitlines()
        head = [line[3:] for line in itertools.takewhile(lambda line: line.startswith("// "), lines[1:])]
        figures[f"example.{file.stem}"] = (f"![{file.stem}](pictures/example_{file.stem}.svg)\n\n{chr(10).join(head)}\n\n"
                                           f"[{file.name}](../examples/{file.name}), {len(lines)} lines.")
    flags = re.findall(r"static constexpr unsigned (\w+) += 1u << \d+; *///< (.*)", (ROOT / "kernel/world/draw.h").read_text(encoding="utf-8"))
    figures["draw.flags"] = "\n".join(["| `Draw::` | what it draws | |", "| --- | --- | --- |"] +
                                      [f"| `{name}` | {what} | ![{name}](pictures/draw_{name}.svg) |" for name, what in flags])
    figures["examples"] = str(len(examples()))
    return figures


def table_of_packages():
    lines = ["| package | what you type | tried |", "| --- | --- | --- |"]
    return "\n".join(lines + [f"| `{row['package']}` | {row['type']} | {row['tried']} |" for row in rows_of("packages.csv")])


def tables_of_source():
    """What the compiler says of a scene that cannot be, and why a call may refuse."""
    sentences = set()
    for file in sorted((ROOT / "kernel/world").rglob("*.h")):
        for assertion in re.findall(r"static_assert\((.*?)\);", file.read_text(encoding="utf-8"), re.S):
            sentences.update(re.findall(r'"(\w[^"]*: [^"]*)"$', assertion))
    rows = [sentence.split(": ", 1) for sentence in sorted(sentences)]
    listed = ["| what the compiler says | and what to do |", "| --- | --- |"] + [f"| {what} | {do} |" for what, do in rows]
    status = (ROOT / "kernel/base/status.h").read_text(encoding="utf-8")
    reasons = re.findall(r"^    (\w+)(?: = 0)?, *///< (.*)$", status, re.M)
    return {"sentences_of_compiler": "\n".join(sorted(sentences)), "sentences": "\n".join(listed), "statuses": "\n".join(["| status | why |", "| --- | --- |"] + [f"| `{name}` | {why} |" for name, why in reasons])}


def figures(programs):
    """A table of budgets/capacities has rows of its own, without a name."""
    known = {**figures_of_tables(), **tables_of_source(), "packages": table_of_packages()}
    for program in programs:
        lines = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
        for line in lines:
            name, tab, value = line.partition("\t")
            if tab:
                known[name] = value.replace("\\n", "\n")
        rows = [line.rsplit(",", 2) for line in lines if "\t" not in line]
        if rows:
            head = ["| a world of | a body | a manifold, or a contact of `max_contacts` |", "| --- | ---: | ---: |"]
            known["capacities"] = "\n".join(head + [f"| {name} | {body} | {manifold} |" for name, body, manifold in rows])
    return known


def with_figures(page, text, known, complaints, partly=False):
    def written(match, form):
        if match[1] not in known:
            if not partly:
                complaints.append(f"{page.name}: nobody knows the figure {match[1]}")
            return match[0]
        return form.format(match[1], known[match[1]])
    text = TABLE.sub(lambda match: written(match, "<!-- table: {0} -->\n{1}\n<!-- end of table -->\n"), text)
    return FIGURE.sub(lambda match: written(match, "<!--={0}-->{1}<!--/-->"), text)


# Links and names.

def prose_of(text):
    return CODE.sub(lambda match: "\n" * match[0].count("\n"), text)


def anchors(page):
    """As the pages of a repository make them of headings."""
    seen, found = {}, set()
    for heading in re.findall(r"^#+ +(.*?)\s*$", prose_of(page.read_text(encoding="utf-8")), re.M):
        slug = re.sub(r"[^\w\- ]", "", re.sub(r"<!--.*?-->", "", heading).lower().replace("`", "")).replace(" ", "-")
        number = seen.get(slug, 0)
        seen[slug] = number + 1
        found.add(slug if number == 0 else f"{slug}-{number}")
    return found


def check_links(page, text, complaints):
    for target in re.findall(r"\]\(([^)\s]+)\)", prose_of(text)):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (page.parent / path).resolve() if path else page
        if not file.exists():
            complaints.append(f"{page.name}: no file {target}")
        elif anchor and anchor not in anchors(file):
            complaints.append(f"{page.name}: no heading {target}")


def words_of_ingot():
    """All identifiers of the tree, and the names of tests, presets and targets."""
    words = set()
    for folder, ends in (("kernel", ".h .cpp .txt"), ("platform", ".h .cpp .cmake .txt .py .c .ld"), ("toolchains", ".cmake .py .md .in"),
                         ("host_tests", ".h .cpp .txt .cmake .py .toml")):
        for file in (ROOT / folder).rglob("*"):
            if file.suffix in ends.split() and file.parent != GUIDE:
                words.update(re.findall(r"[A-Za-z_]\w*", file.read_text(encoding="utf-8")))
                words.add(file.name)
                words.add(file.stem)
    words.update(file.name for file in GUIDE.iterdir())
    for file in ("CMakeLists.txt", "CMakePresets.json"):
        text = (ROOT / file).read_text(encoding="utf-8")
        words.update(re.findall(r"[A-Za-z_][\w-]*", text))
    return words


def check_names(page, text, words, complaints):
    """Of what stands in ticks: paths that there are, identifiers that somebody declares. In the README paths alone."""
    own = set(re.findall(r"[A-Za-z_]\w*", "\n".join(CODE.findall(text))))
    for ticked in IN_TICKS.findall(prose_of(text)):
        for path in re.findall(r"(?:kernel|platform|host_tests|toolchains|fuzz)/[\w./*-]*\w", ticked):
            if not (list(ROOT.glob(path)) if "*" in path else (ROOT / path).exists()):
                complaints.append(f"{page.name}: no path {path}")
        name = re.fullmatch(r"((?:\w+(?:<[^`]*>)?(?:::|\.))*~?[A-Za-z_]\w*)(?:\(.*\))?", ticked)
        if page.parent == GUIDE and name and "/" not in ticked:
            for word in re.findall(r"[A-Za-z_]\w*", name[1]) if ticked not in words else ():
                if word not in words and word not in own:
                    complaints.append(f"{page.name}: nothing is called {word}: `{ticked}`")


def check_headers(page, text, complaints):
    """What ingot.h does not bring, ingot::platform: the page says which header has it, and which target."""
    used = set(re.findall(r"ingot::platform::(\w+)", "\n".join(chunk["shown"] or "" for chunk in CHUNK.finditer(text))))
    for header in sorted((ROOT / "platform").glob("*.h")):
        declared = re.findall(r"^(?:class|struct|\w+) (\w+)(?: \{|\(| :)", header.read_text(encoding="utf-8"), re.M)
        if used.intersection(declared) and f"platform/{header.name}" not in text:
            complaints.append(f"{page.name}: which header has {', '.join(sorted(used.intersection(declared)))}? platform/{header.name}")
    if used and "ingot::platform`" not in text and "ingot::platform)" not in text:
        complaints.append(f"{page.name}: ingot::platform has to be linked, and the page does not say so")


def check_article(page, text, complaints):
    """Rows of an equation: what their third cell names stands in the files of the fourth."""
    for cells in re.findall(r"^\| [\d to]+ \|[^|]*\|([^|]*)\|([^|]*)\|$", text, re.M):
        source = "".join((ROOT / path).read_text(encoding="utf-8") for path in IN_TICKS.findall(cells[1]) if (ROOT / path).exists())
        for name in IN_TICKS.findall(cells[0]):
            if not re.search(rf"\b{name}\b", source):
                complaints.append(f"{page.name}: {name} is not in {cells[1].strip()}")


def check_other_page(page, text, complaints):
    """Pages of the repository that are none of the guide: their links, and the paths that they name, in the kernel from there too."""
    check_links(page, text, complaints)
    for path in re.findall(r"`((?:\w+/)+\w+\.(?:h|cpp|py|md|cmake|csv|sh))`", prose_of(text)):
        if not any((folder / path).exists() for folder in (ROOT, page.parent, ROOT / "kernel", ROOT / "host_tests")):
            complaints.append(f"{page.relative_to(ROOT)}: no path {path}")


def check_measured(page, text, complaints):
    """Figures that a person typed."""
    bare = TABLE.sub("", text)
    bare = FIGURE.sub("", IN_TICKS.sub("", prose_of(bare)))
    for found in MEASURED.finditer(bare):
        complaints.append(f"{page.name}: who wrote this figure? {found[0].strip()}")


def complaints_about(page, text, known, words, partly=False):
    complaints = []
    if with_figures(page, text, known, complaints, partly) != text:
        complaints.append(f"{page.name}: stale figures: cmake --build <a host build> --target update_guide")
    check_links(page, text, complaints)
    check_names(page, text, words, complaints)
    for sentence in re.findall(r"<!--while: (.*?)-->", text):
        if sentence not in known["sentences_of_compiler"]:
            complaints.append(f"{page.name}: the compiler does not say any more: {sentence}")
    check_measured(page, text, complaints)
    check_headers(page, text, complaints)
    if page.parent == GUIDE:
        check_article(page, text, complaints)
    return complaints


def check_pictures(program, update):
    """Pictures are what the program draws; with update they become it. Each example has one, and each flag of draw()."""
    complaints = []
    with tempfile.TemporaryDirectory() as folder:
        for name in ["draw"] + [file.stem for file in examples()]:
            subprocess.run([program, name, folder], check=True, stdout=subprocess.DEVNULL)
        drawn = {file.name: file.read_text(encoding="utf-8") for file in pathlib.Path(folder).glob("*.svg")}
    kept = {file.name: file.read_text(encoding="utf-8") for file in PICTURES.glob("*.svg")}
    for name in sorted(drawn.keys() | kept.keys()):
        if update and name in drawn:
            PICTURES.mkdir(exist_ok=True)
            (PICTURES / name).write_text(drawn[name], encoding="utf-8")
        elif update:
            (PICTURES / name).unlink()
        elif drawn.get(name) != kept.get(name):
            complaints.append(f"pictures/{name} is stale: cmake --build <a host build> --target update_guide_pictures")
    return complaints


def check_all_are_shown(complaints):
    """Each picture and each example stands on a page."""
    text = "".join(page.read_text(encoding="utf-8") for page in pages())
    complaints += [f"no page shows pictures/{file.name}" for file in sorted(PICTURES.glob("*"))
                   if f"pictures/{file.name})" not in text]
    complaints += [f"examples.md has no example.{file.stem}" for file in examples() if f"<!-- table: example.{file.stem} -->" not in text]


def try_page(page, folder):
    """As a stranger: this repository lies in the folder `ingot`."""
    text = (GUIDE / page).read_text(encoding="utf-8")
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)  # of the time before
    folder.mkdir(parents=True)
    (folder / "ingot").symlink_to(ROOT, target_is_directory=True)
    for name, content in re.findall(r"^<!-- file: (\S+) -->\n```\w+\n(.*?)^```$", text, re.M | re.S):
        (folder / name).write_text(content, encoding="utf-8")
    for commands in re.findall(r"^```sh\n(.*?)^```$", text, re.M | re.S):
        if "apt-get" not in commands:
            subprocess.run(["sh", "-ex", "-c", commands], cwd=folder, check=True)


def main():
    if sys.argv[1] == "--try":
        try_page(sys.argv[2], sys.argv[3])
        return
    if sys.argv[1] == "--extract":
        pathlib.Path(sys.argv[2]).write_text(extracted(), encoding="utf-8")
        return
    if sys.argv[1] in ("--check-pictures", "--update-pictures"):
        complaints = check_pictures(sys.argv[2], sys.argv[1] == "--update-pictures")
        if complaints:
            sys.exit("\n".join(complaints))
        return
    known = figures([argument for argument in sys.argv[2:] if argument != "--partly"])
    if sys.argv[1] == "--update":
        for page in pages():
            text, complaints = page.read_text(encoding="utf-8"), []
            page.write_text(with_figures(page, text, known, complaints), encoding="utf-8")
            print(*complaints, sep="\n", end="\n" if complaints else "")
        return
    words = words_of_ingot()
    complaints = [complaint for page in pages() for complaint in complaints_about(page, page.read_text(encoding="utf-8"), known, words, "--partly" in sys.argv)]
    for folder in (ROOT, *(ROOT / name for name in ("kernel", "platform", "host_tests", "toolchains", "fuzz"))):
        for page in sorted(folder.glob("*.md") if folder == ROOT else folder.rglob("*.md")):
            if page not in pages():
                check_other_page(page, page.read_text(encoding="utf-8"), complaints)
    check_all_are_shown(complaints)
    if complaints:
        sys.exit("\n".join(complaints))


if __name__ == "__main__":
    main()
