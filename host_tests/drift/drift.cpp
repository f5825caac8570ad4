// SPDX-License-Identifier: MIT
// ingot_drift STEPS: free bodies of every kind for STEPS steps at 60 Hz. Tells what they have lost, and ends with success if that is nothing.
//
// Criteria: |A^T A - 1| at most 1e-14 (double), 3e-7 (float), and what 16 turns from one polar step to the next leave of roundings,
// five sigma of a walk of 16 roundings of 0.6 epsilon |omega| h; energy within 1e-11, 1e-5; L bitwise; and neither grows with time: the worst of
// the last half at most 1.5 times the worst of the first tenth, which has a fifth of its samples.
#include <ingot/ingot.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

using ingot::scalar;

struct Body {
    const char* name;
    ingot::Vector I, omega;
};
constexpr Body kinds[] = {
    {"book", {1, 2, 3}, {scalar(0.5), 1, scalar(0.75)}},      {"flipping", {1, 2, 3}, {scalar(0.001), 2, scalar(0.0005)}},
    {"brick", {scalar(0.8125), scalar(1.25), scalar(1.9375)}, {scalar(2.5), scalar(-0.5), scalar(1.25)}},
    {"disc", {1, 1, scalar(1.96875)}, {3, 0, 20}},            {"rod", {scalar(0.125), 1, 1}, {8, 1, scalar(0.5)}},
    {"sphere", {1, 1, 1}, {1, 2, 3}},                         {"fast", {1, 2, 3}, {36, 48, -24}},
    {"slow", {1, 2, 3}, {scalar(0.004), scalar(0.008), scalar(0.006)}}};
constexpr int count = sizeof kinds / sizeof kinds[0];

struct Scene : ingot::Scene {
    static constexpr int max_bodies = count;
};

struct Kept {
    double early = 0, late = 0, worst = 0;
    void add(double value, double share) {
        worst = std::max(worst, std::isnan(value) ? HUGE_VAL : value);
        if (share <= 0.1) early = std::max(early, value);
        if (share >= 0.5) late = std::max(late, value);
    }
    /// Below `floor`, a rounding of what is measured, growth means nothing.
    bool grows(double floor) const { return late > 1.5 * std::max(early, floor); }
};

double energy_of(const ingot::BodyState& s, const ingot::Vector& I) {
    const auto product = [&](const ingot::Vector& column) {
        return double(column.x) * double(s.L.x) + double(column.y) * double(s.L.y) + double(column.z) * double(s.L.z);
    };
    const double x = product(s.A.c0), y = product(s.A.c1), z = product(s.A.c2);
    return (x * x / double(I.x) + y * y / double(I.y) + z * z / double(I.z)) / 2;
}

}  // namespace

int main(int argc, char** argv) {
    const long steps = argc == 2 ? std::atol(argv[1]) : 0;
    if (steps < 1000) {
        std::fprintf(stderr, "usage: ingot_drift STEPS, at least 1000\n");
        return 2;
    }
    const bool is_double = sizeof(scalar) == 8;
    const double orthogonality_max = is_double ? 1e-14 : 3e-7, energy_max = is_double ? 1e-11 : 1e-5;
    const double epsilon = double(ingot::epsilon);

    static ingot::World<Scene> world;
    ingot::BodyId ids[count];
    ingot::BodyState begin[count];
    for (int body_i = 0; body_i < count; ++body_i) {
        ingot::BodyDef def;
        def.mass = {1, kinds[body_i].I, {}, ingot::identity_matrix<scalar>()};
        def.state.L = ingot::angular_momentum_of_spin(def.state.A, kinds[body_i].I, kinds[body_i].omega);
        ids[body_i] = world.add(def).value;
        begin[body_i] = world.state(ids[body_i]).value;
    }

    Kept orthogonality[count], energy[count];
    bool clean = true;
    const long every = std::max(7L, steps / 1000003);  // no multiple of the polar interval
    const bool live = isatty(STDERR_FILENO) != 0;
    for (long step_i = 1; step_i <= steps; ++step_i) {
        clean = ingot::step(world, scalar(1) / 60).clean() && clean;
        if (live && step_i % (steps / 1000) == 0) std::fprintf(stderr, "\r%5.1f %% of %ld steps", 100.0 * double(step_i) / double(steps), steps);
        if (step_i % every != 0) continue;
        const double share = double(step_i) / double(steps);
        for (int body_i = 0; body_i < count; ++body_i) {
            const ingot::BodyState s = world.state(ids[body_i]).value;
            double defect = 0;
            const double columns[3][3] = {{double(s.A.c0.x), double(s.A.c0.y), double(s.A.c0.z)},
                                          {double(s.A.c1.x), double(s.A.c1.y), double(s.A.c1.z)},
                                          {double(s.A.c2.x), double(s.A.c2.y), double(s.A.c2.z)}};
            for (int i = 0; i < 3; ++i)
                for (int j = i; j < 3; ++j) {
                    const double dot = columns[i][0] * columns[j][0] + columns[i][1] * columns[j][1] + columns[i][2] * columns[j][2];
                    defect = std::max(defect, std::fabs(dot - (i == j ? 1 : 0)));
                }
            orthogonality[body_i].add(defect, share);
            energy[body_i].add(std::fabs(energy_of(s, kinds[body_i].I) / energy_of(begin[body_i], kinds[body_i].I) - 1), share);
        }
    }
    if (live) std::fprintf(stderr, "\r%40s\r", "");

    std::printf("%ld steps, %s, %d lanes\n%-10s %14s %10s %10s %12s %10s %10s  %s\n", steps, is_double ? "double" : "float", ingot::lanes, "body",
                "|A^T A - 1|", "first 10%", "last 50%", "energy", "first 10%", "last 50%", "L");
    int failed = 0;
    for (int body_i = 0; body_i < count; ++body_i) {
        const ingot::BodyState s = world.state(ids[body_i]).value;
        const bool same_L = std::memcmp(&s.L, &begin[body_i].L, sizeof s.L) == 0;
        const Kept &o = orthogonality[body_i], &e = energy[body_i];
        const ingot::Vector& w = kinds[body_i].omega;
        const double angle = std::min(0.5, std::sqrt(double(ingot::length_sq(w))) / 60);
        const bool good =
            same_L && o.worst <= orthogonality_max + 12 * epsilon * angle && e.worst <= energy_max && !o.grows(4 * epsilon) && !e.grows(4 * epsilon);
        failed += good ? 0 : 1;
        std::printf("%-10s %14.1e %10.1e %10.1e %12.1e %10.1e %10.1e  %s%s\n", kinds[body_i].name, o.worst, o.early, o.late, e.worst, e.early, e.late,
                    same_L ? "kept" : "lost", good ? "" : "   FAILED");
    }
    if (!clean) std::printf("a step was not clean\n");
    return failed == 0 && clean ? 0 : 1;
}
