// SPDX-License-Identifier: MIT
// What a ray takes by the tree, in microseconds and as a share of looking at every body in the same run, through 1024 boxes and through a hundred
// thousand balls, capsules and boxes (tens of thousands with indices of 16 bits). Both have to answer the same, to the bit.
#include <ingot/ingot.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

namespace {

using ingot::scalar;
using ingot::Vector;

constexpr int most_bodies = ingot::index_max > 65535 ? 100000 : 30000;
constexpr scalar apart = scalar(1.1);  ///< m between the bodies of a lattice

template <class BroadPhase, int bodies>
struct Crowd : ingot::Scene {
    static constexpr int max_bodies = bodies, max_manifolds = bodies, max_pairs = 2 * bodies;
    static constexpr bool translates = true, filters = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box>;
    using broad_phase = BroadPhase;
};

class Numbers {
public:
    scalar between(scalar a, scalar b) {
        state_ = state_ * 1664525U + 1013904223U;
        return a + (b - a) * static_cast<scalar>(state_ >> 8U) / scalar(1U << 24U);
    }
    Vector in(const Vector& size) {
        const scalar x = between(0, size.x), y = between(0, size.y);
        return {x, y, between(0, size.z)};
    }
    Vector direction() {
        const Vector way = in({2, 2, 2}) - Vector{1, 1, 1};
        return way * (1 / ingot::sqrt(ingot::length_sq(way)));
    }

private:
    std::uint32_t state_ = 1;
};

struct Ray {
    Vector from, way;
};
constexpr const char* kinds[] = {"inside", "from outside", "from above", "three times through"};

/// Rays of a kind through a crowd of this size.
std::vector<Ray> rays_of(int kind, const Vector& size, int count) {
    Numbers numbers;
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        Ray ray{numbers.in(size), numbers.direction() * size.z};
        if (kind == 1) ray.from = ray.from - ray.way;
        if (kind == 2) ray = {{ray.from.x, ray.from.y, size.z + 5}, {0, 0, -(size.z + 10)}};
        if (kind == 3) ray.way = ray.way * 3;
        rays.push_back(ray);
    }
    return rays;
}

template <class BroadPhase, int bodies>
class Through {
public:
    Through(bool boxes, bool spread) {
        Numbers numbers;
        int side = 1;
        while (side * side * side < bodies) ++side;
        const scalar z = apart * static_cast<scalar>(side);
        size_ = spread ? Vector{2 * z, 2 * z, z} : Vector{z, z, z};
        for (int i = 0; i < bodies; ++i) {
            ingot::BodyDef def;
            def.filter = {1, 0};  // bodies meet nobody, and stay where they are
            def.mass = {1, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
            const scalar wide = numbers.between(scalar(0.15), scalar(0.45));
            if (boxes || i % 3 == 2) {
                def.shape = ingot::Box{{wide, wide * scalar(0.75), wide / 2}};
            } else if (i % 3 == 1) {
                def.shape = ingot::Capsule{wide / 2, wide / 2};
            } else {
                def.shape = ingot::Sphere{wide};
            }
            const Vector place = {static_cast<scalar>(i % side), static_cast<scalar>(i / side % side), static_cast<scalar>(i / side / side)};
            def.state.r_CM = spread ? numbers.in(size_) : place * apart + numbers.in({scalar(0.2), scalar(0.2), scalar(0.2)});
            good_ = world_->add(def).ok() && good_;
        }
        // A step makes the tree; one that outlives a step is cut anew for queries.
        if constexpr (BroadPhase::answers_queries)
            for (int step_i = 0; step_i < 2; ++step_i) good_ = ingot::step(*world_, scalar(1) / 60).status == ingot::Status::ok && good_;
    }
    bool good() const { return good_; }
    Vector size() const { return size_; }

    /// Least microseconds a ray over the rounds, each batch of rays by itself; the answers come to the sums.
    double cost(const std::vector<Ray>& rays, int rounds, long& slots, double& fractions) const {
        constexpr std::size_t batch = 64;
        std::vector<double> least(rays.size() / batch, 1e9);
        for (int round = 0; round < rounds; ++round) {
            slots = 0, fractions = 0;
            for (std::size_t k = 0; k < least.size(); ++k) {
                const auto begin = std::chrono::steady_clock::now();
                for (std::size_t i = k * batch; i < (k + 1) * batch; ++i) {
                    const auto hit = world_->cast_ray(rays[i].from, rays[i].way).value;
                    slots += hit.body.slot, fractions += static_cast<double>(hit.fraction);
                }
                least[k] = std::min(least[k], std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
            }
        }
        double sum = 0;
        for (const double us : least) sum += us;
        return sum / static_cast<double>(rays.size());
    }

private:
    std::unique_ptr<ingot::World<Crowd<BroadPhase, bodies>>> world_ = std::make_unique<ingot::World<Crowd<BroadPhase, bodies>>>();
    Vector size_{};
    bool good_ = true;
};

/// Whether both answer the same.
template <int bodies>
bool measure(const char* name, bool boxes, bool spread, int rays_to_all) {
    const Through<ingot::QueryTree, bodies> tree(boxes, spread);
    const Through<ingot::AllPairs, bodies> all(boxes, spread);
    bool same = tree.good() && all.good();
    for (int kind = 0; kind < 4; ++kind) {
        long slots[2] = {};
        double fractions[2] = {};
        const std::vector<Ray> few = rays_of(kind, tree.size(), rays_to_all);
        const double by_all = all.cost(few, 1, slots[0], fractions[0]);
        const double same_by_tree = tree.cost(few, 5, slots[1], fractions[1]);
        same = same && slots[0] == slots[1] && fractions[0] == fractions[1];
        const double by_tree = tree.cost(rays_of(kind, tree.size(), 4096), 20, slots[1], fractions[1]);
        std::printf("%-34s %-20s %8.3f us, share %.6f\n", name, kinds[kind], by_tree, same_by_tree / by_all);
    }
    return same;
}

}  // namespace

int main() {
    bool same = measure<1024>("1024 boxes", true, false, 1024);
    same = measure<1024>("1024 boxes, anywhere", true, true, 1024) && same;
    same = measure<most_bodies>(most_bodies == 100000 ? "100,000 bodies" : "30,000 bodies", false, false, 128) && same;
    same = measure<most_bodies>(most_bodies == 100000 ? "100,000 bodies, anywhere" : "30,000 bodies, anywhere", false, true, 128) && same;
    std::printf(same ? "The tree answers as looking at every body does.\n" : "THE ANSWERS DIFFER.\n");
    return same ? 0 : 1;
}
