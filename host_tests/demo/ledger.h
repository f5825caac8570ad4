// SPDX-License-Identifier: MIT
#pragma once

#include <ingot/ingot.h>

#include <algorithm>
#include <cmath>

namespace demo {

/// Books of a world: what its energy and momentum should be, and how far off they are. Kept in double.
template <class S>
class Ledger {
public:
    explicit Ledger(const ingot::World<S>& world) : energy_begin_(energy(world)), energy_last_(energy_begin_) {
        add(expected_, momentum(world));
        for (int axis_i = 0; axis_i < 3; ++axis_i) scale_ += std::abs(expected_[axis_i]);
        for_each_body(world, [&](ingot::BodyId id) { mass_ += mass_of(world, id); });
    }

    /// After each step.
    void book(const ingot::World<S>& world, double h) {
        if constexpr (S::translates) {
            const ingot::Vector g = world.gravity();
            add(expected_, {g.x, g.y, g.z}, mass_ * h);
            if constexpr (ingot::collides<S>) book_walls(world);
        }
        const double energy_now = energy(world);
        largest_gain_ = std::max(largest_gain_, (energy_now - energy_last_) / energy_begin_);
        energy_last_ = energy_now;

        double error = 0;
        const ingot::Vector p = momentum(world);
        const double now[3] = {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
        for (int axis_i = 0; axis_i < 3; ++axis_i) {
            error = std::max(error, std::abs(now[axis_i] - expected_[axis_i]));
            scale_ = std::max(scale_, std::abs(now[axis_i]));
        }
        momentum_error_ = std::max(momentum_error_, error / scale_);
        for_each_body(world, [&](ingot::BodyId id) {
            orthogonality_ = std::max(orthogonality_, static_cast<double>(ingot::orthogonality_error(world.state(id).value.A)));
        });
    }

    double energy_change() const { return energy_last_ / energy_begin_ - 1; }  ///< relative, since the begin
    double largest_gain() const { return largest_gain_; }                      ///< relative, of a single step
    double momentum_error() const { return momentum_error_; }                  ///< relative to the largest momentum met
    double orthogonality() const { return orthogonality_; }                    ///< largest |A^T A - 1|

private:
    template <class Visit>
    static void for_each_body(const ingot::World<S>& world, Visit visit) {
        for (int slot = 0; slot < ingot::World<S>::max_bodies; ++slot)
            if (world.is_alive(world.body_at(slot))) visit(world.body_at(slot));
    }

    /// Linear momentum where bodies translate, else angular.
    static ingot::Vector momentum(const ingot::World<S>& world) {
        if constexpr (S::translates) return world.linear_momentum();
        return world.angular_momentum();
    }

    static double mass_of(const ingot::World<S>& world, ingot::BodyId id) {
        if constexpr (S::translates) return static_cast<double>(world.mass(id).value);
        return 0;
    }

    static double energy(const ingot::World<S>& world) {
        double sum = static_cast<double>(world.kinetic_energy());
        if constexpr (S::translates) {
            const ingot::Vector g = world.gravity();
            for_each_body(world, [&](ingot::BodyId id) {
                const ingot::Vector r = world.state(id).value.r_CM;
                const double g_r[3] = {product(g.x, r.x), product(g.y, r.y), product(g.z, r.z)};
                sum -= mass_of(world, id) * (g_r[0] + g_r[1] + g_r[2]);
            });
        }
        return sum;
    }

    /// What immovable bodies gave to the others.
    void book_walls(const ingot::World<S>& world) {
        for (int contact_i = 0; contact_i < world.contact_count(); ++contact_i) {
            const ingot::ContactInfo contact = world.contact(contact_i).value;
            if (mass_of(world, contact.B) == 0) add(expected_, contact.n, static_cast<double>(contact.j));
        }
    }

    static double product(ingot::scalar a, ingot::scalar b) { return static_cast<double>(a) * static_cast<double>(b); }

    static void add(double (&sum)[3], const ingot::Vector& v, double factor = 1) {
        sum[0] += factor * static_cast<double>(v.x);
        sum[1] += factor * static_cast<double>(v.y);
        sum[2] += factor * static_cast<double>(v.z);
    }

    double energy_begin_, energy_last_, expected_[3] = {}, mass_ = 0, scale_ = 0;
    double largest_gain_ = 0, momentum_error_ = 0, orthogonality_ = 0;
};

}  // namespace demo
