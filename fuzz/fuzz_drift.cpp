// SPDX-License-Identifier: MIT
// Free bodies of any moments, spins, orientations and steps for up to thousands of steps, and what they may lose meanwhile.
//
//   L and v_CM are kept bitwise: nothing acts. r_CM is the sum of v_CM h, to half an epsilon of the way a step.
//   A is a rotation to what its method promises.
//   Energy: E = (A^T L) . I^-1 (A^T L) / 2 changes by L . omega d where an orientation is off by a turn d across L; relative to E by at most
//     2 d |L| |omega| / (L . omega), and by Kantorovich's inequality |L| |omega| / (L . omega) <= (k + 1) / (2 sqrt k) with k the ratio of moments.
//     The default method takes back what it has lost: d stays within the bound of host_tests/drift, for k = 8 there. Methods that are exact but for
//     rounding add up to 24 epsilon of A a substep (see defect_max in machine.h).
//
// INGOT_FUZZ_RUN names the function; fuzz_fault breaks a promise on purpose.
#include "fuzz_world.h"
#include "machine.h"

namespace {

using namespace fuzz;

struct Flight : ingot::Scene {
    static constexpr int max_bodies = 3;
    static constexpr bool translates = true;
};
template <class Method>
struct FlightBy : Flight {
    using rotation = Method;
};

constexpr double eps = static_cast<double>(ingot::epsilon);

double dot(const Vector& a, const Vector& b) {
    return static_cast<double>(a.x) * static_cast<double>(b.x) + static_cast<double>(a.y) * static_cast<double>(b.y) +
           static_cast<double>(a.z) * static_cast<double>(b.z);
}
double energy_of(const BodyState& s, const Vector& I) {
    const double x = dot(s.A.c0, s.L), y = dot(s.A.c1, s.L), z = dot(s.A.c2, s.L);
    return (x * x / static_cast<double>(I.x) + y * y / static_cast<double>(I.y) + z * z / static_cast<double>(I.z)) / 2;
}

/// What a method loses of energy, as the angle d above.
enum class Energy { returned, rounded, none };

/// 2^x for x = -range .. range, in 256 steps.
scalar spread(Bytes& in, double range) {
    const double x = (static_cast<double>(in.byte()) / 127.5 - 1) * range;
    double value = 1;
    const int whole = static_cast<int>(x);
    for (int i = 0; i < whole; ++i) value *= 2;
    for (int i = 0; i > whole; --i) value /= 2;
    return static_cast<scalar>(value * (1 + (x - whole) * 0.7));
}

template <class S>
class Drift {
public:
    Drift() { memset(static_cast<void*>(&world_), 0, sizeof world_); }

    uint64_t run(Bytes in, Energy kept) {
        const scalar h = (in.byte() & 1u) != 0 ? scalar(1) / 60 : scalar(0.02) * spread(in, 4);
        const int count = 1 + in.byte() % 3, steps = 16 << (in.byte() % 8);
        for (int body_i = 0; body_i < count; ++body_i) add(in, h);
        for (int step_i = 1; step_i <= steps; ++step_i) {
            const StepReport report = INGOT_FUZZ_STEP(world_, h);
            demand(report.clean(), "a free flight has nothing to tell");
            for (Body& body : bodies_) demand_kept(body, step_i, h, kept);
        }
        return seen_;
    }

private:
    struct Body {
        BodyId id;
        BodyState begin;
        Vector I;
        double E, spread_of_moments, substeps;
    };

    void add(Bytes& in, scalar h) {
        // Moments of a box, so that they are those of a solid.
        const scalar a = spread(in, 3), b = spread(in, 3), c = spread(in, 3);
        const Vector I = {b * b + c * c, c * c + a * a, a * a + b * b};
        const scalar least = I.x < I.y ? (I.x < I.z ? I.x : I.z) : (I.y < I.z ? I.y : I.z),
                     most = I.x > I.y ? (I.x > I.z ? I.x : I.z) : (I.y > I.z ? I.y : I.z);
        BodyDef def;
        def.mass.M = 1;
        def.mass.I_body = I;
        def.mass.A_principal = ingot::identity_matrix<scalar>();
        def.state.A = ingot::nearest_rotation(turned(in));
        def.state.r_CM = number_vector(in, 4);
        def.state.v_CM = number_vector(in, 4);
        Vector n = number_vector(in, 1);
        if (!(ingot::length_sq(n) > scalar(1e-4))) n = {0, 0, 1};
        // |omega| <= |L| / least: no turn of a step beyond the last substep, 8 rad; and now and then about an axis, or nearly.
        if ((in.byte() & 3u) == 0) n = {n.x * scalar(1e-3), n.y * scalar(1e-3), 1};
        const scalar turn = scalar(0.25) * spread(in, 4.5);
        def.state.L = n * (turn * least / (h * ingot::sqrt(ingot::length_sq(n))));
        const Result<BodyId> added = world_.add(def);
        demand(added.ok(), "a sane body is taken");
        Body& body = bodies_[count_++];
        body.id = added.value;
        body.begin = world_.state(added.value).value;
        body.I = I;
        body.E = energy_of(body.begin, I);
        const double k = static_cast<double>(most / least);
        body.spread_of_moments = (k + 1) / (2 * __builtin_sqrt(k));
        body.substeps = 1 + static_cast<double>(turn / limits::angle_per_substep) * 2;
    }

    static Vector number_vector(Bytes& in, scalar size) {
        const auto one = [&] { return size * static_cast<scalar>(in.raw<int16_t>()) / 32768; };
        const scalar x = one(), y = one(), z = one();
        return {x, y, z};
    }
    static Matrix turned(Bytes& in) {
        const Vector n = number_vector(in, 1);
        const scalar angle = 4 * static_cast<scalar>(in.raw<int16_t>()) / 32768, length = ingot::sqrt(ingot::length_sq(n));
        if (!(length > scalar(1e-2))) return ingot::identity_matrix<scalar>();
        const Result<Matrix> A = ingot::rotation_about(n * (1 / length), angle);
        return A.ok() ? A.value : ingot::identity_matrix<scalar>();
    }

    void demand_kept(const Body& body, int step_i, scalar h, Energy kept) {
        if (body.id == BodyId{}) return;
        BodyState s = world_.state(body.id).value;
        if (fuzz_fault == 1 && step_i > 8) s.L.x += 1;
        if (fuzz_fault == 2 && step_i > 8) s.A.c0.x += scalar(0.01);
        see(&s, sizeof s);
        demand(same_bytes(&s.L, &body.begin.L, sizeof s.L), "a free body keeps L");
        demand(same_bytes(&s.v_CM, &body.begin.v_CM, sizeof s.v_CM), "a free body keeps v_CM");
        demand(ingot::orthogonality_error(s.A) <= defect_max<typename S::rotation>, "A stays orthonormal");
        demand(ingot::determinant(s.A) > 0, "A stays a rotation");
        const double t = static_cast<double>(h) * step_i;
        const scalar r[] = {s.r_CM.x, s.r_CM.y, s.r_CM.z}, r_0[] = {body.begin.r_CM.x, body.begin.r_CM.y, body.begin.r_CM.z},
                     v[] = {s.v_CM.x, s.v_CM.y, s.v_CM.z};
        for (int axis = 0; axis < 3; ++axis) {
            const double way = static_cast<double>(v[axis]) * t, begin = static_cast<double>(r_0[axis]);
            const double furthest = __builtin_fabs(begin) + __builtin_fabs(way);
            demand(__builtin_fabs(static_cast<double>(r[axis]) - begin - way) <= eps * furthest * (step_i + 1), "r_CM goes v_CM h a step");
        }
        if (kept == Energy::none) return;
        const double d = kept == Energy::returned ? (sizeof(scalar) == 8 ? 1e-11 : 1e-5) : 24 * eps * body.substeps * step_i;
        double E = energy_of(s, body.I);
        if (fuzz_fault == 3) E *= 1.5;
        demand(__builtin_fabs(E / body.E - 1) <= 2 * d * body.spread_of_moments, "a free body keeps its energy");
    }

    void see(const void* data, size_t size) {
        const unsigned char* bytes = static_cast<const unsigned char*>(data);
        for (size_t byte_i = 0; byte_i < size; ++byte_i) seen_ = (seen_ ^ bytes[byte_i]) * 0x100000001b3u;
    }

    static ingot::World<S> world_;
    Body bodies_[3] = {};
    int count_ = 0;
    uint64_t seen_ = ingot::state_hash_seed;
};
template <class S>
ingot::World<S> Drift<S>::world_;

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    switch (in.byte() % 10u) {
        case 0: case 1: case 2: case 3: return Drift<Flight>().run(in, Energy::returned);
        case 4: return Drift<FlightBy<ingot::DiscreteMoserVeselov<4, false, false>>>().run(in, Energy::rounded);
        case 5: return Drift<FlightBy<ingot::DiscreteMoserVeselov<8, true, false>>>().run(in, Energy::rounded);
        case 6: return Drift<FlightBy<ingot::ExactElliptic>>().run(in, Energy::rounded);
        case 7: return Drift<FlightBy<ingot::SymmetricTopSplitting<6>>>().run(in, Energy::none);
        case 8: return Drift<FlightBy<ingot::LieMidpoint>>().run(in, Energy::none);
        default: return Drift<FlightBy<ingot::Rk4Polar>>().run(in, Energy::none);
    }
}
