// SPDX-License-Identifier: MIT
#include "solve_planes.h"

#include "half_spaces.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Status check_planes(const MoverPlane* planes, int count) {
    if (count < 0 || count > movers::planes_max || (count > 0 && planes == nullptr)) return Status::out_of_range;
    for (int i = 0; i < count; ++i) {  // bound: movers::planes_max
        const MoverPlane& plane = planes[i];
        if (!is_finite(plane.n) || !is_finite(plane.gap) || !is_finite(plane.push_max) || !is_finite(plane.v)) return Status::not_finite;
        if (abs(length_sq(plane.n) - 1) > limits::unit_length) return Status::bad_direction;
        if (!(abs(plane.gap) <= 2 * limits::position_max && length_sq(plane.v) <= limits::speed_max * limits::speed_max)) return Status::out_of_range;
    }
    return Status::ok;
}
Status check_wanted(const Vector& w, scalar most) {
    if (!is_finite(w)) return Status::not_finite;
    return abs(w.x) <= most && abs(w.y) <= most && abs(w.z) <= most ? Status::ok : Status::out_of_range;
}

}  // namespace

Result<Vector> solve_planes(const Vector& way, const MoverPlane* planes, int count) {
    Status status = check_wanted(way, 2 * limits::position_max);
    if (status == Status::ok) status = check_planes(planes, count);
    if (status != Status::ok) return {status, {}};
    HalfSpaces spaces;
    for (int i = 0; i < count; ++i) spaces.add(planes[i].n, min(-planes[i].gap, planes[i].push_max));  // bound: movers::planes_max
    return {Status::ok, nearest_in(spaces, way, movers::far_planes)};
}

Result<Vector> clip_velocity(const Vector& v, const MoverPlane* planes, int count) {
    Status status = check_wanted(v, limits::speed_max);
    if (status == Status::ok) status = check_planes(planes, count);
    if (status != Status::ok) return {status, {}};
    HalfSpaces spaces;
    for (int i = 0; i < count; ++i) spaces.add(planes[i].n, dot(planes[i].n, planes[i].v));  // bound: movers::planes_max
    return {Status::ok, nearest_in(spaces, v, movers::far_planes)};
}

} }  // namespace ingot
