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
        const double R[2] = {random.real(0.05, 0.3), random.real(0.05, 0.3)}, least = std::min(R[0], R[1]), e = case_i % 3 == 0 ? 0 : random.real(0, 1);
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
        EXPECT_LE(parting, closing * std::max(e, 0.0) + 1e-3 * closing + roundings * rate) << case_i;
        EXPECT_LE(((now[0] * M[0] + now[1] * M[1]) / all - together).norm(), 64 * eps * together.norm()) << case_i;
        const Vector3d centre = (r[0] * M[0] + r[1] * M[1]) / all + together * (8 * h);
        EXPECT_LE(((at[0] * M[0] + at[1] * M[1]) / all - centre).norm(), roundings) << case_i;
        std::printf("%d e %.2f closing/step %.4f radii begins %.2f: parting/closing %.4f gap/least %.5f aside %.2e\n", case_i, e, closing * h / least, begins / (closing * h), parting / closing, ((at[1] - at[0]).norm() - R[0] - R[1]) / least,
                    (now[1] - now[0] - n * parting).norm() / closing);
        ++met;
    }
}

}  // namespace
