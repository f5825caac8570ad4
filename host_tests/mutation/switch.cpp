// SPDX-License-Identifier: MIT
// The mutant named in INGOT_MUTANT is on; the numbers of all that were asked for go to the file named in INGOT_REACHED.
#include <cstdio>
#include <cstdlib>

namespace {

constexpr int room = 100000;
bool reached[room];

struct Switch {
    int on = 0;  // none: numbers begin with 1
    Switch() {
        if (const char* number = std::getenv("INGOT_MUTANT")) on = std::atoi(number);
    }
    ~Switch() {
        const char* path = std::getenv("INGOT_REACHED");
        std::FILE* file = path ? std::fopen(path, "w") : nullptr;
        if (file == nullptr) return;
        for (int number = 0; number < room; ++number)
            if (reached[number]) std::fprintf(file, "%d\n", number);
        std::fclose(file);
    }
};
Switch the_switch;

}  // namespace

extern "C" bool ingot_mutant_is_on(int number) {
    reached[number] = true;
    return number == the_switch.on;
}
