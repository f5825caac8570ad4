// SPDX-License-Identifier: MIT
// What flies fast together meets as if it did not fly: who is with whom, not how fast they all go, says what is an impact and what is a contact. And
// who has locked axes has them also where fast bodies meet within a step, whichever of them was added first.
#include "laws/locked_bodies.h"

#include "reference/draws.h"

namespace {

using namespace locked_bodies;
using ingot_reference::draws;

struct Flying : Room<ingot::BlockSweeps, true> {
    static constexpr bool sleeps = false, axis_locks = true;
};

constexpr double rates[] = {30, 60, 120, 240, 1000};

/// Two balls, one behind the other or beside it, that close in at a speed of their own while both go much further in a step than they are large; one
/// pushes, or hits, a third. In closed form: each goes on with its velocity of before and what impacts have given it.
TEST(FastCompanions, meet_as_if_they_did_not_fly) {
    RandomInput random(1);
    int met = 0;
    for (int case_i = 0; case_i < draws(400); ++case_i) {
        const double rate = rates[random.integer(0, 4)], h = static_cast<double>(static_cast<scalar>(1 / rate));
        const double R[2] = {random.real(0.05, 0.3), random.real(0.05, 0.3)}, least = std::min(R[0], R[1]);
        const double e = case_i % 3 == 0 ? 0 : random.real(0, 1);
        const Vector3d n = random.direction();
        // Both go some 2 to 10 radii in a step; what they close in by is from a thousandth of one to two.
        const double closing = least * rate * std::exp(random.real(std::log(1e-3), std::log(2.0)));
        const Vector3d together = random.direction() * (least * rate * random.real(2, 10));
        Thrown<Flying> thrown(0, {e, 0});
        const double begins = random.real(0.2, 3) * closing * h;
        const Vector3d place = random.vector(0.5), r[2] = {place, place + n * (R[0] + R[1] + begins)};
        const double M[2] = {4000 * R[0] * R[0] * R[0], 4000 * R[1] * R[1] * R[1]}, all = M[0] + M[1];
        const Vector3d v[2] = {together + n * (closing * M[1] / all), together - n * (closing * M[0] / all)};
        const int first = random.integer(0, 1);
        for (const int i : {first, 1 - first})
            thrown.body_at(ingot::Sphere{static_cast<scalar>(R[i])}, r[i], v[i], Vector3d::Zero(), Matrix3d::Identity());
        for (int step_i = 0; step_i < 8; ++step_i) ASSERT_TRUE(ingot::step(*thrown.world, static_cast<scalar>(1 / rate)).clean()) << case_i;
        Vector3d now[2], at[2];
        for (const int i : {0, 1}) {
            const BodyState state = thrown.world->state(thrown.world->body_at(i == first ? 0 : 1)).value;
            now[i] = to_eigen(state.v_CM);
            at[i] = to_eigen(state.r_CM);
        }
        const double eps = static_cast<double>(ingot::epsilon), size = together.norm() * 8 * h + 1, roundings = 64 * eps * size;
        const double direction = roundings / (R[0] + R[1]);
        // What touches slower than that does not bounce: see limits.
        const double parting = (now[1] - now[0]).dot(n);
        EXPECT_GE(parting, -(direction + 64 * eps) * (closing + together.norm()) - roundings * rate) << case_i;
        if (8 * h > begins / closing) {
            EXPECT_LE(parting, closing * e + 1e-3 * closing + roundings * rate) << case_i;
        }
        EXPECT_LE(((now[0] * M[0] + now[1] * M[1]) / all - together).norm(), 64 * eps * together.norm()) << case_i;
        const Vector3d centre = (r[0] * M[0] + r[1] * M[1]) / all + together * (8 * h);
        EXPECT_LE(((at[0] * M[0] + at[1] * M[1]) / all - centre).norm(), roundings) << case_i;
        // Where they are is where the impact has left them, a skin or what contacts leave apart at the most.
        const double skin = static_cast<double>(ingot::limits::skin_share) * least, away = 8 * h - begins / closing;
        const double apart = (at[1] - at[0]).norm() - R[0] - R[1], due = away > 0 ? std::max(parting, 0.0) * away : begins - closing * 8 * h;
        EXPECT_NEAR(apart, due, skin + parting * h + 2 * roundings) << case_i;
        met += away > 0 ? 1 : 0;
    }
    EXPECT_GT(met, draws(400) / 2);
}

/// Two fast balls of which some axes are locked meet within a step, without friction. Locked coordinates keep their bits; the impulse is that of the
/// axes that are left, whichever of the two was added first, also where that was the first of all bodies.
TEST(FastLocked, meet_with_the_impulse_of_their_free_axes) {
    RandomInput random(2);
    int met = 0;
    for (int case_i = 0; case_i < draws(600); ++case_i) {
        const double rate = rates[random.integer(0, 4)], h = static_cast<double>(static_cast<scalar>(1 / rate)), e = random.real(0, 1);
        const double R[2] = {random.real(0.05, 0.3), random.real(0.05, 0.3)}, M[2] = {4000 * R[0] * R[0] * R[0], 4000 * R[1] * R[1] * R[1]};
        const unsigned locks[2] = {static_cast<unsigned>(random.integer(0, 63)), case_i % 3 == 0 ? static_cast<unsigned>(random.integer(0, 63)) : 0};
        const Vector3d n = random.direction();
        // 2 to 10 radii a step, each of them, in its free directions; they meet somewhere in the second step.
        const auto free_axes = [&](int i) {
            Vector3d axes = Vector3d::Ones();
            for (int axis = 0; axis < 3; ++axis)
                if (is_locked(locks[i], axis)) axes[axis] = 0;
            return axes;
        };
        Vector3d v[2];
        for (const int i : {0, 1}) {
            v[i] = random.direction() * (R[i] * rate * random.real(2, 10));
            v[i] = (v[i] + n * ((i == 0 ? 1 : -1) * R[i] * rate * 4)).cwiseProduct(free_axes(i));
        }
        const double closing = (v[0] - v[1]).dot(n), K = n.dot(free_axes(0).cwiseProduct(n)) / M[0] + n.dot(free_axes(1).cwiseProduct(n)) / M[1];
        if (closing < 0.5 * (v[0] - v[1]).norm() || closing < 2 * std::min(R[0], R[1]) * rate || K * M[0] < 0.1) continue;
        const double t = h * random.real(1.1, 1.9);
        const Vector3d P = random.vector(0.5), r[2] = {P - n * R[0] - v[0] * t, P + n * R[1] - v[1] * t};
        Thrown<Flying> thrown(0, {e, 0});
        const int first = random.integer(0, 1);
        for (const int i : {first, 1 - first}) {
            thrown.body_at(ingot::Sphere{static_cast<scalar>(R[i])}, r[i], v[i], Vector3d::Zero(), Matrix3d::Identity());
            ASSERT_EQ(thrown.world->set_locks(thrown.world->body_at(i == first ? 0 : 1), locks[i]), Status::ok);
        }
        const auto id_of = [&](int i) { return thrown.world->body_at(i == first ? 0 : 1); };
        const BodyState begin[2] = {thrown.world->state(id_of(0)).value, thrown.world->state(id_of(1)).value};
        for (int step_i = 0; step_i < 3; ++step_i) {
            ASSERT_TRUE(ingot::step(*thrown.world, static_cast<scalar>(h)).clean()) << case_i;
            for (const int i : {0, 1}) ASSERT_TRUE(is_held(*thrown.world, id_of(i), begin[i])) << case_i << ", step " << step_i;
        }
        // Where they meet is known to roundings and to the gap in which they have met: so is n, over their radii.
        const double eps = static_cast<double>(ingot::epsilon), size = 4 + (v[0].norm() + v[1].norm()) * 3 * h;
        const double least = std::min(R[0], R[1]), gap = std::min(static_cast<double>(ingot::limits::impact_gap) * least, 1.0);
        const double off = 4 * (32 * eps * size + gap) / (R[0] + R[1]) + 64 * eps, j = (1 + e) * closing / K;
        for (const int i : {0, 1}) {
            const Vector3d due = v[i] - free_axes(i).cwiseProduct(n) * ((i == 0 ? 1 : -1) * j / M[i]);
            const Vector3d is = to_eigen(thrown.world->state(id_of(i)).value.v_CM);
            EXPECT_LE((is - due).norm(), off * 4 * (j / M[i] + v[0].norm() + v[1].norm())) << case_i << ", locks " << locks[0] << ' ' << locks[1];
        }
        ++met;
    }
    EXPECT_GT(met, draws(600) / 6);
}

}  // namespace
