// SPDX-License-Identifier: MIT
// The whole interface as a state machine: bytes become calls, and after each call the promises are asked for.
//
//   A refused call leaves the world bitwise unchanged, and so does a call that only reads.
//   A call that is about one body changes no other by a bit.
//   Whatever the calls were: places within limits::position_max, orientations orthonormal, no number that is not finite.
//   A report says what happened: capacities, bounds of iterations, bodies frozen.
//   An id names its body while it lives and nothing afterwards.
//   A copy of the world steps to the same bytes.
//   Every lane count gives the same answers to the bit (fuzz_main.cpp).
//
// fuzz_fault breaks a promise on purpose, so that a test can see that the oracle notices (CMakeLists.txt).
#pragma once

#include "bytes.h"
#include "fuzz_world.h"

namespace fuzz { inline namespace INGOT_ABI {

/// How far A may be from orthonormal: |A^T A - 1| by entries.
///
/// Whatever the method, A is one that the door takes for a rotation: a state that was read can be set.
/// The default method is held to its rounding: 4 epsilon from the door. A substep adds A (R - 1), |R - 1| <= 2, in at most 12
/// roundings an entry, a step has up to substeps_max of them, and the defect is taken back every polar_interval steps, up to
/// the rounding of A itself. A defect of an entry counts twice in A^T A.
template <class Method>
constexpr scalar defect_max = limits::orthogonality;
template <>
constexpr scalar defect_max<ingot::MoserVeselov> = scalar(2 * 12 * 2) * ingot::epsilon * limits::substeps_max * limits::polar_interval;

/// Calls and promises of every scene. A fuzzer that knows more calls inherits it and names itself as Whole: see fuzz_friction.cpp.
template <class S, class Whole = void>
class Machine {
public:
    Machine() {
        memset(static_cast<void*>(&world_), 0, sizeof world_);
        memset(static_cast<void*>(&before_), 0, sizeof before_);
        memset(static_cast<void*>(&twin_), 0, sizeof twin_);
    }

    /// Answers with a hash of all that was seen.
    uint64_t run(Bytes in) {
        while (!in.empty()) {
            memcpy(static_cast<void*>(&before_), &world_, sizeof world_);
            whole().call(in);
            demand_all();
        }
        return seen_;
    }

protected:
    static constexpr int known_max = 64;

    /// What the fuzzer knows of the world from the calls it made.
    struct Known {
        BodyId ids[known_max];
        int id_count;
        bool immovable[S::max_bodies];  ///< by slot
    };

    auto& whole() {
        if constexpr (ingot::stacks<S>)
            return static_cast<Whole&>(*this);
        else
            return *this;
    }

    void call(Bytes& in) { call(in.byte(), in); }
    void call(uint8_t op, Bytes& in) {
        switch (op % 16u) {
            case 0: case 1: whole().add(in); break;
            case 2: remove(in); break;
            case 3: set_state(in); break;
            case 4: edit(in, [&](BodyId id) { return world_.add_torque(id, in.vector(10)); }); break;
            case 5: edit(in, [&](BodyId id) { return world_.apply_angular_impulse(id, in.vector(2)); }); break;
            case 6: read(in); break;
            case 7: tag(in); break;
            case 8: replay(in); break;
            case 9: case 10: case 11: step(in); break;
            default:
                if constexpr (S::translates) move(op % 16u, in);
                break;
        }
    }

    void move(unsigned op, Bytes& in) {
        switch (op) {
            case 12: {
                const Vector P = in.vector(4);
                if ((in.byte() & 1u) != 0)
                    edit(in, [&](BodyId id) { return world_.add_force(id, in.vector(20), P); });
                else
                    edit(in, [&](BodyId id) { return world_.apply_impulse(id, in.vector(4), P); });
                break;
            }
            case 13:
                if ((in.byte() & 1u) != 0)
                    edit(in, [&](BodyId id) { return world_.add_central_force(id, in.vector(20)); });
                else
                    edit(in, [&](BodyId id) { return world_.apply_central_impulse(id, in.vector(4)); });
                break;
            case 14: collide(in); break;
            default: gravity(in); break;
        }
    }

    // The calls.

    void add(Bytes& in) {
        BodyDef def;
        def.immovable = (in.byte() & 7u) == 0;
        def.mass = in.mass();
        def.state = in.state(S::translates);
        if (def.immovable && in.byte() != 255) def.state.v_CM = def.state.L = {};
        def.shape = ingot::has_shapes<S> || in.byte() == 255 ? in.shape() : Shape{};
        def.restitution = magnitude(in.number(1));
        (void)add(def);
    }

    Result<BodyId> add(const BodyDef& def) {
        const Result<BodyId> added = world_.add(def);
        demand_added(added, def);
        return added;
    }
    void demand_added(const Result<BodyId>& added, const BodyDef& def) {
        refused(added.status);
        if (added.status == Status::no_room) demand(before_.body_count() == S::max_bodies, "no_room means full");
        if (!added.ok()) {
            demand(added.value == BodyId{}, "a refused add gives the null id");
            return;
        }
        demand(!before_.is_alive(added.value), "a new body gets a new id");
        demand(world_.body_count() == before_.body_count() + 1, "add adds one body");
        demand(!world_.is_frozen(added.value), "a new body is not frozen");
        for (int id_i = 0; id_i < known_.id_count; ++id_i) demand(known_.ids[id_i] != added.value, "an id is given out once");
        only_changed(added.value);
        known_.immovable[added.value.slot] = def.immovable;
        if (known_.id_count < known_max) known_.ids[known_.id_count++] = added.value;
    }

    void remove(Bytes& in) {
        const BodyId id = pick(in);
        const bool lived = world_.is_alive(id);
        const Status status = world_.remove(id);
        refused(status);
        demand(lived == (status == Status::ok), "remove takes out what lives, and nothing else");
        demand(!world_.is_alive(id), "a removed id is dead");
        demand(world_.remove(id) != Status::ok, "nothing is removed twice");
        demand(world_.body_count() == before_.body_count() - (lived ? 1 : 0), "remove takes out one body");
        if (status == Status::ok) only_changed(id);
    }

    void set_state(Bytes& in) {
        const BodyId id = pick(in);
        const BodyState wanted = in.state(S::translates);
        const Status status = world_.set_state(id, wanted);
        refused(status);
        if (status != Status::ok) return;
        only_changed(id);
        const BodyState got = world_.state(id).value;
        demand(within(got.v_CM, limits::speed_max), "a state that was set keeps the speed limit");
        demand(ingot::orthogonality_error(got.A) <= 6 * ingot::epsilon, "an orientation that was set is orthonormal");
    }

    /// A call about one body that answers with a Status.
    template <class Call>
    void edit(Bytes& in, Call make) {
        const BodyId id = pick(in);
        const Status status = make(id);
        refused(status);
        if (status != Status::ok) return;
        only_changed(id);
        const BodyState was = before_.state(id).value, is = world_.state(id).value;
        demand(same_bytes(&was.v_CM, &is.v_CM, sizeof is.v_CM) || within(is.v_CM, limits::speed_max),
               "a velocity that a call changed keeps the speed limit");
    }

    void collide(Bytes& in) {
        const BodyId A = pick(in), B = pick(in);
        const Vector P = in.vector(4), n = in.direction();
        const scalar e = magnitude(in.number(1));
        const Result<scalar> j = world_.collide(A, B, P, n, e);
        refused(j.status);
        demand(j.ok() || j.value == 0, "a refused collision has no impulse");
        if (!j.ok()) return;
        demand(ingot::is_finite(j.value) && j.value >= 0, "bodies push, they do not pull");
        only_changed(A, B);
    }

    void gravity(Bytes& in) {
        const Vector g = in.vector(10);
        const Status status = world_.set_gravity(g);
        refused(status);
        demand((status == Status::ok) == within(g, limits::gravity_max), "gravity is taken within its range");
        if (status == Status::ok) only_changed(BodyId{});
    }

    void tag(Bytes& in) {
        const Status status = world_.set_tag(in.raw<uint16_t>());
        refused(status);
        demand(status == (known_.id_count == 0 ? Status::ok : Status::not_empty), "a tag is for a world without ids");
    }

    void step(Bytes& in) {
        int count = 1 + (in.byte() & 7u);
        const scalar h = in.step_length();
        for (; count > 0; --count) {
            memcpy(static_cast<void*>(&before_), &world_, sizeof world_);
            StepReport report = INGOT_FUZZ_STEP(world_, h);
            if (fuzz_fault == 3) ++report.bodies_frozen;
            refused(report.status);
            demand((report.status == Status::ok) == (h >= limits::step_min && h <= limits::step_max), "h is taken within its range");
            if (report.status != Status::ok) return;
            demand_report(report);
            whole().stepped(report, h);
            demand_all();
        }
    }
    void stepped(const StepReport&, scalar) {}

    void see(const void* data, size_t size) {
        const unsigned char* bytes = static_cast<const unsigned char*>(data);
        for (size_t byte_i = 0; byte_i < size; ++byte_i) seen_ = (seen_ ^ bytes[byte_i]) * 0x100000001b3u;
    }
    template <class... Numbers>
    void see_all(const Numbers&... numbers) {
        (see(&numbers, sizeof numbers), ...);
    }

    void demand_report(const StepReport& report) {
        see_all(report.bodies_frozen, report.spins_clamped, report.contacts, report.contacts_lost, report.pairs_untested,
                report.impact_waves, report.impacts_deferred, report.sweeps, report.sweeps_unfinished);
        demand(world_.step_count() == before_.step_count() + 1, "a step counts one");
        demand(world_.body_count() == before_.body_count(), "a step neither adds nor removes");
        int frozen = 0, movable = 0;
        for (int slot = 0; slot < S::max_bodies; ++slot) {
            const BodyId id = world_.body_at(slot);
            demand(id == before_.body_at(slot), "a step keeps ids");
            if (id == BodyId{}) continue;
            ++movable;
            demand(world_.is_frozen(id) || !before_.is_frozen(id), "frozen is for ever");
            const BodyState was = before_.state(id).value, is = world_.state(id).value;
            if (known_.immovable[slot]) demand(same_bytes(&was, &is, sizeof is), "an immovable body stands still");
            if (!world_.is_frozen(id)) continue;
            demand(!known_.immovable[slot], "only what moves can freeze");
            if (before_.is_frozen(id)) {
                demand(same_bytes(&was, &is, sizeof is), "a frozen body stands still");
                continue;
            }
            ++frozen;
            demand(is_zero(is.v_CM) && is_zero(is.L), "a body freezes at rest");
        }
        demand(report.bodies_frozen == frozen, "every body that froze is reported");
        demand(report.spins_clamped <= movable, "at most every body is clamped");
        // Of contacts with friction, in every substep, of which islands in which something spins fast have four times as many; calm steps that are
        // calm no more begin again, with all of theirs, but for those of points.
        // A body that is followed has as many again at each of its impacts.
        constexpr int begun_again = ingot::solves_pointwise<S> ? 0 : limits::steady_substeps;
        constexpr int substeps = (begun_again + 4 * limits::substeps) * (S::continuous ? limits::impacts_of_body_max * S::max_bodies + 1 : 1);
        const int contacts = report.contacts + (S::continuous ? limits::pair_manifolds_max : 0);  // those that meet in flight have their own
        const int waves_of_stacks = ingot::solves_pointwise<S> ? 0 : substeps * limits::impacts_of_contact * contacts;
        // Without friction impacts come one after another within the step, each with its waves: follow_impacts in kernel/impulse/impacts_in_step.h.
        const int impacts_max = limits::impacts_in_step_max * report.contacts;
        const int waves_max = ingot::stacks<S> ? waves_of_stacks : impacts_max * limits::impact_waves_max;
        demand(report.impact_waves <= waves_max, "waves are bounded");
        // Islands that give energy are swept again, and so are those with bounces that do.
        constexpr int rounds = 1 + limits::gaining_rounds + (S::bounces ? limits::bounce_rounds : 0);
        constexpr int in_a_substep = ingot::solves_pointwise<S> ? limits::sweeps_of_points : limits::sweeps_of_small * rounds;
        // Without friction each wave is solved, what is held until an impact, and what presses at the end.
        const int solves_of_impacts = report.impact_waves + impacts_max + 1;
        const int sweeps_max = ingot::stacks<S> ? substeps * in_a_substep : limits::contact_sweeps_max * solves_of_impacts;
        demand(report.sweeps <= sweeps_max, "sweeps are bounded");
        // An island has a body that moves, and is solved at most twice: calm, and again.
        const int flights = substeps / (begun_again + limits::substeps);
        const int solves = ingot::stacks<S> ? (ingot::solves_pointwise<S> ? 1 : 2) * movable * flights : solves_of_impacts;
        demand(report.sweeps_unfinished <= solves, "at most every solve is unfinished");
        // With friction, a substep that leaves some contacts has had impacts_of_contact waves for each of them; fast bodies wait beside that.
        const int left_max = report.impact_waves / limits::impacts_of_contact + (S::continuous ? movable : 0);
        const bool ran_out = ingot::stacks<S> ? report.impacts_deferred <= left_max : report.impact_waves > 0;
        demand(report.impacts_deferred == 0 || ran_out, "impacts are left when waves run out");
        // Without friction a contact is left where it would bounce, and where it approaches, as the waves of an impact run out; and three times when
        // its own impacts do.
        demand(ingot::stacks<S> || report.impacts_deferred <= report.contacts * (2 * impacts_max + 3), "contacts are left at their impacts");
        demand(report.contacts <= S::max_contacts + S::max_manifolds, "contacts fit");
        demand(ingot::stacks<S> || report.contacts_lost == 0 || report.contacts == S::max_contacts, "contacts are lost when the array is full");
        demand(report.pairs_untested <= S::max_bodies * (S::max_bodies - 1) / 2 * S::max_shapes_of_body * S::max_shapes_of_body,
               "at most every pair is untested");
        if constexpr (S::max_contacts > 0) demand(world_.contact_count() == report.contacts, "contacts are those reported");
    }

    /// A copy at another address steps to the same bytes, and reports the same.
    void replay(Bytes& in) {
        const scalar h = in.step_length();
        memcpy(static_cast<void*>(&twin_), &world_, sizeof world_);
        const StepReport of_twin = ingot::step(twin_, h);
        demand(same_bytes(&world_, &before_, sizeof world_), "worlds share nothing");
        const StepReport report = INGOT_FUZZ_STEP(world_, h);
        demand(report.status == of_twin.status && report.contacts == of_twin.contacts && report.sweeps == of_twin.sweeps,
               "a copy reports the same");
        if (fuzz_fault == 5) flip_a_bit(twin_);
        demand(same_bytes(&world_, &twin_, sizeof world_), "a copy steps to the same bytes");
        if (report.status != Status::ok) return;
        demand_report(report);
        whole().stepped(report, h);
    }

    /// Reads with any id: a reading changes nothing, and answers for the living only.
    void read(Bytes& in) {
        const BodyId id = pick(in);
        const int index = in.raw<int32_t>();
        const World<S>& world = world_;
        const bool lives = world.is_alive(id);
        demand(world.state(id).ok() == lives && world.omega(id).ok() == lives && world.kinetic_energy(id).ok() == lives &&
                   world.linear_momentum(id).ok() == lives && world.angular_momentum(id).ok() == lives,
               "readings answer for the living");
        demand(lives || !world.is_frozen(id), "the dead are not frozen");
        demand(world.body_at(index) == BodyId{} || world.is_alive(world.body_at(index)), "body_at names the living");
        if constexpr (ingot::has_shapes<S>) {
            demand(world.contact(index).ok() == (index >= 0 && index < world.contact_count()), "contacts have indices");
            int count = 0, of_body = 0;
            for (const ingot::ContactInfo& contact : world.contacts()) {
                demand(world.is_alive(contact.A) && world.is_alive(contact.B), "the living touch");
                of_body += contact.A == id || contact.B == id ? 1 : 0;
                ++count;
            }
            demand(count == world.contact_count(), "contacts are counted");
            for (const ingot::ContactInfo& contact : world.contacts_of(id)) of_body -= contact.A == id || contact.B == id ? 1 : 0;
            demand(of_body == 0, "those of a body are told of it");
        }
        demand(same_bytes(&world_, &before_, sizeof world_), "a reading changes nothing");
    }

    // The promises.

    void refused(Status status) {
        see_all(status);
        if (fuzz_fault == 4) see_all(ingot::lanes);
        if (status == Status::ok) return;
        if (fuzz_fault == 1) flip_a_bit(world_);
        demand(same_bytes(&world_, &before_, sizeof world_), "a refused call leaves the world bitwise unchanged");
    }

    void only_changed(BodyId a, BodyId b = BodyId{}) {
        for (int slot = 0; slot < S::max_bodies; ++slot) {
            const BodyId id = before_.body_at(slot);
            if (id == BodyId{} || id == a || id == b) continue;
            demand(world_.is_alive(id), "a call about one body removes no other");
            const BodyState was = before_.state(id).value, is = world_.state(id).value;
            demand(same_bytes(&was, &is, sizeof is), "a call about one body moves no other");
            const Vector omega_was = before_.omega(id).value, omega_is = world_.omega(id).value;
            demand(same_bytes(&omega_was, &omega_is, sizeof omega_is), "a call about one body turns no other");
        }
    }

    void demand_all() {
        if (fuzz_fault == 2) overwrite_A(scalar(1.5));
        int count = 0;
        for (int slot = 0; slot < S::max_bodies; ++slot) {
            const BodyId id = world_.body_at(slot);
            if (id == BodyId{}) continue;
            ++count;
            demand_body(id);
        }
        demand(count == world_.body_count(), "body_count counts the living");
        for (int id_i = 0; id_i < known_.id_count; ++id_i) {
            const BodyId id = known_.ids[id_i];
            demand(world_.is_alive(id) == (world_.body_at(id.slot) == id), "an id lives in its slot or not at all");
            BodyId foreign = id;
            ++foreign.world_tag;
            demand(world_.state(foreign).status == Status::foreign_id, "an id with another tag is foreign");
        }
        if constexpr (S::max_contacts > 0) demand_contacts();
        demand(ingot::is_finite(world_.kinetic_energy()) && world_.kinetic_energy() >= 0, "the energy is finite and not negative");
        demand(ingot::is_finite(world_.linear_momentum()) && ingot::is_finite(world_.angular_momentum()), "momenta are finite");
    }

    void demand_body(BodyId id) {
        const BodyState s = world_.state(id).value;
        const Vector omega = world_.omega(id).value;
        see_all(s, omega);
        demand(within(s.r_CM, limits::position_max), "a body stays within limits::position_max");
        demand(ingot::is_finite(s.v_CM), "v_CM is finite");
        demand(ingot::is_finite(s.L), "L is finite");
        demand(ingot::is_finite(omega), "omega is finite");
        demand(ingot::orthogonality_error(s.A) <= defect_max<typename S::rotation>, "A is orthonormal");
        demand(ingot::determinant(s.A) > 0, "A is a rotation");
    }

    void demand_contacts() {
        for (int contact_i = 0; contact_i < world_.contact_count(); ++contact_i) {
            const Result<ingot::ContactInfo> contact = world_.contact(contact_i);
            demand(contact.ok(), "a contact below the count can be read");
            const ingot::ContactInfo& c = contact.value;
            see_all(c.A, c.B, c.n, c.separation, c.j);
            demand(world_.is_alive(c.A) && world_.is_alive(c.B) && c.A != c.B, "a contact is of two living bodies");
            demand(magnitude(ingot::length_sq(c.n) - 1) <= 16 * ingot::epsilon, "the normal of a contact is of unit length");
            demand(ingot::is_finite(c.separation) && ingot::is_finite(c.j) && c.j >= 0, "contacts push, with a finite impulse");
        }
    }

    // Help.

    static bool is_zero(const Vector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }
    static bool within(const Vector& v, scalar limit) {
        return magnitude(v.x) <= limit && magnitude(v.y) <= limit && magnitude(v.z) <= limit;
    }

    /// Mostly an id that lives or lived, at times null, at times any bits.
    BodyId pick(Bytes& in) {
        const uint8_t kind = in.byte();
        if (kind < 128) return world_.body_at(kind % S::max_bodies);
        if (kind < 240) return known_.id_count > 0 ? known_.ids[kind % known_.id_count] : BodyId{};
        if (kind < 244) return BodyId{};
        BodyId id = known_.id_count > 0 ? known_.ids[0] : BodyId{};
        if (kind < 248) id.generation += in.byte();
        else if (kind < 250) id.slot = in.raw<ingot::Index>();
        else if (kind < 252) id.world_tag = in.raw<uint16_t>();
        else id = in.raw<BodyId>();
        return id;
    }

    // Faults.

    static void flip_a_bit(World<S>& world) { reinterpret_cast<unsigned char*>(&world)[sizeof world / 2] ^= 1u; }

    /// Overwrites an entry of A of the first body where the world keeps it.
    static void overwrite_A(scalar with) {
        const BodyId id = world_.body_at(0);
        const Result<BodyState> s = world_.state(id);
        unsigned char* bytes = reinterpret_cast<unsigned char*>(&world_);
        for (size_t at = 0; s.ok() && at + sizeof with <= sizeof world_; at += sizeof with) {
            if (memcmp(bytes + at, &s.value.A.c0.x, sizeof with) != 0) continue;
            memcpy(bytes + at, &with, sizeof with);
            if (world_.state(id).value.A.c0.x == with) return;
        }
    }

    static World<S> world_, before_, twin_;
    Known known_ = {};
    uint64_t seen_ = ingot::state_hash_seed;
};

template <class S, class Whole>
World<S> Machine<S, Whole>::world_;
template <class S, class Whole>
World<S> Machine<S, Whole>::before_;
template <class S, class Whole>
World<S> Machine<S, Whole>::twin_;

} }  // namespace fuzz
