// SPDX-License-Identifier: MIT
// A call that cannot be obeyed says why and changes nothing: not a bit of the world, in every build.
#include "capacity/yard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace yard;

constexpr scalar infinity = std::numeric_limits<scalar>::infinity();
constexpr scalar nan_value = std::numeric_limits<scalar>::quiet_NaN();
constexpr scalar largest = std::numeric_limits<scalar>::max();
constexpr scalar smallest = std::numeric_limits<scalar>::denorm_min();

/// The number next to a limit on its far side.
scalar beyond(scalar limit) { return std::nextafter(limit, limit < 0 ? -infinity : infinity); }
scalar below(scalar limit) { return std::nextafter(limit, -infinity); }

/// Everything the calls of World take; as made here, each call accepts it.
struct Args {
    BodyDef def = plain_body({1, 2, 3}, ingot::Sphere{1});
    BodyState state = plain_body({1, 2, 3}).state;
    Vector F = {1, 2, 3}, tau = {1, 2, 3}, j = {1, 2, 3}, k = {1, 2, 3}, P = {0, 1, 2}, n = {0, 0, 1}, gravity = {0, 0, -10};
    scalar e = scalar(0.5), step = h;

    Args() {
        def.state.v_CM = {1, 0, 0};
        def.restitution = scalar(0.5);
    }
};

struct Number {
    std::string name;
    std::function<scalar&(Args&)> in;
};

struct Call {
    const char* name;
    std::function<Status(World<Yard>&, const Cast&, const Args&)> make;
    std::vector<Number> numbers;
};

using VectorIn = std::function<Vector&(Args&)>;

void append(std::vector<Number>& numbers, const std::string& name, VectorIn in) {
    numbers.push_back({name + ".x", [=](Args& a) -> scalar& { return in(a).x; }});
    numbers.push_back({name + ".y", [=](Args& a) -> scalar& { return in(a).y; }});
    numbers.push_back({name + ".z", [=](Args& a) -> scalar& { return in(a).z; }});
}

void append_state(std::vector<Number>& numbers, std::function<BodyState&(Args&)> in) {
    append(numbers, "r_CM", [=](Args& a) -> Vector& { return in(a).r_CM; });
    append(numbers, "v_CM", [=](Args& a) -> Vector& { return in(a).v_CM; });
    append(numbers, "A.c0", [=](Args& a) -> Vector& { return in(a).A.c0; });
    append(numbers, "A.c1", [=](Args& a) -> Vector& { return in(a).A.c1; });
    append(numbers, "A.c2", [=](Args& a) -> Vector& { return in(a).A.c2; });
    append(numbers, "L", [=](Args& a) -> Vector& { return in(a).L; });
}

/// All calls that take numbers, with all numbers they take.
std::vector<Call> all_calls() {
    std::vector<Call> calls;
    const auto call = [&](const char* name, auto make) -> std::vector<Number>& {
        calls.push_back({name, make, {}});
        return calls.back().numbers;
    };

    auto* numbers = &call("add", [](World<Yard>& w, const Cast&, const Args& a) { return w.add(a.def).status; });
    numbers->push_back({"M", [](Args& a) -> scalar& { return a.def.mass.M; }});
    append(*numbers, "I_body", [](Args& a) -> Vector& { return a.def.mass.I_body; });
    append_state(*numbers, [](Args& a) -> BodyState& { return a.def.state; });
    append(*numbers, "shape.size", [](Args& a) -> Vector& { return a.def.shape.size; });
    numbers->push_back({"shape.offset", [](Args& a) -> scalar& { return a.def.shape.offset; }});
    numbers->push_back({"restitution", [](Args& a) -> scalar& { return a.def.restitution; }});

    numbers = &call("set_state", [](World<Yard>& w, const Cast& c, const Args& a) { return w.set_state(c.box, a.state); });
    append_state(*numbers, [](Args& a) -> BodyState& { return a.state; });

    numbers = &call("add_force", [](World<Yard>& w, const Cast& c, const Args& a) { return w.add_force(c.box, a.F, a.P); });
    append(*numbers, "F", [](Args& a) -> Vector& { return a.F; });
    append(*numbers, "P", [](Args& a) -> Vector& { return a.P; });

    numbers = &call("add_central_force", [](World<Yard>& w, const Cast& c, const Args& a) { return w.add_central_force(c.box, a.F); });
    append(*numbers, "F", [](Args& a) -> Vector& { return a.F; });

    numbers = &call("add_torque", [](World<Yard>& w, const Cast& c, const Args& a) { return w.add_torque(c.box, a.tau); });
    append(*numbers, "tau", [](Args& a) -> Vector& { return a.tau; });

    numbers = &call("apply_impulse", [](World<Yard>& w, const Cast& c, const Args& a) { return w.apply_impulse(c.heavy, a.j, a.P); });
    append(*numbers, "j", [](Args& a) -> Vector& { return a.j; });
    append(*numbers, "P", [](Args& a) -> Vector& { return a.P; });

    numbers = &call("apply_central_impulse",
                    [](World<Yard>& w, const Cast& c, const Args& a) { return w.apply_central_impulse(c.heavy, a.j); });
    append(*numbers, "j", [](Args& a) -> Vector& { return a.j; });

    numbers = &call("apply_angular_impulse",
                    [](World<Yard>& w, const Cast& c, const Args& a) { return w.apply_angular_impulse(c.heavy, a.k); });
    append(*numbers, "k", [](Args& a) -> Vector& { return a.k; });

    numbers = &call("collide", [](World<Yard>& w, const Cast& c, const Args& a) { return w.collide(c.spinner, c.ball, a.P, a.n, a.e).status; });
    append(*numbers, "P", [](Args& a) -> Vector& { return a.P; });
    append(*numbers, "n", [](Args& a) -> Vector& { return a.n; });
    numbers->push_back({"e", [](Args& a) -> scalar& { return a.e; }});

    numbers = &call("set_gravity", [](World<Yard>& w, const Cast&, const Args& a) { return w.set_gravity(a.gravity); });
    append(*numbers, "gravity", [](Args& a) -> Vector& { return a.gravity; });

    numbers = &call("step", [](World<Yard>& w, const Cast&, const Args& a) { return ingot::step(w, a.step).status; });
    numbers->push_back({"h", [](Args& a) -> scalar& { return a.step; }});
    return calls;
}

class BadCalls : public ::testing::Test {
protected:
    BadCalls() {
        clear(world_);
        cast_ = fill(world_);
        copy(undisturbed_, world_);
        for (uint64_t& hash : trace_) {
            (void)ingot::step(undisturbed_, h);
            hash = undisturbed_.state_hash();
        }
    }

    /// The call is refused for the reason given, changes no bit, and the world goes on as if it had not been made.
    template <class Made>
    void refuses(Status reason, const std::string& what, Made made) {
        copy(touched_, world_);
        EXPECT_EQ(made(touched_), reason) << what;
        EXPECT_TRUE(same_bytes(touched_, world_)) << what << " changed the world";
        for (const uint64_t hash : trace_) {
            (void)ingot::step(touched_, h);
            ASSERT_EQ(touched_.state_hash(), hash) << what << " changed a later step";
        }
        EXPECT_TRUE(same_bytes(touched_, undisturbed_)) << what << " changed a later step";
    }

    template <class Made>
    void accepts(const std::string& what, Made made) {
        copy(touched_, world_);
        EXPECT_EQ(made(touched_), Status::ok) << what;
        EXPECT_FALSE(same_bytes(touched_, world_)) << what << " did nothing";
    }

    static World<Yard> world_, touched_, undisturbed_;
    Cast cast_;
    uint64_t trace_[10];
};

World<Yard> BadCalls::world_, BadCalls::touched_, BadCalls::undisturbed_;

TEST_F(BadCalls, the_yard_is_what_the_tests_take_it_for) {
    EXPECT_EQ(world_.body_count(), 6);
    EXPECT_GE(world_.contact_count(), 5) << "box and ball are on the ground";
    EXPECT_TRUE(world_.is_frozen(cast_.frozen));
    EXPECT_FALSE(world_.is_frozen(cast_.spinner));
    EXPECT_EQ(cast_.outlived.slot, cast_.spinner.slot);
    EXPECT_FALSE(world_.is_alive(cast_.outlived));
    EXPECT_FALSE(world_.is_alive(cast_.removed));
}

TEST_F(BadCalls, every_call_accepts_the_numbers_that_the_tests_spoil) {
    for (const Call& call : all_calls()) accepts(call.name, [&](World<Yard>& w) { return call.make(w, cast_, Args()); });
}

TEST_F(BadCalls, nan_and_infinity_are_not_finite_in_every_number_of_every_call) {
    int spoiled = 0;
    for (const Call& call : all_calls()) {
        for (const Number& number : call.numbers) {
            for (const scalar bad : {nan_value, infinity, -infinity}) {
                Args args;
                number.in(args) = bad;
                const Status reason = std::string(call.name) == "step" ? Status::bad_step : Status::not_finite;
                refuses(reason, std::string(call.name) + " with " + number.name + " = " + std::to_string(bad),
                        [&](World<Yard>& w) { return call.make(w, cast_, args); });
                ++spoiled;
            }
        }
    }
    EXPECT_EQ(spoiled, 3 * (27 + 18 + 6 + 3 + 3 + 6 + 3 + 3 + 7 + 3 + 1));
}

/// The last value that a number may have, and the reason for which the next one is refused.
struct Limit {
    const char* call;
    const char* number;
    scalar last;
    scalar first_bad;
    Status reason;
};

TEST_F(BadCalls, each_range_ends_where_limits_say) {
    const scalar r = limits::position_max, v = limits::speed_max, F = limits::force_max, tau = limits::torque_max;
    const Limit table[] = {
        {"add", "r_CM.x", r, beyond(r), Status::out_of_range},
        {"add", "r_CM.y", -r, beyond(-r), Status::out_of_range},
        {"add", "r_CM.z", r, largest, Status::out_of_range},
        {"add", "v_CM.x", v, beyond(v), Status::out_of_range},
        {"add", "v_CM.z", -v, beyond(-v), Status::out_of_range},
        {"add", "L.x", limits::spin_max, beyond(limits::spin_max), Status::out_of_range},  // the moment about x is 1
        {"add", "L.x", -limits::spin_max, beyond(-limits::spin_max), Status::out_of_range},
        {"add", "L.y", 1, largest, Status::out_of_range},
        {"add", "M", limits::mass_min, below(limits::mass_min), Status::bad_mass},
        {"add", "M", limits::mass_max, beyond(limits::mass_max), Status::bad_mass},
        {"add", "M", 1, 0, Status::bad_mass},
        {"add", "M", 1, scalar(-0.0), Status::bad_mass},
        {"add", "M", 1, -1, Status::bad_mass},
        {"add", "M", 1, smallest, Status::bad_mass},
        {"add", "M", 1, largest, Status::bad_mass},
        {"add", "I_body.x", 1, 0, Status::bad_inertia},
        {"add", "I_body.y", 1, -1, Status::bad_inertia},
        {"add", "I_body.z", 1, smallest, Status::bad_inertia},
        {"add", "I_body.z", scalar(2.5), scalar(2.51), Status::bad_inertia},  // 1 + 1.5 is all it may be
        {"add", "I_body.x", scalar(0.5), scalar(0.49), Status::bad_inertia},
        {"add", "I_body.z", 1, largest, Status::bad_inertia},
        {"add", "restitution", 0, -smallest, Status::bad_restitution},
        {"add", "restitution", 1, beyond(1), Status::bad_restitution},
        {"add", "restitution", 1, -largest, Status::bad_restitution},
        {"add", "shape.size.x", limits::size_min, below(limits::size_min), Status::bad_shape},
        {"add", "shape.size.x", limits::size_max, beyond(limits::size_max), Status::bad_shape},
        {"add", "shape.size.x", 1, 0, Status::bad_shape},
        {"add", "shape.size.x", 1, -1, Status::bad_shape},
        {"set_state", "r_CM.x", -r, beyond(-r), Status::out_of_range},
        {"set_state", "r_CM.z", r, beyond(r), Status::out_of_range},
        {"set_state", "v_CM.y", v, beyond(v), Status::out_of_range},
        {"set_state", "v_CM.z", -v, -largest, Status::out_of_range},
        {"set_state", "L.x", limits::spin_max, beyond(limits::spin_max), Status::out_of_range},
        {"set_state", "L.z", 1, -largest, Status::out_of_range},
        {"add_force", "P.x", 10, beyond(r), Status::out_of_range},
        {"add_force", "F.z", F / 4, largest, Status::out_of_range},
        {"add_central_force", "F.x", F, beyond(F), Status::out_of_range},
        {"add_central_force", "F.y", -F, beyond(-F), Status::out_of_range},
        {"add_torque", "tau.x", tau, beyond(tau), Status::out_of_range},
        {"add_torque", "tau.z", -tau, beyond(-tau), Status::out_of_range},
        {"apply_impulse", "P.y", 1900, beyond(r), Status::out_of_range},
        {"apply_impulse", "j.x", 10, largest, Status::out_of_range},
        {"apply_central_impulse", "j.x", F, beyond(F), Status::out_of_range},
        {"apply_central_impulse", "j.z", -F, beyond(-F), Status::out_of_range},
        {"apply_angular_impulse", "k.y", tau, beyond(tau), Status::out_of_range},
        {"apply_angular_impulse", "k.x", -tau, beyond(-tau), Status::out_of_range},
        {"collide", "P.x", 0, beyond(r), Status::out_of_range},
        {"collide", "P.z", 0, -largest, Status::out_of_range},
        {"collide", "e", 0, -smallest, Status::bad_restitution},
        {"collide", "e", 1, beyond(1), Status::bad_restitution},
        {"collide", "n.z", 1, 1 + 5 * ingot::epsilon, Status::bad_direction},
        {"collide", "n.z", 1, 1 - 5 * ingot::epsilon, Status::bad_direction},
        {"collide", "n.z", 1, 0, Status::bad_direction},
        {"collide", "n.z", 1, 2, Status::bad_direction},
        {"collide", "n.x", smallest, scalar(0.01), Status::bad_direction},
        {"collide", "n.y", 0, largest, Status::bad_direction},
        {"set_gravity", "gravity.x", limits::gravity_max, beyond(limits::gravity_max), Status::out_of_range},
        {"set_gravity", "gravity.z", -limits::gravity_max, beyond(-limits::gravity_max), Status::out_of_range},
        {"step", "h", limits::step_max, beyond(limits::step_max), Status::bad_step},
        {"step", "h", limits::step_min, below(limits::step_min), Status::bad_step},
        {"step", "h", h, 0, Status::bad_step},
        {"step", "h", h, scalar(-0.0), Status::bad_step},
        {"step", "h", h, -h, Status::bad_step},
        {"step", "h", h, -1, Status::bad_step},
        {"step", "h", h, smallest, Status::bad_step},
        {"step", "h", h, scalar(1e6), Status::bad_step},
        {"step", "h", h, largest, Status::bad_step},
    };
    const std::vector<Call> calls = all_calls();
    for (const Limit& limit : table) {
        const auto call = std::find_if(calls.begin(), calls.end(), [&](const Call& c) { return std::string(c.name) == limit.call; });
        ASSERT_NE(call, calls.end()) << limit.call;
        const auto number = std::find_if(call->numbers.begin(), call->numbers.end(), [&](const Number& n) { return n.name == limit.number; });
        ASSERT_NE(number, call->numbers.end()) << limit.number;
        const std::string what = std::string(limit.call) + " with " + limit.number + " = ";

        Args args;
        number->in(args) = limit.last;
        accepts(what + std::to_string(limit.last), [&](World<Yard>& w) { return call->make(w, cast_, args); });
        number->in(args) = limit.first_bad;
        refuses(limit.reason, what + std::to_string(limit.first_bad), [&](World<Yard>& w) { return call->make(w, cast_, args); });
    }
}

TEST_F(BadCalls, inertia_that_no_solid_has) {
    const auto add = [](const Vector& I) {
        return [I](World<Yard>& w) {
            BodyDef def = plain_body({1, 2, 3});
            def.mass.I_body = I;
            return w.add(def).status;
        };
    };
    const scalar low = limits::inertia_min, high = limits::inertia_max, ratio = limits::inertia_ratio_max;
    accepts("smallest moments", add({low, low, low}));
    refuses(Status::bad_inertia, "moment below the smallest", add({low, below(low), low}));
    accepts("largest moments", add({high, high, high}));
    refuses(Status::bad_inertia, "moment above the largest", add({high, high, beyond(high)}));
    accepts("a flat plate", add({1, 1, 2}));
    accepts("a flat plate but for rounding", add({1, 1, 2 + scalar(1e-5)}));
    refuses(Status::bad_inertia, "flatter than flat", add({1, 1, scalar(2.001)}));
    refuses(Status::bad_inertia, "flatter than flat", add({scalar(2.001), 1, 1}));
    refuses(Status::bad_inertia, "flatter than flat", add({1, scalar(2.001), 1}));
    accepts("a needle", add({1, 1, scalar(1.01) / ratio}));
    refuses(Status::bad_inertia, "a needle too thin", add({1, 1, scalar(0.99) / ratio}));
    refuses(Status::bad_inertia, "a needle too thin", add({scalar(0.99) / ratio, 1, 1}));
    refuses(Status::bad_inertia, "no moments", add({0, 0, 0}));
    refuses(Status::bad_inertia, "negative moments", add({-1, -1, -1}));
    refuses(Status::bad_inertia, "moments whose sum overflows", add({largest, largest, largest}));
}

TEST_F(BadCalls, a_matrix_that_is_no_rotation) {
    const Matrix turned = ingot::rotation_about({0, scalar(0.6), scalar(0.8)}, 2).value;
    const scalar x = limits::orthogonality / 2;  // scaling by 1 + x puts A^T A off by 2 x + x^2
    Matrix sheared = turned, swapped = turned, reflected = turned, flat = turned, huge = turned * largest;
    sheared.c0 += turned.c1 * scalar(0.1);
    swapped.c0 = turned.c1;
    swapped.c1 = turned.c0;
    reflected.c2 = -turned.c2;
    flat.c2 = {};
    const struct {
        const char* what;
        Matrix A;
        Status expected;
    } table[] = {
        {"a rotation", turned, Status::ok},
        {"a rotation in rough numbers", turned * (1 + scalar(0.9) * x), Status::ok},
        {"scaled up", turned * (1 + x), Status::not_a_rotation},
        {"scaled down", turned * (1 - scalar(1.1) * x), Status::not_a_rotation},
        {"doubled", turned * 2, Status::not_a_rotation},
        {"sheared", sheared, Status::not_a_rotation},
        {"columns swapped", swapped, Status::not_a_rotation},
        {"reflected", reflected, Status::not_a_rotation},
        {"inverted", turned * -1, Status::not_a_rotation},
        {"a projection", flat, Status::not_a_rotation},
        {"zero", Matrix{}, Status::not_a_rotation},
        {"so large that its squares overflow", huge, Status::not_a_rotation},
        {"so small that its squares vanish", turned * smallest, Status::not_a_rotation},
    };
    for (const auto& row : table) {
        const auto set = [&](World<Yard>& w) {
            BodyState state = w.state(cast_.box).value;
            state.A = row.A;
            return w.set_state(cast_.box, state);
        };
        const auto add = [&](World<Yard>& w) {
            BodyDef def = plain_body({1, 2, 3});
            def.state.A = row.A;
            return w.add(def).status;
        };
        if (row.expected == Status::ok) {
            accepts(row.what, set);
            EXPECT_LE(ingot::orthogonality_error(touched_.state(cast_.box).value.A), 4 * ingot::epsilon) << row.what;
            accepts(row.what, add);
        } else {
            refuses(row.expected, row.what, set);
            refuses(row.expected, row.what, add);
        }
    }
}

TEST_F(BadCalls, ids_that_name_no_body) {
    const std::vector<std::pair<const char*, std::function<Status(World<Yard>&, BodyId)>>> calls = {
        {"remove", [](World<Yard>& w, BodyId id) { return w.remove(id); }},
        {"state", [](World<Yard>& w, BodyId id) { return w.state(id).status; }},
        {"set_state", [](World<Yard>& w, BodyId id) { return w.set_state(id, Args().state); }},
        {"omega", [](World<Yard>& w, BodyId id) { return w.omega(id).status; }},
        {"add_force", [](World<Yard>& w, BodyId id) { return w.add_force(id, {1, 0, 0}, {}); }},
        {"add_central_force", [](World<Yard>& w, BodyId id) { return w.add_central_force(id, {1, 0, 0}); }},
        {"add_torque", [](World<Yard>& w, BodyId id) { return w.add_torque(id, {1, 0, 0}); }},
        {"apply_impulse", [](World<Yard>& w, BodyId id) { return w.apply_impulse(id, {1, 0, 0}, {}); }},
        {"apply_central_impulse", [](World<Yard>& w, BodyId id) { return w.apply_central_impulse(id, {1, 0, 0}); }},
        {"apply_angular_impulse", [](World<Yard>& w, BodyId id) { return w.apply_angular_impulse(id, {1, 0, 0}); }},
        {"collide, first", [&](World<Yard>& w, BodyId id) { return w.collide(id, cast_.box, {}, {1, 0, 0}, 1).status; }},
        {"collide, second", [&](World<Yard>& w, BodyId id) { return w.collide(cast_.box, id, {}, {1, 0, 0}, 1).status; }},
        {"collide, both", [](World<Yard>& w, BodyId id) { return w.collide(id, id, {}, {1, 0, 0}, 1).status; }},
        {"kinetic_energy", [](World<Yard>& w, BodyId id) { return w.kinetic_energy(id).status; }},
        {"linear_momentum", [](World<Yard>& w, BodyId id) { return w.linear_momentum(id).status; }},
        {"angular_momentum", [](World<Yard>& w, BodyId id) { return w.angular_momentum(id).status; }},
        {"is_alive", [](World<Yard>& w, BodyId id) { return w.is_alive(id) ? Status::ok : Status::stale_id; }},
        {"is_frozen", [](World<Yard>& w, BodyId id) { return w.is_frozen(id) ? Status::ok : Status::stale_id; }},
    };
    const auto changed = [&](auto change) {
        BodyId id = cast_.box;
        change(id);
        return id;
    };
    const struct {
        const char* what;
        BodyId id;
        Status reason;
    } table[] = {
        {"null", BodyId{}, Status::stale_id},
        {"removed", cast_.removed, Status::stale_id},
        {"of a slot that another lives in", cast_.outlived, Status::stale_id},
        {"of the future", changed([](BodyId& id) { id.generation += 2; }), Status::stale_id},
        {"of a gap between lives", changed([](BodyId& id) { id.generation += 1; }), Status::stale_id},
        {"with the last generation", changed([](BodyId& id) { id.generation = UINT32_MAX; }), Status::stale_id},
        {"with no generation", changed([](BodyId& id) { id.generation = 0; }), Status::stale_id},
        {"of the slot past the last", changed([](BodyId& id) { id.slot = Yard::max_bodies; }), Status::stale_id},
        {"of the last slot there can be", changed([](BodyId& id) { id.slot = UINT16_MAX; }), Status::stale_id},
        {"of another world", changed([](BodyId& id) { id.world_tag = 8; }), Status::foreign_id},
        {"of a world without a tag", changed([](BodyId& id) { id.world_tag = 0; }), Status::foreign_id},
        {"of another world, and of no slot here", BodyId{UINT16_MAX, 8, 1}, Status::foreign_id},
    };
    for (const auto& row : table) {
        for (const auto& call : calls) {
            const std::string what = std::string(call.first) + " of an id " + row.what;
            const bool yes_or_no = std::string(call.first).rfind("is_", 0) == 0;
            refuses(yes_or_no ? Status::stale_id : row.reason, what, [&](World<Yard>& w) { return call.second(w, row.id); });
        }
    }
}

TEST_F(BadCalls, a_foreign_id_is_told_by_the_world_that_gave_it_out) {
    static World<Yard> other;
    clear(other);
    ASSERT_EQ(other.set_tag(8), Status::ok);
    const BodyId foreign = other.add(plain_body({})).value;
    refuses(Status::foreign_id, "remove", [&](World<Yard>& w) { return w.remove(foreign); });
    refuses(Status::foreign_id, "set_state", [&](World<Yard>& w) { return w.set_state(foreign, Args().state); });
    EXPECT_TRUE(other.is_alive(foreign));
}

TEST_F(BadCalls, nothing_is_removed_twice) {
    copy(touched_, world_);
    const BodyId id = cast_.spinner;
    ASSERT_EQ(touched_.remove(id), Status::ok);
    static World<Yard> after;
    copy(after, touched_);
    EXPECT_EQ(touched_.remove(id), Status::stale_id);
    EXPECT_TRUE(same_bytes(touched_, after));

    const BodyId next = touched_.add(plain_body({})).value;
    ASSERT_EQ(next.slot, id.slot) << "the lowest free slot";
    ASSERT_NE(next, id);
    copy(after, touched_);
    EXPECT_EQ(touched_.remove(id), Status::stale_id) << "the id outlives its body and names no other";
    EXPECT_EQ(touched_.set_state(id, Args().state), Status::stale_id);
    EXPECT_TRUE(same_bytes(touched_, after));
}

TEST_F(BadCalls, nothing_is_added_past_the_capacity) {
    copy(touched_, world_);
    while (touched_.body_count() < Yard::max_bodies) ASSERT_TRUE(touched_.add(plain_body({0, 0, 99})).ok());
    static World<Yard> full;
    copy(full, touched_);
    for (int again = 0; again < 3; ++again) {
        const Result<BodyId> refused = touched_.add(plain_body({0, 0, 99}));
        EXPECT_EQ(refused.status, Status::no_room);
        EXPECT_EQ(refused.value, BodyId{});
        EXPECT_TRUE(same_bytes(touched_, full));
    }
    BodyDef bad = plain_body({});
    bad.mass.M = -1;
    EXPECT_EQ(touched_.add(bad).status, Status::bad_mass) << "what is wrong with a body is said first";
    EXPECT_TRUE(same_bytes(touched_, full));

    ASSERT_EQ(touched_.remove(cast_.ball), Status::ok);
    EXPECT_TRUE(touched_.add(plain_body({0, 0, 99})).ok()) << "room again";
}

struct Pair : ingot::Scene {
    static constexpr int max_bodies = 2;
};

TEST_F(BadCalls, a_slot_whose_generations_are_used_up_is_not_given_out_again) {
    static World<Pair> pair;
    clear(pair);
    BodyDef def = plain_body({});
    for (int life = 0; life < 1000; ++life) ASSERT_EQ(pair.remove(pair.add(def).value), Status::ok);

    // 2^31 lives take too long: the counter is found by its value and moved on.
    unsigned char* bytes = reinterpret_cast<unsigned char*>(&pair);
    const uint32_t lived = 2000, nearly_used_up = UINT32_MAX - 3;
    int found = 0;
    for (size_t at = 0; at + sizeof lived <= sizeof pair; at += sizeof lived) {
        if (memcmp(bytes + at, &lived, sizeof lived) != 0) continue;
        memcpy(bytes + at, &nearly_used_up, sizeof nearly_used_up);
        ++found;
    }
    ASSERT_EQ(found, 1);

    const BodyId last = pair.add(def).value;
    EXPECT_EQ(last.slot, 0);
    EXPECT_EQ(last.generation, UINT32_MAX - 2);
    ASSERT_EQ(pair.remove(last), Status::ok);
    EXPECT_EQ(pair.add(def).value.slot, 1) << "slot 0 is used up";
    EXPECT_EQ(pair.add(def).status, Status::no_room);
    EXPECT_FALSE(pair.is_alive(last));
    EXPECT_FALSE(pair.is_alive(BodyId{}));
}

TEST_F(BadCalls, sums_that_leave_the_range_their_summands_keep) {
    const scalar F = limits::force_max, tau = limits::torque_max, quarter = scalar(0.25);
    const Vector centre = world_.state(cast_.heavy).value.r_CM, lever{-2, 0, 0};
    refuses(Status::out_of_range, "force on force", [&](World<Yard>& w) { return w.add_central_force(cast_.heavy, {F * scalar(0.26), 0, 0}); });
    accepts("a force that just fits", [&](World<Yard>& w) { return w.add_central_force(cast_.heavy, {F * quarter, 0, 0}); });
    refuses(Status::out_of_range, "torque on torque", [&](World<Yard>& w) { return w.add_torque(cast_.heavy, {0, tau * scalar(0.26), 0}); });
    accepts("a torque that just fits", [&](World<Yard>& w) { return w.add_torque(cast_.heavy, {0, tau * quarter, 0}); });
    refuses(Status::out_of_range, "a force that fits, whose torque does not",
            [&](World<Yard>& w) { return w.add_force(cast_.heavy, {0, 0, F * quarter}, centre + lever); });
    refuses(Status::out_of_range, "a torque that fits, whose force does not",
            [&](World<Yard>& w) { return w.add_force(cast_.heavy, {F * scalar(0.26), 0, 0}, centre); });
    refuses(Status::out_of_range, "a lever as long as the world",
            [&](World<Yard>& w) { return w.add_force(cast_.box, {F, F, F}, {-limits::position_max, limits::position_max, 0}); });
    refuses(Status::out_of_range, "a speed beyond the limit",
            [&](World<Yard>& w) { return w.apply_central_impulse(cast_.spinner, {0, limits::speed_max * scalar(1.01), 0}); });
    refuses(Status::out_of_range, "a spin beyond the limit",
            [&](World<Yard>& w) { return w.apply_angular_impulse(cast_.spinner, Vector{1, 1, 1} * (4 * limits::spin_max)); });
    refuses(Status::out_of_range, "a speed within, a spin beyond the limit",
            [&](World<Yard>& w) { return w.apply_impulse(cast_.spinner, {1000, 0, 0}, {0, limits::position_max, 0}); });
    refuses(Status::out_of_range, "an impulse as large as any", [&](World<Yard>& w) { return w.apply_impulse(cast_.box, {F, F, F}, {1, 2, 3}); });
}

TEST_F(BadCalls, a_spin_beyond_all_numbers) {
    static World<Yard> world;
    clear(world);
    BodyDef def = plain_body({});
    def.mass.I_body = {scalar(0.01), scalar(0.01), scalar(0.01)};
    const BodyId id = world.add(def).value;
    BodyState state = world.state(id).value;
    state.L = {0, std::numeric_limits<scalar>::max(), 0};
    EXPECT_EQ(world.set_state(id, state), Status::out_of_range);
    EXPECT_EQ(world.state(id).value.L.y, 0);
}

TEST_F(BadCalls, a_collision_that_would_drive_a_body_beyond_the_limit_changes_neither) {
    World<Yard>& w = touched_;
    copy(w, world_);
    ASSERT_EQ(w.remove(cast_.spinner), Status::ok);
    ASSERT_EQ(w.remove(cast_.ball), Status::ok);
    BodyDef light = plain_body({10, 0, 100}), heavy = plain_body({0, 0, 100});
    light.mass = mass_of(scalar(1e-3), {1, 1, 1});
    light.state.v_CM = {-limits::speed_max * scalar(0.9), 0, 0};
    heavy.mass = mass_of(1000, {1, 1, 1});
    heavy.state.v_CM = {limits::speed_max * scalar(0.9), 0, 0};
    const BodyId id_light = w.add(light).value, id_heavy = w.add(heavy).value;
    static World<Yard> before;
    copy(before, w);
    EXPECT_EQ(w.collide(id_light, id_heavy, {5, 0, 100}, {1, 0, 0}, 1).status, Status::out_of_range);
    EXPECT_EQ(w.collide(id_heavy, id_light, {5, 0, 100}, {-1, 0, 0}, 1).status, Status::out_of_range);
    EXPECT_TRUE(same_bytes(w, before));
    EXPECT_GT(w.collide(id_light, id_heavy, {5, 0, 100}, {1, 0, 0}, 0).value, 0) << "without bounce both stay within";
}

TEST_F(BadCalls, collisions_that_cannot_be) {
    const Vector P{}, n{0, 0, 1};
    refuses(Status::bad_shape, "with itself", [&](World<Yard>& w) { return w.collide(cast_.box, cast_.box, P, n, 1).status; });
    refuses(Status::frozen, "first frozen", [&](World<Yard>& w) { return w.collide(cast_.frozen, cast_.box, P, n, 1).status; });
    refuses(Status::frozen, "second frozen", [&](World<Yard>& w) { return w.collide(cast_.box, cast_.frozen, P, n, 1).status; });
    refuses(Status::bad_direction, "a diagonal that is not normalised",
            [&](World<Yard>& w) { return w.collide(cast_.box, cast_.ball, P, {1, 1, 1}, 1).status; });
    copy(touched_, world_);
    const BodyId wall = touched_.add(ground()).value;
    static World<Yard> before;
    copy(before, touched_);
    EXPECT_EQ(touched_.collide(cast_.ground, wall, P, n, 1).status, Status::immovable);
    EXPECT_TRUE(same_bytes(touched_, before));
}

TEST_F(BadCalls, a_frozen_body_takes_nothing) {
    const BodyId id = cast_.frozen;
    refuses(Status::frozen, "set_state", [&](World<Yard>& w) { return w.set_state(id, Args().state); });
    refuses(Status::frozen, "add_force", [&](World<Yard>& w) { return w.add_force(id, {1, 0, 0}, {}); });
    refuses(Status::frozen, "add_central_force", [&](World<Yard>& w) { return w.add_central_force(id, {1, 0, 0}); });
    refuses(Status::frozen, "add_torque", [&](World<Yard>& w) { return w.add_torque(id, {1, 0, 0}); });
    refuses(Status::frozen, "apply_impulse", [&](World<Yard>& w) { return w.apply_impulse(id, {1, 0, 0}, {}); });
    refuses(Status::frozen, "apply_central_impulse", [&](World<Yard>& w) { return w.apply_central_impulse(id, {1, 0, 0}); });
    refuses(Status::frozen, "apply_angular_impulse", [&](World<Yard>& w) { return w.apply_angular_impulse(id, {1, 0, 0}); });
}

TEST_F(BadCalls, an_immovable_body_has_no_motion) {
    const BodyId id = cast_.ground;
    const auto set = [id](const Vector& v_CM, const Vector& L) {
        return [=](World<Yard>& w) {
            BodyState state{};
            state.v_CM = v_CM;
            state.L = L;
            return w.set_state(id, state);
        };
    };
    refuses(Status::immovable, "a velocity", set({0, smallest, 0}, {}));
    refuses(Status::immovable, "an angular momentum", set({}, {1, 0, 0}));
    refuses(Status::immovable, "add_force", [&](World<Yard>& w) { return w.add_force(id, {1, 0, 0}, {}); });
    refuses(Status::immovable, "add_central_force", [&](World<Yard>& w) { return w.add_central_force(id, {1, 0, 0}); });
    refuses(Status::immovable, "add_torque", [&](World<Yard>& w) { return w.add_torque(id, {1, 0, 0}); });
    refuses(Status::immovable, "apply_impulse", [&](World<Yard>& w) { return w.apply_impulse(id, {1, 0, 0}, {}); });
    refuses(Status::immovable, "apply_central_impulse", [&](World<Yard>& w) { return w.apply_central_impulse(id, {1, 0, 0}); });
    refuses(Status::immovable, "apply_angular_impulse", [&](World<Yard>& w) { return w.apply_angular_impulse(id, {1, 0, 0}); });

    const auto add = [](const Vector& v_CM, const Vector& L) {
        return [=](World<Yard>& w) {
            BodyDef def = ground();
            def.state.v_CM = v_CM;
            def.state.L = L;
            return w.add(def).status;
        };
    };
    accepts("at rest", add({}, {}));
    refuses(Status::immovable, "added with a velocity", add({1, 0, 0}, {}));
    refuses(Status::immovable, "added with an angular momentum", add({}, {0, 0, 1}));
    accepts("its mass is not looked at", [](World<Yard>& w) {
        BodyDef def = ground();
        def.mass = mass_of(nan_value, {-1, infinity, 0});
        return w.add(def).status;
    });
}

TEST_F(BadCalls, shapes_that_are_none) {
    const auto add = [](const Shape& shape, bool immovable) {
        return [=](World<Yard>& w) {
            BodyDef def = plain_body({1, 2, 3}, shape);
            def.immovable = immovable;
            return w.add(def).status;
        };
    };
    const scalar low = limits::size_min, high = limits::size_max, far = limits::position_max;
    for (const bool immovable : {false, true}) {
        accepts("the smallest box", add(ingot::Box{{low, low, low}}, immovable));
        accepts("the largest box", add(ingot::Box{{high, high, high}}, immovable));
        refuses(Status::bad_shape, "box too thin in x", add(ingot::Box{{below(low), 1, 1}}, immovable));
        refuses(Status::bad_shape, "box too long in y", add(ingot::Box{{1, beyond(high), 1}}, immovable));
        refuses(Status::bad_shape, "box without height", add(ingot::Box{{1, 1, 0}}, immovable));
        refuses(Status::bad_shape, "box inside out", add(ingot::Box{{1, -1, 1}}, immovable));
        refuses(Status::bad_shape, "ball inside out", add(ingot::Sphere{-1}, immovable));
        refuses(Status::bad_shape, "ball without radius", add(ingot::Sphere{0}, immovable));
        refuses(Status::bad_shape, "a kind that there is not", add({static_cast<ingot::ShapeKind>(200), {1, 1, 1}, 0}, immovable));
    }
    refuses(Status::bad_shape, "ground that can move", add(ingot::HalfSpace{{0, 0, 1}, 0}, false));
    accepts("ground as far as it goes", add(ingot::HalfSpace{{0, 0, 1}, far}, true));
    refuses(Status::out_of_range, "ground too far", add(ingot::HalfSpace{{0, 0, 1}, beyond(far)}, true));
    refuses(Status::out_of_range, "ground too deep", add(ingot::HalfSpace{{0, 0, 1}, beyond(-far)}, true));
    refuses(Status::bad_direction, "ground without a normal", add(ingot::HalfSpace{{0, 0, 0}, 0}, true));
    refuses(Status::bad_direction, "a normal too long", add(ingot::HalfSpace{{0, 0, 1 + 5 * ingot::epsilon}, 0}, true));
    refuses(Status::bad_direction, "a normal not normalised", add(ingot::HalfSpace{{1, 1, 1}, 0}, true));
    refuses(Status::bad_direction, "a normal whose square overflows", add(ingot::HalfSpace{{0, largest, 0}, 0}, true));
    refuses(Status::not_finite, "a normal that is no number", add(ingot::HalfSpace{{0, 0, nan_value}, 0}, true));
    refuses(Status::not_finite, "an offset that is no number", add(ingot::HalfSpace{{0, 0, 1}, infinity}, true));
}

TEST_F(BadCalls, contacts_are_read_by_index) {
    const auto contact = [](int index) { return [=](World<Yard>& w) { return w.contact(index).status; }; };
    const int count = world_.contact_count();
    for (int index = 0; index < count; ++index) EXPECT_TRUE(world_.contact(index).ok());
    for (const int index : {-1, count, count + 1, Yard::max_contacts, INT32_MAX, INT32_MIN})
        refuses(Status::out_of_range, "contact " + std::to_string(index), contact(index));
    for (const volatile int slot : {-1, Yard::max_bodies, INT32_MAX, INT32_MIN}) EXPECT_EQ(world_.body_at(slot), BodyId{}) << slot;
}

TEST_F(BadCalls, a_tag_is_for_a_world_that_never_had_a_body) {
    refuses(Status::not_empty, "set_tag", [](World<Yard>& w) { return w.set_tag(9); });
    World<Yard>& w = touched_;
    clear(w);
    EXPECT_EQ(w.set_tag(9), Status::ok);
    const BodyId id = w.add(plain_body({})).value;
    EXPECT_EQ(id.world_tag, 9);
    ASSERT_EQ(w.remove(id), Status::ok);
    EXPECT_EQ(w.set_tag(10), Status::not_empty) << "ids are out there";
    EXPECT_EQ(w.add(plain_body({})).value.world_tag, 9);
}

TEST_F(BadCalls, a_refused_step_reports_nothing_else) {
    for (const scalar bad : {scalar(0), nan_value, beyond(limits::step_max)}) {
        const StepReport report = ingot::step(world_, bad);
        EXPECT_EQ(report.status, Status::bad_step);
        EXPECT_FALSE(report.clean());
        StepReport expected{};
        expected.status = Status::bad_step;
        EXPECT_EQ(report.contacts, expected.contacts);
        EXPECT_EQ(report.bodies_frozen, 0);
        EXPECT_EQ(report.sweeps, 0);
    }
    EXPECT_EQ(world_.step_count(), 30u);
}

/// One body that only turns.
struct Satellite : ingot::Scene {};

TEST(BadCallsOfASmallScene, what_a_scene_does_not_name_is_not_in_it) {
    static World<Satellite> world, before;
    clear(world);
    BodyDef def = plain_body({});
    def.state.L = {1, 2, 3};

    const auto refused = [&](Status reason, const BodyDef& bad) {
        copy(before, world);
        EXPECT_EQ(world.add(bad).status, reason);
        EXPECT_TRUE(same_bytes(world, before));
    };
    BodyDef bad = def;
    bad.state.r_CM = {0, smallest, 0};
    refused(Status::not_in_scene, bad);
    bad = def;
    bad.state.v_CM = {1, 0, 0};
    refused(Status::not_in_scene, bad);
    for (const Shape shape : {Shape(ingot::Sphere{1}), Shape(ingot::Box{{1, 1, 1}})}) {
        bad = def;
        bad.shape = shape;
        refused(Status::not_in_scene, bad);
    }
    bad = ground();
    refused(Status::not_in_scene, bad);

    const BodyId id = world.add(def).value;
    refused(Status::no_room, def);
    BodyState state = world.state(id).value;
    state.r_CM = {1, 0, 0};
    copy(before, world);
    EXPECT_EQ(world.set_state(id, state), Status::not_in_scene);
    state.r_CM = {};
    state.v_CM = {0, 0, 1};
    EXPECT_EQ(world.set_state(id, state), Status::not_in_scene);
    EXPECT_TRUE(same_bytes(world, before));
    state.v_CM = {};
    EXPECT_EQ(world.set_state(id, state), Status::ok);
}

struct Balls : ingot::Scene {
    static constexpr int max_bodies = 3;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 4;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere>;
};
/// Names shapes, and no contacts for them.
struct Ghosts : Balls {
    static constexpr int max_contacts = 0;
};

TEST(BadCallsOfASmallScene, a_shape_that_the_scene_does_not_name) {
    static World<Balls> world, before;
    clear(world);
    EXPECT_EQ(world.add(plain_body({}, ingot::Box{{1, 1, 1}})).status, Status::not_in_scene);
    EXPECT_EQ(world.add(ground()).status, Status::not_in_scene);
    EXPECT_TRUE(same_bytes(world, before));
    EXPECT_TRUE(world.add(plain_body({}, ingot::Sphere{1})).ok());

    static World<Ghosts> ghosts, no_ghosts;
    clear(ghosts);
    EXPECT_EQ(ghosts.add(plain_body({}, ingot::Sphere{1})).status, Status::not_in_scene);
    EXPECT_TRUE(same_bytes(ghosts, no_ghosts));
    EXPECT_TRUE(ghosts.add(plain_body({})).ok());
}

}  // namespace
