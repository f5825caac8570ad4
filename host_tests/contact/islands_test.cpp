// SPDX-License-Identifier: MIT
// Islands side by side in the solver: what one of them does is the same alone and beside others, to the bit, and each has its own plan, sums and end.
#include <gtest/gtest.h>

#include <ingot/solver/sweeps/swept_contacts.h>
#include <ingot/solver/sweeps/conjugate_gradients.h>
#include <ingot/solver/sweeps/sweep_velocities.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "contact/pile.h"

namespace {

using ingot::Island;
using ingot::lanes;
using ingot::scalar;
using ingot::SolverView;
using ingot::SweepPlan;
using ingot_contact::Pile;

constexpr scalar h = scalar(1) / 64;
constexpr ingot::Vector gravity = {0, 0, -10};

/// Bodies that hang together. A column of cubes; a plank on pillars side by side; a plate that carries balls.
struct Part {
    enum class Kind { column, bridge, tray } kind;
    int count;  ///< cubes, pillars, balls
    int place;  ///< m, along x
    scalar push = 0;  ///< N, along x, on the last body

    int body_count() const { return kind == Kind::column ? count : count + 1; }
};

/// Slot 0 is the ground; each part takes the next slots.
struct Yard {
    std::vector<Part> parts;
    std::vector<int> first_slot;
    Pile pile;

    explicit Yard(const std::vector<Part>& parts_) : parts(parts_), pile(slots_of(parts_)) {
        int slot = 1;
        for (const Part& part : parts) {
            first_slot.push_back(slot);
            build(part, slot);
            slot += part.body_count();
        }
        std::sort(pile.pairs.begin(), pile.pairs.end(), [](const ingot::BodyPair& a, const ingot::BodyPair& b) { return a.key() < b.key(); });
    }
    static int slots_of(const std::vector<Part>& parts) {
        int slots = 1;
        for (const Part& part : parts) slots += part.body_count();
        return slots;
    }

    void build(const Part& part, int first) {
        const auto x = static_cast<scalar>(part.place);
        const int last = first + part.body_count() - 1;
        for (int i = 0; i < part.count; ++i) {
            const auto along = static_cast<scalar>(i), half = scalar(0.5);
            switch (part.kind) {
                case Part::Kind::column:
                    add_body(first + i, 1 + along, {x, 0, along + half});
                    touch(i == 0 ? 0 : first + i - 1, first + i, {x, 0, along}, 4);
                    break;
                case Part::Kind::bridge:
                    add_body(first + i, 1, {x + along, 0, half});
                    touch(0, first + i, {x + along, 0, 0}, 4);
                    touch(first + i, last, {x + along, 0, 1}, 4);
                    break;
                case Part::Kind::tray:
                    add_body(first + 1 + i, 1, {x + along, 0, scalar(1.5)});
                    touch(first, first + 1 + i, {x + along, 0, 1}, 1);
                    break;
            }
        }
        const scalar middle = x + static_cast<scalar>(part.count - 1) / 2;
        if (part.kind == Part::Kind::bridge) add_body(last, 8, {middle, 0, scalar(1.25)});
        if (part.kind == Part::Kind::tray) {
            add_body(first, 8, {middle, 0, scalar(0.5)});
            touch(0, first, {middle, 0, 0}, 4);
        }
        const ingot::Place at = ingot::place_of(last);
        ingot::set_lane(pile.translation[static_cast<std::size_t>(at.tile)].F_T, at.lane, ingot::Vector{part.push, 0, 0});
    }
    void add_body(int slot, scalar M, const ingot::Vector& r) {
        const ingot::Place at = ingot::place_of(slot);
        ingot::TranslationTile& translation = pile.translation[static_cast<std::size_t>(at.tile)];
        translation.inv_M[at.lane] = 1 / M;
        ingot::set_lane(translation.r_CM, at.lane, r);
        const scalar inv_I = 6 / M;
        ingot::set_lane(translation.inv_I_world, at.lane, ingot::Sym3<scalar>{inv_I, inv_I, inv_I, 0, 0, 0});
    }
    /// A is the lower slot, and below.
    void touch(int below, int above, const ingot::Vector& P, int points) {
        ingot::ManifoldRecord record{};
        record.mu = scalar(0.5);
        record.manifold.n = {0, 0, -1};
        record.manifold.count = static_cast<int8_t>(points);
        for (int i = 0; i < points; ++i) {
            const scalar side = points == 1 ? 0 : scalar(0.4);
            record.manifold.points[i].P = {P.x + ((i & 1) != 0 ? side : -side), (i & 2) != 0 ? side : -side, P.z};
            record.manifold.points[i].feature = static_cast<std::uint32_t>(i);
        }
        pile.pairs.push_back({static_cast<ingot::Index>(below), static_cast<ingot::Index>(above), static_cast<ingot::Index>(pile.records.size())});
        pile.records.push_back(record);
    }

    /// Of a pair, by its body that can move.
    bool is_of(std::size_t part_i, const ingot::BodyPair& pair) const {
        return pair.body_B >= first_slot[part_i] && pair.body_B < first_slot[part_i] + parts[part_i].body_count();
    }
    template <class Each>
    void for_records(std::size_t part_i, const Each& each) {
        for (const ingot::BodyPair& pair : pile.pairs)
            if (is_of(part_i, pair)) each(pile.records[pair.record]);
    }
    void make_old(std::size_t part_i, bool steady) {
        for_records(part_i, [&](ingot::ManifoldRecord& record) {
            record.substeps = static_cast<std::uint16_t>(8 * ingot::limits::substeps);
            if (steady) record.substeps = static_cast<std::uint16_t>(record.substeps | ingot::steady_bit);
        });
    }
    void push(std::size_t part_i, scalar F) {
        const ingot::Place at = ingot::place_of(first_slot[part_i] + parts[part_i].body_count() - 1);
        ingot::set_lane(pile.translation[static_cast<std::size_t>(at.tile)].F_T, at.lane, ingot::Vector{F, 0, 0});
    }
};

/// The sweeps, and the plans of the batches that each island was in.
struct WatchedSweeps : ingot::SweptContacts<SolverView, false, false> {
    using Swept = ingot::SweptContacts<SolverView, false, false>;
    using Swept::Swept;
    std::map<int, std::vector<SweepPlan>> plans;

    bool next_batch(const ingot::ContactStep& step) {
        if (!Swept::next_batch(step)) return false;
        for (int island_i = 0; island_i < view.island_count; ++island_i)
            if (view.islands[island_i].in_batch) plans[island_i].push_back(view.plan);
        return true;
    }
};

/// A step, and what it left.
struct Solved {
    Yard& yard;
    SolverView solver;
    ingot::StepReport report{};
    std::map<int, std::vector<SweepPlan>> plans;

    explicit Solved(Yard& yard_) : yard(yard_), solver(yard_.pile.solver()) {
        WatchedSweeps sweeps(solver);
        ingot::conduct_substeps(sweeps, {yard.pile.view(), gravity, h, {}}, report);
        plans = sweeps.plans;
    }
    int island_of(std::size_t part_i) const { return solver.island_of[solver.local_of[yard.first_slot[part_i]]]; }
    const Island& island(std::size_t part_i) const { return solver.islands[island_of(part_i)]; }
    const std::vector<SweepPlan>& plans_of(std::size_t part_i) { return plans[island_of(part_i)]; }

    template <class T>
    static void append(std::vector<unsigned char>& to, const T& value) {
        const auto* const bytes = reinterpret_cast<const unsigned char*>(&value);
        to.insert(to.end(), bytes, bytes + sizeof value);
    }
    /// Bodies and records of a part, all bits.
    std::vector<unsigned char> bits(std::size_t part_i) const {
        std::vector<unsigned char> all;
        for (int i = 0; i < yard.parts[part_i].body_count(); ++i) {
            const int body_i = solver.local_of[yard.first_slot[part_i] + i];
            append(all, solver.bodies[body_i]);
            append(all, solver.histories[body_i]);
        }
        yard.for_records(part_i, [&](const ingot::ManifoldRecord& record) { append(all, record); });
        return all;
    }
};

const std::vector<Part> crowd = {{Part::Kind::column, 3, 0},    {Part::Kind::bridge, 20, 10},  {Part::Kind::column, 1, 40},
                                 {Part::Kind::tray, 5, 50},     {Part::Kind::column, 2, 60},   {Part::Kind::tray, 70, 80},
                                 {Part::Kind::column, 1, 160},  {Part::Kind::bridge, 3, 170},  {Part::Kind::column, 13, 180},
                                 {Part::Kind::column, 1, 190}};

TEST(Islands, are_what_hangs_together) {
    Yard yard(crowd);
    Solved solved(yard);
    ASSERT_EQ(solved.solver.island_count, static_cast<int>(crowd.size()));
    for (std::size_t part_i = 0; part_i < crowd.size(); ++part_i) {
        const Part& part = crowd[part_i];
        int manifolds = 0;
        yard.for_records(part_i, [&](const ingot::ManifoldRecord&) { ++manifolds; });
        EXPECT_EQ(solved.island_of(part_i), static_cast<int>(part_i)) << "in the order of their first bodies";
        for (int i = 0; i < part.body_count(); ++i)
            EXPECT_EQ(solved.solver.island_of[solved.solver.local_of[yard.first_slot[part_i] + i]], static_cast<int>(part_i));
        EXPECT_EQ(solved.island(part_i).manifold_count, manifolds);
        EXPECT_EQ(solved.island(part_i).level_count, part.kind == Part::Kind::column ? part.count : 2);
        EXPECT_EQ(solved.island(part_i).new_count, manifolds);
        EXPECT_EQ(solved.island(part_i).central_count, part.kind == Part::Kind::tray ? part.count % 2 : 0) << "the ball above the middle";
        EXPECT_EQ(solved.plans_of(part_i), std::vector<SweepPlan>{manifolds > ingot::limits::small_island ? SweepPlan::large : SweepPlan::small});
    }
}

/// Pushed or not, new, old or steady: ten steps' impulses on.
TEST(Islands, do_the_same_alone_and_beside_others) {
    for (const int kind : {0, 1, 2}) {
        Yard yard(crowd);
        std::vector<Yard> alone;
        for (const Part& part : crowd) alone.emplace_back(std::vector<Part>{part});
        for (int step_i = 0; step_i < 10; ++step_i) {
            for (std::size_t part_i = 0; part_i < crowd.size(); ++part_i) {
                if (kind > 0 && (step_i + static_cast<int>(part_i)) % 3 == 0) {
                    yard.make_old(part_i, kind == 2);
                    alone[part_i].make_old(0, kind == 2);
                }
                const auto F = static_cast<scalar>((step_i * static_cast<int>(part_i)) % 4 == 3 ? 30 : 0);
                yard.push(part_i, F);
                alone[part_i].push(0, F);
            }
            Solved together(yard);
            int sweeps = 0;
            scalar residual = 0;
            for (std::size_t part_i = 0; part_i < crowd.size(); ++part_i) {
                Solved own(alone[part_i]);
                ASSERT_EQ(together.bits(part_i), own.bits(0)) << "part " << part_i << ", step " << step_i << ", kind " << kind;
                EXPECT_EQ(together.plans_of(part_i), own.plans_of(0));
                const Island &here = together.island(part_i), &there = own.island(0);
                EXPECT_EQ(here.sweeps, there.sweeps);
                EXPECT_EQ(here.size, there.size);
                EXPECT_EQ(here.residual, there.residual);
                EXPECT_EQ(here.steady, there.steady);
                EXPECT_EQ(own.report.sweeps, own.island(0).sweeps);
                EXPECT_EQ(own.report.residual, own.island(0).residual);
                sweeps = std::max(sweeps, here.sweeps);
                residual = std::max(residual, here.residual);
            }
            EXPECT_EQ(together.report.sweeps, sweeps) << "the most of all islands";
            EXPECT_EQ(together.report.residual, residual);
        }
    }
}

/// One that begins again has done nothing: bodies, impulses and ages are those of an island that had all of its substeps at once.
TEST(Islands, that_turn_out_not_to_be_steady_begin_again) {
    for (const Part& part : {Part{Part::Kind::column, 2, 3}, Part{Part::Kind::tray, 70, 3}}) {
        Yard steady({part});
        (void)Solved(steady);
        Yard restless(steady);
        steady.make_old(0, true);
        restless.make_old(0, false);
        steady.push(0, 100);
        restless.push(0, 100);
        Solved again(steady), at_once(restless);
        const bool large = part.count > ingot::limits::small_island;
        const SweepPlan begun = large ? SweepPlan::large_steady : SweepPlan::small_steady, full = large ? SweepPlan::large : SweepPlan::small;
        EXPECT_EQ(again.plans_of(0), (std::vector<SweepPlan>{begun, full}));
        EXPECT_EQ(at_once.plans_of(0), (std::vector<SweepPlan>{full}));
        EXPECT_EQ(again.bits(0), at_once.bits(0));
        EXPECT_GT(again.island(0).sweeps, at_once.island(0).sweeps) << "all are told";
        EXPECT_FALSE(again.island(0).steady);
        steady.for_records(0, [](const ingot::ManifoldRecord& record) { EXPECT_FALSE(ingot::was_steady(record)); });
    }
}

/// An island that begins again and one that is new are solved together; one that stays steady is not among them, and is not touched by them.
TEST(Islands, that_begin_again_join_those_that_are_new) {
    const std::vector<Part> parts = {{Part::Kind::column, 2, 0}, {Part::Kind::column, 2, 5}, {Part::Kind::column, 2, 10}};
    const auto prepare = [](Yard& yard, std::size_t part_i, std::size_t kind) {
        if (kind == 0) yard.push(part_i, 100);
        if (kind != 1) yard.make_old(part_i, true);
        if (kind == 1) yard.for_records(part_i, [](ingot::ManifoldRecord& record) { record.substeps = 0; });
    };
    Yard yard(parts);
    (void)Solved(yard);
    for (std::size_t part_i = 0; part_i < parts.size(); ++part_i) prepare(yard, part_i, part_i);
    Solved solved(yard);
    EXPECT_EQ(solved.plans_of(0), (std::vector<SweepPlan>{SweepPlan::small_steady, SweepPlan::small}));
    EXPECT_EQ(solved.plans_of(1), (std::vector<SweepPlan>{SweepPlan::small}));
    EXPECT_EQ(solved.plans_of(2), (std::vector<SweepPlan>{SweepPlan::small_steady}));
    for (std::size_t part_i = 0; part_i < parts.size(); ++part_i) {
        Yard own({parts[part_i]});
        (void)Solved(own);
        prepare(own, 0, part_i);
        EXPECT_EQ(solved.bits(part_i), Solved(own).bits(0)) << part_i;
    }
    EXPECT_TRUE(solved.island(2).steady);
    const auto age = [&](std::size_t part_i) {
        int found = 0;
        yard.for_records(part_i, [&](const ingot::ManifoldRecord& record) { found = ingot::age_of(record); });
        return found;
    };
    EXPECT_EQ(age(0), 9 * ingot::limits::substeps) << "the substeps that were taken back do not count";
    EXPECT_EQ(age(1), ingot::limits::substeps);
}

/// The first substep of a batch of new islands, as far as the sweeps.
struct Begun {
    SolverView solver;
    WatchedSweeps sweeps;

    explicit Begun(Yard& yard, SweepPlan plan) : solver(yard.pile.solver()), sweeps(solver) {
        const ingot::ContactStep step = {yard.pile.view(), gravity, h, {}};
        ingot::StepReport report{};
        sweeps.begin(step, report);
        do EXPECT_TRUE(sweeps.next_batch(step));
        while (solver.plan != plan);
        const scalar h_substep = h / static_cast<scalar>(sweeps.substeps());
        sweeps.predict(h_substep, {}, report);
        sweeps.kick(h_substep);
        sweeps.warm_start(h_substep);
        ingot::plan_sweeps(solver);
        ingot::select_live(solver);
        ingot::begin_sweeps(solver);
    }
};

/// No lane waits for its own island: cubes side by side fill blocks.
TEST(Islands, share_blocks) {
    std::vector<Part> cubes;
    for (int i = 0; i < 4 * lanes; ++i) cubes.push_back({Part::Kind::column, 1, 2 * i});
    Yard yard(cubes);
    const Begun begun(yard, SweepPlan::small);
    EXPECT_EQ(begun.solver.island_count, 4 * lanes);
    EXPECT_EQ(begun.solver.visit_count, 4);
    EXPECT_EQ(begun.solver.block_count, 4);
    for (int visit_i = 0; visit_i < begun.solver.visit_count; ++visit_i) {
        const ingot::Visit visit = begun.solver.visits[visit_i];
        EXPECT_EQ(visit.lane_bits, ingot::all_lanes);
        EXPECT_EQ(visit.island == ingot::no_island, lanes > 1) << "of several";
        for (int lane_i = 0; lane_i < lanes; ++lane_i) EXPECT_EQ(begun.solver.blocks[visit.block].island[lane_i], visit.block * lanes + lane_i);
    }
}

/// Sums go by level, colour and number within the island: the eight of them, and their sum, do not depend on lanes, nor on who else is there.
TEST(Islands, have_sums_of_their_own) {
    int whole = 0;
    for (const SweepPlan plan : {SweepPlan::small, SweepPlan::large}) {
        Yard yard(crowd);
        const Begun begun(yard, plan);
        const SolverView& solver = begun.solver;
        ingot::sweep_velocities(solver, solver.live, solver.live_count, 1, true);
        ingot::measure_sweep(solver);
        for (int island_i = 0; island_i < solver.island_count; ++island_i) {
            const Island& island = solver.islands[island_i];
            if (!island.in_batch) continue;
            scalar sums[8] = {}, residual = 0;
            std::map<std::pair<int, int>, int> of_colour;
            int manifolds = 0, several = 0;
            for (int position = 0; position < solver.lane_count; ++position) {
                const ingot::Index manifold_i = ingot::manifold_at(solver, position);
                if (manifold_i == ingot::no_manifold || solver.island_at[manifold_i] != island_i) continue;
                const ingot::ContactBlock& block = solver.blocks[position / lanes];
                const int level = solver.level[manifold_i], colour = solver.colour[manifold_i];
                // Beyond 32 colours each is alone.
                const int number = colour < 32 ? of_colour[{level, colour}]++ : 0;
                several += number >= 8 ? 1 : 0;
                sums[number % 8] += block.change[position % lanes];
                residual = std::max(residual, block.fastest[position % lanes]);
                EXPECT_EQ(block.sum_i[position % lanes], number % 8);
                ++manifolds;
            }
            EXPECT_EQ(manifolds, island.manifold_count);
            const scalar size = ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
            EXPECT_GT(size, 0);
            EXPECT_EQ(island.size, size) << island_i;
            EXPECT_EQ(island.residual, residual) << island_i;
            whole += several;
        }
    }
    EXPECT_GT(whole, 0) << "some colours have more than eight";
}

/// A settled island is in no live visit: neither its bodies nor its impulses change, whatever they are, though it shares blocks with others.
TEST(Islands, that_are_settled_drop_out_of_the_sweeps) {
    int changed = 0;
    for (const SweepPlan plan : {SweepPlan::small, SweepPlan::large}) {
        for (const int odd : {0, 1}) {
            Yard yard(crowd);
            Begun begun(yard, plan);
            SolverView& solver = begun.solver;
            const auto is_off = [&](int island_i) { return plan == SweepPlan::large || island_i % 2 == odd; };
            for (int island_i = 0; island_i < solver.island_count; ++island_i) {
                Island& island = solver.islands[island_i];
                island.beta = scalar(0.5);
                if (island.in_batch && is_off(island_i)) island.sweeps_on = false;
            }
            ingot::select_live(solver);
            std::vector<int> live(static_cast<std::size_t>(solver.manifold_count), 0);
            for (int visit_i = 0; visit_i < solver.live_count; ++visit_i) {
                const ingot::Visit visit = solver.live[visit_i];
                for (int lane_i = 0; lane_i < lanes; ++lane_i) {
                    const ingot::Index manifold_i = solver.blocks[visit.block].manifold[lane_i];
                    if ((visit.lane_bits >> lane_i & 1u) != 0 && manifold_i != ingot::no_manifold) ++live[manifold_i];
                }
            }
            for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {
                const Island& island = solver.islands[solver.island_at[manifold_i]];
                EXPECT_EQ(live[static_cast<std::size_t>(manifold_i)], island.in_batch && island.sweeps_on ? 1 : 0);
            }
            const std::vector<ingot::SolverBody> bodies(solver.bodies, solver.bodies + solver.body_count);
            const std::vector<ingot::ContactBlock> blocks(solver.blocks, solver.blocks + solver.block_count);
            for (int sweep_i = 1; sweep_i <= 3; ++sweep_i) {
                ingot::sweep_velocities(solver, solver.live, solver.live_count, sweep_i, true);
                ingot::measure_sweep(solver);
                ingot::extrapolate(solver);
            }
            for (int body_i = 1; body_i < solver.body_count; ++body_i) {
                const Island& island = solver.islands[solver.island_of[body_i]];
                const bool same = std::memcmp(&solver.bodies[body_i], &bodies[static_cast<std::size_t>(body_i)], sizeof bodies[0]) == 0;
                EXPECT_EQ(same, !island.in_batch || !island.sweeps_on) << body_i;
            }
            for (int position = 0; position < solver.lane_count; ++position) {
                const ingot::Index manifold_i = ingot::manifold_at(solver, position);
                if (manifold_i == ingot::no_manifold) continue;
                const ingot::ContactBlock &is = solver.blocks[position / lanes], &was = blocks[static_cast<std::size_t>(position / lanes)];
                const int lane_i = position % lanes;
                bool same = is.torsion.j[lane_i] == was.torsion.j[lane_i];
                for (int row = 0; row < is.rows; ++row) same = same && is.row[row].j[lane_i] == was.row[row].j[lane_i];
                for (int axis = 0; axis < 2; ++axis) same = same && is.friction.j[axis][lane_i] == was.friction.j[axis][lane_i];
                EXPECT_TRUE(same || solver.islands[is.island[lane_i]].sweeps_on) << manifold_i;
                changed += same ? 0 : 1;
            }
        }
    }
    EXPECT_GT(changed, 20);
}

/// Each has its own number of sweeps: what is settled does not wait, and does not hold up.
TEST(Islands, end_their_sweeps_one_by_one) {
    Yard yard(crowd);
    Begun begun(yard, SweepPlan::small);
    SolverView& solver = begun.solver;
    ingot::solve_velocities(solver);
    EXPECT_EQ(solver.live_count, 0);
    int fewest = 1000, most = 0;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        const Island& island = solver.islands[island_i];
        if (!island.in_batch) continue;
        EXPECT_FALSE(island.sweeps_on);
        EXPECT_TRUE(island.residual <= island.settled || island.sweeps == island.sweeps_max) << island_i;
        fewest = std::min(fewest, island.sweeps);
        most = std::max(most, island.sweeps);
    }
    EXPECT_LT(2 * fewest, most);
}

}  // namespace
