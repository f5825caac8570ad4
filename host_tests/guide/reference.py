#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The reference: what Doxygen is shown of headers and pages, and the list of headers that users meet.

    reference.py --write FOLDER          writes what Doxygen reads: headers without what only the kernel asks for, and the pages
    reference.py --check FOLDER          fails where Doxygen has warned of anything, or the pages it wrote lack a call

Of a header it hides what only the kernel asks for: protected parts, and the names below. A comment of a class that is followed by a blank line is of
all calls up to the next, a group; where several names are declared at once, the comment is of each.
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
KERNEL, GUIDE = ROOT / "kernel", ROOT / "host_tests" / "guide"

# What ingot.h brings along that a user names: calls, arguments, answers, traits, and what is to be put there.
HEADERS = """
ingot.h
world/world.h world/world_adds.h world/world_bodies.h world/world_touching.h world/world_edits.h world/world_kinematic.h world/world_joints.h world/world_drives.h
world/world_reactions.h world/world_ties.h world/world_contacts.h world/world_reads.h world/world_queries.h
world/world_dynamics.h figure/dynamics.h base/workers.h
world/world_mover.h mover/mover.h mover/solve_planes.h
world/body_def.h world/contact_info.h world/scene.h world/step.h world/snapshot.h world/draw.h
base/config.h base/status.h base/report.h base/ids.h base/limits.h base/effort.h base/version.h base/floating_point.h
body/mass_properties.h body/check_body.h body/kinematics.h body/user_frame.h
shape/shapes.h shape/compound.h shape/convex_hull.h shape/hull_of_points.h shape/placed_shape.h
math/vec3.h math/mat3.h math/sym3.h math/rotation.h math/quaternion.h math/trig.h math/sqrt.h
motion/force_field.h motion/force_fields.h motion/forced_flight.h motion/moser_veselov.h motion/symmetric_top.h motion/listing1_euler.h
motion/lie_midpoint.h motion/rk4_polar.h motion/exact_elliptic.h motion/damping.h
impulse/impulse.h impulse/frictionless_impacts.h broad_phase/body_filter.h broad_phase/all_pairs.h broad_phase/sorted_tree.h broad_phase/query_tree.h
solver/sweeps/block_sweeps.h solver/direct/hybrid_islands.h solver/sequential/sequential_impulses.h
joint/joints.h joint/drives.h joint/reactions.h joint/target_record.h energy_momentum/energy_momentum.h figure/read_figure.h
query/query_filter.h events/contact_events.h draw/pen.h draw/wireframe.h
""".split()

# Members by which the kernel asks a method that a scene names, and never a user.
INTERNAL_MEMBERS = ("Memory AwakeMemory TreeMemory View name as_printed compensates returns_energy substeps is_direct is_pointwise is_frictionless is_implicit "
                    "answers_queries takes_velocities integrate_A fly island_capacity entries_per_row snap order_of_scene solve_contacts numbers "
                    "integrate_A_listing1").split()
# Of some headers, names in the namespace.
INTERNAL = {
    "base/config.h": "PairKey key_of INGOT_JOIN_ INGOT_JOIN INGOT_DOUBLES_ADD_WRONGLY",
    "base/report.h": "count note_figures note_sweeps",
    "base/workers.h": "tasks_of_worker tasks_max TaskRange range_of tasks_for over_ranges",
    "base/effort.h": "sweeps_of_new new_until sweeps_of_balls steady_sweeps goes_up spares_substeps",
    "base/floating_point.h": "check_floating_point_of_kernel",
    "body/check_body.h": "ScaledInverseInertia scaled_inverse_inertia correction_of_rotation",
    "body/mass_properties.h": "solids",
    "body/kinematics.h": "is_within_runaway",
    "broad_phase/body_filter.h": "FilterView NoFilters",
    "broad_phase/all_pairs.h": "find_all_pairs find_all_awake_pairs search_all_pairs is_tree",
    "broad_phase/sorted_tree.h": "TreeBox TreeLeaf TreeKey SortedTreeView leaf_bodies find_pairs_by_tree find_due_pairs_by_tree search_by_tree",
    "draw/pen.h": "draw_point draw_shape draw_color_count",
    "draw/wireframe.h": "lines_of_box lines_of_capsule lines_of_half_space",
    "events/contact_events.h": "write_event EventList ContactsOfStep emit_hits emit_begins copy_list",
    "figure/dynamics.h": "DynamicsBody DynamicsSize Dynamics direction_rates inverse_dynamics gravity_torques transpose_torques mass_matrix "
                         "effective_inertia",
    "figure/read_figure.h": "FigureMarks mark_figure",
    "mover/mover.h": "movers check_mover check_mover_input",
    "joint/joints.h": "is_tie is_servo has_servos is_wheel has_length limited_directions driven_directions is_same has_ties limits_of_joint drives_of_joint may_break has_reactions "
                      "has_limits has_drives",
    "joint/drives.h": "DriveRecord",
    "joint/reactions.h": "mean_of_step check_strength breaks_under JointPhase BreakRecord write_record",
    "joint/target_record.h": "TargetRecord",
    "math/vec3.h": "load store",
    "math/mat3.h": "load store",
    "math/sym3.h": "load store",
    "math/sqrt.h": "sqrt_by_digits",
    "math/trig.h": "ReducedAngle two_over_pi reduced_angle sin_cos_reduced",
    "motion/force_fields.h": "InversePowers inverse_powers is_steady depends_on_velocity operator()",
    "motion/force_field.h": "is_field",
    "motion/forced_flight.h": "kick drift add_field_forces_to add_field_forces",
    "motion/damping.h": "check_damping add_damping",
    "shape/compound.h": "CompoundView place_shapes drop_pairs_of_one_body",
    "shape/convex_hull.h": "HullTable table_of",
    "shape/hull_of_points.h": "hulls",
    "shape/shapes.h": "level_number patch_number least_half_extent bounding_radius",
    "solver/sequential/sequential_impulses.h": "LandingPart",
    "solver/sweeps/block_sweeps.h": "BlockSolver solve_by_sweeps",
    "solver/direct/hybrid_islands.h": "solve_hybrid",
    "world/contact_info.h": "ContactPlaces Iterator ContactRange(",
    "world/world_reactions.h": "Iterator BreakRange(",
    "world/draw.h": "WorldDrawing",
    "world/scene.h": "SceneOrNone shares_work solves_in_parts any_of collides stacks solves_pointwise solves_directly has_shapes has_joints has_joint_limits has_joint_drives has_wheels has_joint_rows "
                     "has_joint_reactions has_joint_breaking swings_freely has_loops has_ties has_targets has_servos has_gears has_levels hulls_of are_hulls has_compounds shape_capacity "
                     "pairs_with_own ShapesOf hides_internal_edges queries_by_tree has_sensors has_events follows_fast_bodies has_materials sweeps_balls_alone "
                     "has_field flies_in_field SceneOf",
    "world/snapshot.h": "OfWorld OfBody OfShape OfManifold OfEntry snapshot_parts saved_size write_numbers read_numbers saved_field_size saved_body_size "
                        "saved_list_size scene_signature expected_header shape_count_of write_body write_manifolds write_lists snapshot_size_of read_whole "
                        "read_body read_manifolds read_lists read_snapshot_contents for_manifolds",
}


# What headers say to readers of theirs, and Doxygen wants said to it.
NAMESPACES = """
/// @namespace ingot
/// The kernel: worlds, bodies, shapes, joints, and the mathematics of the article. Units are SI; see the guide for how it hangs together.

/// @namespace ingot::limits
/// Every tolerance and range of the kernel, with its unit and what happens beyond it.

/// @namespace ingot::quaternions
/// Orientations as quaternions, for files, networks and engines that keep them so.

/// @namespace ingot::platform
/// Beside the kernel, which knows nothing of it: clock, fixed step, console, recorder, stack.
"""

# Conversions of kinds to what holds any, and the number of a kind.
CONVERSIONS = re.compile(r"^ *(?:constexpr operator (?:Joint|Shape|JointDrive)\(\) const|static constexpr (?:ShapeKind|JointKind) kind)[^\n]*$", re.M)


def declared(name):
    """Where a declaration of this name begins: its line, with what stands before it (comment, template) left to Doxygen's eye."""
    end = "" if name.endswith("(") else r"(?!\w|::)"
    return re.compile(r"^ *(?!//|return|using namespace)(?:(?:alignas\(\w+\)|[^\n(=;/])*?[\s&*])?" + re.escape(name) + end + r"[^\n]*$", re.M)


def end_of_declaration(text, begin):
    """Behind the ; or the } that ends it."""
    depth, opened = 0, False
    for at in range(begin, len(text)):
        c = text[at]
        if c in "{(":
            depth, opened = depth + 1, opened or c == "{"
        elif c in "})":
            depth -= 1
            if depth == 0 and c == "}" and opened and not text[at + 1:].startswith(","):  # of a list of what a constructor sets
                return at + 1 + (text[at + 1:at + 2] == ";")
        elif c == ";" and depth == 0:
            return at + 1
    return len(text)


def begin_with_heads(text, begin):
    """With the comment and the template line above."""
    lines = text[:begin].split("\n")
    while len(lines) > 1 and re.match(r" *(///|template)", lines[-2]):
        lines.pop(-2)
    return sum(len(line) + 1 for line in lines[:-1])


def without(text, name):
    """The declarations of a name become blank lines, so that the others keep theirs."""
    at = 0
    in_namespace = any(not match[0].startswith(" ") for match in declared(name).finditer(text))  # then a trait of that name stays
    while match := declared(name).search(text, at):
        if in_namespace and match[0].startswith(" "):
            at = match.end()
            continue
        begin, end = begin_with_heads(text, match.start()), end_of_declaration(text, match.start())
        rest = re.match(r"[^\n]*", text[end:])[0]  # its comment
        if rest.strip() and not rest.strip().startswith("//"):
            rest = ""
        text = text[:begin] + "\n" * text[begin:end].count("\n") + text[end + len(rest):]
        at = begin
    return text


def with_groups(text):
    """A comment in a class, by itself between blank lines or behind `public:`, is of what follows."""
    def group(match):
        lines = [line.strip()[2:].strip() for line in match[2].strip().split("\n")]
        head, _, rest = " ".join(lines).partition(". ")
        return f"{match[1]}    /** @name {head.rstrip('.')}\n     *  {rest}\n     *  @{{ */\n".replace("\n     *  \n", "\n") + "\n" * (len(lines) - 3)
    parts = re.split(r"(?m)^(?=class World\w* )", text)
    for i, part in enumerate(parts[1:], 1):
        text_of_part, count = re.subn(r"(\n\n|public:\n)((?:    //[^/\n][^\n]*\n)+)(?=\n)", lambda m: m[1] + "    /** @} */" * 0 + group(re.match(r"(\n\n|public:\n)(.*)", m[0], re.S)), part)
        # Each group ends where the next begins, or its class.
        pieces = text_of_part.split("    /** @name ")
        parts[i] = pieces[0] + "".join("    /** @name " + re.sub(r"\n(?=private:|\};)", "\n    /** @} */\n", piece, count=1) if "\nprivate:" in piece or "\n};" in piece
                                      else "    /** @name " + piece + "    /** @} */\n" for piece in pieces[1:])
    return "".join(parts)


def one_by_one(text):
    """`scalar a{}, b{};  ///< m` becomes two lines."""
    def split(match):
        indent, kind, names, comment = match.groups()
        return "\n".join(f"{indent}{kind} {name.strip()};  {comment}" for name in re.split(r",\s*(?![^{(<]*[})>])", names))
    return re.sub(r"^( *)((?:static constexpr )?[A-Za-z][\w:<>]*) ([\w\[\]{}= .\-]+(?:, ?[\w\[\]{}= .\-]+)+); *(///<[^\n]*)$", split, text, flags=re.M)


def share_comments(text):
    """Constants that follow a documented one without a comment of their own are of its comment: both, of `a = 1, b = 2`, and the next line."""
    out, first, before = [], None, ""
    for line in text.split("\n"):
        constant = re.match(r"inline constexpr (\w+) (\w+)\b[^;]*;", line)
        if not constant:
            first = None
        elif first is None or before.startswith("///") or "///<" in line:
            first = constant[2]
        else:
            out.append(f"/// @copydoc ingot::limits::{first}")
        parts = re.findall(r"(\w+ = (?:[^,()]|\([^()]*\))+)", line.rstrip(";")) if constant and "///<" not in line else []
        if len(parts) > 1:
            kind = constant[1]
            out.append(f"inline constexpr {kind} {parts[0]};")
            out += [f"/// @copydoc ingot::limits::{constant[2]}\ninline constexpr {kind} {part};" for part in parts[1:]]
        else:
            out.append(line)
        before = line
    return "\n".join(out)


def header(path, text):
    text = re.sub(r"^#include[^\n]*$|^#pragma once$", "", text, flags=re.M)  # Doxygen reads each once: what one includes would be missing by itself
    text = re.sub(r"^protected:", "private:", text, flags=re.M)
    text = text.replace("{ inline namespace INGOT_ABI {", "{").replace("} }  // namespace ingot", "}  // namespace ingot").replace("} } }  //", "} }  //")
    name = str(path.relative_to(KERNEL)) if path.is_relative_to(KERNEL) else ""
    for internal in INTERNAL.get(name, "").split():
        text = without(text, internal)
    text = re.sub(r"\b(Eqs?|Fig)\. (?=\d)", r"\1.&#160;", text)  # a brief ends at a full stop
    if name == "base/limits.h":
        text = share_comments(text)
    if name == "ingot.h":
        text += NAMESPACES
    if name.startswith(("motion/", "solver/", "broad_phase/", "impulse/", "energy_momentum/")):
        for internal in INTERNAL_MEMBERS:
            text = without(text, internal)
    return one_by_one(with_groups(CONVERSIONS.sub("", text)))


def slug_of(heading):
    return re.sub(r"[^\w\- ]", "", heading.lower().replace("`", "")).replace(" ", "-")


def page(path, text):
    """Without what tests need; headings have the names that links know them by."""
    text = re.sub(r"^<!-- (cpp.*?|continues |file: \S+ |table: \S+ |end of table )-->\n", "", text, flags=re.M | re.S)
    text = re.sub(r"<!--.*?-->", "", text)
    blocks = re.split(r"(?ms)(^```\w*\n.*?^```$)", text)
    title = True

    def heading(match):
        nonlocal title
        label = f"page_{path.stem}" if title else f"{path.stem}_{slug_of(match[2])}"
        title = False
        return f"{match[1]} {match[2]} {{#{label}}}"

    def link(match):
        file, _, anchor = match[2].partition("#")
        target = (path.parent / file).resolve() if file else path
        if target.parent != GUIDE or target.suffix != ".md":  # it is not in these pages
            return match[1] if target.name == "README.md" or not file else f"{match[1]} (`{target.relative_to(ROOT)}`)"
        label = f"{target.stem}_{anchor}" if anchor else f"page_{target.stem}"
        return f'@ref {label} "{match[1]}"'
    for i in range(0, len(blocks), 2):
        blocks[i] = re.sub(r"(?m)^(#+) (.*)$", heading, blocks[i])
        blocks[i] = re.sub(r"(?<!!)\[([^\]]+)\]\(([^)\s]+)\)", link, blocks[i])
        blocks[i] = re.sub(r"(?<!`)`([^`\n]*'[^`\n]*)`(?!`)", r"``\1``", blocks[i])  # to doxygen a ' ends what one ` began
    return "".join(blocks)


def inputs():
    index = GUIDE / "README.md"
    named = [GUIDE / name for name in re.findall(r"\((\w+\.md)\)", index.read_text(encoding="utf-8"))]
    pages = [index] + list(dict.fromkeys(named)) + sorted(set(GUIDE.glob("*.md")) - {index, *named})
    return pages + [KERNEL / name for name in HEADERS] + sorted((ROOT / "platform").glob("*.h"))


def missing_calls(folder):
    """Calls of a world, and some functions, that no page of the reference lists: hidden by mistake, or not read."""
    sys.path.insert(0, str(GUIDE.parent / "budgets"))
    import calls
    members = set()
    for part in (KERNEL / "world").glob("world*.h"):
        if part.name != "world_slots.h":
            members.update(calls.members_of_world(part.read_text(encoding="utf-8")))

    def names_in(page):
        return set(re.findall(r"\w+", (folder / page).read_text(encoding="utf-8"))) if (folder / page).exists() else set()
    functions = {"step", "save_snapshot", "load_snapshot", "snapshot_size", "draw", "axis_angle", "principal", "collision_impulse", "Vector", "BodyDef"}
    return sorted(members - names_in("classingot_1_1World-members.html")) + sorted(functions - names_in("namespaceingot.html"))


def main():
    if sys.argv[1] == "--write":
        folder = pathlib.Path(sys.argv[2]).resolve()
        for path in inputs():
            text = path.read_text(encoding="utf-8")
            to = folder / path.relative_to(ROOT)
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_text(header(path, text) if path.suffix == ".h" else page(path, text), encoding="utf-8")
        (folder / "inputs.txt").write_text("INPUT = " + " ".join(f'"{folder / path.relative_to(ROOT)}"' for path in inputs()) + "\n", encoding="utf-8")
    else:
        folder = pathlib.Path(sys.argv[2])
        complaints = (folder / "warnings.txt").read_text(encoding="utf-8").splitlines()
        complaints += [f"the reference has no {name}" for name in missing_calls(folder)]
        if complaints:
            sys.exit("\n".join(complaints))


if __name__ == "__main__":
    main()
