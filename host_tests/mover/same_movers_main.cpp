// SPDX-License-Identifier: MIT
// Movers among boxes, and on a mesh, and where they get to: the same on every kernel.
#include <cstdio>
#include <gtest/gtest.h>

#include "course.h"

using namespace mover_test;

int main() {
    for (const bool as_mesh : {false, true}) {
        level_test::Random random(5);
        std::vector<Block> blocks = {{{-12, -12, -1}, {12, 12, 0}}};
        for (int i = 0; i < 30; ++i) {
            const V low{on_lattice(within(random, -10, 8)), on_lattice(within(random, -10, 8)), 0};
            const V size{on_lattice(within(random, 0.2, 2)), on_lattice(within(random, 0.2, 2)), on_lattice(about(random, 0.1, 2))};
            if (low.norm() > 3) blocks.push_back({low, low + size});
        }
        auto& world = empty_world<Street>();
        level_tool::MeshData mesh;
        if (as_mesh)
            add_as_mesh(world, blocks, mesh);
        else
            add_as_boxes(world, blocks);
        Mover mover = standing_at(world, 0, 0, 0);
        Vector v{};
        for (int i = 0; i < 2000; ++i) {
            if (random() % 30 == 0) v = {static_cast<scalar>(within(random, -4, 4)), static_cast<scalar>(within(random, -4, 4)), 0};
            const scalar jump = random() % 50 == 0 && stands(mover) ? scalar(4) : scalar(0);
            if (world.move(mover, {v, jump}, scalar(1) / 64) != Status::ok) return 1;
            if (i % 100 == 99)
                std::printf("%a %a %a %d\n", static_cast<double>(mover.r.x), static_cast<double>(mover.r.y), static_cast<double>(mover.r.z),
                            static_cast<int>(mover.ground.footing));
        }
    }
    return 0;
}
