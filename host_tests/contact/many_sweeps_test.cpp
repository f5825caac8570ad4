// SPDX-License-Identifier: MIT
// The rows and the sweeps against the exact solution of the same contact problem: with sweeps enough they meet. Piles at random, one
// substep, from rest and from impulses of a step before.
#include <gtest/gtest.h>

#include <ingot/solver/sweeps/conjugate_gradients.h>
#include <ingot/solver/sweeps/order_manifolds.h>
#include <ingot/solver/sweeps/plan_islands.h>
#include <ingot/solver/sweeps/predict_contacts.h>
#include <ingot/solver/sweeps/solve_velocities.h>
#include <ingot/constraint/prepare_blocks.h>
#include <ingot/solver/sweeps/sweep_velocities.h>
#include <ingot/solver/sweeps/warm_start.h>
#include <ingot/solver/sequential/move_point_bodies.h>
#include <ingot/solver/sequential/sweep_points.h>

#include "contact/pile.h"
#include "contact/play.h"
#include "reference/contact_reference.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_contact;
using ingot::BodyPair;
using ingot::lanes;
using ingot_reference::ContactBody;
using ingot_reference::ContactProblem;
using ingot_reference::ContactSolution;
using ingot_reference::FrictionPatch;
using ingot_reference::RandomInput;

constexpr double h = 1.0 / 240, reference_tolerance = 1e-11;

void put(scalar (&to)[4], const Eigen::Vector3d& value, double fourth) {
    for (int axis = 0; axis < 3; ++axis) to[axis] = static_cast<scalar>(value(axis));
    to[3] = static_cast<scalar>(fourth);
}

/// A pile and the same as a problem for the reference; gravity has acted in both.
struct Twins {
    Pile pile;
    ContactProblem problem;
};

/// Bodies on top of each other and beside each other, three in four manifolds with several points; slot 0 is the ground.
Twins random_pile(RandomInput& random, double mu_max) {
    Twins twins{Pile(random.integer(2, 7)), {}};
    Pile& pile = twins.pile;
    twins.problem.h = h;
    std::vector<Matrix3d> inv_I(1, Matrix3d::Zero());
    twins.problem.bodies.emplace_back();
    for (int slot = 1; slot < pile.bodies; ++slot) {
        const double M = std::exp(random.real(-1, 1));
        const Matrix3d A = random.rotation();
        ContactBody body;
        body.inv_M = static_cast<double>(static_cast<scalar>(1 / M));
        body.inv_I_world = (A * random.moments(M).cwiseInverse().asDiagonal() * A.transpose()).unaryExpr([](double x) {
            return static_cast<double>(static_cast<scalar>(x));
        });
        body.inv_I_world = Matrix3d(body.inv_I_world.selfadjointView<Eigen::Upper>());
        body.r_CM = Eigen::Vector3d(random.real(-0.2, 0.2), random.real(-0.2, 0.2), slot - 0.5);
        body.v_CM = random.vector(0.3);
        body.omega = random.vector(0.3);
        twins.problem.bodies.push_back(body);

        const ingot::Place at = ingot::place_of(slot);
        ingot::TranslationTile& translation = pile.translation[static_cast<std::size_t>(at.tile)];
        translation.inv_M[at.lane] = static_cast<scalar>(body.inv_M);
        ingot::set_lane(translation.r_CM, at.lane, ingot_reference::to_vector(body.r_CM));
        const Matrix3d& I = body.inv_I_world;
        const ingot::Sym3<scalar> packed = {static_cast<scalar>(I(0, 0)), static_cast<scalar>(I(1, 1)), static_cast<scalar>(I(2, 2)),
                                            static_cast<scalar>(I(0, 1)), static_cast<scalar>(I(0, 2)), static_cast<scalar>(I(1, 2))};
        ingot::set_lane(translation.inv_I_world, at.lane, packed);
    }
    for (int upper = 1; upper < pile.bodies; ++upper) {
        for (int lower = 0; lower < upper; ++lower) {
            if (lower != upper - 1 && random.integer(0, 3) > 0) continue;  // on the one before, and at times on others
            ingot::ManifoldRecord record{};
            record.mu = static_cast<scalar>(random.real(0, mu_max));
            const Eigen::Vector3d up = (Eigen::Vector3d::UnitZ() + random.vector(0.2)).normalized();
            record.manifold.n = ingot_reference::to_vector(-up);  // A is the lower slot
            record.manifold.count = static_cast<int8_t>(random.integer(1, 4));
            const Eigen::Vector3d a = twins.problem.bodies[static_cast<std::size_t>(upper)].r_CM,
                                  b = twins.problem.bodies[static_cast<std::size_t>(lower)].r_CM;
            Eigen::Vector3d middle = lower == 0 ? Eigen::Vector3d(a - 0.5 * up) : Eigen::Vector3d((a + b) / 2);
            middle += random.vector(0.1);
            for (int i = 0; i < record.manifold.count; ++i) {
                const double angle = 1.5707963 * i + random.real(-0.5, 0.5);
                const Eigen::Vector3d e1 = up.unitOrthogonal(), e2 = up.cross(e1);
                record.manifold.points[i].P =
                    ingot_reference::to_vector(middle + random.real(0.2, 0.5) * (std::cos(angle) * e1 + std::sin(angle) * e2));
                record.manifold.points[i].separation = static_cast<scalar>(random.real(-0.001, 0));
                record.manifold.points[i].feature = static_cast<std::uint32_t>(i);
            }
            pile.pairs.push_back(
                {static_cast<ingot::Index>(lower), static_cast<ingot::Index>(upper), static_cast<ingot::Index>(pile.records.size())});
            pile.records.push_back(record);
        }
    }
    // Sorted by slots, as a world has them.
    std::sort(pile.pairs.begin(), pile.pairs.end(), [](const BodyPair& a, const BodyPair& b) { return a.key() < b.key(); });

    for (const BodyPair& pair : pile.pairs) {
        const ingot::ManifoldRecord& record = pile.records[pair.record];
        FrictionPatch patch;
        patch.body_A = pair.body_A;
        patch.body_B = pair.body_B;
        patch.n = to_eigen(record.manifold.n).normalized();
        patch.mu = static_cast<double>(record.mu);
        patch.r_P = Eigen::Vector3d::Zero();
        for (int i = 0; i < record.manifold.count; ++i) {
            ingot_reference::ContactPoint point;
            point.body_A = pair.body_A;
            point.body_B = pair.body_B;
            point.r_P = to_eigen(record.manifold.points[i].P);
            point.n = patch.n;
            patch.points.push_back(static_cast<int>(twins.problem.points.size()));
            patch.r_P += point.r_P / record.manifold.count;
            twins.problem.points.push_back(point);
        }
        double radius = 0;
        for (const int i : patch.points) radius += (twins.problem.points[static_cast<std::size_t>(i)].r_P - patch.r_P).norm() / record.manifold.count;
        patch.mu_twist = record.manifold.count > 1 ? patch.mu * radius : 0;
        twins.problem.patches.push_back(patch);
    }
    return twins;
}

/// The bodies of the problem as the solver takes them in, L for omega.
void take_in(ingot::SolverView& solver, const ContactProblem& problem) {
    solver.bodies[0] = {};
    solver.body_count = static_cast<int>(problem.bodies.size());
    for (int slot = 1; slot < solver.body_count; ++slot) {
        const ContactBody& body = problem.bodies[static_cast<std::size_t>(slot)];
        solver.local_of[slot] = solver.slot_of[slot] = static_cast<ingot::Index>(slot);
        put(solver.bodies[slot].v_CM, body.v_CM, body.inv_M);
        put(solver.bodies[slot].L, body.inv_I_world.inverse() * body.omega, 0);
    }
}

/// The islands of a pile that was taken in, and their sweeps, in which whatever changes makes active. A pile is one island, and new.
void plan(ingot::SolverView& solver, const ingot::BodyView& bodies) {
    ingot::NoJointedBodies none;
    ingot::find_levels(solver, none);
    ingot::plan_islands(solver, none, bodies, static_cast<scalar>(h));
    ASSERT_TRUE(ingot::begin_batch(solver, none, ingot::SweepPlan::small, bodies, {}));
    ingot::prepare_blocks(solver, bodies);
    ingot::count_central_manifolds(solver);
    ingot::predict_contacts(solver, static_cast<scalar>(h));
    ingot::predict_bounces(solver, static_cast<scalar>(h));
    ingot::warm_start(solver, solver.visits, solver.visit_count, static_cast<scalar>(h));  // impulses are 0 as yet: nothing is given
    ingot::plan_sweeps(solver);
    for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].settled = 0;
    ingot::select_live(solver);
    ingot::begin_sweeps(solver);
}

ContactSolution solution_of(const ingot::SolverView& solver, const ContactProblem& problem) {
    ContactSolution found;
    for (int slot = 0; slot < solver.body_count; ++slot) {
        const ContactBody& body = problem.bodies[static_cast<std::size_t>(slot)];
        const ingot::SolverBody& now = solver.bodies[slot];
        found.v_CM.emplace_back(now.v_CM[0], now.v_CM[1], now.v_CM[2]);
        found.omega.push_back(body.inv_I_world * Eigen::Vector3d(now.L[0], now.L[1], now.L[2]));
    }
    return found;
}

/// What sweeps still change, m/s, decides how far they are: a sequence that shrinks by q is within residual / (1 - q) of its end. The rows'
/// own rounding, some units in the last place of 1 m/s in each of up to twelve manifolds, is taken up as often. These piles shrink by
/// 0.9 and faster.
void expect_sweeps_meet_the_exact_solution(double mu_max) {
    RandomInput random(8);
    double worst = 0, worst_share = 0;
    int compared = 0;
    for (int pile_i = 0; pile_i < 60; ++pile_i) {
        Twins twins = random_pile(random, mu_max);
        const ContactSolution exact = ingot_reference::solve_contacts(twins.problem, reference_tolerance);
        if (!exact.converged) continue;  // friction on several sides may have no solution that Newton finds
        ingot::SolverView solver = twins.pile.solver();
        take_in(solver, twins.problem);
        plan(solver, twins.pile.view());
        ASSERT_EQ(solver.island_count, 1);
        constexpr int sweeps = 2000;
        for (int sweep_i = 1; sweep_i <= sweeps; ++sweep_i)
            ingot::sweep_velocities(solver, solver.live, solver.live_count, sweep_i, sweep_i % 2 != 0);
        ingot::measure_sweep(solver);
        const auto residual = static_cast<double>(solver.islands[0].residual);
        const double bound = (residual + 12 * 4 * static_cast<double>(ingot::epsilon)) / (1 - 0.9) + reference_tolerance;
        const double distance = ingot_reference::velocity_distance(twins.problem, exact, solution_of(solver, twins.problem));
        worst = std::max(worst, distance);
        worst_share = std::max(worst_share, distance / bound);
        EXPECT_LE(distance, bound) << "pile " << pile_i << " of " << twins.pile.bodies << " bodies, residual " << residual;
        ++compared;
    }
    figure("piles", compared);
    figure("largest distance, m/s", worst);
    figure("largest share of its bound", worst_share);
    EXPECT_GT(compared, 40);
}
TEST(ManySweeps, without_friction_lead_to_the_exact_solution) { expect_sweeps_meet_the_exact_solution(0); }
/// Coulomb's law to the letter: where a manifold slides, friction is against the slip.
TEST(ManySweeps, with_friction_lead_to_the_exact_solution) { expect_sweeps_meet_the_exact_solution(0.4); }

/// Of a manifold with one point whose normal goes through both centres of mass there is nothing to turn: such a heap gets more sweeps.
TEST(Blocks, know_how_many_manifolds_are_central) {
    RandomInput random(9);
    for (int pile_i = 0; pile_i < 40; ++pile_i) {
        Twins twins = random_pile(random, 0);
        int central = 0;
        for (const BodyPair& pair : twins.pile.pairs) {
            if (random.integer(0, 1) == 0) continue;  // as it is: its points are beside the middle
            ingot::Manifold& manifold = twins.pile.records[pair.record].manifold;
            const Eigen::Vector3d b = twins.problem.bodies[pair.body_B].r_CM;
            const Eigen::Vector3d a = pair.body_A == 0 ? Eigen::Vector3d(b.x(), b.y(), 0) : twins.problem.bodies[pair.body_A].r_CM;
            manifold.count = 1;
            manifold.n = ingot_reference::to_vector((a - b).normalized());
            manifold.points[0].P = ingot_reference::to_vector(pair.body_A == 0 ? a : Eigen::Vector3d((a + b) / 2));
            ++central;
        }
        ingot::SolverView solver = twins.pile.solver();
        take_in(solver, twins.problem);
        plan(solver, twins.pile.view());
        ASSERT_EQ(solver.island_count, 1);
        EXPECT_EQ(solver.islands[0].central_count, central) << pile_i;
        const int visits = solver.visit_count, levels = solver.islands[0].level_count;
        plan(solver, twins.pile.view());
        ASSERT_EQ(solver.island_count, 1);
        EXPECT_EQ(solver.visit_count, visits) << "what the view held before does not matter";
        EXPECT_EQ(solver.islands[0].level_count, levels);
        EXPECT_EQ(solver.islands[0].central_count, central) << pile_i;
    }
}

/// What the last sweep changed of all contacts, one by one: no term is below zero, so the roundings of any order are of the sum.
double sum_by_lanes(const ingot::SolverView& solver) {
    double sum = 0;
    for (int position = 0; position < solver.lane_count; ++position)
        if (ingot::manifold_at(solver, position) != ingot::no_manifold)
            sum += static_cast<double>(solver.blocks[position / lanes].change[position % lanes]);
    return sum;
}

/// The sequential solver on a pile, whose bodies have the velocities of the problem.
struct LightPile {
    std::vector<ingot::PointBody> bodies;
    std::vector<ingot::PointContact> contacts;
    std::vector<ingot::Index> members, body_slots;
    ingot::PointView view{};

    explicit LightPile(Twins& twins)
        : bodies(twins.pile.rotation.size() * lanes), contacts(twins.pile.pairs.size()), members(contacts.size()), body_slots(bodies.size()) {
        view.pairs = twins.pile.pairs.data(), view.records = twins.pile.records.data();
        view.manifold_count = static_cast<int>(twins.pile.pairs.size());
        view.bodies = bodies.data(), view.contacts = contacts.data(), view.members = members.data(), view.body_slots = body_slots.data();
        ingot::take_in_bodies(view, twins.pile.view(), {}, static_cast<scalar>(h));
        ingot::join_bodies(view);
        EXPECT_TRUE(ingot::next_island(view));
        EXPECT_EQ(view.member_count, view.manifold_count) << "all of a pile is one island";
        for (std::size_t slot = 1; slot < twins.problem.bodies.size(); ++slot) {
            const ContactBody& body = twins.problem.bodies[slot];
            bodies[slot].velocity = {ingot_reference::to_vector(body.v_CM), ingot_reference::to_vector(body.omega),
                                     ingot_reference::to_vector(Eigen::Vector3d(body.inv_I_world.inverse() * body.omega))};
        }
        ingot::begin_contacts(view, 1, static_cast<scalar>(h));
    }
    /// Sweeps, joined by conjugate gradients or not; returns what the last still changed, m/s.
    double sweep(int sweeps, bool joined) {
        ingot::SweepOfPoints made{};
        scalar before = 0;
        for (int sweep_i = 1; sweep_i <= sweeps; ++sweep_i) {
            made = ingot::sweep_point_velocities(view, sweep_i % 2 != 0, 0);
            if (joined && sweep_i < sweeps) ingot::go_on_along(view, sweep_i > 1 && before > 0 && made.size <= before ? made.size / before : 0);
            before = made.size;
        }
        return static_cast<double>(made.fastest);
    }
    ContactSolution solution() const {
        ContactSolution found;
        for (const ingot::PointBody& body : bodies) {
            const bool moves = body.inv_M > 0;
            found.v_CM.push_back(moves ? to_eigen(body.velocity.linear) : Eigen::Vector3d::Zero());
            found.omega.push_back(moves ? to_eigen(body.velocity.angular) : Eigen::Vector3d::Zero());
        }
        return found;
    }
};

/// The sequential solver's rows lead there too. Point by point these piles shrink by 0.99 and faster, and what points and bodies round is as much
/// more.
void expect_points_meet_the_exact_solution(double mu_max) {
    RandomInput random(8);
    double worst = 0, worst_share = 0;
    int compared = 0;
    for (int pile_i = 0; pile_i < 60; ++pile_i) {
        Twins twins = random_pile(random, mu_max);
        const ContactSolution exact = ingot_reference::solve_contacts(twins.problem, reference_tolerance);
        if (!exact.converged) continue;
        LightPile light(twins);
        const double residual = light.sweep(2000, false);
        const double bound = (residual + 4 * static_cast<double>(ingot::epsilon)) / (1 - 0.99) + reference_tolerance;
        const double distance = ingot_reference::velocity_distance(twins.problem, exact, light.solution());
        worst = std::max(worst, distance);
        worst_share = std::max(worst_share, distance / bound);
        EXPECT_LE(distance, bound) << "pile " << pile_i << " of " << twins.pile.bodies << " bodies, residual " << residual;
        ++compared;
    }
    figure("piles", compared);
    figure("largest distance, m/s", worst);
    figure("largest share of its bound", worst_share);
    EXPECT_GT(compared, 40);
}
TEST(ManySweepsOfPoints, without_friction_lead_to_the_exact_solution) { expect_points_meet_the_exact_solution(0); }
TEST(ManySweepsOfPoints, with_friction_lead_to_the_exact_solution) { expect_points_meet_the_exact_solution(0.4); }

/// Who cannot move, has gone bad or touches nothing was not hit, whatever a step before has left.
TEST(ManySweepsOfPoints, begin_with_bodies_that_were_not_hit) {
    RandomInput random(10);
    Twins twins = random_pile(random, 0);
    LightPile light(twins);
    for (ingot::PointBody& body : light.bodies) body.hit = true;
    ingot::take_in_bodies(light.view, twins.pile.view(), {}, static_cast<scalar>(h));
    for (const ingot::PointBody& body : light.bodies) EXPECT_FALSE(body.hit);
}

/// Of an impact the next substep is given no more again than twice what was given before it, and what stops two substeps of gravity.
TEST(ManySweepsOfPoints, give_no_impact_again) {
    RandomInput random(11);
    int cut = 0;
    for (int pile_i = 0; pile_i < 40; ++pile_i) {
        Twins twins = random_pile(random, 0);
        LightPile light(twins);
        for (ingot::PointBody& body : light.bodies) {
            body.hit = random.integer(0, 2) == 0;
            body.forces.linear = ingot_reference::to_vector(random.vector(10));
        }
        std::vector<ingot::ManifoldRecord>& records = twins.pile.records;
        for (ingot::ManifoldRecord& record : records)
            for (int i = 0; i < record.manifold.count; ++i)
                record.j[i] = static_cast<scalar>(random.real(0, 2)), record.j_before[i] = static_cast<scalar>(random.real(0, 0.5));
        const std::vector<ingot::ManifoldRecord> before = records;
        ingot::sweep_point_positions(light.view, static_cast<scalar>(h));
        for (const BodyPair& pair : twins.pile.pairs) {
            const ingot::ManifoldRecord &was = before[pair.record], &is = records[pair.record];
            const Eigen::Vector3d n = to_eigen(was.manifold.n);
            double pull = 0;
            for (const int slot : {pair.body_A, pair.body_B})
                if (slot != 0) pull = std::max(pull, to_eigen(light.bodies[static_cast<std::size_t>(slot)].forces.linear).norm());
            const bool hit = light.bodies[pair.body_A].hit || light.bodies[pair.body_B].hit;
            for (int i = 0; i < was.manifold.count; ++i) {
                double K = 0;
                for (const int slot : {pair.body_A, pair.body_B}) {
                    const ContactBody& body = twins.problem.bodies[static_cast<std::size_t>(slot)];
                    if (slot == 0) continue;
                    const Eigen::Vector3d lever = (to_eigen(was.manifold.points[i].P) - body.r_CM).cross(n);
                    K += body.inv_M + lever.dot(body.inv_I_world * lever);
                }
                const double j = static_cast<double>(was.j[i]), most = 2 * static_cast<double>(was.j_before[i]) + 2 * h * pull / K;
                // K is a sum of a dozen rounded products of numbers of one sign, and levers of places up to 7 m.
                EXPECT_NEAR(static_cast<double>(is.j[i]), hit ? std::min(j, most) : j, 64 * static_cast<double>(ingot::epsilon)) << pile_i;
                cut += hit && most < j ? 1 : 0;
            }
        }
    }
    EXPECT_GT(cut, 50);
}

/// As many sweeps as a substep may have, with conjugate gradients, are nearer to it than without.
TEST(ManySweepsOfPoints, with_conjugate_gradients_lead_there_sooner) {
    RandomInput random(9);
    double sum[2] = {0, 0};
    int compared = 0;
    for (int pile_i = 0; pile_i < 40; ++pile_i) {
        const Twins twins = random_pile(random, 0);
        const ContactSolution exact = ingot_reference::solve_contacts(twins.problem, reference_tolerance);
        if (!exact.converged) continue;
        for (const bool joined : {false, true}) {
            Twins own = twins;
            LightPile light(own);
            (void)light.sweep(ingot::limits::sweeps_of_points, joined);
            sum[joined] += std::log(ingot_reference::velocity_distance(twins.problem, exact, light.solution()) + 1e-7);
        }
        ++compared;
    }
    figure("mean distance, m/s", std::exp(sum[0] / compared));
    figure("the same with conjugate gradients, m/s", std::exp(sum[1] / compared));
    EXPECT_LT(sum[1], sum[0]);
    EXPECT_GT(compared, 25);
}

/// The extrapolations of conjugate gradients lead to the same end, and sooner.
TEST(ManySweeps, with_conjugate_gradients_lead_there_too) {
    RandomInput random(9);
    double plain_sum = 0, joined_sum = 0;
    int compared = 0;
    for (int pile_i = 0; pile_i < 40; ++pile_i) {
        Twins twins = random_pile(random, 0);
        const ContactSolution exact = ingot_reference::solve_contacts(twins.problem, reference_tolerance);
        if (!exact.converged) continue;
        double distance[2];
        for (const bool joined : {false, true}) {
            ingot::SolverView solver = twins.pile.solver();
            take_in(solver, twins.problem);
            plan(solver, twins.pile.view());
            ASSERT_EQ(solver.island_count, 1);
            ingot::Island& island = solver.islands[0];
            scalar before = 0;
            for (int sweep_i = 1; sweep_i <= 8; ++sweep_i) {
                ingot::sweep_velocities(solver, solver.live, solver.live_count, sweep_i, sweep_i % 2 != 0);
                ingot::measure_sweep(solver);
                const scalar size = island.size;
                EXPECT_NEAR(static_cast<double>(size), sum_by_lanes(solver), 64 * static_cast<double>(ingot::epsilon * size));
                island.beta = sweep_i > 1 && size <= before && before > 0 ? size / before : 0;
                before = size;
                if (joined && sweep_i < 8) ingot::extrapolate(solver);
            }
            distance[joined] = ingot_reference::velocity_distance(twins.problem, exact, solution_of(solver, twins.problem));
        }
        plain_sum += std::log(distance[0] + 1e-7);
        joined_sum += std::log(distance[1] + 1e-7);
        ++compared;
    }
    figure("mean distance after 8 sweeps, m/s", std::exp(plain_sum / compared));
    figure("the same with conjugate gradients, m/s", std::exp(joined_sum / compared));
    EXPECT_LT(joined_sum, plain_sum);
    EXPECT_GT(compared, 25);
}

}  // namespace
