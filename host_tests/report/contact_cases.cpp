// SPDX-License-Identifier: MIT
// The contact scenes in one build of the kernel. Compiled once for each scalar and lane count.
//
// Types of the scenes do not carry the scalar in their names as the kernel's do: each build gets a namespace of its own.
#include <ingot/ingot.h>
#define scenes INGOT_JOIN(scenes_, INGOT_ABI, )

#include "kernel_run.h"
#include "scenes/contact/all_contact_scenes.h"

namespace report {

std::vector<ContactCase> INGOT_JOIN(contact_cases_, INGOT_ABI, )();
std::vector<ContactCase> INGOT_JOIN(simbenchmark_cases_, INGOT_ABI, )();

namespace {

using Boxes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
using Balls = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;

/// The same by sweeps and by the solver that picks itself.
template <class Placed, int manifolds>
ContactCase case_of_both(const char* name) {
    ContactCase one = contact_case<Placed, Boxes, manifolds>(name);
    one.begin_chosen = [] {
        return std::make_unique<KernelRun<Placed, SceneFor<Placed, Boxes, manifolds, true, ingot::HybridIslands<>>>>();
    };
    return one;
}

/// Friction of its pairs, 0.4 and 0.8, as geometric means.
struct RollingByMeans : scenes::SimRolling {
    static constexpr scenes::PlacedBody body(int body_i) {
        scenes::PlacedBody placed = scenes::SimRolling::body(body_i);
        placed.mu = body_i == 0 ? mu_ground_box * mu_ground_box / mu_box_ball : mu_box_ball;
        return placed;
    }
};
ContactCase rolling_case(const char* name, const ingot::Vector& push) {
    using S = SceneFor<RollingByMeans, ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>, 60>;
    ContactCase one = contact_case<RollingByMeans, S::shapes, 60>(name);
    copy(push, one.push);
    one.begin = [push] { return std::make_unique<KernelRun<RollingByMeans, S>>(push); };
    return one;
}

}  // namespace

std::vector<ContactCase> INGOT_JOIN(simbenchmark_cases_, INGOT_ABI, )() {
    using namespace scenes;
    return {
        rolling_case("simbenchmark_rolling_diagonal", SimRolling::push_diagonal),
        rolling_case("simbenchmark_rolling_along_y", SimRolling::push_along_y),
        contact_case<SimBouncing, Balls, 100>("simbenchmark_bouncing"),
        contact_case<Sim666<false>, Balls, 1700>("simbenchmark_666"),
        contact_case<Sim666<true>, Balls, 1700>("simbenchmark_elastic_666"),
    };
}

std::vector<ContactCase> INGOT_JOIN(contact_cases_, INGOT_ABI, )() {
    using namespace scenes;
    return {
        contact_case<Pyramid<10>, Boxes, 150>("pyramid_55"),
        contact_case<Pyramid<20>, Boxes, 600>("pyramid_210"),
        contact_case<Pyramid<30>, Boxes, 1400>("pyramid_465"),
        case_of_both<Tower<20>, 60>("tower_20"),
        contact_case<Tower<20>, Boxes, 60, false>("tower_20_searched"),
        case_of_both<Tower<40>, 120>("tower_40"),
        contact_case<SpherePile<8>, Balls, 2500>("pile_512"),
        contact_case<SpherePile<16>, Balls, 18000>("pile_4096"),
        case_of_both<MassRatio<1, 1000>, 4>("mass_ratio_1000"),
        case_of_both<MassRatio<1, 1000000>, 4>("mass_ratio_1e6"),
        case_of_both<MassRatio<9, 1000>, 20>("mass_ratio_ten"),
        contact_case<Incline<70>, Boxes, 2>("incline_mu07"),
        contact_case<Incline<40>, Boxes, 2>("incline_mu04"),
        contact_case<Bounce<100>, Balls, 2>("bounce_e1"),
        contact_case<Bounce<50>, Balls, 2>("bounce_e05"),
        contact_case<BoxDroppedFlat<50>, Boxes, 2>("box_dropped_flat"),
        contact_case<PitOfBoxes, Boxes, 1500>("pit_125"),
    };
}

}  // namespace report
