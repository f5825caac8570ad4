// SPDX-License-Identifier: MIT
// Figures of control.md: how well the car and the tank of ../scenes drive. Its bits, and so its figures, are those of every target. See guide.py.
#include <cmath>
#include <cstdio>

#include "../scenes/tank.h"
#include "../scenes/vehicle.h"

namespace {

using ingot::scalar;

constexpr int rates[] = {30, 60, 120, 240};  // steps a second
constexpr double g = 9.81;

double real(scalar x) { return static_cast<double>(x); }
scalar step_of(int rate) { return 1 / static_cast<scalar>(rate); }
void row(const char* name) { std::printf("\\n| %s |", name); }
void cell(double value) { std::printf(" %.2g |", value); }

template <class S>
void add_road(ingot::World<S>& world) {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ground.friction = scalar(0.8);
    (void)world.set_gravity({0, 0, scalar(-g)});
    (void)world.add(ground);
}

struct Ride {
    ingot::World<scenes::OnRoad>& world;
    scenes::Car car{};
    scenes::Driving driving{};
    int rate;

    Ride(bool slips, int steps_a_second, double speed) : world(world_of()), rate(steps_a_second) {
        world = {};
        add_road(world);
        car.design.slips = slips;
        (void)scenes::add_car(world, {0, 0, 0}, static_cast<scalar>(speed), car);
    }
    static ingot::World<scenes::OnRoad>& world_of() {
        static ingot::World<scenes::OnRoad> only;
        return only;
    }
    void step() {
        (void)scenes::drive_car(world, car, driving, step_of(rate));
        (void)ingot::step(world, step_of(rate));
    }
    void go(int seconds) {
        for (int step_i = 0; step_i < seconds * rate; ++step_i) step();
    }
    ingot::BodyState state() const { return world.state(car.chassis).value; }
};

// mm, in ten seconds at 50 m/s; at 30 steps a second, in which wheels would turn too far, at 25.
double aside(bool slips, int rate) {
    Ride ride(slips, rate, rate > 30 ? 50 : 25);
    ride.go(10);
    return 1000 * std::fabs(real(ride.state().r_CM.y));
}
// %, of a circle of 15 m, at 1 m/s.
double off_circle(bool slips, int rate) {
    Ride ride(slips, rate, 1);
    for (int step_i = 1; step_i <= rate; ++step_i) {
        ride.driving.curvature = static_cast<scalar>(step_i) / static_cast<scalar>(15 * rate);
        ride.step();
    }
    ride.go(1);
    double way = 0, turn = 0;
    for (int step_i = 0; step_i < 3 * rate; ++step_i) {
        const ingot::BodyState a = ride.state();
        ride.step();
        const ingot::BodyState b = ride.state();
        const ingot::Vector r = (b.r_CM - b.A.c0 * (ride.car.design.base / 2)) - (a.r_CM - a.A.c0 * (ride.car.design.base / 2));
        way += std::hypot(real(r.x), real(r.y));
        turn += std::atan2(real(a.A.c0.x * b.A.c0.y - a.A.c0.y * b.A.c0.x), real(a.A.c0.x * b.A.c0.x + a.A.c0.y * b.A.c0.y));
    }
    return 100 * std::fabs(way / turn / 15 - 1);
}
// %, of v^2 / (2 mu g), from 20 m/s.
double off_braking_way(bool slips, int rate) {
    Ride ride(slips, rate, 20);
    ride.go(1);
    const double x = real(ride.state().r_CM.x), way = 20 * 20 / (2 * 0.8 * g);
    ride.driving.locked = true;
    ride.go(4);
    return 100 * std::fabs((real(ride.state().r_CM.x) - x) / way - 1);
}
// %, of the rate at which belts turn a tank about itself, at 0.1 m/s.
double off_turn_rate(int rate) {
    static ingot::World<scenes::OnTracks> world;
    world = {};
    add_road(world);
    scenes::Tank tank;
    (void)scenes::add_tank(world, {0, 0, 0}, tank);
    double turn = 0;
    for (int step_i = 0; step_i < 3 * rate; ++step_i) {
        const ingot::Vector a = world.state(tank.hull).value.A.c0;
        (void)scenes::drive_tank(world, tank, scalar(-0.1), scalar(0.1));
        (void)ingot::step(world, step_of(rate));
        const ingot::Vector b = world.state(tank.hull).value.A.c0;
        if (step_i >= 2 * rate) turn += real(a.x * b.y - a.y * b.x);
    }
    return 100 * std::fabs(turn / real(scenes::turn_rate(tank, scalar(-0.1), scalar(0.1))) - 1);
}

template <class Of>
void add_rows(const char* by_friction, const char* by_slip, const Of& of) {
    row(by_friction);
    for (const int rate : rates) cell(of(false, rate));
    row(by_slip);
    for (const int rate : rates) cell(of(true, rate));
}

}  // namespace

int main() {
    std::printf("control.vehicles\t| off by, at so many steps a second |");
    for (const int rate : rates) std::printf(" %d |", rate);
    std::printf("\\n| --- | ---: | ---: | ---: | ---: |");
    add_rows("straight on at 50 m/s for 10 s, mm, friction", "the same, slip law", aside);
    add_rows("a circle of 15 m, %, friction", "the same, slip law", off_circle);
    add_rows("braking from 20 m/s, %, friction", "the same, slip law", off_braking_way);
    row("a tank about itself, %");
    for (const int rate : rates) cell(off_turn_rate(rate));
    std::printf("\n");
}
