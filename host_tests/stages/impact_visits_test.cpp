// SPDX-License-Identifier: MIT
// How much work the impacts of a step may be, whatever its bodies are: so many visits to each contact.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "reference/draws.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_reference;
using ingot::scalar;
namespace limits = ingot::limits;

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 8, max_contacts = 40;
    static constexpr bool translates = true;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
/// Contacts give way to others within the step.
struct Crowd : Yard {
    static constexpr int max_contacts = 6;
};

/// The storage of a world, whose contacts no world shows all of.
template <class S>
struct Crash {
    ingot::Storage<S> storage{};
    ingot::StepReport report{};

    /// Bodies in each other and in floors; most with speeds so near the least number that tolerances vanish, and sweeps do not end.
    explicit Crash(RandomInput& random) {
        const int bodies = random.integer(2, Yard::max_bodies), floors = random.integer(1, 2);
        const double least = std::log2(static_cast<double>(std::numeric_limits<scalar>::denorm_min()));
        const double speed = random.integer(0, 3) == 0 ? 10 : std::exp2(least + random.real(0, 40)), decades = random.integer(0, 2) * 2.0;
        storage.slots_used = bodies;
        if (random.integer(0, 3) == 0) storage.gravity = {0, 0, static_cast<scalar>(-9.8)};
        for (int slot = 0; slot < bodies; ++slot) {
            ingot::BodyDef def;
            def.restitution = static_cast<scalar>(random.integer(0, 2) == 0 ? 1 : random.real(0, 1));
            const double M = std::pow(10, random.real(-decades, decades));
            const Eigen::Vector3d r = random.vector(0.8), v = random.vector(speed), L = random.vector(speed) * M;
            const Eigen::Vector3d half = random.vector(0.4).cwiseAbs();
            const Eigen::Matrix3d A = random.rotation(), tilted = slot == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : A;
            const Eigen::Vector3d moments = random.moments(M * 0.1);
            if (slot < floors) {
                def.immovable = true;
                def.state.A = to_matrix(tilted);
                def.shape = ingot::HalfSpace{{0, 0, 1}, 0};
            } else {
                def.mass = {static_cast<scalar>(M), to_vector(moments), {}, ingot::identity_matrix<scalar>()};
                def.state = {to_vector(r), to_vector(v), to_matrix(A), to_vector(L)};
                if (random.integer(0, 2) == 0)
                    def.shape = ingot::Sphere{static_cast<scalar>(0.1 + half.x())};
                else
                    def.shape = ingot::Box{to_vector(half + Eigen::Vector3d::Constant(0.1))};
            }
            ingot::write_body(storage.bodies(), slot, def);
            storage.surfaces[slot] = {def.shape, ingot::bounding_radius(def.shape), def.restitution, 0};
        }
    }
    void step(scalar h) {
        ingot::Step<S> now{storage, h, storage.bodies(), report};
        ingot::resolve_impacts(now);
        ingot::ImpulsiveMotion::advance(now);
    }
    int most_visits() {
        int most = 0;
        const ingot::ContactView contacts = storage.contact_view();
        for (int i = 0; i < *contacts.count; ++i) most = std::max(most, static_cast<int>(contacts.contacts[i].visits));
        return most;
    }
};

/// What presses takes no more than a solve of impacts, so a step has three times the bound for each contact: see limits::impact_visits_max. Without
/// it they came to 10^8 of a contact, and a step of nine contacts took seconds.
template <class S>
void visits_stay_within_their_bound(unsigned seed) {
    RandomInput random(seed);
    int most = 0, worn = 0;
    for (int case_i = 0; case_i < draws(4000); ++case_i) {
        Crash<S> crash(random);
        crash.step(static_cast<scalar>(std::pow(10, random.real(-3, -1.5))));
        const int visits = crash.most_visits();
        ASSERT_LE(visits, 3 * limits::impact_visits_max) << case_i;
        most = std::max(most, visits);
        if (visits < limits::impact_visits_max) continue;
        ++worn;
        EXPECT_FALSE(crash.report.clean()) << case_i;
    }
    std::printf("    at most %d visits, %d of %d steps came to the bound\n", most, worn, draws(4000));
    EXPECT_GT(worn, 0);
}

/// In the tiles an impulse acts from the begin of the step, so what it does within it is taken back of places: of a body that forces drive out of the
/// range these left it, and it was frozen there.
TEST(ImpactPlaces, are_in_the_range_of_places_whatever_forces_do) {
    RandomInput random(323);
    int bad = 0;
    for (int case_i = 0; case_i < draws(8000); ++case_i) {
        Crash<Yard> crash(random);
        const int slots = crash.storage.slots_used;
        for (int slot = 0; slot < slots; ++slot) {
            if (!ingot::is_dynamic(crash.storage.bodies(), slot)) continue;
            const Eigen::Vector3d F = random.vector(std::pow(10, random.real(0, 15))), tau = random.vector(std::pow(10, random.real(0, 15)));
            ingot::set_lane(crash.storage.translation[slot / ingot::lanes].F_T, slot % ingot::lanes, to_vector(F));
            ingot::set_lane(crash.storage.rotation[slot / ingot::lanes].tau_T, slot % ingot::lanes, to_vector(tau));
        }
        crash.step(static_cast<scalar>(std::pow(10, random.real(-3, 1))));
        for (int slot = 0; slot < slots; ++slot) {
            const Eigen::Vector3d r = to_eigen<double>(ingot::lane_of(crash.storage.translation[slot / ingot::lanes].r_CM, slot % ingot::lanes));
            ASSERT_LE(r.cwiseAbs().maxCoeff(), static_cast<double>(limits::position_max)) << case_i;
        }
        for (const ingot::TranslationTile& tile : crash.storage.translation) bad += tile.bad != 0 ? 1 : 0;
    }
    EXPECT_GT(bad, 0);
}

TEST(ImpactVisits, stay_within_their_bound) { visits_stay_within_their_bound<Yard>(321); }
TEST(ImpactVisits, stay_within_their_bound_where_there_is_no_room) { visits_stay_within_their_bound<Crowd>(322); }

}  // namespace
