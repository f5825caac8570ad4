// SPDX-License-Identifier: MIT
// Compiled with contraction on, for a processor that has it: check_floating_point() must say so. 77: this processor has not.
#include <ingot/ingot.h>

int main() {
#ifdef __x86_64__
    if (!__builtin_cpu_supports("fma")) return 77;
#endif
    return ingot::check_floating_point() == ingot::Status::wrong_rounding ? 0 : 1;
}
