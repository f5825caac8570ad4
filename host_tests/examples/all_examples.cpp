// SPDX-License-Identifier: MIT
// Every example of this folder is a program by itself. Here they are one, which takes a fraction of the time to build:
//
//     examples crate
#include <ingot/ingot.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace balancing_robot {
#include "balancing_robot.cpp"
}
namespace bridge {
#include "bridge.cpp"
}
namespace character {
#include "character.cpp"
}
namespace conveyor {
#include "conveyor.cpp"
}
namespace crate {
#include "crate.cpp"
}
namespace dice {
#include "dice.cpp"
}
namespace dominoes {
#include "dominoes.cpp"
}
namespace drone {
#include "drone.cpp"
}
namespace frame_buffer {
#include "frame_buffer.cpp"
}
namespace lift {
#include "lift.cpp"
}
namespace marble_run {
#include "marble_run.cpp"
}
namespace one_bit_display {
#include "one_bit_display.cpp"
}
namespace pinball {
#include "pinball.cpp"
}
namespace projectile {
#include "projectile.cpp"
}
namespace ray_picking {
#include "ray_picking.cpp"
}
namespace replay {
#include "replay.cpp"
}
namespace rollback {
#include "rollback.cpp"
}
namespace satellite {
#include "satellite.cpp"
}
namespace trigger {
#include "trigger.cpp"
}

namespace {

struct Example {
    const char* name;
    int (*run)();
};
constexpr Example examples[] = {
    {"balancing_robot", balancing_robot::main},
    {"bridge", bridge::main},
    {"character", character::main},
    {"conveyor", conveyor::main},
    {"crate", crate::main},
    {"dice", dice::main},
    {"dominoes", dominoes::main},
    {"drone", drone::main},
    {"frame_buffer", frame_buffer::main},
    {"lift", lift::main},
    {"marble_run", marble_run::main},
    {"one_bit_display", one_bit_display::main},
    {"pinball", pinball::main},
    {"projectile", projectile::main},
    {"ray_picking", ray_picking::main},
    {"replay", replay::main},
    {"rollback", rollback::main},
    {"satellite", satellite::main},
    {"trigger", trigger::main},
};

}  // namespace

int main(int argc, char** argv) {
    for (const Example& example : examples)
        if (argc == 2 && std::strcmp(argv[1], example.name) == 0) return example.run();
    for (const Example& example : examples) std::printf("%s\n", example.name);
    return 2;
}
