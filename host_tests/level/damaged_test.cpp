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

/// Nodes that lead anywhere, into each other and beyond the tables, and whose boxes hold all there is: walks fill their stacks and come to all ends.
TEST(DamagedLevels, whose_nodes_lead_in_circles_end_all_the_same) {
    Random random(47);
    for (int round = 0; round < 200 / shares; ++round) {
        level_tool::MeshData mesh = built(village(random, 3));
        for (ingot::MeshNode& node : mesh.nodes) {
            node.origin = {};
            node.shifts = 0x999;
            node.counts = 0;
            for (int k = 0; k < 4; ++k) {
                const int children = between(random, 0, 3) > 0 ? ingot::MeshNode::inner : between(random, 0, 15);
                node.counts = static_cast<uint16_t>(node.counts | children << 4 * k);
            }
            node.first_node = static_cast<uint16_t>(between(random, 0, mesh.view.mesh.node_count));
            node.first_triangle = static_cast<uint16_t>(between(random, 0, mesh.view.mesh.triangle_count + 8));
            for (int axis = 0; axis < 3; ++axis)
                for (int k = 0; k < 4; ++k) node.low[axis][k] = 0, node.high[axis][k] = 255;
        }
        mesh.view.checksum = checksum_of(mesh.view);
        EXPECT_EQ(check_level(mesh.view), Status::bad_shape);
        walk_about(mesh.view, random);
        ingot::LevelHit hit{};
        (void)cast_ray_on_level(mesh.view, mesh.view.low, mesh.view.high - mesh.view.low, hit);
    }
}

/// So many nodes, one in the other, and a triangle in the last.
level_tool::MeshData chain_of_nodes(int count) {
    level_tool::MeshData mesh;
    mesh.corners = {lattice_point(0, 0, 0), lattice_point(4, 0, 0), lattice_point(0, 4, 1)};
    mesh.triangles = {{{0, 1, 2}, 0, 0}};
    for (int i = 0; i < count; ++i) {
        ingot::MeshNode node;
        node.counts = i + 1 < count ? ingot::MeshNode::inner : 1;
        node.first_node = static_cast<uint16_t>(i + 1);
        for (auto& high : node.high) high[0] = 4;
        mesh.nodes.push_back(node);
    }
    LevelTable& level = mesh.view;
    level.step = scalar(1) / 64;
    level.high = Vector{4, 4, 1} * level.step;
    level.mesh.corners = mesh.corners.data(), level.mesh.corner_count = 3;
    level.mesh.triangles = mesh.triangles.data(), level.mesh.triangle_count = 1;
    level.mesh.nodes = mesh.nodes.data(), level.mesh.node_count = static_cast<uint16_t>(count);
    level.checksum = checksum_of(level);
    return mesh;
}

TEST(DamagedLevels, that_are_deeper_than_twelve_nodes_are_refused) {
    for (int count = 1; count <= ingot::MeshTable::depth_max + 3; ++count)
        EXPECT_EQ(check_level(chain_of_nodes(count).view), count <= ingot::MeshTable::depth_max ? Status::ok : Status::bad_shape) << count;
}

/// One number of a sound mesh is another, and the checksum is that of what is there.
TEST(DamagedLevels, whose_checksum_is_theirs_are_refused_for_their_tree) {
    using Data = level_tool::MeshData;
    const struct {
        const char* name;
        void (*put)(Data&);
    } faults[] = {
        {"no corners", [](Data& mesh) { mesh.view.mesh.corner_count = 0; }},
        {"no nodes", [](Data& mesh) { mesh.view.mesh.node_count = 0; }},
        {"a root without children", [](Data& mesh) { mesh.nodes[0].counts = 0; }},
        {"a child too many", [](Data& mesh) { mesh.nodes.back().counts = ingot::MeshNode::inner; }},
        {"a node that nobody leads to", [](Data& mesh) { --mesh.view.mesh.node_count; }},
        {"a triangle in no leaf",
         [](Data& mesh) {
             mesh.triangles.push_back(mesh.triangles[0]);
             mesh.view.mesh.triangles = mesh.triangles.data();
             ++mesh.view.mesh.triangle_count;
         }},
        {"a triangle too few", [](Data& mesh) { --mesh.view.mesh.triangle_count; }},
        {"materials below none", [](Data& mesh) { mesh.view.material_count = -1; }},
    };
    for (const auto& fault : faults) {
        Random random(48);
        Data mesh = built(village(random, 3));
        ASSERT_GT(mesh.nodes.size(), 2u);
        ASSERT_EQ(check_level(mesh.view), Status::ok);
        fault.put(mesh);
        mesh.view.checksum = checksum_of(mesh.view);
        EXPECT_EQ(check_level(mesh.view), Status::bad_shape) << fault.name;
    }
}

TEST(DamagedLevels, that_lack_a_table_are_refused) {
    Random random(50);
    const level_tool::MeshData mesh = built(village(random, 3));
    const Field hills = field(random, 9, 9, false, 0, [](int column, int row) { return column * row; });
    LevelTable no_triangles = mesh.view, no_nodes = mesh.view, no_corners = mesh.view;
    no_triangles.mesh.triangles = nullptr;
    no_nodes.mesh.nodes = nullptr;
    no_corners.mesh.corners = nullptr;
    LevelTable no_extremes = hills.view, no_column = hills.view, too_many = hills.view;
    no_extremes.heights.extremes = nullptr;
    no_column.heights.columns = 1;
    too_many.heights.columns = too_many.heights.rows = 65535;  // nothing of a field is read before its cells are counted
    for (const LevelTable& bad : {no_triangles, no_nodes, no_corners, no_extremes, no_column, too_many})
        EXPECT_EQ(check_level(bad), Status::bad_shape);
}

/// The box of a field is said six times over, and each of them is looked at.
TEST(DamagedLevels, whose_box_is_another_are_refused) {
    Random random(51);
    const level_tool::MeshData mesh = built(village(random, 3));
    const Field hills = field(random, 9, 9, false, 0, [](int column, int row) { return column * row; });
    for (const LevelTable* level : {&mesh.view, &hills.view})
        for (int number_i = 0; number_i < 6; ++number_i)
            for (const int by : {-1, 1}) {
                LevelTable bad = *level;
                scalar* const numbers[] = {&bad.low.x, &bad.low.y, &bad.low.z, &bad.high.x, &bad.high.y, &bad.high.z};
                *numbers[number_i] += static_cast<scalar>(by) * bad.step;
                EXPECT_EQ(check_level(bad), Status::bad_shape) << number_i;
            }
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
