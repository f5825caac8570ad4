// SPDX-License-Identifier: MIT
// The demo: draws what happens in some scenes, then runs others that firmware runs too, tells how wrong they are, and writes what there is to plot.
//
//     ingot_demo OUT_DIR        writes OUT_DIR/wall.svg, stairs.svg, walker.svg, pile.svg, terrain.svg, each as soon as it is done;
//                               then <scene>_energy.csv, t_handle_flip.csv, drop_heights.csv, hashes.txt
#include <cmath>
#include <cstdio>
#include <string>

#include "../scenes/all_scenes.h"
#include "euler_equations.h"
#include "ledger.h"
#include "pictures.h"
#include "progress.h"

namespace {

template <class S>
ingot::World<S> world;

struct File {
    explicit File(const std::string& path) : stream(std::fopen(path.c_str(), "w")) {
        if (stream == nullptr) std::perror(path.c_str());
    }
    ~File() {
        if (stream != nullptr) std::fclose(stream);
    }
    std::FILE* stream;
};

/// What is kept, and to which part of itself.
void print_kept(const char* what, double error, const char* end) {
    if (error > 0) {
        std::printf("%s%.1g%s", what, error, end);
    } else {
        std::printf("%sthe last digit%s", what, end);
    }
}

/// Runs a scene, prints its row, and calls sample(step_i) now and then. Returns false if anything went wrong.
template <class S, class Sample>
bool run(const std::string& out_dir, std::FILE* hashes, Sample sample) {
    ingot::World<S>& w = world<S>;
    if (set_up(w) != ingot::Status::ok) return false;
    File energy_csv(out_dir + "/" + S::name + "_energy.csv");
    if (energy_csv.stream == nullptr) return false;
    std::fprintf(energy_csv.stream, "t,energy_change,momentum_error,orthogonality\n");

    demo::Ledger<S> ledger(w);
    int unclean = 0;
    const int every = S::demo_steps / 1200 + 1;
    {
        demo::Progress progress(S::title, S::demo_steps);
        for (int step_i = 0; step_i < S::demo_steps; ++step_i) {
            if (step_i == S::golden_steps)
                std::fprintf(hashes, "%s %d 0x%016llx\n", S::name, step_i, static_cast<unsigned long long>(w.state_hash()));
            if (step_i % every == 0) {
                std::fprintf(energy_csv.stream, "%.9g,%.9g,%.9g,%.9g\n", step_i * static_cast<double>(S::h), ledger.energy_change(),
                             ledger.momentum_error(), ledger.orthogonality());
                sample(step_i);
            }
            if (!ingot::step(w, S::h).clean()) ++unclean;
            ledger.book(w, S::h);
            progress.at(step_i);
        }
    }
    std::printf("%s, for %.0f s in steps of 1/%.0f s\n", S::title, S::demo_steps * static_cast<double>(S::h), 1 / static_cast<double>(S::h));
    std::printf("  a world of %zu bytes with %d %s\n", sizeof w, w.body_count(), w.body_count() == 1 ? "body" : "bodies");
    if (ledger.energy_change() < -0.01) {
        std::printf("  its bounces lose %.0f %% of the energy; none of the steps gained any beyond rounding, %.1g of it at most\n",
                    -100 * ledger.energy_change(), ledger.largest_gain());
    } else {
        print_kept("  its energy, which nothing may change, is what it was to ", std::fabs(ledger.energy_change()), "\n");
    }
    print_kept("  its momentum is what it should be to ", ledger.momentum_error(), "; ");
    print_kept("axes are at right angles to ", ledger.orthogonality(), "\n");
    std::printf("  all its numbers at the end, as one: 0x%016llx%s\n\n", static_cast<unsigned long long>(w.state_hash()),
                unclean == 0 ? "" : "   NOT EVERY STEP WAS CLEAN");
    return unclean == 0;
}

/// The handle's spin about its middle axis, beside Euler's equations in extended precision.
bool run_t_handle(const std::string& out_dir, std::FILE* hashes) {
    using scenes::THandle;
    File csv(out_dir + "/t_handle_flip.csv");
    if (csv.stream == nullptr) return false;
    std::fprintf(csv.stream, "t,omega,omega_reference\n");

    const ingot::Vector I = ingot::principal(scenes::t_handle_solid()).value.I_body;
    const int axis = scenes::middle_axis(I);
    const auto component = [&](const ingot::Vector& v) { return static_cast<double>(axis == 0 ? v.x : axis == 1 ? v.y : v.z); };
    const auto omega_body = [&] {
        const ingot::BodyId id = world<THandle>.body_at(0);
        return ingot::transpose_times(world<THandle>.state(id).value.A, world<THandle>.omega(id).value);
    };
    demo::EulerEquations reference;
    int reference_step = -1;
    return run<THandle>(out_dir, hashes, [&](int step_i) {
        if (reference_step < 0) reference = demo::EulerEquations(I, omega_body());
        for (reference_step = std::max(reference_step, 0); reference_step < step_i; ++reference_step) reference.advance(1.0L / 60);
        std::fprintf(csv.stream, "%.9g,%.9g,%.9g\n", step_i / 60.0, component(omega_body()), static_cast<double>(reference.omega[axis]));
    });
}

/// Height of every body over time.
bool run_drop(const std::string& out_dir, std::FILE* hashes) {
    using scenes::Drop;
    File csv(out_dir + "/drop_heights.csv");
    if (csv.stream == nullptr) return false;
    std::fprintf(csv.stream, "t,flat,edge,corner,askew,ball_e_05,ball_e_09\n");
    return run<Drop>(out_dir, hashes, [&](int step_i) {
        std::fprintf(csv.stream, "%.9g", step_i * static_cast<double>(Drop::h));
        for (int slot = 1; slot < Drop::max_bodies; ++slot)
            std::fprintf(csv.stream, ",%.9g", static_cast<double>(world<Drop>.state(world<Drop>.body_at(slot)).value.r_CM.z));
        std::fprintf(csv.stream, "\n");
    });
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: ingot_demo OUT_DIR\n");
        return 2;
    }
    const std::string out_dir = argv[1];
    std::printf("ingot %d.%d.%d: rigid bodies, %s, %d of them with each instruction\n\n", INGOT_VERSION_MAJOR, INGOT_VERSION_MINOR,
                INGOT_VERSION_PATCH, sizeof(ingot::scalar) == 4 ? "in float" : "in double", ingot::lanes);
    bool good = demo::write_pictures(out_dir);

    std::printf("\nWhat is kept to rounding, in scenes that run as firmware too:\n\n");
    File hashes(out_dir + "/hashes.txt");
    if (hashes.stream == nullptr) return 1;
    const auto nothing = [](int) {};
    good = run<scenes::Satellite>(out_dir, hashes.stream, nothing) && good;
    good = run_t_handle(out_dir, hashes.stream) && good;
    good = run<scenes::Tumblers>(out_dir, hashes.stream, nothing) && good;
    good = run_drop(out_dir, hashes.stream) && good;
    return good ? 0 : 1;
}
