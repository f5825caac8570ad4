// SPDX-License-Identifier: MIT
#pragma once

#include "../base/ids.h"
#include "../broad_phase/body_filter.h"
#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

/// Which bodies a query looks at. As it is, all but sensors.
struct QueryFilter {
    /// Of the query, as if it were a body: it finds those that would meet it. In a scene without filters bodies have meets_all.
    BodyFilter filter = {0xffffffffu, 0xffffffffu};
    BodyId except = {};    ///< a body it does not look at: the one that asks
    bool sensors = false;  ///< sensors too
};

/// What a cast meets first.
struct QueryHit {
    BodyId body{};    ///< the null id: it meets none
    scalar fraction{};  ///< of the way, 0 .. 1; 1 if it meets none
    Vector P{};       ///< m, world: on the body; the end of the way if it meets none
    Vector n{};       ///< unit, away from the body; where the way begins inside, against the motion; zero if it meets none
    int shape{};      ///< which of the body's shapes, where it has several; else 0

    constexpr bool found() const { return body.generation != 0; }  ///< there is a body
};

/// The body nearest to a point.
struct QueryNearest {
    BodyId body{};    ///< the null id: none is near enough
    scalar distance{};  ///< m, from its surface; negative inside, and behind a level
    Vector P{};       ///< m, world: on its surface
    Vector n{};       ///< unit, out of the body
    int shape{};      ///< which of the body's shapes, where it has several; else 0

    constexpr bool found() const { return body.generation != 0; }  ///< there is a body
};

/// No body.
inline constexpr int no_slot = -1;

} }  // namespace ingot
