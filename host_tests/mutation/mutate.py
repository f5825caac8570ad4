#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Mutation run over kernel/: small faults are put in, one at a time, and the host tests have to notice.

    mutate.py [--count 400] [--seed 1] [--jobs 2] [--rooms blocks,collide] [--programs query_test,laws_test] [--brief] [--again LOG]
              [--scratch build/mutation]

A sample of mutants is drawn: operators and comparisons exchanged, constants changed, conditions negated, statements left out. clang's syntax tree
says where they are. All of the sample are compiled at once into a copy of the tree, each behind a question `is this one switched on?`, so a mutant
costs no build but only its tests: those cases of the GoogleTest programs that were seen to come by it, the quick ones first, until one fails,
crashes or takes ten times its time. (float, 4 lanes, gcc; all of it is float arithmetic with one order, so what kills is seldom a matter of chance.)

Not mutated: what is computed by the compiler (limits, static_assert, constexpr variables, array sizes, conditions of if constexpr) and macros.
What the golden hashes alone would notice is not counted: a hash says that something changed, not what is right.

A run in two parts takes less time: the first is brief, and what survives it is played again with all draws, by --again and the output of the first.

Prints the score of each room and the survivors. survivors.csv lists those that were looked at, with the reason why no test can tell them from the
kernel; they are not played and do not count. Columns: file, original, mutant (both as the run prints them), a piece of the line (may be empty), reason.
Fails when the score is below --least.
"""
import argparse
import bisect
import collections
import concurrent.futures
import csv
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))

EXCHANGED = {"+": "-", "-": "+", "*": "/", "/": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
             "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=", "<<": ">>", ">>": "<<", "&": "|", "|": "&"}
OF_VECTORS = ("+", "-", "+=", "-=")  # what vectors have the exchange of, too
DELETED = ("CallExpr", "CXXMemberCallExpr", "CXXOperatorCallExpr", "BinaryOperator", "CompoundAssignOperator", "UnaryOperator", "BreakStmt",
           "ContinueStmt", "ExprWithCleanups")
PROGRAMS_LEFT_OUT = re.compile(r"reference|report|platform|golden|same_output")

Mutant = collections.namedtuple("Mutant", "file begin end line original mutant text")


class Syntax:
    """Mutants of the kernel from clang's JSON, whose places name file and line only where they change."""

    def __init__(self, kernel):
        self.kernel = kernel
        self.file = ""
        self.sources = {}
        self.found = {}

    def place(self, location):
        """(offset, end) in self.file, or None within macros."""
        if not location:
            return None
        if "spellingLoc" in location or "expansionLoc" in location:
            for part in location.values():
                self.place(part)
            return None
        if "file" in location:
            self.file = location["file"]
        if "offset" not in location:
            return None
        return self.file, location["offset"], location["offset"] + location.get("tokLen", 0)

    def source(self, path):
        if path not in self.sources:
            with open(path, "rb") as file:
                self.sources[path] = file.read()
        return self.sources[path]

    def text(self, span):
        return self.source(span[0])[span[1]:span[2]].decode()

    def add(self, span, mutant, text):
        """text: what stands there instead, {0} being the question whether the mutant is switched on."""
        original = self.text(span)
        line = self.source(span[0]).count(b"\n", 0, span[1]) + 1
        fold = lambda s: " ".join(s.split())
        key = (span, mutant)
        if key not in self.found:
            self.found[key] = Mutant(span[0], span[1], span[2], line, fold(original), fold(mutant), text)


def collect(node, syntax, parent=None, fixed=False):
    """Mutants of a node whose places are known; fixed: the compiler computes it."""
    kind = node.get("kind", "")
    if kind in ("CXXMethodDecl", "CXXConstructorDecl") and (node.get("isImplicit") or node.get("explicitlyDefaulted")):
        return  # what the compiler writes has the place of the name
    inner = [child for child in node.get("inner", []) if child]
    fixed = fixed or kind in ("ConstantExpr", "StaticAssertDecl", "EnumConstantDecl") or bool(node.get("constexpr") and kind == "VarDecl")
    span = node.get("span")
    if span and not fixed:
        text = syntax.text(span)
        if kind in ("BinaryOperator", "CompoundAssignOperator") and len(inner) == 2 or kind == "CXXOperatorCallExpr" and len(inner) == 3:
            left, right = (child.get("span") for child in inner[-2:])
            if left and right and left[0] == right[0] == span[0] and left[2] <= right[1]:
                between = syntax.source(span[0])[left[2]:right[1]].decode()
                operator = between.strip()
                if operator in EXCHANGED and (kind != "CXXOperatorCallExpr" or operator in OF_VECTORS):
                    a, b = syntax.text(left), syntax.text(right)
                    syntax.add(span, "%s %s %s" % (a, EXCHANGED[operator], b), "({0} ? (%s%s%s) : (%s))" % (
                        a, between.replace(operator, EXCHANGED[operator]), b, text))
        elif kind == "IntegerLiteral" and text.isdigit():
            syntax.add(span, str(int(text) + 1), "({0} ? %d : %s)" % (int(text) + 1, text))
        elif kind == "FloatingLiteral":
            number = text.rstrip("fFlL")
            value = float.fromhex(number) if number.lower().startswith("0x") else float(number)
            other = "1.0" if value == 0 else "2 * " + text
            syntax.add(span, other, "({0} ? %s : %s)" % (other, text))
        elif kind == "IfStmt" and not node.get("isConstexpr") and not node.get("hasInit") and not node.get("hasVar") and inner and inner[0].get("span"):
            condition = inner[0]["span"]
            syntax.add(condition, "!(%s)" % syntax.text(condition), "({0} != static_cast<bool>(%s))" % syntax.text(condition))
        elif kind == "ConditionalOperator" and inner and inner[0].get("span"):
            condition = inner[0]["span"]
            syntax.add(condition, "!(%s)" % syntax.text(condition), "({0} ? !(%s) : (%s))" % (syntax.text(condition), syntax.text(condition)))
        if parent == "CompoundStmt" and kind in DELETED and not text.startswith("("):
            syntax.add(span, "nothing", "if (!{0}) %s" % text)
    for child_i, child in enumerate(inner):
        collect(child, syntax, kind, fixed or kind == "IfStmt" and bool(node.get("isConstexpr")) and child_i == 0)


def candidates(build):
    """All mutants of the kernel."""
    unit = os.path.join(build, "all_of_it.cpp")
    sources = sorted(os.path.join(directory, name) for directory, _, names in os.walk(os.path.join(ROOT, "kernel")) for name in names if name.endswith(".cpp"))
    headers = sorted(os.path.join(directory, name) for directory, _, names in os.walk(os.path.join(ROOT, "kernel")) for name in names if name.endswith(".h"))
    with open(unit, "w") as file:
        file.write("".join('#include "%s"\n' % path for path in sources + headers))
    clang = next(name for name in ["clang++"] + ["clang++-%d" % version for version in range(22, 13, -1)] if shutil.which(name))
    tree = subprocess.run([clang, "-std=gnu++17", "-DINGOT_ASSERTS=0", "-DINGOT_DOUBLE=0", "-DINGOT_LANES=4", "-w", "-Xclang", "-ast-dump=json",
                           "-fsyntax-only", unit], check=True, stdout=subprocess.PIPE).stdout
    sys.setrecursionlimit(100000)
    syntax = Syntax(os.path.join(ROOT, "kernel"))
    root = json.loads(tree)
    del tree

    def places(node):
        if "loc" in node:
            syntax.place(node["loc"])
        if "range" in node:
            begin = syntax.place(node["range"].get("begin"))
            end = syntax.place(node["range"].get("end"))
            if begin and end and begin[0] == end[0]:
                path = os.path.realpath(begin[0])
                if path.startswith(syntax.kernel + os.sep):
                    node["span"] = (path, begin[1], end[2])
        for child in node.get("inner", []):
            if child:
                places(child)

    places(root)
    collect(root, syntax)
    return sorted(syntax.found.values())


def sample(mutants, count, seed, rooms):
    """Mutants that do not overlap. Each has its place in the draw by what it is: a change of the kernel elsewhere leaves the sample as it was."""
    if rooms:
        mutants = [mutant for mutant in mutants if room_of(mutant) in rooms]
    twins = collections.Counter()
    draw = []
    for mutant in mutants:
        what = (os.path.relpath(mutant.file, ROOT), mutant.original, mutant.mutant)
        draw.append((hashlib.sha256(repr((seed, what, twins[what])).encode()).digest(), mutant))
        twins[what] += 1
    chosen, taken = [], collections.defaultdict(list)
    for _, mutant in sorted(draw):
        spans = taken[mutant.file]
        at = bisect.bisect(spans, (mutant.begin, mutant.end))
        if any(begin < mutant.end and mutant.begin < end for begin, end in spans[max(0, at - 1):at + 1]):
            continue
        bisect.insort(spans, (mutant.begin, mutant.end))
        chosen.append(mutant)
        if len(chosen) == count:
            break
    return sorted(chosen)


def room_of(mutant):
    return os.path.relpath(mutant.file, os.path.join(ROOT, "kernel")).split(os.sep)[0]


def write_tree(mutants, tree):
    """The kernel with all mutants in it, switched off. Numbers begin with 1. Files that stay the same are not touched."""
    by_file = collections.defaultdict(list)
    for number, mutant in mutants.items():
        by_file[mutant.file].append((mutant.begin, number, mutant))
    for directory, _, names in os.walk(os.path.join(ROOT, "kernel")):
        for name in names:
            path = os.path.join(directory, name)
            with open(path, "rb") as file:
                content = file.read()
            for begin, number, mutant in sorted(by_file[path], reverse=True):
                text = mutant.text.replace("{0}", "INGOT_MUTANT(%d)" % number)
                lost = content[begin:mutant.end].count(b"\n") - text.count("\n")
                content = content[:begin] + text.encode() + b"\n" * max(0, lost) + content[mutant.end:]
            to = os.path.join(tree, os.path.relpath(path, ROOT))
            if not os.path.exists(to) or open(to, "rb").read() != content:
                os.makedirs(os.path.dirname(to), exist_ok=True)
                with open(to, "wb") as file:
                    file.write(content)


def copy_tree(tree):
    files = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout.split("\n")
    for name in files:
        if name and not name.startswith("kernel/") and os.path.isfile(os.path.join(ROOT, name)):
            to = os.path.join(tree, name)
            os.makedirs(os.path.dirname(to), exist_ok=True)
            if not os.path.exists(to) or open(to, "rb").read() != open(os.path.join(ROOT, name), "rb").read():
                shutil.copyfile(os.path.join(ROOT, name), to)
    shutil.copyfile(os.path.join(ROOT, "kernel", "CMakeLists.txt"), os.path.join(tree, "kernel", "CMakeLists.txt"))


def build_all(mutants, scratch, jobs, wanted, brief):
    """Builds the tests of the mutated tree, or those wanted, brief as the preset `test` has them or all of it; drops the mutants that do not compile. Returns the test programs."""
    tree, build = os.path.join(scratch, "tree"), os.path.join(scratch, "build")
    os.makedirs(os.path.join(tree, "kernel"), exist_ok=True)
    copy_tree(tree)
    runtime = os.path.join(scratch, "switch.o")
    subprocess.run(["g++", "-O2", "-c", os.path.join(HERE, "switch.cpp"), "-o", runtime], check=True)
    write_tree(mutants, tree)
    level = ["-DINGOT_TEST_BRIEF=ON", "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DINGOT_KERNEL_LEVEL=O1"] if brief else ["-DCMAKE_CXX_FLAGS_DEBUG=-O1"]
    subprocess.run(["cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_TOOLCHAIN_FILE=" + os.path.join(tree, "toolchains", "host-gcc.cmake"),
                    "-DCMAKE_BUILD_TYPE=Debug", *level, "-DCMAKE_CXX_FLAGS=-w -include " + os.path.join(HERE, "switch.h"),
                    "-DCMAKE_CXX_STANDARD_LIBRARIES=" + runtime, "-DINGOT_SCALAR=float", "-DINGOT_LANES=4", "-DINGOT_BUILD_DEMO=OFF",
                    "-DINGOT_BUILD_REPORT=OFF"], check=True, stdout=subprocess.DEVNULL)
    targets = subprocess.run(["ninja", "-C", build, "-t", "targets", "all"], check=True, stdout=subprocess.PIPE, text=True).stdout
    programs = sorted(set(re.findall(r"^(host_tests/\S+_test): CXX_EXECUTABLE_LINKER", targets, re.M)))
    programs = [program for program in programs if not PROGRAMS_LEFT_OUT.search(program) and (not wanted or os.path.basename(program) in wanted)]
    stages = [["ingot_kernel"], [program for program in programs if "saved_pile" in program or "mass_properties" in program], programs]
    for _ in range(40):
        run = subprocess.run(["ninja", "-C", build, "-j", str(jobs), "-k", "0" if len(stages) > 1 else "5"] + stages[0], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if run.returncode == 0 and len(stages) > 1:
            del stages[0]  # what is wrong with a header is found where few units are compiled
            continue
        if run.returncode == 0:
            return [os.path.join(build, program) for program in programs]
        bad = {(os.path.relpath(os.path.realpath(path), tree), int(line)) for path, line in
               re.findall(r"(\S*/kernel/[\w/.]+):(\d+):\d+: error", run.stdout) + re.findall(r"(\S*/kernel/[\w/.]+):(\d+):\d+:   required", run.stdout)}
        dropped = [number for number, mutant in mutants.items() if (os.path.relpath(mutant.file, ROOT), mutant.line) in bad]
        if not dropped:
            sys.exit(run.stdout[-4000:])
        print("%d mutants do not compile" % len(dropped), flush=True)
        for number in dropped:
            del mutants[number]
        write_tree(mutants, tree)
    sys.exit("the mutated tree does not build")


def run_cases(program, cases, number, patience, reached=None):
    """True if all pass. A mutant may do whatever it likes: its memory is bounded, and its time."""
    environment = dict(os.environ, INGOT_MUTANT=str(number), GTEST_COLOR="no", GTEST_FAIL_FAST="1", GTEST_BRIEF="1")
    if reached:
        environment["INGOT_REACHED"] = reached
    try:
        return subprocess.run(["prlimit", "--as=4000000000", "--core=0", program, "--gtest_filter=" + ":".join(cases)], env=environment,
                              cwd=os.path.dirname(program), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=patience).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def list_cases(program):
    suite, cases = "", []
    for line in subprocess.run([program, "--gtest_list_tests"], check=True, stdout=subprocess.PIPE, text=True).stdout.split("\n"):
        name = line.split("#")[0].strip()
        if line and not line.startswith(" "):
            suite = name if name.endswith(".") else ""
        elif name and suite and "DISABLED_" not in suite + name:
            cases.append(suite + name)
    return cases


Case = collections.namedtuple("Case", "program name seconds")


def survey(programs, scratch, slowest, jobs):
    """{number: cases that come by it, the quick ones first}."""
    def one(program, name):
        note = os.path.join(scratch, "reached_%d" % (hash((program, name)) & 0xffffffffffff))
        begin = time.time()
        passed = run_cases(program, [name], 0, slowest, note)
        seconds = time.time() - begin
        numbers = []
        if os.path.exists(note):
            numbers = [int(number) for number in open(note).read().split()]
            os.remove(note)
        return Case(program, name, seconds), passed, numbers

    reaching, left_out = collections.defaultdict(list), []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for case, passed, numbers in pool.map(lambda pair: one(*pair), [(program, name) for program in programs for name in list_cases(program)]):
            if not passed:
                left_out.append(case.name)
            for number in numbers if passed else []:
                reaching[number].append(case)
    print("%d cases are left out: they fail or take more than %g s" % (len(left_out), slowest), *left_out, sep="\n    ")
    return {number: sorted(cases, key=lambda case: case.seconds) for number, cases in reaching.items()}


def killer(number, cases, budget):
    """The program that notices, or None."""
    spent, position = 0, 0
    for most in (0.05, 0.3, 1e9):
        tier = collections.defaultdict(list)
        while position < len(cases) and cases[position].seconds <= most and spent < budget:
            case = cases[position]
            tier[case.program].append(case)
            spent += case.seconds
            position += 1
        for program, group in sorted(tier.items(), key=lambda item: sum(case.seconds for case in item[1])):
            if not run_cases(program, [case.name for case in group], number, 5 + 10 * sum(case.seconds for case in group)):
                return os.path.basename(program)
    return None


def read_reviewed():
    """Whether a mutant is one of survivors.csv."""
    pieces = collections.defaultdict(list)
    with open(os.path.join(os.path.dirname(HERE), "tables", "survivors.csv")) as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            pieces[row["file"], row["original"], row["mutant"]].append(row["line"])

    def is_reviewed(mutant):
        with open(mutant.file) as file:
            line = file.read().split("\n")[mutant.line - 1]
        return any(piece in line for piece in pieces[os.path.relpath(mutant.file, ROOT), mutant.original, mutant.mutant])

    return is_reviewed


def described(mutant):
    return "%s:%d: %s  ->  %s" % (os.path.relpath(mutant.file, ROOT), mutant.line, mutant.original, mutant.mutant)


def read_run(log):
    """What survived a run, and how many were noticed in it, and are reviewed, of its output."""
    with open(log) as file:
        lines = file.read().split("\n")
    survivors = {line[len("survives: "):].split("   (no case")[0] for line in lines if line.startswith("survives: ")}
    totals = [line.split() for line in lines if line.startswith("kernel ")]
    if not totals:
        sys.exit(log + " is not the output of a run that has ended")
    return survivors, int(totals[0][2]), int(totals[0][3])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--rooms", type=lambda names: names.split(","), default=[])
    parser.add_argument("--programs", type=lambda names: names.split(","), default=[], help="what these notice alone: quick, while tests are written")
    parser.add_argument("--brief", action="store_true", help="tests as brief as the preset `test` has them: half the time, and less is noticed")
    parser.add_argument("--again", help="output of a run of the same count and seed, on this kernel: what survived there is played again")
    parser.add_argument("--scratch", default=os.path.join(ROOT, "build", "mutation"))
    parser.add_argument("--slowest", type=float, default=30.0, help="seconds of a case; slower ones are left out")
    parser.add_argument("--budget", type=float, default=300.0, help="seconds of tests for one mutant")
    parser.add_argument("--least", type=float, default=90.0, help="per cent of the mutants that are to be noticed")
    arguments = parser.parse_args()
    scratch = os.path.abspath(arguments.scratch)
    os.makedirs(scratch, exist_ok=True)

    everything = candidates(scratch)
    mutants = dict(enumerate(sample(everything, arguments.count, arguments.seed, arguments.rooms), 1))
    noticed_before = reviewed_before = 0
    if arguments.again:
        survivors_before, noticed_before, reviewed_before = read_run(arguments.again)
        mutants = {number: mutant for number, mutant in mutants.items() if described(mutant) in survivors_before}
    print("%d mutants of %d" % (len(mutants), len(everything)), flush=True)
    programs = build_all(mutants, scratch, arguments.jobs, arguments.programs, arguments.brief)
    print("built %d programs with %d mutants" % (len(programs), len(mutants)), flush=True)
    reaching = survey(programs, scratch, arguments.slowest, arguments.jobs)
    is_reviewed = read_reviewed()

    rooms = collections.defaultdict(lambda: [0, 0, 0])  # mutants, killed, equal by review
    begin = time.time()
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        play = lambda number: None if is_reviewed(mutants[number]) else killer(number, reaching.get(number, []), arguments.budget)
        for number, found in zip(mutants, pool.map(play, mutants)):
            mutant = mutants[number]
            room = rooms[room_of(mutant)]
            room[0] += 1
            if found:
                room[1] += 1
            elif is_reviewed(mutant):
                room[2] += 1
            else:
                print("survives: %s%s" % (described(mutant), "" if number in reaching else "   (no case comes by)"), flush=True)
    print("%-10s %8s %8s %9s %8s" % ("room", "mutants", "noticed", "reviewed", "per cent"))
    total = [sum(room[i] for room in rooms.values()) for i in range(3)]
    share = lambda room: 100.0 * room[1] / max(1, room[0] - room[2])
    for name, room in sorted(rooms.items()) + [("kernel", total)]:
        print("%-10s %8d %8d %9d %8.1f" % (name, *room, share(room)))
    if arguments.again:
        total = [total[0] + noticed_before + reviewed_before, total[1] + noticed_before, total[2] + reviewed_before]
        print("%-10s %8d %8d %9d %8.1f" % ("both runs", *total, share(total)))
    print("%.0f s of tests, seed %d" % (time.time() - begin, arguments.seed))
    if total[0] == 0 or share(total) < arguments.least:
        sys.exit("mutation score %.1f %%, and %.1f %% are asked for" % (share(total), arguments.least))


if __name__ == "__main__":
    main()
