// SPDX-License-Identifier: MIT
// ingot beside Box3D on one mesh: 512 bodies are let go over 8192 triangles, flat or hills, and both take turns step by step, on one thread, without
// sleep. Prints ms a step of each, the share of Box3D's time, and how fast the bodies are in the end: a pile that lies still takes what it takes to.
#include <box3d/box3d.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "level/ground.h"

namespace {

using namespace level_test;

struct Pile : ingot::Scene {
    static constexpr int max_bodies = 516, max_manifolds = 6000, max_pairs = 14000;
    static constexpr bool translates = true;
    using broad_phase = ingot::SortedTree;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Level>;
    static inline LevelTable levels[1] = {};
};

constexpr int cells = 64, grain = 256, side = 8, steps = 360, late = 240;
constexpr float half = 0.25F, friction = 0.6F;
enum class Bodies { boxes, balls, both };

class Race {
public:
    Race(bool hills, Bodies bodies) : world_(empty_world<Pile>()) {
        b3WorldDef def = b3DefaultWorldDef();
        def.gravity = {0, 0, -9.81F};
        def.enableSleep = false;
        box3d_ = b3CreateWorld(&def);
        add_ground(hills);
        for (int i = 0; i < side * side * side; ++i) add(i, bodies == Bodies::balls || (bodies == Bodies::both && i % 2 != 0));
    }
    ~Race() {
        b3DestroyWorld(box3d_);
        b3DestroyMesh(mesh_);
    }
    Race(const Race&) = delete;
    Race& operator=(const Race&) = delete;

    void run(const char* name) {
        double ours = 0, theirs = 0, ours_late = 0, theirs_late = 0;
        for (int i = 0; i < steps; ++i) {
            const auto begin = Clock::now();
            (void)ingot::step(world_, scalar(1) / 60);
            const auto middle = Clock::now();
            b3World_Step(box3d_, 1.0F / 60, 4);
            const double a = ms(begin, middle), b = ms(middle, Clock::now());
            ours += a, theirs += b;
            if (i >= late) ours_late += a, theirs_late += b;
        }
        std::printf("%-14s ingot %.3f ms, Box3D %.3f ms, share %.2f; last 2 s share %.2f; left m/s: %.3f, %.3f\n", name, ours / steps, theirs / steps,
                    ours / theirs, ours_late / theirs_late, speed_of_ours(), speed_of_theirs());
    }

private:
    using Clock = std::chrono::steady_clock;
    static double ms(Clock::time_point a, Clock::time_point b) { return std::chrono::duration<double, std::milli>(b - a).count(); }

    void add_ground(bool hills) {
        Random random(5);
        const Soup soup = terrain(random, cells, grain, [hills](int x, int y) {
            return hills ? static_cast<int>(1024 + 200 * std::sin(0.35 * x) + 160 * std::cos(0.3 * y + 0.15 * x)) : 1024;
        });
        take_mesh(soup, 1.0 / grain, ground_);
        add_level(world_, ground_.view, scalar(friction));
        std::vector<b3Vec3> corners;
        std::vector<std::int32_t> indices;
        for (const auto& p : soup.points)
            corners.push_back({static_cast<float>(p.x) / grain, static_cast<float>(p.y) / grain, static_cast<float>(p.z) / grain});
        for (const ingot::LevelFace& face : soup.faces) indices.insert(indices.end(), {face.a, face.b, face.c});
        b3MeshDef mesh = {};
        mesh.vertices = corners.data();
        mesh.indices = indices.data();
        mesh.vertexCount = static_cast<int>(corners.size());
        mesh.triangleCount = static_cast<int>(indices.size() / 3);
        mesh.identifyEdges = true;
        mesh_ = b3CreateMesh(&mesh, nullptr, 0);
        const b3BodyDef body = b3DefaultBodyDef();
        const b3ShapeDef surface = surface_of(1);
        b3CreateMeshShape(b3CreateBody(box3d_, &body), &surface, mesh_, {1, 1, 1});
    }
    static b3ShapeDef surface_of(float density) {
        b3ShapeDef surface = b3DefaultShapeDef();
        surface.density = density;
        surface.baseMaterial.friction = friction;
        return surface;
    }
    void add(int i, bool ball) {
        const auto along = [](int k, int off) { return 32 + 0.62F * static_cast<float>(k - side / 2) + 0.01F * static_cast<float>(off); };
        const float x = along(i % side, i % 7), y = along(i / side % side, i % 5), z = 6.2F + 0.62F * static_cast<float>(i / side / side);
        BodyDef def;
        def.friction = scalar(friction);
        def.state.r_CM = {scalar(x), scalar(y), scalar(z)};
        const Vector size = {scalar(half), scalar(half), scalar(half)};
        b3BodyDef body = b3DefaultBodyDef();
        body.type = b3_dynamicBody;
        body.enableSleep = false;
        body.position = {x, y, z};
        const b3BodyId added = b3CreateBody(box3d_, &body);
        const b3ShapeDef surface = surface_of(1000);
        if (ball) {
            def.shape = ingot::Sphere{size.x};
            def.mass = ingot::principal(ingot::solid_sphere(1000, size.x)).value;
            const b3Sphere sphere = {{0, 0, 0}, half};
            b3CreateSphereShape(added, &surface, &sphere);
        } else {
            def.shape = ingot::Box{size};
            def.mass = ingot::principal(ingot::solid_box(1000, size)).value;
            const b3BoxHull box = b3MakeBoxHull(half, half, half);
            b3CreateHullShape(added, &surface, &box.base);
        }
        ids_.push_back(world_.add(def).value);
        theirs_.push_back(added);
    }
    double speed_of_ours() const {
        double sum = 0;
        for (const BodyId id : ids_) sum += length(world_.state(id).value.v_CM);
        return sum / static_cast<double>(ids_.size());
    }
    double speed_of_theirs() const {
        double sum = 0;
        for (const b3BodyId id : theirs_) {
            const b3Vec3 v = b3Body_GetLinearVelocity(id);
            sum += static_cast<double>(std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
        }
        return sum / static_cast<double>(theirs_.size());
    }

    World<Pile>& world_;
    b3WorldId box3d_{};
    b3MeshData* mesh_ = nullptr;
    Ground ground_;
    std::vector<BodyId> ids_;
    std::vector<b3BodyId> theirs_;
};

}  // namespace

int main() {
    const struct {
        const char* name;
        bool hills;
        Bodies bodies;
    } heats[] = {{"boxes, flat", false, Bodies::boxes}, {"balls, flat", false, Bodies::balls},  {"both, flat", false, Bodies::both},
                 {"boxes, hills", true, Bodies::boxes}, {"balls, hills", true, Bodies::balls}, {"both, hills", true, Bodies::both}};
    for (const auto& heat : heats) Race(heat.hills, heat.bodies).run(heat.name);
    return 0;
}
