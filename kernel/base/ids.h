// SPDX-License-Identifier: MIT
#pragma once

#include "config.h"

namespace ingot { inline namespace INGOT_ABI {

/// Names one body of one world for as long as that body lives. All zero is the null id: it names no body.
///
/// `generation` counts the additions and removals of its slot: odd while a body lives there, so an id outlives its body
/// without ever naming another. A slot whose counter is used up is not given out again.
///
/// An id says nothing else of its world than the tag, and a world that was given none has the tag 0: of two worlds of one tag, each takes the ids of
/// the other for its own where slot and generation fit. A world holds no pointer and knows of no other, so nothing can tell: who has two worlds gives
/// each a tag.
struct BodyId {
    Index slot{};           ///< where the body is: World::body_at; 0 .. max_bodies - 1
    uint16_t world_tag{};   ///< World::set_tag; tells apart the ids of several worlds of one scene
    uint32_t generation{};  ///< odd while the body lives; 0: the null id

    /// The same body of the same world.
    constexpr bool operator==(const BodyId& other) const {
        return slot == other.slot && world_tag == other.world_tag && generation == other.generation;
    }
    constexpr bool operator!=(const BodyId& other) const { return !(*this == other); }  ///< another
};

} }  // namespace ingot
