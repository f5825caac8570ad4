// SPDX-License-Identifier: MIT
// Prints a hash of what queries answer: one line, the same for every lane count.
#include <cinttypes>
#include <cstdio>

#include "query/field.h"

int main() {
    using namespace query_field;
    std::uint64_t hash = ingot::state_hash_seed;
    int found = 0;
    const auto add = [&](BodyId id, scalar number, const Vector& P, const Vector& n) {
        const scalar numbers[7] = {number, P.x, P.y, P.z, n.x, n.y, n.z};
        const std::uint32_t names[2] = {id.slot, id.generation};
        const auto add_bytes = [&](const void* bytes, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) hash = (hash ^ static_cast<const unsigned char*>(bytes)[i]) * 0x100000001b3u;
        };
        add_bytes(names, sizeof names);
        add_bytes(numbers, sizeof numbers);
        found += id.generation != 0 ? 1 : 0;
    };
    RandomInput random(41);
    for (int world_i = 0; world_i < 20; ++world_i) {
        Bodies bodies;
        const auto world = field_of<Field>(random, 60, bodies);
        for (int query_i = 0; query_i < 100; ++query_i) {
            const Vector from = to_vector(random.vector(place)), way = to_vector(random.vector(place));
            PlacedShape shape = any_placed(random, 1);
            shape.r = from;
            const QueryHit ray = world->cast_ray(from, way).value, cast = world->cast_shape(shape, way).value;
            add(ray.body, ray.fraction, ray.P, ray.n);
            add(cast.body, cast.fraction, cast.P, cast.n);
            const QueryNearest nearest = world->find_nearest(from, 5).value;
            add(nearest.body, nearest.distance, nearest.P, nearest.n);
            BodyId ids[60];
            const int count = world->find_overlaps(shape, ids, 60).value;
            for (int i = 0; i < count; ++i) add(ids[i], 0, {}, {});
        }
    }
    std::printf("%d found, %016" PRIx64 "\n", found, hash);
    return found > 1000 ? 0 : 1;
}
