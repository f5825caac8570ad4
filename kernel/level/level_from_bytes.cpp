// SPDX-License-Identifier: MIT
#include "level_from_bytes.h"

#include "height_grid.h"
#include "level_walk.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Vector vector_of(const float (&numbers)[3]) {
    return {static_cast<scalar>(numbers[0]), static_cast<scalar>(numbers[1]), static_cast<scalar>(numbers[2])};
}

/// The table that follows the others, of so many items.
template <class Item>
const Item* take_table(const uint8_t*& at, int64_t& left, int64_t count) {
    const int64_t size = count * static_cast<int64_t>(sizeof(Item));
    if (count == 0 || left < size) {
        left -= size;
        return nullptr;
    }
    const void* table = at;
    at += size;
    left -= size;
    return static_cast<const Item*>(table);
}

}  // namespace

Result<LevelTable> level_from_bytes(const void* bytes, size_t size) {
    const auto* at = static_cast<const uint8_t*>(bytes);
    LevelHeader header;
    if (bytes == nullptr || size < sizeof header || reinterpret_cast<uintptr_t>(bytes) % alignof(LevelHeader) != 0) return {Status::bad_shape, {}};
    INGOT_COPY_BYTES(static_cast<void*>(&header), bytes, sizeof header);
    for (int i = 0; i < 8; ++i)
        if (header.magic[i] != LevelHeader::name[i]) return {Status::bad_shape, {}};
    if (header.order != LevelHeader::order_of_machine) return {Status::bad_shape, {}};
    if (header.version != LevelHeader::version_now) return {Status::other_version, {}};
    if (header.size != size || header.other_diagonal > 1 || header.has > 3) return {Status::bad_shape, {}};

    LevelTable level{};
    level.origin = vector_of(header.origin);
    level.low = vector_of(header.low);
    level.high = vector_of(header.high);
    level.step = static_cast<scalar>(header.step);
    level.checksum = header.checksum;
    at += sizeof header;
    auto left = static_cast<int64_t>(size - sizeof header);
    if (header.columns == 0) {
        level.mesh.node_count = header.node_count;
        level.mesh.triangle_count = header.triangle_count;
        level.mesh.corner_count = header.corner_count;
        level.mesh.nodes = take_table<MeshNode>(at, left, header.node_count);
        level.mesh.triangles = take_table<LatticeTriangle>(at, left, header.triangle_count);
        level.mesh.corners = take_table<LatticePoint>(at, left, header.corner_count);
    } else {
        const int64_t cells = static_cast<int64_t>(grid::cells_of(header.columns)) * grid::cells_of(header.rows);
        if (header.rows < 2 || header.columns < 2 || header.triangle_count != 0) return {Status::bad_shape, {}};
        level.heights.columns = header.columns;
        level.heights.rows = header.rows;
        level.heights.spacing_x = static_cast<scalar>(header.spacing[0]);
        level.heights.spacing_y = static_cast<scalar>(header.spacing[1]);
        level.heights.other_diagonal = header.other_diagonal != 0;
        const int64_t samples = static_cast<int64_t>(header.columns) * header.rows;
        const bool is_in_bytes = (header.has & LevelHeader::has_bytes) != 0;
        if (is_in_bytes)
            level.heights.blocks = take_table<HeightBlock>(at, left, grid::byte_blocks_of(header.columns, header.rows));
        else
            level.heights.heights = take_table<uint16_t>(at, left, samples);
        level.heights.extremes = take_table<uint16_t>(at, left, grid::extremes_of(header.columns, header.rows));
        level.heights.cells = take_table<uint8_t>(at, left, (header.has & LevelHeader::has_cells) != 0 ? cells : 0);
        level.heights.bytes = take_table<uint8_t>(at, left, is_in_bytes ? samples : 0);
    }
    if (left != 0) return {Status::bad_shape, {}};
    if (!level.is_mesh() && level.heights.extremes != nullptr) {
        level.low = grid::low_of(level);
        level.high = grid::high_of(level);
    }
    const Status status = check_level(level);
    if (status != Status::ok) return {status, {}};
    return {Status::ok, level};
}

}}  // namespace ingot::INGOT_ABI
