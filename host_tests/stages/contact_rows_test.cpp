// SPDX-License-Identifier: MIT
// Impacts without friction as rows: each row against Figure 4 term by term, the solve against the conditions that its answer has to meet, and
// numbers that leave the range.
#include <gtest/gtest.h>
#include <ingot/base/limits.h>
#include <ingot/body/auxiliary.h>
#include <ingot/impulse/contact_rows.h>
#include <ingot/impulse/solve_contact_forces.h>
#include <ingot/impulse/solve_impacts.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "reference/eigen_impulse.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"
#include "tiles.h"

namespace {

using namespace ingot_reference;
using ingot::Contact;
using ingot::scalar;
using ingot_stages::Tiles;
using Real = long double;
using V = Eigen::Matrix<Real, 3, 1>;

constexpr double eps = static_cast<double>(ingot::epsilon);
ingot::AnyVisits any_visits;

/// Bodies, and contacts between them that need no shapes.
struct Rows {
    Tiles tiles;
    std::vector<Contact> contacts;
    ingot::Index count = 0;

    explicit Rows(int slots) : tiles(slots) {}
    ingot::ContactView view() {
        count = static_cast<ingot::Index>(contacts.size());
        return {contacts.data(), &count, static_cast<int>(contacts.size())};
    }

    /// n from B to A; the places of the point are from the centres of mass.
    void touch(int A, int B, const Eigen::Vector3d& n, const Eigen::Vector3d& r_A, const Eigen::Vector3d& r_B, double e = 0) {
        Contact c{};
        c.body_A = static_cast<ingot::Index>(A), c.body_B = static_cast<ingot::Index>(B);
        c.n = to_vector(n);
        c.lever_A = cross(to_vector(r_A), c.n), c.lever_B = cross(to_vector(r_B), c.n);
        c.e = static_cast<scalar>(e);
        c.touches = true;
        contacts.push_back(c);
    }
    /// Impacts as the step begins.
    void solve_impacts(scalar rest_speed, ingot::StepReport& report) {
        ingot::solve_impacts({tiles.view(), {}, {}, 0, rest_speed}, view(), 0, true, any_visits, report);
    }
    void prepare() {
        ingot::refresh_inv_I_world(tiles.view());
        for (ingot::Contact& c : contacts) ingot::prepare_contact_row<false>(c, tiles.view());
    }
    V v(int slot) { return to_eigen<Real>(ingot::lane_of(tiles.translation(slot).v_CM, slot % ingot::lanes)); }
    V L(int slot) { return to_eigen<Real>(ingot::lane_of(tiles.rotation(slot).L, slot % ingot::lanes)); }
    Real inv_M(int slot) { return static_cast<Real>(tiles.translation(slot).inv_M[slot % ingot::lanes]); }
    Eigen::Matrix<Real, 3, 3> inv_I(int slot) {
        return to_eigen<Real>(ingot::lane_of(tiles.translation(slot).inv_I_world, slot % ingot::lanes));
    }
    /// n.(v_AP - v_BP) from omega = I^-1 L and the lever r x n: n.(omega x r) = omega.(r x n).
    Real speed(const Contact& c) {
        const V n = to_eigen<Real>(c.n), l_A = to_eigen<Real>(c.lever_A), l_B = to_eigen<Real>(c.lever_B);
        return n.dot(v(c.body_A) - v(c.body_B)) + (inv_I(c.body_A) * L(c.body_A)).dot(l_A) - (inv_I(c.body_B) * L(c.body_B)).dot(l_B);
    }
    bool kicked(int slot) { return (tiles.rotation(slot).kicked >> (slot % ingot::lanes) & 1u) != 0; }
    bool bad(int slot) { return (tiles.rotation(slot).bad >> (slot % ingot::lanes) & 1u) != 0; }
};

void put(Rows& rows, int slot, RandomInput& random, bool immovable = false) {
    ingot::BodyDef def = definition(random.real(0.5, 4), random.moments(1));
    def.state = {to_vector(random.vector(3)), to_vector(random.vector(3)), to_matrix(random.rotation()), to_vector(random.vector(1))};
    def.immovable = immovable;
    rows.tiles.write(slot, def);
}

TEST(ContactRow, has_the_denominator_and_the_speed_of_figure_4) {
    RandomInput random(301);
    for (int case_i = 0; case_i < 300; ++case_i) {
        Rows rows(ingot::lanes + 3);
        const int A = ingot::lanes + 1, B = 1;
        put(rows, A, random, case_i % 3 == 1);
        put(rows, B, random, case_i % 3 == 2);
        const Eigen::Vector3d n = random.direction(), r_A = random.vector(2), r_B = random.vector(2);
        rows.touch(A, B, n, r_A, r_B);
        rows.contacts[0].active = true, rows.contacts[0].j = rows.contacts[0].tolerance = 7;
        rows.prepare();
        const Contact& c = rows.contacts[0];
        // Figure 4 as printed, of the numbers that the kernel was given. A body that nothing moves has neither 1/M nor 1/I.
        const V n_ = to_eigen<Real>(c.n), rA = to_eigen<Real>(to_vector(r_A)), rB = to_eigen<Real>(to_vector(r_B));
        const Eigen::Matrix<Real, 3, 3> zero = Eigen::Matrix<Real, 3, 3>::Zero();
        const bool moves_A = case_i % 3 != 1, moves_B = case_i % 3 != 2;
        const Eigen::Matrix<Real, 3, 3> I_A = moves_A ? rows.inv_I(A) : zero, I_B = moves_B ? rows.inv_I(B) : zero;
        const Real K = rows.inv_M(A) + rows.inv_M(B) + ((I_A * rA.cross(n_)).cross(rA) + (I_B * rB.cross(n_)).cross(rB)).dot(n_);
        EXPECT_EQ(rows.inv_M(A) > 0, moves_A);
        EXPECT_EQ(rows.inv_M(B) > 0, moves_B);
        // Some thirty roundings of sums of squares; |n|^2 is 1 to two.
        EXPECT_NEAR(static_cast<double>(c.inv_K * static_cast<scalar>(K)), 1, 64 * eps) << case_i;
        EXPECT_NEAR(static_cast<double>((to_eigen<Real>(c.k_A) - I_A * rA.cross(n_)).norm()), 0,
                    64 * eps * static_cast<double>(I_A.norm() * rA.norm()));
        EXPECT_NEAR(static_cast<double>((to_eigen<Real>(c.k_B) - I_B * rB.cross(n_)).norm()), 0,
                    64 * eps * static_cast<double>(I_B.norm() * rB.norm()));
        EXPECT_EQ(to_eigen(c.lever_A).isZero(), !moves_A);
        EXPECT_EQ(to_eigen(c.lever_B).isZero(), !moves_B);
        EXPECT_FALSE(c.active);
        EXPECT_EQ(c.tolerance, 0);
        EXPECT_EQ(c.j, 0);

        const ingot::NormalSpeed speed = ingot::normal_speed(c, rows.tiles.view());
        const V omega_A = I_A * rows.L(A), omega_B = I_B * rows.L(B);
        const Real u = ((rows.v(A) + omega_A.cross(rA)) - (rows.v(B) + omega_B.cross(rB))).dot(n_);
        EXPECT_NEAR(static_cast<double>(speed.u), static_cast<double>(u), 64 * eps * static_cast<double>(speed.magnitude));
        const Real sizes = (n_.cwiseProduct(rows.v(A)).cwiseAbs() + n_.cwiseProduct(rows.v(B)).cwiseAbs() +
                            to_eigen<Real>(c.k_A).cwiseProduct(rows.L(A)).cwiseAbs() + to_eigen<Real>(c.k_B).cwiseProduct(rows.L(B)).cwiseAbs())
                               .sum();
        EXPECT_NEAR(static_cast<double>(speed.magnitude), static_cast<double>(sizes), 64 * eps * static_cast<double>(sizes));
        const scalar rounding = ingot::limits::contact_roundings * ingot::epsilon * speed.magnitude;
        EXPECT_EQ(ingot::tolerance_of(c, speed), rounding);
        Contact coarse = c;
        coarse.tolerance = 2 * rounding;  // the largest that it was in this step
        EXPECT_EQ(ingot::tolerance_of(coarse, speed), 2 * rounding);
    }
}

TEST(ContactRow, gives_equal_and_opposite_impulses) {
    RandomInput random(302);
    for (int case_i = 0; case_i < 200; ++case_i) {
        Rows rows(ingot::lanes + 1);
        put(rows, 0, random);
        put(rows, ingot::lanes, random);
        const bool central_A = case_i % 4 == 1, central_B = case_i % 4 == 2;
        const Eigen::Vector3d n = random.direction(), zero = Eigen::Vector3d::Zero();
        const Eigen::Vector3d r_A = random.vector(2), r_B = random.vector(2);
        rows.touch(0, ingot::lanes, n, central_A ? zero : r_A, central_B ? zero : r_B);
        rows.prepare();
        const Contact c = rows.contacts[0];
        rows.tiles.rotation(0).kicked = rows.tiles.rotation(ingot::lanes).kicked = 0;
        const V v_A = rows.v(0), v_B = rows.v(ingot::lanes), L_A = rows.L(0), L_B = rows.L(ingot::lanes);
        const auto j = static_cast<scalar>(random.real(0.1, 3));
        ASSERT_TRUE(ingot::apply_impulse(c, j, rows.tiles.view()));
        const V J = to_eigen<Real>(c.n) * static_cast<Real>(j);
        // Each component is rounded at its product, its factor and its sum.
        const auto near = [&](const V& a, const V& b, Real scale) {
            EXPECT_LE(static_cast<double>((a - b).norm()), 8 * eps * static_cast<double>(scale)) << case_i;
        };
        near(rows.v(0), v_A + J * rows.inv_M(0), v_A.norm() + J.norm() * rows.inv_M(0));
        near(rows.v(ingot::lanes), v_B - J * rows.inv_M(ingot::lanes), v_B.norm() + J.norm() * rows.inv_M(ingot::lanes));
        near(rows.L(0), L_A + to_eigen<Real>(c.lever_A) * static_cast<Real>(j), L_A.norm() + to_eigen<Real>(c.lever_A).norm() * static_cast<Real>(j));
        near(rows.L(ingot::lanes), L_B - to_eigen<Real>(c.lever_B) * static_cast<Real>(j),
             L_B.norm() + to_eigen<Real>(c.lever_B).norm() * static_cast<Real>(j));
        EXPECT_EQ(rows.kicked(0), !central_A) << "a central impulse leaves the free flight alone";
        EXPECT_EQ(rows.kicked(ingot::lanes), !central_B);
        EXPECT_EQ(rows.tiles.rotation(0).kicked & ~1u, 0u) << "nobody else was";
    }
}

/// An impulse that no number holds is given to neither of the two, and who would have been carried off by it is marked.
TEST(ContactRow, that_leaves_the_range_changes_nothing_and_marks_whom_it_would_have) {
    constexpr scalar most = std::numeric_limits<scalar>::max(), j = most / 8;  // added to `most` in its direction it has no finite rounding
    constexpr int A = 0, B = ingot::lanes;
    struct Blow {
        scalar v_A, L_A, v_B, L_B;
        bool bad_A, bad_B;
    };
    for (const Blow& blow : {Blow{0, 0, 0, 0, false, false}, Blow{most, 0, 0, 0, true, false}, Blow{0, most, 0, 0, true, false},
                             Blow{0, 0, -most, 0, false, true}, Blow{0, 0, 0, -most, false, true}, Blow{most, 0, 0, -most, true, true}}) {
        Rows rows(B + 1);
        for (const int slot : {A, B}) rows.tiles.write(slot, definition(1, Eigen::Vector3d::Ones()));
        // n = x and r = -y for both: r x n = z.
        rows.touch(A, B, Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitY());
        rows.prepare();
        rows.tiles.translation(A).v_CM[0][0] = blow.v_A, rows.tiles.rotation(A).L[2][0] = blow.L_A;
        rows.tiles.translation(B).v_CM[0][0] = blow.v_B, rows.tiles.rotation(B).L[2][0] = blow.L_B;
        rows.tiles.rotation(A).kicked = 0;
        const bool fits = !blow.bad_A && !blow.bad_B;
        EXPECT_EQ(ingot::apply_impulse(rows.contacts[0], j, rows.tiles.view()), fits);
        EXPECT_EQ(rows.bad(A), blow.bad_A);
        EXPECT_EQ(rows.bad(B), blow.bad_B);
        EXPECT_EQ(rows.kicked(A), fits);
        const scalar given = fits ? j : scalar(0);
        EXPECT_EQ(rows.tiles.translation(A).v_CM[0][0], blow.v_A + given);
        EXPECT_EQ(rows.tiles.rotation(A).L[2][0], blow.L_A + given);
        EXPECT_EQ(rows.tiles.translation(B).v_CM[0][0], blow.v_B - given);
        EXPECT_EQ(rows.tiles.rotation(B).L[2][0], blow.L_B - given);
    }
}

/// Of a pair with an impulse that no number holds: its row is given up, and no body moves by what was not given.
TEST(ContactRows, whose_impulse_leaves_the_range_are_given_up) {
    constexpr scalar most = std::numeric_limits<scalar>::max();
    for (const int points : {1, 2}) {
        Rows rows(2);
        // All the speed is that of the centres
        for (const int slot : {0, 1}) rows.tiles.write(slot, definition(1, Eigen::Vector3d(1e6 * Eigen::Vector3d::Ones())));
        for (int i = 0; i < points; ++i) rows.touch(0, 1, Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitY() * (1 + i), -Eigen::Vector3d::UnitY());
        rows.prepare();
        rows.tiles.rotation(0).L[2][0] = most;  // any impulse drives it beyond
        for (Contact& c : rows.contacts) c.active = true, c.target = most;
        const ingot::SweepOutcome outcome = ingot::solve_active_contacts(rows.view(), rows.tiles.view(), any_visits);
        EXPECT_TRUE(outcome.finished) << "nothing is left to sweep over";
        EXPECT_TRUE(rows.bad(0));
        for (const Contact& c : rows.contacts) {
            EXPECT_FALSE(c.active && c.j > 0);
            EXPECT_TRUE(ingot::is_finite(c.j));
        }
        EXPECT_EQ(rows.tiles.rotation(0).L[2][0], most);
        EXPECT_EQ(rows.v(0), V::Zero());
        EXPECT_EQ(rows.v(1), V::Zero());
    }
}

TEST(ContactRows, of_one_pair_stand_together) {
    Rows rows(4);
    const Eigen::Vector3d n = Eigen::Vector3d::UnitX(), r = Eigen::Vector3d::UnitY();
    for (const auto& [A, B] : {std::pair(0, 1), std::pair(0, 1), std::pair(0, 2), std::pair(1, 2), std::pair(1, 2), std::pair(1, 2)})
        rows.touch(A, B, n, r, r);
    EXPECT_EQ(ingot::manifold_end(rows.view(), 0), 2);
    EXPECT_EQ(ingot::manifold_end(rows.view(), 1), 2);
    EXPECT_EQ(ingot::manifold_end(rows.view(), 2), 3);
    EXPECT_EQ(ingot::manifold_end(rows.view(), 3), 6);
    rows.count = 4;  // the array goes on, the contacts do not
    EXPECT_EQ(ingot::manifold_end({rows.contacts.data(), &rows.count, 6}, 3), 4);
}

/// A chain of bodies, each pair of which touches at up to four points, some bodies immovable.
Rows chain_of(RandomInput& random, int bodies) {
    Rows rows(bodies);
    for (int slot = 0; slot < bodies; ++slot) put(rows, slot, random, slot % 5 == 4);
    for (int A = 0; A + 1 < bodies; ++A) {
        const Eigen::Vector3d n = random.direction();
        const int points = random.integer(1, 4);
        for (int point_i = 0; point_i < points; ++point_i) {
            const Eigen::Vector3d r_A = random.vector(1), r_B = random.vector(1);  // in this order with every compiler
            rows.touch(A, A + 1, n, r_A, r_B, random.real(0, 1));
        }
    }
    rows.prepare();
    return rows;
}

/// As many visits as it takes give the same bits as no budget; with less it ends there, and says so.
TEST(ContactRows, are_visited_within_a_budget) {
    RandomInput random(305);
    int cut_short = 0;
    for (int case_i = 0; case_i < 200; ++case_i) {
        const int bodies = random.integer(2, 9);
        const auto aimed = [&](Rows rows) {
            for (Contact& c : rows.contacts) {
                c.tolerance = ingot::tolerance_of(c, ingot::normal_speed(c, rows.tiles.view()));
                c.active = true;
                c.target = 1;
            }
            return rows;
        };
        const Rows begin = aimed(chain_of(random, bodies));
        Rows free = begin, within = begin, scarce = begin;
        const int contacts = static_cast<int>(begin.contacts.size());
        const ingot::SweepOutcome wanted = ingot::solve_active_contacts(free.view(), free.tiles.view(), any_visits);
        ingot::VisitsLeft plenty{ingot::no_budget - 1};
        const ingot::SweepOutcome outcome = ingot::solve_active_contacts(within.view(), within.tiles.view(), plenty);
        EXPECT_EQ(outcome.sweeps, wanted.sweeps);
        const int taken = ingot::no_budget - 1 - plenty.count;
        EXPECT_GE(taken, contacts * outcome.sweeps);
        for (int slot = 0; slot < bodies; ++slot) EXPECT_EQ(within.v(slot), free.v(slot)) << case_i;

        ingot::VisitsLeft few{random.integer(contacts, taken)};
        const bool enough = few.count == taken;
        const ingot::SweepOutcome ended = ingot::solve_active_contacts(scarce.view(), scarce.tiles.view(), few);
        EXPECT_GE(few.count, 0);
        for (const Contact& c : scarce.contacts) EXPECT_GE(c.j, 0) << "what is cut short pushes too";
        cut_short += !ended.finished;
        if (!enough && wanted.finished) {
            EXPECT_FALSE(ended.finished);
        }
    }
    EXPECT_GT(cut_short, 50);
}

/// What settles a row: its tolerance, after a quarter of the sweeps limits::contact_slack times it; and the rounding of this test's sums.
double allowed(const Contact& c) { return static_cast<double>(c.tolerance) * static_cast<double>(ingot::limits::contact_slack) * 2; }

/// The conditions of Signorini, in velocities: j >= 0, speed >= target, and one of the two is an equality. With a mass matrix that is
/// positive definite they have one answer for the velocities, and this test needs no other solver.
TEST(ContactRows, of_many_pairs_meet_the_conditions_of_complementarity) {
    RandomInput random(304);
    int pressed = 0, loose = 0, left_out = 0, unfinished = 0;
    for (int case_i = 0; case_i < 200; ++case_i) {
        const int bodies = random.integer(2, 9);
        Rows rows = chain_of(random, bodies);
        for (Contact& c : rows.contacts) {
            c.tolerance = ingot::tolerance_of(c, ingot::normal_speed(c, rows.tiles.view()));
            c.active = random.integer(0, 5) != 0;
            c.target = static_cast<scalar>(random.real(-1, 1));
            c.j = 7;  // of the solve before: forgotten
        }
        std::vector<V> v, L;
        for (int slot = 0; slot < bodies; ++slot) v.push_back(rows.v(slot)), L.push_back(rows.L(slot));
        const ingot::SweepOutcome outcome = ingot::solve_active_contacts(rows.view(), rows.tiles.view(), any_visits);
        EXPECT_GE(outcome.sweeps, 1);
        EXPECT_EQ(outcome.finished || outcome.sweeps == ingot::limits::contact_sweeps_max, true);
        unfinished += outcome.finished ? 0 : 1;  // as the header says: the rest is reported, and promises no more than that
        if (!outcome.finished) continue;
        for (const Contact& c : rows.contacts) {
            if (!c.active) {
                EXPECT_EQ(c.j, 0);
                ++left_out;
                continue;
            }
            const double over = static_cast<double>(rows.speed(c)) - static_cast<double>(c.target);
            EXPECT_GE(c.j, 0);
            EXPECT_GE(over, -allowed(c)) << case_i;
            if (c.j > 0) {
                EXPECT_LE(over, allowed(c)) << case_i;
            }
            ++(c.j > 0 ? pressed : loose);
        }
        // What the bodies have received is what the rows say that they gave.
        for (const Contact& c : rows.contacts) {
            v[c.body_A] += to_eigen<Real>(c.n) * static_cast<Real>(c.j) * rows.inv_M(c.body_A);
            v[c.body_B] -= to_eigen<Real>(c.n) * static_cast<Real>(c.j) * rows.inv_M(c.body_B);
            L[c.body_A] += to_eigen<Real>(c.lever_A) * static_cast<Real>(c.j);
            L[c.body_B] -= to_eigen<Real>(c.lever_B) * static_cast<Real>(c.j);
        }
        for (int slot = 0; slot < bodies; ++slot) {
            const double roundings = 64 * eps * outcome.sweeps * 4;
            EXPECT_LE(static_cast<double>((v[static_cast<std::size_t>(slot)] - rows.v(slot)).norm()),
                      roundings * (1 + static_cast<double>(rows.v(slot).norm())));
            EXPECT_LE(static_cast<double>((L[static_cast<std::size_t>(slot)] - rows.L(slot)).norm()),
                      roundings * (1 + static_cast<double>(rows.L(slot).norm())));
        }
    }
    EXPECT_GT(pressed, 300);
    EXPECT_GT(loose, 300);
    EXPECT_GT(left_out, 100);
    std::printf("%d of 200 not settled in %d sweeps\n", unfinished, ingot::limits::contact_sweeps_max);
    EXPECT_LE(unfinished, 200 / 20);  // levers at random are harder than those of any shape
}

/// One contact is the impulse of Figure 4, in one sweep and one to see that it was enough.
TEST(ContactRows, of_one_contact_are_figure_4) {
    RandomInput random(305);
    for (int case_i = 0; case_i < 200; ++case_i) {
        Rows rows(2);
        put(rows, 0, random);
        put(rows, 1, random);
        const Eigen::Vector3d n = random.direction(), r_A = random.vector(1), r_B = random.vector(1);
        rows.touch(0, 1, n, r_A, r_B, random.real(0, 1));
        rows.prepare();
        ImpulseBody<Real> A{rows.inv_M(0), rows.inv_I(0), rows.v(0), rows.inv_I(0) * rows.L(0), to_eigen<Real>(to_vector(r_A))};
        ImpulseBody<Real> B{rows.inv_M(1), rows.inv_I(1), rows.v(1), rows.inv_I(1) * rows.L(1), to_eigen<Real>(to_vector(r_B))};
        const Contact& c = rows.contacts[0];
        const Real j = figure4_impulse<Real>(A, B, to_eigen<Real>(c.n), static_cast<Real>(c.e));
        const ingot::NormalSpeed before = ingot::normal_speed(c, rows.tiles.view());
        ingot::StepReport report{};
        rows.solve_impacts(0, report);
        const double rounding = 64 * eps * static_cast<double>(before.magnitude * c.inv_K);
        EXPECT_NEAR(static_cast<double>(rows.contacts[0].j_total), static_cast<double>(j), rounding) << case_i;
        EXPECT_EQ(report.impact_waves, j > 0 ? 1u : 0u);
        EXPECT_EQ(report.impacts_deferred, 0u);
        EXPECT_EQ(report.sweeps_unfinished, 0u);
        if (j > 0) {
            EXPECT_EQ(report.sweeps, 2u);
        }
    }
}

/// Of a pair that lands on several points either all bounce or none: at the speed of the fastest, and above rest_speed only.
TEST(ContactRows, of_a_pair_bounce_together_or_not_at_all) {
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    for (const double rest_speed : {1.0, 3.0}) {
        Rows rows(2);
        rows.tiles.write(0, definition(2, Eigen::Vector3d(0.5, 0.5, 0.5)));
        ingot::BodyDef ground{};
        ground.immovable = true;
        rows.tiles.write(1, ground);
        // One corner comes down at 2 m/s + 0.25 m 2 rad/s, the other at half a metre per second less.
        rows.tiles.translation(0).v_CM[2][0] = -2;
        rows.tiles.rotation(0).L[1][0] = scalar(0.5);  // omega = 1 rad/s
        rows.touch(0, 1, up, {0.25, 0, -0.5}, {0, 0, 0}, 0.5);
        rows.touch(0, 1, up, {-0.25, 0, -0.5}, {0, 0, 0}, 0.5);
        rows.prepare();
        const double u_0 = static_cast<double>(rows.speed(rows.contacts[0])), u_1 = static_cast<double>(rows.speed(rows.contacts[1]));
        ASSERT_NEAR(u_0, -2.25, 1e-6);
        ASSERT_NEAR(u_1, -1.75, 1e-6);
        ingot::StepReport report{};
        rows.solve_impacts(static_cast<scalar>(rest_speed), report);
        const double e = rest_speed < 2.25 ? 0.5 : 0;
        EXPECT_NEAR(static_cast<double>(rows.speed(rows.contacts[0])), -e * u_0, 64 * eps * 4);
        EXPECT_NEAR(static_cast<double>(rows.speed(rows.contacts[1])), -e * u_1, 64 * eps * 4);
        EXPECT_EQ(report.impact_waves, 1u);
    }
}

/// Newton's cradle: waves go on until nothing approaches, each counted.
TEST(ContactRows, pass_impacts_on_wave_by_wave) {
    constexpr int balls = 6;
    Rows rows(balls);
    for (int slot = 0; slot < balls; ++slot) rows.tiles.write(slot, definition(1, Eigen::Vector3d::Ones()));
    rows.tiles.translation(0).v_CM[0][0] = 1;
    for (int slot = 0; slot + 1 < balls; ++slot)
        rows.touch(slot, slot + 1, -Eigen::Vector3d::UnitX(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 1);
    rows.prepare();
    ingot::StepReport report{};
    rows.solve_impacts(0, report);
    for (int slot = 0; slot < balls; ++slot) EXPECT_EQ(rows.v(slot).x(), slot == balls - 1 ? 1 : 0);
    EXPECT_EQ(report.impact_waves, static_cast<std::uint32_t>(balls - 1));
    EXPECT_EQ(report.sweeps, 2u * (balls - 1));
    EXPECT_EQ(report.impacts_deferred, 0u);
    for (const Contact& c : rows.contacts) EXPECT_EQ(c.j_total, 1);
}

/// A ball that touches two walls goes to and fro without end; in the second half of the waves it bounces no more, and that is told.
TEST(ContactRows, bounce_to_and_fro_for_half_of_the_waves) {
    Rows rows(3);
    ingot::BodyDef wall{};
    wall.immovable = true;
    rows.tiles.write(0, definition(1, Eigen::Vector3d::Ones()));
    for (const int slot : {1, 2}) rows.tiles.write(slot, wall);
    rows.tiles.translation(0).v_CM[0][0] = 1;
    for (const int slot : {1, 2})
        rows.touch(0, slot, Eigen::Vector3d::UnitX() * (slot == 1 ? 1 : -1), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 1);
    rows.prepare();
    ingot::StepReport report{};
    rows.solve_impacts(0, report);
    // Waves 0 .. half are begun with a bounce each; the next one stops it.
    EXPECT_EQ(report.impact_waves, ingot::limits::impact_waves_max / 2 + 2u);
    EXPECT_EQ(report.impacts_deferred, 1u);
    EXPECT_EQ(rows.v(0).x(), 0);
    // It came to each wall every other wave and gave 2 N s, but the last.
    EXPECT_EQ(rows.contacts[0].j_total + rows.contacts[1].j_total, 2 * (ingot::limits::impact_waves_max / 2 + 1) + 1);
}

/// Corners of one body, of inertia about its axes far apart, land together: some press others into the ground, and those press back. Waves
/// that bounce may not end that; the first that has them all does. Boxes with their mass in the middle took all waves there are before.
TEST(ContactRows, are_at_rest_after_one_wave_that_has_them_all) {
    RandomInput random(309);
    int most = 0, unfinished = 0;
    for (int case_i = 0; case_i < 300; ++case_i) {
        Rows rows(2);
        ingot::BodyDef ground{};
        ground.immovable = true;
        const Eigen::Vector3d moments = random.moments(1) * std::pow(10, random.real(-4, 0));
        ingot::BodyDef body = definition(1, moments);
        body.state = {{}, to_vector(random.vector(1)), to_matrix(random.rotation()), to_vector(moments.asDiagonal() * random.vector(1))};
        rows.tiles.write(0, body);
        rows.tiles.write(1, ground);
        const Eigen::Vector3d n = random.direction(), half = random.vector(0.5).cwiseAbs() + Eigen::Vector3d::Constant(0.1);
        const Eigen::Matrix3d A = to_eigen<double>(body.state.A);
        const double e = random.real(0, 1);
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3d signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            rows.touch(0, 1, n, A * half.cwiseProduct(signs), Eigen::Vector3d::Zero(), e);
        }
        rows.prepare();
        ingot::StepReport report{};
        rows.solve_impacts(0, report);
        most = std::max(most, static_cast<int>(report.impact_waves));
        unfinished += report.sweeps_unfinished > 0 ? 1 : 0;
        if (report.sweeps_unfinished > 0) continue;
        // Waves 0 .. half are begun with a bounce each; the next one has all, and one more what the roundings of eight corners add up to.
        EXPECT_LE(report.impact_waves, ingot::limits::impact_waves_max / 2 + 3u) << case_i;
        for (const Contact& c : rows.contacts)
            EXPECT_GE(static_cast<double>(rows.speed(c)), -static_cast<double>(ingot::limits::contact_slack * c.tolerance)) << case_i;
    }
    std::printf("at most %d waves, %d of 300 not settled\n", most, unfinished);
}

/// The forces of a step are the impulses of its rows over its length, at the points of contact.
TEST(ContactForces, are_impulses_over_the_step_and_leave_loose_contacts_alone) {
    constexpr scalar h = scalar(1) / 64;
    RandomInput random(306);
    int given = 0, loose = 0;
    for (int case_i = 0; case_i < 100; ++case_i) {
        constexpr int bodies = 4;
        Rows rows = chain_of(random, bodies);
        for (Contact& c : rows.contacts) c.j_total = 1;
        std::vector<V> F(bodies), tau(bodies);
        for (int slot = 0; slot < bodies; ++slot) {
            const ingot::Vector push = to_vector(random.vector(2));
            ingot::set_lane(rows.tiles.translation(slot).F_T, slot % ingot::lanes, push);
            ingot::set_lane(rows.tiles.rotation(slot).tau_T, slot % ingot::lanes, push);
            F[static_cast<std::size_t>(slot)] = tau[static_cast<std::size_t>(slot)] = to_eigen<Real>(push);
        }
        ingot::StepReport report{};
        ingot::solve_contact_forces(rows.view(), rows.tiles.view(), h, any_visits, report);
        EXPECT_GE(report.sweeps, 1u);
        EXPECT_EQ(report.sweeps_unfinished, 0u);
        double size = 4;
        for (const Contact& c : rows.contacts) {
            EXPECT_TRUE(c.active);
            EXPECT_EQ(c.target, 0);
            EXPECT_EQ(c.j_total, 1 + c.j);
            ++(c.j > 0 ? given : loose);
            const Real force = static_cast<Real>(c.j) / static_cast<Real>(h);
            F[c.body_A] += to_eigen<Real>(c.n) * force, F[c.body_B] -= to_eigen<Real>(c.n) * force;
            tau[c.body_A] += to_eigen<Real>(c.lever_A) * force, tau[c.body_B] -= to_eigen<Real>(c.lever_B) * force;
            size += static_cast<double>(force);
            const double over = static_cast<double>(rows.speed(c));
            EXPECT_GE(over, -allowed(c));
        }
        for (int slot = 0; slot < bodies; ++slot) {
            const auto i = static_cast<std::size_t>(slot);
            const int lane_i = slot % ingot::lanes;
            EXPECT_LE(static_cast<double>((to_eigen<Real>(ingot::lane_of(rows.tiles.translation(slot).F_T, lane_i)) - F[i]).norm()), 32 * eps * size);
            EXPECT_LE(static_cast<double>((to_eigen<Real>(ingot::lane_of(rows.tiles.rotation(slot).tau_T, lane_i)) - tau[i]).norm()),
                      32 * eps * 2 * size);
        }
    }
    EXPECT_GT(given, 50);
    EXPECT_GT(loose, 50);
}

}  // namespace
