// SPDX-License-Identifier: MIT
// A level as bytes of a file, which host_tests/level_tool writes: a header, then the tables as they lie in memory. Nothing is copied.
#pragma once

#include <stddef.h>

#include "../base/status.h"
#include "level_table.h"

namespace ingot { inline namespace INGOT_ABI {

/// What the bytes of a level begin with. After it: of a mesh nodes, triangles, corners; of heights samples, extremes, cells; of heights in bytes
/// blocks, extremes, cells, samples.
struct LevelHeader {
    static constexpr uint8_t name[8] = {'i', 'n', 'g', 'o', 't', 'l', 'e', 'v'};  ///< magic
    static constexpr uint16_t order_of_machine = 0x0102;                          ///< as the machine that has the tables writes it
    static constexpr uint16_t version_now = 1;                                    ///< of the tables
    static constexpr uint8_t has_cells = 1, has_bytes = 2;                        ///< in `has`
    uint8_t magic[8]{};                                                           ///< name
    uint16_t order{}, version{};                                                  ///< order_of_machine, version_now
    uint32_t size{};                                                              ///< bytes in all
    uint32_t checksum{};                                                          ///< LevelTable::checksum
    float step{};                                                                 ///< m
    float origin[3]{}, low[3]{}, high[3]{};                                       ///< m; of heights low and high are not read
    float spacing[2]{};                                                           ///< m, of heights
    uint16_t corner_count{}, triangle_count{}, node_count{};                      ///< of a mesh
    uint16_t columns{}, rows{};                                                   ///< of heights
    uint8_t other_diagonal{};                                                     ///< of heights, 0 or 1
    uint8_t has{};                                                                ///< of heights: has_cells, has_bytes, or both, or 0
};
static_assert(sizeof(LevelHeader) == 80 && alignof(LevelHeader) == 4, "the header lies in files");

/// The level whose bytes these are. It points into them: they stay where they are, in flash or memory, as long as it is in use.
///
/// Errors:  bad_shape (no level, not whole, damaged, of the other order of bytes, or not at a multiple of 4), other_version.
/// Cost:    one reading of all bytes (check_level).
Result<LevelTable> level_from_bytes(const void* bytes, size_t size);

}}  // namespace ingot::INGOT_ABI
