// SPDX-License-Identifier: MIT
#include "snapshot_bytes.h"

#include "../base/limits.h"
#include "../body/freeze_bad_bodies.h"
#include "../body/kinematics.h"
#include "../body/auxiliary.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool is_within(const Vector& v, scalar limit) { return check_vector(v, limit) == Status::ok; }

/// Eight bytes, the lowest first; zeros past the end.
uint64_t word_at(const uint8_t* bytes, size_t left) {
    uint64_t word = 0;
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    if (left >= 8) {  // the same in one load, four times as fast
        INGOT_COPY_BYTES(&word, bytes, 8);
        return word;
    }
#endif
    for (size_t byte_i = 0; byte_i < 8 && byte_i < left; ++byte_i) word |= static_cast<uint64_t>(bytes[byte_i]) << (8 * byte_i);
    return word;
}

/// integrate_v lets speed_runaway pass, and the contact forces of the same step may add to it. The energy is still far from
/// overflow.
constexpr scalar speed_max_seen = 1000 * limits::speed_runaway;

bool is_zero_vector(const Vector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

bool is_power_of_two(scalar x) {
    ScalarBits bits;
    INGOT_COPY_BYTES(&bits, &x, sizeof bits);
    constexpr ScalarBits fraction = (ScalarBits(1) << (INGOT_DOUBLE ? 52 : 23)) - 1;
    return (bits & fraction) == 0;
}

/// What make_immovable leaves of a body.
bool is_without_motion(const SavedBody& body, bool translates) {
    const scalar third = scalar(1) / 3;
    const Vector ratio = body.inv_I_ratio;
    if (ratio.x != third || ratio.y != third || ratio.z != third) return false;
    if (!is_zero_vector(body.L) || !is_zero_vector(body.tau_T)) return false;
    return !translates || (body.inv_M == 0 && is_zero_vector(body.v_CM) && is_zero_vector(body.F_T));
}

/// The moments as scaled_inverse_inertia makes them of a solid's. 1/I keeps the order of the limits, so their bounds are exact;
/// ratios of moments are seen through two roundings more.
bool are_moments_of_a_solid(const Vector& ratio, scalar scale) {
    if (!is_finite(ratio) || !is_finite(scale) || !(scale > 0) || !is_power_of_two(scale)) return false;
    const scalar sum = ratio.x + ratio.y + ratio.z;
    if (!(sum > scalar(0.5) && sum <= 1)) return false;
    const scalar inverses[3] = {ratio.x * scale, ratio.y * scale, ratio.z * scale};
    for (scalar inverse : inverses)
        if (!(inverse >= 1 / limits::inertia_max && inverse <= 1 / limits::inertia_min)) return false;

    const scalar moments[3] = {1 / inverses[0], 1 / inverses[1], 1 / inverses[2]};
    const scalar trace = moments[0] + moments[1] + moments[2];
    scalar smallest = moments[0], largest = moments[0];
    for (scalar moment : moments) {
        if (moment - (trace - moment) > 2 * limits::triangle_inequality * trace) return false;
        smallest = moment < smallest ? moment : smallest;
        largest = moment > largest ? moment : largest;
    }
    return largest <= limits::inertia_ratio_max * (1 + 8 * epsilon) * smallest;
}

/// A step looks at the spin before it turns the body: at its begin, and of the mean L. So it may leave three times spin_runaway, and an attitude in
/// which L means more spin; it freezes such a body the next time. NaN is not in range, so an L that is not finite is not sound.
bool turns_within_range(const SavedBody& body) {
    const Vector ratio = body.inv_I_ratio;
    const scalar least_ratio = min(ratio.x, min(ratio.y, ratio.z)), most = 3 * limits::spin_runaway * (1 + 8 * epsilon);
    return length_sq(body.L * (least_ratio * body.inv_I_scale)) <= most * most;
}

bool is_within(const Matrix& m, scalar limit) {
    return is_within(m.c0, limit) && is_within(m.c1, limit) && is_within(m.c2, limit);
}

}  // namespace

bool is_kept_rotation(const Matrix& A) {
    return check_rotation(A) == Status::ok && orthogonality_error(A) <= limits::orthogonality_kept;
}

uint64_t snapshot_checksum(const uint8_t* bytes, size_t size) {
    uint64_t sum = size;
    for (size_t byte_i = 0; byte_i < size; byte_i += 8) {  // bound: the bytes of a snapshot
        const uint64_t word = word_at(bytes + byte_i, size - byte_i);
        sum = (sum ^ word) * 0x9e3779b97f4a7c15u;  // odd: one to one
        sum ^= sum >> 32;                          // what multiplication moved up comes down
    }
    return sum;
}

Status check_snapshot_envelope(const uint8_t* bytes, size_t size, const SnapshotHeader& expected) {
    if (bytes == nullptr || size < snapshot_header_size() + snapshot_checksum_size) return Status::bad_snapshot;
    ByteReader reader(bytes, size);
    SnapshotHeader header{};
    header.numbers(reader);
    if (header.magic != expected.magic || header.length != size) return Status::bad_snapshot;

    const size_t checked_size = size - snapshot_checksum_size;
    uint64_t checksum = 0;
    ByteReader(bytes + checked_size, snapshot_checksum_size)(checksum);
    if (checksum != snapshot_checksum(bytes, checked_size)) return Status::bad_snapshot;
    // What a sound snapshot says of itself is true, so the reason is told: last, for damage has no reason.
    if (header.format != expected.format || header.determinism != expected.determinism) return Status::other_version;
    const bool same_scene =
        header.signature == expected.signature && header.parts == expected.parts && header.field_size == expected.field_size;
    return same_scene ? Status::ok : Status::other_scene;
}

SavedBody saved_body(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    const RotationTile& rotation = bodies.rotation[at.tile];
    SavedBody body{};
    if ((rotation.kicked >> at.lane & 1u) != 0) body.flags = SavedBody::kicked;
    if (is_frozen(bodies, slot)) body.flags = static_cast<uint8_t>(body.flags | SavedBody::frozen);
    body.A = lane_of(rotation.A, at.lane);
    body.L = lane_of(rotation.L, at.lane);
    body.tau_T = lane_of(rotation.tau_T, at.lane);
    body.inv_I_ratio = lane_of(rotation.inv_I_ratio, at.lane);
    body.inv_I_scale = rotation.inv_I_scale[at.lane];
    if (bodies.compensation != nullptr) body.A_low = lane_of(bodies.compensation[at.tile].A_low, at.lane);
    if (bodies.energy != nullptr) body.E_0 = bodies.energy[at.tile].E_0[at.lane];
    if (bodies.translation == nullptr) return body;
    const TranslationTile& translation = bodies.translation[at.tile];
    body.r_CM = lane_of(translation.r_CM, at.lane);
    body.v_CM = lane_of(translation.v_CM, at.lane);
    body.F_T = lane_of(translation.F_T, at.lane);
    body.inv_M = translation.inv_M[at.lane];
    return body;
}

void write_saved_body(const BodyView& bodies, int slot, const SavedBody& body) {
    const Place at = place_of(slot);
    RotationTile& rotation = bodies.rotation[at.tile];
    const unsigned bit = 1u << at.lane;
    if ((body.flags & SavedBody::kicked) != 0) rotation.kicked = static_cast<uint16_t>(rotation.kicked | bit);
    if ((body.flags & SavedBody::frozen) != 0) rotation.bad = static_cast<uint16_t>(rotation.bad | bit);
    set_lane(rotation.A, at.lane, body.A);
    set_lane(rotation.L, at.lane, body.L);
    set_lane(rotation.tau_T, at.lane, body.tau_T);
    set_lane(rotation.inv_I_ratio, at.lane, body.inv_I_ratio);
    rotation.inv_I_scale[at.lane] = body.inv_I_scale;
    if (bodies.compensation != nullptr) set_lane(bodies.compensation[at.tile].A_low, at.lane, body.A_low);
    if (bodies.energy != nullptr) bodies.energy[at.tile].E_0[at.lane] = body.E_0;
    if (bodies.translation != nullptr) {
        TranslationTile& translation = bodies.translation[at.tile];
        set_lane(translation.r_CM, at.lane, body.r_CM);
        set_lane(translation.v_CM, at.lane, body.v_CM);
        set_lane(translation.F_T, at.lane, body.F_T);
        translation.inv_M[at.lane] = body.inv_M;
    }
}

bool is_valid(const SavedBody& body, bool translates) {
    if (body.flags > (SavedBody::kicked | SavedBody::frozen)) return false;
    if (!is_kept_rotation(body.A) || !is_within(body.A_low, limits::orthogonality_kept)) return false;
    if (!is_within(body.tau_T, limits::torque_max)) return false;
    if (!(body.E_0 >= 0) || !is_finite(body.E_0)) return false;
    if (translates) {
        if (!is_within(body.r_CM, limits::position_max) || !is_within(body.v_CM, speed_max_seen)) return false;
        if (!is_within(body.F_T, limits::force_max)) return false;
    }
    if (body.inv_I_scale == 0) return is_without_motion(body, translates);
    if ((body.flags & SavedBody::frozen) != 0) return false;
    if (translates && !(body.inv_M >= 1 / limits::mass_max && body.inv_M <= 1 / limits::mass_min)) return false;
    return are_moments_of_a_solid(body.inv_I_ratio, body.inv_I_scale) && turns_within_range(body);
}

bool is_valid(const SavedRest& saved, const SavedBody& body, scalar sleep_time) {
    if (saved.awake > 2 || !(saved.rest_time >= 0 && saved.rest_time <= sleep_time)) return false;
    if (saved.awake == 1) return true;
    return is_zero_vector(body.L) && is_zero_vector(body.tau_T) && is_zero_vector(body.v_CM) && is_zero_vector(body.F_T);
}

bool is_valid(const SavedSurface& surface, bool can_move) {
    const Shape shape{static_cast<ShapeKind>(surface.kind), surface.size, surface.offset};
    if (shape.kind == ShapeKind::half_space && can_move) return false;
    return check_shape(shape) == Status::ok && surface.e >= 0 && surface.e <= 1 && surface.mu >= 0 && surface.mu <= limits::friction_max;
}

bool is_valid(const SavedManifold& saved) {
    const ManifoldRecord& record = saved.record;
    const Manifold& manifold = record.manifold;
    if (manifold.count < 1 || manifold.count > Manifold::points_max || age_of(record) > limits::substeps_kept) return false;
    if (!(abs(length_sq(manifold.n) - 1) <= limits::flatness)) return false;
    if (!(record.mu >= 0 && record.mu <= limits::friction_max && record.e >= 0 && record.e <= 1)) return false;
    bool sound = is_finite(record.j_friction) && is_finite(saved.j_reference) && is_finite(record.j_torsion);
    for (int point_i = 0; point_i < Manifold::points_max; ++point_i) {
        const ManifoldPoint& point = manifold.points[point_i];
        sound = sound && is_finite(point.P) && is_finite(point.separation) && is_finite(record.j[point_i]) && is_finite(record.j_before[point_i]) &&
                is_finite(saved.anchors.separation[point_i]);
        for (int axis = 0; axis < 3; ++axis)
            sound = sound && is_finite(saved.anchors.on_A[axis][point_i]) && is_finite(saved.anchors.on_B[axis][point_i]);
    }
    return sound && is_finite(saved.anchors.n_A) && is_finite(saved.anchors.n_B) && saved.anchors.margin >= 0 && is_finite(saved.anchors.margin);
}

} }  // namespace ingot
