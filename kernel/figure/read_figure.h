// SPDX-License-Identifier: MIT
// Figures between two steps: which bodies hang together, and how they move as one.
#pragma once

#include "../body/body_tiles.h"
#include "../joint/joint_lists.h"

namespace ingot { inline namespace INGOT_ABI {

/// All bodies that hang together by joints with one, through what can move. World axes.
struct FigureInfo {
    int body_count{};         ///< 1 for a body without joints
    scalar mass{};            ///< kg
    Vector r_CM{}, v_CM{};    ///< m, m/s: of the centre of mass of all
    Vector p{};               ///< kg m/s
    Vector L{};               ///< kg m^2/s, about r_CM
    scalar kinetic_energy{};  ///< J
};

/// The bodies of a figure as bits by slot, and room to go through them.
struct FigureMarks {
    uint8_t* bits;  ///< all 0 to begin with
    Index* room;    ///< for every body that may have joints

    bool has(int slot) const { return (bits[slot / 8] >> slot % 8 & 1u) != 0; }
    void set(int slot) const { bits[slot / 8] = static_cast<uint8_t>(bits[slot / 8] | 1u << slot % 8); }
};

/// Marks all that hangs together with a body that can move. Cost: a look at each joint of each of its bodies.
void mark_figure(const BodyView& bodies, const JointLists& lists, Index slot, const FigureMarks& marks);

/// Sums over the bodies that are marked, in the order of slots: so they do not depend on the body that was asked for. slots: in use.
FigureInfo figure_of(const BodyView& bodies, const FigureMarks& marks, int slots);

} }  // namespace ingot
