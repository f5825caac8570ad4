// SPDX-License-Identifier: MIT
// Two worlds that differ in their broad phase alone, of which all that is done to the one is done to the other: what they answer is compared to
// the bit. One looks at all bodies, the other goes through the tree.
#pragma once

#include <cstring>

#include "query/field.h"
#include "scenes/hulls.h"

namespace query_twins {

using namespace query_field;

/// Bodies of every kind.
template <class Search, int bodies, int shapes_of_body, bool sleepy, bool follows>
struct Yard : ingot::Scene {
    static constexpr int max_bodies = bodies;
    static constexpr int max_manifolds = 8 * bodies < 9000 ? 8 * bodies : 9000;
    static constexpr int max_pairs = 6 * max_manifolds;
    static constexpr int max_overlaps = bodies;
    static constexpr int max_shapes_of_body = shapes_of_body;
    static constexpr bool translates = true, filters = true, kinematic_bodies = true, sleeps = sleepy, continuous = follows;
    using broad_phase = Search;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {scenes::rock_hull.hull.value.view(), scenes::octahedron_hull.hull.value.view()};
};

/// How the bodies of a world lie.
struct Cloud {
    double place, least, most;  ///< m: within +- place, and sizes
};

template <class S, class T>
struct Twins {
    using All = S;
    using ByTree = T;

    RandomInput random;
    Cloud cloud;
    std::unique_ptr<World<S>> all = std::make_unique<World<S>>();
    std::unique_ptr<World<T>> tree = std::make_unique<World<T>>();
    std::vector<BodyId> ids{};
    int answered = 0, edits = 0, refused = 0;

    Twins(std::uint64_t seed, const Cloud& where) : random(seed), cloud(where) {}

    /// Does the same to both; what they answer is the same.
    template <class Call>
    auto both(const Call& call) {
        const auto a = call(*all);
        const auto b = call(*tree);
        if constexpr (std::is_same_v<std::remove_const_t<decltype(a)>, Status>) {
            EXPECT_EQ(a, b);
            refused += a == Status::ok ? 0 : 1;
        } else {
            EXPECT_EQ(a.status, b.status);
            refused += a.ok() ? 0 : 1;
        }
        return a;
    }

    scalar length() { return static_cast<scalar>(cloud.least * std::pow(cloud.most / cloud.least, random.real(0, 1))); }
    Vector somewhere() { return to_vector(random.vector(cloud.place)); }
    BodyId one() { return ids[static_cast<std::size_t>(random.integer(0, static_cast<int>(ids.size()) - 1))]; }
    Shape shape() {
        switch (random.integer(0, 4)) {
            case 0: return ingot::Sphere{length()};
            case 1: return ingot::Capsule{length(), length()};
            case 2: return ingot::Box{{length(), length(), length()}};
            case 3: return ingot::Cylinder{length(), length()};
            default: return ingot::hull_of<S>(random.integer(0, 1));
        }
    }
    ingot::Matrix turn() { return random.integer(0, 2) == 0 ? ingot::identity_matrix<scalar>() : to_matrix(random.rotation()); }

    BodyDef any_body() {
        BodyDef def;
        def.mass = {1, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
        def.shape = shape();
        def.state.r_CM = somewhere();
        def.state.A = turn();
        def.filter = {1u << random.integer(0, 3), random.integer(0, 3) == 0 ? 0x5u : 0xffffffffu};
        def.sensor = random.integer(0, 7) == 0;
        const int kind = random.integer(0, 11);
        def.immovable = kind <= 2;
        def.kinematic = kind == 3;
        if (kind == 0) {  // level along an axis, or tilted by very little, or anyhow
            const int axis = random.integer(0, 5);
            const Eigen::Vector3d along = (axis < 3 ? 1 : -1) * Eigen::Vector3d::Unit(axis % 3);
            Eigen::Vector3d n = along;
            if (random.integer(0, 1) == 0) n = random.integer(0, 1) == 0 ? (along + random.vector(1e-4)).normalized().eval() : random.direction();
            def.shape = ingot::HalfSpace{to_vector(n), static_cast<scalar>(random.real(-cloud.place, 0) - 0.9 * cloud.place)};
            if (random.integer(0, 1) == 0) def.state.A = ingot::identity_matrix<scalar>();
        } else if (!def.immovable && random.integer(0, 1) == 0) {
            def.state.v_CM = to_vector(random.vector(3));
            if (def.kinematic) def.state.L = to_vector(random.vector(1));
        }
        return def;
    }
    void add() {
        BodyDef def = any_body();
        Result<BodyId> added{};
        if constexpr (S::max_shapes_of_body > 1) {
            if (def.shape.kind != ShapeKind::half_space && random.integer(0, 1) == 0) {
                ingot::ShapeDef parts[3];
                const int count = random.integer(1, 3);
                for (ingot::ShapeDef& part : parts) {
                    part.shape = shape();
                    part.r = to_vector(random.vector(3 * cloud.least));
                    part.A = turn();
                    part.sensor = random.integer(0, 5) == 0;
                }
                def.shape = {};
                def.sensor = false;
                added = both([&](auto& world) { return world.add(def, parts, count); });
                if (added.ok()) ids.push_back(added.value);
                return;
            }
        }
        added = both([&](auto& world) { return world.add(def); });
        if (added.ok()) ids.push_back(added.value);
    }
    void remove() {
        if (ids.empty()) return;
        const std::size_t which = static_cast<std::size_t>(random.integer(0, static_cast<int>(ids.size()) - 1));
        const BodyId id = ids[which];
        (void)both([&](auto& world) { return world.remove(id); });
        ids[which] = ids.back();
        ids.pop_back();
    }
    /// A body is another one, or elsewhere, from now on. What is refused is refused by both.
    void edit() {
        ++edits;
        if (ids.empty()) return add();
        const BodyId id = one();
        const int shape_i = random.integer(0, S::max_shapes_of_body - 1);
        const Shape other = random.integer(0, 9) == 0 ? Shape{} : shape();
        ingot::BodyState state = all->state(id).value;
        switch (random.integer(0, 17)) {
            case 0:
            case 1: return add();
            case 2: return remove();
            case 3: state.r_CM = somewhere(); break;
            case 4: state.r_CM = state.r_CM + to_vector(random.vector(cloud.least)); break;
            case 5: state.A = turn(); break;
            case 6: (void)both([&](auto& world) { return world.set_shape(id, other, shape_i); }); return;
            case 7: (void)both([&](auto& world) { return world.set_sensor(id, other.size.x > 1, shape_i); }); return;
            case 8: (void)both([&](auto& world) { return world.set_filter(id, {1u << shape_i, 0xffffffffu}); }); return;
            case 9: (void)both([&](auto& world) { return world.set_kinematic(id); }); return;
            case 10: (void)both([&](auto& world) { return world.set_velocity(id, state.r_CM * scalar(-0.1), {0, 1, 0}); }); return;
            case 11: (void)both([&](auto& world) { return world.move_to(id, state.r_CM * scalar(0.9), state.A); }); return;
            case 12: (void)both([&](auto& world) { return world.set_immovable(id); }); return;
            case 13:
                (void)both([&](auto& world) { return world.set_movable(id, {2, {1, 2, 2}, {}, ingot::identity_matrix<scalar>()}); });
                return;
            case 14: (void)both([&](auto& world) { return world.apply_central_impulse(id, state.r_CM * scalar(-2)); }); return;
            case 15:  // it freezes in the next step
                if (random.integer(0, 3) == 0)
                    (void)both([&](auto& world) { return world.add_torque(id, {0, 0, ingot::limits::torque_max}); });
                return;
            case 16:
                if constexpr (S::sleeps) (void)both([&](auto& world) { return world.sleep(id); });
                return;
            default:
                if constexpr (S::max_shapes_of_body > 1) {
                    const ingot::ShapePlace place = {to_vector(random.vector(4 * cloud.least)), turn()};
                    (void)both([&](auto& world) { return world.set_shape_place(id, place, shape_i); });
                }
                return;
        }
        (void)both([&](auto& world) { return world.set_state(id, state); });
    }
    void step() {
        const scalar h = random.integer(0, 1) == 0 ? scalar(1) / 60 : scalar(1) / 240;
        const ingot::StepReport a = ingot::step(*all, h), b = ingot::step(*tree, h);
        EXPECT_EQ(a.status, b.status);
        EXPECT_EQ(all->state_hash(), tree->state_hash()) << "steps are the same, too";
        for (const auto counter : {&ingot::StepReport::bodies_frozen, &ingot::StepReport::contacts, &ingot::StepReport::contacts_lost,
                                   &ingot::StepReport::pairs_untested, &ingot::StepReport::impacts_deferred, &ingot::StepReport::sweeps,
                                   &ingot::StepReport::overlaps_lost, &ingot::StepReport::sweeps_unfinished})
            EXPECT_EQ(a.*counter, b.*counter) << "and what they tell";
        EXPECT_EQ(a.residual, b.residual);
    }
    /// Both begin again from what was saved; and ids go on.
    void reload() {
        std::vector<std::uint8_t> bytes(ingot::snapshot_size<S>());
        const auto again = [&](auto& world) {
            const Result<std::size_t> size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
            ASSERT_TRUE(size.ok());
            ASSERT_EQ(ingot::load_snapshot(*world, bytes.data(), size.value), Status::ok);
        };
        again(all);
        again(tree);
    }

    QueryFilter any_filter() {
        QueryFilter filter;
        if (random.integer(0, 3) == 0) filter.filter = {1u << random.integer(0, 3), 0x7u};
        if (random.integer(0, 3) == 0) filter.sensors = true;
        if (random.integer(0, 3) == 0 && !ids.empty()) filter.except = one();
        return filter;
    }
    /// From anywhere: within a body, along a face of one, from far away.
    Vector any_point() {
        if (ids.empty() || random.integer(0, 1) == 0) return somewhere();
        const BodyId id = one();
        const ingot::BodyState state = all->state(id).value;
        const Shape its = all->shape(id).value;
        switch (random.integer(0, 3)) {
            case 0: return state.r_CM;
            case 1: return state.r_CM + state.A * Vector{its.size.x, 0, 0};
            case 2: return state.r_CM + state.A * its.size;
            default: return state.r_CM + to_vector(random.vector(2 * cloud.least));
        }
    }
    Vector any_way(const Vector& from) {
        const Vector towards = any_point() - from;
        const scalar length = std::sqrt(ingot::length_sq(towards));
        switch (random.integer(0, 5)) {
            case 0: return to_vector(Eigen::Vector3d(Eigen::Vector3d::Unit(random.integer(0, 2)) * random.real(-3, 3) * cloud.place));
            case 1: return to_vector(random.vector(cloud.least));
            case 2: return length > 0 ? towards * (scalar(1e6) / length) : Vector{0, 0, scalar(1e6)};
            case 3: return Vector{};  // refused
            default: return towards * static_cast<scalar>(random.real(0.3, 4));
        }
    }
    template <class Found>
    static std::vector<unsigned char> bytes_of(const Found& found) {
        const scalar number = [&] {
            if constexpr (std::is_same_v<Found, QueryHit>)
                return found.fraction;
            else
                return found.distance;
        }();
        const scalar numbers[] = {number, found.P.x, found.P.y, found.P.z, found.n.x, found.n.y, found.n.z};
        const std::uint32_t names[] = {found.body.slot, found.body.generation, static_cast<std::uint32_t>(found.shape)};
        std::vector<unsigned char> bytes(sizeof numbers + sizeof names);
        std::memcpy(bytes.data(), numbers, sizeof numbers);
        std::memcpy(bytes.data() + sizeof numbers, names, sizeof names);
        return bytes;
    }
    template <class Ask>
    void expect_same(const char* what, const Ask& ask) {
        const auto a = ask(*all);
        const auto b = ask(*tree);
        ASSERT_EQ(a.status, b.status) << what;
        ASSERT_EQ(bytes_of(a.value), bytes_of(b.value))
            << what << ": slots " << a.value.body.slot << " and " << b.value.body.slot << " found " << a.value.found() << b.value.found();
        answered += a.value.found() ? 1 : 0;
    }
    void ask() {
        const QueryFilter filter = any_filter();
        const Vector from = any_point(), way = any_way(from);
        const ingot::ConvexHull* const hull = &S::hulls[0];
        PlacedShape moving = {shape(), from, turn(), nullptr};
        if (moving.shape.kind == ShapeKind::hull) moving.hull = hull + static_cast<int>(moving.shape.size.y);
        expect_same("ray", [&](const auto& world) { return world.cast_ray(from, way, filter); });
        expect_same("cast", [&](const auto& world) { return world.cast_shape(moving, way, filter); });
        const auto within = static_cast<scalar>(random.integer(0, 5) == 0 ? 1e9 : random.real(0, 1) * cloud.place);
        expect_same("nearest", [&](const auto& world) { return world.find_nearest(from, within, filter); });

        const int capacity = random.integer(0, 1) == 0 ? random.integer(0, 4) : S::max_bodies;
        std::vector<BodyId> a(static_cast<std::size_t>(S::max_bodies) + 1), b = a;
        const Result<int> count_a = all->find_overlaps(moving, a.data(), capacity, filter);
        const Result<int> count_b = tree->find_overlaps(moving, b.data(), capacity, filter);
        ASSERT_EQ(count_a.status, count_b.status);
        ASSERT_EQ(count_a.value, count_b.value) << "overlaps";
        ASSERT_EQ(a, b) << "overlaps, and what lies behind them";
        answered += count_a.value;
    }
};

}  // namespace query_twins
