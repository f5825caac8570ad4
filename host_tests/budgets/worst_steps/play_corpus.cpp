// SPDX-License-Identifier: MIT
// Plays the corpus of a machine of fuzz/ on the board, and prints the instructions of every step that was taken:
//
//     input 01ab...                       name of the file
//     scene ... [with S = Yard; ...]      once an input: its first byte chose it
//     648 0                               a step: instructions, contacts
//
// Ends with status 1 at a broken promise, as the fuzzer does.
#include <ingot/platform/console.h>

#include "../../../fuzz/fuzz_world.h"
#include "counted_step.h"

namespace {

using namespace ingot::platform;

struct Input {
    const char* name;
    const char* bytes;
    size_t size;
};
const Input inputs[] = {
#include INGOT_INPUTS  // written by CMake: {"name", bytes, size},
};

const char* scene_before = nullptr;  // of this input
uint64_t ticks_of_nothing = 0;       // between two readings

}  // namespace

int fuzz_fault = 0;

void broken_promise(const char* text) {
    console_write("broken promise: ");
    console_write(text);
    console_write("\n");
    console_exit(1);
}

void print_step(const char* scene, uint64_t ticks, int contacts) {
    if (scene != scene_before) {
        console_write("scene ");
        console_write(scene);
        console_write("\n");
        scene_before = scene;
    }
    console_write_u64(clock_ticks_to_instructions(ticks - ticks_of_nothing));
    console_write(" ");
    console_write_i64(contacts);
    console_write("\n");
}

int main() {
    clock_start();
    const uint64_t begin = clock_ticks();
    ticks_of_nothing = clock_ticks() - begin;
    for (const Input& input : inputs) {
        console_write("input ");
        console_write(input.name);
        console_write("\n");
        scene_before = nullptr;
        (void)run_with_1_lane(reinterpret_cast<const uint8_t*>(input.bytes), input.size);
    }
    return 0;
}
