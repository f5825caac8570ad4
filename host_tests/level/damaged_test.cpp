// SPDX-License-Identifier: MIT
// Tables and bytes of which some are others: refused, and walked through without harm.
#include <gtest/gtest.h>
#include <ingot/level/level_walk.h>

#include <cstddef>

#include "aligned.h"
#include "fields.h"
#include "level_tool/output.h"
#include "small_levels.h"

namespace {

using namespace level_test;
using ingot::LevelTable;
using ingot::LevelTriangle;
using ingot::scalar;
using ingot::Status;
using ingot::Vector;

constexpr int shares = INGOT_TEST_BRIEF ? 4 : 1;  // of the faults

/// Walks and rays over a level of which nothing is known: they end, and read nothing that is not there (sanitizers look).
void walk_about(const LevelTable& level, Random& random) {
    size_t told = 0;
    const auto count = [&told](const LevelTriangle&) { ++told; };
    for_triangles_in(level, {-infinity, -infinity, -infinity}, {infinity, infinity, infinity}, count);
    EXPECT_LE(told, size_t{4 * 8} * (1 + level.mesh.node_count) + triangles_of(level).size());
    for (int i = 0; i < 4; ++i) {
        const auto draw = [&] { return static_cast<scalar>(random() % 64); };
        const Vector low{draw(), draw(), draw()};
        for_triangles_in(level, low, low + Vector{draw(), draw(), draw()}, count);
        ingot::LevelHit hit{};
        (void)cast_ray_on_level(level, low, Vector{draw() - 32, draw() - 32, -draw()}, hit);
    }
}

/// A field in bytes whose samples fit, and whose extremes are theirs.
bool is_sound(const Field& field) {
    std::vector<uint16_t> extremes(field.extremes.size());
    ingot::grid::fill_extremes(field.view.heights, extremes.data());
    bool sound = extremes == field.extremes;
    for (int row = 0; row < field.view.heights.rows; ++row)
        for (int column = 0; column < field.view.heights.columns; ++column)
            sound = sound && ingot::grid::height_at(field.view.heights, column, row) <= 65535;
    for (const ingot::HeightBlock& block : field.blocks) sound = sound && block.shift <= ingot::HeightBlock::shift_max;
    return sound;
}

TEST(DamagedLevels, of_which_a_byte_is_another_are_refused_and_do_no_harm) {
    Random random(34);
    level_tool::MeshData mesh = built(village(random, 3));
    ASSERT_EQ(check_level(mesh.view), Status::ok);
    const auto damage = [&](void* from, size_t size) {
        for (int i = 0; i < 2000 / shares; ++i) {
            uint8_t& byte = static_cast<uint8_t*>(from)[random() % size];
            const uint8_t kept = byte;
            byte = static_cast<uint8_t>(byte ^ (1 + random() % 255));
            EXPECT_EQ(check_level(mesh.view), Status::bad_shape);
            walk_about(mesh.view, random);
            byte = kept;
        }
    };
    damage(mesh.corners.data(), mesh.corners.size() * sizeof mesh.corners[0]);
    damage(mesh.triangles.data(), mesh.triangles.size() * sizeof mesh.triangles[0]);
    damage(mesh.nodes.data(), mesh.nodes.size() * sizeof mesh.nodes[0]);
    // All of them anything, whatever the checksum says.
    for (int i = 0; i < 200 / shares; ++i) {
        for (size_t k = 0; k < mesh.nodes.size() * sizeof mesh.nodes[0]; ++k)
            reinterpret_cast<uint8_t*>(mesh.nodes.data())[k] = static_cast<uint8_t>(random());
        for (ingot::LatticeTriangle& t : mesh.triangles) t.corners[random() % 3] = static_cast<uint16_t>(random());
        mesh.view.checksum = checksum_of(mesh.view);
        EXPECT_EQ(check_level(mesh.view), Status::bad_shape);
        walk_about(mesh.view, random);
    }
    for (int round = 0; round < 2; ++round) {
        Field hills = field(random, 40, 20, false, 4, [&](int, int) { return between(random, 0, 900); });
        ASSERT_EQ(check_level(hills.view), Status::ok);
        std::vector<uint16_t>& numbers = round == 0 ? hills.heights : hills.extremes;
        for (int i = 0; i < 1000 / shares; ++i) {
            uint16_t& number = numbers[random() % numbers.size()];
            const uint16_t kept = number;
            number = static_cast<uint16_t>(number ^ (1u << random() % 16));
            EXPECT_EQ(check_level(hills.view), Status::bad_shape);
            walk_about(hills.view, random);
            number = kept;
        }
        hills.cells[17] = static_cast<uint8_t>(hills.cells[17] ^ 1);
        EXPECT_EQ(check_level(hills.view), Status::bad_shape);
    }
    Field in_bytes = field(random, 40, 20, false, 4, [&](int, int) { return between(random, 0, 9000); });
    (void)level_tool::put_into_bytes(in_bytes, 40, 20);
    finish_heights(in_bytes, 40, 20);
    ASSERT_EQ(check_level(in_bytes.view), Status::ok);
    const auto spoil = [&](uint8_t* from, size_t size) {
        for (int i = 0; i < 1000 / shares; ++i) {
            uint8_t& byte = from[random() % size];
            const uint8_t kept = byte;
            byte = static_cast<uint8_t>(byte ^ (1 + random() % 255));
            EXPECT_EQ(check_level(in_bytes.view), Status::bad_shape);
            walk_about(in_bytes.view, random);
            // As little where the checksum is of what is there.
            in_bytes.view.checksum = checksum_of(in_bytes.view);
            EXPECT_EQ(check_level(in_bytes.view) == Status::ok, is_sound(in_bytes));
            walk_about(in_bytes.view, random);
            byte = kept;
            in_bytes.view.checksum = checksum_of(in_bytes.view);
        }
    };
    spoil(in_bytes.bytes.data(), in_bytes.bytes.size());
    spoil(reinterpret_cast<uint8_t*>(in_bytes.blocks.data()), in_bytes.blocks.size() * sizeof in_bytes.blocks[0]);
}

TEST(DamagedLevels, that_are_not_those_of_a_level_are_refused) {
    Random random(44);
    const Field hills = field(random, 12, 9, true, 4, [&](int, int) { return between(random, 0, 900); });
    Field small = field(random, 12, 9, true, 4, [&](int, int) { return between(random, 0, 900); });
    (void)level_tool::put_into_bytes(small, 12, 9);
    finish_heights(small, 12, 9);
    Aligned byte_field_bytes(level_tool::level_bytes(small.view, false));
    Aligned field_bytes(level_tool::level_bytes(hills.view, false)), mesh_bytes(level_tool::level_bytes(small_levels[0], false));
    EXPECT_EQ(ingot::level_from_bytes(nullptr, 100).status, Status::bad_shape);
    Aligned other_order(level_tool::level_bytes(small_levels[0], true));
    EXPECT_EQ(other_order.level().status, Status::bad_shape);
    for (Aligned* file : {&mesh_bytes, &field_bytes, &byte_field_bytes}) {
        ASSERT_EQ(file->level().status, Status::ok);
        for (size_t size = 0; size < file->size; ++size) EXPECT_EQ(ingot::level_from_bytes(file->words.data(), size).status, Status::bad_shape);
        EXPECT_EQ(ingot::level_from_bytes(file->words.data(), file->size + 1).status, Status::bad_shape);
        for (size_t i = 0; i < file->size; ++i)
            for (int k = 0; k < 4; ++k) {
                const bool is_unread = file != &mesh_bytes && i >= offsetof(ingot::LevelHeader, low) && i < offsetof(ingot::LevelHeader, spacing);
                const bool is_of_the_other = i >= offsetof(ingot::LevelHeader, spacing) && i < sizeof(ingot::LevelHeader);
                const uint8_t kept = file->bytes()[i];
                file->bytes()[i] = static_cast<uint8_t>(kept ^ (1 + random() % 255));
                const Status status = file->level().status;
                if (!is_unread && !is_of_the_other) {
                    EXPECT_NE(status, Status::ok) << i;
                }
                file->bytes()[i] = kept;
            }
        std::memmove(file->bytes() + 2, file->bytes(), file->size);
        EXPECT_EQ(ingot::level_from_bytes(file->bytes() + 2, file->size).status, Status::bad_shape) << "at a multiple of 2";
    }
}

}  // namespace
