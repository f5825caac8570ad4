// SPDX-License-Identifier: MIT
// The demo: runs the scenes on the host, tells what each cost and how wrong it was, and writes what there is to plot.
//
//     ingot_demo OUT_DIR        writes OUT_DIR/<scene>_energy.csv, t_handle_flip.csv, drop_heights.csv, hashes.txt,
//                               tower.svg, pile.svg
#include <chrono>
#include <cstdio>
#include <string>

#include "../scenes/all_scenes.h"
#include "contact_scenes.h"
#include "euler_equations.h"
#include "ledger.h"
#include <ingot/platform/clock.h>
#include "picture.h"
#include "progress.h"

namespace {

template <class S>
ingot::World<S> world;

/// The stages that the scene's step calls, in order.
template <class S>
std::string stages() {
    std::string names;
    if (ingot::collides<S>) names += "find_contacts solve_impacts ";
    if (ingot::stacks<S>) names += "find_pairs update_manifolds solve_manifolds ";
    names += "integrate_L ";
    if (S::translates) names += "integrate_v ";
    if (ingot::collides<S>) names += "solve_contact_forces ";
    names += S::rotation::name;
    if (S::translates) names += " integrate_r";
    return names;
}

struct File {
    explicit File(const std::string& path) : stream(std::fopen(path.c_str(), "w")) {
        if (stream == nullptr) std::perror(path.c_str());
    }
    ~File() {
        if (stream != nullptr) std::fclose(stream);
    }
    std::FILE* stream;
};

/// Steps a second, measured on a run of its own, without books.
template <class S>
double steps_per_second() {
    using namespace ingot::platform;
    static ingot::World<S> timed;
    if (set_up(timed) != ingot::Status::ok) return 0;
    const uint64_t begin = clock_ticks();
    int steps = 0;
    double seconds = 0;
    for (; seconds < 0.3; ++steps) {
        (void)ingot::step(timed, S::h);
        seconds = static_cast<double>(clock_ticks() - begin) / static_cast<double>(clock_frequency_hz());
    }
    return steps / seconds;
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
    std::printf("%s: %s, %d steps of 1/%.0f s\n", S::name, S::title, S::demo_steps, 1 / static_cast<double>(S::h));
    const double rate = steps_per_second<S>();
    std::printf("  bodies %d   world %zu bytes   %.3g million steps/s   %.3g million bodies times steps/s\n", w.body_count(), sizeof w,
                rate * 1e-6, rate * w.body_count() * 1e-6);
    std::printf("  stages %s\n", stages<S>().c_str());
    std::printf("  energy change %.2g (largest gain of a step %.2g)   momentum error %.2g   |A^T A - 1| %.2g\n",
                ledger.energy_change(), ledger.largest_gain(), ledger.momentum_error(), ledger.orthogonality());
    std::printf("  state hash 0x%016llx%s\n\n", static_cast<unsigned long long>(w.state_hash()),
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

/// Body `slot` as the picture wants it.
template <class S>
void draw_body(const ingot::World<S>& w, int slot, demo::Picture& picture) {
    const ingot::BodyState state = w.state(w.body_at(slot)).value;
    const ingot::Shape shape = S::placed::body(slot).def.shape;
    const auto copy = [](const ingot::Vector& v, double (&to)[3]) {
        to[0] = static_cast<double>(v.x), to[1] = static_cast<double>(v.y), to[2] = static_cast<double>(v.z);
    };
    double A[3][3], r[3], size[3];
    copy(state.A.c0, A[0]);
    copy(state.A.c1, A[1]);
    copy(state.A.c2, A[2]);
    copy(state.r_CM, r);
    copy(shape.size, size);
    if (shape.kind == ingot::ShapeKind::sphere) picture.add_ball(r, size[0]);
    if (shape.kind == ingot::ShapeKind::box) picture.add_box(A, r, size);
}

/// Height of the highest centre of mass, m.
template <class S>
double highest(const ingot::World<S>& w) {
    double z = -1e9;
    for (int slot = 0; slot < S::max_bodies; ++slot)
        z = std::max(z, static_cast<double>(w.state(w.body_at(slot)).value.r_CM.z));
    return z;
}

/// A contact scene: prints its row and draws where its bodies lie at the end. Returns false if anything went wrong.
template <class S>
bool run_contact(const std::string& out_dir) {
    ingot::World<S>& w = world<S>;
    if (set_up(w) != ingot::Status::ok) return false;
    demo::Ledger<S> ledger(w);
    const double highest_begin = highest(w);
    int lost = 0, frozen = 0;
    double sweeps = 0, residual = 0;
    {
        demo::Progress progress(S::title, S::demo_steps);
        for (int step_i = 0; step_i < S::demo_steps; ++step_i) {
            const ingot::StepReport report = ingot::step(w, S::h);
            lost += report.contacts_lost + report.pairs_untested;
            frozen += report.bodies_frozen;
            sweeps = report.sweeps;
            residual = static_cast<double>(report.residual);
            ledger.book(w, S::h);
            progress.at(step_i);
        }
    }
    demo::Picture picture(S::camera_width, S::camera_height);
    for (int slot = 0; slot < S::max_bodies; ++slot) draw_body(w, slot, picture);
    const double seconds = S::demo_steps * static_cast<double>(S::h);
    char caption[100];
    std::snprintf(caption, sizeof caption, "%s: after %.0f s", S::title, seconds);
    const bool drawn = picture.write((out_dir + "/" + S::name + ".svg").c_str(), caption);

    std::printf("%s: %s, %d steps of 1/%.0f s\n", S::name, S::title, S::demo_steps, 1 / static_cast<double>(S::h));
    const double rate = steps_per_second<S>();
    std::printf("  bodies %d   world %zu bytes   %.3g thousand steps/s   %.3g million bodies times steps/s\n", w.body_count(),
                sizeof w, rate * 1e-3, rate * w.body_count() * 1e-6);
    std::printf("  stages %s\n", stages<S>().c_str());
    std::printf("  highest body sank by %.3g mm   kinetic energy at the end %.2g J   largest energy gain of a step %.2g   |A^T A - 1| %.2g\n",
                1e3 * (highest_begin - highest(w)), static_cast<double>(w.kinetic_energy()), ledger.largest_gain(), ledger.orthogonality());
    std::printf("  last step: %.3g sweeps, residual %.2g m/s\n", sweeps, residual);
    std::printf("  state hash 0x%016llx%s\n\n", static_cast<unsigned long long>(w.state_hash()),
                lost + frozen == 0 ? "" : "   CONTACTS WERE LOST, OR BODIES FROZEN");
    return drawn && lost + frozen == 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: ingot_demo OUT_DIR\n");
        return 2;
    }
    const std::string out_dir = argv[1];
    File hashes(out_dir + "/hashes.txt");
    if (hashes.stream == nullptr) return 1;
    ingot::platform::clock_start();

    std::printf("ingot %d.%d.%d, %s, %d lanes\n\n", INGOT_VERSION_MAJOR, INGOT_VERSION_MINOR, INGOT_VERSION_PATCH,
                sizeof(ingot::scalar) == 4 ? "float" : "double", ingot::lanes);
    const auto nothing = [](int) {};
    bool good = run<scenes::Satellite>(out_dir, hashes.stream, nothing);
    good = run_t_handle(out_dir, hashes.stream) && good;
    good = run<scenes::Tumblers>(out_dir, hashes.stream, nothing) && good;
    good = run_drop(out_dir, hashes.stream) && good;
    good = run_contact<demo::TowerOfCubes>(out_dir) && good;
    good = run_contact<demo::PileOfBalls>(out_dir) && good;
    return good ? 0 : 1;
}
