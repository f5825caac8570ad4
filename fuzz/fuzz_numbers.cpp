// SPDX-License-Identifier: MIT
// Every door with raw bits: NaN, infinities, denormals, -0, and what lies an ulp on either side of a limit. One call an input, so that
// there are many.
//
//   A refused call leaves the world bitwise unchanged, and so does one that only asks.
//   Where the header states a range, the call is taken within it and refused beyond: the oracle says which, from the bits and in double.
//   What was taken is a state that steps to finite numbers, orthonormal, within limits::position_max.
//   What is worked out from numbers (solids, principal axes, rotations) is sound or refused.
//
// INGOT_FUZZ_RUN names the function; fuzz_fault breaks a promise on purpose (CMakeLists.txt).
#include "bytes.h"
#include "fuzz_world.h"

namespace {

using namespace fuzz;

/// A moving box, the ground, and a place for one more.
struct Stage : ingot::Scene {
    static constexpr int max_bodies = 3;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 3;
    static constexpr bool filters = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};

// What the oracle knows of numbers, apart from the kernel.

bool finite_bits(scalar x) {
    if constexpr (sizeof(scalar) == 4) {
        uint32_t bits;
        memcpy(&bits, &x, sizeof x);
        return (bits >> 23 & 0xffu) != 0xffu;
    } else {
        uint64_t bits;
        memcpy(&bits, &x, sizeof x);
        return (bits >> 52 & 0x7ffu) != 0x7ffu;
    }
}
bool finite_bits(const Vector& v) { return finite_bits(v.x) && finite_bits(v.y) && finite_bits(v.z); }
bool finite_bits(const Matrix& A) { return finite_bits(A.c0) && finite_bits(A.c1) && finite_bits(A.c2); }
bool finite_bits(const BodyState& s) { return finite_bits(s.r_CM) && finite_bits(s.v_CM) && finite_bits(s.A) && finite_bits(s.L); }

using Exact = long double;
Exact exact(scalar x) { return static_cast<Exact>(x); }

bool between(scalar x, scalar low, scalar high) {
    return finite_bits(x) && exact(x) >= exact(low) && exact(x) <= exact(high);
}
bool inside(const Vector& v, scalar limit) { return between(v.x, -limit, limit) && between(v.y, -limit, limit) && between(v.z, -limit, limit); }

/// What check_vector has to say.
Status status_of(const Vector& v, scalar limit) {
    return !finite_bits(v) ? Status::not_finite : inside(v, limit) ? Status::ok : Status::out_of_range;
}

/// Reads raw bits, numbers about a limit, and sane ones.
class Numbers {
public:
    explicit Numbers(Bytes& in) : in_(in) {}

    scalar number(scalar about) {
        const uint8_t kind = in_.byte();
        if (kind < 96) return in_.raw<scalar>();
        if (kind < 128) return next_to(about, static_cast<int>(kind % 5u) - 2, (kind & 16u) != 0);
        return in_.number(about < 10 ? about : scalar(10));
    }
    Vector vector(scalar about) {
        const uint8_t which = in_.byte();  // mostly one component is out of the way: the others must not hide it
        const auto one = [&](unsigned bit) { return (which & bit) != 0 ? number(about) : scalar(in_.byte()) / 64; };
        const scalar x = one(1), y = one(2), z = one(4);
        return {x, y, z};
    }
    Matrix matrix() {
        Matrix A = ingot::identity_matrix<scalar>();
        const uint8_t kind = in_.byte();
        if (kind < 64) return A;
        if (kind < 128) return {vector(1), vector(1), vector(1)};
        if (kind < 192) {
            const Result<Matrix> turned =
                ingot::rotation_about({0, kind < 160 ? scalar(0.6) : scalar(0), kind < 160 ? scalar(0.8) : scalar(1)}, in_.number(4));
            if (turned.ok()) A = turned.value;
        }
        A.c0.x += number(limits::orthogonality);
        return A;
    }
    BodyState state() {
        const uint8_t parts = in_.byte();
        BodyState s{};
        s.r_CM.z = 10;
        if ((parts & 1u) != 0) s.r_CM = vector(limits::position_max);
        if ((parts & 2u) != 0) s.v_CM = vector(limits::speed_max);
        if ((parts & 4u) != 0) s.A = matrix();
        if ((parts & 8u) != 0) s.L = vector(limits::spin_max);
        return s;
    }
    Shape shape() {
        const auto kind = static_cast<ShapeKind>(in_.byte() & 7u);
        return {kind, vector(limits::size_max), (in_.byte() & 1u) != 0 ? number(limits::position_max) : scalar(0)};
    }

private:
    /// The number some ulps away.
    static scalar next_to(scalar about, int ulps, bool negative) {
        if constexpr (sizeof(scalar) == 4) {
            int32_t bits;
            memcpy(&bits, &about, sizeof bits);
            bits += ulps;
            memcpy(&about, &bits, sizeof bits);
        } else {
            int64_t bits;
            memcpy(&bits, &about, sizeof bits);
            bits += ulps;
            memcpy(&about, &bits, sizeof bits);
        }
        return negative ? -about : about;
    }

    Bytes& in_;
};

class Doors {
public:
    uint64_t run(Bytes in) {
        if (pristine_.body_count() == 0) furnish();
        memcpy(static_cast<void*>(&world_), &pristine_, sizeof world_);
        box_ = world_.body_at(1);
        call(in);
        return world_.state_hash();
    }

private:
    static constexpr scalar I_box = scalar(0.4);  // kg m^2

    static void furnish() {
        BodyDef ground, box;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        box.mass = {1, {I_box, I_box, I_box}, {}, ingot::identity_matrix<scalar>()};
        box.shape = ingot::Box{{1, 1, 1}};
        box.state.r_CM.z = 10;  // clear of the ground: contacts are for other fuzzers
        demand(pristine_.add(ground).ok() && pristine_.add(box).ok(), "two bodies fit");
    }

    void call(Bytes& in) {
        const uint8_t op = in.byte();
        Numbers numbers(in);
        switch (op % 24u) {
            case 0: return gravity(numbers);
            case 1: case 2: return set_state(numbers);
            case 3: case 4: return add(in, numbers);
            case 5: return force(numbers.vector(limits::force_max), numbers.vector(limits::position_max));
            case 6: return central_force(numbers);
            case 7: return torque(numbers);
            case 8: return impulse(numbers.vector(limits::force_max), numbers.vector(limits::position_max));
            case 9: return central_impulse(numbers);
            case 10: return angular_impulse(numbers);
            case 11: return collide(in, numbers);
            case 12: return step(numbers.number(in.byte() % 2u == 0 ? limits::step_min : limits::step_max));
            case 13: return ray(numbers);
            case 14: return nearest(numbers);
            case 15: return shape_query(in, numbers);
            case 16: return ids(in);
            case 17: return filter(in);
            case 18: return mass(numbers);
            case 19: return principal(numbers);
            case 20: return rotation(numbers);
            case 21: return solids(in, numbers);
            case 22: return shape(numbers);
            default: return forces_add_up(numbers);
        }
    }

    // The doors.

    void gravity(Numbers& numbers) {
        const Vector g = numbers.vector(limits::gravity_max);
        answered(world_.set_gravity(g), status_of(g, limits::gravity_max));
    }

    void set_state(Numbers& numbers) {
        const BodyState s = numbers.state();
        const Status status = world_.set_state(box_, s);
        checked(status);
        demand_state(s, status, I_box);
    }

    /// What can be said of a state without doing as the kernel does: refused where it must be, taken where nothing is near a limit.
    static void demand_state(const BodyState& s, Status status, scalar I_least) {
        const bool bad = !finite_bits(s) || !inside(s.r_CM, limits::position_max) || !inside(s.v_CM, limits::speed_max);
        demand(!(bad && status == Status::ok), "what is not finite or beyond its range is refused");
        demand(finite_bits(s) || status == Status::not_finite || status == Status::out_of_range || status == Status::not_a_rotation,
               "what is not finite is called so, or wrong for another reason");
        const bool upright = same_bytes(&s.A, &identity_, sizeof identity_);
        const bool good = !bad && upright && inside(s.L, limits::spin_max / 2 * I_least);
        demand(!good || status == Status::ok, "a state within its ranges is taken");
    }

    void add(Bytes& in, Numbers& numbers) {
        BodyDef def;
        const uint8_t parts = in.byte();
        def.mass = {1, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
        def.shape = ingot::Sphere{1};
        def.state.r_CM = {5, 0, 5};
        if ((parts & 1u) != 0) def.mass.M = numbers.number(parts % 4u < 2 ? limits::mass_min : limits::mass_max);
        if ((parts & 2u) != 0) def.mass.I_body = numbers.vector(parts % 8u < 4 ? limits::inertia_min : limits::inertia_max);
        if ((parts & 4u) != 0) def.state = numbers.state();
        if ((parts & 8u) != 0) def.shape = numbers.shape();
        if ((parts & 16u) != 0) def.restitution = numbers.number(1);
        if ((parts & 32u) != 0) def.friction = numbers.number(limits::friction_max);
        if ((parts & 64u) != 0) def.filter = {in.raw<uint32_t>(), in.raw<uint32_t>()};
        def.immovable = (parts & 128u) != 0;
        const Result<BodyId> added = world_.add(def);
        checked(added.status);
        demand(added.ok() == (added.value != BodyId{}), "an id comes with ok, and only then");
        const bool surface = between(def.restitution, 0, 1) && between(def.friction, 0, limits::friction_max);
        demand(surface || !added.ok(), "restitution and friction keep their ranges");
        if (!def.immovable) {
            const bool heavy = between(def.mass.M, limits::mass_min, limits::mass_max);
            demand(heavy || !added.ok(), "a mass keeps its range");
            const Vector& I = def.mass.I_body;
            const auto moment = [](scalar x) { return between(x, limits::inertia_min, limits::inertia_max); };
            demand((moment(I.x) && moment(I.y) && moment(I.z)) || !added.ok(), "moments keep their range");
            if (added.ok()) demand_triangle(def.mass.I_body);
        }
        if (added.ok()) {
            demand_state(def.state, Status::ok, 1);
            demand(finite_bits(def.shape.size) && finite_bits(def.shape.offset), "a shape is finite");
        }
    }

    static void demand_triangle(const Vector& I) {
        const Exact a = exact(I.x), b = exact(I.y), c = exact(I.z), trace = a + b + c, slack = 2 * exact(limits::triangle_inequality) * trace;
        demand(a <= b + c + slack && b <= c + a + slack && c <= a + b + slack, "no moment exceeds the sum of the others");
    }

    void force(const Vector& F, const Vector& P) {
        const Status status = world_.add_force(box_, F, P);
        checked(status);
        demand(status != Status::ok || (inside(F, limits::force_max) && inside(P, limits::position_max)), "forces and points keep their ranges");
        const bool small = inside(F, limits::torque_max / limits::position_max / 4) && inside(P, limits::position_max / 2);
        demand(!small || status == Status::ok, "a small force is taken");
    }
    void central_force(Numbers& numbers) {
        const Vector F = numbers.vector(limits::force_max);
        answered(world_.add_central_force(box_, F), status_of(F, limits::force_max));
    }
    void torque(Numbers& numbers) {
        const Vector tau = numbers.vector(limits::torque_max);
        answered(world_.add_torque(box_, tau), status_of(tau, limits::torque_max));
    }
    /// Each in range, and their sum not.
    void forces_add_up(Numbers& numbers) {
        const Vector first = numbers.vector(limits::force_max), second = numbers.vector(limits::force_max);
        if (world_.add_central_force(box_, first) != Status::ok) return;
        keep();
        const Status status = world_.add_central_force(box_, second);
        checked(status);
        const Vector sum = first + second;  // rounded once, as the kernel's is
        demand((status == Status::ok) == (inside(second, limits::force_max) && inside(sum, limits::force_max)),
               "a sum of forces keeps the range of one");
    }
    void impulse(const Vector& j, const Vector& P) {
        const Status status = world_.apply_impulse(box_, j, P);
        checked(status);
        demand(status != Status::ok || (inside(j, limits::force_max) && inside(P, limits::position_max)), "impulses and points keep their ranges");
        demand_motion(status);
    }
    void central_impulse(Numbers& numbers) {
        const Vector j = numbers.vector(limits::speed_max);  // of 1 kg
        const Status status = world_.apply_central_impulse(box_, j);
        checked(status);
        demand((status == Status::ok) == inside(j, limits::speed_max), "an impulse is taken as far as the speed allows");
        demand_motion(status);
    }
    void angular_impulse(Numbers& numbers) {
        const Vector k = numbers.vector(limits::spin_max * I_box);
        const Status status = world_.apply_angular_impulse(box_, k);
        checked(status);
        demand(status != Status::ok || finite_bits(k), "an angular impulse is finite");
        demand_motion(status);
    }
    void demand_motion(Status status) const {
        if (status != Status::ok) return;
        const Vector omega = world_.omega(box_).value;
        demand(inside(world_.state(box_).value.v_CM, limits::speed_max), "an impulse keeps the speed limit");
        // A turn of omega, from the body's axes, to the world's: no component exceeds the length, sqrt 3 times the limit.
        demand(inside(omega, scalar(1.75) * limits::spin_max), "an impulse keeps the spin limit");
    }

    void collide(Bytes& in, Numbers& numbers) {
        const Vector P = numbers.vector(limits::position_max), n = (in.byte() & 1u) != 0 ? numbers.vector(1) : Vector{0, 0, 1};
        const scalar e = numbers.number(1);
        (void)world_.apply_central_impulse(box_, {0, 0, -1});
        keep();
        const Result<scalar> j = world_.collide(box_, world_.body_at(0), P, n, e);
        checked(j.status);
        const Exact off = exact(n.x) * exact(n.x) + exact(n.y) * exact(n.y) + exact(n.z) * exact(n.z) - 1;
        const bool unit = finite_bits(n) && off < 16 * exact(ingot::epsilon) && off > -16 * exact(ingot::epsilon);
        demand(!j.ok() || (between(e, 0, 1) && inside(P, limits::position_max) && unit), "a collision keeps its ranges");
        demand(finite_bits(j.value) && j.value >= 0, "a collision pushes, with a finite impulse");
    }

    void step(scalar h) {
        const StepReport report = INGOT_FUZZ_STEP(world_, h);
        checked(report.status, false);
        demand((report.status == Status::ok) == between(h, limits::step_min, limits::step_max), "h is taken within its range");
        demand_bodies();
    }

    void ray(Numbers& numbers) {
        const Vector from = numbers.vector(limits::position_max), way = numbers.vector(limits::position_max);
        const Result<ingot::QueryHit> hit = world_.cast_ray(from, way);
        asked();
        demand(!hit.ok() || (inside(from, limits::position_max) && finite_bits(way)), "a ray keeps its range");
        demand_hit(hit);
    }
    static void demand_hit(const Result<ingot::QueryHit>& hit) {
        demand(finite_bits(hit.value.fraction) && finite_bits(hit.value.P) && finite_bits(hit.value.n), "what a query finds is finite");
        demand(between(hit.value.fraction, 0, 1), "a fraction of the way is within 0 .. 1");
    }
    void nearest(Numbers& numbers) {
        const Vector point = numbers.vector(limits::position_max);
        const scalar within = numbers.number(limits::position_max);
        const Result<ingot::QueryNearest> found = world_.find_nearest(point, within);
        asked();
        const Status door = !finite_bits(point) ? Status::not_finite : status_of(point, limits::position_max);
        demand(found.ok() == (door == Status::ok && between(within, 0, limits::position_max)), "find_nearest is asked within its ranges");
        demand(finite_bits(found.value.distance) && finite_bits(found.value.P) && finite_bits(found.value.n), "what a query finds is finite");
        demand(!found.ok() || found.value.distance <= within, "what is nearest is near enough");
    }
    void shape_query(Bytes& in, Numbers& numbers) {
        const uint8_t kind = in.byte();
        const ingot::PlacedShape moving = {(kind & 1u) != 0 ? numbers.shape() : Shape(ingot::Box{{1, scalar(0.5), scalar(0.25)}}),
                                           (kind & 2u) != 0 ? numbers.vector(limits::position_max) : Vector{0, 0, 3},
                                           (kind & 4u) != 0 ? numbers.matrix() : ingot::identity_matrix<scalar>(), nullptr};
        if ((kind & 8u) != 0) {
            demand_hit(world_.cast_shape(moving, numbers.vector(limits::position_max)));
        } else {
            BodyId found[2];
            const Result<int> count = world_.find_overlaps(moving, found, 2);
            demand(count.value >= 0 && count.value <= 2, "no more overlap than there are");
        }
        asked();
    }

    void ids(Bytes& in) {
        const BodyId id = in.raw<BodyId>();
        const bool lives = id == world_.body_at(0) || id == world_.body_at(1);
        demand(world_.is_alive(id) == lives && world_.state(id).ok() == lives && world_.mass(id).ok() == lives && world_.filter(id).ok() == lives,
               "only the ids of living bodies are answered");
        asked();
        if (!lives) checked(world_.remove(id));
    }
    void filter(Bytes& in) {
        const ingot::BodyFilter wanted = {in.raw<uint32_t>(), in.raw<uint32_t>()};
        answered(world_.set_filter(box_, wanted), Status::ok);
        const ingot::BodyFilter kept = world_.filter(box_).value;
        demand(kept.category == wanted.category && kept.mask == wanted.mask, "a filter is kept as it is");
    }

    // Numbers without a world.

    void mass(Numbers& numbers) {
        const ingot::MassProperties m = {numbers.number(limits::mass_max), numbers.vector(limits::inertia_max), {}, ingot::identity_matrix<scalar>()};
        const Status status = ingot::check_mass_properties(m);
        demand(status != Status::ok || (between(m.M, limits::mass_min, limits::mass_max) && finite_bits(m.I_body)), "a mass keeps its range");
        if (status == Status::ok) demand_triangle(m.I_body);
    }
    void principal(Numbers& numbers) {
        const Vector diagonal = numbers.vector(limits::inertia_max), products = numbers.vector(1);
        const ingot::MassDistribution solid = {numbers.number(limits::mass_max), numbers.vector(limits::position_max),
                                               {diagonal.x, diagonal.y, diagonal.z, products.x, products.y, products.z}};
        demand_principal(solid);
    }
    static void demand_principal(const ingot::MassDistribution& solid) {
        const Result<ingot::MassProperties> m = ingot::principal(solid);
        if (!m.ok()) return;
        demand(finite_bits(m.value.I_body) && finite_bits(m.value.A_principal) && finite_bits(m.value.r_CM), "mass properties are finite");
        demand(ingot::check_mass_properties(m.value) == Status::ok, "principal gives what add takes");
        demand(ingot::orthogonality_error(m.value.A_principal) <= 64 * ingot::epsilon, "principal axes are orthonormal");
        demand(ingot::determinant(m.value.A_principal) > 0, "principal axes are right-handed");
    }
    void rotation(Numbers& numbers) {
        const Vector n = numbers.vector(1);
        const scalar angle = numbers.number(1000);
        const Result<Matrix> A = ingot::rotation_about(n, angle);
        demand(!A.ok() || (finite_bits(n) && between(angle, -1000, 1000)), "an axis is finite, an angle within its range");
        demand(!A.ok() || ingot::check_rotation(A.value) == Status::ok, "rotation_about gives rotations");
        demand(!A.ok() || ingot::orthogonality_error(A.value) <= 2 * limits::unit_length + 32 * ingot::epsilon,
               "rotation_about is as exact as its axis");
    }
    void solids(Bytes& in, Numbers& numbers) {
        const scalar density = numbers.number(1000), a = numbers.number(limits::size_max), b = numbers.number(limits::size_max),
                     c = numbers.number(1);
        switch (in.byte() % 7u) {
            case 0: return demand_principal(ingot::solid_sphere(density, a));
            case 1: return demand_principal(ingot::solid_box(density, {a, b, c}));
            case 2: return demand_principal(ingot::solid_cylinder(density, a, b));
            case 3: return demand_principal(ingot::solid_capsule(density, a, b));
            case 4: return demand_principal(ingot::solid_cone(density, a, b));
            case 5: return demand_principal(ingot::solid_ellipsoid(density, {a, b, c}));
            default:
                return demand_principal(ingot::combined(ingot::solid_box(density, {a, 1, b}),
                                                        ingot::placed(ingot::solid_sphere(1, c), numbers.matrix(), numbers.vector(100))));
        }
    }
    void shape(Numbers& numbers) {
        const Shape s = numbers.shape();
        const Status status = ingot::check_shape(s);
        demand(status != Status::ok || (finite_bits(s.size) && finite_bits(s.offset)), "a shape is finite");
        // A level has the size of its table, which is looked at by check_level.
        if (status != Status::ok || s.kind == ShapeKind::none || s.kind == ShapeKind::level) return;
        const scalar radius = ingot::bounding_radius(s);
        demand(s.kind == ShapeKind::half_space ? radius == 0 : between(radius, limits::size_min, 2 * limits::size_max),
               "a bounding radius is as large as the shape");
    }

    // The promises.

    /// What a refusal is compared with, from now on.
    void keep() {
        memcpy(static_cast<void*>(&kept_world_), &world_, sizeof world_);
        kept_ = true;
    }
    const World<Stage>& before() const { return kept_ ? kept_world_ : pristine_; }

    /// A call that only asks.
    void asked() const { demand(same_bytes(&world_, &before(), sizeof world_), "asking changes nothing"); }

    /// A call whose status the oracle knows.
    void answered(Status status, Status due) {
        demand(status == due, "a number is taken within its range, and refused beyond, for the reason");
        checked(status);
    }

    /// Refused: nothing has changed. Taken: the world steps, and is whole.
    void checked(Status status, bool steps = true) {
        if (status != Status::ok) {
            if (fuzz_fault == 1) reinterpret_cast<unsigned char*>(&world_)[sizeof world_ / 2] ^= 1u;
            demand(same_bytes(&world_, &before(), sizeof world_), "a refused call leaves the world bitwise unchanged");
            return;
        }
        if (!steps) return;
        demand(INGOT_FUZZ_STEP(world_, scalar(1) / 60).status == Status::ok, "a world steps");
        demand_bodies();
    }

    void demand_bodies() const {
        for (int slot = 0; slot < Stage::max_bodies; ++slot) {
            const BodyId id = world_.body_at(slot);
            if (id == BodyId{}) continue;
            const BodyState s = world_.state(id).value;
            demand(finite_bits(s) && finite_bits(world_.omega(id).value), "motion is finite");
            demand(inside(s.r_CM, limits::position_max), "a body stays within limits::position_max");
            demand(ingot::orthogonality_error(s.A) <= 3 * limits::orthogonality, "A is orthonormal");
        }
    }

    static World<Stage> pristine_, kept_world_, world_;
    static constexpr Matrix identity_ = ingot::identity_matrix<scalar>();
    BodyId box_ = {};
    bool kept_ = false;
};

World<Stage> Doors::pristine_, Doors::kept_world_, Doors::world_;

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) { return Doors().run(Bytes(data, size)); }
