// SPDX-License-Identifier: MIT
// The tests of SimBenchmark: their errors by their definitions (scenes/contact/simbenchmark.h), and the CPU time that a run takes beside them.
#include <cmath>
#include <stdexcept>

#include "contact_metrics.h"
#include "simbenchmark.h"
#include "suites.h"

namespace report {

namespace {

constexpr double g = 9.81;

double energy_of(const ContactCase& scene, const std::vector<BodyPose>& poses) {
    double sum = kinetic_energy(scene, poses);
    for (std::size_t i = 0; i < poses.size(); ++i)
        if (!scene.bodies[i].immovable) sum += scene.bodies[i].M * g * poses[i].r[2];
    return sum;
}

/// |v_box - a_box t|^2 + |v_ball - a_ball t|^2 of the first ball, m^2 s^-2.
double rolling_error(const ContactCase& scene, const std::vector<BodyPose>& poses, double t) {
    constexpr double M = 10, m = 25, F = 150, mu = 0.4, a_box = (F - mu * (M + m) * g) / (M + m * 2 / 7);
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = scene.push[axis] / F * a_box * t, box = poses[1].v[axis] - way, ball = poses[2].v[axis] - way * 2 / 7;
        sum += box * box + ball * ball;
    }
    return sum;
}

/// m^2, over all pairs that overlap.
double squared_overlaps(const ContactCase& scene, const std::vector<BodyPose>& poses) {
    double sum = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        for (std::size_t k = i + 1; k < poses.size(); ++k) {
            const double deep = overlap_of(scene.bodies[i], poses[i], scene.bodies[k], poses[k]);
            if (deep > 0) sum += deep * deep;
        }
    }
    return sum;
}

/// What a run shows: the mean of the errors before each step (of overlaps: of every tenth), and the CPU time of the steps alone.
struct Outcome {
    double error, us;
    int steps;
};
Outcome outcome_of(const ContactCase& scene, int rate) {
    const std::unique_ptr<ContactRun> run = scene.begin();
    std::vector<BodyPose> poses;
    run->read(poses);
    const bool rolls = scene.name.find("rolling") != std::string::npos, overlaps = scene.name == "simbenchmark_666";
    const double E_0 = energy_of(scene, poses);
    Outcome outcome{0, 0, static_cast<int>(std::lround(scene.seconds * rate))};
    int samples = 0;
    for (int step_i = 0; step_i < outcome.steps; ++step_i) {
        if (!overlaps || step_i % 10 == 0) {
            run->read(poses);
            const double E = energy_of(scene, poses) - E_0;
            outcome.error += rolls      ? rolling_error(scene, poses, static_cast<double>(step_i) / rate)
                             : overlaps ? squared_overlaps(scene, poses)
                                        : E * E;
            ++samples;
        }
        const double from = thread_us();
        run->step(rate);
        outcome.us += thread_us() - from;
    }
    outcome.error /= samples;
    return outcome;
}

}  // namespace

void run_simbenchmark(const Settings& settings, const std::vector<Variant>& variants, Rows& rows) {
    Progress progress(static_cast<int>(simbenchmark_tests().size()) * 2);
    for (const SimBenchmarkTest& test : simbenchmark_tests()) {
        for (const char* scalar : {"float", "double"}) {
            progress.begin(test.name + std::string(", ") + scalar);
            std::vector<const Variant*> builds;
            for (const Variant& variant : variants)
                if (variant.scalar == scalar) builds.push_back(&variant);
            const Variant& build = *builds[builds.size() / 2];
            const ContactCase* scene = nullptr;
            for (const ContactCase& one : build.simbenchmark)
                if (one.name == test.name) scene = &one;
            if (scene == nullptr) throw std::runtime_error("no scene is called " + std::string(test.name));
            for (const int rate : simbenchmark_rates()) {
                if (settings.quick && rate != 1000 && rate != 100) continue;
                const Outcome outcome = outcome_of(*scene, rate);
                const auto add = [&](const char* metric, double value, const char* unit) {
                    rows.add({"simbenchmark", test.name, "default", scalar, build.lanes, "host", 1.0 / rate, metric, value, unit});
                };
                add("error", outcome.error, "1");
                add("us_per_step", outcome.us / outcome.steps, "us");
                add("cpu_seconds", outcome.us * 1e-6, "s");
            }
        }
    }
}

}  // namespace report
