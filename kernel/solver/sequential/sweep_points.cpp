// SPDX-License-Identifier: MIT
#include "point_reversals.h"

namespace ingot { inline namespace INGOT_ABI {

template void begin_contacts(const PointView&, scalar, scalar);
template void end_contacts(const PointView&, scalar, bool);
template void warm_start(const PointView&);
template bool begin_point_reversals(const PointView&, scalar);
template void end_point_reversals(const PointView&, scalar);
template SweepOfPoints sweep_point_velocities(const PointView&, bool, scalar);
template void go_on_along(const PointView&, scalar);
template void sweep_point_positions(const PointView&, scalar);

} }  // namespace ingot
