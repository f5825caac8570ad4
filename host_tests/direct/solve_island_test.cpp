// SPDX-License-Identifier: MIT
// One island, made up at random, solved by the kernel and by the reference.
#include <gtest/gtest.h>
#include <ingot/solver/sweeps/move_bodies.h>
#include <ingot/solver/sweeps/order_manifolds.h>
#include <ingot/solver/sweeps/plan_islands.h>
#include <ingot/solver/sweeps/predict_contacts.h>
#include <ingot/solver/sweeps/solve_velocities.h>
#include <ingot/constraint/prepare_blocks.h>
#include <ingot/solver/direct/factor_rows.h>
#include <ingot/solver/direct/hold_energy.h>
#include <ingot/solver/direct/island_rows.h>
#include <ingot/solver/direct/choose_islands.h>
#include <ingot/solver/direct/hybrid_contacts.h>
#include <ingot/solver/direct/hybrid_islands.h>
#include <ingot/solver/direct/solve_directly.h>
#include <ingot/solver/direct/solve_island.h>
#include <ingot/ingot.h>

#include <array>
#include <cstring>

#include "reference/contact_reference.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_reference;
using ingot::scalar;

constexpr int most_bodies = 8, most_manifolds = 24;

struct Yard : ingot::Scene {
    static constexpr int max_bodies = most_bodies;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = most_manifolds;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
    using solver = ingot::HybridIslands<most_manifolds, 12 * most_manifolds>;
};

Vector3d to_double(const ingot::Vector& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
ingot::Vector in_scalar(const Vector3d& v) {
    return {static_cast<scalar>(v.x()), static_cast<scalar>(v.y()), static_cast<scalar>(v.z())};
}

/// Where bodies of a random island touch: at corners of rectangles that lie anyhow, or right below, along one axis of the world, so that levers
/// are exact: at four points of a line, at three of a line and one beside it that is apart, or at one under the centre of mass.
enum class Touch { rectangle, line, line_and_one, centre };

/// Bodies at random that touch at random, slot 0 what cannot move; and the same as a problem for the reference.
struct RandomIsland {
    static constexpr double h = 1.0 / 240;
    ingot::Storage<Yard> storage{};
    ingot::SolverView solver{};
    ingot::DirectView direct{};
    ContactProblem problem;
    double fastest = 0;  ///< m/s, that a body or a point of it has

    Touch touch;
    std::vector<ingot::IslandState> states;  ///< of the islands that solve() has tried
    std::vector<bool> carried;             ///< of each, whether it found an impulse

    RandomIsland(RandomInput& random, int body_count, double mu_most, double mass_binades, Touch touch_ = Touch::rectangle) : touch(touch_) {
        problem.h = h;
        storage.slots_used = body_count;
        for (int slot = 0; slot < body_count; ++slot) add_body(random, slot, mass_binades);
        ingot::refresh_inv_I_world(storage.bodies());
        for (int slot = 0; slot < body_count; ++slot) describe(slot);
        for (int slot = 1; slot < body_count; ++slot) {
            add_manifold(random, slot, random.integer(0, slot - 1), mu_most);
            if (slot > 1 && random.integer(0, 2) == 0) add_manifold(random, slot, 0, mu_most);
        }
        prepare();
    }

    void add_body(RandomInput& random, int slot, double mass_binades) {
        ingot::BodyDef def;
        def.immovable = slot == 0;
        const double M = std::exp2(random.real(-mass_binades, mass_binades));
        def.mass.M = static_cast<scalar>(M);
        def.mass.I_body = in_scalar(random.moments(M));
        def.state.A = ingot::identity_matrix<scalar>();
        def.state.r_CM = in_scalar(Vector3d(0, 0, slot) + random.vector(0.3));
        if (slot != 0) {
            def.state.v_CM = in_scalar(random.vector(1) - Vector3d(0, 0, 1));
            def.state.L = in_scalar(random.vector(1) * M * 0.2);
        }
        ingot::write_body(storage.bodies(), slot, def);
    }

    void describe(int slot) {
        const ingot::Place at = ingot::place_of(slot);
        const ingot::TranslationTile& tile = storage.translation[at.tile];
        ContactBody body;
        const auto I = ingot::lane_of(tile.inv_I_world, at.lane);
        body.inv_M = static_cast<double>(tile.inv_M[at.lane]);
        const double xx = static_cast<double>(I.xx), yy = static_cast<double>(I.yy), zz = static_cast<double>(I.zz);
        const double xy = static_cast<double>(I.xy), xz = static_cast<double>(I.xz), yz = static_cast<double>(I.yz);
        body.inv_I_world << xx, xy, xz, xy, yy, yz, xz, yz, zz;
        body.r_CM = to_double(ingot::lane_of(tile.r_CM, at.lane));
        body.v_CM = to_double(ingot::lane_of(tile.v_CM, at.lane));
        body.omega = body.inv_I_world * to_double(ingot::lane_of(storage.rotation[at.tile].L, at.lane));
        fastest = std::max({fastest, body.v_CM.norm(), 2 * body.omega.norm()});
        problem.bodies.push_back(body);
    }

    /// A face of 1 to 4 points between a body and one below it.
    void add_manifold(RandomInput& random, int above, int below, double mu_most) {
        const int manifold_i = storage.manifold_count++;
        ingot::ManifoldRecord& record = storage.records[manifold_i];
        record.mu = static_cast<scalar>(random.real(0, mu_most));
        storage.pairs[manifold_i] = {static_cast<ingot::Index>(below), static_cast<ingot::Index>(above),
                                     static_cast<ingot::Index>(manifold_i)};
        const Vector3d n = (Vector3d(0, 0, 1.2) + random.direction()).normalized(),
                       across = n.cross(random.direction()).normalized();
        const auto &A = problem.bodies[static_cast<std::size_t>(below)], &B = problem.bodies[static_cast<std::size_t>(above)];
        const Vector3d middle = (below == 0 ? B.r_CM - 0.5 * n : Vector3d((A.r_CM + B.r_CM) / 2)) + random.vector(0.1);
        const int shapes[4] = {1, 2, 4, 4};
        record.manifold.count = static_cast<int8_t>(shapes[random.integer(0, 3)]);
        record.manifold.n = in_scalar(-n);  // from B, the one above, to A
        const double long_side = random.real(0.1, 0.5), short_side = random.real(0.1, 0.5);
        const double separation = random.integer(0, 4) == 0 ? random.real(0.002, 0.004) : -1e-4;
        if (touch != Touch::rectangle) {
            touch_below(record.manifold, B.r_CM, long_side);
            return;
        }
        for (int point_i = 0; point_i < record.manifold.count; ++point_i) {
            const double x = record.manifold.count == 1 ? 0 : (point_i & 1) != 0 ? 1 : -1, y = (point_i & 2) != 0 ? 1 : -1;
            const Vector3d P = middle + across * (x * long_side) + n.cross(across) * (y * short_side);
            record.manifold.points[point_i] = {in_scalar(P), static_cast<scalar>(separation), static_cast<uint32_t>(point_i)};
        }
    }

    void touch_below(ingot::Manifold& manifold, const Vector3d& r_CM, double side) const {
        manifold.count = touch == Touch::centre ? 1 : 4;
        manifold.n = {0, 0, -1};
        for (int point_i = 0; point_i < manifold.count; ++point_i) {
            const bool beside = touch == Touch::line_and_one && point_i == 3;
            const double x = touch == Touch::centre || beside ? 0 : side * (point_i - 1);
            const Vector3d P = r_CM + Vector3d(x, beside ? side : 0, -0.5);
            manifold.points[point_i] = {in_scalar(P), scalar(beside ? 0.1 : -1e-4), static_cast<uint32_t>(point_i)};
        }
    }

    void prepare() {
        solver = storage.solver();
        direct = storage.direct_view();
        const ingot::BodyView bodies = storage.bodies();
        ingot::take_in_bodies(solver, bodies, {}, static_cast<scalar>(h));
        ingot::NoJointedBodies none;
        ingot::find_levels(solver, none);
        ingot::plan_islands(solver, none, bodies, static_cast<scalar>(h));
        // All contacts are new, and so few that all islands are of one plan.
        for (int island_i = 0; island_i < solver.island_count; ++island_i) EXPECT_EQ(solver.islands[island_i].plan, ingot::SweepPlan::small);
        EXPECT_TRUE(ingot::begin_batch(solver, none, ingot::SweepPlan::small, bodies, {}));
        EXPECT_EQ(solver.substeps, ingot::limits::substeps);
        ingot::prepare_blocks(solver, bodies);
        ingot::predict_contacts(solver, static_cast<scalar>(h));
        ingot::predict_bounces(solver, static_cast<scalar>(h));
        for (int body_i = 1; body_i < solver.body_count; ++body_i) {
            for (int axis = 0; axis < 3; ++axis) {
                direct.free_motion[body_i].v_CM[axis] = solver.bodies[body_i].v_CM[axis];
                direct.free_motion[body_i].L[axis] = solver.bodies[body_i].L[axis];
            }
        }
        for (int record_i = 0; record_i < storage.manifold_count; ++record_i)
            direct.unsettled[record_i] = ingot::limits::unsettled_steps;
    }

    /// Returns how many islands were chosen.
    int choose() {
        for (auto& record : storage.records) record.substeps = 1;  // no contact is new
        ingot::StepReport report{};
        choose_islands(solver, direct, report);
        EXPECT_EQ(report.direct, 0);
        ingot::begin_direct_batch(solver, direct);
        int chosen = 0;
        for (int island_i = 0; island_i < solver.island_count; ++island_i) chosen += is_chosen(island_i) ? 1 : 0;
        EXPECT_EQ(direct.some_chosen, chosen > 0);
        return chosen;
    }
    bool is_chosen(int island_i) const { return direct.state[island_i] == ingot::IslandState::chosen; }

    /// The islands one by one: to the bodies' velocities, and, into `found`, what impulses did it.
    bool solve(ContactSolution& found, int work = 1 << 24, bool after_sweeps = false) {
        EXPECT_GT(choose(), 0);
        for (const ContactBody& body : problem.bodies) {
            found.v_CM.push_back(body.v_CM);
            found.omega.push_back(body.omega);
        }
        bool solved = true;
        for (int island_i = 0; island_i < solver.island_count; ++island_i) {
            if (!is_chosen(island_i)) continue;
            ingot::load_rows(solver, storage.bodies(), direct, island_i);
            direct.work_left = work;
            direct.uneven = true;  // impacts too
            states.push_back(ingot::solve_island(solver, direct, static_cast<scalar>(h), after_sweeps));
            solved = states.back() == ingot::IslandState::solved && solved;
            bool pushed = false;
            for (int row_i = 0; row_i < direct.manifold_count * ingot::DirectView::row_count; ++row_i) {
                const bool exists = (direct.manifolds[row_i / ingot::DirectView::row_count].rows >> row_i % ingot::DirectView::row_count & 1u) != 0;
                pushed = pushed || (exists && direct.rows[row_i].j > 0);
            }
            carried.push_back(pushed);
            collect(found);
        }
        return solved;
    }

    void collect(ContactSolution& found) {
        for (int body_i = 1; body_i < direct.body_count; ++body_i) {
            const ingot::DirectBody& body = direct.bodies[body_i];
            const std::size_t slot = solver.slot_of[body.body_i];
            found.v_CM[slot] = {body.linear.x, body.linear.y, body.linear.z};
            found.omega[slot] = problem.bodies[slot].inv_I_world * Vector3d(body.angular.x, body.angular.y, body.angular.z);
        }
        for (int manifold_i = 0; manifold_i < direct.manifold_count; ++manifold_i) {
            const ingot::DirectView::Manifold& manifold = direct.manifolds[manifold_i];
            const auto& pair =
                solver.pairs[solver.blocks[manifold.position / ingot::lanes].manifold[manifold.position % ingot::lanes]];
            const auto& block = solver.blocks[manifold.position / ingot::lanes];
            const auto& contact = solver.records[pair.record].manifold;
            const ingot::DirectRow* const rows = direct.rows + manifold_i * ingot::DirectView::row_count;
            FrictionPatch patch;
            patch.body_A = pair.body_A;
            patch.body_B = pair.body_B;
            patch.n = to_double(contact.n);
            patch.mu = manifold.mu;
            patch.mu_twist = manifold.mu * manifold.radius;
            for (int row = 0; row < contact.count; ++row) {
                ContactPoint point;
                point.body_A = pair.body_A;
                point.body_B = pair.body_B;
                point.r_P = to_double(contact.points[row].P);
                point.n = patch.n;
                point.v_n_target = static_cast<double>(block.row[row].target[manifold.position % ingot::lanes]);
                patch.points.push_back(static_cast<int>(problem.points.size()));
                patch.r_P += point.r_P / contact.count;
                problem.points.push_back(point);
                found.impulse.push_back(patch.n * rows[row].j);
            }
            Vector3d t = Vector3d::Zero();
            for (int axis = 0; axis < 2; ++axis) {
                const ingot::DirectRow& row = rows[ingot::friction_row + axis];
                t += Vector3d(row.d.x, row.d.y, row.d.z) * row.j;
            }
            problem.patches.push_back(patch);
            found.patch_impulse.push_back(t);
            found.patch_twist.push_back((manifold.rows >> ingot::torsion_row & 1u) != 0 ? rows[ingot::torsion_row].j : 0);
        }
    }
};

/// What the kernel's solution may miss the laws by, m/s: limits::direct_settled_speed for each law, and normals and levers of
/// friction that are scalars, a few roundings of the speeds there are; the moments of inertia they act on differ by up to 20.
double allowance(const RandomIsland& island) {
    return 10 * ingot::limits::direct_settled_speed + 4 * 20 * static_cast<double>(ingot::epsilon) * island.fastest;
}

double kinetic_energy(const ContactProblem& problem, const std::vector<Vector3d>& v_CM, const std::vector<Vector3d>& omega) {
    double sum = 0;
    for (std::size_t i = 1; i < problem.bodies.size(); ++i)
        sum +=
            v_CM[i].squaredNorm() / problem.bodies[i].inv_M + omega[i].dot(problem.bodies[i].inv_I_world.inverse() * omega[i]);
    return sum / 2;
}

/// Islands of 2 to bodies_max bodies without friction, of which velocities are unique. Returns how many of them are solved.
int solve_without_friction(RandomInput& random, int count, int bodies_max, Touch touch = Touch::rectangle) {
    int solved = 0;
    for (int case_i = 0; case_i < count; ++case_i) {
        RandomIsland island(random, random.integer(2, bodies_max), 0, 3, touch);
        ContactSolution found;
        if (!island.solve(found)) continue;
        ++solved;
        const ContactSolution exact = solve_contacts_without_friction(island.problem);
        EXPECT_TRUE(exact.converged) << case_i;
        EXPECT_LE(velocity_distance(island.problem, found, exact), allowance(island)) << case_i;
    }
    std::printf("%d of %d islands without friction solved\n", solved, count);
    return solved;
}

TEST(DirectIsland, agrees_with_the_exact_solution_without_friction) {
    RandomInput random(1);
    EXPECT_GE(solve_without_friction(random, 400, most_bodies), 390);
}

/// Points of which none, or not all, have an area between them: what some carry can be carried by others in more than one way, and how much of
/// it is undetermined must not matter.
TEST(DirectIsland, agrees_with_the_exact_solution_on_points_of_a_line) {
    RandomInput random(5);
    for (const Touch touch : {Touch::line, Touch::line_and_one}) EXPECT_GE(solve_without_friction(random, 200, 4, touch), 190);
}

/// An attempt after sweeps that have done nothing gains all there is to gain: what is solved before them is solved after them too, and keeps the laws
/// to what sweeps would leave. Where nothing pushes, nothing is gained.
TEST(DirectIsland, is_solved_after_sweeps_where_something_is_gained) {
    RandomInput random(8);
    int gained = 0, nothing = 0;
    for (int case_i = 0; case_i < 400; ++case_i) {
        const int body_count = random.integer(2, most_bodies);
        const auto seed = static_cast<std::uint64_t>(1000 + case_i);
        RandomInput once(seed), again(seed);
        RandomIsland before(once, body_count, case_i % 2, 3), after(again, body_count, case_i % 2, 3);
        ContactSolution found_before, found_after;
        before.solve(found_before);
        const bool all = after.solve(found_after, 1 << 24, true);
        for (std::size_t i = 0; i < before.states.size(); ++i) {
            if (before.states[i] != ingot::IslandState::solved) continue;
            const bool gains = before.carried[i];
            EXPECT_EQ(after.states[i], gains ? ingot::IslandState::solved : ingot::IslandState::chosen) << case_i;
            ++(gains ? gained : nothing);
        }
        if (!all) continue;
        EXPECT_LE(contact_residual(after.problem, found_after), allowance(after) + static_cast<double>(ingot::limits::settled_speed)) << case_i;
    }
    std::printf("%d islands solved after sweeps, %d at which nothing was to be gained\n", gained, nothing);
    EXPECT_GT(gained, 300);
    EXPECT_GT(nothing, 20);
}

/// What an island does not have is not touched, neither by its solve nor by a step: it may be there no more.
TEST(DirectIsland, touches_nothing_beyond_its_end) {
    RandomInput random(9);
    for (int case_i = 0; case_i < 50; ++case_i) {
        RandomIsland island(random, random.integer(2, most_bodies), 1, 3);
        EXPECT_GT(island.choose(), 0);
        const ingot::DirectView& direct = island.direct;
        for (int island_i = 0; island_i < island.solver.island_count; ++island_i) {
            if (!island.is_chosen(island_i)) continue;
            ingot::load_rows(island.solver, island.storage.bodies(), island.direct, island_i);
            const int count = direct.manifold_count;
            // Left over from another: four points on the island's own bodies, that carry and slide.
            for (int manifold_i = count; manifold_i < direct.manifold_capacity; ++manifold_i) {
                ingot::DirectView::Manifold& left = direct.manifolds[manifold_i] = direct.manifolds[0];
                left.rows = left.active = left.sliding = left.pulls = 0x7f;
                left.points = 4;
                for (int row = 0; row < ingot::DirectView::row_count; ++row) {
                    direct.rows[manifold_i * ingot::DirectView::row_count + row] = direct.rows[0];
                    direct.rows[manifold_i * ingot::DirectView::row_count + row].j = 1;
                }
            }
            const std::vector<ingot::DirectView::Manifold> manifolds(direct.manifolds + count, direct.manifolds + direct.manifold_capacity);
            const std::vector<ingot::DirectRow> rows(direct.rows + count * ingot::DirectView::row_count,
                                                     direct.rows + direct.manifold_capacity * ingot::DirectView::row_count);
            island.direct.work_left = 1 << 24;
            island.direct.uneven = case_i % 2 != 0;  // impacts too, or not
            (void)ingot::solve_island(island.solver, island.direct, static_cast<scalar>(RandomIsland::h), false);
            (void)ingot::place_island(island.solver, island.direct, static_cast<scalar>(RandomIsland::h));
            for (std::size_t i = 0; i < manifolds.size(); ++i) {
                const ingot::DirectView::Manifold &is = direct.manifolds[static_cast<std::size_t>(count) + i], &was = manifolds[i];
                EXPECT_TRUE(is.rows == was.rows && is.active == was.active && is.sliding == was.sliding && is.pulls == was.pulls) << case_i;
            }
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const ingot::DirectRow& is = direct.rows[static_cast<std::size_t>(count * ingot::DirectView::row_count) + i];
                EXPECT_TRUE(is.j == rows[i].j && is.target == rows[i].target) << case_i;
            }
        }
    }
    for (int case_i = 0; case_i < 50; ++case_i) {
        RandomIsland island(random, random.integer(2, most_bodies), 1, 3);
        for (auto& record : island.storage.records) record.substeps = 1;
        const auto body_count = static_cast<std::size_t>(island.solver.body_count);
        const auto island_count = static_cast<std::size_t>(island.solver.island_count);
        const ingot::FreeMotion motion = {{1, 2, 3}, {4, 5, 6}};
        std::vector<ingot::FreeMotion> free_motion(body_count + 4, motion);
        std::vector<ingot::IslandState> states(body_count + 4, ingot::IslandState::left_to_sweeps);
        island.direct.free_motion = free_motion.data();
        island.direct.state = states.data();
        ingot::StepReport report{};
        const auto h = static_cast<scalar>(ingot::limits::substeps * RandomIsland::h);
        ingot::HybridContacts<ingot::SolverView, false, true> contacts(island.solver, island.direct);
        ingot::conduct_substeps(contacts, {island.storage.bodies(), {}, h, {}}, report);
        ASSERT_EQ(static_cast<std::size_t>(island.solver.body_count), body_count);
        ASSERT_EQ(static_cast<std::size_t>(island.solver.island_count), island_count);
        EXPECT_NE(free_motion[1].v_CM[2], motion.v_CM[2]) << "an island was chosen";
        for (std::size_t island_i = 0; island_i < states.size(); ++island_i)
            EXPECT_EQ(states[island_i] == ingot::IslandState::left_to_sweeps, island_i >= island_count) << case_i;
        for (std::size_t body_i = body_count; body_i < free_motion.size(); ++body_i) {
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(free_motion[body_i].v_CM[axis], motion.v_CM[axis]) << case_i;
                EXPECT_EQ(free_motion[body_i].L[axis], motion.L[axis]) << case_i;
            }
        }
    }
}

/// Islands that are solved are left out of the sweeps, and nobody else. Who stays is where it was, and is added to the same one of its island's
/// sums: they are the same for any lanes and any neighbours.
TEST(DirectIsland, that_is_solved_is_left_out_of_the_sweeps) {
    RandomInput random(10);
    int cut = 0;
    // By manifold: the block and lane that are visited, and which of the sums it is added to.
    using Visits = std::vector<std::vector<std::array<int, 3>>>;
    const auto visits_of = [](const ingot::SolverView& solver, const ingot::Visit* visits, int count) {
        Visits found(static_cast<std::size_t>(solver.manifold_count));
        for (int visit_i = 0; visit_i < count; ++visit_i) {
            const ingot::Visit visit = visits[visit_i];
            const ingot::ContactBlock& block = solver.blocks[visit.block];
            for (int lane_i = 0; lane_i < ingot::lanes; ++lane_i) {
                const ingot::Index manifold_i = block.manifold[lane_i];
                if ((visit.lane_bits >> lane_i & 1u) == 0 || manifold_i == ingot::no_manifold) continue;  // spare lanes join a visit
                EXPECT_EQ(block.island[lane_i], solver.island_at[manifold_i]);
                // A visit that names an island is added up as one vector.
                EXPECT_TRUE(visit.island == ingot::no_island || visit.island == block.island[lane_i]);
                const int sum_i = visit.island == ingot::no_island ? block.sum_i[lane_i] : block.sum_i[0] + lane_i;
                found[manifold_i].push_back({visit.block, lane_i, sum_i});
            }
        }
        return found;
    };
    for (int case_i = 0; case_i < 300; ++case_i) {
        RandomIsland island(random, most_bodies, 1, 3);
        ingot::SolverView& solver = island.solver;
        for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].sweeps_on = random.integer(0, 1) == 0;
        const auto is_on = [&](std::size_t manifold_i) {
            return solver.islands[solver.island_at[manifold_i]].sweeps_on;
        };
        ingot::select_live(solver);
        const Visits all = visits_of(solver, solver.visits, solver.visit_count), left = visits_of(solver, solver.live, solver.live_count);
        int off = 0;
        for (std::size_t manifold_i = 0; manifold_i < all.size(); ++manifold_i) {
            off += is_on(manifold_i) ? 0 : 1;
            ASSERT_EQ(all[manifold_i].size(), 1u);
            if (is_on(manifold_i)) {
                EXPECT_EQ(left[manifold_i], all[manifold_i]) << case_i;
            } else {
                EXPECT_TRUE(left[manifold_i].empty()) << case_i;
            }
        }
        cut += off > 0 && off < solver.manifold_count ? 1 : 0;
    }
    EXPECT_GT(cut, 50);

    // Before the sweeps, and at the positions: those that are solved, and no others.
    int solved = 0, unsolved = 0;
    for (int case_i = 0; case_i < 300; ++case_i) {
        RandomIsland island(random, most_bodies, 1, 3);
        EXPECT_GT(island.choose(), 0);
        ingot::SolverView& solver = island.solver;
        for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].residual = 7;  // of the substep before
        ingot::plan_sweeps(solver);
        ingot::solve_before_sweeps(solver, island.direct, island.storage.bodies(), static_cast<scalar>(RandomIsland::h));
        std::vector<ingot::IslandState> state(island.direct.state, island.direct.state + solver.island_count);
        for (std::size_t i = 0; i < state.size(); ++i) {
            EXPECT_EQ(solver.islands[i].sweeps_on, state[i] != ingot::IslandState::solved) << case_i;
            EXPECT_EQ(solver.islands[i].residual, 0) << "what is not swept tells nothing of sweeps";
            ++(state[i] == ingot::IslandState::solved ? solved : unsolved);
        }
        ingot::place_islands(solver, island.direct, island.storage.bodies(), static_cast<scalar>(RandomIsland::h));
        for (std::size_t i = 0; i < state.size(); ++i) {
            EXPECT_TRUE(state[i] == ingot::IslandState::solved || solver.islands[i].sweeps_on) << case_i;
            EXPECT_EQ(island.direct.state[i] == ingot::IslandState::chosen, state[i] != ingot::IslandState::swept) << "once more in the next substep";
        }
    }
    EXPECT_GT(solved, 20);
    EXPECT_GT(unsolved, 10);
}

/// What an attempt may spend does not depend on whether its island is at hand already, with a factor of the attempt before, or was put away for
/// another island: else whom it shares the world with would decide whether it is solved.
TEST(DirectIsland, spends_the_same_at_hand_and_put_away) {
    RandomInput random(12);
    int attempts = 0, had_factor = 0;
    for (int case_i = 0; case_i < 100; ++case_i) {
        RandomIsland island(random, random.integer(2, most_bodies), 0, 3);
        EXPECT_GT(island.choose(), 0);
        for (int island_i = 0; island_i < island.solver.island_count; ++island_i) {
            if (!island.is_chosen(island_i)) continue;
            const auto begin = [&](int work) {
                island.direct.uneven = true;
                island.direct.work_left = work;
            };
            const auto solve = [&] { return ingot::solve_island(island.solver, island.direct, static_cast<scalar>(RandomIsland::h), false); };
            ingot::load_rows(island.solver, island.storage.bodies(), island.direct, island_i);
            begin(1 << 24);
            if (solve() != ingot::IslandState::solved) continue;
            const std::vector<ingot::SolverBody> bodies(island.solver.bodies, island.solver.bodies + island.solver.body_count);
            const std::vector<ingot::ContactBlock> blocks(island.solver.blocks, island.solver.blocks + island.solver.block_count);
            int spent[2];
            ingot::IslandState state[2], without[2];
            for (const bool put_away : {false, true}) {
                std::copy(bodies.begin(), bodies.end(), island.solver.bodies);
                std::copy(blocks.begin(), blocks.end(), island.solver.blocks);
                if (put_away) ingot::load_rows(island.solver, island.storage.bodies(), island.direct, island_i);
                had_factor += island.direct.factored ? 1 : 0;
                begin(1 << 24);
                state[put_away] = solve();
                spent[put_away] = (1 << 24) - island.direct.work_left;
            }
            EXPECT_EQ(spent[0], spent[1]) << case_i;
            EXPECT_EQ(state[0], state[1]) << case_i;
            // And with less than that it is not solved, either way.
            for (const bool put_away : {false, true}) {
                std::copy(bodies.begin(), bodies.end(), island.solver.bodies);
                std::copy(blocks.begin(), blocks.end(), island.solver.blocks);
                if (put_away) ingot::load_rows(island.solver, island.storage.bodies(), island.direct, island_i);
                begin(spent[0] - 1);
                without[put_away] = solve();
            }
            EXPECT_EQ(without[0], without[1]) << case_i;
            EXPECT_TRUE(spent[0] == 0 || without[0] == ingot::IslandState::chosen) << case_i;
            ++attempts;
        }
    }
    EXPECT_GT(attempts, 50);
    EXPECT_GT(had_factor, 50);
}

/// With sliding friction there are two factors in place of one, and an entry is made of couplings with two directions: four times the work.
TEST(DirectIsland, counts_the_work_of_sliding) {
    RandomInput random(11);
    int counted = 0;
    for (int case_i = 0; case_i < 50; ++case_i) {
        RandomIsland island(random, random.integer(2, 4), 1, 1);
        EXPECT_GT(island.choose(), 0);
        for (int island_i = 0; island_i < island.solver.island_count; ++island_i) {
            if (!island.is_chosen(island_i)) continue;
            ingot::load_rows(island.solver, island.storage.bodies(), island.direct, island_i);
            int work[2];
            for (const bool slides : {false, true}) {
                for (int manifold_i = 0; manifold_i < island.direct.manifold_count; ++manifold_i) {
                    ingot::DirectView::Manifold& manifold = island.direct.manifolds[manifold_i];
                    manifold.active = manifold.rows & (1u | 3u << ingot::friction_row);
                    manifold.sliding = slides ? static_cast<uint8_t>(3u << ingot::friction_row) : uint8_t(0);
                    for (int row = 0; row < ingot::DirectView::row_count; ++row)
                        island.direct.rows[manifold_i * ingot::DirectView::row_count + row].j = 1;
                }
                island.direct.work_left = 1 << 24;
                island.direct.factored = false;
                ASSERT_TRUE(ingot::factor_rows(island.direct));
                work[slides] = (1 << 24) - island.direct.work_left;
            }
            EXPECT_GT(work[0], 0);
            EXPECT_EQ(work[1], 2 * 2 * work[0]) << case_i;
            ++counted;
        }
    }
    EXPECT_GT(counted, 40);
}

/// A second attempt, from what the first found, is taken if it is better, and changes nothing else.
TEST(DirectIsland, is_left_as_it_is_where_another_attempt_gains_nothing) {
    RandomInput random(6);
    int left = 0, taken = 0;
    for (int case_i = 0; case_i < 100; ++case_i) {
        RandomIsland island(random, random.integer(2, most_bodies), 1, 3);
        ContactSolution found;
        if (!island.solve(found)) continue;
        for (int island_i = 0; island_i < island.solver.island_count; ++island_i) {
            if (!island.is_chosen(island_i)) continue;
            ingot::load_rows(island.solver, island.storage.bodies(), island.direct, island_i);
            island.direct.work_left = 1 << 24;
            island.direct.uneven = true;
            const std::vector<ingot::SolverBody> before(island.solver.bodies, island.solver.bodies + island.solver.body_count);
            const ingot::IslandState state = ingot::solve_island(island.solver, island.direct, static_cast<scalar>(RandomIsland::h), true);
            ++(state == ingot::IslandState::solved ? taken : left);
            for (std::size_t i = 1; i < before.size() && state != ingot::IslandState::solved; ++i)
                EXPECT_EQ(std::memcmp(&before[i], &island.solver.bodies[i], sizeof before[i]), 0) << case_i;
            ContactSolution again = found;
            for (int body_i = 1; body_i < island.direct.body_count; ++body_i) {
                const ingot::SolverBody& body = island.solver.bodies[island.direct.bodies[body_i].body_i];
                const std::size_t slot = island.solver.slot_of[island.direct.bodies[body_i].body_i];
                for (int axis = 0; axis < 3; ++axis) again.v_CM[slot][axis] = static_cast<double>(body.v_CM[axis]);
                const Vector3d L(static_cast<double>(body.L[0]), static_cast<double>(body.L[1]), static_cast<double>(body.L[2]));
                again.omega[slot] = island.problem.bodies[slot].inv_I_world * L;
            }
            EXPECT_LE(velocity_distance(island.problem, found, again), allowance(island)) << case_i;
        }
    }
    std::printf("%d second attempts taken, %d not\n", taken, left);
    EXPECT_GT(left, 0);
}

/// A body at rest, with impulses left over from when it slid: taken back whole, they leave the friction without a direction, and the body at rest.
TEST(DirectIsland, forgets_how_it_slid) {
    RandomInput random(7);
    for (int case_i = 0; case_i < 50; ++case_i) {
        RandomIsland island(random, 2, 1, 3, Touch::centre);
        const double N = random.real(0.1, 10);
        ingot::ContactBlock& block = island.solver.blocks[0];
        int lane_i = 0;
        while (block.manifold[lane_i] == ingot::no_manifold) ++lane_i;
        block.row[0].j[lane_i] = static_cast<scalar>(N);
        block.friction.j[case_i % 2][lane_i] = static_cast<scalar>(N) * block.mu[lane_i];
        ingot::SolverBody& body = island.solver.bodies[1];
        for (int axis = 0; axis < 3; ++axis) body.v_CM[axis] = body.L[axis] = 0;
        island.direct.free_motion[1] = {};
        block.row[0].separation[lane_i] = 0;
        ingot::predict_contacts(island.solver, static_cast<scalar>(RandomIsland::h));
        ContactSolution found;
        ASSERT_TRUE(island.solve(found)) << case_i;
        const double settled = 10 * ingot::limits::direct_settled_speed;
        EXPECT_LE(found.v_CM[1].norm() + found.omega[1].norm(), settled) << case_i;
        EXPECT_LE(found.patch_impulse[0].norm() * island.problem.bodies[1].inv_M, settled) << case_i;
    }
}

/// With friction a solution need not be the only one: it is one if it keeps the laws.
TEST(DirectIsland, keeps_the_laws_of_friction) {
    RandomInput random(2);
    int solved = 0, same = 0;
    for (int case_i = 0; case_i < 400; ++case_i) {
        RandomIsland island(random, random.integer(2, most_bodies), 1, 3);
        ContactSolution found;
        if (!island.solve(found)) continue;
        ++solved;
        const double allowed = allowance(island);
        EXPECT_LE(contact_residual(island.problem, found), allowed) << case_i;
        std::vector<Vector3d> v_CM, omega;
        for (const ContactBody& body : island.problem.bodies) {
            v_CM.push_back(body.v_CM);
            omega.push_back(body.omega);
        }
        EXPECT_LE(kinetic_energy(island.problem, found.v_CM, found.omega),
                  kinetic_energy(island.problem, v_CM, omega) * (1 + 1e-6))
            << case_i;
        const ContactSolution exact = solve_contacts(island.problem);
        same += velocity_distance(island.problem, found, exact) <= allowed ? 1 : 0;
    }
    std::printf("%d of 400 islands with friction solved, %d as the reference does\n", solved, same);
    EXPECT_GE(solved, 280);  // cold starts of contacts at random; what does not settle is the sweeps'
    EXPECT_GE(same, solved - solved / 50);
}

/// An attempt for which there is not enough work writes nothing: the sweeps go on from where they were.
TEST(DirectIsland, without_work_changes_nothing) {
    RandomInput random(3);
    for (int case_i = 0; case_i < 20; ++case_i) {
        RandomIsland island(random, random.integer(3, most_bodies), 1, 3);
        const std::vector<ingot::SolverBody> before(island.solver.bodies, island.solver.bodies + island.solver.body_count);
        ContactSolution found;
        EXPECT_FALSE(island.solve(found, 1));
        for (std::size_t i = 0; i < before.size(); ++i)
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(island.solver.bodies[i].v_CM[axis], before[i].v_CM[axis]);
                EXPECT_EQ(island.solver.bodies[i].L[axis], before[i].L[axis]);
            }
    }
}

/// Impulses that give energy are scaled to what gives least; those that take some stay as they are.
TEST(DirectIsland, holds_its_energy) {
    RandomInput random(4);
    int scaled = 0, kept = 0;
    for (int case_i = 0; case_i < 200; ++case_i) {
        RandomIsland island(random, 2, 1, 3);
        if (island.choose() == 0) continue;
        int island_i = 0;
        while (!island.is_chosen(island_i)) ++island_i;
        ingot::load_rows(island.solver, island.storage.bodies(), island.direct, island_i);
        ingot::SolverBody& body = island.solver.bodies[island.direct.bodies[1].body_i];
        const double M = 1 / static_cast<double>(body.v_CM[3]), share = random.real(-3, 3);
        const auto energy = [&] {
            double sum = 0;
            for (int axis = 0; axis < 3; ++axis) sum += static_cast<double>(body.v_CM[axis]) * static_cast<double>(body.v_CM[axis]);
            return M * sum / 2;
        };
        const double free_energy = energy();
        for (int axis = 0; axis < 3; ++axis) body.v_CM[axis] = static_cast<scalar>(static_cast<double>(body.v_CM[axis]) * share);
        const double given = energy();
        hold_energy(island.solver, island.direct);
        if (given > free_energy * (1 + 1e-6)) {  // along one direction the least is none at all, or what there was
            ++scaled;
            EXPECT_NEAR(energy(), share < 0 ? 0 : free_energy, 1e-6 * given) << share;
        } else if (given < free_energy * (1 - 1e-6)) {
            ++kept;
            EXPECT_EQ(energy(), given) << share;
        }
    }
    EXPECT_GT(scaled, 50);
    EXPECT_GT(kept, 20);
}

}  // namespace
