// SPDX-License-Identifier: MIT
#include "variant.h"

namespace report {

#define INGOT_VARIANT(abi, lane_count) Variant variant_##abi();
#include "variant_list.inc"
#undef INGOT_VARIANT

namespace {

/// Kernels of vectors wider than 16 bytes are built for AVX2.
bool can_run([[maybe_unused]] int vector_bytes) {
#if defined(__x86_64__) || defined(__i386__)
    return vector_bytes <= 16 || __builtin_cpu_supports("avx2") != 0;
#else
    return true;
#endif
}

}  // namespace

std::vector<Variant> variants() {
    std::vector<Variant> all;
    const auto add = [&](Variant (*make)(), int bytes) {
        if (can_run(bytes)) all.push_back(make());
    };
#define INGOT_VARIANT(abi, lane_count) add(variant_##abi, lane_count*(#abi[1] == '3' ? 4 : 8));
#include "variant_list.inc"
#undef INGOT_VARIANT
    return all;
}

}  // namespace report
