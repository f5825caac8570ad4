// SPDX-License-Identifier: MIT
#include "contact_exact.h"

#include <ingot/ingot.h>
#define scenes scenes_of_exact_steps  // see contact_cases.cpp

#include "contact_case.h"
#include "scenes/contact/all_contact_scenes.h"
#include "scenes/contact/exact_problem.h"

namespace report {

namespace {

template <class Placed>
ExactStep solved() {
    using namespace ingot_reference;
    const ContactProblem problem = scenes::exact_problem_of<Placed>(1e-9);
    ContactSolution rest;
    for (const ContactBody& body : problem.bodies) {
        rest.v_CM.push_back(Vector3d::Zero());
        rest.omega.push_back(Vector3d::Zero());
        (void)body;
    }
    const double from = thread_us();
    const ContactSolution exact = solve_contacts(problem);
    const double us = thread_us() - from;
    return {exact.converged, velocity_distance(problem, exact, rest), us};
}

}  // namespace

ExactStep exact_first_step(const std::string& scene) {
    if (scene == "pyramid_210") return solved<scenes::Pyramid<20>>();
    if (scene == "tower_20") return solved<scenes::Tower<20>>();
    if (scene == "mass_ratio_1000") return solved<scenes::MassRatio<1, 1000>>();
    if (scene == "mass_ratio_1e6") return solved<scenes::MassRatio<1, 1000000>>();
    if (scene == "incline_mu07") return solved<scenes::Incline<70>>();
    return {};
}

}  // namespace report
