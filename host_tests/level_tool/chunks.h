// SPDX-License-Identifier: MIT
// A mesh of any size on one lattice, cut into parts that a table holds.
#pragma once

#include "input.h"
#include "level_data.h"

namespace level_tool {

/// Corners in steps from the origin of the frame.
struct LatticeFace {
    int64_t corners[3][3];
    int line;
    uint8_t material;
};
struct LatticeMesh {
    std::vector<LatticeFace> faces;
    std::vector<std::string> materials;  ///< by number; empty where the file has numbers itself
};

/// How places of a file become places of a level.
struct Placing {
    double scale = 1;  ///< m a unit of the file
    double step = 0;   ///< m
    bool y_is_up = false;
};

/// Moves corners to the lattice, and names what has no area there, or is there already, by its line. Materials: names that are all numbers up to 255
/// are these numbers; else they are numbered in their alphabetical order.
Refusal place_on_lattice(const ObjMesh& obj, const Placing& placing, LatticeMesh& mesh, std::ostream& messages);

/// Parts of up to 65535 triangles and corners that are up to 65535 steps across, each the numbers of its faces. They depend on the triangles, and not
/// on their order.
Refusal cut_into_chunks(const LatticeMesh& mesh, std::vector<std::vector<int>>& chunks);

/// The table of one of them.
Refusal build_chunk(const LatticeMesh& mesh, const std::vector<int>& numbers, ingot::scalar step, MeshData& data);

}  // namespace level_tool
