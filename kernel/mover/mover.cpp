// SPDX-License-Identifier: MIT
#include "mover.h"

#include "../body/check_body.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool is_between(scalar x, scalar low, scalar high) { return x >= low && x <= high; }
bool is_slow(const Vector& v) { return abs(v.x) <= limits::speed_max && abs(v.y) <= limits::speed_max && abs(v.z) <= limits::speed_max; }

}  // namespace

Status check_mover(const Mover& m, scalar unit) {
    const scalar numbers[] = {m.step, m.stick, m.slope, m.skin, m.force_max};
    for (const scalar number : numbers)
        if (!is_finite(number)) return Status::not_finite;
    const Vector vectors[] = {m.up, m.v, m.v_drift, m.r_in_ground, m.ground.n};
    for (const Vector& vector : vectors)
        if (!is_finite(vector)) return Status::not_finite;
    Status status = check_shape(m.capsule);
    if (status == Status::ok) status = check_vector(m.r, limits::position_max);
    if (status != Status::ok) return status;
    if (abs(length_sq(m.up) - 1) > limits::unit_length) return Status::bad_direction;
    if (!is_between(m.step, 0, limits::size_max) || !is_between(m.stick, 0, limits::size_max)) return Status::out_of_range;
    if (!is_between(m.slope, 0, scalar(1.5)) || !is_between(m.force_max, 0, limits::force_max)) return Status::out_of_range;
    if (!is_slow(m.v) || !is_slow(m.v_drift)) return Status::out_of_range;
    return m.skin > 0 && m.skin * unit >= limits::size_min && m.skin * unit <= m.capsule.radius ? Status::ok : Status::bad_shape;
}

Status check_mover_input(const MoverInput& input) {
    if (!is_finite(input.v) || !is_finite(input.jump)) return Status::not_finite;
    return is_slow(input.v) && is_between(input.jump, 0, limits::speed_max) ? Status::ok : Status::out_of_range;
}

} }  // namespace ingot
