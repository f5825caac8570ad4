// SPDX-License-Identifier: MIT
// A free body flown by a method of one's choice, through a world.
#pragma once

#include <ingot/ingot.h>

#include <cmath>
#include <string>

#include "reference/free_body_table.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"

namespace hard_cases {

using namespace ingot_reference;
using ingot::scalar;
using Column = FreeBodyCase::Vector3;
using Square = FreeBodyCase::Matrix3;

constexpr bool is_double = sizeof(scalar) == 8;
constexpr double eps = static_cast<double>(ingot::epsilon);

/// What a case asks in double and in float.
constexpr double bound(double in_double, double in_float) { return is_double ? in_double : in_float; }

template <class Rotation>
struct Alone : ingot::Scene {
    using rotation = Rotation;
};

/// One body in a world, and what it began with.
template <class Rotation = ingot::MoserVeselov>
class Flight {
public:
    Flight(const Column& I, const Square& A, const Column& L) : I_(I) {
        ingot::BodyDef def = definition(1, I);
        def.state.A = to_matrix(A);
        def.state.L = to_vector(L);
        const ingot::Result<ingot::BodyId> id = world_.add(def);
        status_ = id.status;
        id_ = id.value;
        if (id.ok()) begin_ = world_.state(id_).value;
    }
    explicit Flight(const FreeBodyCase& body) : Flight(body.I, body.A_0, body.L) {}

    ingot::Status status() const { return status_; }

    void fly(long steps, scalar h) {
        for (long step_i = 0; step_i < steps; ++step_i) clean_ = ingot::step(world_, h).clean() && clean_;
    }

    ingot::World<Alone<Rotation>>& world() { return world_; }
    ingot::BodyId id() const { return id_; }
    ingot::BodyState state() const { return world_.state(id_).value; }
    Square A() const { return to_eigen<long double>(state().A); }
    bool clean() const { return clean_; }
    bool keeps_L() const { return to_eigen(state().L) == to_eigen(begin_.L); }
    double orthogonality() const { return orthogonality_defect(A()); }
    bool is_rotation() const { return orthogonality() <= 8 * eps && A().determinant() > 0; }
    double energy_error() const { return static_cast<double>(std::abs(energy_of(state()) / energy_of(begin_) - 1)); }
    double turned_from(const Square& A_other) const { return attitude_error(A(), A_other); }
    const ingot::BodyState& begin() const { return begin_; }

private:
    long double energy_of(const ingot::BodyState& s) const {
        const Column y = to_eigen<long double>(s.A).transpose() * to_eigen<long double>(s.L);
        return y.dot(y.cwiseQuotient(I_));
    }

    Column I_;
    ingot::World<Alone<Rotation>> world_{};
    ingot::BodyId id_;
    ingot::BodyState begin_;
    ingot::Status status_;
    bool clean_ = true;
};

/// Worst over the samples that fall on steps.
struct TableErrors {
    double attitude = 0, energy = 0, orthogonality = 0;
    bool keeps_L = true, clean = true;
};

template <class Rotation = ingot::MoserVeselov>
TableErrors against_table(const std::string& table, const std::string& name, int rate) {
    const FreeBodyCase body(table, name);
    Flight<Rotation> flight(body);
    TableErrors worst;
    long steps = 0;
    for (const FreeBodyCase::Sample& sample : body.samples) {
        const long double due = sample.t * rate;
        if (due != std::floor(due)) continue;
        flight.fly(static_cast<long>(due) - steps, scalar(1) / static_cast<scalar>(rate));
        steps = static_cast<long>(due);
        worst.attitude = std::max(worst.attitude, flight.turned_from(sample.A));
        worst.energy = std::max(worst.energy, flight.energy_error());
        worst.orthogonality = std::max(worst.orthogonality, flight.orthogonality());
    }
    worst.keeps_L = flight.keeps_L();
    worst.clean = flight.clean();
    std::printf("    %-15s %4d Hz %-13s attitude %.1e rad, energy %.1e, orthogonality %.1e\n", name.c_str(), rate, Rotation::name, worst.attitude,
                worst.energy, worst.orthogonality);
    return worst;
}

}  // namespace hard_cases
