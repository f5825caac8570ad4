// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include <vector>

// One life of a world, followed by a kernel of another lane count. Each function exists once for each lane count (lanes_part.cpp).
namespace lanes_test {

/// The hash and the bytes after so many calls.
struct Trace {
    bool loaded;
    std::vector<uint64_t> hashes;
    std::vector<uint8_t> bytes;
};

/// A life of `before` calls from an empty world; its snapshot.
using Begin = std::vector<uint8_t> (*)(uint64_t seed, int before);
/// Loads, and goes on with that life for `after` calls.
using GoOn = Trace (*)(const std::vector<uint8_t>& from, uint64_t seed, int before, int after);

/// Balls that bounce beside boxes that land: a hash after each step.
using Land = std::vector<uint64_t> (*)();

struct Kernel {
    int lanes;
    Begin begin;
    GoOn go_on;
    Land land;
};

Kernel kernel_of_1();
Kernel kernel_of_4();
Kernel kernel_of_8();

}  // namespace lanes_test
