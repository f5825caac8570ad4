// SPDX-License-Identifier: MIT
// The numbers of a portable snapshot by name, without knowing its scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace replay {

struct SnapshotField {
    int slot = -1;     ///< of the body; -1: of the world
    std::string name;  ///< as in the kernel: "L.y", "gravity.z", "generation"
    bool is_real = false;
    uint64_t bits = 0;
    std::size_t offset = 0;  ///< from the begin of the snapshot, bytes
    unsigned size = 0;  ///< bytes

    /// As a number; that of a float or double if it is_real.
    double value(bool doubles) const;
};

struct SnapshotFields {
    bool doubles = false;
    uint64_t signature = 0;  ///< of the scene
    std::vector<SnapshotField> fields;
};

/// Reads what save_snapshot wrote. Returns: why the bytes are no snapshot; empty if they are one.
std::string read_fields(const std::vector<uint8_t>& bytes, SnapshotFields& snapshot);

}  // namespace replay
