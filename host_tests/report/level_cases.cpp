// SPDX-License-Identifier: MIT
// Ground of triangles in one build of the kernel. Compiled for float and for double, each in namespaces of its own: names of tests do not carry the
// scalar as the kernel's do.
#include <ingot/ingot.h>
#define level_test INGOT_JOIN(level_test_, INGOT_ABI, )
#define level_tool INGOT_JOIN(level_tool_, INGOT_ABI, )

#include "level_cases.h"

#include <algorithm>
#include <chrono>

#include "level/ground.h"

namespace report {

namespace {

using namespace level_test;

constexpr const char* ground_names[seams_count] = {"grid", "fan", "slivers", "flush boxes", "field"};
constexpr const char* body_names[goers_count] = {"ball", "box", "wheel", "roller", "coin", "pebble"};

/// One draw, 1 to 20 m/s fast; the worst stay in `worst`.
void go_over(Random& random, Seams seams, Goer kind, int rate, OverGround& worst) {
    const Ground ground = plane_of(random, seams);
    const double speed = about(random, 1, 20), size = about(random, 0.05, 0.8);
    BodyDef def = goer(random, kind, static_cast<scalar>(size), speed);
    def.state.r_CM = def.state.r_CM + ground.middle;
    const int steps = static_cast<int>(std::min(2.0, ground.reach / speed) * rate);
    const Went as = go_on_slab(ground.middle.z, def, rate, steps);
    auto& on_level = empty_world<OnLevel>();
    (void)add_level(on_level, ground.view);
    const Went went = go(on_level, def, rate, steps);
    worst.way = std::max(worst.way, std::abs(length(went.by) / length(as.by) - 1));
    worst.speed = std::max(worst.speed, length(went.v - as.v) / speed);
    worst.hop = std::max({worst.hop, std::abs(went.hop - as.hop), std::abs(went.sink - as.sink)});
    worst.impulse = std::max(worst.impulse, std::abs(went.impulse / as.impulse - 1));
}

template <class Work>
double seconds_of(int repeats, const Work& work) {
    double least = 1e30;
    for (int i = 0; i < repeats; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return least;
}

constexpr int sliding_boxes = 64, sliding_steps = 60;

/// ns a body and step of boxes that slide over cells of a metre, each by itself.
template <class AddGround>
double cost_of_sliding(int repeats, const AddGround& add_ground) {
    return 1e9 / (sliding_boxes * sliding_steps) * seconds_of(repeats, [&] {
        auto& world = empty_world<OnLevel>();
        add_ground(world);
        const scalar half = scalar(0.25);
        BodyDef def;
        def.mass = ingot::principal(ingot::solid_box(80, {half, half, half})).value;
        def.shape = ingot::Box{{half, half, half}};
        def.friction = scalar(0.05);
        for (int i = 0; i < sliding_boxes; ++i) {
            def.state.r_CM = {static_cast<scalar>(8 + 10 * (i % 8)), static_cast<scalar>(8 + 10 * (i / 8)), 4 + half};
            def.state.v_CM = {3, scalar(0.1) * static_cast<scalar>(i % 8), 0};
            (void)world.add(def);
        }
        for (int i = 0; i < sliding_steps; ++i) (void)ingot::step(world, scalar(1) / 60);
    });
}

constexpr int cells = 95, grain = 64;

Field flat_field(bool in_bytes) {
    Field field;
    field.heights.assign((cells + 1) * (cells + 1), 4 * grain);
    field.view.heights.spacing_x = field.view.heights.spacing_y = 1;
    field.view.step = scalar(1) / grain;
    if (in_bytes) (void)level_tool::put_into_bytes(field, cells + 1, cells + 1);
    finish_heights(field, cells + 1, cells + 1);
    return field;
}

double bytes_of(const level_tool::MeshData& mesh) {
    return static_cast<double>(sizeof mesh.corners[0] * mesh.corners.size() + sizeof mesh.triangles[0] * mesh.triangles.size() +
                               sizeof mesh.nodes[0] * mesh.nodes.size());
}
double bytes_of(const Field& field) {
    const std::size_t samples = field.bytes.empty() ? sizeof field.heights[0] * field.heights.size()
                                                    : field.bytes.size() + sizeof(ingot::HeightBlock) * field.blocks.size();
    return static_cast<double>(samples + sizeof field.extremes[0] * field.extremes.size());
}

int hill(int x, int y) { return static_cast<int>(3000 + 1500 * std::sin(0.13 * x) + 1200 * std::cos(0.1 * y + 0.05 * x)); }

/// ns of a box of two metres that asks for its triangles, and of a ray down onto the ground.
void add_queries(const char* name, const LevelTable& level, int repeats, std::vector<OfGround>& of) {
    constexpr int queries = 4000;
    Random random(11);
    std::vector<Vector> at;
    const Vector size = level.high - level.low;
    for (int i = 0; i < queries; ++i)
        at.push_back(level.low + Vector{size.x * static_cast<scalar>(share(random)), size.y * static_cast<scalar>(share(random)), 0});
    std::size_t told = 0;
    const double walks = seconds_of(repeats, [&] {
        for (const Vector& p : at)
            for_triangles_in(level, p - Vector{1, 1, 0}, p + Vector{1, 1, size.z}, [&told](const ingot::LevelTriangle&) { ++told; });
    });
    const double rays = seconds_of(repeats, [&] {
        ingot::LevelHit hit;
        for (const Vector& p : at) told += cast_ray_on_level(level, p + Vector{0, 0, size.z + 1}, {0, 0, -size.z - 2}, hit) ? 1u : 0u;
    });
    of.push_back({name, "walk_ns", 1e9 * walks / queries, "ns"});
    of.push_back({name, "ray_ns", 1e9 * rays / queries, "ns"});
    if (told == 0) of.push_back({name, "told", 0, "1"});
}

void add_sizes(int repeats, std::vector<OfGround>& of) {
    Random random(36);
    const level_tool::MeshData terrain_mesh = built(terrain(random, 97, 600, hill)), houses = built(village(random, 30));
    Field words = field(random, 200, 200, false, 0, hill), bytes = field(random, 200, 200, false, 0, hill);
    (void)level_tool::put_into_bytes(bytes, 200, 200);
    finish_heights(bytes, 200, 200);
    of.push_back({"terrain", "bytes_per_triangle", bytes_of(terrain_mesh) / terrain_mesh.view.mesh.triangle_count, "bytes"});
    of.push_back({"village", "bytes_per_triangle", bytes_of(houses) / houses.view.mesh.triangle_count, "bytes"});
    of.push_back({"field", "bytes_per_sample", bytes_of(words) / 40000, "bytes"});
    of.push_back({"field in bytes", "bytes_per_sample", bytes_of(bytes) / 40000, "bytes"});
    add_queries("terrain", terrain_mesh.view, repeats, of);
    add_queries("village", houses.view, repeats, of);
    add_queries("field", words.view, repeats, of);
    add_queries("field in bytes", bytes.view, repeats, of);
}

void add_costs(int repeats, std::vector<OfGround>& of) {
    Random random(1);
    const level_tool::MeshData mesh = built(terrain(random, cells, grain, [](int, int) { return 4 * grain; }), scalar(1) / grain);
    const Field words = flat_field(false), bytes = flat_field(true);
    const auto on = [repeats](const LevelTable& table) {
        return cost_of_sliding(repeats, [&table](World<OnLevel>& world) { (void)add_level(world, table, scalar(0.05)); });
    };
    const double slab = cost_of_sliding(repeats, [](World<OnLevel>& world) {
        BodyDef def;
        def.immovable = true;
        def.shape = ingot::Box{{scalar(cells) / 2, scalar(cells) / 2, 2}};
        def.state.r_CM = {scalar(cells) / 2, scalar(cells) / 2, 2};
        def.friction = scalar(0.05);
        (void)world.add(def);
    });
    of.push_back({"slab", "box_ns", slab, "ns"});
    of.push_back({"terrain", "box_ns", on(mesh.view), "ns"});
    of.push_back({"field", "box_ns", on(words.view), "ns"});
    of.push_back({"field in bytes", "box_ns", on(bytes.view), "ns"});
}

LevelFigures figures(int draws, int repeats) {
    LevelFigures all;
    all.scalar = sizeof(scalar) == 4 ? "float" : "double";
    all.lanes = ingot::lanes;
    for (int seams = 0; seams < seams_count; ++seams)
        for (int body = 0; body < goers_count; ++body)
            for (const int rate : level_rates) {
                OverGround worst;
                worst.ground = ground_names[seams], worst.body = body_names[body], worst.rate = rate;
                Random random(static_cast<uint64_t>(7000 + 100 * seams + 10 * body));
                for (int draw = 0; draw < draws; ++draw) go_over(random, static_cast<Seams>(seams), static_cast<Goer>(body), rate, worst);
                all.over.push_back(worst);
            }
    add_sizes(repeats, all.of);
    add_costs(repeats, all.of);
    return all;
}

}  // namespace

#if INGOT_DOUBLE
LevelFigures level_figures_of_double(int draws, int repeats) { return figures(draws, repeats); }
#else
LevelFigures level_figures_of_float(int draws, int repeats) { return figures(draws, repeats); }
#endif

}  // namespace report
