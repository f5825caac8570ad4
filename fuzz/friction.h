// SPDX-License-Identifier: MIT
// Contacts with friction as a state machine: what machine.h demands, and beside it
//
//   Events pair up: what begins was apart, what ends had begun, hits and begins are of bodies that live and may meet; the overlaps are those
//   that entered and did not leave.
//   Where nothing but contacts acts, they keep the momentum, and solved point by point that of momentum too; where no impact bounces either, they
//   give no energy.
//   Queries find the living that their filter names, at finite places within their reach, on a surface.
//   A snapshot saves as the bytes it was loaded from, in the middle of a pile too, and steps to the bytes of the world that was never saved.
//   A world that is copied back is the world it was.
//   Who sleeps is at rest, and keeps its bits until it is awake.
//   Surfaces keep what they are told, rolling resistance and a velocity, and nobody else's; such a call is taken within its range.
//
// fuzz_fault breaks a promise: 1 to 5 are those of machine.h, 11 and on are its own.
#pragma once

#include "fuzz_world.h"
#include "machine.h"
#include "materials.h"

namespace fuzz { inline namespace INGOT_ABI {

using ingot::Event;
using ingot::EventKind;
using ingot::PlacedShape;
using ingot::QueryFilter;

/// Two bodies, by their ids, and which of their shapes.
struct Pair {
    BodyId A, B;
    int shape_A, shape_B;
    bool operator==(const Pair& other) const { return A == other.A && B == other.B && shape_A == other.shape_A && shape_B == other.shape_B; }
};

/// Pairs in no order.
struct Pairs {
    static constexpr int room = 128;
    Pair pairs[room];
    int count;

    int find(const Pair& pair) const {
        for (int i = 0; i < count; ++i)
            if (pairs[i] == pair) return i;
        return -1;
    }
    void add(const Pair& pair) {
        demand(count < room, "room for pairs, in the fuzzer");
        pairs[count++] = pair;
    }
    void remove(int i) { pairs[i] = pairs[--count]; }
};

template <class S>
class Friction : public Machine<S, Friction<S>> {
    using Base = Machine<S, Friction<S>>;
    friend Base;
    using Base::add;
    using Base::before_;
    using Base::demand_all;
    using Base::demand_report;
    using Base::edit;
    using Base::known_;
    using Base::only_changed;
    using Base::pick;
    using Base::refused;
    using Base::see_all;
    using Base::twin_;
    using Base::world_;
    static constexpr int N = S::max_bodies;

public:
    Friction() {
        memset(static_cast<void*>(&kept_), 0, sizeof kept_);
        memset(static_cast<void*>(&kept_state_), 0, sizeof kept_state_);
    }

private:
    /// What it knows, beside Base::Known.
    struct State {
        typename Base::Known known;
        Pairs touching, inside;
        bool events_whole;     ///< none was lost since the world was empty
        bool sensor[N][S::max_shapes_of_body];  ///< by slot and shape
        bool only_senses[N];   ///< all its shapes are sensors
        scalar mass[N];        ///< kg, by slot; 0: immovable
        double reach[N];       ///< m, by slot, of its shapes from its centre of mass
        double inertia[N];     ///< kg m^2, by slot, no less than about any axis
        bool isotropic[N];     ///< turning it changes no energy
        Materials<S> materials;
        bool bounces, pushed;  ///< some body has restitution; a force is due in the next step
        int manifolds;         ///< of the step before
        bool loaded;           ///< something but contacts acted in it
        bool driven;           ///< some surface moved
        double size;           ///< kg m/s, of it: see Balance
    };

    /// Scenes with sleep have three calls more, and after those, scenes whose surfaces roll or move two.
    static constexpr unsigned calls_of_sleep = S::sleeps ? 29 : 26;
    static constexpr unsigned calls = calls_of_sleep + (ingot::has_materials<S> ? 2 : 0);

    void call(Bytes& in) {
        const uint8_t op = in.byte();
        if (op % calls >= calls_of_sleep)
            set_material(in);
        else
            call(op % calls, in);
        state_.materials.demand_kept(world_);
    }
    void call(unsigned op, Bytes& in) {
        switch (op) {
            case 16: case 17: add_near(in); break;
            case 18: build(in); break;
            case 19: ask(in); break;
            case 20: set_filter(in); break;
            case 21: keep_or_go_back(in); break;
            case 22: through_a_snapshot(in); break;
            case 23: replace(in); break;
            case 24: case 25: this->step(in); break;
            case 26: case 27: case 28: sleep(op, in); break;
            default:
                if (op == 4 || op == 12 || op == 13) state_.pushed = true;
                Base::call(static_cast<uint8_t>(op), in);
                break;
        }
    }

    // Bodies.

    void add(Bytes& in) {
        BodyDef def;
        def.immovable = (in.byte() & 7u) == 0;
        def.mass = mass(in);
        def.state = in.state(true);
        if (def.immovable && in.byte() != 255) def.state.v_CM = def.state.L = {};
        def.shape = in.shape();
        add(def, in);
    }

    /// Of any kind that the scene has; half of them hulls, where it has some.
    static Shape any_shape(Bytes& in) {
        if constexpr (ingot::hulls_of<S>.count > 0)
            if ((in.byte() & 1u) != 0) return ingot::hull_of<S>(in.byte() % (ingot::hulls_of<S>.count + (in.byte() == 255 ? 2 : 0)));
        return in.any_shape();
    }

    /// What a body is made of.
    struct Build {
        int shape_count;
        bool sensor[S::max_shapes_of_body];
        double reach;  ///< m, from its centre of mass
    };
    static double reach_of(const Shape& shape, const Vector& r) {
        if (shape.kind == ShapeKind::half_space) return __builtin_inf();
        return __builtin_sqrt(static_cast<double>(ingot::length_sq(r))) + static_cast<double>(ingot::bounding_radius(shape));
    }

    /// One shape, or several where the scene has them: then the first is def.shape where it would be, and others of that surface are about it.
    /// Of a sensor that has several, some are.
    Result<BodyId> add_shapes(const BodyDef& def, Build& body, [[maybe_unused]] Bytes& in) {
        body = {def.shape.kind == ShapeKind::none ? 0 : 1, {def.sensor}, reach_of(def.shape, {})};
        if constexpr (S::max_shapes_of_body > 1) {
            ingot::ShapeDef parts[S::max_shapes_of_body];
            const int count = 1 + in.byte() % S::max_shapes_of_body;
            for (int i = 0; i < count; ++i) {
                parts[i].shape = i == 0 ? def.shape : any_shape(in);
                if (i > 0 && parts[i].shape.kind == ShapeKind::half_space && in.byte() != 255) parts[i].shape = ingot::Sphere{scalar(0.25)};
                if (i > 0) parts[i].r = in.vector(1);
                if (i > 0 && (in.byte() & 1u) != 0) parts[i].A = in.orientation();
                parts[i].restitution = def.restitution;
                parts[i].friction = def.friction;
                body.sensor[i] = parts[i].sensor = def.sensor && (in.byte() & 1u) == 0;
                const double reach = reach_of(parts[i].shape, parts[i].r);
                body.reach = reach > body.reach ? reach : body.reach;
            }
            BodyDef bare = def;
            bare.shape = {};
            bare.sensor = false;
            const Result<BodyId> added = world_.add(bare, parts, count);
            this->demand_added(added, def);
            body.shape_count = count;
            return added;
        } else {
            return Base::add(def);
        }
    }

    /// Moments as they come, or those of a ball.
    static ingot::MassProperties mass(Bytes& in) {
        ingot::MassProperties m = in.mass();
        if ((in.byte() & 1u) != 0) m.I_body = {m.I_body.x, m.I_body.x, m.I_body.x};
        return m;
    }

    void add(BodyDef& def, Bytes& in) {
        const uint8_t surface = in.byte();
        const bool bounces = (surface & 1u) != 0 && (S::bounces || in.byte() == 255);  // where nothing may, it is refused
        def.restitution = bounces ? magnitude(in.number(1)) : scalar(0);
        def.friction = (surface & 2u) != 0 ? magnitude(in.number(2)) : scalar(0.5);
        if (S::filters && (surface & 12u) == 12u) def.filter = {in.byte() & 7u, in.byte() & 7u};
        def.sensor = S::max_overlaps > 0 && (surface & 112u) == 112u;
        Build body{};
        const Result<BodyId> added = add_shapes(def, body, in);
        if (!added.ok()) return;
        demand(S::bounces || def.restitution == 0, "where nothing bounces, nothing is added that does");
        const int slot = added.value.slot;
        state_.materials.begin_body(slot, body.shape_count);
        state_.only_senses[slot] = body.shape_count > 0;
        for (int i = 0; i < S::max_shapes_of_body; ++i) {
            state_.sensor[slot][i] = body.sensor[i];
            if (i < body.shape_count && !body.sensor[i]) state_.only_senses[slot] = false;
        }
        state_.reach[slot] = body.reach;
        state_.inertia[slot] = static_cast<double>(def.mass.I_body.x + def.mass.I_body.y + def.mass.I_body.z);
        state_.mass[slot] = def.immovable ? 0 : def.mass.M;
        state_.isotropic[slot] = def.mass.I_body.x == def.mass.I_body.y && def.mass.I_body.y == def.mass.I_body.z;
        state_.bounces = state_.bounces || def.restitution > 0;
    }

    /// A body of about a metre where another is, or beside it.
    void add_near(Bytes& in) {
        const Result<BodyState> other = world_.state(pick(in));
        BodyDef def;
        def.mass = mass(in);
        def.shape = any_shape(in);
        def.immovable = def.shape.kind == ShapeKind::half_space || (in.byte() & 15u) == 0;
        if (other.ok()) def.state.r_CM = other.value.r_CM + in.vector(2);
        if ((in.byte() & 3u) == 0) def.state.A = in.orientation();
        if (!def.immovable && (in.byte() & 3u) == 0) def.state.v_CM = in.vector(20);
        if (!def.immovable && (in.byte() & 3u) == 0) def.state.L = in.vector(2);
        add(def, in);
    }

    /// The ground and what stands on it.
    void build(Bytes& in) {
        BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        if ((in.byte() & 1u) != 0) {
            add(ground, in);
            refused(world_.set_gravity({0, 0, scalar(-9.81)}));
        }
        for (int level = 0; level < 1 + (in.byte() & 3); ++level) {
            memcpy(static_cast<void*>(&before_), &world_, sizeof world_);
            BodyDef box;
            box.mass = {1 + magnitude(in.number(1)), {scalar(0.2), scalar(0.2), scalar(0.2)}, {}, ingot::identity_matrix<scalar>()};
            box.shape = (in.byte() & 1u) != 0 ? Shape(ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}}) : any_shape(in);
            box.state.r_CM = {in.number(scalar(0.1)), in.number(scalar(0.1)), scalar(0.5) + static_cast<scalar>(level)};
            add(box, in);
        }
    }

    /// Out with a body, and in with another in the same slot and place: it may be touching at the time.
    void replace(Bytes& in) {
        const BodyId id = world_.body_at(in.byte() % N);
        const Result<BodyState> was = world_.state(id);
        if (!was.ok()) return;
        const Status removed = world_.remove(id);
        demand(removed == Status::ok, "what lives can be removed");
        only_changed(id);
        memcpy(static_cast<void*>(&before_), &world_, sizeof world_);
        BodyDef def;
        def.mass = mass(in);
        def.shape = any_shape(in);
        def.immovable = def.shape.kind == ShapeKind::half_space;
        def.state = was.value;
        if (def.immovable || (in.byte() & 3u) != 0) def.state.v_CM = def.state.L = {};
        add(def, in);
    }

    void set_filter(Bytes& in) {
        if constexpr (S::filters) {
            const ingot::BodyFilter wanted = {in.byte() & 7u, in.byte() & 7u};
            edit(in, [&](BodyId id) {
                const Status status = world_.set_filter(id, wanted);
                if (status == Status::ok) {
                    const ingot::BodyFilter got = world_.filter(id).value;
                    demand(got.category == wanted.category && got.mask == wanted.mask, "a filter is kept");
                }
                return status;
            });
        }
    }

    // Surfaces.

    /// Rolling resistance or a velocity, of a shape that there is as a rule.
    void set_material([[maybe_unused]] Bytes& in) {
        if constexpr (ingot::has_materials<S>) {
            const uint8_t kind = in.byte();
            const int shape_i = kind < 192 ? kind % S::max_shapes_of_body : static_cast<int>(in.raw<int8_t>());
            const bool moves = S::surface_velocities && (!S::rolling_resistance || (kind & 1u) != 0);
            edit(in, [&](BodyId id) {
                const Status status = moves ? set_belt(id, shape_i, in.vector(8)) : set_lever(id, shape_i, scalar(0.25) + in.number(scalar(0.25)));
                if constexpr (S::sleeps) demand(status != Status::ok || !world_.is_asleep(id), "whose surface changes is awake");
                return status;
            });
        }
    }
    Status set_lever(BodyId id, int shape_i, scalar lever) {
        if constexpr (S::rolling_resistance) {
            const Status status = world_.set_rolling_resistance(id, lever, shape_i);
            demand_taken(status, id, shape_i, lever);
            if (status == Status::ok) state_.materials.lever[id.slot * S::max_shapes_of_body + shape_i] = lever;
            if (fuzz_fault == 16 && status == Status::ok) (void)world_.set_rolling_resistance(id, lever / 2, shape_i);
            return status;
        }
        return Status::ok;
    }
    Status set_belt(BodyId id, int shape_i, const Vector& velocity) {
        if constexpr (S::surface_velocities) {
            const Status status = world_.set_surface_velocity(id, velocity, shape_i);
            demand_taken(status, id, shape_i, velocity);
            if (status == Status::ok) state_.materials.belt[id.slot * S::max_shapes_of_body + shape_i] = velocity;
            if (fuzz_fault == 17 && status == Status::ok) (void)world_.set_surface_velocity(id, velocity * scalar(0.5), shape_i);
            return status;
        }
        return Status::ok;
    }
    template <class Number>
    void demand_taken(Status status, BodyId id, int shape_i, const Number& number) const {
        Status due = state_.materials.status_of(world_, id, shape_i);
        if (due == Status::ok) due = state_.materials.status_of(number);
        if (fuzz_fault == 18 && due == Status::not_finite) due = Status::out_of_range;
        demand(status == due, "what a surface is told is taken within its range");
    }

    // Time.

    /// Keeps the world, or goes back to the one that was kept.
    void keep_or_go_back(Bytes& in) {
        if ((in.byte() & 1u) == 0) {
            memcpy(static_cast<void*>(&kept_), &world_, sizeof world_);
            kept_state_ = state_;
            kept_state_.known = known_;
            return;
        }
        memcpy(static_cast<void*>(&world_), &kept_, sizeof world_);
        state_ = kept_state_;
        known_ = kept_state_.known;
        if (world_.step_count() == 0 && world_.body_count() == 0) state_.events_whole = true;
    }

    void through_a_snapshot([[maybe_unused]] Bytes& in) {
        if constexpr (S::max_events == 0) {
            static uint8_t bytes[ingot::snapshot_size<S>()], again[ingot::snapshot_size<S>()];
            const Result<size_t> saved = ingot::save_snapshot(world_, bytes, sizeof bytes);
            demand(saved.ok(), "a world fits into what snapshot_size says");
            demand(same_bytes(&world_, &before_, sizeof world_), "saving changes nothing");
            demand(ingot::load_snapshot(twin_, bytes, saved.value) == Status::ok, "what was saved can be loaded");
            expect_same_snapshot(bytes, again, saved.value, "what was loaded saves as the same bytes");
            state_.materials.demand_kept(twin_);

            const scalar h = in.step_length();
            StepReport report = INGOT_FUZZ_STEP(world_, h);
            const StepReport of_twin = ingot::step(twin_, h);
            if (fuzz_fault == 11 && report.status == Status::ok) (void)twin_.set_gravity({1, 2, 3});
            demand(report.status == of_twin.status && report.contacts == of_twin.contacts && report.sweeps == of_twin.sweeps &&
                       same_bytes(&report.residual, &of_twin.residual, sizeof report.residual),
                   "a loaded world reports the same");
            const Result<size_t> stepped_size = ingot::save_snapshot(world_, bytes, sizeof bytes);
            expect_same_snapshot(bytes, again, stepped_size.value, "a loaded world steps to the same bytes");
            if (report.status != Status::ok) return;
            demand_report(report);
            stepped(report, h);
        }
    }
    void expect_same_snapshot(const uint8_t* bytes, uint8_t* again, size_t size, const char* promise) {
        const Result<size_t> saved = ingot::save_snapshot(twin_, again, size);
        demand(saved.ok() && saved.value == size && same_bytes(bytes, again, size), promise);
    }

    // Sleep.

    void sleep([[maybe_unused]] unsigned op, [[maybe_unused]] Bytes& in) {
        if constexpr (S::sleeps) {
            if (op == 26) {
                edit(in, [&](BodyId id) { return world_.wake(id); });
            } else if (op == 27) {
                edit(in, [&](BodyId id) { return world_.sleep(id); });
            } else {
                // Long enough for what lies still to fall asleep.
                for (int i = 0; i < 40; ++i) {
                    memcpy(static_cast<void*>(&before_), &world_, sizeof world_);
                    const StepReport report = INGOT_FUZZ_STEP(world_, scalar(1) / 60);
                    demand(report.status == Status::ok, "a step of 1/60 s is taken");
                    demand_report(report);
                    stepped(report, scalar(1) / 60);
                    demand_all();
                }
            }
        }
    }

    /// In a step as long as sleep_time an island may wake, move and fall asleep again.
    void demand_sleep([[maybe_unused]] scalar h) {
        if constexpr (S::sleeps) {
            for (int slot = 0; slot < N; ++slot) {
                const BodyId id = world_.body_at(slot);
                const bool asleep = world_.is_asleep(id);
                see_all(asleep);
                if (!asleep) continue;
                const BodyState was = before_.state(id).value;
                BodyState is = world_.state(id).value;
                if (fuzz_fault == 15) is.v_CM.x = 1;
                demand(Base::is_zero(is.v_CM) && Base::is_zero(is.L), "who sleeps is at rest");
                demand(h >= S::sleep_time || !before_.is_asleep(id) || same_bytes(&was, &is, sizeof is), "who sleeps keeps its bits");
            }
        }
    }

    /// After each step.
    void stepped(const StepReport& report, scalar h) {
        demand(ingot::is_finite(report.residual) && report.residual >= 0, "the residual is a speed");
        constexpr int pairs_max = N * (N - 1) / 2 * S::max_shapes_of_body * S::max_shapes_of_body;
        demand(report.contacts + report.contacts_lost <= pairs_max, "a pair has one manifold");
        demand(report.contacts_lost == 0 || S::max_pairs < pairs_max || state_.manifolds + report.contacts >= S::max_manifolds,
               "contacts are lost when the array is full");
        see_all(report.overlaps_lost, report.events_lost, report.residual);
        state_.manifolds = report.contacts;
        demand_overlaps(report);
        demand_events(report);
        demand_sleep(h);
        demand_balance(report);
        state_.pushed = false;
    }

    void demand_overlaps(const StepReport& report) {
        if constexpr (ingot::has_sensors<S>) {
            demand(world_.overlap_count() <= S::max_overlaps, "overlaps fit");
            demand(report.overlaps_lost == 0 || world_.overlap_count() == S::max_overlaps, "overlaps are lost when the array is full");
            for (int i = 0; i < world_.overlap_count(); ++i) {
                const ingot::OverlapInfo overlap = world_.overlap(i).value;
                see_all(overlap.sensor, overlap.visitor);
                demand_meet(overlap.sensor, overlap.visitor);
                demand(overlap.sensor_shape >= 0 && overlap.sensor_shape < S::max_shapes_of_body && overlap.visitor_shape >= 0 &&
                           overlap.visitor_shape < S::max_shapes_of_body,
                       "an overlap names shapes of its bodies");
                demand(state_.sensor[overlap.sensor.slot][overlap.sensor_shape] && !state_.sensor[overlap.visitor.slot][overlap.visitor_shape],
                       "a body that is none is in a sensor");
            }
        }
    }

    /// Both live, and their filters let them.
    void demand_meet(BodyId A, BodyId B) const {
        demand(world_.is_alive(A) && world_.is_alive(B) && A != B, "two living bodies meet");
        if constexpr (S::filters) demand(ingot::meet(world_.filter(A).value, world_.filter(B).value), "bodies meet that their filters let");
    }

    void demand_events([[maybe_unused]] const StepReport& report) {
        if constexpr (ingot::has_events<S>) {
            const ingot::EventView events = world_.events();
            demand(events.count <= S::max_events, "events fit");
            demand(report.events_lost == 0 || events.count == S::max_events, "events are lost when the array is full");
            if (report.events_lost != 0) state_.events_whole = false;
            static const int order[] = {2, 0, 4, 3, 1};  // of begin, end, hit, enter, leave
            int order_before = 0;
            for (const Event& event : events) {
                see_all(event.kind, event.A, event.B, event.shape_A, event.shape_B, event.P, event.n, event.speed);
                const int now = order[static_cast<int>(event.kind)];
                demand(now >= order_before, "events come in their order");
                order_before = now;
                demand_event(event);
            }
            if (!state_.events_whole) return;
            constexpr int met_in_flight = S::continuous ? ingot::limits::flight_impacts_max : 0;  // and may be apart again
            demand(state_.touching.count <= report.contacts + met_in_flight, "what touches has a contact");
            if constexpr (ingot::has_sensors<S>) {
                demand(state_.inside.count == world_.overlap_count(), "who entered a sensor and did not leave is in it");
                for (int i = 0; i < world_.overlap_count(); ++i) {
                    const ingot::OverlapInfo overlap = world_.overlap(i).value;
                    const Pair pair = {overlap.sensor, overlap.visitor, overlap.sensor_shape, overlap.visitor_shape};
                    demand(state_.inside.find(pair) >= 0, "who is in a sensor has entered");
                }
            }
        }
    }

    void demand_event(const Event& event) {
        const Pair pair = {event.A, event.B, event.shape_A, event.shape_B};
        demand(event.shape_A < S::max_shapes_of_body && event.shape_B < S::max_shapes_of_body, "an event names shapes of its bodies");
        const bool of_sensor = event.kind == EventKind::enter || event.kind == EventKind::leave;
        const bool ends = event.kind == EventKind::end || event.kind == EventKind::leave;
        if (!ends) demand_meet(event.A, event.B);
        if (!ends && !of_sensor) {
            demand(!state_.sensor[event.A.slot][event.shape_A] && !state_.sensor[event.B.slot][event.shape_B], "sensors touch nothing");
            demand(ingot::is_finite(event.P) && ingot::is_finite(event.speed) && event.speed >= 0, "events have finite places and speeds");
            demand(magnitude(ingot::length_sq(event.n) - 1) <= 64 * ingot::epsilon, "the normal of an event is of unit length");
            demand(event.kind != EventKind::hit || event.speed > S::hit_speed, "hits are fast");
        }
        if (!state_.events_whole) return;
        Pairs& pairs = of_sensor ? state_.inside : state_.touching;
        const int at = pairs.find(pair);
        if (ends) {
            demand(at >= 0, "what ends has begun");
            if (fuzz_fault != 12) pairs.remove(at);
        } else if (event.kind == EventKind::hit) {
            demand(at >= 0, "what is hit touches");
        } else {
            demand(at < 0, "what begins was apart");
            pairs.add(pair);
        }
    }

    // Momentum and energy.

    /// Sums before or after a step, in double.
    struct Balance {
        double P[3], kinetic, size;  ///< kg m/s, J, and sum of sqrt(2 E M) + (slack_of_block + 2 w) M, kg m/s, w of the fastest surface
    };
    /// m/s; four points of one manifold have a compliance of rank 3: of what they push by, rows give each other that much more, and take it back.
    static constexpr double slack_of_block = static_cast<double>(limits::approach_slack) / static_cast<double>(limits::block_diagonal - 1);
    Balance balance_of(const World<S>& world) const {
        Balance sum{};
        sum.kinetic = static_cast<double>(world.kinetic_energy());
        for (int slot = 0; slot < N; ++slot) {
            const Result<BodyState> s = world.state(world.body_at(slot));
            if (!s.ok()) continue;
            const double M = static_cast<double>(state_.mass[slot]);
            sum.P[0] += M * static_cast<double>(s.value.v_CM.x);
            sum.P[1] += M * static_cast<double>(s.value.v_CM.y);
            sum.P[2] += M * static_cast<double>(s.value.v_CM.z);
            sum.size += __builtin_sqrt(2 * sum.kinetic * M) + (slack_of_block + 2 * state_.materials.fastest()) * M;
        }
        return sum;
    }

    /// Updates of a body in a step: normals, twist and friction, of all its manifolds, in sweeps and their extrapolations, and no more warm
    /// starts and kicks than sweeps. Waves of impacts have sweeps of their own; direct solves, at most direct_sets_max a substep.
    ///
    /// Solved point by point, a sweep visits a manifold once: rounds_of_points over its normals, friction, and the extrapolation. A twist does not
    /// update v. A substep that begins with the change of the one before begins with its roundings too: each counts up to once a substep.
    static double updates_in(const StepReport& report) {
        if constexpr (ingot::solves_pointwise<S>) {
            constexpr int visit = limits::rounds_of_points * ingot::Manifold::points_max + 4;  // of the four, two are warm start and kick
            return double{limits::substeps} * visit * report.sweeps * report.contacts;
        }
        const int direct = ingot::solves_directly<S> ? limits::substeps * limits::direct_sets_max : 0;
        const int rounds = report.sweeps + report.impact_waves * limits::sweeps_of_small + direct;
        return 4.0 * rounds * 3 * (N - 1) * S::max_shapes_of_body * S::max_shapes_of_body;
    }

    /// Where nothing but contacts acts.
    ///
    /// Each update of v rounds twice, by half an epsilon of the fastest a body of the energy can be; a sweep that has not ended may be twice
    /// that fast.
    /// Of bodies at rest the rounding of a target makes sweeps that push at up to approach_slack, by rows up to slack_of_block, and take it back.
    /// Two surfaces that move at w draw what they touch by up to 2 w, and a row by the mass of the lighter at most.
    /// Energy: with e = 0 an exact solve gives -j.K j / 2. The sweeps leave rows that are off by what the last one corrected, no more than
    /// settled_speed_of_small and 4 epsilon of the fastest where it was not the last allowed, times the rows beside it: four
    /// normals, twist and friction, and two of rolling resistance, whose turns count by the radius that makes a speed of them. That speed, times all
    /// impulses there can be, is what they may give. Surfaces that move may give any energy. For SequentialImpulses see off_by.
    ///
    /// A step begins with the impulses of the one before, which may have changed no speed at all: those that held a load that is gone, or
    /// that the bodies have been stopped since. Sweeps take them back, with the rounding of what they were. So the step before counts too,
    /// and must have been such a one.
    void demand_balance(const StepReport& report) {
        if constexpr (S::sleeps) return;  // who falls asleep leaves its momentum, up to M sleep_speed
        const Vector g = world_.gravity();
        bool isolated = !state_.pushed && g.x == 0 && g.y == 0 && g.z == 0 && report.bodies_frozen == 0, quiet = !state_.bounces;
        double lightest = 1e300;
        for (int slot = 0; slot < N; ++slot) {
            const BodyId id = world_.body_at(slot);
            if (id == BodyId{}) continue;
            const double M = static_cast<double>(state_.mass[slot]);
            isolated = isolated && M > 0 && !world_.is_frozen(id);
            quiet = quiet && state_.isotropic[slot];
            lightest = M < lightest ? M : lightest;
        }
        Balance was = balance_of(before_), is = balance_of(world_);
        const bool was_loaded = state_.loaded, driven = state_.driven || state_.materials.fastest() > 0;
        double size = was.size > is.size ? was.size : is.size;
        const double size_before = state_.size;
        state_.loaded = !isolated;
        state_.driven = state_.materials.fastest() > 0;
        state_.size = size;
        if (size_before > size) size = size_before;
        if (!isolated || was_loaded || report.contacts == 0) return;
        if (fuzz_fault == 13) is.P[0] += 0.1 * was.size;
        if (fuzz_fault == 14) is.kinetic *= 1.1;
        const double updates = updates_in(report);
        const double rounding = updates * 2 * static_cast<double>(ingot::epsilon) * size;
        for (int axis = 0; axis < 3; ++axis) demand(!(__builtin_fabs(is.P[axis] - was.P[axis]) > rounding), "contacts keep the momentum");
        if constexpr (ingot::solves_pointwise<S>) demand_moment(size, is.kinetic > was.kinetic ? is.kinetic : was.kinetic, updates);
        if (!quiet || driven || report.sweeps >= (ingot::solves_pointwise<S> ? limits::sweeps_of_points : limits::sweeps_of_small)) return;
        const double fastest = __builtin_sqrt(2 * was.kinetic / lightest);
        const double given = limits::substeps * off_by(report, fastest) * size + updates * 2 * static_cast<double>(ingot::epsilon) * was.kinetic;
        demand(!(is.kinetic - was.kinetic > given), "contacts give no energy");
    }

    /// What contacts give is given at one point to both, with levers as they were at the begin of the step: the sum over the bodies of
    /// r_CM x M (change of v_CM) + (change of L) is 0 but for rounding. `size` and `kinetic` as in Balance.
    ///
    /// An update gives a body up to 2 sqrt(2 E M). v_CM rounds as above, with r_CM as its lever. A lever P - r_CM rounds once, the moment of it by
    /// two products and their difference: 6 half epsilons are more than both. P is no further off than two bodies are apart, and a reach of its own
    /// and two of whom it is deep in. L, up to 2 sqrt(2 E I), rounds once.
    void demand_moment(double size, double kinetic, double updates) const {
        double sum[3] = {}, away = 0, reach = 0, spin = 0;
        for (int slot = 0; slot < N; ++slot) {
            const Result<BodyState> was = before_.state(world_.body_at(slot)), is = world_.state(world_.body_at(slot));
            if (!is.ok()) continue;
            const double M = static_cast<double>(state_.mass[slot]);
            double r[3], p[3], r_size_sq = 0;
            for (int axis = 0; axis < 3; ++axis) {
                r[axis] = in_double(was.value.r_CM, axis);
                p[axis] = M * (in_double(is.value.v_CM, axis) - in_double(was.value.v_CM, axis));
                r_size_sq += r[axis] * r[axis];
            }
            for (int axis = 0; axis < 3; ++axis) {
                const int next = (axis + 1) % 3, last = (axis + 2) % 3;
                sum[axis] += r[next] * p[last] - r[last] * p[next] + in_double(is.value.L, axis) - in_double(was.value.L, axis);
            }
            away = r_size_sq > away * away ? __builtin_sqrt(r_size_sq) : away;
            reach = state_.reach[slot] > reach ? state_.reach[slot] : reach;
            spin += __builtin_sqrt(2 * kinetic * state_.inertia[slot]);
        }
        if (fuzz_fault == 19) sum[0] += 0.1 * size * away;
        const double eps = static_cast<double>(ingot::epsilon);
        const double rounding = updates * eps * (2 * size * away + 3 * 2 * size * (2 * away + 3 * reach) + spin);
        for (const double off : sum) demand(!(__builtin_fabs(off) > rounding), "contacts keep the angular momentum");
    }
    static double in_double(const Vector& v, int axis) { return static_cast<double>(axis == 0 ? v.x : axis == 1 ? v.y : v.z); }

    /// m/s, that the last sweep leaves rows off by; `fastest`: m/s, what a body can go at.
    ///
    /// SequentialImpulses leave alone what is off by ignored_speed, and correct the rows beside it by no more than settled_speed_of_points in the
    /// last sweep, each normal once in each of the rounds. To both, what 4 epsilon of the fastest makes.
    static double off_by(const StepReport& report, double fastest) {
        const double rounding = 4 * static_cast<double>(ingot::epsilon) * fastest;
        if constexpr (ingot::solves_pointwise<S>) {
            constexpr int rows = limits::rounds_of_points * ingot::Manifold::points_max + 2;
            return (static_cast<double>(limits::settled_speed_of_points) + rounding) * rows * report.contacts +
                   static_cast<double>(limits::ignored_speed) + rounding;
        }
        constexpr int rows = S::rolling_resistance ? 8 : 6;
        return (static_cast<double>(limits::settled_speed_of_small) + rounding) * rows * (N - 1);
    }

    // Queries.

    void ask(Bytes& in) {
        QueryFilter filter;
        const uint8_t kind = in.byte();
        if ((kind & 4u) != 0) filter.filter = {in.byte() & 7u, in.byte() & 7u};
        if ((kind & 8u) != 0) filter.except = pick(in);
        filter.sensors = (kind & 16u) != 0;
        const World<S>& world = world_;
        const bool except_lives = filter.except.generation == 0 || world.is_alive(filter.except);
        const Vector from = in.vector(8);
        const PlacedShape shape = {any_shape(in), from, in.orientation(), nullptr};
        switch (kind & 3u) {
            case 0: {
                const Vector way = in.vector(16);
                const Result<ingot::QueryHit> hit = world.cast_ray(from, way, filter);
                demand(!hit.ok() || except_lives, "a query does not leave out the dead");
                demand_hit(hit, filter);
                if (hit.ok() && hit.value.found()) demand_on_surface(hit.value, from, way, filter);
                break;
            }
            case 1: demand_hit(world.cast_shape(shape, in.vector(16), filter), filter); break;
            case 2: {
                BodyId found[N];
                const int capacity = in.byte() % (N + 1);
                const Result<int> count = world.find_overlaps(shape, found, capacity, filter);
                see_all(count.status, count.value);
                demand(count.value >= 0 && count.value <= world.body_count(), "no more overlap than there are");
                for (int i = 0; i < count.value && i < capacity; ++i) {
                    demand_seen(found[i], filter);
                    demand(i == 0 || found[i - 1].slot < found[i].slot, "overlaps come in the order of slots");
                }
                break;
            }
            default: {
                const scalar within = magnitude(in.number(8));
                const Result<ingot::QueryNearest> nearest = world.find_nearest(from, within, filter);
                see_all(nearest.status, nearest.value.body, nearest.value.distance, nearest.value.P, nearest.value.n);
                demand(ingot::is_finite(nearest.value.distance) && ingot::is_finite(nearest.value.P) && ingot::is_finite(nearest.value.n),
                       "what a query finds is finite");
                if (!nearest.ok() || !nearest.value.found()) break;
                demand_seen(nearest.value.body, filter);
                demand(nearest.value.distance <= within, "what is nearest is near enough");
                break;
            }
        }
        demand(same_bytes(&world_, &before_, sizeof world_), "a query changes nothing");
    }

    void demand_hit(const Result<ingot::QueryHit>& hit, const QueryFilter& filter) {
        see_all(hit.status, hit.value.body, hit.value.fraction, hit.value.P, hit.value.n);
        demand(ingot::is_finite(hit.value.P) && ingot::is_finite(hit.value.n) && hit.value.fraction >= 0 && hit.value.fraction <= 1,
               "what a query finds is finite");
        if (!hit.ok() || !hit.value.found()) return;
        demand_seen(hit.value.body, filter);
        demand(magnitude(ingot::length_sq(hit.value.n) - 1) <= 64 * ingot::epsilon, "the normal of a hit is of unit length");
    }

    void demand_seen(BodyId id, const QueryFilter& filter) const {
        demand(world_.is_alive(id), "a query finds the living");
        demand(id != filter.except, "a query leaves out whom it is told to");
        demand(filter.sensors || !state_.only_senses[id.slot], "a query sees sensors when it is told to");
        if constexpr (S::filters) demand(ingot::meet(world_.filter(id).value, filter.filter), "a query finds whom its filter lets");
    }

    /// Two oracles: no body is nearer to where a ray ends than rounding, seen by the routine for nearest points; and there is one.
    void demand_on_surface(const ingot::QueryHit& hit, const Vector& from, const Vector& way, const QueryFilter& filter) const {
        const auto size = [](const Vector& v) { return magnitude(v.x) + magnitude(v.y) + magnitude(v.z); };
        const scalar scale = size(from) + size(way) + size(world_.state(hit.body).value.r_CM);
        if (!(scale < 1000)) return;
        const Result<ingot::QueryNearest> nearest = world_.find_nearest(hit.P, 1, filter);
        const scalar slack = 256 * ingot::epsilon * (scale + 8);
        demand(nearest.ok() && nearest.value.found() && nearest.value.distance <= slack, "a ray ends on a surface");
        if (hit.fraction > 0) demand(nearest.value.distance >= -slack * 4, "a ray ends on the first surface");
    }

    static World<S> kept_;
    static State kept_state_;
    State state_ = {{}, {}, {}, true, {}, {}, {}, {}, {}, {}, {}, false, false, 0, false, false, 0};
};

template <class S>
World<S> Friction<S>::kept_;
template <class S>
typename Friction<S>::State Friction<S>::kept_state_ = {};

} }  // namespace fuzz
