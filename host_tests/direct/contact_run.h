// SPDX-License-Identifier: MIT
// A contact scene run with a solver of choice, and how far its bodies have strayed.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <vector>

#include "scenes/contact/all_contact_scenes.h"

namespace direct_test {

using ingot::scalar;
using ingot::Vector;

/// A world for any contact scene.
template <class Contact, class Solver>
struct Setup : ingot::Scene {
    static constexpr int max_bodies = Contact::body_count;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4 * Contact::body_count;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using solver = Solver;
};

/// What a run has seen, over all of its steps.
struct Totals {
    double sink = 0;     ///< m; most that the last body has come down from where it began
    double drift = 0;    ///< m; most that a body has moved sideways
    double overlap = 0;  ///< m; most that one body of a column has sunk into the one below it
    double us = 0;       ///< microseconds a step, on average
    int solves = 0, refused = 0, unfinished = 0, sweeps = 0;
};

template <class Contact, class Solver>
struct ContactRun {
    using World = ingot::World<Setup<Contact, Solver>>;
    World* world = new World();
    std::vector<ingot::BodyId> ids;
    std::vector<Vector> begin;
    Totals totals;

    ContactRun() {
        EXPECT_EQ(world->set_gravity(Contact::gravity), ingot::Status::ok);
        for (int body_i = 0; body_i < Contact::body_count; ++body_i) {
            scenes::PlacedBody placed = Contact::body(body_i);
            placed.def.friction = placed.mu;
            const auto id = world->add(placed.def);
            EXPECT_TRUE(id.ok());
            ids.push_back(id.value);
            begin.push_back(placed.def.state.r_CM);
        }
    }
    ~ContactRun() { delete world; }
    ContactRun(const ContactRun&) = delete;
    ContactRun& operator=(const ContactRun&) = delete;

    Vector place(std::size_t body_i) const { return world->state(ids[body_i]).value.r_CM; }

    void step(int count, scalar h = Contact::h) {
        for (int step_i = 0; step_i < count; ++step_i) {
            const auto start = std::chrono::steady_clock::now();
            const ingot::StepReport report = ingot::step(*world, h);
            totals.us += std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count() / count;
            ASSERT_EQ(report.bodies_frozen, 0);
            totals.solves += report.direct_solves;
            totals.refused += report.direct_refused;
            totals.unfinished += report.direct_unfinished;
            totals.sweeps += report.sweeps;
            look();
        }
    }

    void look() {
        const std::size_t last = ids.size() - 1;
        totals.sink = std::fmax(totals.sink, static_cast<double>(begin[last].z - place(last).z));
        for (std::size_t i = 1; i <= last; ++i) {
            const Vector r = place(i), below = i == 1 ? Vector{0, 0, -scalar(0.5)} : place(i - 1);
            totals.drift = std::fmax(totals.drift,
                                     std::hypot(static_cast<double>(r.x - begin[i].x), static_cast<double>(r.y - begin[i].y)));
            totals.overlap = std::fmax(totals.overlap, 1 - static_cast<double>(r.z - below.z));
        }
    }
};

}  // namespace direct_test
