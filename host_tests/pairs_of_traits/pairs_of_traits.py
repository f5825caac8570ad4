#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every pair of traits compiles, runs and has a golden hash, or is refused with a sentence.

    pairs_of_traits.py --units TABLE DIR COUNT      writes unit_0.cpp .. and main.cpp: the scenes of pairs.csv, or of covering.csv
    pairs_of_traits.py --check-table [SCENE.H]      every member of Scene is in traits.toml, every pair in pairs.csv
    pairs_of_traits.py --check-refused COMPILE...   the compiler refuses the pairs it has to, with these sentences, and no others
    pairs_of_traits.py --check-only-refused COMPILE...  the same of the pairs that are refused; the others run in the scenes of covering.csv
    pairs_of_traits.py --check-hashes TABLE PROGRAM SCALAR
    pairs_of_traits.py --update-refused COMPILE...  writes which pairs are refused to pairs.csv; and covering.csv anew
    pairs_of_traits.py --update-hashes TABLE PROGRAM SCALAR

A pair is a row of pairs.csv: its traits, the base it stands in, and a hash for each scalar, over all lanes and compilers; or the sentence.
A row of covering.csv is a scene of many traits: every pair that runs is in one of them (a covering array of strength 2: D. M. Cohen, S. R. Dalal,
M. L. Fredman, G. C. Patton, "The AETG system", IEEE Transactions on Software Engineering 23(7), 1997).
"""
import csv
import itertools
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
HOUSE = HERE.parents[1]
TABLES, SCENE = HERE.parent / "tables", HOUSE / "kernel/world/scene.h"
TABLE, COVERING = TABLES / "pairs.csv", TABLES / "covering.csv"
COLUMNS = ("trait", "other", "base", "float", "double", "sentence")
COVERING_COLUMNS = ("traits", "base", "float", "double")
TRAITS_OF_SCENE_MAX = 12  # of covering.csv: with more, one fault hides the next
BASE_SHAPES = ("Sphere", "Box", "HalfSpace")

settings = tomllib.loads((HERE / "traits.toml").read_text())
BASES, TRAITS = settings["base"], settings["trait"]


def members_of_scene(header):
    body = re.search(r"^struct Scene \{\n(.*?)^\};", pathlib.Path(header).read_text(), re.M | re.S).group(1)
    return re.findall(r"^    static constexpr [\w:]+ +(\w+) *=", body, re.M) + re.findall(r"^    using (\w+) *=", body, re.M)


def are_alternatives(a, b):
    """One of two values of the same member: no scene names both."""
    ours, theirs = TRAITS[a].get("sets", {}), TRAITS[b].get("sets", {})
    return any(name in theirs and theirs[name] != value for name, value in ours.items())


PAIRS = [(a, b) for a, b in itertools.combinations(TRAITS, 2) if not are_alternatives(a, b)]


def bases_of(*names):
    """Those to try. A trait that makes a base stands in no other; two such make both."""
    fixed = [TRAITS[name]["of"] for name in names if "of" in TRAITS[name]]
    return [fixed[0]] if fixed else list(BASES)


def scene(struct, base, *names):
    """The struct, as C++."""
    members = dict(BASES[base])
    for name in names:
        members.update(TRAITS[name].get("also", {}))
    for name in names:
        members.update(TRAITS[name].get("sets", {}))
    shapes = list(BASE_SHAPES)
    for name in names:
        shapes += TRAITS[name].get("shapes", [])
    lines = [f"struct {struct} : ingot::Scene {{", "    static constexpr int max_bodies = yard::max_bodies;",
             "    using shapes = ingot::Shapes<" + ", ".join(f"ingot::{shape}" for shape in shapes) + ">;"]
    for name, value in members.items():
        lines.append("    " + (f"using {value};" if re.match(r"\w+ =", value) else f"static constexpr {value};"))
    for verb, more, last in (("set_up", "", ""), ("edit", ", [[maybe_unused]] int step_i", "")):
        lines.append("    template <class W>")
        lines.append(f"    static void {verb}([[maybe_unused]] W& world, [[maybe_unused]] const yard::Ids& yard{more}) {{")
        lines.append("        using namespace ::yard;")
        lines += ["        " + TRAITS[name][verb].strip() for name in names if verb in TRAITS[name]]
        lines.append("    }" + last)
    lines.append("};")
    return "\n".join(lines) + "\n"


def struct_name(*names):
    return "__".join(names)


def read_table():
    with open(TABLE, newline="") as file:
        return {(row["trait"], row["other"]): row for row in csv.DictReader(file)}


def read_covering():
    if not COVERING.exists():
        return {}
    with open(COVERING, newline="") as file:
        return {tuple(row["traits"].split("+")): row for row in csv.DictReader(file)}


def read_scenes(table):
    """{traits: row} of those that run, of either table."""
    rows = read_table() if pathlib.Path(table).name == TABLE.name else read_covering()
    return {names: row for names, row in rows.items() if not row.get("sentence")}


def write_rows(path, columns, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


HEAD = "// Written by pairs_of_traits.py.\n#include \"pairs_of_traits/yard.h\"\n\nnamespace pairs {\n\n"


def write_if_new(path, text):
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def write_units(table, folder, count):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    rows = list(read_scenes(table).items())
    for unit_i in range(count):
        text, calls = HEAD + "namespace {\n\n", ""
        for scene_i, (names, row) in list(enumerate(rows))[unit_i::count]:
            struct = f"Scene_{scene_i}"
            text += scene(struct, row["base"], *names) + "\n"
            calls += f'    yard::run<{struct}>("{"+".join(names)}");\n'
        text += f"}}  // namespace\n\nvoid run_unit_{unit_i}();\nvoid run_unit_{unit_i}() {{\n{calls}}}\n\n}}  // namespace pairs\n"
        write_if_new(folder / f"unit_{unit_i}.cpp", text)
    text = "// Written by pairs_of_traits.py.\nnamespace pairs {\n" + "".join(f"void run_unit_{i}();\n" for i in range(count)) + "}\n\nint main() {\n"
    write_if_new(folder / "main.cpp", text + "".join(f"    pairs::run_unit_{i}();\n" for i in range(count)) + "}\n")


def sentences_of(compile_command, scenes):
    """Compiles worlds of {struct: text} and returns {struct: the sentences against it, in the order of the compiler}. One unit for all: each error names its scene."""
    text = HEAD + "".join(scenes.values())
    text += "".join(f"constexpr unsigned long size_of_{struct} = sizeof(ingot::World<{struct}>);\n" for struct in scenes) + "\n}  // namespace pairs\n"
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "scenes.cpp"
        source.write_text(text)
        limit = ["-ferror-limit=0"] if "clang" in pathlib.Path(compile_command[0]).name else ["-fmax-errors=0"]
        said = subprocess.run([*compile_command, *limit, str(source)], capture_output=True, text=True).stderr
    found, struct, sentence = {}, None, None
    for line in said.splitlines():
        inside = re.search(r"In instantiation of .*\[with .*?= pairs::(\w+)", line)
        if inside:  # gcc: before the error
            struct = inside.group(1)
        error = re.search(r"error: (?:static assertion failed|static_assert failed)(?: due to requirement '.*?')?:? \"?([^\"]+)\"?$", line)
        if error and "check_scene" not in error.group(1):
            sentence = error.group(1)
            if struct and not inside:
                found.setdefault(struct, []).append(sentence)
        elif re.search(r"error: ", line) and struct is None:
            raise SystemExit(f"pairs_of_traits: no sentence, but\n{line}")
        requested = re.search(r"instantiation of .*<pairs::(\w+)>' requested here", line)
        if requested and sentence:  # clang: after it
            found.setdefault(requested.group(1), []).append(sentence)
            sentence = None
    return found


def judge(compile_command, pairs=PAIRS):
    """{pair: (base, [])} of those that compile, {pair: (base, sentences)} of those that are refused."""
    alone = {struct_name(name, "in", base): (name, base) for name in TRAITS for base in BASES}
    refused_alone = sentences_of(compile_command, {struct: scene(struct, base, name) for struct, (name, base) in alone.items()})
    stands = {key for struct, key in alone.items() if struct not in refused_alone}
    tried = {}
    for a, b in pairs:
        fixed = bases_of(a, b)
        both = [base for base in fixed if (a, base) in stands and (b, base) in stands] or [base for base in fixed if (a, base) in stands] or fixed
        for base in both:
            tried[struct_name(a, b, "in", base)] = (a, b, base)
    refused = sentences_of(compile_command, {struct: scene(struct, base, a, b) for struct, (a, b, base) in tried.items()})
    verdict = {}
    for struct, (a, b, base) in tried.items():
        sentences = refused.get(struct, [])
        if (a, b) not in verdict or (verdict[a, b][1] and not sentences):
            verdict[a, b] = (base, sentences)
    return verdict


def cover(edges, together, size):
    """Sets of up to `size` traits, all pairs of them in `together`, each of `edges` in one of them: each begins with a pair that is left, and takes in
    the trait that brings most such pairs, while there is one."""
    order = {name: i for i, name in enumerate(TRAITS)}
    friends = {}
    for edge in together:
        for name in edge:
            friends.setdefault(name, set()).update(edge - {name})
    left, found = set(edges), []
    while left:
        names = sorted(min(left, key=lambda edge: sorted(order[name] for name in edge)), key=order.get)
        while len(names) < size:
            brings = {name: sum(frozenset((name, other)) in left for other in names) for name in set.intersection(*(friends[name] for name in names))}
            best = max(brings, key=lambda name: (brings[name], -order[name]), default=None)
            if best is None or brings[best] == 0:
                break
            names.append(best)
        found.append(tuple(sorted(names, key=order.get)))
        left -= {frozenset(pair) for pair in itertools.combinations(names, 2)}
    return found


def covering(compile_command, rows):
    """{traits: base}. Three may refuse each other that go together in pairs: such a scene is taken apart."""
    chosen = {}
    together = {frozenset(pair) for pair, row in rows.items() if not row["sentence"]}  # in one base or another: the compiler says in which
    for base in BASES:
        todo = [({frozenset(pair) for pair, row in rows.items() if row["base"] == base and not row["sentence"]}, TRAITS_OF_SCENE_MAX)]
        while todo:
            edges, size = todo.pop()
            scenes = {f"Scene_{i}": names for i, names in enumerate(cover(edges, together, size))}
            refused = sentences_of(compile_command, {struct: scene(struct, base, *names) for struct, names in scenes.items()}) if scenes else {}
            for struct, names in scenes.items():
                if struct in refused:
                    todo.append(({edge for edge in edges if edge <= set(names)}, max(2, len(names) // 2)))
                else:
                    chosen[names] = base
    return chosen


def kinds_of_scenes(rows):
    """{trait: the bases it stands in}, of those that do not make one: as its pairs with these say."""
    makers = {trait["of"]: name for name, trait in TRAITS.items() if "of" in trait}
    kinds = {}
    for name in TRAITS:
        if name not in makers.values():
            row = lambda maker: rows.get((maker, name)) or rows.get((name, maker))  # none: both set the same member
            kinds[name] = {base for base, maker in makers.items() if row(maker) and not row(maker)["sentence"]}
    return kinds


# What is said of traits that stand in some of the bases alone.
STANDS_IN = {("contacts",): "Only with `max_manifolds`", ("impacts",): "Only with `max_contacts`", ("flight",): "Only without contacts",
             ("contacts", "impacts"): "Only with `max_manifolds` or `max_contacts`", ("impacts", "flight"): "Never with `max_manifolds`",
             ("contacts", "flight"): "Never with `max_contacts`"}


def refused_table(rows):
    """Every pair that is refused, by the bases that its traits stand in, or by name: of guide/refused.md."""
    kinds = kinds_of_scenes(rows)
    named = {bases: [f"`{name}`" for name, stands in kinds.items() if stands == set(bases)] for bases in STANDS_IN}
    stand = " ".join(f"{words}: {', '.join(named[bases])}." for bases, words in STANDS_IN.items() if named[bases])
    odd = [name for name, stands in kinds.items() if tuple(base for base in ("contacts", "impacts", "flight") if base in stands) not in
           [*STANDS_IN, ("contacts", "impacts", "flight")]]
    assert not odd, f"say in STANDS_IN where these stand: {odd}"
    refused = {}
    for (a, b), row in rows.items():
        makers = a not in kinds and b not in kinds
        if row["sentence"] and (makers or (a in kinds and b in kinds and kinds[a] & kinds[b])):
            refused.setdefault(row["sentence"], []).append((a, b))
    count = sum(1 for row in rows.values() if row["sentence"])
    lines = [f"{len(rows) - count} of {len(rows)} pairs of traits go together, each tried in a scene that uses both; the others do not compile, and say why.",
             stand,
             "", "| not together | what the compiler says |", "| --- | --- |"]
    for sentence, pairs in refused.items():
        partners, share = {}, {}
        for name in itertools.chain(*pairs):
            share[name] = share.get(name, 0) + 1
        for a, b in pairs:  # the one that is in more of them stands first
            first, second = (a, b) if share[a] >= share[b] else (b, a)
            partners.setdefault(first, []).append(second)
        said = "; ".join(f"`{first}` with " + ", ".join(f"`{name}`" for name in others) for first, others in partners.items())
        lines.append(f"| {said} | {sentence} |")
    return "\n".join(lines)


def fail(complaints):
    for complaint in complaints:
        print(f"pairs_of_traits: {complaint}")
    sys.exit(1 if complaints else 0)


def check_table(header=SCENE):
    members = members_of_scene(header)
    named = {member for trait in TRAITS.values() for member in trait.get("sets", {})} | set(settings["always"])
    complaints = [f"no trait of traits.toml sets {member} of Scene" for member in members if member not in named]
    complaints += [f"Scene has no {member}" for member in sorted(named) if member not in members]
    rows = read_table()
    complaints += [f"{a} with {b} has no row in pairs.csv" for a, b in PAIRS if (a, b) not in rows]
    complaints += [f"{a} with {b} is a row of pairs.csv, and no pair" for a, b in rows if (a, b) not in PAIRS]
    covered = {pair for names in read_covering() for pair in itertools.combinations(names, 2)}
    complaints += [f"{a} with {b} runs, and is in no row of covering.csv: --update-refused" for (a, b), row in rows.items()
                   if not row["sentence"] and (a, b) not in covered]
    fail(complaints)


def check_refused(compile_command, pairs=PAIRS):
    rows, verdict = read_table(), judge(compile_command, pairs)
    if missing := [pair for pair in verdict if pair not in rows]:
        fail([f"{a} with {b} has no row in pairs.csv" for a, b in missing])
    # Where several sentences are said, compilers differ in which comes first.
    fail([f"{a} with {b}: the table says '{rows[a, b]['sentence'] or 'runs in ' + rows[a, b]['base']}', the compiler {sentences or 'runs in ' + base}"
          for (a, b), (base, sentences) in verdict.items()
          if rows[a, b]["base"] != base or (rows[a, b]["sentence"] not in sentences if sentences else rows[a, b]["sentence"])])


def update_refused(compile_command):
    old = read_table() if TABLE.exists() else {}
    rows = {}
    for pair, (base, sentences) in judge(compile_command).items():
        sentence = sentences[0] if sentences else ""
        kept = {} if sentence else {key: old.get(pair, {}).get(key, "") for key in ("float", "double")}
        rows[pair] = dict.fromkeys(COLUMNS, "") | {"trait": pair[0], "other": pair[1], "base": base, "sentence": sentence} | kept
    write_rows(TABLE, COLUMNS, (rows[pair] for pair in PAIRS))
    old = read_covering()
    write_rows(COVERING, COVERING_COLUMNS, ({"float": "", "double": ""} | old.get(names, {}) | {"traits": "+".join(names), "base": base}
                                            for names, base in covering(compile_command, rows).items()))


def hashes_of(program):
    said = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    return {tuple(line.rsplit(",", 1)[0].split("+")): line.rsplit(",", 1)[1] for line in said.split()}


def check_hashes(table, program, scalar):
    hashes = hashes_of(program)
    fail([f"{' with '.join(names)}: {hashes.get(names, 'not run')}, and {row[scalar] or 'nothing'} in {pathlib.Path(table).name}"
          for names, row in read_scenes(table).items() if hashes.get(names) != row[scalar]])


def update_hashes(table, program, scalar):
    is_pairs = pathlib.Path(table).name == TABLE.name
    rows = read_table() if is_pairs else read_covering()
    for names, value in hashes_of(program).items():
        rows[names][scalar] = value
    write_rows(*((TABLE, COLUMNS) if is_pairs else (COVERING, COVERING_COLUMNS)), rows.values())


if __name__ == "__main__":
    verb, arguments = sys.argv[1], sys.argv[2:]
    if verb == "--units":
        write_units(arguments[0], arguments[1], int(arguments[2]))
    else:
        {"--check-table": check_table, "--check-refused": lambda *command: check_refused(command),
         "--check-only-refused": lambda *command: check_refused(command, [pair for pair, row in read_table().items() if row["sentence"]]),
         "--check-hashes": check_hashes, "--update-refused": lambda *command: update_refused(command), "--update-hashes": update_hashes}[verb](*arguments)
