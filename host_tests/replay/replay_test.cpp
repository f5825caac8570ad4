// SPDX-License-Identifier: MIT
// Two machines play one game; one of them errs once. The report names the step, the body and the number.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>

#include "replay/report_divergence.h"
#include "replay/snapshot_fields.h"
#include "scenes/drop.h"
#include "snapshot/life.h"

namespace {

using namespace life;
using replay::Recording;
using scenes::Drop;

/// A machine that plays Drop and records it.
struct Machine {
    World<Drop> world;
    ingot::platform::Recorder<64, 2, 16, ingot::snapshot_size<Drop>()> recorder;

    Machine() {
        clear(world);
        EXPECT_EQ(set_up(world), Status::ok);
    }

    /// One step under an input: who is kicked, and how.
    void play(uint8_t who, uint8_t how, bool keeps_states = true) {
        const uint8_t input[2] = {who, how};
        (void)world.apply_central_impulse(world.body_at(who % Drop::max_bodies), {static_cast<scalar>(how), 0, 50});
        (void)ingot::step(world, Drop::h);
        record(input, keeps_states);
    }
    void record(const uint8_t (&input)[2], bool keeps_states) {
        EXPECT_TRUE(recorder.record(world.step_count(), input, how_many(input), world.state_hash()));
        const std::vector<uint8_t> state = saved(world);
        if (keeps_states) {
            EXPECT_TRUE(recorder.keep_state(state.data(), state.size()));
        }
    }
    static size_t how_many(const uint8_t (&input)[2]) { return input[1] == 0 ? 1 : 2; }

    std::vector<uint8_t> bytes() const {
        std::vector<uint8_t> written;
        recorder.write([&written](uint8_t byte) { written.push_back(byte); });
        return written;
    }
    Recording recording() const {
        Recording read;
        EXPECT_EQ(replay::read_recording(bytes(), read), "");
        return read;
    }
};

std::string report(const Machine& a, const Machine& b, bool parts = true) {
    std::ostringstream out;
    EXPECT_EQ(replay::report_divergence(a.recording(), b.recording(), out), parts);
    return out.str();
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

uint8_t who_of(int step_i) { return static_cast<uint8_t>(step_i * 7 % 5 + 1); }
uint8_t how_of(int step_i) { return static_cast<uint8_t>(step_i % 3); }

TEST(Replay, of_machines_that_agree) {
    const auto a = std::make_unique<Machine>(), b = std::make_unique<Machine>();
    for (int step_i = 0; step_i < 100; ++step_i) {
        a->play(who_of(step_i), how_of(step_i));
        b->play(who_of(step_i), how_of(step_i));
    }
    EXPECT_EQ(report(*a, *b, false), "the same in all 64 steps that both have\n");
}

/// An error of one bit of one number of one body, in one step.
TEST(Replay, names_the_step_the_body_and_the_number) {
    struct Error {
        const char* name;
        scalar& (*of)(BodyState&);
    };
    const Error errors[] = {
        {"r_CM.x", [](BodyState& state) -> scalar& { return state.r_CM.x; }},
        {"v_CM.y", [](BodyState& state) -> scalar& { return state.v_CM.y; }},
        {"L.z", [](BodyState& state) -> scalar& { return state.L.z; }},
    };
    for (const Error& error : errors) {
        for (const int slot : {1, 3, 6}) {
            const auto a = std::make_unique<Machine>(), b = std::make_unique<Machine>();
            for (int step_i = 0; step_i < 60; ++step_i) {
                a->play(who_of(step_i), how_of(step_i));
                if (step_i != 50) {
                    b->play(who_of(step_i), how_of(step_i));
                    continue;
                }
                b->world = a->world;
                const BodyId id = b->world.body_at(slot);
                BodyState state = b->world.state(id).value;
                error.of(state) += scalar(0.125);
                ASSERT_EQ(b->world.set_state(id, state), Status::ok);
                b->record({who_of(step_i), how_of(step_i)}, true);
            }
            const std::string text = report(*a, *b);
            EXPECT_TRUE(has(text, "step 51: told the same, and the hashes are 0x")) << text;
            EXPECT_TRUE(has(text, "body in slot " + std::to_string(slot) + ": " + error.name + " is ")) << text;
            EXPECT_FALSE(has(text, "it may have begun before")) << text;
            for (int other = 0; other < Drop::max_bodies; ++other)
                EXPECT_EQ(has(text, "body in slot " + std::to_string(other) + ":"), other == slot) << text;
        }
    }
}

TEST(Replay, names_the_input_that_differs) {
    const auto a = std::make_unique<Machine>(), b = std::make_unique<Machine>();
    for (int step_i = 0; step_i < 60; ++step_i) {
        a->play(who_of(step_i), 2);
        b->play(who_of(step_i), step_i == 45 ? 3 : 2);
    }
    const std::string text = report(*a, *b);
    EXPECT_TRUE(has(text, "step 46: told different things\n  byte 1 of the input is 0x02 and 0x03\n")) << text;
    EXPECT_TRUE(has(text, "body in slot " + std::to_string(who_of(45)) + ": v_CM.x is ")) << text;

    const auto c = std::make_unique<Machine>();
    for (int step_i = 0; step_i < 60; ++step_i) c->play(who_of(step_i), step_i == 45 ? 0 : 2);
    EXPECT_TRUE(has(report(*a, *c), "step 46: told different things\n  inputs of 2 and 1 bytes\n"));
}

TEST(Replay, says_what_it_cannot_tell) {
    const auto a = std::make_unique<Machine>(), b = std::make_unique<Machine>(), without = std::make_unique<Machine>();
    for (int step_i = 0; step_i < 130; ++step_i) {
        a->play(who_of(step_i), how_of(step_i));
        b->play(step_i == 80 ? uint8_t(2) : uint8_t(who_of(step_i)), step_i == 80 ? 200 : how_of(step_i));
        without->play(who_of(step_i), step_i == 80 ? 200 : how_of(step_i), false);
    }
    EXPECT_TRUE(has(report(*a, *without), "no state of this step or a later one is in both"));
    // The states of step 81 are overwritten: 115 is the oldest kept.
    EXPECT_TRUE(has(report(*a, *b), "step 115 is the first one with states:\n  body in slot ")) << report(*a, *b);

    for (int step_i = 130; step_i < 200; ++step_i) {
        a->play(who_of(step_i), how_of(step_i));
        b->play(who_of(step_i), how_of(step_i));
    }
    EXPECT_TRUE(has(report(*a, *b), "step 137: ")) << report(*a, *b);
    EXPECT_TRUE(has(report(*a, *b), "no earlier step is in both: it may have begun before")) << report(*a, *b);
}

TEST(Replay, tells_a_body_that_lives_on_one_machine_only) {
    const auto a = std::make_unique<Machine>(), b = std::make_unique<Machine>();
    for (int step_i = 0; step_i < 20; ++step_i) {
        if (step_i == 18) {
            EXPECT_EQ(b->world.remove(b->world.body_at(4)), Status::ok);
        }
        a->play(who_of(step_i), how_of(step_i));
        b->play(who_of(step_i), how_of(step_i));
    }
    EXPECT_TRUE(has(report(*a, *b), "body in slot 4: generation is 1 and 2")) << report(*a, *b);
}

/// The names are those of the numbers: read once more, from the world.
template <class S>
void expect_the_names_to_be_right(World<S>& world) {
    replay::SnapshotFields snapshot;
    ASSERT_EQ(replay::read_fields(saved(world), snapshot), "");
    const auto value = [&](int slot, const std::string& name) {
        for (const replay::SnapshotField& field : snapshot.fields)
            if (field.slot == slot && field.name == name) return field.value(snapshot.doubles);
        ADD_FAILURE() << "no " << name << " in slot " << slot;
        return 0.0;
    };
    EXPECT_EQ(value(-1, "steps"), world.step_count());
    if constexpr (S::translates) {
        EXPECT_EQ(value(-1, "gravity.z"), static_cast<double>(world.gravity().z));
    }
    int living = 0;
    for (int slot = 0; slot < S::max_bodies; ++slot) {
        const BodyId id = world.body_at(slot);
        if (id == BodyId{}) continue;
        ++living;
        const BodyState state = world.state(id).value;
        EXPECT_EQ(value(slot, "generation"), id.generation);
        EXPECT_EQ(value(slot, "A.c0.y"), static_cast<double>(state.A.c0.y));
        EXPECT_EQ(value(slot, "A.c2.z"), static_cast<double>(state.A.c2.z));
        EXPECT_EQ(value(slot, "L.x"), static_cast<double>(state.L.x));
        EXPECT_EQ(value(slot, "L.z"), static_cast<double>(state.L.z));
        if constexpr (S::translates) {
            EXPECT_EQ(value(slot, "r_CM.y"), static_cast<double>(state.r_CM.y));
            EXPECT_EQ(value(slot, "v_CM.x"), static_cast<double>(state.v_CM.x));
            EXPECT_EQ(value(slot, "inv_M") > 0 ? static_cast<scalar>(1 / value(slot, "inv_M")) : 0, world.mass(id).value);
        }
        if constexpr (ingot::collides<S>) {
            EXPECT_LE(value(slot, "restitution"), 1);
        }
    }
    EXPECT_GT(living, 2);
}

TEST(Replay, reads_snapshots_of_any_scene) {
    static World<Yard> crates;
    static World<PrintedYard> printed;
    static World<Tops> tops;
    static World<Tide> tide;
    const auto fill = [](auto& world) {
        clear(world);
        Life life(3);
        for (int call_i = 0; call_i < 200; ++call_i) life.live(world);
        expect_the_names_to_be_right(world);
    };
    fill(crates);
    fill(printed);
    fill(tops);
    fill(tide);
    replay::SnapshotFields snapshot;
    std::vector<uint8_t> bytes = saved(crates);
    EXPECT_NE(replay::read_fields({}, snapshot), "");
    bytes.pop_back();
    EXPECT_NE(replay::read_fields(bytes, snapshot), "");
}

TEST(Replay, the_tool_ends_with_what_it_found) {
    const auto a = std::make_unique<Machine>(), b = std::make_unique<Machine>();
    for (int step_i = 0; step_i < 20; ++step_i) {
        a->play(who_of(step_i), how_of(step_i));
        b->play(who_of(step_i), step_i == 10 ? 9 : how_of(step_i));
    }
    const std::string folder = ::testing::TempDir() + "ingot_replay_";
    const auto file = [&](const char* name, const std::vector<uint8_t>& bytes) {
        const std::string path = folder + name;
        std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return path;
    };
    const std::string of_a = file("a", a->bytes()), of_b = file("b", b->bytes()), nothing = file("nothing", {1, 2, 3}), said = folder + "said";
    const auto run = [&](const std::string& arguments) {
        const int status = std::system((std::string(INGOT_REPLAY) + " " + arguments + " > " + said + " 2>&1").c_str());
        return status / 256;
    };
    EXPECT_EQ(run(of_a + " " + of_a), 0);
    EXPECT_EQ(run(of_a + " " + of_b), 1);
    std::ifstream text(said);
    std::string line;
    std::getline(text, line);
    EXPECT_EQ(line, "step 11: told different things");
    EXPECT_EQ(run(of_a + " " + nothing), 2);
    EXPECT_EQ(run(of_a + " " + folder + "that_is_not_there"), 2);
    EXPECT_EQ(run(of_a), 2);
}

}  // namespace
