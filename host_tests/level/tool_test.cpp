// SPDX-License-Identifier: MIT
// ingot_level: what it makes of files, good, bad, empty, and large ones; and level_from_bytes of what it makes.
#include <byte_hill.h>
#include <gtest/gtest.h>
#include <hill.h>
#include <ingot/level/level_walk.h>
#include <roof.h>

#include <fstream>
#include <sstream>

#include "aligned.h"
#include "fields.h"
#include "level_tool/chunks.h"
#include "level_tool/level_tool.h"
#include "small_levels.h"

namespace {

using namespace level_test;
using ingot::LevelTable;
using ingot::scalar;
using ingot::Status;
using ingot::Vector;
using level_tool::Outcome;

constexpr bool are_equal(const LevelTable& a, const LevelTable& b) {
    const auto same = [](const Vector& x, const Vector& y) { return x.x == y.x && x.y == y.y && x.z == y.z; };
    return a.checksum == b.checksum && checksum_of(a) == checksum_of(b) && same(a.low, b.low) && same(a.high, b.high) && same(a.origin, b.origin);
}
static_assert(are_equal(roof_of_tool[0], small_levels[0]) && are_equal(hill_of_tool[0], small_levels[1]) &&
              are_equal(byte_hill_of_tool[0], small_levels[2]));

std::string made(const std::string& name) { return std::string(LEVEL_SCRATCH) + "/" + name; }
/// Of this test alone: others run beside it.
std::string scratch(const std::string& name) { return made(testing::UnitTest::GetInstance()->current_test_info()->name()) + "_" + name; }

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
std::string read(const std::string& path) {
    std::stringstream all;
    all << std::ifstream(path, std::ios::binary).rdbuf();
    return all.str();
}

struct ToolRun {
    Outcome outcome;
    std::string messages;
};
ToolRun run_on(const std::string& name, const std::string& text, std::vector<std::string> words = {}) {
    write(scratch(name), text);
    words.insert(words.begin(), {scratch(name), "--out", scratch("out")});
    std::stringstream messages;
    const Outcome outcome = level_tool::run(words, messages);
    return {outcome, messages.str()};
}

void expect_refused(const std::string& name, const std::string& text, const std::string& sentence, const std::vector<std::string>& words = {}) {
    const ToolRun run = run_on(name, text, words);
    EXPECT_EQ(run.outcome, Outcome::refused) << text;
    EXPECT_NE(run.messages.find(sentence), std::string::npos) << run.messages;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(LevelTool, makes_of_files_what_the_compiler_makes_of_constants) {
    // That the headers are is asserted above.
    Aligned roof_bytes(read(made("roof.bin"))), hill_bytes(read(made("hill.bin"))), byte_hill_bytes(read(made("byte_hill.bin")));
    const auto roof_level = roof_bytes.level(), hill_level = hill_bytes.level(), byte_hill_level = byte_hill_bytes.level();
    ASSERT_TRUE(roof_level.ok());
    ASSERT_TRUE(hill_level.ok());
    EXPECT_TRUE(are_equal(roof_level.value, small_levels[0]));
    EXPECT_TRUE(are_equal(hill_level.value, small_levels[1]));
    ASSERT_TRUE(byte_hill_level.ok());
    EXPECT_TRUE(are_equal(byte_hill_level.value, small_levels[2]));
    EXPECT_NE(read(made("roof.txt")).find("line 17: a triangle that has no area"), std::string::npos);
    ingot::LevelHit hit{};
    EXPECT_TRUE(cast_ray_on_level(roof_level.value, {2, 1, 5}, {0, 0, -10}, hit));
}

TEST(LevelTool, reads_what_modelling_programs_write) {
    const std::string corners = read(std::string(LEVEL_FIXTURES) + "/roof.obj");
    std::string dos;
    for (const char c : corners) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const uint32_t checksum = small_levels[0].checksum;
    const auto checksum_of_run = [](const ToolRun& run) {
        EXPECT_EQ(run.outcome, Outcome::done) << run.messages;
        return Aligned(read(scratch("out.bin"))).level().value.checksum;
    };
    EXPECT_EQ(checksum_of_run(run_on("dos.obj", dos)), checksum);
    const std::string backwards =
        "v 0 0 0\nv 4 0 0\nv 4 6 0\nv 0 6 0\nv 0 3 2 1.0 0.5 0.5\nv +4 3e0 2\nvt 0 0\nvn 0 0 1\no x\ns off\nusemtl 0\nf -6 \\\n-2 -3\n"
        "f -5 -4 -1 # end\nusemtl 3\nf -6/1/1 -5/1 -1/1 -2\nusemtl 4\nf -2 -1 -4 -3\nl 1 2\np 1\ng\n";
    EXPECT_EQ(checksum_of_run(run_on("backwards.obj", backwards)), checksum);
    // In other units, and with y up.
    std::stringstream turned;
    for (const Vector& p : roof_corners) turned << "v " << 100 * p.x << " " << 100 * p.z << " " << -100 * p.y << "\n";
    turned << "usemtl 0\nf 1 5 4\nf 2 3 6\nusemtl 3\nf 1 2 6 5\nusemtl 4\nf 5 6 3 4";
    EXPECT_EQ(checksum_of_run(run_on("turned.obj", turned.str(), {"--y-up", "--scale", "1/100"})), checksum);
    // Names of materials are numbered by the alphabet.
    ASSERT_EQ(run_on("names.obj", square + "usemtl stone\nf 1 2 3\nusemtl grass\nf 1 3 4\n").outcome, Outcome::done);
    EXPECT_NE(read(scratch("out.h")).find("// Material 0: grass\n// Material 1: stone\n"), std::string::npos);
}

TEST(LevelTool, says_in_a_sentence_and_a_line_what_is_wrong_with_a_mesh) {
    expect_refused("empty.obj", "", "there is no corner in it");
    expect_refused("comment.obj", "# nothing\n\n", "there is no corner in it");
    expect_refused("points.obj", square, "there is no face in it");
    expect_refused("zeros.obj", std::string(5000, '\0'), "there is no corner in it");
    expect_refused("beyond.obj", square + "f 1 2 5\n", "line 5: corner '5' is not there: 4 were named before it");
    expect_refused("zero.obj", square + "f 0 1 2\n", "line 5: corner '0' is not there");
    expect_refused("before.obj", square + "f -5 1 2\n", "line 5: corner '-5' is not there");
    expect_refused("huge.obj", square + "f 1 2 99999999999999999999\n", "line 5: '99999999999999999999' is no corner");
    expect_refused("short.obj", square + "\nf 1 2\n", "line 6: a face has three corners or more, this one has 2");
    expect_refused("letters.obj", "v 0 zero 0\n", "line 1: 'zero' is no number");
    expect_refused("nan.obj", "v 0 nan 0\n", "'nan' is no number");
    expect_refused("infinite.obj", "v 0 1e999 0\n", "'1e999' is no number");
    expect_refused("two.obj", "v 0 1\n", "line 1: a corner has three numbers, this one has 2");
    expect_refused("line.obj", square + "f 1 2 2\n", "line 5: a triangle that has no area on the lattice");
    expect_refused("tiny.obj", square + "f 1 2 3\n", "no triangle has an area on a lattice", {"--scale", "1/100000"});
    expect_refused("far.obj", square + "v 1e7 0 0\nf 1 2 5\n", "line 6: a corner is further than");
    expect_refused("wide.obj", square + "v 65 0 0\nf 1 5 3\n", "line 6: a triangle is 66560 steps across");
    std::string many = square;
    for (int i = 0; i < 257; ++i) many += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
    expect_refused("many.obj", many, "it has 257 materials");
    const ToolRun doubled = run_on("doubled.obj", square + "f 1 2 3\nf 1 3 4\nf 3 1 2\n");
    EXPECT_EQ(doubled.outcome, Outcome::done);
    EXPECT_NE(doubled.messages.find("line 7: a triangle that is there already"), std::string::npos) << doubled.messages;
}

TEST(LevelTool, survives_files_that_are_noise) {
    Random random(41);
    const std::string good = read(std::string(LEVEL_FIXTURES) + "/roof.obj");
    const std::string letters = "vf0123456789.-+e/ \n#\\u";
    std::stringstream messages;
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string text = good;
        for (int k = between(random, 1, 5); k > 0; --k) text[random() % text.size()] = letters[random() % letters.size()];
        if (random() % 4 == 0) text.resize(random() % text.size());
        level_tool::ObjMesh obj;
        level_tool::LatticeMesh mesh;
        std::vector<std::vector<int>> chunks;
        level_tool::Refusal refusal = level_tool::read_obj(text, obj, messages);
        if (refusal.empty()) refusal = level_tool::place_on_lattice(obj, {1, 1.0 / 1024, false}, mesh, messages);
        if (refusal.empty()) refusal = level_tool::cut_into_chunks(mesh, chunks);
        refused += refusal.empty() ? 0 : 1;
        for (const std::vector<int>& chunk : chunks) {
            level_tool::MeshData data;
            EXPECT_EQ(level_tool::build_chunk(mesh, chunk, scalar(1) / 1024, data), "");
            EXPECT_EQ(check_level(data.view), Status::ok);
        }
        std::string image = "P" + std::string(random() % 2 == 0 ? "5" : "2") + " 4 " + std::to_string(random() % 9) + " 255\n";
        for (int k = between(random, 0, 60); k > 0; --k) image += random() % 2 == 0 ? static_cast<char>(random()) : letters[random() % 12];
        level_tool::HeightGrid grid;
        for (const level_tool::Refusal& why :
             {level_tool::read_pgm(image, grid), level_tool::read_csv(text, grid), level_tool::read_csv(image, grid)})
            if (why.empty()) {
                EXPECT_EQ(grid.heights.size(), static_cast<size_t>(grid.columns * grid.rows));
            }
    }
    EXPECT_GT(refused, 300);
    EXPECT_LT(refused, 2900);
}

TEST(LevelTool, makes_fields_of_images_and_tables) {
    const auto level_of = [](const ToolRun& run) {
        EXPECT_EQ(run.outcome, Outcome::done) << run.messages;
        return read(scratch("out.bin"));
    };
    const uint32_t checksum = small_levels[1].checksum;
    for (const char* text : {"P2 # plain\n4 2\n9\n0 4 8 9\n4 0 4 9\n", "P5 4 2 255\n\0\4\10\11\4\0\4\11"}) {
        const std::string image(text, text[1] == '2' ? std::strlen(text) : 19);
        EXPECT_EQ(Aligned(level_of(run_on("hill.pgm", image, {"--step", "1/64"}))).level().value.checksum, checksum) << text;
    }
    const std::string wide("P5\n4 2\n300\n\0\0\0\4\0\10\0\11\0\4\0\0\0\4\0\11", 27);
    EXPECT_EQ(Aligned(level_of(run_on("wide.pgm", wide, {"--step", "1/64"}))).level().value.checksum, checksum);
    EXPECT_EQ(Aligned(level_of(run_on("range.pgm", "P2 4 2 9 0 4 8 9 4 0 4 9", {"--step", "1/64", "--range", "0", "9/64"}))).level().value.checksum,
              checksum);
    // In bytes, and where those do not reach: steps of 8, so half of one.
    Aligned bytes(level_of(run_on("bytes.pgm", "P2 4 2 9 0 4 8 9 4 0 4 9", {"--step", "1/64", "--bytes"})));
    EXPECT_EQ(bytes.level().value.checksum, small_levels[2].checksum);
    const ToolRun steep = run_on("steep.csv", "0 2000\n4 1000\n", {"--step", "1", "--bytes"});
    EXPECT_TRUE(Aligned(level_of(steep)).level().ok());
    EXPECT_EQ(steep.messages, "2 by 2 heights in 12 bytes.\nHeights moved by up to 4 m, to fit into bytes.\n");
    Aligned holes(level_of(run_on("holes.csv", "0;1;;4\r\n1;1;1;nan\r\n2;2;2;2\r\n", {"--spacing", "0.3", "2", "--other-diagonal"})));
    const auto level = holes.level();
    ASSERT_TRUE(level.ok());
    EXPECT_EQ(triangles_of(level.value).size(), 2u * 3);
    EXPECT_EQ(level.value.heights.spacing_x, scalar(0.3f));
    EXPECT_EQ(level.value.heights.spacing_y, 2);

    expect_refused("none.csv", "", "has 2 to 65535 columns and rows, this one 0 by 0");
    expect_refused("ragged.csv", "1,2\n1,2,3\n", "line 2: 3 heights, where the rows before it have 2");
    expect_refused("word.csv", "1 2\n1 x\n", "line 2: 'x' is no height");
    expect_refused("high.csv", "0 1000\n0 0\n", "a field is up to 65535: choose --step 0.015625");
    expect_refused("holes.csv", ",\n,\n", "there is no height in it");
    expect_refused("none.pgm", "", "this is no image");
    expect_refused("colour.pgm", "P6 2 2 255\n", "this is no image");
    expect_refused("header.pgm", "P5 2\n", "the header of the image");
    expect_refused("early.pgm", "P5 4 2 255\n123", "the image ends early: 8 bytes of heights are due, 3 are there");
    expect_refused("plain.pgm", "P2 2 2 255\n1 2 3 x", "height 4 of 4 is no number");
    expect_refused("above.pgm", "P2 2 2 9\n1 2 3 10", "height 4 is 10, above the greatest level 9");
    expect_refused("large.pgm", "P2 70000 2 9\n", "has 2 to 65535 columns and rows");
}

TEST(LevelTool, has_exit_codes_and_help) {
    const auto run = [](const std::vector<std::string>& words) {
        std::stringstream messages;
        const Outcome outcome = level_tool::run(words, messages);
        EXPECT_FALSE(messages.str().empty());
        return outcome;
    };
    EXPECT_EQ(run({"--help"}), Outcome::done);
    EXPECT_EQ(run({}), Outcome::wrong_use);
    EXPECT_EQ(run({"a.obj", "b.obj"}), Outcome::wrong_use);
    EXPECT_EQ(run({"a.obj", "--fast"}), Outcome::wrong_use);
    EXPECT_EQ(run({"a.obj", "--step", "0.001"}), Outcome::wrong_use);
    EXPECT_EQ(run({"a.obj", "--step"}), Outcome::wrong_use);
    EXPECT_EQ(run({"a.obj", "--step", "1/0"}), Outcome::wrong_use);
    EXPECT_EQ(run({"a.obj", "--scale", "-1"}), Outcome::wrong_use);
    EXPECT_EQ(run({"a.csv", "--spacing", "0"}), Outcome::wrong_use);
    EXPECT_EQ(run({"a.png"}), Outcome::wrong_use);
    EXPECT_EQ(run({"a_file_that_is_not_there.obj"}), Outcome::no_file);
    EXPECT_EQ(run({LEVEL_FIXTURES}), Outcome::wrong_use);
    EXPECT_EQ(run({std::string(LEVEL_FIXTURES) + "/roof.obj", "--out", "no/such/folder/x"}), Outcome::no_file);
}

/// A ground larger than one level, as a file; its levels together have each triangle once, and meet.
std::string ground_of(Random& random, int n, double cell) {
    std::stringstream text;
    for (int row = 0; row <= n; ++row)
        for (int column = 0; column <= n; ++column)
            text << "v " << column * cell << " " << row * cell << " " << between(random, 0, 999) / 1000.0 << "\n";
    std::vector<std::string> faces;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const int a = row * (n + 1) + column + 1;
            faces.push_back("f " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(a + n + 2) + " " +
                            std::to_string(a + n + 1) + "\n");
        }
    for (size_t i = faces.size(); i > 1; --i) std::swap(faces[i - 1], faces[random() % i]);
    for (const std::string& face : faces) text << face;
    return text.str();
}

void expect_ground_is_whole(int n, double cell, Random& random) {
    const ToolRun run = run_on("ground.obj", ground_of(random, n, cell), {"--no-header"});
    ASSERT_EQ(run.outcome, Outcome::done);
    int levels = 0;
    EXPECT_EQ(std::sscanf(run.messages.substr(run.messages.find("triangles make")).c_str(), "triangles make %d", &levels), 1);
    EXPECT_GT(levels, 1);
    std::vector<Aligned> files;
    std::vector<LevelTable> tables;
    size_t triangles = 0;
    for (int i = 0; i < levels; ++i) files.emplace_back(read(scratch("out_" + std::to_string(i) + ".bin")));
    for (Aligned& file : files) {
        const auto level = file.level();
        ASSERT_TRUE(level.ok());
        tables.push_back(level.value);
        triangles += level.value.mesh.triangle_count;
    }
    EXPECT_EQ(triangles, static_cast<size_t>(2 * n * n));
    // Rays down meet ground, at seams between levels too.
    for (int i = 0; i < 20000; ++i) {
        const auto place = [&] { return static_cast<scalar>(static_cast<int>(cell * 1024) * between(random, 1, n - 1)) / 1024; };
        const Vector from{place(), place(), 2};
        bool is_met = false;
        ingot::LevelHit hit{};
        for (const LevelTable& level : tables) is_met = is_met || cast_ray_on_level(level, from, {0, 0, -4}, hit);
        ASSERT_TRUE(is_met) << from.x << ", " << from.y;
    }
}

TEST(LevelTool, cuts_what_is_too_wide_into_levels_that_meet) {
    Random random(42);
    expect_ground_is_whole(60, 2.5, random);
}

TEST(LevelTool, cuts_a_million_triangles_into_levels) {
    if (INGOT_TEST_BRIEF) GTEST_SKIP() << "a million triangles are for nightly";
    Random random(43);
    expect_ground_is_whole(708, 0.25, random);
}

}  // namespace
