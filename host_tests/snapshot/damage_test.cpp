// SPDX-License-Identifier: MIT
// A damaged snapshot is refused, whatever the damage, and leaves the world that it was for bitwise unchanged.
#include "snapshot/life.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "reference/draws.h"

namespace {

using namespace life;
using Bytes = std::vector<uint8_t>;

constexpr scalar nan_value = std::numeric_limits<scalar>::quiet_NaN();
constexpr scalar infinity = std::numeric_limits<scalar>::infinity();

/// Writes a number at an offset, from the lowest byte up.
template <class T>
void put(Bytes& bytes, size_t offset, T number) {
    ASSERT_LE(offset + sizeof number, bytes.size());
    uint64_t bits = 0;
    if constexpr (std::is_floating_point_v<T>) {
        ingot::ScalarBits of_number;
        memcpy(&of_number, &number, sizeof number);
        bits = of_number;
    } else {
        bits = number;
    }
    for (size_t byte_i = 0; byte_i < sizeof number; ++byte_i) bytes[offset + byte_i] = static_cast<uint8_t>(bits >> (8 * byte_i));
}
scalar scalar_at(const Bytes& bytes, size_t offset) {
    ingot::ScalarBits bits = 0;
    for (size_t byte_i = 0; byte_i < sizeof bits; ++byte_i) bits |= static_cast<ingot::ScalarBits>(bytes[offset + byte_i]) << (8 * byte_i);
    scalar number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

/// Makes the checksum right again: what the numbers say is then all that is wrong.
void seal(Bytes& bytes) { put(bytes, bytes.size() - 8, ingot::snapshot_checksum(bytes.data(), bytes.size() - 8)); }

/// The format, written down a second time: offsets in bytes.
constexpr size_t s = sizeof(scalar);
constexpr size_t at_format = 8, at_determinism = 10, at_signature = 12, at_length = 20, at_parts = 24, at_field_size = 28;
constexpr size_t at_tag = 32, at_steps = 34, at_slots_used = 38, at_free_hint = 42, at_gravity = 46, at_h_1 = at_gravity + 3 * s;
constexpr size_t first_slot = at_h_1 + s;
// From the begin of a slot of a living body.
constexpr size_t to_flags = 4, to_A = 5, to_L = to_A + 9 * s, to_tau_T = to_L + 3 * s, to_ratio = to_tau_T + 3 * s;
constexpr size_t to_scale = to_ratio + 3 * s, to_A_low = to_scale + s, to_E_0 = to_A_low + 9 * s, to_r_CM = to_E_0 + s;
constexpr size_t to_v_CM = to_r_CM + 3 * s, to_F_T = to_v_CM + 3 * s, to_inv_M = to_F_T + 3 * s, to_kind = to_inv_M + s;
constexpr size_t to_size = to_kind + 1, to_offset = to_size + 3 * s, to_e = to_offset + s, to_mu = to_e + s, slot_size = to_mu + s;

class Damage : public ::testing::Test {
protected:
    Damage() {
        clear(world_);
        clear(other_);
        cast_ = fill_yard(world_);
        sound_ = saved(world_);
        Life life(5);
        for (int call_i = 0; call_i < 60; ++call_i) life.live(other_);
        copy(before_, other_);
    }

    static Cast fill_yard(World<Yard>& world) {
        const Cast cast = yard::fill(world);
        for (int slot = 0; slot < Yard::max_bodies; ++slot) (void)world.add_torque(world.body_at(slot), {1, 2, 3});
        return cast;
    }

    void refuses(Status reason, const Bytes& bytes, const std::string& what) {
        EXPECT_EQ(ingot::load_snapshot(other_, bytes.data(), bytes.size()), reason) << what;
        ASSERT_TRUE(same_bytes(other_, before_)) << what << " changed the world";
    }
    void accepts(const Bytes& bytes, const std::string& what) {
        EXPECT_EQ(ingot::load_snapshot(other_, bytes.data(), bytes.size()), Status::ok) << what;
        EXPECT_EQ(saved(other_), bytes) << what;
        copy(other_, before_);
    }

    template <class T>
    Bytes with(size_t offset, T number) const {
        Bytes bytes = sound_;
        put(bytes, offset, number);
        seal(bytes);
        return bytes;
    }

    /// Where a slot begins; those of the yard before it all have bodies.
    static size_t at(BodyId id) { return first_slot + id.slot * slot_size; }

    static World<Yard> world_, other_, before_;
    Cast cast_;
    Bytes sound_;
};

World<Yard> Damage::world_, Damage::other_, Damage::before_;

TEST_F(Damage, the_snapshot_is_sound_and_the_format_is_as_written_down) {
    accepts(sound_, "what was saved");
    ASSERT_EQ(sound_.size(), first_slot + 6 * slot_size + 4 + 8) << "six bodies, an empty slot, a checksum";
    const BodyState box = world_.state(cast_.box).value;
    EXPECT_EQ(scalar_at(sound_, at(cast_.box) + to_r_CM + 2 * s), box.r_CM.z);
    EXPECT_EQ(scalar_at(sound_, at(cast_.box) + to_v_CM + 2 * s), box.v_CM.z);
    EXPECT_EQ(scalar_at(sound_, at(cast_.spinner) + to_A + 5 * s), world_.state(cast_.spinner).value.A.c1.z);
    EXPECT_EQ(scalar_at(sound_, at(cast_.ball) + to_L + 2 * s), world_.state(cast_.ball).value.L.z);
    EXPECT_EQ(scalar_at(sound_, at(cast_.ball) + to_inv_M), 1);
    EXPECT_EQ(scalar_at(sound_, at(cast_.ball) + to_size), scalar(0.5));
    EXPECT_EQ(scalar_at(sound_, at(cast_.box) + to_e), scalar(0.25));
    EXPECT_EQ(sound_[at(cast_.frozen) + to_flags] & 2, 2);
}

TEST_F(Damage, of_any_single_byte) {
    for (size_t byte_i = 0; byte_i < sound_.size(); ++byte_i) {
        for (int change = 1; change < 256; ++change) {
            Bytes bytes = sound_;
            bytes[byte_i] = static_cast<uint8_t>(bytes[byte_i] ^ change);
            ASSERT_EQ(ingot::load_snapshot(other_, bytes.data(), bytes.size()), Status::bad_snapshot) << "byte " << byte_i;
        }
        ASSERT_TRUE(same_bytes(other_, before_)) << "byte " << byte_i;
    }
}

TEST_F(Damage, of_its_length) {
    for (size_t size = 0; size < sound_.size(); ++size) {
        const Bytes cut(sound_.begin(), sound_.begin() + static_cast<std::ptrdiff_t>(size));
        refuses(Status::bad_snapshot, cut, "cut to " + std::to_string(size));
        if (size < at_parts + 8) continue;
        Bytes pretending = cut;  // its length and checksum made right
        put(pretending, at_length, static_cast<uint32_t>(size));
        seal(pretending);
        refuses(Status::bad_snapshot, pretending, "made " + std::to_string(size));
    }
    Bytes longer = sound_;
    longer.push_back(0);
    refuses(Status::bad_snapshot, longer, "a byte more");
    put(longer, at_length, static_cast<uint32_t>(longer.size()));
    seal(longer);
    refuses(Status::bad_snapshot, longer, "a byte more that is counted");
    refuses(Status::bad_snapshot, with(at_length, static_cast<uint32_t>(sound_.size() + 1)), "a length that is not the file's");
    EXPECT_EQ(ingot::load_snapshot(other_, nullptr, 0), Status::bad_snapshot);
    EXPECT_TRUE(same_bytes(other_, before_));
}

TEST_F(Damage, of_another_kind_or_version_or_scene) {
    refuses(Status::bad_snapshot, with(0, uint8_t(0x88)), "another magic");
    refuses(Status::other_version, with(at_format, uint16_t(ingot::snapshot_format + 1)), "a later format");
    refuses(Status::other_version, with(at_determinism, uint16_t(INGOT_DETERMINISM_VERSION + 1)), "another kernel");
    refuses(Status::other_scene, with(at_signature, uint64_t(1)), "another scene");
    refuses(Status::other_scene, with(at_parts, uint32_t(0)), "other parts");
    refuses(Status::other_scene, with(at_field_size, uint32_t(4)), "a field");
}

/// Everything that makes snapshots of two scenes differ.
struct More : Yard { static constexpr int max_bodies = 8; };
struct Fewer : Yard { static constexpr int max_contacts = 23; };
struct NoBoxes : Yard { using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>; };
struct Flying : Yard { static constexpr int max_contacts = 0; };
struct Midpoint : Yard { using rotation = ingot::LieMidpoint; };
struct Plain : Yard { using rotation = ingot::DiscreteMoserVeselov<6, true, false>; };
struct Lower : Yard { using rotation = ingot::DiscreteMoserVeselov<4>; };
struct Pulled : Yard { using force_field = ingot::PointMassGravity; };
struct Seven : ingot::Scene { static constexpr int max_bodies = 7; };

template <class S>
void refuses_the_yard(const Bytes& bytes) {
    static World<S> world, before;
    clear(world);
    (void)world.add(plain_body({}));
    copy(before, world);
    EXPECT_EQ(ingot::load_snapshot(world, bytes.data(), bytes.size()), Status::other_scene);
    EXPECT_TRUE(same_bytes(world, before));
    EXPECT_NE(ingot::scene_signature<S>(), ingot::scene_signature<Yard>());
}

TEST_F(Damage, of_none_but_for_another_scene) {
    refuses_the_yard<More>(sound_);
    refuses_the_yard<Fewer>(sound_);
    refuses_the_yard<NoBoxes>(sound_);
    refuses_the_yard<Flying>(sound_);
    refuses_the_yard<Midpoint>(sound_);
    refuses_the_yard<Plain>(sound_);
    refuses_the_yard<Lower>(sound_);
    refuses_the_yard<Pulled>(sound_);
    refuses_the_yard<Seven>(sound_);
    refuses_the_yard<PrintedYard>(sound_);
}

TEST_F(Damage, of_numbers_that_are_not_finite) {
    for (const scalar bad : {nan_value, infinity, -infinity}) {
        for (size_t offset = at_gravity; offset < first_slot; offset += s) refuses(Status::bad_snapshot, with(offset, bad), "gravity or h");
        for (const BodyId id : {cast_.ground, cast_.box, cast_.spinner, cast_.heavy, cast_.frozen}) {
            for (size_t offset = to_A; offset < to_kind; offset += s)
                refuses(Status::bad_snapshot, with(at(id) + offset, bad), "number at " + std::to_string(offset));
            for (size_t offset = to_size; offset < slot_size; offset += s)
                refuses(Status::bad_snapshot, with(at(id) + offset, bad), "surface at " + std::to_string(offset));
        }
    }
}

TEST_F(Damage, of_the_order_of_slots) {
    const auto used = static_cast<uint32_t>(Yard::max_bodies);
    refuses(Status::bad_snapshot, with(at_slots_used, used + 1), "more slots than there are");
    refuses(Status::bad_snapshot, with(at_slots_used, used - 1), "fewer slots than follow");
    refuses(Status::bad_snapshot, with(at_slots_used, uint32_t(0)), "no slot");
    refuses(Status::bad_snapshot, with(at_slots_used, UINT32_MAX), "slots beyond counting");
    Bytes slot_more(sound_.begin(), sound_.end() - 8);  // an empty one, beyond the arrays
    slot_more.insert(slot_more.end(), {2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    put(slot_more, at_slots_used, used + 1);
    put(slot_more, at_length, static_cast<uint32_t>(slot_more.size()));
    seal(slot_more);
    refuses(Status::bad_snapshot, slot_more, "a slot more than there are");
    refuses(Status::bad_snapshot, with(at(cast_.removed), uint32_t(0)), "an empty slot that never was used");
    refuses(Status::bad_snapshot, with(at_free_hint, used), "a free slot below the hint");
    refuses(Status::bad_snapshot, with(at_free_hint, used + 1), "a hint beyond the slots");
    refuses(Status::bad_snapshot, with(at_free_hint, UINT32_MAX), "a hint beyond counting");
    refuses(Status::bad_snapshot, with(at(cast_.box), uint32_t(0)), "a used slot that never was");
    refuses(Status::bad_snapshot, with(at(cast_.box), uint32_t(2)), "a body in an empty slot");
    refuses(Status::bad_snapshot, with(at(cast_.removed), uint32_t(3)), "a slot without the body that lives in it");
    accepts(with(at(cast_.box), uint32_t(77)), "another generation of the living");
    accepts(with(at(cast_.removed), uint32_t(78)), "another generation of the dead");
    accepts(with(at_free_hint, uint32_t(0)), "a hint that hints at nothing");
    accepts(with(at_steps, uint32_t(99)), "another count of steps");

    Bytes used_up = with(at(cast_.removed), UINT32_MAX - 1);  // no free slot: it is not given out again
    put(used_up, at_free_hint, used);
    seal(used_up);
    accepts(used_up, "a slot that is used up below the hint");
    put(used_up, at_free_hint, used + 1);
    seal(used_up);
    refuses(Status::bad_snapshot, used_up, "a hint beyond the slots of a full world");
}

TEST_F(Damage, of_the_time_of_a_field) {
    static World<Tide> tide, before;
    clear(tide);
    Life life(2);
    for (int call_i = 0; call_i < 40; ++call_i) life.live(tide);
    copy(before, tide);
    const Bytes sound = saved(tide);
    const size_t at_t = at_h_1 + s, at_t_low = at_t + s;
    EXPECT_EQ(scalar_at(sound, at_t), tide.time());
    const auto load_with = [&](size_t offset, scalar number) {
        Bytes bytes = sound;
        put(bytes, offset, number);
        seal(bytes);
        return ingot::load_snapshot(tide, bytes.data(), bytes.size());
    };
    for (const scalar bad : {nan_value, infinity, -infinity, scalar(-1)}) EXPECT_EQ(load_with(at_t, bad), Status::bad_snapshot);
    for (const scalar bad : {nan_value, infinity, -infinity}) EXPECT_EQ(load_with(at_t_low, bad), Status::bad_snapshot);
    EXPECT_TRUE(same_bytes(tide, before));
    EXPECT_EQ(load_with(at_t, scalar(77)), Status::ok);
    EXPECT_EQ(tide.time(), 77);
}

TEST_F(Damage, of_a_shape_that_the_scene_does_not_name) {
    static World<NoBoxes> world;
    clear(world);
    ASSERT_TRUE(world.add(plain_body({}, ingot::Sphere{1})).ok());
    Bytes bytes = saved(world);
    const uint8_t kinds[] = {static_cast<uint8_t>(ingot::ShapeKind::sphere), static_cast<uint8_t>(ingot::ShapeKind::box)};
    for (const size_t offset : {to_size + s, to_size + 2 * s}) put(bytes, first_slot + offset, scalar(1));
    for (const uint8_t kind : kinds) {
        put(bytes, first_slot + to_kind, kind);
        seal(bytes);
        EXPECT_EQ(ingot::load_snapshot(world, bytes.data(), bytes.size()), kind == kinds[0] ? Status::ok : Status::bad_snapshot);
    }
}

struct Lie {
    const char* what;
    BodyId of;
    size_t offset;
    scalar number;
};

TEST_F(Damage, of_what_a_body_cannot_be) {
    const scalar above = 1 + 4 * ingot::epsilon, above_rounding = 1 + 16 * ingot::epsilon;
    scalar least_ratio = 1;
    for (size_t axis = 0; axis < 3; ++axis) least_ratio = std::min(least_ratio, scalar_at(sound_, at(cast_.ball) + to_ratio + axis * s));
    const scalar L_max = 3 * limits::spin_runaway / (least_ratio * scalar_at(sound_, at(cast_.ball) + to_scale));  // what a step can leave
    const Lie lies[] = {
        {"a stretched A", cast_.box, to_A, scalar(1.1)},
        {"an A that is a little off", cast_.box, to_A, scalar(1.001)},
        {"a mirrored A", cast_.heavy, to_A, -1},
        {"a place out of range", cast_.ball, to_r_CM + s, limits::position_max * above},
        {"a speed out of all range", cast_.ball, to_v_CM, limits::speed_runaway * 1001},
        {"a torque out of range", cast_.ball, to_tau_T, -limits::torque_max * above},
        {"a force out of range", cast_.ball, to_F_T + 2 * s, limits::force_max * above},
        {"a spin out of range", cast_.ball, to_L, L_max * above_rounding},
        {"a low part of A that is high", cast_.ball, to_A_low + s, scalar(0.001)},
        {"an energy below zero", cast_.ball, to_E_0, scalar(-0.5)},
        {"a scale that is no power of two", cast_.ball, to_scale, 3},
        {"a scale below zero", cast_.ball, to_scale, -4},
        {"moments beyond the limit", cast_.ball, to_scale, scalar(0x1p-70)},
        {"moments below the limit", cast_.heavy, to_scale, scalar(0x1p70)},
        {"a body that moves and does not turn", cast_.ball, to_scale, 0},
        {"a ratio of zero", cast_.ball, to_ratio, 0},
        {"a ratio below zero", cast_.ball, to_ratio + s, scalar(-0.1)},
        {"ratios above one", cast_.ball, to_ratio, 1},
        {"ratios that leave room for a smaller scale", cast_.ball, to_ratio, scalar(0.001)},
        {"a body without mass", cast_.ball, to_inv_M, 0},
        {"a mass below zero", cast_.ball, to_inv_M, -1},
        {"a mass beyond the limit", cast_.ball, to_inv_M, scalar(1e-13)},
        {"a mass below the limit", cast_.ball, to_inv_M, scalar(2e9)},
        {"an immovable body that spins", cast_.ground, to_L, 1},
        {"an immovable body that is turned", cast_.ground, to_tau_T, 1},
        {"an immovable body that moves", cast_.ground, to_v_CM, 1},
        {"an immovable body that is pushed", cast_.ground, to_F_T, 1},
        {"an immovable body with a mass", cast_.ground, to_inv_M, 1},
        {"an immovable body with moments", cast_.ground, to_ratio, scalar(0.5)},
        {"a frozen body that moves", cast_.frozen, to_v_CM, 1},
        {"a ball of no size", cast_.ball, to_size, 0},
        {"a box with a side below zero", cast_.box, to_size + s, -1},
        {"a ground that leans on no normal", cast_.ground, to_size + 2 * s, scalar(0.5)},
        {"a ground out of range", cast_.ground, to_offset, limits::position_max * 2},
        {"a restitution above one", cast_.ball, to_e, above},
        {"a restitution below zero", cast_.ball, to_e, scalar(-0.25)},
    };
    for (const Lie& lie : lies) refuses(Status::bad_snapshot, with(at(lie.of) + lie.offset, lie.number), lie.what);

    refuses(Status::bad_snapshot, with(at(cast_.ball) + to_flags, uint8_t(4)), "a flag that is none");
    refuses(Status::bad_snapshot, with(at(cast_.ball) + to_flags, uint8_t(2)), "a frozen body that can move");
    refuses(Status::bad_snapshot, with(at(cast_.ball) + to_kind, uint8_t(4)), "a shape that is none");
    refuses(Status::bad_snapshot, with(at(cast_.box) + to_kind, uint8_t(255)), "a shape that is none");
    const auto with_moments = [&](const Vector& ratio, scalar times_scale) {
        Bytes bytes = sound_;
        put(bytes, at(cast_.ball) + to_ratio, ratio.x);
        put(bytes, at(cast_.ball) + to_ratio + s, ratio.y);
        put(bytes, at(cast_.ball) + to_ratio + 2 * s, ratio.z);
        put(bytes, at(cast_.ball) + to_scale, scalar_at(bytes, at(cast_.ball) + to_scale) * times_scale);
        seal(bytes);
        return bytes;
    };
    const Vector ratio = {scalar_at(sound_, at(cast_.ball) + to_ratio), scalar_at(sound_, at(cast_.ball) + to_ratio + s),
                          scalar_at(sound_, at(cast_.ball) + to_ratio + 2 * s)};
    accepts(with_moments(ratio, 1), "the same moments");
    refuses(Status::bad_snapshot, with_moments(ratio * scalar(0.5), 2), "the same moments under a larger scale");
    refuses(Status::bad_snapshot, with_moments(ratio * scalar(2), scalar(0.5)), "the same moments under a smaller scale");
    const scalar little = ingot::epsilon / 20;
    refuses(Status::bad_snapshot, with_moments({1 - ingot::epsilon, little, little}, 1), "a needle thinner than the limit");
    Bytes plate = sound_;  // a plate wider than a solid: I1 + I2 < I3
    put(plate, at(cast_.ball) + to_ratio, scalar(0.125));
    put(plate, at(cast_.ball) + to_ratio + s, scalar(0.375));
    put(plate, at(cast_.ball) + to_ratio + 2 * s, scalar(0.375));
    seal(plate);
    refuses(Status::bad_snapshot, plate, "moments of no solid");
    Bytes falling_ground = sound_;  // sound but for its shape
    for (size_t offset = 0; offset < 3; ++offset)
        put(falling_ground, at(cast_.ball) + to_size + offset * s, scalar(offset == 2 ? 1 : 0));
    put(falling_ground, at(cast_.ball) + to_kind, uint8_t(ingot::ShapeKind::half_space));
    seal(falling_ground);
    refuses(Status::bad_snapshot, falling_ground, "a half space that can move");

    accepts(with(at(cast_.ball) + to_r_CM, scalar(17)), "another place");
    accepts(with(at(cast_.ball) + to_e, scalar(1)), "another restitution");
    accepts(with(at(cast_.ball) + to_flags, uint8_t(1)), "a kick");
    accepts(with(at(cast_.ball) + to_L, L_max), "the most spin that a step leaves");
    accepts(with(at(cast_.ball) + to_inv_M, 1 / limits::mass_max), "the largest mass");
    accepts(with(at(cast_.ball) + to_inv_M, 1 / limits::mass_min), "the smallest mass");
}

/// The extremes that add takes come back from a snapshot: what the loader checks is not narrower than the door.
TEST_F(Damage, of_none_in_bodies_at_every_limit) {
    static World<Yard> world;
    const scalar low = limits::inertia_min, high = limits::inertia_max, ratio = limits::inertia_ratio_max;
    const Vector moments[] = {{low, low, low},   {high, high, high},         {1, 1, 1 / ratio},
                              {2, 1, 1},         {1, ratio, ratio},          {scalar(0.1), scalar(0.2), scalar(0.3)},
                              {3, 4, 7},         {low * 3, low * 7, low * 9}};
    int taken = 0;
    for (const Vector& I : moments) {
        for (const scalar M : {limits::mass_min, limits::mass_max}) {
            clear(world);
            BodyDef def = plain_body({limits::position_max, -limits::position_max, limits::position_max}, ingot::Sphere{limits::size_min});
            def.mass = mass_of(M, I);
            def.state.v_CM = {limits::speed_max, limits::speed_max, -limits::speed_max};
            def.state.L = {limits::spin_max * I.x, 0, 0};
            def.restitution = 1;
            const Result<BodyId> id = world.add(def);
            if (!id.ok()) continue;
            ++taken;
            (void)world.add_central_force(id.value, {limits::force_max, 0, 0});
            (void)world.add_torque(id.value, {0, limits::torque_max, 0});
            (void)world.set_gravity({limits::gravity_max, 0, 0});
            accepts(saved(world), "moments " + std::to_string(I.x));
        }
    }
    EXPECT_GE(taken, 14);
}

/// What passes is a world: it steps, and nothing in it becomes what it should not be.
TEST_F(Damage, at_random_with_a_right_checksum_is_refused_or_makes_a_world) {
    scenes::Random random(11);
    const auto below = [&random](size_t end) { return static_cast<size_t>((random.symmetric() + 1) * scalar(0.5) * static_cast<scalar>(end)); };
    int refused = 0, accepted = 0;
    for (int trial = 0; trial < ingot_reference::draws(100000); ++trial) {
        Bytes bytes = sound_;
        for (size_t change = 0; change <= below(2); ++change) {
            const size_t from = at_tag, byte_i = from + below(bytes.size() - 8 - from);
            bytes[byte_i] = static_cast<uint8_t>(bytes[byte_i] ^ (1u << below(8)));
        }
        seal(bytes);
        const Status status = ingot::load_snapshot(other_, bytes.data(), bytes.size());
        if (status != Status::ok) {
            ++refused;
            ASSERT_EQ(status, Status::bad_snapshot);
            ASSERT_TRUE(same_bytes(other_, before_)) << "trial " << trial;
            continue;
        }
        ++accepted;
        ASSERT_EQ(saved(other_), bytes) << "trial " << trial;
        for (int step_i = 0; step_i < 2; ++step_i) (void)ingot::step(other_, h);
        for (int slot = 0; slot < Yard::max_bodies; ++slot) {
            const BodyState state = other_.state(other_.body_at(slot)).value;
            ASSERT_TRUE(ingot::is_finite(state.r_CM) && ingot::is_finite(state.v_CM) && ingot::is_finite(state.A) && ingot::is_finite(state.L));
        }
        ASSERT_TRUE(ingot::is_finite(other_.kinetic_energy()));
        copy(other_, before_);
    }
    EXPECT_GT(refused, ingot_reference::draws(10000));
    EXPECT_GT(accepted, ingot_reference::draws(10000));
}

}  // namespace
