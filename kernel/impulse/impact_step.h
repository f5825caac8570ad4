// SPDX-License-Identifier: MIT
// The step in which impacts without friction take place, and how bodies fly in it.
//
// An impact at the time t of the step changes a velocity by dv. The tiles hold what leads to the same place and velocity at the end of it as if all
// of the step were one flight: v + dv, and r - t dv. So at any time after t a body is where its tile says that it flies to:
//
//     r(t) = r_CM + v_CM t + a t^2 / 2,   v(t) = v_CM + a t,   a = F_T / M + gravity
//
// and the stages that follow, which know one parabola a step, need not know of impacts.
#pragma once

#include "../base/report.h"
#include "../body/body_tiles.h"
#include "../shape/surface.h"
#include "collide_shapes.h"
#include "contact_rows.h"

namespace ingot { inline namespace INGOT_ABI {

struct ImpactStep {
    BodyView bodies;
    SurfaceView surfaces;
    Vector gravity;
    scalar h;           ///< s, of the step that is looked at; 0: impacts are of what touches as the step begins, and no others
    scalar rest_speed;  ///< m/s; slower impacts are contacts at rest
    Ways ways = {};     ///< within h: as fast as bodies have been in it so far

    /// m/s; what touches and leaves no faster is taken to rest.
    scalar still() const { return rest_speed * limits::still_share; }
};

/// m s^-2, of a body by forces; 0 of what cannot move.
Vector acceleration_in(const ImpactStep& step, int slot);

/// ImpactStep::ways. Cost: a look at every body.
Ways ways_in(const ImpactStep& step);
/// An impact may have made a body faster than all were before it.
void raise_ways(ImpactStep& step, int slot);

/// A body at the time t of the step, and how it flies on. Its A is that of the begin.
Placed placed_at(const ImpactStep& step, int slot, scalar t);
/// The same of one whose turn counts, as of a box.
Placed turning_at(const ImpactStep& step, int slot, scalar t);

/// Where the contacts of two slots go, found from the time `now` on. A half space is B. is_again: see ContactSink.
ContactSink sink_of(const ImpactStep& step, const ContactView& contacts, int slot_A, int slot_B, scalar now, bool is_again, StepReport& report);

/// n.(v_AP - v_BP) at a time of the step. Its rounding is that of the speeds it is the sum of, even where they cancel.
struct SpeedInStep : NormalSpeed {
    scalar change;  ///< m/s, by forces since the begin
};
SpeedInStep speed_at(const ImpactStep& step, const Contact& contact, scalar t);

} }  // namespace ingot
