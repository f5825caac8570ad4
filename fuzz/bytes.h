// SPDX-License-Identifier: MIT
// Bytes of the fuzzer as numbers, vectors, orientations and shapes: mostly sane, at times at an edge, at times any bit pattern there
// is, so that a run gets through the door and still tries every lock.
#pragma once

#include <ingot/ingot.h>
#include <string.h>

#include "fuzz_world.h"

namespace fuzz { inline namespace INGOT_ABI {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::BodyState;
using ingot::Matrix;
using ingot::Result;
using ingot::scalar;
using ingot::Shape;
using ingot::ShapeKind;
using ingot::Status;
using ingot::StepReport;
using ingot::Vector;
using ingot::World;
namespace limits = ingot::limits;

inline void demand(bool promise, const char* text) {
    if (!promise) broken_promise(text);
}

inline bool same_bytes(const void* a, const void* b, size_t size) { return memcmp(a, b, size) == 0; }

inline scalar magnitude(scalar x) { return x < 0 ? -x : x; }

/// Reads the input; past its end everything is zero.
class Bytes {
public:
    Bytes(const uint8_t* data, size_t size) : next_(data), left_(size) {}

    bool empty() const { return left_ == 0; }

    uint8_t byte() {
        if (left_ == 0) return 0;
        --left_;
        return *next_++;
    }

    template <class T>
    T raw() {
        uint8_t bytes[sizeof(T)];
        for (uint8_t& b : bytes) b = byte();
        T value;
        memcpy(&value, bytes, sizeof value);
        return value;
    }

    /// Mostly within -size .. size.
    scalar number(scalar size) {
        static constexpr scalar huge = sizeof(scalar) == 4 ? scalar(__FLT_MAX__) : scalar(__DBL_MAX__);
        static constexpr scalar tiny = sizeof(scalar) == 4 ? scalar(__FLT_DENORM_MIN__) : scalar(__DBL_DENORM_MIN__);
        static const scalar edges[] = {
            0, scalar(-0.0), 1, -1, scalar(__builtin_nan("")), scalar(__builtin_inf()), scalar(-__builtin_inf()),
            huge, -huge, tiny, -tiny, ingot::epsilon, 1 + ingot::epsilon, 1 - ingot::epsilon / 2, scalar(1e-22), scalar(1e-38),
            limits::position_max, -limits::position_max, limits::speed_max, -limits::speed_max, limits::force_max,
            -limits::force_max, limits::mass_min, limits::mass_max, limits::inertia_min, limits::inertia_max, limits::size_min,
            limits::size_max, limits::step_min, limits::step_max, limits::gravity_max, scalar(1) / 60};
        const uint8_t kind = byte();
        if (kind < 200) return size * (static_cast<scalar>(raw<int16_t>()) / 32768);
        if (kind < 232) return edges[kind - 200];
        return raw<scalar>();
    }

    Vector vector(scalar size) {
        if ((byte() & 7u) == 0) return {};
        const scalar x = number(size), y = number(size), z = number(size);
        return {x, y, z};
    }

    Vector direction() {
        static const Vector axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
        const uint8_t kind = byte();
        if (kind < 6) return axes[kind];
        const Vector v = vector(1);
        const scalar length = ingot::sqrt(ingot::length_sq(v));
        return kind < 224 && length > scalar(1e-3) && length < 10 ? v * (1 / length) : v;
    }

    Matrix orientation() {
        const uint8_t kind = byte();
        if (kind < 64) return ingot::identity_matrix<scalar>();
        if (kind < 224) {
            const Result<Matrix> turned = ingot::rotation_about(direction(), number(4));
            Matrix A = turned.ok() ? turned.value : ingot::identity_matrix<scalar>();
            if (kind >= 200) A.c1.x += number(limits::orthogonality);
            if (kind >= 212) A.c2 = A.c2 * number(2);
            return A;
        }
        return {vector(1), vector(1), vector(1)};
    }

    BodyState state(bool translates) {
        BodyState s{};
        if (translates || byte() == 255) {
            s.r_CM = vector(8);
            s.v_CM = vector(8);
        }
        s.A = orientation();
        s.L = vector(4);
        return s;
    }

    ingot::MassProperties mass() {
        ingot::MassProperties m{};
        m.M = magnitude(number(4));
        const scalar a = magnitude(number(1)), b = magnitude(number(1)), c = magnitude(number(1));
        m.I_body = (byte() & 15u) == 0 ? Vector{a, b, c} : Vector{b + c, c + a, a + b};  // the sums are moments of some solid
        return m;
    }

    Shape shape() {
        switch (byte() & 15u) {
            case 0: return {};
            case 1: return {static_cast<ShapeKind>(byte()), vector(2), number(2)};
            case 2: case 3: case 4: return ingot::HalfSpace{direction(), number(2)};
            case 5: case 6: case 7: case 8: case 9: return ingot::Box{{magnitude(number(2)), magnitude(number(2)), magnitude(number(2))}};
            default: return ingot::Sphere{magnitude(number(2))};
        }
    }

    /// Of all kinds that a body can have, about a metre as a rule.
    Shape any_shape() {
        const auto size = [&] { return scalar(0.05) + magnitude(number(1)); };
        switch (byte() & 15u) {
            case 0: return shape();
            case 1: case 2: return ingot::HalfSpace{direction(), number(2)};
            case 3: case 4: return ingot::Capsule{size(), size()};
            case 5: case 6: return ingot::Cylinder{size(), size()};
            case 7: case 8: case 9: case 10: return ingot::Sphere{size()};
            default: return ingot::Box{{size(), size(), size()}};
        }
    }

    scalar step_length() {
        const uint8_t kind = byte();
        return kind < 128 ? scalar(1) / 60 : magnitude(number(1));
    }

private:
    const uint8_t* next_;
    size_t left_;
};

} }  // namespace fuzz
