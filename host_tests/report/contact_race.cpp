// SPDX-License-Identifier: MIT
#include "contact_race.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace report {

double thread_us() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

std::vector<Metric> followed(const ContactCase& scene, const BeginRun& begin, int rate, double seconds) {
    const std::unique_ptr<ContactRun> run = begin();
    std::vector<BodyPose> poses;
    run->read(poses);
    ContactTally tally(scene, poses, seconds);
    const int steps = static_cast<int>(std::lround(seconds * rate));
    for (int step_i = 1; step_i <= steps; ++step_i) {
        run->step(rate);
        run->read(poses);
        tally.see(poses, run->figures(), static_cast<double>(step_i) / rate);
        if (run->figures().frozen > 0) break;
    }
    std::vector<Metric> metrics = tally.metrics();
    if (run->bytes() > 0) metrics.push_back({"world_bytes", run->bytes(), "bytes"});
    return metrics;
}

std::vector<double> raced(const ContactCase& scene, const std::vector<BeginRun>& begins, int rate, double seconds,
                          int repetitions) {
    const int burst = scene.bodies.size() > 10 ? 1 : 10;  // steps of a body or two are shorter than a look at the clock
    const auto bursts = static_cast<std::size_t>(std::lround(seconds * rate / burst));
    const std::size_t later = bursts / 2;
    std::vector<std::vector<double>> least(begins.size(), std::vector<double>(bursts, std::numeric_limits<double>::infinity()));
    for (int repetition_i = 0; repetition_i < repetitions; ++repetition_i) {
        std::vector<std::unique_ptr<ContactRun>> runs;
        for (const BeginRun& begin : begins) runs.push_back(begin());
        for (std::size_t burst_i = 0; burst_i < bursts; ++burst_i) {
            for (std::size_t run_i = 0; run_i < runs.size(); ++run_i) {
                const double from = thread_us();
                for (int step_i = 0; step_i < burst; ++step_i) runs[run_i]->step(rate);
                double& best = least[run_i][burst_i];
                best = std::min(best, (thread_us() - from) / burst);  // a NaN stays
            }
        }
        for (std::size_t run_i = 0; run_i < runs.size(); ++run_i)
            if (runs[run_i]->figures().frozen > 0) least[run_i].assign(bursts, std::nan(""));
    }
    std::vector<double> medians;
    for (std::vector<double>& times : least) {
        if (std::isnan(times[0])) {
            medians.push_back(times[0]);
            continue;
        }
        const auto middle = times.begin() + static_cast<std::ptrdiff_t>(later + (bursts - later) / 2);
        std::nth_element(times.begin() + static_cast<std::ptrdiff_t>(later), middle, times.end());
        medians.push_back(*middle);
    }
    return medians;
}

std::vector<Approach> approach_to_rest(const ContactCase& scene, const BeginRun& begin, int rate) {
    const std::unique_ptr<ContactRun> run = begin();
    double M = 0, us = 0;
    for (const SceneBody& body : scene.bodies) M += body.immovable ? 0 : body.M;
    std::vector<Approach> points;
    std::vector<BodyPose> poses;
    for (int step_i = 1; step_i <= 256; ++step_i) {
        const double from = thread_us();
        run->step(rate);
        us += thread_us() - from;
        if ((step_i & (step_i - 1)) != 0) continue;
        run->read(poses);
        points.push_back({step_i, us, std::sqrt(2 * kinetic_energy(scene, poses) / M)});
    }
    return points;
}

bool stands_still(const std::string& scene) {
    return scene == "pyramid_210" || scene == "tower_20" || scene == "mass_ratio_1000" || scene == "mass_ratio_1e6" || scene == "incline_mu07";
}

void add_approach(const std::vector<Approach>& approach, const Row& row, Rows& rows) {
    for (const Approach& point : approach) {
        Row at = row;
        at.case_name += "_steps_" + std::to_string(point.steps);
        at.metric = "us_since_start";
        at.value = point.us;
        at.unit = "us";
        rows.add(at);
        at.metric = "distance_to_exact";
        at.value = point.distance;
        at.unit = "m/s";
        rows.add(at);
    }
}

}  // namespace report
