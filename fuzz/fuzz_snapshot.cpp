// SPDX-License-Identifier: MIT
// The loader of snapshots on arbitrary bytes.
//
//   A refused snapshot leaves the world bitwise unchanged.
//   What was loaded saves as the same bytes, and is a world: it steps and reads as fuzz_world.cpp demands of worlds.
//   Every lane count gives the same answers (fuzz_main.cpp).
//
// Few arbitrary bytes have the right checksum. So the first byte chooses the scene and how the rest is taken: as it is; between a right
// header and a right checksum; or as a list of changes to the snapshot of a living world, which is sealed again.
//
// Compiled once for each lane count. INGOT_FUZZ_RUN names the function; fuzz_fault breaks a promise on purpose, so that
// a test can see that the oracle notices (CMakeLists.txt).
#include "fuzz_world.h"

#include <ingot/ingot.h>
#include <string.h>

namespace {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::BodyState;
using ingot::Result;
using ingot::scalar;
using ingot::Status;
using ingot::Vector;
using ingot::World;
namespace limits = ingot::limits;

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 6;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 10;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
struct PrintedYard : Yard {
    using rotation = ingot::Listing1Euler;
};
struct Tops : ingot::Scene {
    static constexpr int max_bodies = 3;
};
struct Tide : ingot::Scene {
    static constexpr int max_bodies = 3;
    static constexpr bool translates = true;
    using force_field = ingot::BothFields<ingot::PointMassGravity, ingot::ThrusterTable<1, 3>>;
};

void demand(bool promise, const char* text) {
    if (!promise) broken_promise(text);
}

bool within(const Vector& v, scalar limit) { return ingot::abs(v.x) <= limit && ingot::abs(v.y) <= limit && ingot::abs(v.z) <= limit; }

/// Reads the input; past its end everything is zero.
class Bytes {
public:
    Bytes(const uint8_t* data, size_t size) : next_(data), left_(size) {}
    bool empty() const { return left_ == 0; }
    size_t left() const { return left_; }
    uint8_t byte() {
        if (left_ == 0) return 0;
        --left_;
        return *next_++;
    }
    uint16_t two_bytes() {
        const unsigned low = byte();
        return static_cast<uint16_t>(low | static_cast<unsigned>(byte()) << 8);
    }

private:
    const uint8_t* next_;
    size_t left_;
};

/// A number at an edge of what the loader checks.
scalar edge(uint8_t which) {
    static const scalar edges[] = {
        0, scalar(-0.0), 1, -1, 2, scalar(0.5), scalar(1) / 3, scalar(__builtin_nan("")), scalar(__builtin_inf()), scalar(-__builtin_inf()),
        ingot::scalar_max, ingot::epsilon, 1 + ingot::epsilon, limits::position_max, limits::force_max, limits::speed_runaway,
        1000 * limits::speed_runaway, limits::spin_runaway, 1 / limits::mass_min, 1 / limits::mass_max, limits::inertia_max,
        limits::inertia_min, limits::size_min, limits::size_max, limits::gravity_max, limits::orthogonality, scalar(0x1p-60), scalar(0x1p60)};
    return edges[which % (sizeof edges / sizeof edges[0])];
}

template <class S>
class Loader {
public:
    uint64_t run(unsigned mode, bool steps, Bytes in) {
        steps_ = steps;
        if (before_.step_count() == 0) fill(before_);
        memcpy(static_cast<void*>(&world_), &before_, sizeof world_);
        switch (mode) {
            case 0: take(in); break;
            case 1: take_between_header_and_checksum(in); break;
            default: change(in); break;
        }
        load();
        return seen_;
    }

private:
    /// Room for a snapshot, and for a slot more than there are.
    static constexpr size_t room = ingot::snapshot_size<S>() + 16;

    /// A world with a bit of everything that does not depend on the input.
    static void fill(World<S>& world) {
        memset(static_cast<void*>(&world), 0, sizeof world);
        for (int body_i = 0; body_i < S::max_bodies; ++body_i) {
            BodyDef def;
            def.mass = {2, {1, scalar(1.5), 2}, {}, ingot::identity_matrix<scalar>()};
            def.state.L = {1, static_cast<scalar>(body_i), 2};
            if constexpr (S::translates) def.state.r_CM = {static_cast<scalar>(body_i) - 2, 0, 1};
            if constexpr (S::max_contacts > 0) {
                def.shape = body_i % 2 == 0 ? ingot::Shape(ingot::Sphere{scalar(0.5)}) : ingot::Shape(ingot::Box{{1, scalar(0.5), scalar(0.5)}});
                if (body_i == 0) def.shape = ingot::HalfSpace{{0, 0, 1}, 0};
            }
            def.immovable = body_i == 0;
            if (def.immovable) def.state.L = {};
            (void)world.add(def);
        }
        (void)world.remove(world.body_at(S::max_bodies - 1));
        for (int step_i = 0; step_i < 2; ++step_i) (void)ingot::step(world, scalar(1) / 60);
        (void)world.add_torque(world.body_at(1), {1, 2, 3});
    }

    void take(Bytes& in) {
        for (size_ = 0; !in.empty() && size_ < room; ++size_) bytes_[size_] = in.byte();
    }

    void take_between_header_and_checksum(Bytes& in) {
        ingot::SnapshotHeader header = ingot::expected_header<S>();
        size_ = ingot::snapshot_header_size();
        while (!in.empty() && size_ + ingot::snapshot_checksum_size < room) bytes_[size_++] = in.byte();
        size_ += ingot::snapshot_checksum_size;
        header.length = static_cast<uint32_t>(size_);
        ingot::ByteWriter writer(bytes_);
        header.numbers(writer);
        seal();
    }

    /// Changes of bits and of whole numbers, anywhere but in the header.
    void change(Bytes& in) {
        const Result<size_t> saved = ingot::save_snapshot(world_, bytes_, room);
        demand(saved.ok(), "a world fits into what snapshot_size says");
        size_ = saved.value;
        const size_t from = ingot::snapshot_header_size(), end = size_ - ingot::snapshot_checksum_size;
        while (!in.empty()) {
            const uint8_t kind = in.byte();
            const size_t at = from + in.two_bytes() % (end - from);
            if (kind < 64) {
                bytes_[at] = static_cast<uint8_t>(bytes_[at] ^ (1u << kind % 8u));
            } else if (kind < 96) {
                bytes_[at] = in.byte();
            } else if (at + sizeof(scalar) <= end) {
                ingot::ByteWriter writer(bytes_ + at);
                writer.real(edge(in.byte()));
            }
        }
        seal();
    }

    void seal() {
        ingot::ByteWriter writer(bytes_ + size_ - ingot::snapshot_checksum_size);
        writer.integer(ingot::snapshot_checksum(bytes_, size_ - ingot::snapshot_checksum_size));
    }

    void load() {
        const Status status = ingot::load_snapshot(world_, bytes_, size_);
        see_all(status);
        if (status != Status::ok) {
            if (fuzz_fault == 1) reinterpret_cast<unsigned char*>(&world_)[sizeof world_ / 2] ^= 1u;
            demand(memcmp(&world_, &before_, sizeof world_) == 0, "a refused snapshot leaves the world bitwise unchanged");
            return;
        }
        if (fuzz_fault == 2) (void)world_.remove(world_.body_at(1));
        const Result<size_t> saved = ingot::save_snapshot(world_, again_, room);
        demand(saved.ok() && saved.value == size_ && memcmp(again_, bytes_, size_) == 0, "what was loaded saves as the same bytes");
        demand_all();
        // At times, and once: the contacts of forged states take all the sweeps there are, a hundred times the rest.
        if (steps_) {
            (void)INGOT_FUZZ_STEP(world_, scalar(1) / 60);
            demand_all();
        }
        BodyDef def;
        def.mass = {2, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
        const Result<BodyId> added = world_.add(def);
        see_all(added.status);
        demand(added.ok() || added.status == Status::no_room, "a loaded world takes bodies while it has room");
    }

    void demand_all() {
        int count = 0;
        for (int slot = 0; slot < S::max_bodies; ++slot) {
            const BodyId id = world_.body_at(slot);
            if (id == BodyId{}) continue;
            ++count;
            const BodyState state = world_.state(id).value;
            const Vector omega = world_.omega(id).value;
            see_vectors(state.r_CM, state.v_CM, state.A.c0, state.A.c1, state.A.c2, state.L, omega);
            demand(within(state.r_CM, limits::position_max), "a body stays within limits::position_max");
            demand(ingot::is_finite(state.v_CM) && ingot::is_finite(state.L) && ingot::is_finite(omega), "motion is finite");
            // A turn keeps the norm of A^T A - 1, and its largest entry is within a factor 3 of that.
            demand(ingot::orthogonality_error(state.A) <= 3 * limits::orthogonality, "A is orthonormal");
        }
        demand(count == world_.body_count(), "body_count counts the living");
        demand(ingot::is_finite(world_.kinetic_energy()) && ingot::is_finite(world_.linear_momentum()), "energy and momentum are finite");
    }

    void see(const void* data, size_t size) {
        const unsigned char* bytes = static_cast<const unsigned char*>(data);
        for (size_t byte_i = 0; byte_i < size; ++byte_i) seen_ = (seen_ ^ bytes[byte_i]) * 0x100000001b3u;
    }
    template <class... Values>
    void see_all(const Values&... values) { (see(&values, sizeof values), ...); }

    /// Values, without the sign of zero: worlds have no -0 in what whole tiles are added to, and forged snapshots have.
    template <class... Vectors>
    void see_vectors(const Vectors&... vectors) {
        const Vector positive_zero{};
        (see_all(vectors + positive_zero), ...);
    }

    static World<S> world_, before_;
    static uint8_t bytes_[room], again_[room];
    size_t size_ = 0;
    bool steps_ = false;
    uint64_t seen_ = ingot::state_hash_seed;
};

template <class S>
World<S> Loader<S>::world_;
template <class S>
World<S> Loader<S>::before_;
template <class S>
uint8_t Loader<S>::bytes_[Loader<S>::room];
template <class S>
uint8_t Loader<S>::again_[Loader<S>::room];

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    const uint8_t choice = in.byte();
    const unsigned mode = choice / 4u % 4u;
    const bool steps = choice / 16u % 8u == 0;
    switch (choice % 4u) {
        case 0: return Loader<Yard>().run(mode, steps, in);
        case 1: return Loader<PrintedYard>().run(mode, steps, in);
        case 2: return Loader<Tops>().run(mode, steps, in);
        default: return Loader<Tide>().run(mode, steps, in);
    }
}
