// SPDX-License-Identifier: MIT
// What builds tables: the same bytes whatever the order of the input, sizes, refusals; and tables that are damaged.
#include <gtest/gtest.h>
#include <ingot/level/height_field_of.h>
#include <ingot/level/level_walk.h>

#include <cmath>
#include <numeric>

#include "fields.h"
#include "small_levels.h"

namespace {

using namespace level_test;
using ingot::LevelFace;
using ingot::LevelTable;
using ingot::LevelTriangle;
using ingot::scalar;
using ingot::Status;
using ingot::Vector;

// ---- the compiler

// The same, mentioned in another order.
constexpr Vector other_corners[] = {{4, 3, 2}, {9, 9, 9}, {0, 3, 2}, {0, 6, 0}, {4, 6, 0}, {4, 0, 0}, {0, 0, 0}};
constexpr LevelFace other_faces[] = {{4, 3, 2, 4}, {6, 2, 3, 0}, {2, 0, 4, 4}, {0, 5, 4, 0}, {2, 6, 0, 3}, {5, 0, 6, 3}, {6, 6, 5, 0}, {5, 0, 6, 9}};
static constexpr auto other_built = ingot::mesh_of(other_corners, other_faces);
static_assert(other_built.value.checksum == roof_built.value.checksum && other_built.value.doubled == 1);

static_assert(ingot::levels_in(small_levels).count == 3 && small_levels[0].is_mesh() && !small_levels[1].is_mesh());

std::vector<uint8_t> bytes_of(const LevelTable& level) {
    std::vector<uint8_t> bytes;
    const auto add = [&bytes](const void* from, size_t size) {
        const auto* begin = static_cast<const uint8_t*>(from);
        bytes.insert(bytes.end(), begin, begin + size);
    };
    const ingot::MeshTable& mesh = level.mesh;
    add(mesh.corners, mesh.corner_count * sizeof *mesh.corners);
    add(mesh.triangles, mesh.triangle_count * sizeof *mesh.triangles);
    add(mesh.nodes, mesh.node_count * sizeof *mesh.nodes);
    add(&level.origin, sizeof level.origin);
    add(&level.checksum, sizeof level.checksum);
    return bytes;
}

TEST(LevelTables, of_the_compiler_are_those_of_the_host) {
    Soup soup;
    for (const Vector& p : roof_corners) {
        const auto at = [](scalar x) { return static_cast<int>(x * 1024); };
        soup.points.push_back(lattice_point(at(p.x), at(p.y), at(p.z)));
    }
    soup.faces.assign(std::begin(roof_faces), std::end(roof_faces));
    const level_tool::MeshData host = built(soup);
    EXPECT_EQ(bytes_of(host.view), bytes_of(small_levels[0]));
    EXPECT_EQ(check_level(small_levels[0]), Status::ok);
    EXPECT_EQ(check_level(small_levels[1]), Status::ok);
    EXPECT_EQ(check_level(small_levels[2]), Status::ok);
    // A roof: its ridge is convex; what it stands on is open.
    for (uint32_t i = 0; i < 6; ++i) {
        const LevelTriangle t = triangle_of(small_levels[0], i);
        for (int k = 0; k < 3; ++k) {
            const Vector &a = t.corners[k], &b = t.corners[(k + 1) % 3];
            const bool is_open = a.z == 0 && b.z == 0;
            const bool is_inside = t.material == 3 && (b - a).y != 0 && (b - a).x != 0;
            EXPECT_EQ(t.edge(k) == ingot::EdgeKind::border, is_open);
            if (is_inside) {
                EXPECT_EQ(t.edge(k), ingot::EdgeKind::flat);
            }
        }
    }
}

/// Whatever a field has beside its heights.
TEST(LevelTables, of_heights_by_the_compiler_are_those_of_the_tool) {
    constexpr unsigned columns = 7, rows = 5;
    Random random(30);
    for (int round = 0; round < 16; ++round) {
        const Field made = field(random, columns, rows, round % 2 != 0, round % 4 / 2 * 5, [&](int, int) { return between(random, 0, 65535); });
        const LevelTable& tool = made.view;
        uint16_t samples[columns * rows];
        std::copy(made.heights.begin(), made.heights.end(), samples);
        const ingot::HeightFieldOptions beside = {tool.heights.cells, tool.heights.other_diagonal, tool.origin};
        const auto host = ingot::height_field_of<columns, rows>(samples, tool.heights.spacing_x, tool.heights.spacing_y, tool.step, beside);
        ASSERT_EQ(host.status, Status::ok);
        EXPECT_EQ(host.value.view().checksum, tool.checksum);
        EXPECT_EQ(host.value.view().heights.other_diagonal, tool.heights.other_diagonal);
        EXPECT_EQ(check_level(host.value.view()), Status::ok);
    }
}

void shuffle(Soup& soup, Random& random) {
    std::vector<int> order(soup.points.size());
    std::iota(order.begin(), order.end(), 0);
    for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    std::vector<ingot::LatticePoint> points(soup.points.size());
    for (size_t i = 0; i < order.size(); ++i) points[static_cast<size_t>(order[i])] = soup.points[i];
    soup.points = points;
    for (LevelFace& face : soup.faces) {
        int c[3] = {order[static_cast<size_t>(face.a)], order[static_cast<size_t>(face.b)], order[static_cast<size_t>(face.c)]};
        std::rotate(c, c + random() % 3, c + 3);
        face = {c[0], c[1], c[2], face.material};
    }
    for (size_t i = soup.faces.size(); i > 1; --i) std::swap(soup.faces[i - 1], soup.faces[random() % i]);
}

/// Each corner a point of its own for each triangle that has it: what scanners and some modelling programs write.
Soup taken_apart(const Soup& soup) {
    Soup apart;
    for (const LevelFace& face : soup.faces) {
        const int first = static_cast<int>(apart.points.size());
        for (int corner : {face.a, face.b, face.c}) apart.points.push_back(soup.points[static_cast<size_t>(corner)]);
        apart.faces.push_back({first, first + 1, first + 2, face.material});
    }
    return apart;
}

TEST(LevelTables, are_the_same_bytes_whatever_the_order_of_the_input) {
    Random random(31);
    for (int round = 0; round < 12; ++round) {
        Soup soup = round % 3 == 0   ? loose_triangles(random, 300, 500, 40)
                    : round % 3 == 1 ? terrain(random, 16, 100, [&](int, int) { return between(random, 0, 2) * 100; })
                                     : village(random, 4);
        const level_tool::MeshData first = built(soup);
        ASSERT_EQ(check_level(first.view), Status::ok);
        for (int again = 0; again < 4; ++again) {
            shuffle(soup, random);
            EXPECT_EQ(bytes_of(built(soup).view), bytes_of(first.view));
        }
        Soup apart = taken_apart(soup);
        shuffle(apart, random);
        EXPECT_EQ(bytes_of(built(apart).view), bytes_of(first.view));
    }
}

TEST(LevelTables, hold_every_triangle_that_has_an_area_once) {
    Random random(32);
    for (int round = 0; round < 8; ++round) {
        // On few points many triangles are lines, and many are there twice.
        const Soup soup = loose_triangles(random, 400, 4, 4);
        std::vector<std::vector<uint64_t>> given, told;
        const auto rotated = [](std::vector<uint64_t> keys) {
            std::rotate(keys.begin(), std::min_element(keys.begin(), keys.end()), keys.end());
            return keys;
        };
        for (const LevelFace& f : soup.faces) {
            const auto point = [&](int i) { return soup.points[static_cast<size_t>(i)]; };
            if (!ingot::lattice::has_area(point(f.a), point(f.b), point(f.c))) continue;
            using ingot::lattice::key_of_point;
            given.push_back(rotated({key_of_point(point(f.a)), key_of_point(point(f.b)), key_of_point(point(f.c))}));
        }
        std::sort(given.begin(), given.end());
        const size_t with_area = given.size();
        given.erase(std::unique(given.begin(), given.end()), given.end());
        const level_tool::MeshData mesh = built(soup);
        for (const ingot::LatticeTriangle& t : mesh.triangles)
            told.push_back(
                rotated({ingot::lattice::key_of_point(mesh.corners[t.corners[0]]), ingot::lattice::key_of_point(mesh.corners[t.corners[1]]),
                         ingot::lattice::key_of_point(mesh.corners[t.corners[2]])}));
        std::sort(told.begin(), told.end());
        EXPECT_EQ(told, given);
        EXPECT_EQ(mesh.without_area, static_cast<int>(soup.faces.size() - with_area));
        EXPECT_EQ(mesh.doubled, static_cast<int>(with_area - given.size()));
        EXPECT_EQ(check_level(mesh.view), Status::ok);
    }
}

TEST(LevelTables, scale_by_powers_of_two_to_the_bit) {
    Random random(33);
    const Soup soup = terrain(random, 16, 300, [&](int, int) { return between(random, 0, 2000); });
    const level_tool::MeshData one = built(soup, scalar(1) / 1024, -70000, 123, 9);
    for (const scalar factor : {scalar(0.5), scalar(64), scalar(1) / 256}) {
        const level_tool::MeshData other = built(soup, factor / 1024, -70000, 123, 9);
        ASSERT_EQ(other.view.mesh.triangle_count, one.view.mesh.triangle_count);
        for (int i = 0; i < 3000; ++i) {
            const auto draw = [&] { return static_cast<scalar>(random() % 65536) / 65536; };
            const Vector size = one.view.high - one.view.low, low = one.view.low + scaled(size, {draw(), draw(), draw()});
            const Vector high = low + size * (draw() / 16);
            std::vector<uint32_t> told, told_other;
            for_triangles_in(one.view, low, high, [&](const LevelTriangle& t) { told.push_back(t.number); });
            for_triangles_in(other.view, low * factor, high * factor, [&](const LevelTriangle& t) { told_other.push_back(t.number); });
            ASSERT_EQ(told, told_other);
            const Vector way = scaled(size, {draw() - scalar(0.5), draw() - scalar(0.5), -2 * draw()});
            ingot::LevelHit hit{}, hit_other{};
            ASSERT_EQ(cast_ray_on_level(one.view, high, way, hit), cast_ray_on_level(other.view, high * factor, way * factor, hit_other));
            ASSERT_EQ(hit.triangle, hit_other.triangle);
            ASSERT_EQ(hit.fraction, hit_other.fraction);
        }
    }
}

// ---- refusals

TEST(LevelTables, are_refused_where_they_would_be_none) {
    const Vector corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const LevelFace one[] = {{0, 1, 2}};
    EXPECT_EQ(ingot::mesh_of(corners, one).status, Status::ok);
    const LevelFace beyond[] = {{0, 1, 3}}, negative[] = {{0, -1, 2}}, line[] = {{0, 1, 1}};
    EXPECT_EQ(ingot::mesh_of(corners, beyond).status, Status::out_of_range);
    EXPECT_EQ(ingot::mesh_of(corners, negative).status, Status::out_of_range);
    EXPECT_EQ(ingot::mesh_of(corners, line).status, Status::bad_shape);
    for (const scalar x : {not_a_number, infinity, -infinity}) {
        const Vector bad[] = {{0, 0, 0}, {1, x, 0}, {0, 1, 0}};
        EXPECT_EQ(ingot::mesh_of(bad, one).status, Status::not_finite);
        EXPECT_EQ(ingot::mesh_of(corners, one, x).status, Status::out_of_range);
    }
    for (const scalar step : {scalar(0), scalar(-1), scalar(0.1), scalar(3), scalar(1e30)})
        EXPECT_EQ(ingot::mesh_of(corners, one, step).status, Status::out_of_range);
    // Small triangles are points, on the lattice.
    EXPECT_EQ(ingot::mesh_of(corners, one, scalar(4)).status, Status::bad_shape);
    const Vector wide[] = {{0, 0, 0}, {65, 0, 0}, {0, 1, 0}}, far[] = {{scalar(2e9), 0, 0}, {scalar(2e9), 1, 0}, {scalar(2e9), 0, 1}};
    EXPECT_EQ(ingot::mesh_of(wide, one).status, Status::out_of_range);
    EXPECT_EQ(ingot::mesh_of(wide, one, scalar(1) / 512).status, Status::ok);
    EXPECT_EQ(ingot::mesh_of(far, one).status, Status::out_of_range);

    static constexpr uint16_t flat[4] = {};
    const auto field = [](scalar spacing, scalar step, const Vector& origin) {
        return ingot::height_field_of<2, 2>(flat, spacing, spacing, step, {nullptr, false, origin}).status;
    };
    EXPECT_EQ(field(1, 1, {}), Status::ok);
    EXPECT_EQ(field(not_a_number, 1, {}), Status::not_finite);
    EXPECT_EQ(field(1, 1, {0, infinity, 0}), Status::not_finite);
    EXPECT_EQ(field(0, 1, {}), Status::out_of_range);
    EXPECT_EQ(field(-1, 1, {}), Status::out_of_range);
    EXPECT_EQ(field(1, scalar(0.3), {}), Status::out_of_range);
    EXPECT_EQ(field(1, 1, {0, 0, scalar(0.5)}), Status::out_of_range);
    EXPECT_EQ(field(1, 1, {INGOT_DOUBLE ? scalar(1e16) : scalar(1e8), 0, 0}), Status::out_of_range);
}

/// Of the tool, too, which comes by the door of its own.
TEST(LevelTables, of_faces_that_name_no_corner_are_refused) {
    Random random(39);
    for (int round = 0; round < 64; ++round) {
        Soup soup = village(random, 2);
        const int count = static_cast<int>(soup.points.size());
        LevelFace& face = soup.faces[random() % soup.faces.size()];
        int* const corners[] = {&face.a, &face.b, &face.c};
        *corners[round % 3] = round % 2 == 0 ? -between(random, 1, 9) : count + between(random, 0, 9);
        level_tool::MeshData refused;
        EXPECT_EQ(level_tool::build_mesh(soup.points, soup.faces, {0, 0, 0}, scalar(1) / 1024, refused), Status::out_of_range);
    }
}

TEST(LevelTables, whose_frame_is_wrong_are_refused) {
    Random random(35);
    const level_tool::MeshData mesh = built(village(random, 3));
    const Field hills = field(random, 9, 9, false, 0, [](int column, int row) { return column * row; });
    EXPECT_EQ(ingot::check_level({}), Status::bad_shape);
    Field in_bytes = field(random, 9, 9, false, 0, [](int column, int row) { return column * row; });
    (void)level_tool::put_into_bytes(in_bytes, 9, 9);
    finish_heights(in_bytes, 9, 9);
    ASSERT_EQ(check_level(in_bytes.view), Status::ok);
    LevelTable both = in_bytes.view, neither = in_bytes.view, no_blocks = in_bytes.view;
    both.heights.heights = hills.view.heights.heights;
    neither.heights.bytes = nullptr;
    no_blocks.heights.blocks = nullptr;
    for (const LevelTable& bad : {both, neither, no_blocks}) EXPECT_EQ(check_level(bad), Status::bad_shape);
    const LevelTable* const levels[] = {&mesh.view, &hills.view, &in_bytes.view};
    for (const LevelTable* level : levels) {
        for (int fault = 0; fault < 12; ++fault) {
            LevelTable bad = *level;
            switch (fault) {
                case 0: bad.step *= 2; break;
                case 1: bad.step *= scalar(1.5); break;
                case 2: bad.step = not_a_number; break;
                case 3: bad.origin.z += bad.step / 2; break;
                case 4: bad.origin.x = not_a_number; break;
                case 5: bad.low.x -= 1; break;
                case 6: bad.high.z += 1; break;
                case 7: ++bad.checksum; break;
                case 8: bad.mesh.corners = nullptr, bad.heights.heights = nullptr, bad.heights.bytes = nullptr; break;
                case 9: bad.mesh.node_count = 0, bad.heights.spacing_x = 0; break;
                case 10: bad.mesh.triangle_count = static_cast<uint16_t>(bad.mesh.triangle_count / 2), bad.heights.rows = 1; break;
                default: bad.mesh = mesh.view.mesh, bad.heights = hills.view.heights; break;
            }
            EXPECT_EQ(check_level(bad), Status::bad_shape) << fault;
        }
    }
}

// ---- sizes

double bytes_a_triangle(const LevelTable& level) {
    const ingot::MeshTable& mesh = level.mesh;
    return static_cast<double>(mesh.corner_count * sizeof(ingot::LatticePoint) + mesh.triangle_count * sizeof(ingot::LatticeTriangle) +
                               mesh.node_count * sizeof(ingot::MeshNode)) /
           mesh.triangle_count;
}

/// Samples of a field as its table has them.
std::vector<uint16_t> samples_in(const ingot::HeightTable& heights) {
    std::vector<uint16_t> samples;
    for (int row = 0; row < heights.rows; ++row)
        for (int column = 0; column < heights.columns; ++column)
            samples.push_back(static_cast<uint16_t>(ingot::grid::height_at(heights, column, row)));
    return samples;
}

/// Fields of every relief, from flat to cliffs: a sample moves by half a step of its block at most (by one, where half of one would be beyond 65535),
/// none where the block is no higher than 255 steps; and the field is the one of the samples as they are now, triangle by triangle.
TEST(LevelTables, in_bytes_are_the_field_of_the_nearest_samples) {
    Random random(45);
    int moved_fields = 0;
    for (int field_i = 0; field_i < (INGOT_TEST_BRIEF ? 60 : 400); ++field_i) {
        const int columns = between(random, 2, 70), rows = between(random, 2, 50), top = 65535 >> between(random, 0, 16);
        const auto relief = [&](int, int) { return between(random, field_i % 3 == 0 ? top - top / 2 : 0, top); };
        const Field words = field(random, columns, rows, field_i % 2 != 0, field_i % 5, relief);
        Field bytes = field(random, columns, rows, field_i % 2 != 0, 0, relief);
        bytes.heights = words.heights, bytes.cells = words.cells;
        const int furthest = level_tool::put_into_bytes(bytes, columns, rows);
        finish_heights(bytes, columns, rows);
        ASSERT_EQ(check_level(bytes.view), Status::ok);
        const std::vector<uint16_t> now = samples_in(bytes.view.heights);
        int most = 0;
        for (size_t i = 0; i < now.size(); ++i) {
            const size_t column = i % static_cast<size_t>(columns), row = i / static_cast<size_t>(columns);
            const ingot::HeightBlock& block = bytes.blocks[row / 16 * static_cast<size_t>((columns + 15) / 16) + column / 16];
            const int moved = std::abs(now[i] - words.heights[i]), step = 1 << block.shift;
            EXPECT_LE(moved, words.heights[i] + step / 2 > 65535 ? step : step / 2);
            if (top <= 255) {
                EXPECT_EQ(block.shift, 0);
            }
            most = std::max(most, moved);
        }
        EXPECT_EQ(furthest, most);
        moved_fields += most > 0 ? 1 : 0;

        Field again = field(random, columns, rows, field_i % 2 != 0, 0, relief);
        again.heights = now, again.cells = words.cells;
        finish_heights(again, columns, rows);
        EXPECT_EQ(again.extremes, bytes.extremes);
        for (const uint32_t number : triangles_of(again.view)) {
            const LevelTriangle a = triangle_of(again.view, number), b = triangle_of(bytes.view, number);
            for (int i = 0; i < 3; ++i)
                EXPECT_TRUE(a.corners[i].x == b.corners[i].x && a.corners[i].y == b.corners[i].y && a.corners[i].z == b.corners[i].z);
            EXPECT_TRUE(a.edges == b.edges && a.material == b.material && a.number == b.number);
        }
        const Vector from{static_cast<scalar>(between(random, 0, 80)) / 2, static_cast<scalar>(between(random, 17, 57)), 500}, way{3, -2, -900};
        ingot::LevelHit hit_a{}, hit_b{};
        EXPECT_EQ(cast_ray_on_level(again.view, from, way, hit_a), cast_ray_on_level(bytes.view, from, way, hit_b));
        EXPECT_EQ(hit_a.fraction, hit_b.fraction);
    }
    EXPECT_GT(moved_fields, 10);
}

TEST(LevelTables, take_sixteen_bytes_a_triangle_and_two_or_one_a_sample) {
    Random random(36);
    const level_tool::MeshData hills = built(terrain(
        random, 97, 600, [](int x, int y) { return static_cast<int>(3000 + 1500 * std::sin(0.13 * x) + 1200 * std::cos(0.1 * y + 0.05 * x)); }));
    EXPECT_LE(bytes_a_triangle(hills.view), 14);
    RecordProperty("terrain", std::to_string(bytes_a_triangle(hills.view)));
    const level_tool::MeshData houses = built(village(random, 30));
    EXPECT_LE(bytes_a_triangle(houses.view), 16);
    const Field field_of_hills = field(random, 200, 200, false, 0, [](int column, int row) { return column * row; });
    EXPECT_LE(static_cast<double>(sizeof(uint16_t) * (field_of_hills.heights.size() + field_of_hills.extremes.size())) / (200 * 200), 2.1);
    Field in_bytes = field(random, 200, 200, false, 0, [](int column, int row) { return column * row; });
    (void)level_tool::put_into_bytes(in_bytes, 200, 200);
    EXPECT_LE(static_cast<double>(in_bytes.bytes.size() + sizeof in_bytes.blocks[0] * in_bytes.blocks.size() +
                                  sizeof in_bytes.extremes[0] * in_bytes.extremes.size()) / (200 * 200), 1.1);
    std::printf("%.2f and %.2f bytes a triangle\n", bytes_a_triangle(hills.view), bytes_a_triangle(houses.view));
}

TEST(LevelTables, hold_65535_triangles_and_no_more) {
    Random random(37);
    Soup soup = terrain(random, 181, 300, [&](int, int) { return between(random, 0, 3000); });
    while (soup.faces.size() > 65535) soup.faces.pop_back();
    while (soup.faces.size() < 65535) soup.faces.push_back({0, static_cast<int>(soup.faces.size() % 9000) + 1, 20000});
    const level_tool::MeshData mesh = built(soup);
    ASSERT_GT(mesh.view.mesh.triangle_count, 65000);
    EXPECT_EQ(check_level(mesh.view), Status::ok);
    shuffle(soup, random);
    EXPECT_EQ(built(soup).view.checksum, mesh.view.checksum);
    soup = loose_triangles(random, 65536, 60000, 5000);
    level_tool::MeshData refused;
    EXPECT_EQ(level_tool::build_mesh(soup.points, soup.faces, {0, 0, 0}, scalar(1) / 1024, refused), Status::no_room);
}

/// Triangles that are larger each than the one before, which the surface-area rule would peel off one by one: the depth is bounded all the same.
TEST(LevelTables, are_no_deeper_than_twelve_nodes) {
    Random random(38);
    for (int round = 0; round < 10; ++round) {
        Soup soup;
        for (int size = 1; size < 65535; size = size + std::max(1, size / (4 << round)))
            for (int k = 0; k < 40 && soup.faces.size() < 30000; ++k) {
                const int first = static_cast<int>(soup.points.size());
                soup.points.push_back(lattice_point(0, 0, k));
                soup.points.push_back(lattice_point(size, 0, k));
                soup.points.push_back(lattice_point(0, size, k));
                soup.faces.push_back({first, first + 1, first + 2});
            }
        const level_tool::MeshData mesh = built(soup);
        ASSERT_FALSE(mesh.triangles.empty());
        EXPECT_EQ(check_level(mesh.view), Status::ok);  // the depth among other things
        size_t told = 0;
        for_triangles_in(mesh.view, mesh.view.low, mesh.view.high, [&](const LevelTriangle&) { ++told; });
        EXPECT_EQ(told, mesh.triangles.size());
    }
}

}  // namespace
