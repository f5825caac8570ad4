// SPDX-License-Identifier: MIT
// Plays a scene of scenes/contact in a world with friction, and measures it, in double and apart from the kernel's collision
// code: places, energy, overlap.
#pragma once

#include <ingot/ingot.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <vector>

#include "contact/body_measures.h"
#include "reference/kernel_types.h"
#include "scenes/contact/all_contact_scenes.h"

namespace ingot_contact {

using ingot::BodyId;
using ingot::BodyState;
using ingot::scalar;
using ingot::Status;
using ingot::StepReport;
using ingot::Vector;
using Matrix3d = Eigen::Matrix3d;
using Vector3d = Eigen::Vector3d;
using ingot_reference::to_eigen;
using scenes::PlacedBody;

constexpr bool is_double = sizeof(scalar) == 8;

/// Rooms come in few sizes: each that is stepped takes the compiler as long as a dozen tests.
constexpr int room_size(int bodies) { return bodies <= 8 ? 8 : bodies <= 48 ? 48 : bodies <= 256 ? 256 : bodies <= 1024 ? 1024 : bodies; }

template <int bodies, class BroadPhase, bool renews, int manifolds, int pairs, class Solver>
struct RoomOfSize : ingot::Scene {
    static constexpr int max_bodies = bodies;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = manifolds;
    static constexpr int max_pairs = pairs;
    static constexpr bool recycles_manifolds = renews;
    using broad_phase = BroadPhase;
    using solver = Solver;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};

/// Room for any scene of so many bodies: in a pile of boxes a body has about twelve neighbours, and half of each pair is its own.
template <int bodies, class BroadPhase = ingot::AllPairs, bool renews = true, int manifolds = 8 * room_size(bodies), int pairs = 2 * manifolds,
          class Solver = ingot::BlockSweeps>
using Room = RoomOfSize<room_size(bodies), BroadPhase, renews, manifolds, pairs, Solver>;

/// What step reports add up to.
struct ReportSum {
    int steps = 0, not_ok = 0, frozen = 0, clamped = 0, lost = 0, most_contacts = 0;
    int sweeps = 0;
    int solved_directly = 0, refused_directly = 0, unfinished_directly = 0;  ///< steps in which an island was
    double residual = 0;  ///< m/s, the largest

    void add(const StepReport& report) {
        ++steps;
        not_ok += report.status != Status::ok;
        frozen += report.bodies_frozen;
        clamped += report.spins_clamped;
        lost += report.contacts_lost;
        sweeps += report.sweeps;
        solved_directly += (report.direct & ingot::DirectBits::solved) != 0;
        refused_directly += (report.direct & ingot::DirectBits::refused) != 0;
        unfinished_directly += (report.direct & ingot::DirectBits::unfinished) != 0;
        most_contacts = std::max<int>(most_contacts, report.contacts);
        residual = std::max(residual, static_cast<double>(report.residual));
    }
    bool clean() const { return not_ok == 0 && frozen == 0 && clamped == 0 && lost == 0; }
};

/// A world, the bodies that were put in, and where they stood.
template <class S>
class Play {
public:
    using WorldOfS = ingot::World<S>;

    Play(const std::vector<PlacedBody>& bodies, const Vector& gravity) : placed_(bodies), world_(new WorldOfS{}) {
        sound_ = world_->set_gravity(gravity) == Status::ok;
        for (const PlacedBody& body : bodies) {
            ingot::BodyDef def = body.def;
            def.friction = body.mu;
            const ingot::Result<BodyId> added = world_->add(def);
            sound_ = sound_ && added.ok() && !body.is_hull;
            ids_.push_back(added.value);
        }
    }

    /// All bodies were taken, with their shapes.
    bool sound() const { return sound_; }
    WorldOfS& world() { return *world_; }
    BodyId id(int body_i) const { return ids_[static_cast<std::size_t>(body_i)]; }
    int body_count() const { return static_cast<int>(ids_.size()); }
    const ReportSum& reports() const { return reports_; }
    const PlacedBody& placed(int body_i) const { return placed_[static_cast<std::size_t>(body_i)]; }
    bool moves(int body_i) const { return !placed(body_i).def.immovable; }

    StepReport step(scalar h) {
        const StepReport report = ingot::step(*world_, h);
        reports_.add(report);
        return report;
    }

    /// Steps of h for so many seconds; after_step(step_i), counted from 1, sees the world after each.
    template <class AfterStep>
    void run(scalar h, double seconds, const AfterStep& after_step) {
        const int steps = static_cast<int>(std::lround(seconds / static_cast<double>(h)));
        for (int step_i = 1; step_i <= steps; ++step_i) {
            (void)step(h);
            after_step(step_i);
        }
    }
    void run(scalar h, double seconds) {
        run(h, seconds, [](int) {});
    }

    BodyState state(int body_i) const { return world_->state(id(body_i)).value; }
    Vector3d r(int body_i) const { return to_eigen(state(body_i).r_CM); }
    Vector3d v(int body_i) const { return to_eigen(state(body_i).v_CM); }
    Matrix3d A(int body_i) const { return to_eigen(state(body_i).A); }
    Vector3d omega(int body_i) const { return omega_of(placed_now(body_i)); }
    Vector3d moved(int body_i) const { return r(body_i) - to_eigen(placed(body_i).def.state.r_CM); }

    /// Horizontal way from its place, m.
    double drift(int body_i) const {
        const Vector3d way = moved(body_i);
        return std::hypot(way.x(), way.y());
    }

    double M(int body_i) const { return static_cast<double>(placed(body_i).def.mass.M); }
    double kinetic(int body_i) const { return kinetic_energy_of(placed_now(body_i)); }
    double kinetic() const { return sum([this](int i) { return kinetic(i); }); }
    /// Kinetic, and potential from the origin on.
    double energy() const {
        const Vector3d g = to_eigen(world_->gravity());
        return sum([&](int i) { return moves(i) ? kinetic(i) - M(i) * g.dot(r(i)) : 0; });
    }

    /// Largest horizontal way of a body from its place, m.
    double shift() const {
        return largest([this](int i) { return drift(i); });
    }
    /// Largest way downwards, m.
    double sink() const {
        return largest([this](int i) { return -moved(i).z(); });
    }
    double fastest() const {
        return largest([this](int i) { return v(i).norm(); });
    }
    double fastest_spin() const {
        return largest([this](int i) { return omega(i).norm(); });
    }
    bool finite() const {
        for (int i = 0; i < body_count(); ++i) {
            const BodyState now = state(i);
            if (!is_finite(now.r_CM) || !is_finite(now.v_CM) || !is_finite(now.L) || !is_finite(now.A)) return false;
        }
        return true;
    }

    /// A body as it is now.
    PlacedBody placed_now(int body_i) const {
        PlacedBody now = placed(body_i);
        now.def.state = state(body_i);
        return now;
    }

    /// How deep two bodies are inside each other, m.
    double overlap(int i, int k) const { return overlap_of(placed_now(i), placed_now(k)); }

    /// Overlaps of pairs that overlap, m. Cost: all pairs.
    std::vector<double> overlaps() const {
        std::vector<PlacedBody> bodies;
        for (int i = 0; i < body_count(); ++i) bodies.push_back(placed_now(i));
        return overlaps_of(bodies);
    }
    double deepest_overlap() const {
        double most = 0;
        for (const double deep : overlaps()) most = std::max(most, deep);
        return most;
    }

private:
    template <class Of>
    double sum(const Of& of) const {
        double total = 0;
        for (int i = 0; i < body_count(); ++i) total += of(i);
        return total;
    }
    template <class Of>
    double largest(const Of& of) const {
        double most = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < body_count(); ++i) {
            if (!moves(i)) continue;
            const double one = of(i);
            if (!(one <= most)) most = one;  // a NaN stays
        }
        return most;
    }

    std::vector<PlacedBody> placed_;
    std::vector<BodyId> ids_;
    std::unique_ptr<WorldOfS> world_;
    ReportSum reports_;
    bool sound_ = true;
};

/// Bodies from a function of their number.
template <int body_count, class BodyOf>
std::vector<PlacedBody> bodies_from(const BodyOf& body_of) {
    std::vector<PlacedBody> bodies;
    for (int body_i = 0; body_i < body_count; ++body_i) bodies.push_back(body_of(body_i));
    return bodies;
}

template <class Scene>
std::vector<PlacedBody> bodies_of() {
    return bodies_from<Scene::body_count>(Scene::body);
}

/// A scene that is a type, in room for it.
template <class Scene, class BroadPhase = ingot::AllPairs, bool renews = true>
Play<Room<Scene::body_count, BroadPhase, renews>> play() {
    return {bodies_of<Scene>(), Scene::gravity};
}

/// The same, solved by another than sweeps.
template <class Scene, class Solver>
using RoomSolvedBy = Room<Scene::body_count, ingot::AllPairs, true, 8 * room_size(Scene::body_count), 16 * room_size(Scene::body_count), Solver>;
template <class Scene, class Solver>
Play<RoomSolvedBy<Scene, Solver>> play_by() {
    return {bodies_of<Scene>(), Scene::gravity};
}

/// What a test measured, beside what it asks for.
inline void figure(const char* what, double value) { std::printf("    %-52s %.4g\n", what, value); }

}  // namespace ingot_contact
